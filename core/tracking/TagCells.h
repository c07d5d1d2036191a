// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace core::tracking {

/// Number of cells per side of a tag with its white border, as printed: row by row from the upper left, true for white.
inline constexpr int kCellsASide = 10;
/// Number of cells of the edge that is the tag's size: the black square without the white border.
inline constexpr int kEdgeCells = 8;
using TagCells = std::array<bool, kCellsASide * kCellsASide>;

/// Returns the cells of a tag of the family 36h11.
/// @param id  0 .. kTagCount - 1
/// All are white in a program that is built without AprilTag.
[[nodiscard]] TagCells cellsOf(int id);

}  // namespace core::tracking
