// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/base/Result.h"

namespace core::settings {

/// The motor of the bur. Its torque falls linearly from stall to free speed (Dyson & Darvell 1999,
/// docs/facts/haptics.md, section 8.6), so that a load of T N mm leaves (1 - T / stall) of the speed. Default: the air
/// turbine.
struct Handpiece
{
    std::string name = "turbine";
    double freeRpm = 320'000.0;
    double stallTorqueNmm = 1.1;
    bool operator==(const Handpiece&) const = default;

    /// Returns the turns per minute under a load; 0 from the stall torque on.
    [[nodiscard]] double rpmUnder(double torqueNmm) const noexcept;
};

/// Returns the shipped handpieces (docs/facts/haptics.md, section 8.6; S read in a source, T textbook, A assumed):
/// turbine    320,000 rpm, 1.1 N mm [T]; 300,000 to 450,000 and up to 2.33 N mm measured [S]
/// electric   1:5, 200,000 rpm, 3 N mm [T]: holds its speed
/// low-speed  1:1, 20,000 rpm [T], 20 N mm [A]: for caries
[[nodiscard]] std::span<const Handpiece> handpieces();

/// Returns a handpiece by name. UnknownName lists the known names.
[[nodiscard]] Result<Handpiece> findHandpiece(std::string_view name);

/// Checks a handpiece. OutOfRange names the first value outside its limits: 100 to 500,000 rpm, 0.1 to 100 N mm.
[[nodiscard]] Status check(const Handpiece& handpiece);

}  // namespace core::settings
