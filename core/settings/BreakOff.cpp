// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/settings/BreakOff.h"

namespace core::settings {

Status check(const BreakOff& rule)
{
    if (!(rule.slenderness >= 3.0 && rule.slenderness <= 100.0))
        return unexpected(ErrorCode::OutOfRange, "What breaks off must be 3 to 100 times as high as it is wide.");
    return {};
}

}  // namespace core::settings
