// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"

namespace core::settings {

/// Whether too slender remains break off: a column or a fin left by a cut that is higher than `slenderness` times its
/// width.
struct BreakOff
{
    bool on = false;
    double slenderness = 6.0;  ///< height by width; no uncut cusp is close to it: a flank of 80 degrees is under 6
    bool operator==(const BreakOff&) const = default;
};

/// Checks the rule. OutOfRange if the slenderness is not from 3 to 100.
[[nodiscard]] Status check(const BreakOff& rule);

}  // namespace core::settings
