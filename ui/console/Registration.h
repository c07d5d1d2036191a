// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>

#include <QAction>

#include "core/servo/ServoState.h"
#include "core/settings/FeelPreset.h"
#include "core/settings/Parameters.h"

namespace ui::tooth {
class PointerControl;
}

/// What the window has for the console and the page of settings. Ui thread.
namespace ui::console {

/// The times between the servo's ticks, as the poses in its state tell them: a second of them.
class PeriodMeter
{
public:
    /// The newest state; call it often, each holds the last 16 ticks only.
    void take(const core::servo::ServoState& state);
    /// The time that a share of the periods stays under, µs; NaN before there are any.
    [[nodiscard]] double percentileUs(double share) const;

private:
    static constexpr std::size_t kPeriods = 1000;
    std::array<std::int32_t, kPeriods> m_periodsNs{};  ///< ring
    std::size_t m_next = 0;
    std::size_t m_count = 0;
    std::int64_t m_newestNs = 0;
};

/// Every number of a hardness preset: "hardness.enamel.rate", "force.stiffness".
/// While what is felt is presets::veiled(), none of them can be read or set.
/// @param now      what is felt now
/// @param initial  what is to be felt if nothing is turned
/// @param feel     sets it; answers why not, or nothing
void registerFeel(core::settings::Parameters& parameters, const std::function<core::settings::FeelPreset()>& now,
                  const std::function<core::settings::FeelPreset()>& initial,
                  const std::function<std::string(const core::settings::FeelPreset&)>& feel);

/// A checkable action as a switch.
/// @param action     must outlive the registry
/// @param initially  whether it is on where nobody has touched it
void registerSwitch(core::settings::Parameters& parameters, const char* name, QAction* action, bool initially = false);

/// "hand.feed": how fast the bur goes down at most while the mouse button is pressed. "hand.push": how hard it presses.
/// @param hand  must outlive the parameters
void registerHand(core::settings::Parameters& parameters, const tooth::PointerControl& hand,
                  const std::function<void(double mmPerS)>& setFeed,
                  const std::function<void(double newtons)>& setPush);

/// What may be told of the bur's work, as in the panel beside the tooth.
struct Told
{
    bool depth = true;
    bool removed = true;
};

/// "live.force", "live.depth" and so on.
/// @param meter  must outlive the registry
/// @param told   here and now
void registerLive(core::settings::Parameters& parameters, const std::function<core::servo::ServoState()>& servo,
                  const PeriodMeter& meter, const std::function<Told()>& told);

}  // namespace ui::console
