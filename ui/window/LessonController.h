// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <QObject>

#include "lessons/Assignment.h"
#include "ui/window/ExamClock.h"
#include "ui/window/PracticeState.h"

namespace ui::catalog {
class LessonsPage;
}
namespace ui::kit {
class Actions;
class MessageBar;
}  // namespace ui::kit
namespace ui::practice {
class ViewMenu;
}

namespace ui::window {

class BurControl;
class CommandSender;
class ExerciseView;
class Navigation;
class PracticeRoom;
class UnsavedWork;

/// Manages the student's attempt at a lesson: begins it, sets the allowed aids, runs its clock, and ends an exam.
class LessonController final : public QObject
{
    Q_OBJECT
public:
    LessonController(PracticeState& state, PracticeRoom& room, kit::Actions& actions, practice::ViewMenu& viewMenu,
                     kit::MessageBar& messages, catalog::LessonsPage& lessons, const Navigation& navigation,
                     BurControl& bur, ExerciseView& exercise);

    /// Begins an attempt. The caller shows its tooth afterwards.
    void begin(const lessons::Assignment& assignment);
    /// Sets the times of the attempt before it was interrupted. Call it after begin().
    void resumeClock(double recordedS, double workedS) { m_clock.resume(recordedS, workedS); }
    /// Locks the aids that are not allowed.
    void setAids(const lessons::Aids& aids);
    /// Shows the ideal in section and colours, if the lesson allows that.
    void showIdeal();
    /// Sets whether the student has no attempt left.
    void setUsedUp(bool usedUp);
    /// Updates time and steps of the lesson.
    void follow();
    /// Ends an exam: its time is over or it has a score. Cutting is disabled. Does nothing in practice.
    void endExam();
    /// Ends an exam that does not count, because another attempt was begun elsewhere.
    void refuseExam();
    /// Begins the lesson again. After a grade, in an exercise and in an exam, that is another attempt. Otherwise the
    /// tooth is reset, which can be undone. If an exam has ended without a grade, shows a message instead.
    void startAgain(CommandSender& commands, UnsavedWork& unsaved);
    void showBegunAgain();

signals:
    /// Emitted when the time of an exam is over.
    void gradeRequested();
    void attemptAgainRequested();
    /// Emitted when the lesson does not allow the radiograph.
    void radiographLocked();
    /// Emitted when the practice room must be opened.
    void roomRequested();
    /// Emitted when actions and overlays need an update.
    void changed();

private:
    void endTime();
    void endAtLimit();
    void say(const QString& sentence);

    PracticeState& m_state;
    PracticeRoom& m_room;
    kit::Actions& m_actions;
    practice::ViewMenu& m_viewMenu;
    kit::MessageBar& m_messages;
    catalog::LessonsPage& m_lessons;
    const Navigation& m_navigation;
    BurControl& m_bur;
    ExerciseView& m_exercise;
    ExamClock m_clock;
};

}  // namespace ui::window
