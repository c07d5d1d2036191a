// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include <QObject>
#include <QTimer>

#include "app/attempt/AttemptController.h"
#include "core/rt/TripleBuffer.h"
#include "haptics/simulated/IdealHand.h"

namespace app {

/// Moves the simulated force device: it does the current attempt by itself, and follows a replay that leads it. Works
/// while the user has chosen that device. Ui thread.
class SimulatedHand final : public QObject
{
    Q_OBJECT

public:
    /// All of them outlive this.
    struct Parts
    {
        core::session::UiChannels& channels;
        core::session::SessionLoop& session;
        DeviceController& devices;
        CurrentAttempt& attempt;
        AttemptController& attempts;
    };
    /// @param input  of the simulated device
    SimulatedHand(const Parts& parts, core::rt::TripleBuffer<core::servo::PointerInput>& input);

    /// Sets how to find out whether a replay leads the hand.
    void setLead(std::function<bool()> isLed) { m_isLed = std::move(isLed); }

private:
    void follow();
    void decide();

    core::session::UiChannels& m_channels;
    core::session::SessionLoop& m_session;
    DeviceController& m_devices;
    CurrentAttempt& m_attempt;
    core::rt::TripleBuffer<core::servo::PointerInput>& m_input;
    std::function<bool()> m_isLed = [] { return false; };
    QTimer m_timer;
    std::optional<haptics::IdealHand> m_hand;
    std::uint8_t m_bur = 0;  ///< that it holds
};

}  // namespace app
