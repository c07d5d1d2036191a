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

/// Registers the window's parameters for the console and the settings page. Ui thread.
namespace ui::console {

/// Measures the times between ticks of the servo over the last second, from the poses in its state.
class PeriodMeter
{
public:
    /// Adds the newest state. Call often: each state holds the last 16 ticks only.
    void take(const core::servo::ServoState& state);
    /// Returns the percentile of the periods for a share of 0 to 1, µs; NaN if there are none.
    [[nodiscard]] double percentileUs(double share) const;

private:
    static constexpr std::size_t kPeriods = 1000;
    std::array<std::int32_t, kPeriods> m_periodsNs{};  ///< ring
    std::size_t m_next = 0;
    std::size_t m_count = 0;
    std::int64_t m_newestNs = 0;
};

/// Registers every number of a hardness preset: "hardness.enamel.rate", "force.stiffness". While the current preset is
/// presets::veiled(), none of them can be read or set.
/// @param now      returns the current preset
/// @param initial  returns the preset before any manual change
/// @param feel     applies a preset; returns an empty string, or why it was refused
void registerFeel(core::settings::Parameters& parameters, const std::function<core::settings::FeelPreset()>& now,
                  const std::function<core::settings::FeelPreset()>& initial,
                  const std::function<std::string(const core::settings::FeelPreset&)>& feel);

/// Registers a checkable action as a switch.
/// @param action     must outlive the registry
/// @param initially  the default
void registerSwitch(core::settings::Parameters& parameters, const char* name, QAction* action, bool initially = false);

/// Registers "hand.feed", the highest speed at which the bur is lowered while the mouse button is pressed, and
/// "hand.push", the force.
/// @param hand  must outlive the parameters
void registerHand(core::settings::Parameters& parameters, const tooth::PointerControl& hand,
                  const std::function<void(double mmPerS)>& setFeed,
                  const std::function<void(double newtons)>& setPush);

/// Which live values may be shown, as in the panel beside the tooth.
struct Told
{
    bool depth = true;
    bool removed = true;
};

/// Registers "live.force", "live.depth" and so on.
/// @param meter  must outlive the registry
/// @param told   returns what may be shown now
void registerLive(core::settings::Parameters& parameters, const std::function<core::servo::ServoState()>& servo,
                  const PeriodMeter& meter, const std::function<Told()>& told);

}  // namespace ui::console
