// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include <QObject>

#include "core/grading/Exercise.h"
#include "core/servo/ServoState.h"
#include "ui/tooth/ExerciseMarks.h"
#include "ui/window/PracticeState.h"

namespace ui::kit {
class Actions;
}
namespace ui::practice {
class ExerciseCard;
}
namespace ui::tooth {
class ToothView;
}

namespace ui::window {

class CommandSender;
class PracticeRoom;
class ReplayView;

/// Shows the exercise of a lesson in the practice room: its card, and marks on the tooth.
class ExerciseView final : public QObject
{
    Q_OBJECT
public:
    ExerciseView(const PracticeState& state, PracticeRoom& room, kit::Actions& actions, tooth::ToothView& view,
                 const ReplayView& replay, CommandSender& commands);

    /// Shows or hides the card for the tooth that is shown.
    void begin();
    [[nodiscard]] bool isShown() const;
    void setServo(const core::servo::ServoState& servo);
    void setPractised(const core::grading::Practised& practised);
    /// Shows the right answers. Call it when the exercise has a grade.
    void conclude();
    /// Marks on the tooth the points to touch, the pads to name, and the places that the step of the lesson mentions.
    void mark();
    /// Shows the undo history if it is open and allowed.
    void showHistory();
    /// Returns whether the student must identify the tissues of the shown tooth by feel. If so, the tissues are neither
    /// coloured nor named.
    [[nodiscard]] bool isBlindfolded() const;

signals:
    /// Emitted when actions and overlays need an update.
    void changed();

private:
    [[nodiscard]] tooth::ExerciseMarks marksOfPads() const;

    const PracticeState& m_state;
    PracticeRoom& m_room;
    kit::Actions& m_actions;
    tooth::ToothView& m_view;
    const ReplayView& m_replay;
    practice::ExerciseCard* m_card;
    std::uint64_t m_generation = 0;  ///< generation of the tooth for which the card is shown
    std::optional<core::grading::Touched> m_touched;
};

}  // namespace ui::window
