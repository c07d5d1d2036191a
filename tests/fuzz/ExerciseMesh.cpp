// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/Exercises.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include "core/mesh/Holes.h"
#include "core/mesh/MeshAnalysis.h"
#include "core/mesh/MeshReader.h"
#include "core/mesh/Placement.h"
#include "core/mesh/Weld.h"
#include "core/terrain/Rasteriser.h"
#include "core/terrain/Rim.h"

namespace fuzz {
namespace {

void useMesh(core::mesh::TriangleMesh mesh)
{
    using namespace core;
    promise(!mesh.triangles.empty());
    for (const glm::vec3& v : mesh.vertices)
        promise(std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z));
    for (const auto& t : mesh.triangles)
        promise(*std::max_element(t.begin(), t.end()) < mesh.vertices.size());
    mesh::weldByPosition(mesh);
    mesh::MeshFacts facts = mesh::analyse(mesh);
    mesh::turnOutwards(mesh, facts);
    const auto placement = mesh::findPlacement(mesh, facts, {});
    if (!placement)
        return;
    mesh::moveToToothFrame(mesh, *placement);
    for (const mesh::Hole& hole : mesh::findHoles(mesh, facts))
        mesh::patch(mesh, hole);
    glm::dvec2 low(1.0e9);
    glm::dvec2 high(-1.0e9);
    for (const glm::vec3& v : mesh.vertices) {
        low = glm::min(low, glm::dvec2(v.x, v.y));
        high = glm::max(high, glm::dvec2(v.x, v.y));
    }
    if (std::max(high.x - low.x, high.y - low.y) < 0.2)
        return;
    const terrain::HeightMaps maps = terrain::rasterise(mesh, terrain::fitGrid(low, high, 64));
    promise(std::isfinite(terrain::volumeOf(maps)) && terrain::volumeOf(maps) >= 0.0);
    std::vector<float> sewn;
    terrain::sewRim(maps.grid, maps.top, maps.bottom, terrain::wholeOf(maps.grid), sewn);
}

}  // namespace

void exerciseMesh(std::string_view bytes)
{
    using core::mesh::MeshFormat;
    for (const MeshFormat format : {MeshFormat::Obj, MeshFormat::Stl, MeshFormat::Ply})
        if (auto file = core::mesh::readMesh(bytes, format, "input"))
            useMesh(std::move(file->mesh));
        else
            promise(!file.error().detail.empty());
}

}  // namespace fuzz
