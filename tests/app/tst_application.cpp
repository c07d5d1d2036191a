// SPDX-License-Identifier: GPL-3.0-or-later
// The whole program behind a real window: its threads run, the mouse drills.
#include <algorithm>
#include <array>

#include <QAction>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QListView>
#include <QPushButton>
#include <QRadioButton>
#include <QSlider>
#include <QSqlQuery>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <glm/geometric.hpp>

#include "app/Application.h"
#include "core/teeth/Block.h"
#include "lessons/LessonCatalog.h"
#include "tests/support/OpenGlMain.h"
#include "ui/replay/HistoryPanel.h"
#include "ui/shell/Actions.h"
#include "ui/shell/MessageBar.h"
#include "ui/shell/TabularLabel.h"
#include "ui/study/Forecast.h"
#include "ui/study/ScorePage.h"
#include "ui/tooth/ToothView.h"

using ui::shell::MainWindow;

class TestApplication : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void cleanup() { m_application.reset(); }

    void theFirstMinutesFromBeginningToEnd();
    void theSameWorkIsGradedOnce();
    void aScoreIsExplainedInTheBackground();
    void stoppingAReplayBringsTheOwnWorkBack();
    void theOwnWorkIsStillAskedAboutAfterTwoReplays();
    void aMomentOfTheOwnAttemptIsShownAndLeft();
    void anotherAttemptIsPlayedBeside();
    void theExpertOfWhatIsPlayedIsPutBeside();
    void aHandIsLedAlongARecording();
    void theUndoHistoryLeadsToAnyMoment();
    void stoppingTheReplayOfWhoHasNoWorkGivesAWholeTooth();
    void theSimulatedHandpieceDrillsByItself();
    void anUnfinishedAttemptIsOfferedWhenItIsLetGo();
    void anUnfinishedAttemptIsOfferedAndTakenUp();
    void discardedAttemptsMakeWayForOlderOnes();
    void anExamThatWasGradedIsNotTakenUpAgain();
    void anExamsTimeGoesOnWhileItsStudentIsAway();

private:
    template <class T>
    T* child(const char* name = "") const
    {
        return m_application->window().findChild<T*>(QString::fromLatin1(name));
    }
    [[nodiscard]] ui::shell::Actions& actions() const { return *child<ui::shell::Actions>(); }
    [[nodiscard]] QString message() const { return child<ui::shell::MessageBar>()->sentence(); }
    [[nodiscard]] QString enamelRemoved() const { return child<ui::shell::TabularLabel>("enamelRemoved")->text(); }
    void start(const QString& recording = {}, bool simulatedDevice = false);
    /// Drills at a point of the tooth until more enamel is gone than before.
    void drillAt(glm::dvec3 pointMm) const;
    void save(const QString& path) const;
    /// Opens a shipped lesson and waits until it can be worked on.
    lessons::Lesson openLesson(const std::string& id) const;
    /// Brings the bur over a place of the tooth and presses the button.
    void pressAt(glm::dvec2 placeMm) const;
    /// Presses there until the exercise says so: the room may still be being laid out, and the servo getting its tooth.
    void touchUntil(glm::dvec2 placeMm, const QString& expectedTitle) const;
    /// Creates the school and goes to the tooth as its admin.
    void logIn() const;
    void letGo() const { QTest::mouseRelease(&m_application->window().view(), Qt::LeftButton); }
    [[nodiscard]] QString title() const { return child<QLabel>("exerciseTitle")->text(); }
    /// Asks for the score by the card's own button; the total is on the page.
    QString graded() const;
    QString expected() const;
    /// Has the work graded and goes back to it.
    void grade() const;
    /// Drills, and leaves the attempt's journal in `into` as a program leaves it that is killed now; then ends. Returns
    /// how much enamel was gone.
    QString leaveUnfinished(glm::dvec3 pointMm, const QString& into);
    [[nodiscard]] QStringList journals(const QString& folder = {}) const
    {
        return QDir(m_folder->filePath("unfinished/" + folder)).entryList({"*.cuspjournal"}, QDir::Files);
    }
    [[nodiscard]] QPushButton* messageButton(const char* name = "") const
    {
        return child<ui::shell::MessageBar>()->findChild<QPushButton*>(QString::fromLatin1(name));
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<app::Application> m_application;
};

void TestApplication::init()
{
    QLocale::setDefault(QLocale("en_GB"));
    m_folder = std::make_unique<QTemporaryDir>();
}

void TestApplication::start(const QString& recording, bool simulatedDevice)
{
    app::WindowOptions options;
    options.source = {36};
    options.database = m_folder->filePath("grades.sqlite");
    options.recording = recording;
    options.simulatedDevice = simulatedDevice;
    m_application = app::Application::make(options).value();
    m_application->show();
    QTRY_VERIFY_WITH_TIMEOUT(actions().grade->isEnabled(), 30000);
}

void TestApplication::logIn() const
{
    m_application->window().askLogin();  // nobody is let in who is not at the door
    emit m_application->window().schoolWanted({"admin", "Ada", "Admin", database::Role::Admin}, "correct horse");
    QTRY_COMPARE_WITH_TIMEOUT(actions().account->text(), QString("admin"), 30000);
    actions().back->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(actions().grade->isEnabled(), 30000);
}

void TestApplication::drillAt(glm::dvec3 pointMm) const
{
    ui::tooth::ToothView& view = m_application->window().view();
    const QString before = enamelRemoved();
    const glm::dvec2 pixel = view.camera().pixelOf(pointMm);
    const QPoint at(qRound(pixel.x), qRound(pixel.y));
    QTest::mouseMove(&view, at);
    QTest::mousePress(&view, Qt::LeftButton, {}, at);
    QTRY_VERIFY_WITH_TIMEOUT(enamelRemoved() != before, 30000);
    QTest::mouseRelease(&view, Qt::LeftButton, {}, at);
    QTest::qWait(500);  // the stroke ends, and is told
}

void TestApplication::save(const QString& path) const
{
    emit m_application->window().recordingSaveRequested(path);
    QTRY_VERIFY_WITH_TIMEOUT(message().contains("saved"), 30000);
}

void TestApplication::grade() const
{
    actions().grade->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(!actions().undo->isEnabled(), 10000);  // another page
    actions().back->trigger();
}

QString TestApplication::leaveUnfinished(glm::dvec3 pointMm, const QString& into)
{
    start();
    drillAt(pointMm);
    if (journals().size() != 1)
        qFatal("one journal, of the attempt on the table");
    actions().burs[3]->trigger();
    const QString own = enamelRemoved();
    QTest::qWait(200);  // the last of it reaches the disk
    const QString kept = m_folder->filePath(into);
    QFile::copy(m_folder->filePath("unfinished/" + journals().front()), kept);
    m_application.reset();
    if (!journals().isEmpty())
        qFatal("a program that ends in order leaves nothing behind");
    QFile::rename(kept, m_folder->filePath("unfinished/" + into));
    return own;
}

/// A program that dies holds what it has locked until it is gone.
void TestApplication::anUnfinishedAttemptIsOfferedWhenItIsLetGo()
{
    static_cast<void>(leaveUnfinished({-2.0, 1.0, -1.0}, "1-1.cuspjournal"));
    auto held = core::recording::findAttempt(
        std::filesystem::path(m_folder->filePath("unfinished/1-1.cuspjournal").toStdString()));
    QVERIFY(held && *held);
    bool isOfferedBefore = false;
    QTimer::singleShot(300, this, [&] {
        isOfferedBefore = message().contains("an attempt of");
        held->reset();
    });
    start();
    QVERIFY(!isOfferedBefore);
    QTRY_VERIFY_WITH_TIMEOUT(message().contains("Tooth 36: an attempt of"), 30000);
}

void TestApplication::anUnfinishedAttemptIsOfferedAndTakenUp()
{
    const QString own = leaveUnfinished({-2.0, 1.0, -1.0}, "1-1.cuspjournal");
    start();
    QTRY_VERIFY_WITH_TIMEOUT(message().contains("Tooth 36: an attempt of"), 30000);
    // Put away, it is offered again with the lessons.
    actions().back->trigger();
    QVERIFY(!message().contains("an attempt of"));
    actions().lessons->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("continueWords")->text().contains("Continue where I stopped: Tooth 36"),
                             30000);
    actions().back->trigger();
    // Never opened silently.
    QVERIFY(enamelRemoved() != own);
    QVERIFY(!actions().undo->isEnabled());
    actions().lessons->trigger();
    QTest::mouseClick(child<QPushButton>("continue"), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(enamelRemoved(), own, 30000);
    QVERIFY(message().contains("goes on where it was left"));
    QCOMPARE(journals(), QStringList{"1-1.cuspjournal"});
    QTRY_VERIFY(actions().undo->isEnabled());
    QTRY_VERIFY2(actions().burs[3]->isChecked(), "the bur that was in hand last");
    drillAt({2.0, 1.0, -1.0});
    // The same file holds what is done from now on.
    const QString again = enamelRemoved();
    QTest::qWait(200);
    QFile::copy(m_folder->filePath("unfinished/1-1.cuspjournal"), m_folder->filePath("kept"));
    m_application.reset();
    QVERIFY(journals().isEmpty());
    QVERIFY(QFile::rename(m_folder->filePath("kept"), m_folder->filePath("unfinished/1-1.cuspjournal")));
    start();
    QTRY_VERIFY_WITH_TIMEOUT(message().contains("Tooth 36: an attempt of"), 30000);
    QTest::mouseClick(messageButton(), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(enamelRemoved(), again, 30000);
    actions().undo->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(enamelRemoved(), own, 30000);
}

void TestApplication::discardedAttemptsMakeWayForOlderOnes()
{
    const int kTwoClicksMs =
        3 * QApplication::doubleClickInterval();  // the second of one click is not meant for another
    leaveUnfinished({-2.0, 1.0, -1.0}, "1-1.cuspjournal");
    const QString newest = m_folder->filePath("unfinished/2-1.cuspjournal");
    QVERIFY(QFile::copy(m_folder->filePath("unfinished/1-1.cuspjournal"), newest));
    QFile broken(m_folder->filePath("unfinished/3-1.cuspjournal"));
    QVERIFY(broken.open(QIODevice::WriteOnly));
    broken.write("This is no journal.");
    broken.close();
    start();
    QTRY_VERIFY_WITH_TIMEOUT(message().contains("Tooth 36: an attempt of"), 30000);
    QCOMPARE(journals("discarded"), QStringList{"3-1.cuspjournal"});
    QTest::mouseClick(messageButton("decline"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(journals("discarded").size() == 2, 30000);
    QTRY_VERIFY_WITH_TIMEOUT(message().contains("Tooth 36: an attempt of"), 30000);
    QTest::qWait(kTwoClicksMs);
    QTest::mouseClick(messageButton("decline"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(journals("discarded").size() == 3, 30000);
    QVERIFY(journals().isEmpty());
    // Thought better of it.
    QTRY_VERIFY_WITH_TIMEOUT(message().contains("kept for seven days"), 30000);
    QTest::mouseClick(messageButton(), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(message().contains("Tooth 36: an attempt of"), 30000);
    QCOMPARE(journals().size(), 1);
    QTest::qWait(kTwoClicksMs);
    QTest::mouseClick(messageButton("decline"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(journals("discarded").size() == 3 && journals().isEmpty(), 30000);
    while (!message().isEmpty() && !message().contains("cannot be taken up again"))
        child<ui::shell::MessageBar>()->dismiss();
    QVERIFY(message().contains("cannot be taken up again"));
}

void TestApplication::anExamThatWasGradedIsNotTakenUpAgain()
{
    QFile file(m_folder->filePath("exam.lesson.json"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(R"({"format": 1, "based_on": "decay-36-2-moderate.lesson.json", "id": "exam-36", "exam": true})");
    file.close();
    const auto read = lessons::readLesson(file.fileName());
    QVERIFY(read.lesson && read.lesson->exam);
    for (const bool isGraded : {false, true}) {
        start();
        emit m_application->window().lessonChosen(*read.lesson);
        QTest::qWait(100);
        QTRY_VERIFY_WITH_TIMEOUT(actions().grade->isEnabled(), 30000);
        drillAt({-2.0, 1.0, -1.0});
        if (isGraded) {
            actions().grade->trigger();
            QTRY_VERIFY_WITH_TIMEOUT(child<ui::study::Forecast>()->isVisible(), 30000);
            QVERIFY(!expected().isEmpty());
            QVERIFY(child<ui::study::ScorePage>()->isVisible());
        }
        QTest::qWait(300);  // the last of it reaches the disk
        QCOMPARE(journals().size(), 1);
        const QString kept = m_folder->filePath("kept");
        QVERIFY(QFile::copy(m_folder->filePath("unfinished/" + journals().front()), kept));
        m_application.reset();
        QVERIFY(QFile::rename(kept, m_folder->filePath("unfinished/1-1.cuspjournal")));
        start();
        if (isGraded) {
            QTRY_COMPARE_WITH_TIMEOUT(journals("discarded").size(), 1, 30000);
            QVERIFY(!message().contains("an attempt of"));
        } else {
            QTRY_VERIFY_WITH_TIMEOUT(message().contains("an attempt of"), 30000);
            QFile::remove(m_folder->filePath("unfinished/1-1.cuspjournal"));
        }
        m_application.reset();
    }
}

/// Who leaves an exam, or has its program killed, could think as long as he likes.
void TestApplication::anExamsTimeGoesOnWhileItsStudentIsAway()
{
    QFile file(m_folder->filePath("exam.lesson.json"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(R"({"format": 1, "based_on": "decay-36-2-moderate.lesson.json", "id": "exam-36", "exam": true,
                   "minutes": 10})");
    file.close();
    const auto read = lessons::readLesson(file.fileName());
    QVERIFY(read.lesson && read.lesson->exam);
    start();
    emit m_application->window().lessonChosen(*read.lesson);
    QTest::qWait(100);
    QTRY_VERIFY_WITH_TIMEOUT(actions().grade->isEnabled(), 30000);
    drillAt({-2.0, 1.0, -1.0});
    QTest::qWait(300);
    QCOMPARE(journals().size(), 1);
    const QString kept = m_folder->filePath("kept");
    QVERIFY(QFile::copy(m_folder->filePath("unfinished/" + journals().front()), kept));
    m_application.reset();
    // It was begun four minutes ago.
    const auto found = core::recording::findAttempt(kept.toStdString());
    QVERIFY(found && *found);
    const std::int64_t begunUtcMs = QDateTime::currentMSecsSinceEpoch() - 240'000;
    auto made = core::recording::JournalFile::create(m_folder->filePath("unfinished/1-1.cuspjournal").toStdString(),
                                                     (*found)->recording, begunUtcMs);
    QVERIFY(made && (*made)->sync());
    made->reset();
    start();
    QTRY_VERIFY_WITH_TIMEOUT(message().contains("an attempt of"), 30000);
    QTest::mouseClick(messageButton(), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(message().contains("goes on where it was left"), 30000);
    const auto* left = child<ui::shell::TabularLabel>("lessonTime");
    QTRY_VERIFY2_WITH_TIMEOUT(left->text().startsWith("5:"), qPrintable(left->text()), 30000);
}

lessons::Lesson TestApplication::openLesson(const std::string& id) const
{
    lessons::Lesson lesson;
    for (const lessons::CatalogEntry& entry : lessons::readCatalog({}))
        if (entry.read.lesson && entry.read.lesson->id == id)
            lesson = *entry.read.lesson;
    if (lesson.id.empty())
        qFatal("no such lesson");
    emit m_application->window().lessonChosen(lesson);
    QTest::qWait(100);
    [&] { QTRY_VERIFY_WITH_TIMEOUT(actions().grade->isEnabled(), 30000); }();
    // From above, so that nothing stands before anything.
    ui::tooth::ToothView& view = m_application->window().view();
    view.setCamera(0.0, 85.0, view.camera().distanceMm());
    return lesson;
}

void TestApplication::pressAt(glm::dvec2 placeMm) const
{
    ui::tooth::ToothView& view = m_application->window().view();
    const core::terrain::Tooth& tooth = *view.tooth();
    const glm::dvec2 node = tooth.anatomy->grid.latticeOf(placeMm);
    const std::size_t k = tooth.anatomy->grid.index(qRound(node.x), qRound(node.y));
    const glm::dvec2 pixel = view.camera().pixelOf({placeMm, static_cast<double>(tooth.anatomy->top[k])});
    const QPoint at(qRound(pixel.x), qRound(pixel.y));
    QTest::mouseMove(&view, at);
    QTest::qWait(600);  // the hand gets there
    QTest::mousePress(&view, Qt::LeftButton, {}, at);
}

void TestApplication::touchUntil(glm::dvec2 placeMm, const QString& expectedTitle) const
{
    for (int tries = 0; tries < 5 && title() != expectedTitle; ++tries) {
        pressAt(placeMm);
        static_cast<void>(QTest::qWaitFor([&] { return title() == expectedTitle; }, 3000));
        letGo();
        QTest::qWait(200);
    }
    QCOMPARE(title(), expectedTitle);
}

QString TestApplication::graded() const
{
    auto* button = child<QPushButton>("exerciseGrade");
    if (!button->isVisible())
        return QStringLiteral("is not offered");
    QTest::mouseClick(button, Qt::LeftButton);
    if (!QTest::qWaitFor([this] { return child<ui::study::Forecast>()->isVisible(); }, 3000))
        return message();
    return expected();
}

/// What the score is once something was expected of it.
QString TestApplication::expected() const
{
    if (child<QPushButton>("showScore")->isEnabled())
        return QStringLiteral("shows the score before anything is expected");
    QTest::keyClick(child<QSlider>("expected"), Qt::Key_Right);
    QTest::keyClick(child<ui::study::Forecast>()->findChild<QRadioButton*>(), Qt::Key_Space);
    QTest::mouseClick(child<QPushButton>("showScore"), Qt::LeftButton);
    return child<ui::study::ScorePage>()->isVisible() ? child<ui::shell::TabularLabel>("total")->text() : message();
}

/// All three exercises, by the mouse, as somebody does them who has never held a handpiece.
void TestApplication::theFirstMinutesFromBeginningToEnd()
{
    start();
    QTRY_VERIFY(actions().drill->isChecked());
    const lessons::Lesson touch = openLesson("orientation-1-touch");
    QTRY_VERIFY(!actions().drill->isChecked());
    QCOMPARE(title(), QString("0 of 6 points touched"));
    // As soon as the tooth has come to the servo.
    const auto refused = [this] {
        actions().grade->trigger();
        return message().contains("not been begun");
    };
    QTRY_VERIFY2(refused(), qPrintable(message()));
    // With the bur turning nothing counts as touched, and it is said.
    actions().drill->trigger();
    QTRY_VERIFY(child<QLabel>("exerciseAdvice")->text().contains("space bar"));
    actions().drill->trigger();
    QTRY_VERIFY(!child<QLabel>("exerciseAdvice")->text().contains("space bar"));
    const auto touchAll = [&](const std::array<std::size_t, 6>& order) {
        for (std::size_t n = 0; n < order.size(); ++n)
            touchUntil(touch.touch->pointsMm[order[n]],
                       n < 5 ? QString("%1 of 6 points touched").arg(n + 1) : QString("All 6 points touched"));
    };
    touchAll({3, 0, 5, 1, 4, 2});
    QCOMPARE(graded(), QString("100.0"));
    // Anew, from the score as from the tooth: nothing is touched.
    actions().reload->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(title(), QString("0 of 6 points touched"), 10000);
    QVERIFY(!child<ui::study::ScorePage>()->isVisible());
    QTRY_VERIFY(!actions().drill->isChecked());
    QTest::qWait(500);  // the room is laid out, and the tooth has come to the servo
    ui::tooth::ToothView& view = m_application->window().view();
    view.setCamera(0.0, 85.0, view.camera().distanceMm());
    touchAll({0, 1, 2, 3, 4, 5});
    QCOMPARE(graded(), QString("100.0"));
    // The same is not graded twice: the page comes at once, without a question.
    actions().back->trigger();
    actions().grade->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::study::ScorePage>()->isVisible(), 30000);
    actions().back->trigger();

    openLesson("orientation-2-hold");
    QVERIFY(!actions().drill->isChecked());
    QTRY_COMPARE(title(), QString("Hold 1.0 N for 10 s"));
    m_application->window().view().setPushForce(1.0);
    pressAt({-0.27, 0.64});
    QTRY_COMPARE_WITH_TIMEOUT(title(), QString("Held for 10 s"), 30000);
    letGo();
    QCOMPARE(graded(), QString("100.0"));
    actions().back->trigger();

    openLesson("orientation-3-layers");
    QTRY_VERIFY(actions().drill->isChecked());
    QVERIFY(!child<ui::shell::TabularLabel>("materialFigure")->isVisible());
    pressAt({core::teeth::kPadX[0], 0.0});
    QTest::qWait(1000);
    letGo();
    const auto made = core::teeth::padMaterials(m_application->window().view().tooth()->anatomy->seed);
    const auto choose = [&](std::size_t pad, core::terrain::Material said) {
        QTest::mouseClick(
            child<QPushButton>(qPrintable(QStringLiteral("pad%1%2").arg(pad).arg(static_cast<int>(said)))),
            Qt::LeftButton);
    };
    choose(0, made[0]);
    choose(1, made[2]);
    choose(1, made[1]);  // thought better of it
    choose(2, made[0]);
    QCOMPARE(title(), QString("Every pad has its name"));
    QTest::qWait(200);
    QCOMPARE(graded(), QString("70.0"));  // two of three: 90 * 2 / 3 and 10 for the force
    actions().back->trigger();
    QVERIFY(child<ui::shell::TabularLabel>("materialFigure")->isVisible());
    QVERIFY(child<QLabel>("padTruth0")->text().contains("right"));
    QVERIFY(child<QLabel>("padTruth2")->text().contains("it is"));
}

void TestApplication::theSameWorkIsGradedOnce()
{
    start();
    logIn();
    const auto rows = [this] {
        const auto database = database::sql::Database::open(m_folder->filePath("grades.sqlite")).value();
        QSqlQuery query(database->handle());
        return query.exec("SELECT count(*) FROM attempts WHERE tooth = '36' AND person_id IS NOT NULL") && query.next()
                   ? query.value(0).toInt()
                   : -1;
    };
    const auto grade = [this] {
        actions().grade->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(child<ui::study::ScorePage>()->isVisible(), 30000);
        actions().back->trigger();
    };
    // A whole tooth is no attempt.
    actions().grade->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(message().contains("not ready") || message().contains("Nothing has been cut"), 30000);
    QVERIFY(!child<ui::study::ScorePage>()->isVisible());
    QCOMPARE(rows(), 0);
    drillAt({-2.0, 1.0, -1.0});
    grade();
    grade();
    QTRY_COMPARE_WITH_TIMEOUT(rows(), 1, 30000);
    QTest::qWait(200);
    QCOMPARE(rows(), 1);
    drillAt({2.0, 1.0, -1.0});
    grade();
    grade();
    QTRY_COMPARE_WITH_TIMEOUT(rows(), 2, 30000);
    QTest::qWait(200);
    QCOMPARE(rows(), 2);
}

/// Moments and other grids come when they are found; shown again, the same grade has them at once; a click on a moment
/// plays the attempt from there.
void TestApplication::aScoreIsExplainedInTheBackground()
{
    start();
    logIn();
    drillAt({-2.0, 1.0, -1.0});
    const QString own = enamelRemoved();
    actions().grade->trigger();
    const auto moments = [this] {
        QList<QPushButton*> found;
        for (QPushButton* button : child<ui::study::ScorePage>()->findChildren<QPushButton*>())
            if (button->text().contains("never removed"))
                found << button;
        return found;
    };
    QTRY_COMPARE_WITH_TIMEOUT(moments().size(), 1, 30000);
    QVERIFY(child<QLabel>("noise")->isVisible());
    QVERIFY2(child<QLabel>("noise")->text().contains("At half the grid"), qPrintable(child<QLabel>("noise")->text()));
    QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("class")->isVisible(), 30000);
    actions().back->trigger();
    actions().grade->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(child<ui::study::ScorePage>()->isVisible(), 30000);
    QCOMPARE(moments().size(), 1);
    QVERIFY(child<QLabel>("noise")->isVisible());
    QTest::mouseClick(moments().front(), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(actions().pauseReplay->isEnabled(), 30000);
    QVERIFY(!child<ui::study::ScorePage>()->isVisible());
    QTRY_COMPARE_WITH_TIMEOUT(enamelRemoved(), own, 30000);  // how it ended
}

void TestApplication::stoppingAReplayBringsTheOwnWorkBack()
{
    start();
    drillAt({-2.0, 1.0, -1.0});
    const QString recording = m_folder->filePath("first.cusprec");
    save(recording);
    drillAt({2.0, 1.0, -1.0});
    const QString own = enamelRemoved();
    const QImage tooth = m_application->window().view().toothPicture();
    emit m_application->window().recordingOpenRequested(recording);
    QTRY_VERIFY_WITH_TIMEOUT(actions().pauseReplay->isEnabled(), 30000);
    QTRY_VERIFY(enamelRemoved() != own);
    actions().back->trigger();
    QVERIFY(message().contains("your own work"));
    QTRY_COMPARE(enamelRemoved(), own);
    QCOMPARE(m_application->window().view().toothPicture(), tooth);
    // And it goes on from there.
    QVERIFY(actions().undo->isEnabled());
    drillAt({0.0, -2.0, -1.0});
}

void TestApplication::theOwnWorkIsStillAskedAboutAfterTwoReplays()
{
    start();
    drillAt({-2.0, 1.0, -1.0});
    const QString recording = m_folder->filePath("first.cusprec");
    save(recording);
    drillAt({2.0, 1.0, -1.0});
    for (int n = 0; n < 2; ++n) {
        emit m_application->window().recordingOpenRequested(recording);
        QVERIFY(!actions().openRecording->isEnabled());
        QTRY_VERIFY_WITH_TIMEOUT(actions().openRecording->isEnabled() && actions().pauseReplay->isEnabled(), 30000);
        QTest::qWait(300);  // what the recording has cut is told
    }
    m_application->window().close();
    QVERIFY(m_application->window().isVisible());
    QVERIFY(child<QWidget>("workQuestion") != nullptr);
}

void TestApplication::aMomentOfTheOwnAttemptIsShownAndLeft()
{
    start();
    drillAt({-2.0, 1.0, -1.0});
    const QString own = enamelRemoved();
    QVERIFY(own != "0.00");
    QTest::qWait(1500);  // an attempt of more than a second
    grade();
    m_application->showMoment(1.0e6);
    // Held, a moment before its end.
    QVERIFY(actions().pauseReplay->text().startsWith("Resume"));
    const auto time = [this] { return child<ui::shell::TabularLabel>("replayTime")->text(); };
    // To a second, for the words are rounded.
    const auto seconds = [&](int part) {
        const QStringList words = time().section(" of ", part, part).split(u':');
        return 60 * words.front().toInt() + words.back().toInt();
    };
    QTRY_VERIFY2_WITH_TIMEOUT(seconds(1) > 0 && seconds(1) - seconds(0) <= 1, qPrintable(time()), 10000);
    QTRY_COMPARE(enamelRemoved(), own);
    const QImage cut = m_application->window().view().toothPicture();
    // What is said at the end is not said elsewhere.
    m_application->window().showReplayEnd();
    QVERIFY(message().contains("come to its end"));
    actions().stepBack->trigger();
    QVERIFY2(!message().contains("come to its end"), qPrintable(message()));
    // Back to before it was cut, and forth to what the stroke has left.
    actions().replayBegin->trigger();
    QTRY_COMPARE(enamelRemoved(), QString("0.00"));
    QVERIFY(m_application->window().view().toothPicture() != cut);
    actions().stepOn->trigger();
    QTRY_COMPARE(enamelRemoved(), own);
    QCOMPARE(m_application->window().view().toothPicture(), cut);
    actions().stepBack->trigger();
    QTRY_COMPARE(enamelRemoved(), QString("0.00"));
    // To the card, where the other moments are, and from there to the tooth.
    actions().back->trigger();
    QVERIFY(child<ui::study::ScorePage>()->isVisible());
    actions().back->trigger();
    QTRY_COMPARE(enamelRemoved(), own);
    drillAt({2.0, 1.0, -1.0});
}

void TestApplication::anotherAttemptIsPlayedBeside()
{
    start();
    drillAt({-2.0, 1.0, -1.0});
    const QString recording = m_folder->filePath("first.cusprec");
    save(recording);
    drillAt({2.0, 1.0, -1.0});
    const QString own = enamelRemoved();
    grade();
    m_application->showMoment(1.0e6);
    const auto views = [this] { return m_application->window().findChildren<ui::tooth::ToothView*>(); };
    for (int n = 0; n < 2; ++n) {  // another one takes its place
        emit m_application->window().besideWanted(recording);
        QTRY_VERIFY_WITH_TIMEOUT(actions().beside->isEnabled() && views().size() == 2, 30000);
    }
    const auto* beside = views().front() == &m_application->window().view() ? views().back() : views().front();
    // Both at their ends: what the first stroke has left, and what both have.
    actions().replayEnd->trigger();
    const auto cut = [](const ui::tooth::ToothView& view) {
        double sum = 0.0;
        for (std::size_t k = 0; k < view.tooth()->top.size(); ++k)
            sum += static_cast<double>(view.tooth()->anatomy->top[k] - view.tooth()->top[k]);
        return sum;
    };
    QTRY_VERIFY_WITH_TIMEOUT(cut(*beside) > 0.0 && cut(m_application->window().view()) > cut(*beside), 10000);
    actions().replayBegin->trigger();
    QTRY_VERIFY(cut(*beside) == 0.0 && cut(m_application->window().view()) == 0.0);
    actions().beside->trigger();
    QCOMPARE(views().size(), 1);
    emit m_application->window().besideWanted(recording);
    QTRY_COMPARE_WITH_TIMEOUT(views().size(), 2, 30000);
    actions().back->trigger();
    QCOMPARE(views().size(), 1);
    QTRY_COMPARE(enamelRemoved(), own);
}

/// Whatever lies on the table meanwhile.
void TestApplication::theExpertOfWhatIsPlayedIsPutBeside()
{
    start();
    static_cast<void>(openLesson("decay-36-small"));
    drillAt({-2.0, 1.0, -1.0});
    const QString recording = m_folder->filePath("lesson.cusprec");
    save(recording);
    m_application.reset();
    start(recording);
    QTRY_VERIFY_WITH_TIMEOUT(actions().expert->isVisible() && actions().expert->isEnabled(), 30000);
    actions().expert->trigger();
    // The end of what is played may be told over the sentence about it: the view itself says whose hand it is.
    const auto isShown = [this] {
        const auto views = m_application->window().findChildren<ui::tooth::ToothView*>();
        return views.size() == 2 && std::any_of(views.begin(), views.end(), [](const ui::tooth::ToothView* view) {
                   return view->accessibleName() == "The simulated hand";
               });
    };
    QTRY_VERIFY2_WITH_TIMEOUT(isShown(), qPrintable(message()), 180000);
}

void TestApplication::aHandIsLedAlongARecording()
{
    start({}, true);
    const QString before = enamelRemoved();
    QTRY_VERIFY_WITH_TIMEOUT(enamelRemoved() != before, 30000);
    QTest::qWait(1500);
    grade();
    m_application->showMoment(1.0e6);
    QTRY_VERIFY_WITH_TIMEOUT(actions().along->isEnabled(), 10000);
    core::session::ServoState seen;
    connect(&m_application->window().view(), &ui::tooth::ToothView::frameAdvanced, this,
            [&seen](const core::session::ServoState& state) { seen = state; });
    const auto apartMm = [&seen] { return glm::length(seen.deviceMm - seen.anchorMm); };
    // Where the machine stands still for a moment the hand seems to hold against it, and is let go.
    for (int tries = 0; tries < 5 && !actions().along->isChecked(); ++tries) {
        actions().replayBegin->trigger();
        actions().along->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(seen.tick == 0 || apartMm() < 3.0, 10000);
        if (tries == 0)
            actions().pauseReplay->trigger();  // it goes on
        QTest::qWait(1500);
    }
    QVERIFY2(actions().along->isChecked(), qPrintable("a hand that goes along is not let go: " + message()));
    QVERIFY2(apartMm() < 3.0, qPrintable(QString("%1 mm").arg(apartMm())));
    actions().along->trigger();
    actions().back->trigger();
    QTRY_VERIFY(!actions().along->isVisible());
}

void TestApplication::theUndoHistoryLeadsToAnyMoment()
{
    start();
    actions().history->trigger();
    const auto* list = &child<ui::replay::HistoryPanel>("historyPanel")->list();
    drillAt({-2.0, 1.0, -1.0});
    const QString first = enamelRemoved();
    QTRY_COMPARE(list->model()->rowCount(), 2);
    actions().undo->trigger();
    QTRY_COMPARE(enamelRemoved(), QString("0.00"));
    drillAt({2.0, 1.0, -1.0});
    const QString second = enamelRemoved();
    QTRY_COMPARE(list->model()->rowCount(), 3);
    const auto goTo = [&](int row) {
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                          list->visualRect(list->model()->index(row, 0)).center());
    };
    goTo(1);  // what was undone
    QTRY_COMPARE(enamelRemoved(), first);
    goTo(2);
    QTRY_COMPARE(enamelRemoved(), second);
    goTo(0);
    QTRY_COMPARE(enamelRemoved(), QString("0.00"));
    QVERIFY(list->model()->index(0, 0).data().toString().contains("present"));
}

void TestApplication::stoppingTheReplayOfWhoHasNoWorkGivesAWholeTooth()
{
    start();
    drillAt({-2.0, 1.0, -1.0});
    const QString recording = m_folder->filePath("first.cusprec");
    save(recording);
    m_application.reset();
    start(recording);
    QVERIFY(actions().pauseReplay->isEnabled());
    actions().back->trigger();
    QVERIFY(message().contains("whole"));
    QTRY_COMPARE(enamelRemoved(), QString("0.00"));
    drillAt({-2.0, 1.0, -1.0});
}

void TestApplication::theSimulatedHandpieceDrillsByItself()
{
    start({}, true);
    const QList<QLabel*> labels = m_application->window().findChildren<QLabel*>();
    QVERIFY(std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
        return label->isVisible() && label->text() == "The simulated handpiece is at work";
    }));
    const QString before = enamelRemoved();
    QTRY_VERIFY_WITH_TIMEOUT(enamelRemoved() != before, 30000);
}

int main(int argc, char** argv)
{
    return support::openGlMain<TestApplication>(argc, argv);
}

#include "tst_application.moc"
