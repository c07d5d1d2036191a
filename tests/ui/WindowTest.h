// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include <QApplication>
#include <QDropEvent>
#include <QFileDialog>
#include <QMenu>
#include <QMimeData>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "core/servo/ServoState.h"
#include "core/session/SessionChannels.h"
#include "lessons/LessonCatalog.h"
#include "lessons/Rubric.h"
#include "tests/database/SchoolRig.h"
#include "tests/support/SyntheticMolar.h"
#include "ui/kit/Actions.h"
#include "ui/kit/ConfirmOverlay.h"
#include "ui/kit/MessageBar.h"
#include "ui/kit/TabularDigitsLabel.h"
#include "ui/kit/Theme.h"
#include "ui/replay/AttemptTimeline.h"
#include "ui/tooth/ToothView.h"
#include "ui/window/MainWindow.h"
#include "ui/window/PracticeRoom.h"

namespace support {

inline const std::vector<lessons::CatalogEntry>& catalog()
{
    static const std::vector<lessons::CatalogEntry> all = lessons::readCatalog({});
    return all;
}

template <class Fits>
const lessons::ReadLesson& shippedWhere(const Fits& fits)
{
    for (const lessons::CatalogEntry& entry : catalog())
        if (entry.read.lesson && fits(*entry.read.lesson))
            return entry.read;
    qFatal("no such lesson");
    return catalog().front().read;
}

inline const lessons::ReadLesson& shipped(const std::string& id)
{
    return shippedWhere([&](const lessons::Lesson& lesson) { return lesson.id == id; });
}

/// Returns the assignment of a lesson, made once.
inline const lessons::Assignment& assigned(const std::string& id)
{
    static std::map<std::string, lessons::Assignment> all;
    const auto [found, isNew] = all.try_emplace(id);
    if (isNew)
        found->second = lessons::assign(*shipped(id).lesson).value().assignment;
    return found->second;
}

inline const lessons::Assignment& assigned(lessons::Task task)
{
    return assigned(
        shippedWhere([&](const lessons::Lesson& lesson) { return lesson.task == task && !lesson.exam; }).lesson->id);
}

inline lessons::Assignment exam(const std::string& id = "class1-36")
{
    lessons::Assignment assignment = assigned(id);
    assignment.lesson->exam = true;
    return assignment;
}

inline lessons::ScoreSheet sheet(double cariesPercent, double soundMm3, double pulpMm2)
{
    lessons::Rubric rubric;
    rubric.title = {{"en", "Trial"}};
    rubric.version = 2;
    rubric.hash = std::string(64, 'a');
    for (const auto& [id, unit, tolerance, span, weight] : {std::tuple("caries_left", "percent", 1.0, 30.0, 600),
                                                            {"sound_tissue", "mm3", 4.0, 20.0, 400},
                                                            {"pulp_exposure", "mm2", 0.0, 0.0, 0}}) {
        lessons::CriterionRule& rule = rubric.criteria.emplace_back();
        rule.id = rule.measure = id;
        rule.unit = unit;
        rule.tolerance = tolerance;
        rule.span = span;
        rule.weightTenths = weight;
        rule.critical = weight == 0;
    }
    return lessons::grade(rubric,
                          {{"caries_left", cariesPercent}, {"sound_tissue", soundMm3}, {"pulp_exposure", pulpMm2}});
}

/// Returns an attempt with two strokes with different burs, an undo, and a breach.
inline ui::replay::AttemptTimeline course()
{
    ui::replay::AttemptTimeline course;
    course.lengthS = course.readyS = 60.0;
    course.strokes = {{5.0, 9.0, 9.01, 0}, {20.0, 21.0, 21.01, 3}};
    using ui::replay::Mark;
    course.marks = {{Mark::Kind::Bur, 15.0, 3},
                    {Mark::Kind::Handpiece, 26.0, 1, "electric"},
                    {Mark::Kind::Undo, 40.0, 9000},
                    {Mark::Kind::Note, 50.0, core::grading::answerNote(1, core::terrain::Material::Dentin)}};
    core::grading::Infraction breach;
    breach.breach = core::grading::RuleViolation::PulpExposed;
    breach.seconds = 20.5;
    course.infractions = {breach};
    return course;
}

/// Tests of the main window. The test takes the part of the threads: it publishes their state, and reads the commands.
///
/// The cases of a program share one window. begin() of each case returns it to a whole tooth in the practice room. If a
/// case closes the window, or changes it for good, it calls spoil(): the next case has a new window.
class WindowTest : public QObject
{
protected:
    static void prepare()
    {
        QLocale::setDefault(QLocale("en_GB"));
        QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
        static const QTemporaryDir settings;
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
        ui::kit::applyTheme(*qApp, ui::kit::ThemeChoice::Light);
    }

    void begin()
    {
        if (m_window == nullptr || m_isSpoilt) {
            QSettings(QStringLiteral("cusp"), QStringLiteral("cusp")).clear();
            openWindow();
        } else {
            reset();
        }
        core::session::SessionState session;
        session.toothGeneration = m_generation;
        session.undoSteps = 3;
        session.redoSteps = 1;
        take({}, session);
        QVERIFY(actions().undo->isEnabled());
        static_cast<void>(sent());
    }
    void end()
    {
        m_isSpoilt = m_isSpoilt || QTest::currentTestFailed();
        if (m_isSpoilt)
            m_window.reset();
    }
    void spoil() { m_isSpoilt = true; }

    /// Opens another window, which reads the settings that the one before has left.
    void openWindow()
    {
        m_isSpoilt = false;
        m_window.reset();
        m_links = std::make_unique<core::session::UiChannels>();
        m_window = std::make_unique<ui::window::MainWindow>(*m_links);
        m_window->show();
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
        m_generation = 0;
        takeUsualHandpieces();
        show();
    }

    template <class T>
    T* child(const char* name = nullptr) const
    {
        return m_window->findChild<T*>(name == nullptr ? QString() : QString::fromLatin1(name));
    }
    [[nodiscard]] QString figure(const char* name) const { return child<ui::kit::TabularDigitsLabel>(name)->text(); }
    [[nodiscard]] QString message() const { return child<ui::kit::MessageBar>()->sentence(); }
    [[nodiscard]] ui::kit::Actions& actions() const { return *child<ui::kit::Actions>(); }
    [[nodiscard]] bool isInRoom() const { return child<ui::window::PracticeRoom>()->isVisible(); }
    [[nodiscard]] ui::kit::ConfirmOverlay* question(const char* name = "workQuestion") const
    {
        return child<ui::kit::ConfirmOverlay>(name);
    }
    /// Presses a button of a question or a card.
    void click(const char* name) const
    {
        auto* button = child<QPushButton>(name);
        QVERIFY2(button != nullptr && button->isVisible(), name);
        button->click();
    }
    /// Presses keys like a person, so that the window's shortcuts receive them.
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) const
    {
        QTest::keyClick(QApplication::focusWidget() != nullptr ? QApplication::focusWidget() : m_window.get(), key,
                        modifiers);
    }
    void press(const QKeySequence& keys) const { press(keys[0].key(), keys[0].keyboardModifiers()); }
    /// Accepts the open file dialog with this path.
    void accept(const QString& path) const
    {
        auto* dialog = child<QFileDialog>();
        QVERIFY(dialog != nullptr);
        dialog->setDirectory(QFileInfo(path).path());
        dialog->selectFile(path);
        QMetaObject::invokeMethod(dialog, "accept");
    }

    /// Drops data on the window. Returns false if the window does not accept it.
    [[nodiscard]] bool drop(const QMimeData& data) const
    {
        QDragEnterEvent enter(QPoint(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(m_window.get(), &enter);
        if (!enter.isAccepted())
            return false;
        QDropEvent event(QPointF(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(m_window.get(), &event);
        return true;
    }
    [[nodiscard]] bool dropFile(const QString& path) const
    {
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(path)});
        return drop(data);
    }

    /// Puts another tooth on the table.
    void show(const std::shared_ptr<const core::terrain::ToothAnatomy>& tooth = support::syntheticMolar())
    {
        m_window->showTooth(tooth, ++m_generation, {});
    }
    void beginLesson(const lessons::Assignment& assignment)
    {
        m_window->setAssignment(assignment);
        show(assignment.anatomy);
    }
    /// Begins a lesson that allows every aid except this one.
    void forbid(bool lessons::Aids::*aid) const
    {
        lessons::Aids aids;
        aids.*aid = false;
        m_window->lessonController().setAids(aids);
    }
    /// Publishes a state of the threads. The window has taken it when the call returns.
    void take(const core::servo::ServoState& servo, const core::session::SessionState& session) const
    {
        m_links->servo.publish(servo);
        m_links->session.publish(session);
        frame();
    }
    void frame() const
    {
        QSignalSpy drawn(&m_window->view(), &ui::tooth::ToothView::frameAdvanced);
        QVERIFY(drawn.wait(20'000));
    }
    /// Publishes a state in which so much enamel of the shown tooth is gone.
    void cutSomething(double enamelMm3) const
    {
        core::session::SessionState session;
        session.toothGeneration = m_generation;
        session.removedMm3[1] = enamelMm3;
        session.undoSteps = static_cast<int>(enamelMm3 * 100.0);
        take({}, session);
        QTRY_COMPARE(figure("enamelRemoved"), QString::number(enamelMm3, 'f', 2));
    }

    /// Returns all commands since the last call.
    [[nodiscard]] std::vector<core::session::SessionCommand> allSent() const
    {
        std::vector<core::session::SessionCommand> all;
        for (core::session::SessionCommand c; m_links->commands.tryPop(c);)
            all.push_back(std::move(c));
        return all;
    }
    /// Returns the commands of the user: the window itself adds notes of aids and rests.
    [[nodiscard]] std::vector<core::session::SessionCommand> sent() const
    {
        std::vector<core::session::SessionCommand> all = allSent();
        std::erase_if(all, [](const core::session::SessionCommand& c) {
            return std::holds_alternative<core::session::SetAids>(c) || isRest(c);
        });
        return all;
    }
    [[nodiscard]] static bool isRest(const core::session::SessionCommand& command)
    {
        const auto* note = std::get_if<core::session::AddNote>(&command);
        return note != nullptr && (note->code == core::servo::kRestNote || note->code == core::servo::kWorkNote);
    }
    /// Returns the requests for the drill since the last call.
    [[nodiscard]] QList<bool> drillSent() const
    {
        QList<bool> all;
        for (const core::session::SessionCommand& command : allSent())
            if (const auto* drill = std::get_if<core::servo::SetDrill>(&command))
                all << drill->on;
        return all;
    }

    /// Returns a school with people of every role. It is made once and not changed.
    static const support::SchoolRig& school()
    {
        static const auto rig = [] {
            auto made = std::make_unique<support::SchoolRig>(false);
            made->populate();
            return made;
        }();
        return *rig;
    }

    std::unique_ptr<core::session::UiChannels> m_links;
    std::unique_ptr<ui::window::MainWindow> m_window;
    std::uint64_t m_generation = 0;  ///< of the tooth on the table

private:
    void takeUsualHandpieces()
    {
        const auto all = core::settings::handpieces();
        m_window->setHandpieces({all.begin(), all.end()});
    }
    /// Resets the window for the next case.
    void reset()
    {
        for (QFileDialog* dialog : m_window->findChildren<QFileDialog*>())
            delete dialog;
        for (ui::kit::ConfirmOverlay* card : m_window->findChildren<ui::kit::ConfirmOverlay*>())
            delete card;
        m_window->setWho({});
        m_window->setMayEdit(true);
        m_window->leaveAll();
        m_window->stopBusy();
        m_window->replayView().hideBeside();
        m_window->setReplaying(false);
        m_window->unsavedWork().setUnsavedGrades(0);
        takeUsualHandpieces();
        beginLesson(lessons::practiceOn(support::syntheticMolar()).value());
        for (int steps = 0; !isInRoom() && steps < 5; ++steps)
            actions().back->trigger();
        for (QAction* shown : {actions().section, actions().otherHand, actions().fullScreen, actions().history,
                               actions().mirror, actions().wetLook, actions().drill})
            if (shown->isChecked())
                shown->trigger();
        if (!actions().panel->isChecked())
            actions().panel->trigger();
        while (child<ui::kit::MessageBar>()->dismiss()) {
        }
        m_window->resize(ui::window::MainWindow::firstSize(m_window->screen()->availableSize()));
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
        m_window->view().setFocus();
        QVERIFY(isInRoom());
    }

    bool m_isSpoilt = false;
};

}  // namespace support
