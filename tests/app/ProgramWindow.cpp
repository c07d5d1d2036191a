// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/ProgramWindow.h"
#include "core/servo/ServoState.h"

#include <algorithm>
#include <utility>

#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QFileInfo>
#include <QLabel>
#include <QRadioButton>
#include <QSlider>

#include "core/servo/StrokeDetector.h"
#include "lessons/LessonCatalog.h"
#include "lessons/LessonReader.h"
#include "tests/support/Files.h"
#include "ui/scoring/ScorePage.h"
#include "ui/scoring/ScorePredictionPage.h"
#include "ui/tooth/ToothView.h"

namespace support {

void ProgramWindow::begin(app::WindowOptions options)
{
    if (options.database.isEmpty())
        options.database = m_folder->filePath("school.sqlite");
    m_application = app::Application::make(options).value();
    m_servo = {};
    connect(&window().view(), &ui::tooth::ToothView::frameAdvanced, this, [this](const core::servo::ServoState& state) {
        if (state.removedMm3 != m_removed || state.toothGeneration != m_servo.toothGeneration) {
            m_removed = state.removedMm3;
            m_cutAtTick = state.tick;
        }
        m_servo = state;
    });
    m_application->show();
    // A small picture: without a graphics card it is drawn by the processor.
    window().resize(window().minimumSizeHint().expandedTo({1100, 760}));
}

void ProgramWindow::click(const char* button) const
{
    auto* const found = child<QPushButton>(button);
    QVERIFY2(found != nullptr, button);
    QTRY_VERIFY2_WITH_TIMEOUT(found->isEnabled(), button, kPatienceMs);
    QTest::mouseClick(found, Qt::LeftButton);
}

const QLabel* ProgramWindow::labelWith(const QString& words) const
{
    const auto labels = window().findChildren<QLabel*>();
    const auto found = std::find_if(labels.begin(), labels.end(), [&](const QLabel* label) {
        return label->isVisible() && label->text().contains(words);
    });
    return found == labels.end() ? nullptr : *found;
}

QPoint ProgramWindow::press(glm::dvec3 pointMm) const
{
    ui::tooth::ToothView& view = window().view();
    const glm::dvec2 pixel = view.camera().pixelOf(pointMm);
    const QPoint at(qRound(pixel.x), qRound(pixel.y));
    QTest::mouseMove(&view, at);
    QTest::mousePress(&view, Qt::LeftButton, {}, at);
    return at;
}

void ProgramWindow::release() const
{
    QTest::mouseRelease(&window().view(), Qt::LeftButton);
}

void ProgramWindow::drill(glm::dvec3 pointMm) const
{
    const QString before = removed();
    const QPoint at = press(pointMm);
    WAIT_FOR(removed() != before);
    QTest::mouseRelease(&window().view(), Qt::LeftButton, {}, at);
    waitForStrokeEnd();
}

void ProgramWindow::waitForStrokeEnd() const
{
    constexpr std::uint64_t kEndedTicks = 2 * core::servo::StrokeDetector::kPauseTicks;
    WAIT_FOR(m_servo.tick > m_cutAtTick + kEndedTicks);
}

void ProgramWindow::waitForTicks(std::uint64_t ticks) const
{
    const std::uint64_t before = m_servo.tick;
    WAIT_FOR(m_servo.tick > before + ticks);
}

void ProgramWindow::waitForNewTooth(const std::function<void()>& change) const
{
    const std::uint64_t before = m_servo.toothGeneration;
    change();
    WAIT_FOR(m_servo.toothGeneration > before);
    waitForTooth();
}

void ProgramWindow::openLesson(const lessons::Lesson& lesson) const
{
    waitForNewTooth([&] { emit window().lessonChosen(lesson); });
}

void ProgramWindow::openMadeLesson(std::string_view json) const
{
    const QString path = m_folder->filePath("made.lesson.json");
    write(path, json);
    openLesson(lessons::readLesson(path).lesson.value());
}

lessons::Lesson ProgramWindow::openLesson(const std::string& id) const
{
    for (const lessons::CatalogEntry& entry : lessons::readCatalog(lessons::teachersFolder()))
        if (entry.read.lesson && entry.read.lesson->id == id) {
            openLesson(*entry.read.lesson);
            return *entry.read.lesson;
        }
    qFatal("no such lesson");
}

void ProgramWindow::expectScore() const
{
    waitForPage<ui::scoring::ScorePredictionPage>();
    QVERIFY(!child<QPushButton>("showScore")->isEnabled());
    QTest::keyClick(child<QSlider>("expected"), Qt::Key_Right);
    QTest::keyClick(child<ui::scoring::ScorePredictionPage>()->findChild<QRadioButton*>(), Qt::Key_Space);
    click("showScore");
    waitForPage<ui::scoring::ScorePage>();
}

QStringList ProgramWindow::journals(const QString& below) const
{
    return QDir(m_folder->filePath("unfinished/" + below)).entryList({"*.cuspjournal"}, QDir::Files);
}

QString ProgramWindow::killWithJournal(const QString& below)
{
    const QDir folder(m_folder->filePath("unfinished/" + below));
    if (journals(below).size() != 1)
        qFatal("there is one unfinished attempt");
    const QString journal = folder.filePath(journals(below).front());
    // The file is written 25 times a second, not together with the window: what was done before is in it after two
    // more writes, or once it is written no longer.
    constexpr int kStillMs = 300;
    qint64 size = -1;
    int writes = -1;
    QElapsedTimer still;
    static_cast<void>(QTest::qWaitFor(
        [&] {
            if (const qint64 now = QFileInfo(journal).size(); now != std::exchange(size, now)) {
                ++writes;
                still.start();
            }
            return writes >= 2 || still.elapsed() > kStillMs;
        },
        kPatienceMs));
    const QString kept = m_folder->filePath("kept");
    QFile::copy(journal, kept);
    m_application.reset();
    if (!QFile::rename(kept, journal))
        qFatal("a program that ends in order leaves no unfinished attempt behind");
    return journal;
}

}  // namespace support
