// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/Result.h"
#include "core/mesh/TriangleMesh.h"
#include "core/teeth/MeshBuilder.h"
#include "core/teeth/PosteriorForm.h"
#include "core/teeth/ToothTable.h"

namespace core::teeth {

/// Generates a whole tooth from the tables: mm, tooth frame (+z occlusal, +x from mesial to distal, right-handed; see
/// buccalSign() for y), origin at the centre of the crown's outline at the height of the tallest cusp.
///
/// Closed, manifold, oriented outwards, and the same for the same seed. Seed 0 is the mean tooth; any other varies its
/// sizes, cusps and grooves. Some tens of milliseconds. UnknownName for numbers other than 21-28 and 31-38.
[[nodiscard]] Result<mesh::TriangleMesh> generateTooth(int fdi, std::uint64_t seed);

/// Returns the construction of a premolar or molar by generateTooth(). Takes as long; UnknownName for other teeth.
[[nodiscard]] Result<PosteriorForm> posteriorForm(int fdi, std::uint64_t seed);

/// A tooth for viewing, not for drilling.
struct CoarseTooth
{
    mesh::TriangleMesh mesh;
    std::size_t crownVertices = 0;      ///< number of the mesh's first vertices that form the crown; the others form
                                        ///< the root
    std::vector<std::uint32_t> cervix;  ///< vertices around the CEJ line
};

/// Returns the mean tooth of generateTooth() with fewer triangles: a few thousand, in a few milliseconds, or as many as
/// `detail` requests.
[[nodiscard]] Result<CoarseTooth> generateCoarseTooth(int fdi, const MeshDetail& detail = MeshDetail::coarse());

/// Returns the sizes of this tooth: those of the table for seed 0, otherwise drawn from its distribution (truncated at
/// two standard deviations). The CEJ is crownHeightMm below the highest point of the facial side.
[[nodiscard]] Result<ToothSizes> drawToothSizes(int fdi, std::uint64_t seed);

}  // namespace core::teeth
