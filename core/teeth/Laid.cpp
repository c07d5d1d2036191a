// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/teeth/Laid.h"

#include <algorithm>
#include <array>

#include "core/base/NumberField.h"
#include "core/teeth/ToothTable.h"

namespace core::teeth {
namespace {

using terrain::Lying;
using terrain::ToothSide;

/// In the order of terrain::ToothSide, for a tooth with +y buccal.
constexpr std::array<std::string_view, terrain::kToothSideCount> kOfTheMouth{"occlusal", "mesial", "distal", "lingual",
                                                                             "buccal"};
constexpr std::array<std::string_view, terrain::kToothSideCount> kOfTheFrame{"occlusal", "-x", "+x", "-y", "+y"};

ToothSide acrossTheArch(ToothSide side)
{
    return side == ToothSide::MinusY ? ToothSide::PlusY : side == ToothSide::PlusY ? ToothSide::MinusY : side;
}

}  // namespace

Result<Lying> findLying(std::string_view name, double tiltDeg, int fdi)
{
    const auto& names = fdi != 0 ? kOfTheMouth : kOfTheFrame;
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end())
        return unexpected(
            ErrorCode::UnknownName,
            LocalizableText{fdi != 0 ? "\"%1\" is no side of a tooth; write occlusal, mesial, distal, buccal or lingual"
                                     : "\"%1\" is no side of a scan; write occlusal, -x, +x, -y or +y",
                            {noted(std::string(name.substr(0, 40)))}});
    auto side = static_cast<ToothSide>(found - names.begin());
    if (side == ToothSide::Occlusal)
        return Lying{};
    if (fdi != 0 && buccalSign(fdi) < 0.0)
        side = acrossTheArch(side);
    const Lying lying{side, tiltDeg};
    if (!lying.isSound())
        return unexpected(ErrorCode::OutOfRange,
                          LocalizableText{"a tooth is tilted by %1 to %2 degrees, not by %3",
                                          {noted(plainNumber(Lying::kLeastTiltDeg)),
                                           noted(plainNumber(Lying::kMostTiltDeg)), noted(plainNumber(tiltDeg))}});
    return lying;
}

std::string_view nameOf(const Lying& lying, int fdi)
{
    const ToothSide side = fdi != 0 && buccalSign(fdi) < 0.0 ? acrossTheArch(lying.up) : lying.up;
    return (fdi != 0 ? kOfTheMouth : kOfTheFrame).at(static_cast<std::size_t>(side));
}

}  // namespace core::teeth
