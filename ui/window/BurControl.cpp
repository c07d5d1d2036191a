// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/BurControl.h"

#include <algorithm>
#include <utility>

#include <QAction>

#include "ui/kit/Actions.h"
#include "ui/window/CommandSender.h"

namespace ui::window {
namespace {

constexpr qint64 kAnswerMs = 500;

}  // namespace

void BurControl::Request::begin(int wanted)
{
    value = wanted;
    since.start();
}

bool BurControl::Request::allows(int answer) const
{
    return answer == value || !since.isValid() || since.elapsed() > kAnswerMs;
}

void BurControl::switchDrill(bool on)
{
    m_stoppedForBreach = false;
    setDrill(on);
}

void BurControl::setDrill(bool on)
{
    if (m_commands.send(core::servo::SetDrill{on}))
        m_drill.begin(on ? 1 : 0);
    else
        m_actions.drill->setChecked(!on);
}

void BurControl::chooseBur(int index)
{
    if (m_commands.send(core::servo::SetBur{static_cast<std::uint8_t>(index)}))
        m_bur.begin(index);
}

void BurControl::chooseHandpiece(int shipped)
{
    const auto found = std::find(m_handpieces.begin(), m_handpieces.end(), shipped);
    const auto index = static_cast<std::uint8_t>(found - m_handpieces.begin());
    if (found != m_handpieces.end() && m_commands.send(core::servo::SetHandpiece{index}))
        m_handpiece.begin(index);
}

void BurControl::resume(std::optional<std::uint8_t> bur, std::optional<std::uint8_t> handpiece)
{
    if (bur)
        chooseBur(*bur);
    if (handpiece && *handpiece < m_handpieces.size() && m_handpieces[*handpiece] >= 0)
        chooseHandpiece(m_handpieces[*handpiece]);
}

void BurControl::setHandpieces(const std::vector<core::settings::Handpiece>& atHand)
{
    const auto shipped = core::settings::handpieces();
    m_handpieces.clear();
    for (const core::settings::Handpiece& handpiece : atHand) {
        const auto found = std::find(shipped.begin(), shipped.end(), handpiece);
        m_handpieces.push_back(found == shipped.end() ? -1 : static_cast<int>(found - shipped.begin()));
    }
    for (int k = 0; k < m_actions.handpieces.size(); ++k)
        m_actions.handpieces[k]->setVisible(std::find(m_handpieces.begin(), m_handpieces.end(), k) !=
                                            m_handpieces.end());
    m_handpiece = {};
}

void BurControl::forgetRequests()
{
    m_drill = {};
    m_bur = {};
}

void BurControl::show(const core::servo::ServoState& servo)
{
    if (servo.tick == 0)  // the servo has not answered yet
        return;
    const bool isOn = servo.drillSwitchedOn || servo.drillOn;
    if (m_drill.allows(isOn ? 1 : 0) && m_actions.drill->isChecked() != isOn)
        m_actions.drill->setChecked(isOn);
    if (servo.burIndex < m_actions.burs.size() && m_bur.allows(servo.burIndex))
        m_actions.burs[servo.burIndex]->setChecked(true);
    if (servo.handpieceIndex < m_handpieces.size() && m_handpiece.allows(servo.handpieceIndex))
        if (const int shipped = m_handpieces[servo.handpieceIndex]; shipped >= 0)
            m_actions.handpieces[shipped]->setChecked(true);
}

void BurControl::setInRoom(bool isInRoom, bool isBreachShown)
{
    if (!isInRoom && m_actions.drill->isChecked() && m_state.tooth != nullptr && !m_state.isReplaying) {
        m_pausedOnPage = true;
        setDrill(false);
    } else if (isInRoom && std::exchange(m_pausedOnPage, false) && !m_state.isOver) {
        if (isBreachShown)
            m_stoppedForBreach = true;
        else
            setDrill(true);
    }
}

void BurControl::beginTask(lessons::Task task)
{
    const bool cutsNothing = task == lessons::Task::TouchPoints || task == lessons::Task::HoldForce;
    m_wasOn = std::exchange(m_stoppedForBreach, false) || m_wasOn;
    if (cutsNothing) {
        m_wasOn = m_wasOn || m_pausedOnPage || m_actions.drill->isChecked();
        setDrill(false);
    } else if (task == lessons::Task::TellLayers || m_wasOn || m_pausedOnPage) {
        m_wasOn = false;
        setDrill(true);
    }
    m_pausedOnPage = false;
}

void BurControl::stopForBreach(bool isFirst)
{
    if (isFirst)
        m_stoppedForBreach = m_actions.drill->isChecked();
    setDrill(false);
}

void BurControl::continueAfterBreach()
{
    if (std::exchange(m_stoppedForBreach, false))
        setDrill(true);
}

void BurControl::stopAtEnd()
{
    m_wasOn = m_wasOn || m_pausedOnPage || m_actions.drill->isChecked();
    m_pausedOnPage = false;
    setDrill(false);
}

}  // namespace ui::window
