// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <QElapsedTimer>

#include "core/settings/Handpiece.h"
#include "lessons/Lesson.h"
#include "ui/window/PracticeState.h"

namespace ui::kit {
class Actions;
}

namespace ui::window {

class CommandSender;

/// Switches the drill and changes bur and handpiece on request. Shows the state of the servo in the actions.
///
/// Stops the drill on other pages, when a rule is broken, in exercises in which nothing is cut, and at the end of an
/// exam. Starts it again, if it ran before, when the student may drill again.
class BurControl
{
public:
    BurControl(CommandSender& commands, kit::Actions& actions, const PracticeState& state)
        : m_commands(commands), m_actions(actions), m_state(state)
    {}

    /// Switches the drill for the user.
    void switchDrill(bool on);
    void chooseBur(int index);
    /// Requests another handpiece.
    /// @param shipped  index into core::settings::handpieces()
    void chooseHandpiece(int shipped);
    /// Selects the bur and the handpiece that an interrupted attempt used last.
    /// @param handpiece  index as in SetHandpiece
    void resume(std::optional<std::uint8_t> bur, std::optional<std::uint8_t> handpiece);
    /// Sets the handpieces of the next attempt, in the order of its settings.
    void setHandpieces(const std::vector<core::settings::Handpiece>& atHand);
    /// Forgets outstanding requests for drill and bur, because another hand drills from now on. show() then accepts any
    /// state of the servo.
    void forgetRequests();
    /// Checks the actions for drill, bur and handpiece as the servo reports them. Ignores a report that differs from a
    /// request for half a second after the request.
    void show(const core::servo::ServoState& servo);

    /// Stops the drill when another page is opened, and starts it again in the room.
    /// @param isBreachShown  whether the drill stays off until the user has answered to a breach
    void setInRoom(bool isInRoom, bool isBreachShown);
    /// Stops or starts the drill for the task of a new attempt.
    void beginTask(lessons::Task task);
    /// Stops the drill at a breach.
    /// @param isFirst  false if an earlier breach has stopped the drill and the user has not answered yet
    void stopForBreach(bool isFirst);
    /// Starts the drill again if a breach has stopped it.
    void continueAfterBreach();
    /// Stops the drill until the next attempt.
    void stopAtEnd();

private:
    /// A value that was requested, which the actions show until the servo confirms it or kAnswerMs have passed.
    struct Request
    {
        int value = 0;
        QElapsedTimer since;

        void begin(int wanted);
        [[nodiscard]] bool allows(int answer) const;
    };

    void setDrill(bool on);

    CommandSender& m_commands;
    kit::Actions& m_actions;
    const PracticeState& m_state;
    Request m_drill;
    Request m_bur;
    Request m_handpiece;
    std::vector<int> m_handpieces;    ///< of the attempt, as indices into core::settings::handpieces(); -1: another one
    bool m_wasOn = false;             ///< the drill ran when an exercise or the end of an exam stopped it
    bool m_stoppedForBreach = false;  ///< the drill ran when a breach stopped it
    bool m_pausedOnPage = false;      ///< the drill ran when another page was opened
};

}  // namespace ui::window
