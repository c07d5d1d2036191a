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

/// Switches the drill, and changes bur and handpiece, on request; shows in the actions what the servo answers.
///
/// The drill runs only while it is watched: it stops on other pages, at a breach of a rule, in exercises in which
/// nothing is cut, and at the end of an exam. Where the student may drill again, it runs as before.
class BurControl
{
public:
    BurControl(CommandSender& commands, kit::Actions& actions, const PracticeState& state)
        : m_commands(commands), m_actions(actions), m_state(state)
    {}

    /// The user switches the drill.
    void switchDrill(bool on);
    void chooseBur(int index);
    /// @param shipped  index into core::settings::handpieces()
    void chooseHandpiece(int shipped);
    /// Takes the bur and the handpiece with which an attempt was interrupted.
    /// @param handpiece  index as in SetHandpiece
    void resume(std::optional<std::uint8_t> bur, std::optional<std::uint8_t> handpiece);
    /// Sets the handpieces of the next attempt, in the order of its settings.
    void setHandpieces(const std::vector<core::settings::Handpiece>& atHand);
    /// Ignores outstanding answers: another hand drills from now on.
    void forgetRequests();
    /// Checks the actions of what is in use. An answer that contradicts a request is ignored for half a second.
    void show(const core::servo::ServoState& servo);

    /// Stops the drill when another page is opened, and starts it again in the room.
    /// @param isBreachShown  the drill waits for the user's answer to a breach
    void setInRoom(bool isInRoom, bool isBreachShown);
    /// Stops or starts the drill as a new attempt needs it.
    void beginTask(lessons::Task task);
    /// Stops the drill at a breach.
    /// @param isFirst  no earlier breach waits for its answer
    void stopForBreach(bool isFirst);
    /// Starts the drill again if a breach has stopped it.
    void continueAfterBreach();
    /// Stops the drill until the next attempt.
    void stopAtEnd();

private:
    /// A request that is believed until the servo answers, or until it has had time to.
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
    std::vector<int> m_handpieces;    ///< at hand, as indices into core::settings::handpieces(); -1: not one of those
    bool m_wasOn = false;             ///< before an exercise or the end of an exam stopped the drill
    bool m_stoppedForBreach = false;  ///< the drill ran when a breach stopped it
    bool m_pausedOnPage = false;      ///< the drill ran when another page was opened
};

}  // namespace ui::window
