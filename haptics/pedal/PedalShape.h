// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/settings/PedalSettings.h"

namespace haptics {

/// Converts the readings of a pedal into the speed of the bur. Pure; create one each time a pedal is plugged in.
///
/// A pedal counts as released until it has been read at rest. So the bur does not start if the pedal is pressed, or its
/// axis is stuck, when the program starts. The bur starts when the pedal has been beyond the dead zone plus a margin
/// for kStartsAfterS, so that noise does not start it. It stops at once.
class PedalShape
{
public:
    static constexpr double kStartsAfterS = 0.02;
    static constexpr double kStartMargin = 0.02;  ///< share of the travel
    static constexpr double kStepPercent = 1.0;   ///< smaller changes of the speed are noise

    explicit PedalShape(const core::settings::PedalSettings& settings) noexcept : m_settings(settings) {}

    /// Processes the next reading and returns the speed of the bur in per cent; 0: stopped.
    /// @param reading  of the axis, -1 to 1; one that is not finite counts as a released pedal
    /// @param seconds  since the last call
    int update(double reading, double seconds) noexcept;
    /// Returns whether the pedal has been read at rest.
    [[nodiscard]] bool hasRested() const noexcept { return m_hasRested; }

private:
    core::settings::PedalSettings m_settings;
    bool m_hasRested = false;
    double m_beyondS = 0.0;  ///< time beyond the dead zone
    int m_percent = 0;
};

}  // namespace haptics
