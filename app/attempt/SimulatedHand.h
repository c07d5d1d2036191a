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

    /// Sets how to find out where a replay leads the hand to, tooth frame, mm; empty: it does not.
    void setLead(std::function<std::optional<glm::dvec3>()> leadMm) { m_leadMm = std::move(leadMm); }

private:
    void follow();
    void decide();

    core::session::UiChannels& m_channels;
    core::session::SessionLoop& m_session;
    DeviceController& m_devices;
    CurrentAttempt& m_attempt;
    core::rt::TripleBuffer<core::servo::PointerInput>& m_input;
    std::function<std::optional<glm::dvec3>()> m_leadMm;
    QTimer m_timer;
    std::optional<haptics::IdealHand> m_hand;
    std::uint8_t m_bur = 0;  ///< that it holds
};

}  // namespace app
