// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QElapsedTimer>
#include <QObject>

#include "core/imaging/Section.h"
#include "core/servo/ServoState.h"
#include "core/session/SessionChannels.h"
#include "ui/window/PracticeState.h"

namespace ui::practice {
class ViewMenu;
}
namespace ui::tooth {
class ToothView;
}

namespace ui::window {

class AttemptNotes;
class BurControl;
class ExerciseView;
class LessonController;
class PracticeRoom;
class ReplayView;

/// Reads the newest state of servo and session, and updates the practice room.
class PracticeController final : public QObject
{
    Q_OBJECT
public:
    /// @param links  must outlive the controller
    PracticeController(core::session::UiChannels& links, PracticeState& state, PracticeRoom& room,
                       tooth::ToothView& view, const practice::ViewMenu& viewMenu, BurControl& bur, ReplayView& replay,
                       ExerciseView& exercise, LessonController& lesson, AttemptNotes& notes);

    /// Prepares for another tooth. Call it when PracticeState::tooth has changed.
    void setTooth();
    /// Handles a frame of the tooth view: shows the state of the servo in that frame, and the state of the session.
    void takeFrame(const core::servo::ServoState& servo);
    /// Shows the state of the session only. Call it while the view draws nothing.
    void takeSession();
    /// Shows the states of other channels, also in the tooth view: those of a replay, or again those of the student.
    /// @param channels  must outlive the controller
    void showChannels(core::session::UiChannels& channels);

signals:
    /// Emitted after each frame.
    void frameTaken(const core::servo::ServoState& servo);
    /// Emitted when actions need an update.
    void changed();

private:
    [[nodiscard]] core::imaging::DepthReading readDepth(const core::servo::ServoState& servo) const;
    void showGuide(const core::servo::ServoState& servo);
    void showHarm(const core::session::SessionState& now);

    core::session::UiChannels* m_channels;
    PracticeState& m_state;
    PracticeRoom& m_room;
    tooth::ToothView& m_view;
    const practice::ViewMenu& m_viewMenu;
    BurControl& m_bur;
    ReplayView& m_replay;
    ExerciseView& m_exercise;
    LessonController& m_lesson;
    AttemptNotes& m_notes;
    std::optional<core::imaging::PulpChamber> m_pulp;  ///< pulp chamber of the tooth that is shown
    QElapsedTimer m_sinceGuide;
    bool m_hasCut = false;  ///< the user has cut since the window was opened
};

}  // namespace ui::window
