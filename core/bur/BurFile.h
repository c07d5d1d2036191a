// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "core/base/Result.h"
#include "core/bur/Bur.h"

namespace core::bur {

inline constexpr double kWidestHeadMm = 1.5;       ///< largest radius of a head in a file
inline constexpr double kThinnestHeadMm = 0.2;     ///< smallest radius: every tooth has columns below it
inline constexpr double kSharpestCornerMm = 0.02;  ///< smallest radius of a rim in a file

/// Reads burs from text, line by line:
///
///     bur 171                          id of the bur: up to 24 characters without blanks
///     shape tapered                    one of shapeWord()
///     material carbide                 or "diamond" and the grit's number in ISO 6360: diamond 524
///     iso6360 500 314 168 006 012      may be left out
///     neck 0.5                         radius just above the head
///     flat 0.308446                    the end: a flat disc to this radius; left out if the end is round
///     arc 0.408351 0.095638 0.1        to this radius and height, with this radius of its own
///     line 0.6 4.4                     to this radius and height
///     end
///
/// Radii are from the axis and heights from the tip, mm. `flat`, `arc` and `line` are the profile, from the tip to the
/// neck. It begins with the flat disc, if there is one, and an arc tangent to it, which ends upright or goes on,
/// tangent, as a line to the largest radius. From there lines, and arcs that begin upright, lead up to the neck. "#"
/// begins a comment.
///
/// An error is one sentence with the number of the line: WrongKind for what is not text, FileTruncated without "end",
/// BadNumber, BadStructure or OutOfRange.
[[nodiscard]] Result<std::vector<Bur>> parseBurs(std::string_view text);

/// The one bur of a user's file, which has at most 64 KiB.
[[nodiscard]] Result<Bur> readBur(const std::filesystem::path& path);

}  // namespace core::bur
