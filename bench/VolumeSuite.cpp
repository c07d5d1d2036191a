// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>

#include "bench/Suites.h"
#include "core/terrain/Rasteriser.h"

namespace bench {
namespace {

using core::mesh::TriangleMesh;

void addQuad(TriangleMesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d)
{
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
}

/// Returns a prism with four corners at the bottom and four at the top, both counter-clockwise seen from above.
TriangleMesh prism(const std::array<glm::vec3, 8>& corners)
{
    TriangleMesh mesh;
    mesh.vertices.assign(corners.begin(), corners.end());
    addQuad(mesh, 3, 2, 1, 0);
    addQuad(mesh, 4, 5, 6, 7);
    for (std::uint32_t k = 0; k < 4; ++k)
        addQuad(mesh, k, (k + 1) % 4, (k + 1) % 4 + 4, k + 4);
    return mesh;
}

/// Returns a body of revolution about z, closed by a disc at the height of its first point and at the axis at the top.
TriangleMesh lathe(const std::vector<glm::dvec2>& outline)
{
    constexpr std::uint32_t kTurns = 360;
    TriangleMesh mesh;
    for (const glm::dvec2& p : outline)
        for (std::uint32_t k = 0; k < kTurns; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / kTurns;
            mesh.vertices.emplace_back(p.x * std::cos(angle), p.x * std::sin(angle), p.y);
        }
    for (std::uint32_t ring = 0; ring + 1 < outline.size(); ++ring)
        for (std::uint32_t k = 0; k < kTurns; ++k)
            addQuad(mesh, ring * kTurns + k, ring * kTurns + (k + 1) % kTurns, (ring + 1) * kTurns + (k + 1) % kTurns,
                    (ring + 1) * kTurns + k);
    const auto centre = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.emplace_back(0.0, 0.0, outline.front().y);
    for (std::uint32_t k = 0; k < kTurns; ++k)
        mesh.triangles.push_back({centre, (k + 1) % kTurns, k});
    return mesh;
}

double volumeErrorPercent(const TriangleMesh& mesh, double exactMm3)
{
    glm::dvec2 low(1.0e9);
    glm::dvec2 high(-1.0e9);
    for (const glm::vec3& v : mesh.vertices) {
        low = glm::min(low, glm::dvec2(v));
        high = glm::max(high, glm::dvec2(v));
    }
    const auto maps =
        core::terrain::rasterise(mesh, core::terrain::fitGrid(low, high, core::terrain::kDefaultGridSide));
    return 100.0 * (core::terrain::volumeOf(maps) / exactMm3 - 1.0);
}

}  // namespace

core::Result<Figures> volumeSuite(const Context& context)
{
    context.progress(QStringLiteral("solids"), 0, 1);
    const auto turned = [](double x, double y, double z, double degrees) {
        const double a = degrees * std::numbers::pi / 180.0;
        return glm::vec3(x * std::cos(a) - y * std::sin(a), x * std::sin(a) + y * std::cos(a), z);
    };
    const auto box = [&](double degrees) {
        return prism({turned(-4, -3, 0, degrees), turned(4, -3, 0, degrees), turned(4, 3, 0, degrees),
                      turned(-4, 3, 0, degrees), turned(-4, -3, 5, degrees), turned(4, -3, 5, degrees),
                      turned(4, 3, 5, degrees), turned(-4, 3, 5, degrees)});
    };
    const TriangleMesh wedge =
        prism({glm::vec3(-4, -3, 0), glm::vec3(4, -3, 0), glm::vec3(4, 3, 0), glm::vec3(-4, 3, 0), glm::vec3(-4, -3, 1),
               glm::vec3(4, -3, 5), glm::vec3(4, 3, 5), glm::vec3(-4, 3, 1)});
    std::vector<glm::dvec2> cap;
    for (int k = 0; k <= 90; ++k) {
        const double angle = 0.5 * k * std::numbers::pi / 90.0 + 0.25 * std::numbers::pi * (1.0 - k / 90.0);
        cap.emplace_back(5.0 * std::cos(angle), 5.0 * std::sin(angle));
    }
    cap.back().x = 0.0;
    const double capHeight = 5.0 - cap.front().y;
    const double capVolume = std::numbers::pi * capHeight * capHeight * (15.0 - capHeight) / 3.0;
    const QString reach = QStringLiteral("within 0.5");
    Figures figures;
    const auto add = [&](const char* key, const char* what, const TriangleMesh& mesh, double exact) {
        figures << Figure{QStringLiteral("volume_%1_error_percent").arg(QLatin1String(key)), QLatin1String(what),
                          volumeErrorPercent(mesh, exact), QStringLiteral("%"), reach};
    };
    add("box", "box", box(0.0), 240.0);
    add("turned_box", "box turned by 17 degrees", box(17.0), 240.0);
    add("wedge", "wedge", wedge, 144.0);
    add("cone", "cone", lathe({{4.0, 0.0}, {0.0, 6.0}}), std::numbers::pi * 16.0 * 6.0 / 3.0);
    add("sphere_cap", "sphere cap", lathe(cap), capVolume);
    return figures;
}

}  // namespace bench
