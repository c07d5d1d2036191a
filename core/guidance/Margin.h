// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <glm/vec3.hpp>

#include "core/bur/Bur.h"
#include "core/grading/IdealCavity.h"

/// Guidance by the ideal during the work.
namespace core::guidance {

/// Largest distance that is reported, mm.
inline constexpr double kToldMm = 1.0;

/// Returns the distance from the head of a bur to what the ideal keeps, mm: the least distance from its columns to the
/// ideal's surface, downwards and sideways. Negative: depth in what is to be kept, which a turning bur would remove.
/// Empty if the distance is more than kToldMm. Some microseconds; any thread.
/// @param ideal  of this anatomy; not null
/// @param tip    of the bur, tooth frame, mm
[[nodiscard]] std::optional<double> marginMm(const terrain::ToothAnatomy& anatomy, const std::vector<float>& ideal,
                                             const bur::Bur& bur, const glm::dvec3& tip);

/// The progress of the work: sums over columns, mm3.
struct Progress
{
    double askedMm3 = 0.0;   ///< volume that the ideal removes
    double leftMm3 = 0.0;    ///< part of askedMm3 still there
    double beyondMm3 = 0.0;  ///< removed volume that the ideal keeps
};
/// Measures the progress.
/// @param top  the current top of the tooth, [side * side]
[[nodiscard]] Progress progressOf(const terrain::ToothAnatomy& anatomy, const std::vector<float>& ideal,
                                  const std::vector<float>& top);

}  // namespace core::guidance
