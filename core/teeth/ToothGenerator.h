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

/// Makes a whole tooth from the tables: mm, tooth frame (+z occlusal, +x from mesial to distal, right-handed; see
/// buccalSign() for y), origin at the centre of the crown's outline at the height of the tallest cusp.
///
/// Closed, manifold, oriented outwards, and the same for the same seed. Seed 0 is the mean tooth; any other draws its
/// sizes, cusps and grooves. Some tens of milliseconds. UnknownName for anything but 21-28 and 31-38.
[[nodiscard]] Result<mesh::TriangleMesh> generateTooth(int fdi, std::uint64_t seed);

/// What generateTooth() makes a premolar or molar from. As long as generateTooth() takes; UnknownName for other teeth.
[[nodiscard]] Result<PosteriorForm> posteriorForm(int fdi, std::uint64_t seed);

/// A tooth to look at, not to drill.
struct CoarseTooth
{
    mesh::TriangleMesh mesh;
    std::size_t crownVertices = 0;      ///< of the mesh, its first; the others are the root
    std::vector<std::uint32_t> cervix;  ///< vertices of the CEJ line, once round
};

/// The mean tooth of generateTooth() in fewer triangles: a few thousand, made in a few milliseconds, or as many as
/// `detail` asks for.
[[nodiscard]] Result<CoarseTooth> generateCoarseTooth(int fdi, const MeshDetail& detail = MeshDetail::coarse());

/// The sizes that this tooth has: the table's for seed 0, drawn from its spread (cut at two standard deviations) for
/// any other. The CEJ lies crownHeightMm below the highest point of the facial side.
[[nodiscard]] Result<ToothSizes> drawToothSizes(int fdi, std::uint64_t seed);

}  // namespace core::teeth
