// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/teeth/Gums.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/teeth/LookMeshes.h"
#include "core/teeth/TriangleSamples.h"

namespace core::teeth {
namespace {

constexpr double kStationMm = 0.55;  ///< between two sections across the arch
constexpr double kMapCellMm = 0.25;
constexpr double kGumMarginMm = 1.0;    ///< the margin above the CEJ
constexpr double kBehindMm = 7.0;       ///< gum behind the last tooth
constexpr double kBridgeMm = 3.0;       ///< radius of the curve of the gum between two teeth
constexpr double kDeepBridgeMm = 15.0;  ///< the same between two roots, near the foot of the gum
constexpr double kWideMm = 12.0;        ///< longest span along the arch, to either side
constexpr double kDeepSoftMm = 2.5;     ///< near its foot, the gum is averaged over this length to either side
constexpr double kNecksMm = -6.0;       ///< about where the one begins to turn into the other,
constexpr double kEvenFromMm = -12.5;   ///< and where it has
constexpr double kEvenMm = 7.0;         ///< over which the scallop is evened out further down
constexpr double kScallop = 2.6;        ///< power: how late the margin rises towards the papilla
constexpr double kInsideMm = 0.2;       ///< the margin's edge is hidden so deep in the tooth
constexpr double kRollMm = 1.1;         ///< height of the rolled edge of the margin
constexpr double kSteepestIn = 0.10;    ///< the face falls back under the margin by no more, mm per mm
constexpr int kBaseColumns = 9;
constexpr int kShellColumns = 6;
constexpr double kShellMm = 9.0;        ///< how far the shell bulges below the gum's foot,
constexpr double kShellFrontMm = 16.0;  ///< so far behind its front

/// Depths below the margin at which a section has points.
constexpr std::array kFacialDepthsMm{0.0, 0.05, 0.13, 0.26, 0.45, 0.75, 1.15, 1.7, 2.4, 3.3, 4.4, 5.8};
constexpr std::array kLingualDepthsMm{0.0, 0.05, 0.13, 0.26, 0.45, 0.75, 1.15, 1.7, 2.4, 3.3, 4.4, 5.5};
constexpr int kFootColumns = 3;   ///< from there down to the foot
constexpr int kCrestColumns = 3;  ///< between the two margins

/// How far the teeth reach to one side, over (along the arch, z), and the same with the hollows between them spanned.
class Contour
{
public:
    Contour(const ArchCurve& curve, std::span<const GumTooth> teeth, double side, double endMm)
        : m_reach({0.0, kGumFootMm - 1.0}, {endMm, 0.0}, kMapCellMm, kNothingMm), m_spanned(m_reach)
    {
        for (const GumTooth& tooth : teeth) {
            std::vector<glm::dvec3> points;
            points.reserve(tooth.mesh->vertices.size());
            for (const LookVertex& v : tooth.mesh->vertices) {
                const glm::dvec3 p(tooth.jawFromTooth * glm::dvec4(v.positionMm, 1.0));
                const ArchPlace place = curve.placeOf(glm::dvec2(p));
                points.emplace_back(place.alongMm, p.z, side * place.outwardMm);
            }
            const auto& indices = tooth.mesh->indices;
            for (std::size_t k = 0; k < indices.size(); k += 3)
                sampleTriangle(m_reach, points[indices[k]], points[indices[k + 1]], points[indices[k + 2]],
                               [](double& most, double reach) { most = std::max(most, reach); });
        }
        for (int row = m_reach.rows - 1; row >= 0; --row)
            fill(row);
        span();
    }

    [[nodiscard]] double reach(double alongMm, double z) const { return read(m_reach, alongMm, z); }
    [[nodiscard]] double spanned(double alongMm, double z) const { return read(m_spanned, alongMm, z); }

private:
    /// Between teeth a straight line from one to the next; where no root reaches down as the row above.
    void fill(int row)
    {
        int before = -1;
        for (int column = 0; column < m_reach.columns; ++column) {
            if (m_reach.at(column, row) <= kNothingMm)
                continue;
            const double to = m_reach.at(column, row);
            const double from = before < 0 ? to : m_reach.at(before, row);
            for (int k = before + 1; k < column; ++k)
                m_reach.at(k, row) = before < 0 ? to : from + (to - from) * (k - before) / (column - before);
            before = column;
        }
        for (int k = before + 1; k < m_reach.columns; ++k)
            m_reach.at(k, row) = before >= 0              ? m_reach.at(before, row)
                                 : row + 1 < m_reach.rows ? m_reach.at(k, row + 1)
                                                          : 0.0;
    }

    /// The tooth that is drilled is a map of heights, so a hollow between crown and root is filled: the gum has to
    /// cover the filled tooth.
    [[nodiscard]] SampleMap withoutUndercuts() const
    {
        SampleMap filled = m_reach;
        for (int column = 0; column < filled.columns; ++column) {
            for (int row = filled.rows - 2; row >= 0; --row)
                filled.at(column, row) = std::max(filled.at(column, row), filled.at(column, row + 1));
            double below = kNothingMm;
            for (int row = 0; row < filled.rows; ++row) {
                below = std::max(below, m_reach.at(column, row));
                filled.at(column, row) = std::min(filled.at(column, row), below);
            }
        }
        return filled;
    }

    void span()
    {
        const int wide = static_cast<int>(kWideMm / kMapCellMm);
        std::vector<double> line(static_cast<std::size_t>(m_reach.columns));
        // The right half mirrors the left one.
        const auto onLine = [&](int column) {
            return static_cast<std::size_t>(std::min(std::abs(column), m_reach.columns - 1));
        };
        const SampleMap filled = withoutUndercuts();
        for (int row = 0; row < m_reach.rows; ++row) {
            const double deep = 1.0 - eased(kEvenFromMm, kNecksMm, m_reach.nodeMm(0, row).y);
            const double bridge = kBridgeMm + (kDeepBridgeMm - kBridgeMm) * deep;
            for (int column = 0; column < m_reach.columns; ++column) {
                double most = kNothingMm;
                for (int k = -wide; k <= wide; ++k) {
                    const double away = k * kMapCellMm;
                    const int from = static_cast<int>(onLine(column + k));
                    most = std::max(most, filled.at(from, row) - away * away / (2.0 * bridge));
                }
                line[onLine(column)] = most;
            }
            // Removes the creases where two spans meet.
            const int soft = static_cast<int>(std::lround(kDeepSoftMm * deep / kMapCellMm));
            for (int column = 0; column < m_reach.columns; ++column) {
                double sum = 0.0;
                for (int k = -soft; k <= soft; ++k)
                    sum += line[onLine(column + k)];
                m_spanned.at(column, row) = sum / (2 * soft + 1);
            }
        }
    }

    [[nodiscard]] static double read(const SampleMap& map, double alongMm, double z)
    {
        const double x = std::clamp((alongMm - map.lowMm.x) / map.cellMm, 0.0, map.columns - 1.001);
        const double y = std::clamp((z - map.lowMm.y) / map.cellMm, 0.0, map.rows - 1.001);
        const int c = static_cast<int>(x);
        const int r = static_cast<int>(y);
        const double u = x - c;
        const double v = y - r;
        return (map.at(c, r) * (1.0 - u) + map.at(c + 1, r) * u) * (1.0 - v) +
               (map.at(c, r + 1) * (1.0 - u) + map.at(c + 1, r + 1) * u) * v;
    }

    SampleMap m_reach;
    SampleMap m_spanned;
};

/// One side of a section: points from the margin down, as (outwards to that side, z).
struct Side
{
    std::vector<glm::dvec2> points;
};

}  // namespace

Gums makeGums(Jaw jaw, const ArchCurve& curve, std::span<const GumTooth> teeth, double firstPapillaMm)
{
    const double lastMm = teeth.back().toMm;
    const double endMm = lastMm + kBehindMm;
    const Contour facial(curve, teeth, 1.0, endMm);
    const Contour lingual(curve, teeth, -1.0, endMm);

    // The margin: scalloped, tooth by tooth.
    const auto marginAt = [&](double along, bool isFacial) {
        for (std::size_t k = 0; k < teeth.size(); ++k) {
            const GumTooth& tooth = teeth[k];
            if (along > tooth.toMm)
                continue;
            const double half = 0.5 * (tooth.toMm - tooth.fromMm);
            const double t = (along - tooth.fromMm - half) / half;
            const double neck = (isFacial ? tooth.facialNeckMm : tooth.lingualNeckMm) + kGumMarginMm;
            const double tip = t > 0.0 ? tooth.papillaMm : k == 0 ? firstPapillaMm : teeth[k - 1].papillaMm;
            return neck + (tip - neck) * std::pow(std::min(std::abs(t), 1.0), kScallop);
        }
        const double behind = std::min((along - lastMm) / kBehindMm, 1.0);
        return teeth.back().papillaMm + (kGumFootMm + 0.8 - teeth.back().papillaMm) * behind * behind;
    };
    const auto evenMarginAt = [&](double along, bool isFacial) {
        double sum = 0.0;
        constexpr int kSteps = 16;
        for (int k = -kSteps; k <= kSteps; ++k)
            sum += marginAt(std::abs(along + kEvenMm * k / kSteps), isFacial);
        return sum / (2 * kSteps + 1);
    };
    // How thick the gum is over teeth and roots, by the depth below the margin. Further down, the depth below a margin
    // without scallops counts: otherwise a pleat would hang from each papilla.
    const auto thicknessMm = [&](double depth, double evenDepth, bool isFacial) {
        const double even = 0.30 + 0.55 * eased(0.0, 2.2, depth);
        if (isFacial)
            return even + 0.10 * std::max(evenDepth - 5.0, 0.0);
        return even + (jaw == Jaw::Upper ? 0.55 : 0.12) * std::max(evenDepth - 1.2, 0.0);
    };
    const auto sideAt = [&](double along, bool isFacial, std::span<const double> depths, bool toFoot) {
        const Contour& contour = isFacial ? facial : lingual;
        const double margin = marginAt(along, isFacial);
        const double behind = std::clamp((along - lastMm) / kBehindMm, 0.0, 1.0);
        std::vector<double> all(depths.begin(), depths.end());
        const double foot = margin - kGumFootMm;
        const double evenMargin = evenMarginAt(along, isFacial);
        // Deep down the rows run straight along the jaw.
        const double deepest = std::clamp(depths.back() + margin - evenMargin, 0.3, std::max(0.9 * foot, 0.3));
        for (double& depth : all)
            depth *= 1.0 + (deepest / depths.back() - 1.0) * depth / depths.back();
        for (int k = 1; toFoot && k <= kFootColumns; ++k)
            all.push_back(all[depths.size() - 1] + (foot - all[depths.size() - 1]) * k / kFootColumns);
        const double edge = contour.reach(along, margin) - kInsideMm;
        Side side;
        double face = kNothingMm;
        double before = 0.0;
        for (const double depth : all) {
            const double over =
                contour.spanned(along, margin - depth) + thicknessMm(depth, depth + evenMargin - margin, isFacial);
            face = std::max(over, face - kSteepestIn * (depth - before));
            before = depth;
            const double down = 1.0 - std::min(depth / kRollMm, 1.0);
            const double out = edge + (face - edge) * std::sqrt(1.0 - down * down);
            side.points.emplace_back(out * (1.0 - 0.30 * behind * behind), margin - depth);
        }
        return side;
    };

    LookMesh all;
    const int stations = static_cast<int>(std::ceil(endMm / kStationMm)) + 1;
    int columns = 0;
    int gumColumns = 0;           ///< with the shell before them
    std::vector<glm::vec3> ends;  ///< of the gum's lingual side
    double frontMm = 0.0;         ///< y of the gum's foot at the midline
    for (int s = 0; s < stations; ++s) {
        const double along = std::min(s * kStationMm, endMm);
        const glm::dvec2 middle = curve.point(along);
        const glm::dvec2 outward = curve.outward(along);
        Side front = sideAt(along, true, kFacialDepthsMm, true);
        Side back = sideAt(along, false, kLingualDepthsMm, false);
        // Where teeth touch the two margins meet; they do not pass each other.
        if (const double crossed = -front.points.front().x - back.points.front().x; crossed > 0.0) {
            front.points.front().x += 0.5 * crossed + 0.02;
            back.points.front().x += 0.5 * crossed + 0.02;
        }
        const auto add = [&](double out, double z, Tissue tissue) {
            const glm::dvec2 p = middle + out * outward;
            // The mirror plane is the end of the left half.
            all.vertices.push_back({glm::vec3(s == 0 ? 0.0 : std::max(p.x, 0.0), p.y, z), glm::vec3(0.0F), 1.0F,
                                    static_cast<float>(tissue)});
        };
        // The shell comes from the midline to the foot of the gum, upright where the two meet.
        const glm::dvec2 foot = middle + front.points.back().x * outward;
        if (s == 0)
            frontMm = foot.y;
        const double backMm = (curve.point(endMm).y - frontMm) * along / endMm;
        const double rising = 1.0 - std::min(backMm / kShellFrontMm, 1.0);
        const double bulge = kShellMm * std::sqrt(1.0 - rising * rising);
        for (int k = 0; k < kShellColumns; ++k) {
            const double angle = 0.5 * std::numbers::pi * k / kShellColumns;
            const double x = s == 0 ? 0.0 : std::max(foot.x, 0.0);
            const double start = frontMm + backMm;
            all.vertices.push_back({glm::vec3(x * std::sin(angle), start + (foot.y - start) * std::sin(angle),
                                              kGumFootMm - bulge * std::cos(angle)),
                                    glm::vec3(0.0F), 1.0F, static_cast<float>(Tissue::Gum)});
        }
        for (auto p = front.points.rbegin(); p != front.points.rend(); ++p)
            add(p->x, p->y, Tissue::Gum);
        for (int k = 1; k <= kCrestColumns; ++k) {
            const double t = static_cast<double>(k) / (kCrestColumns + 1);
            const glm::dvec2 from = front.points.front();
            const glm::dvec2 to{-back.points.front().x, back.points.front().y};
            const glm::dvec2 p = from + t * (to - from);
            const double dome = along > lastMm
                                    ? 0.15 * (from.x - to.x) * 4.0 * t * (1.0 - t) * eased(lastMm, lastMm + 2.0, along)
                                    : 0.0;
            add(p.x, p.y + dome, Tissue::Gum);
        }
        for (const glm::dvec2& p : back.points)
            add(-p.x, p.y, Tissue::Gum);
        ends.push_back(all.vertices.back().positionMm);
        gumColumns = static_cast<int>(all.vertices.size()) - s * columns;
        for (int k = 0; k < kBaseColumns; ++k)
            all.vertices.push_back({glm::vec3(0.0F), glm::vec3(0.0F), 1.0F, static_cast<float>(Tissue::Mucosa)});
        columns = gumColumns + kBaseColumns;
    }
    // From the gum's lingual end to the midline: a vault above, below the tongue. It forgets tooth by tooth on the way.
    for (int s = 0; s < stations; ++s) {
        glm::vec3 even(0.0F);
        constexpr int kWide = static_cast<int>(kEvenMm / kStationMm);
        for (int k = s - kWide; k <= s + kWide; ++k) {
            const glm::vec3 end = ends[static_cast<std::size_t>(std::min(std::abs(k), stations - 1))];
            even += k < 0 ? glm::vec3(-end.x, end.y, end.z) : end;
        }
        even /= static_cast<float>(2 * kWide + 1);
        const glm::vec3 own = ends[static_cast<std::size_t>(s)];
        for (int k = 1; k <= kBaseColumns; ++k) {
            const double t = static_cast<double>(k) / kBaseColumns;
            const glm::vec3 from = glm::mix(own, even, static_cast<float>(eased(0.0, 0.4, t)));
            const double vault = (jaw == Jaw::Upper ? -0.42 : 0.30) * from.x;
            const double arc = 1.0 - (1.0 - t) * (1.0 - t);
            all.vertices[static_cast<std::size_t>(s * columns + gumColumns - 1 + k)].positionMm =
                glm::vec3(from.x * (1.0 - t), from.y, from.z + vault * arc);
        }
    }
    const auto at = [&](int station, int column) { return static_cast<std::uint32_t>(station * columns + column); };
    const auto patch = [&](LookMesh& mesh, int fromStation, int toStation, int fromColumn, int toColumn) {
        for (int s = fromStation; s < toStation; ++s)
            for (int c = fromColumn; c < toColumn; ++c)
                for (const std::uint32_t k :
                     {at(s, c), at(s + 1, c), at(s + 1, c + 1), at(s, c), at(s + 1, c + 1), at(s, c + 1)})
                    mesh.indices.push_back(k);
    };
    patch(all, 0, stations - 1, 0, columns - 1);
    smoothNormals(all);
    // The two halves meet without an edge.
    for (LookVertex& v : all.vertices)
        if (v.positionMm.x < 1.0e-4F && glm::length(glm::vec2(v.normal.y, v.normal.z)) > 1.0e-6F)
            v.normal = glm::normalize(glm::vec3(0.0F, v.normal.y, v.normal.z));

    // One mesh a tooth, with the vertices it uses.
    const auto cutOut = [&](int fromStation, int toStation, int fromColumn, int toColumn) {
        LookMesh part;
        patch(part, fromStation, toStation, fromColumn, toColumn);
        std::vector<std::uint32_t> moved(all.vertices.size(), 0xFFFFFFFFU);
        for (std::uint32_t& k : part.indices) {
            if (moved[k] == 0xFFFFFFFFU) {
                moved[k] = static_cast<std::uint32_t>(part.vertices.size());
                part.vertices.push_back(all.vertices[k]);
            }
            k = moved[k];
        }
        return part;
    };
    Gums gums;
    int from = 0;
    for (const GumTooth& tooth : teeth) {
        const bool last = &tooth == &teeth.back();
        const int to = last ? stations - 1 : static_cast<int>(std::lround(tooth.toMm / kStationMm));
        gums.around.push_back(cutOut(from, to, kShellColumns, gumColumns - 1));
        from = to;
    }
    gums.base = cutOut(0, stations - 1, gumColumns - 1, columns - 1);
    gums.shell = cutOut(0, stations - 1, 0, kShellColumns);
    // Its back: from the last line of the shell to the last one of the base, both from the midline outwards.
    const auto first = static_cast<std::uint32_t>(gums.shell.vertices.size());
    for (int k = 0; k <= kShellColumns; ++k) {
        for (const int column : {k, columns - 1 - k * kBaseColumns / kShellColumns}) {
            LookVertex vertex = all.vertices[at(stations - 1, column)];
            vertex.normal = glm::vec3(0.0F, 1.0F, 0.0F);
            gums.shell.vertices.push_back(vertex);
        }
        for (const std::uint32_t corner : {0U, 1U, 2U, 1U, 3U, 2U})
            if (k < kShellColumns)
                gums.shell.indices.push_back(first + 2U * static_cast<std::uint32_t>(k) + corner);
    }
    return gums;
}

}  // namespace core::teeth
