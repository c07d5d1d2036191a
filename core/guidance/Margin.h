// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <glm/vec3.hpp>

#include "core/bur/Bur.h"
#include "core/grading/IdealCavity.h"

/// What is told about the ideal while the student works.
namespace core::guidance {

/// Nearer than this the margin is told, mm.
inline constexpr double kToldMm = 1.0;

/// How far the head of a bur is from what the ideal keeps, mm: the least distance from its columns to the ideal's
/// surface, downwards and sideways. Negative: it stands so deep in what is to be kept, and took it if it turned.
/// Nothing where it is farther than kToldMm from all of it. Some microseconds; any thread.
/// @param ideal  of this anatomy; not null
/// @param tip    of the bur, tooth frame, mm
[[nodiscard]] std::optional<double> marginMm(const terrain::ToothAnatomy& anatomy, const std::vector<float>& ideal,
                                             const bur::Bur& bur, const glm::dvec3& tip);

/// How far the work has come: sums over columns, mm3.
struct Progress
{
    double askedMm3 = 0.0;   ///< what the ideal takes away
    double leftMm3 = 0.0;    ///< of it, still there
    double beyondMm3 = 0.0;  ///< taken away that the ideal keeps
};
/// @param top  the tooth's top now, [side * side]
[[nodiscard]] Progress progressOf(const terrain::ToothAnatomy& anatomy, const std::vector<float>& ideal,
                                  const std::vector<float>& top);

}  // namespace core::guidance
