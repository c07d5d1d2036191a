// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/render/SolidMesh.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "ui/render/Look.h"

namespace ui::render {
namespace {

constexpr float kSteel = 0.0F;
constexpr float kGrip = 1.0F;
constexpr float kBlades = 2.0F;
constexpr float kNotchedBlades = 3.0F;
constexpr float kDiamond = 4.0F;
constexpr float kRing = 5.0F;
constexpr float kRingMm = 0.6F;  ///< length of the ring on a diamond's shank
constexpr int kAround = 48;      ///< facets of a part of circular cross-section
constexpr float kPi = 3.14159265F;
/// Edges sharper than this are not smoothed: cosine of 35 degrees.
constexpr float kCrease = 0.82F;

/// One circle of a swept part: its centre, its radius, and the material from this circle on.
struct Ring
{
    glm::vec3 centre;
    float radius;
    float finish;
};

/// Sweeps circles along a path in the x, z plane. Normals are smooth where the profile is smooth, and split at its
/// edges.
void sweep(SolidMesh& mesh, std::span<const Ring> rings)
{
    const std::size_t count = rings.size();
    // Direction of the path at each ring. Between rings with the same centre (a flat disc), the direction of the
    // nearest piece of the path with a length.
    std::vector<glm::vec3> along(count, glm::vec3(0.0F, 0.0F, 1.0F));
    for (std::size_t k = 0; k < count; ++k) {
        std::size_t low = k;
        std::size_t high = k;
        while (low > 0 && glm::distance(rings[low].centre, rings[high].centre) < 1.0e-4F)
            --low;
        while (high + 1 < count && (high == k || glm::distance(rings[low].centre, rings[high].centre) < 1.0e-4F))
            ++high;
        along[k] = glm::normalize(rings[high].centre - rings[low].centre);
    }
    // Normal of each piece of the profile as (outwards, along).
    std::vector<glm::vec2> pieceNormal(count - 1);
    for (std::size_t k = 0; k + 1 < count; ++k) {
        const float run = glm::dot(rings[k + 1].centre - rings[k].centre, along[k]);
        pieceNormal[k] =
            glm::normalize(glm::vec2(run, -(rings[k + 1].radius - rings[k].radius)) + glm::vec2(1.0e-7F, 0.0F));
    }
    const auto normalAt = [&](std::size_t piece, std::size_t ring) {
        const std::size_t other = ring == piece ? (piece == 0 ? piece : piece - 1) : std::min(piece + 1, count - 2);
        const bool smooth = glm::dot(pieceNormal[piece], pieceNormal[other]) > kCrease;
        return smooth ? glm::normalize(pieceNormal[piece] + pieceNormal[other]) : pieceNormal[piece];
    };
    for (std::size_t piece = 0; piece + 1 < count; ++piece) {
        const auto base = static_cast<std::uint32_t>(mesh.vertices.size());
        for (const std::size_t ring : {piece, piece + 1}) {
            const glm::vec2 n = normalAt(piece, ring);
            const glm::vec3 side{0.0F, 1.0F, 0.0F};
            const glm::vec3 up = glm::cross(along[ring], side);
            for (int a = 0; a <= kAround; ++a) {
                const float angle = 2.0F * kPi * static_cast<float>(a) / kAround;
                const glm::vec3 outwards = -std::cos(angle) * up + std::sin(angle) * side;
                mesh.vertices.push_back({rings[ring].centre + rings[ring].radius * outwards,
                                         n.x * outwards + n.y * along[ring], rings[piece].finish, angle});
            }
        }
        for (std::uint32_t a = 0; a < kAround; ++a) {
            const std::uint32_t low = base + a;
            const std::uint32_t high = low + kAround + 1;
            for (const std::uint32_t index : {low, low + 1, high + 1, low, high + 1, high})
                mesh.indices.push_back(index);
        }
    }
}

/// Adds a solid of revolution about the z axis.
void turn(SolidMesh& mesh, std::span<const glm::vec3> radiusHeightFinish)
{
    std::vector<Ring> rings;
    for (const glm::vec3& p : radiusHeightFinish)
        rings.push_back({{0.0F, 0.0F, p.y}, p.x, p.z});
    sweep(mesh, rings);
}

float finishOf(const core::bur::Bur& bur)
{
    if (bur.isDiamond())
        return kDiamond;
    return bur.isCrosscut() ? kNotchedBlades : kBlades;
}

/// Returns the profile with the finish of the ring between two heights. The heights of the profile must not decrease.
std::vector<glm::vec3> withRing(const std::vector<glm::vec3>& profile, float fromMm, float toMm)
{
    std::vector<glm::vec3> ringed;
    for (std::size_t k = 0; k < profile.size(); ++k) {
        if (k > 0)
            for (const float cut : {fromMm, toMm})
                if (profile[k - 1].y < cut && cut < profile[k].y) {
                    const float share = (cut - profile[k - 1].y) / (profile[k].y - profile[k - 1].y);
                    ringed.emplace_back(glm::mix(profile[k - 1].x, profile[k].x, share), cut, kSteel);
                }
        ringed.push_back(profile[k]);
    }
    for (glm::vec3& point : ringed)
        if (point.y >= fromMm && point.y < toMm)
            point.z = kRing;
    return ringed;
}

}  // namespace

SolidMesh burMesh(const core::bur::Bur& bur)
{
    std::vector<glm::vec3> profile;
    for (const auto& point : bur.outline)
        profile.emplace_back(static_cast<float>(point.radiusMm), static_cast<float>(point.heightMm), finishOf(bur));
    const auto neck = static_cast<float>(bur.shankRadiusMm);
    const auto head = static_cast<float>(bur.headLengthMm);
    profile.emplace_back(neck, head, kSteel);
    const float top = head + static_cast<float>(kNeckMm + kMostLiftMm) + 0.5F;
    profile.emplace_back(neck, top, kSteel);
    profile.emplace_back(0.0F, top, kSteel);
    SolidMesh mesh;
    turn(mesh, profile);
    return mesh;
}

SolidMesh shankMesh(const core::bur::Bur& bur)
{
    const auto neck = static_cast<float>(bur.shankRadiusMm);
    const auto head = static_cast<float>(bur.headLengthMm);
    const float from = head + static_cast<float>(kNeckMm);
    const auto chuck = static_cast<float>(core::bur::kChuckMm);
    constexpr float kShankMm = 0.8F;
    constexpr float kWidensMm = 3.2F;  // or less, if a long head leaves less room
    const float inChuck = chuck + 4.0F;
    const float widens = std::min(kWidensMm, 0.9F * (inChuck - from));
    const std::vector<glm::vec3> profile{
        {0.0F, head - neck, kSteel},
        {0.5F * neck, head - 0.87F * neck, kSteel},
        {0.87F * neck, head - 0.5F * neck, kSteel},
        {neck, head, kSteel},
        {neck, from, kSteel},
        {0.5F * (neck + kShankMm), from + std::min(1.7F, 0.6F * widens), kSteel},
        {kShankMm, from + widens, kSteel},
        {kShankMm, inChuck, kSteel},  // closed, because the handpiece is semi-transparent and the shank ends inside it
        {0.0F, inChuck, kSteel},
    };
    SolidMesh mesh;
    // The ring is at the beginning of the shank, or on the visible part of the neck if the head is long.
    const float ring = std::max(head, std::min(from + 0.5F * widens, chuck - 2.0F * kRingMm));
    turn(mesh, bur.isDiamond() ? withRing(profile, ring, ring + kRingMm) : profile);
    return mesh;
}

SolidMesh handpieceMesh()
{
    SolidMesh mesh;
    const auto chuck = static_cast<float>(core::bur::kChuckMm);
    // The head, from bottom to top: chuck, cap, barrel, push button.
    const std::vector<glm::vec3> head{
        {0.9F, chuck, kGrip},         {1.7F, chuck, kSteel},        {2.0F, chuck + 0.3F, kSteel},
        {2.2F, chuck + 0.8F, kSteel}, {3.1F, chuck + 1.1F, kSteel}, {3.6F, chuck + 1.6F, kSteel},
        {3.8F, chuck + 2.3F, kSteel}, {3.8F, chuck + 3.6F, kGrip},  {3.7F, chuck + 3.7F, kGrip},
        {3.7F, chuck + 3.9F, kSteel}, {3.8F, chuck + 4.0F, kSteel}, {3.8F, chuck + 6.8F, kSteel},
        {3.6F, chuck + 7.4F, kSteel}, {3.2F, chuck + 7.8F, kSteel}, {2.8F, chuck + 8.0F, kGrip},
        {2.6F, chuck + 8.0F, kSteel}, {2.5F, chuck + 8.2F, kSteel}, {0.0F, chuck + 8.3F, kSteel},
    };
    turn(mesh, head);
    // Neck and handle: straight out of the barrel, then bent up by about 22 degrees, as in a contra-angle handpiece.
    const float axis = chuck + 4.9F;
    const std::vector<Ring> handle{
        {{2.0F, 0.0F, axis}, 2.7F, kSteel},           {{5.0F, 0.0F, axis + 0.1F}, 2.6F, kSteel},
        {{8.0F, 0.0F, axis + 0.4F}, 2.6F, kSteel},    {{12.0F, 0.0F, axis + 1.2F}, 2.8F, kSteel},
        {{16.0F, 0.0F, axis + 2.5F}, 3.2F, kSteel},   {{20.0F, 0.0F, axis + 4.1F}, 3.7F, kSteel},
        {{25.0F, 0.0F, axis + 6.1F}, 4.4F, kSteel},   {{27.0F, 0.0F, axis + 6.9F}, 4.6F, kGrip},
        {{27.2F, 0.0F, axis + 7.0F}, 4.4F, kGrip},    {{48.0F, 0.0F, axis + 15.4F}, 5.0F, kGrip},
        {{48.2F, 0.0F, axis + 15.5F}, 5.3F, kSteel},  {{80.0F, 0.0F, axis + 28.3F}, 6.6F, kSteel},
        {{110.0F, 0.0F, axis + 40.4F}, 7.0F, kSteel},
    };
    sweep(mesh, handle);
    return mesh;
}

SolidMesh mirrorMesh()
{
    const auto radius = static_cast<float>(DentalMirror::kRadiusMm);
    SolidMesh mesh;
    const std::vector<glm::vec3> cup{
        {0.0F, -2.2F, kSteel},   {radius - 3.0F, -2.0F, kSteel}, {radius - 1.0F, -1.6F, kSteel},
        {radius, -0.6F, kSteel}, {radius, -0.1F, kSteel},        {radius - 0.2F, 0.0F, kSteel},
        {0.0F, 0.0F, kSteel}};
    turn(mesh, cup);
    const std::vector<Ring> handle{
        {{radius - 1.5F, 0.0F, -1.4F}, 0.9F, kSteel},   {{radius + 2.0F, 0.0F, -2.2F}, 0.9F, kSteel},
        {{radius + 14.0F, 0.0F, -9.0F}, 1.2F, kSteel},  {{radius + 18.0F, 0.0F, -11.3F}, 2.4F, kSteel},
        {{radius + 20.0F, 0.0F, -12.4F}, 2.6F, kGrip},  {{radius + 50.0F, 0.0F, -29.7F}, 2.6F, kSteel},
        {{radius + 100.0F, 0.0F, -58.6F}, 2.8F, kSteel}};
    sweep(mesh, handle);
    return mesh;
}

}  // namespace ui::render
