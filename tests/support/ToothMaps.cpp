// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/ToothMaps.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/mesh/MeshReader.h"
#include "core/teeth/ToothGenerator.h"
#include "core/terrain/Rasteriser.h"
#include "core/terrain/Tooth.h"
#include "tests/support/SyntheticTooth.h"
#include "tests/support/Trials.h"

namespace support {
namespace {

using core::terrain::kEmptyBottom;
using core::terrain::kEmptyTop;

core::terrain::Grid gridOver(int side, double left, double right, double front, double back)
{
    core::terrain::Grid grid;
    grid.side = side;
    grid.cellMm = std::max(right - left, back - front) / (side - 7);
    const double half = 0.5 * grid.cellMm * (side - 1);
    grid.originMm = {0.5 * (left + right) - half, 0.5 * (front + back) - half};
    return grid;
}

/// Moves the highest point of the crown to z = 0 and the middle of the outline to x = y = 0.
ToothMaps mapsOf(core::mesh::TriangleMesh mesh, int side)
{
    glm::vec3 low = mesh.vertices.front();
    glm::vec3 high = mesh.vertices.front();
    for (const glm::vec3& v : mesh.vertices) {
        low = glm::min(low, v);
        high = glm::max(high, v);
    }
    const glm::vec3 half = 0.5F * (high - low);
    for (glm::vec3& v : mesh.vertices)
        v -= glm::vec3(low.x + half.x, low.y + half.y, high.z);
    core::terrain::HeightMaps maps = core::terrain::rasterise(mesh, gridOver(side, -half.x, half.x, -half.y, half.y));
    return {maps.grid, std::move(maps.top), std::move(maps.bottom)};
}

}  // namespace

std::string sharedData(const std::string& file)
{
    const char* folder = std::getenv("CUSP_SHARED_DATA");
    const std::filesystem::path root =
        folder != nullptr ? std::filesystem::path(folder) : std::filesystem::path(CUSP_SOURCE_DIR) / "../shared/data";
    const std::filesystem::path path = root / file;
    std::error_code absent;
    return std::filesystem::exists(path, absent) ? path.string() : std::string();
}

std::optional<ToothMaps> scanMaps(int fdi, int side)
{
    const std::string path = sharedData("teeth/dundee_" + std::to_string(fdi) + ".obj");
    if (path.empty())
        return std::nullopt;
    core::mesh::TriangleMesh mesh = core::mesh::readMesh(std::filesystem::path(path)).value().mesh;
    // The scans are in the pose of one arch: +y up, +z anterior, +x the patient's left; upper teeth crown down.
    constexpr float kMmPerUnit = 10.5F;
    for (glm::vec3& v : mesh.vertices)
        v = kMmPerUnit * (fdi == 36   ? glm::vec3(-v.z, -v.x, v.y)
                          : fdi == 24 ? glm::vec3(-v.z, v.x, -v.y)
                                      : glm::vec3(v.x, v.z, -v.y));
    return mapsOf(std::move(mesh), side);
}

ToothMaps generatedMaps(int fdi, std::uint64_t seed, int side)
{
    return mapsOf(core::teeth::generateTooth(fdi, seed).value(), side);
}

ToothMaps analyticMolar(int side)
{
    ToothMaps maps;
    maps.grid = gridOver(side, -5.0, 5.0, -5.0, 5.0);
    maps.top.assign(maps.grid.count(), kEmptyTop);
    maps.bottom.assign(maps.grid.count(), kEmptyBottom);
    eachNode(maps.grid, [&](std::size_t k, glm::dvec2 at) {
        const double r = glm::length(at);
        if (r >= 5.0)
            return;
        // Four cusps of spherical caps at (+-2.5, +-2.5) over a fossa at -2.5.
        const double cx = std::abs(at.x) - 2.5;
        const double cy = std::abs(at.y) - 2.5;
        double top = std::max(-2.5, -0.55 * (cx * cx + cy * cy));
        if (r > 4.0)
            top = std::min(top, -5.0 + 4.0 * std::sqrt(std::max(0.0, 1.0 - (r - 4.0) * (r - 4.0))));
        if (std::abs(at.y) < 0.15 && r < 3.0)
            top -= 0.8 * (1.0 - std::abs(at.y) / 0.15);
        maps.top[k] = static_cast<float>(top);
        maps.bottom[k] = static_cast<float>(r < 4.2 ? -20.0 + 2.0 * r : -7.5 + 2.5 * (r - 4.2) / 0.8);
    });
    return maps;
}

std::vector<NamedMaps> oddMaps()
{
    ToothMaps empty = analyticMolar(64);
    std::fill(empty.top.begin(), empty.top.end(), kEmptyTop);
    std::fill(empty.bottom.begin(), empty.bottom.end(), kEmptyBottom);
    ToothMaps needle = empty;
    needle.top[2000] = 0.0F;
    needle.bottom[2000] = -20.0F;
    const auto full = [&](float top, float bottom) {
        ToothMaps maps = empty;
        std::fill(maps.top.begin(), maps.top.end(), top);
        std::fill(maps.bottom.begin(), maps.bottom.end(), bottom);
        return maps;
    };
    ToothMaps root = full(-15.0F, -20.0F);  // everything is below the CEJ except one spike
    root.top[2000] = 0.0F;
    return {{"empty", 36, empty},
            {"needle", 36, needle},
            {"full", 0, full(0.0F, -20.0F)},
            {"film of 0.3 mm", 36, full(0.0F, -0.3F)},
            {"film of 0.5 mm", 36, full(0.0F, -0.5F)},
            {"root", 36, root}};
}

core::terrain::PerMaterial volumesOf(const ToothMaps& maps, const std::vector<core::terrain::ColumnLayers>& layers)
{
    core::terrain::PerMaterial sum{};
    for (std::size_t k = 0; k < layers.size(); ++k) {
        if (!maps.isSolid(k))
            continue;
        const auto length = core::terrain::lengthsBetween(layers[k], maps.bottom[k], maps.top[k]);
        for (std::size_t m = 0; m < sum.size(); ++m)
            sum[m] += length[m] * maps.grid.cellMm * maps.grid.cellMm;
    }
    return sum;
}

std::vector<NamedMaps> everyTooth(int side)
{
    std::vector<NamedMaps> teeth;
    teeth.push_back({"analytic molar", 36, analyticMolar(side)});
    int n = 0;
    for (const int fdi : {36, 21, 23, 24, 26, 37, 35, 31})
        if (isTried(n++))
            teeth.push_back({"generated " + std::to_string(fdi), fdi, generatedMaps(fdi, 0, side)});
    for (const int fdi : {21, 24, 36})
        if (auto scan = isTried(n++) ? scanMaps(fdi, side) : std::nullopt)
            teeth.push_back({"scan " + std::to_string(fdi), fdi, std::move(*scan)});
    return teeth;
}

}  // namespace support
