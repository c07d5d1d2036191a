// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/settings/Handpiece.h"

#include <algorithm>
#include <array>

#include "core/settings/Within.h"

namespace core::settings {
double Handpiece::rpmUnder(double torqueNmm) const noexcept
{
    return freeRpm * std::max(0.0, 1.0 - torqueNmm / stallTorqueNmm);
}

std::span<const Handpiece> handpieces()
{
    static const std::array<Handpiece, 3> kShipped{{{}, {"electric", 200'000.0, 3.0}, {"low-speed", 20'000.0, 20.0}}};
    return kShipped;
}

Result<Handpiece> findHandpiece(std::string_view name)
{
    std::string known;
    for (const Handpiece& handpiece : handpieces()) {
        if (handpiece.name == name)
            return handpiece;
        known += (known.empty() ? "" : ", ") + handpiece.name;
    }
    return unexpected(ErrorCode::UnknownName, LocalizableText{"There is no handpiece '%1'; choose one of %2.",
                                                              {noted(std::string(name)), noted(std::move(known))}});
}

Status check(const Handpiece& handpiece)
{
    if (!within(handpiece.freeRpm, 100.0, 500'000.0))
        return unexpected(ErrorCode::OutOfRange,
                          "Handpiece '" + handpiece.name + "': the free speed must lie between 100 and 500,000 rpm.");
    if (!within(handpiece.stallTorqueNmm, 0.1, 100.0))
        return unexpected(ErrorCode::OutOfRange,
                          "Handpiece '" + handpiece.name + "': the stall torque must lie between 0.1 and 100 N mm.");
    return {};
}

}  // namespace core::settings
