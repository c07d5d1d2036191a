// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/Sight.h"

#include <algorithm>
#include <cmath>

namespace core::session {
namespace {

/// First byte of a note that stores the visibility. Other notes begin with an ASCII letter.
constexpr std::uint64_t kTag = 0xE7ULL << 56U;
constexpr std::uint64_t kTagMask = 0xFFULL << 56U;

/// A number of the note, stored in one of 2^bits steps.
struct Field
{
    unsigned shift;
    unsigned bits;
    double from;
    double step;

    [[nodiscard]] std::uint64_t packed(double value) const
    {
        const auto most = static_cast<double>((1ULL << bits) - 1U);
        return static_cast<std::uint64_t>(std::clamp(std::round((value - from) / step), 0.0, most)) << shift;
    }
    [[nodiscard]] double of(std::uint64_t note) const
    {
        return from + step * static_cast<double>((note >> shift) & ((1ULL << bits) - 1U));
    }
};

constexpr Field kAzimuth{44, 12, -180.0, 0.1};
constexpr Field kElevation{33, 11, -90.0, 0.1};
constexpr Field kDistance{23, 10, 0.0, 0.2};
constexpr Field kX{15, 8, -12.7, 0.1};
constexpr Field kY{7, 8, -12.7, 0.1};
constexpr Field kZ{0, 7, -25.0, 0.25};

}  // namespace

std::uint64_t sightNote(const Sight& sight)
{
    return kTag | kAzimuth.packed(std::remainder(sight.azimuthDeg, 360.0)) | kElevation.packed(sight.elevationDeg) |
           kDistance.packed(sight.distanceMm) | kX.packed(sight.lookAtMm.x) | kY.packed(sight.lookAtMm.y) |
           kZ.packed(sight.lookAtMm.z);
}

std::optional<Sight> sightOf(std::uint64_t note)
{
    if ((note & kTagMask) != kTag)
        return std::nullopt;
    return Sight{kAzimuth.of(note), kElevation.of(note), kDistance.of(note), {kX.of(note), kY.of(note), kZ.of(note)}};
}

}  // namespace core::session
