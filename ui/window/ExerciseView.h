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

/// The exercise of a lesson in the practice room: its card, and marks on the tooth.
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
    /// The exercise has a grade: shows the right answers.
    void conclude();
    /// Marks the tooth: points to touch, pads to name, and places that the step of the lesson names.
    void mark();
    /// Shows the undo history if it is open and allowed.
    void showHistory();
    /// Returns whether the tissues of the tooth that is shown must be told by feel: they are not coloured or named.
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
    std::uint64_t m_generation = 0;  ///< of the tooth that the card is about
    std::optional<core::grading::Touched> m_touched;
};

}  // namespace ui::window
