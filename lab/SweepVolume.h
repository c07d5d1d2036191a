// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>

namespace lab {

/// Sweeps of a bur: a straight trench 3 mm long, a half circle of radius 1.2 mm, straight down.
enum class Sweep { Trench, Arc, Plunge };

/// Returns "trench", "arc" or "plunge".
[[nodiscard]] std::string_view nameOf(Sweep sweep);

/// The removal of a sweep compared with exact geometry (docs/facts/haptics.md, section 8.4, item 5).
struct SweepErrors
{
    double volumePercent;  ///< of the mean over the positions of the lattice, signed
    double worstPercent;   ///< of any single position, absolute
    double depthRmsUm;     ///< of the columns' depths, over the area that is lowered exactly
};

/// Depth of the sweeps, mm: that of a trench that can be felt, and deeper than the rounded end of every bur but the
/// ball.
inline constexpr double kSweepDepthMm = 0.4;

/// Returns the volume that a sweep removes from a flat block, mm3: the depth of the underside over every point,
/// integrated. The ends of a path are half bodies of revolution, which make a whole one; the rest is its cross-section
/// times the path of its axis (Pappus).
[[nodiscard]] double sweptMm3(Sweep sweep, std::size_t bur, double depthMm);

/// Returns the cross-section of a straight trench, mm2.
[[nodiscard]] double sweptSectionMm2(std::size_t bur, double depthMm);

/// Sweeps a bur through a block of one material with unlimited removal and compares the result with closed form, over
/// kSweepLies positions of the lattice: shifts that fill the cell evenly, and headings; a quarter of them along the
/// lattice.
/// @param side  columns per side, over 10.5 mm
/// @param bur   index into bur::burs()
[[nodiscard]] SweepErrors measureSweep(Sweep sweep, int side, std::size_t bur, double depthMm = kSweepDepthMm);

inline constexpr int kSweepLies = 32;

}  // namespace lab
