// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/teeth/LookMeshes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

namespace core::teeth {

void smoothNormals(LookMesh& mesh)
{
    for (LookVertex& v : mesh.vertices)
        v.normal = glm::vec3(0.0F);
    for (std::size_t k = 0; k < mesh.indices.size(); k += 3) {
        LookVertex& a = mesh.vertices[mesh.indices[k]];
        LookVertex& b = mesh.vertices[mesh.indices[k + 1]];
        LookVertex& c = mesh.vertices[mesh.indices[k + 2]];
        const glm::vec3 across = glm::cross(b.positionMm - a.positionMm, c.positionMm - a.positionMm);
        for (LookVertex* v : {&a, &b, &c})
            v->normal += across;
    }
    for (LookVertex& v : mesh.vertices) {
        const float length = glm::length(v.normal);
        v.normal = length > 1.0e-12F ? v.normal / length : glm::vec3(0.0F, 0.0F, 1.0F);
    }
}

void softenGrooves(LookMesh& mesh, std::size_t count)
{
    constexpr int kPasses = 10;
    constexpr float kShare = 0.6F;
    std::vector<glm::vec3> sums(mesh.vertices.size());
    std::vector<float> counts(mesh.vertices.size());
    for (int pass = 0; pass < kPasses; ++pass) {
        std::fill(sums.begin(), sums.end(), glm::vec3(0.0F));
        std::fill(counts.begin(), counts.end(), 0.0F);
        for (std::size_t k = 0; k < mesh.indices.size(); ++k) {
            const std::uint32_t from = mesh.indices[k];
            const std::uint32_t to = mesh.indices[k % 3 == 2 ? k - 2 : k + 1];
            sums[from] += mesh.vertices[to].positionMm;
            sums[to] += mesh.vertices[from].positionMm;
            counts[from] += 1.0F;
            counts[to] += 1.0F;
        }
        for (std::size_t k = 0; k < count; ++k) {
            LookVertex& v = mesh.vertices[k];
            const glm::vec3 way = sums[k] / std::max(counts[k], 1.0F) - v.positionMm;
            // In a groove, the surroundings are higher than the vertex.
            const float out = glm::dot(way, v.normal);
            if (counts[k] > 0.0F && out > 0.0F)
                v.positionMm += kShare * out * v.normal;
        }
        smoothNormals(mesh);
    }
}

void shadeGrooves(LookMesh& mesh, std::size_t count)
{
    constexpr int kPasses = 2;
    constexpr float kDeepMm = 0.1F;
    constexpr float kDarkest = 0.4F;  ///< share of the light that a deep groove loses
    LookMesh filled = mesh;
    softenGrooves(filled, count);
    // Normal and depth, averaged over the neighbouring vertices.
    std::vector<glm::vec4> shades(mesh.vertices.size());
    for (std::size_t k = 0; k < shades.size(); ++k)
        shades[k] = glm::vec4(mesh.vertices[k].normal,
                              glm::distance(filled.vertices[k].positionMm, mesh.vertices[k].positionMm));
    for (int pass = 0; pass < kPasses; ++pass) {
        std::vector<glm::vec4> sums = shades;
        std::vector<float> counts(shades.size(), 1.0F);
        for (std::size_t k = 0; k < mesh.indices.size(); ++k) {
            const std::uint32_t from = mesh.indices[k];
            const std::uint32_t to = mesh.indices[k % 3 == 2 ? k - 2 : k + 1];
            sums[from] += shades[to];
            counts[from] += 1.0F;
        }
        for (std::size_t k = 0; k < shades.size(); ++k)
            shades[k] = sums[k] / counts[k];
    }
    for (std::size_t k = 0; k < count; ++k) {
        LookVertex& v = mesh.vertices[k];
        const float share = std::min(shades[k].w / kDeepMm, 1.0F);
        v.open *= 1.0F - kDarkest * share;
        v.normal = glm::normalize(glm::mix(v.normal, glm::vec3(shades[k]), share));
    }
}

void softenShade(LookMesh& mesh)
{
    constexpr int kPasses = 4;
    constexpr float kGroove = 0.55F;  ///< openness up to which a vertex is in a groove
    constexpr float kFree = 0.85F;    ///< openness from which it is not
    struct Shade
    {
        glm::vec3 normal{0.0F};
        float open = 0.0F;
        float count = 0.0F;
    };
    std::vector<Shade> sums(mesh.vertices.size());
    for (int pass = 0; pass < kPasses; ++pass) {
        std::fill(sums.begin(), sums.end(), Shade());
        const auto add = [&](std::uint32_t to, std::uint32_t from) {
            sums[to].normal += mesh.vertices[from].normal;
            sums[to].open += mesh.vertices[from].open;
            sums[to].count += 1.0F;
        };
        for (std::size_t k = 0; k < mesh.indices.size(); ++k) {
            const std::uint32_t from = mesh.indices[k];
            const std::uint32_t to = mesh.indices[k % 3 == 2 ? k - 2 : k + 1];
            add(from, to);
            add(to, from);
        }
        for (std::size_t k = 0; k < mesh.vertices.size(); ++k) {
            LookVertex& v = mesh.vertices[k];
            if (sums[k].count <= 0.0F || v.tissue > 0.5F)
                continue;
            const float open = sums[k].open / sums[k].count;
            const float share = std::clamp((kFree - std::min(v.open, open)) / (kFree - kGroove), 0.0F, 1.0F);
            const glm::vec3 normal = glm::mix(v.normal, sums[k].normal / sums[k].count, share);
            if (glm::length(normal) > 1.0e-3F)
                v.normal = glm::normalize(normal);
            v.open += share * (open - v.open);
        }
    }
}

void findBall(LookMesh& mesh)
{
    glm::vec3 low(1.0e9F);
    glm::vec3 high(-1.0e9F);
    for (const LookVertex& v : mesh.vertices) {
        low = glm::min(low, v.positionMm);
        high = glm::max(high, v.positionMm);
    }
    mesh.middleMm = 0.5F * (low + high);
    mesh.radiusMm = 0.0F;
    for (const LookVertex& v : mesh.vertices)
        mesh.radiusMm = std::max(mesh.radiusMm, glm::distance(v.positionMm, mesh.middleMm));
}

void addToSkyline(SampleMap& skyline, const LookMesh& mesh, const glm::dmat4& jawFromMesh)
{
    std::vector<glm::dvec3> points;
    points.reserve(mesh.vertices.size());
    for (const LookVertex& v : mesh.vertices)
        points.emplace_back(jawFromMesh * glm::dvec4(v.positionMm, 1.0));
    for (std::size_t k = 0; k < mesh.indices.size(); k += 3)
        sampleTriangle(skyline, points[mesh.indices[k]], points[mesh.indices[k + 1]], points[mesh.indices[k + 2]],
                       [](double& highest, double z) { highest = std::max(highest, z); });
}

void findOpenness(LookMesh& mesh, const glm::dmat4& jawFromMesh, const SampleMap& skyline)
{
    constexpr int kWays = 12;
    constexpr double kReachesMm[] = {0.6, 1.2, 1.9, 2.8, 4.0, 5.6, 8.0, 11.0, 15.0};
    const glm::dmat3 turn(jawFromMesh);
    for (LookVertex& v : mesh.vertices) {
        const glm::dvec3 p(jawFromMesh * glm::dvec4(v.positionMm, 1.0));
        const glm::dvec3 n = turn * glm::dvec3(v.normal);
        // Light of an even half sky on this slope, with and without the surroundings.
        double free = 0.0;
        double seen = 0.0;
        for (int way = 0; way < kWays; ++way) {
            const double angle = 2.0 * std::numbers::pi * (way + 0.5) / kWays;
            const glm::dvec2 d{std::cos(angle), std::sin(angle)};
            const double across = n.x * d.x + n.y * d.y;
            // The surface itself hides the sky behind it.
            const double own = std::max(0.0, std::atan2(-across, std::max(n.z, 0.02)));
            double horizon = own;
            for (const double reach : kReachesMm) {
                const glm::dvec2 at = glm::dvec2(p) + reach * d;
                const double z = skyline.at(skyline.columnOf(std::abs(at.x)), skyline.rowOf(at.y));
                horizon = std::max(horizon, std::atan2(z - p.z - 0.05, reach));
            }
            free += 1.0 - std::sin(own);
            seen += 1.0 - std::sin(std::min(horizon, 0.5 * std::numbers::pi));
        }
        // A height map has little information about walls and overhangs, so surfaces that face sideways count as fairly
        // open.
        constexpr double kWall = 0.88;
        const double level = std::clamp((n.z + 0.1) / 0.6, 0.0, 1.0);
        const double share = std::clamp(free > 1.0e-6 ? seen / free : 1.0, 0.0, 1.0);
        v.open = static_cast<float>(kWall + (share - kWall) * level * level * (3.0 - 2.0 * level));
    }
}

}  // namespace core::teeth
