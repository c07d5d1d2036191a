// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"

namespace core::settings {

/// Whether what no tooth could keep breaks off: a column or a fin that a cut has left standing, higher than
/// `slenderness` times its width.
struct BreakOff
{
    bool on = false;
    double slenderness = 6.0;  ///< height by width; no uncut cusp comes near: a flank of 80 degrees is under 6
    bool operator==(const BreakOff&) const = default;
};

/// OutOfRange if the slenderness does not lie between 3 and 100.
[[nodiscard]] Status check(const BreakOff& rule);

}  // namespace core::settings
