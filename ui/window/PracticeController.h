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

/// Takes the newest state of servo and session, and updates what the practice room shows of it.
class PracticeController final : public QObject
{
    Q_OBJECT
public:
    /// @param links  must outlive the controller
    PracticeController(core::session::UiChannels& links, PracticeState& state, PracticeRoom& room,
                       tooth::ToothView& view, const practice::ViewMenu& viewMenu, BurControl& bur, ReplayView& replay,
                       ExerciseView& exercise, LessonController& lesson, AttemptNotes& notes);

    /// Another tooth is shown.
    void setTooth();
    /// Takes the state of the servo in a frame of the tooth view, and that of the session.
    void takeFrame(const core::servo::ServoState& servo);
    /// Takes the state of the session only, while the view draws nothing.
    void takeSession();
    /// Shows the states of other channels, also in the tooth view: those of a replay, or the own ones again.
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
    std::optional<core::imaging::PulpChamber> m_pulp;  ///< of the tooth that is shown
    QElapsedTimer m_sinceGuide;
    bool m_hasCut = false;  ///< in this window
};

}  // namespace ui::window
