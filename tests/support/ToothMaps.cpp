// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/ToothMaps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <glm/vec3.hpp>

#include "core/teeth/ToothGenerator.h"
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

void cover(ToothMaps& maps, const std::array<glm::dvec3, 3>& corner)
{
    const auto lattice = [&](const glm::dvec3& p) { return maps.grid.latticeOf({p.x, p.y}); };
    const std::array<glm::dvec2, 3> at{lattice(corner[0]), lattice(corner[1]), lattice(corner[2])};
    const double area = (at[1].x - at[0].x) * (at[2].y - at[0].y) - (at[2].x - at[0].x) * (at[1].y - at[0].y);
    if (std::abs(area) < 1e-12)
        return;
    const auto [lowX, highX] = std::minmax({at[0].x, at[1].x, at[2].x});
    const auto [lowY, highY] = std::minmax({at[0].y, at[1].y, at[2].y});
    for (int j = std::max(0, static_cast<int>(std::ceil(lowY))); j <= std::min(maps.grid.side - 1.0, highY); ++j) {
        for (int i = std::max(0, static_cast<int>(std::ceil(lowX))); i <= std::min(maps.grid.side - 1.0, highX); ++i) {
            std::array<double, 3> weight{};
            for (std::size_t c = 0; c < 3; ++c) {
                const glm::dvec2& p = at[(c + 1) % 3];
                const glm::dvec2& q = at[(c + 2) % 3];
                weight[c] = ((q.x - p.x) * (j - p.y) - (i - p.x) * (q.y - p.y)) / area;
            }
            if (std::min({weight[0], weight[1], weight[2]}) < -1e-9)
                continue;
            const auto z =
                static_cast<float>(weight[0] * corner[0].z + weight[1] * corner[1].z + weight[2] * corner[2].z);
            float& top = maps.top[maps.grid.index(i, j)];
            float& bottom = maps.bottom[maps.grid.index(i, j)];
            top = std::max(top, z);
            bottom = std::min(bottom, z);
        }
    }
}

ToothMaps rasterise(std::vector<glm::dvec3> points, const std::vector<std::array<std::size_t, 3>>& triangles, int side)
{
    glm::dvec3 low = points.front();
    glm::dvec3 high = points.front();
    for (const glm::dvec3& p : points) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    for (glm::dvec3& p : points)
        p -= glm::dvec3(0.5 * (low.x + high.x), 0.5 * (low.y + high.y), high.z);

    ToothMaps maps;
    maps.grid =
        gridOver(side, 0.5 * (low.x - high.x), 0.5 * (high.x - low.x), 0.5 * (low.y - high.y), 0.5 * (high.y - low.y));
    maps.top.assign(maps.grid.count(), kEmptyTop);
    maps.bottom.assign(maps.grid.count(), kEmptyBottom);
    for (const auto& t : triangles)
        cover(maps, {points[t[0]], points[t[1]], points[t[2]]});
    for (std::size_t k = 0; k < maps.top.size(); ++k) {
        if (maps.top[k] > maps.bottom[k])
            continue;
        maps.top[k] = kEmptyTop;
        maps.bottom[k] = kEmptyBottom;
    }
    return maps;
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
    std::ifstream file(path);
    if (path.empty() || !file)
        return std::nullopt;

    // The scans stand in one arch: +y up, +z anterior, +x the patient's left; upper teeth crown down.
    constexpr double kMmPerUnit = 10.5;
    const auto inTooth = [&](double x, double y, double z) -> glm::dvec3 {
        switch (fdi) {
        case 36:
            return glm::dvec3(-z, -x, y) * kMmPerUnit;
        case 24:
            return glm::dvec3(-z, x, -y) * kMmPerUnit;
        default:
            return glm::dvec3(x, z, -y) * kMmPerUnit;
        }
    };
    std::vector<glm::dvec3> points;
    std::vector<std::array<std::size_t, 3>> triangles;
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        std::string kind;
        words >> kind;
        if (kind == "v") {
            double x = 0.0;
            double y = 0.0;
            double z = 0.0;
            words >> x >> y >> z;
            points.push_back(inTooth(x, y, z));
        } else if (kind == "f") {
            std::vector<std::size_t> face;
            for (std::string word; words >> word;)
                face.push_back(static_cast<std::size_t>(std::stoul(word)) - 1);
            for (std::size_t c = 2; c < face.size(); ++c)
                triangles.push_back({face[0], face[c - 1], face[c]});
        }
    }
    return rasterise(std::move(points), triangles, side);
}

ToothMaps generatedMaps(int fdi, std::uint64_t seed, int side)
{
    const core::mesh::TriangleMesh mesh = core::teeth::generateTooth(fdi, seed).value();
    std::vector<glm::dvec3> points(mesh.vertices.begin(), mesh.vertices.end());
    std::vector<std::array<std::size_t, 3>> triangles;
    for (const auto& t : mesh.triangles)
        triangles.push_back({t[0], t[1], t[2]});
    return rasterise(std::move(points), triangles, side);
}

ToothMaps analyticMolar(int side)
{
    ToothMaps maps;
    maps.grid = gridOver(side, -5.0, 5.0, -5.0, 5.0);
    maps.top.assign(maps.grid.count(), kEmptyTop);
    maps.bottom.assign(maps.grid.count(), kEmptyBottom);
    for (int j = 0; j < side; ++j) {
        for (int i = 0; i < side; ++i) {
            const glm::dvec2 at = maps.grid.nodeMm(i, j);
            const double r = std::sqrt(at.x * at.x + at.y * at.y);
            if (r >= 5.0)
                continue;
            // Four cusps of spherical caps at (+-2.5, +-2.5) over a fossa at -2.5.
            const double cx = std::abs(at.x) - 2.5;
            const double cy = std::abs(at.y) - 2.5;
            double top = std::max(-2.5, -0.55 * (cx * cx + cy * cy));
            if (r > 4.0)
                top = std::min(top, -5.0 + 4.0 * std::sqrt(std::max(0.0, 1.0 - (r - 4.0) * (r - 4.0))));
            if (std::abs(at.y) < 0.15 && r < 3.0)
                top -= 0.8 * (1.0 - std::abs(at.y) / 0.15);
            const double bottom = r < 4.2 ? -20.0 + 2.0 * r : -7.5 + 2.5 * (r - 4.2) / 0.8;
            maps.top[maps.grid.index(i, j)] = static_cast<float>(top);
            maps.bottom[maps.grid.index(i, j)] = static_cast<float>(bottom);
        }
    }
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
    ToothMaps root = full(-15.0F, -20.0F);  // everything below where the CEJ would be but one spike
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
