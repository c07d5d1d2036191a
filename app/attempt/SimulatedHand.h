// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include <QObject>
#include <QTimer>

#include "app/attempt/AttemptContext.h"
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
    /// @param input  of the simulated device
    SimulatedHand(const AttemptContext& context, AttemptController& attempts,
                  core::rt::TripleBuffer<core::servo::PointerInput>& input);

    /// Sets a function that returns where a replay leads the hand, tooth frame, mm; it returns nothing if none does.
    void setLead(std::function<std::optional<glm::dvec3>()> leadMm) { m_leadMm = std::move(leadMm); }

private:
    void follow();
    void decide();

    AttemptContext m_context;
    core::rt::TripleBuffer<core::servo::PointerInput>& m_input;
    std::function<std::optional<glm::dvec3>()> m_leadMm;
    QTimer m_timer;
    std::optional<haptics::IdealHand> m_hand;
    std::uint8_t m_bur = 0;  ///< index of the bur that it holds
};

}  // namespace app
