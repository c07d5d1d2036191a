// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>

namespace lab {

/// The ways in which a bur is swept: a straight trench 3 mm long, a half circle of radius 1.2 mm, straight down.
enum class Sweep { Trench, Arc, Plunge };

/// "trench", "arc" or "plunge".
[[nodiscard]] std::string_view nameOf(Sweep sweep);

/// What a sweep took away beside what geometry says it takes (docs/facts/haptics.md, section 8.4, item 5).
struct SweepErrors
{
    double volumePercent;  ///< of the mean over the lies of the lattice, signed
    double worstPercent;   ///< of any single lie, absolute
    double depthRmsUm;     ///< of the columns' depths, over what geometry says is lowered
};

/// As deep as a trench that is felt, and deeper than the rounded end of every bur but the ball.
inline constexpr double kSweepDepthMm = 0.4;

/// Volume, mm3, that a sweep takes from a flat block: the depth of the underside over every point, integrated. What
/// begins and ends with half a body of revolution has its whole, the rest is its cross-section times the way of its
/// axis (Pappus).
[[nodiscard]] double sweptMm3(Sweep sweep, std::size_t bur, double depthMm);

/// Cross-section, mm2, of a straight trench.
[[nodiscard]] double sweptSectionMm2(std::size_t bur, double depthMm);

/// Sweeps a bur through a block of one material with removal that nothing limits and compares with closed form, over
/// kSweepLies lies of the lattice: shifts that fill the cell evenly, and headings; a quarter of them along the lattice.
/// @param side  columns a side, over 10.5 mm
/// @param bur   index into bur::burs()
[[nodiscard]] SweepErrors measureSweep(Sweep sweep, int side, std::size_t bur, double depthMm = kSweepDepthMm);

inline constexpr int kSweepLies = 32;

}  // namespace lab
