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
constexpr double kNecksMm = -6.0;       ///< height at which necks begin to turn into the even part
constexpr double kEvenFromMm = -12.5;   ///< height at which they have turned into it
constexpr double kEvenMm = 7.0;         ///< length over which the scallop is evened out
constexpr double kScallop = 2.6;        ///< power: how late the margin rises towards the papilla
constexpr double kInsideMm = 0.2;       ///< depth of the hidden edge of the margin in the tooth
constexpr double kRollMm = 1.1;         ///< height of the rolled edge of the margin
constexpr double kSteepestIn = 0.10;    ///< most that the face recedes below the margin, mm per mm
constexpr int kBaseColumns = 9;
constexpr int kShellColumns = 6;
constexpr double kShellMm = 9.0;        ///< the shell bulges this far below the foot of the gum
constexpr double kShellFrontMm = 16.0;  ///< distance of that bulge behind the front

/// Depths below the margin at which a section has points.
constexpr std::array kFacialDepthsMm{0.0, 0.05, 0.13, 0.26, 0.45, 0.75, 1.15, 1.7, 2.4, 3.3, 4.4, 5.8};
constexpr std::array kLingualDepthsMm{0.0, 0.05, 0.13, 0.26, 0.45, 0.75, 1.15, 1.7, 2.4, 3.3, 4.4, 5.5};
constexpr int kFootColumns = 3;   ///< columns from there down to the foot
constexpr int kCrestColumns = 3;  ///< between the two margins

/// The extent of the teeth to one side, over (along the arch, z), and the same extent with the hollows between them
/// spanned.
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
    /// Spans the gaps between teeth with straight lines. Rows without any root are copies of the row above.
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

    /// Returns the map without undercuts. The drilled tooth is a height map, so a hollow between its crown and root is
    /// filled, and the gum has to cover it.
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
            // Smooths the creases between two spans.
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

/// One side of a section: points from the margin down, as (outwards on that side, z).
struct Side
{
    std::vector<glm::dvec2> points;
};

/// Builds the gum from sections across the arch. All sections have the same number of points, so that neighbouring ones
/// can be joined by triangles.
class GumBuilder
{
public:
    GumBuilder(Jaw jaw, const ArchCurve& curve, std::span<const GumTooth> teeth, double firstPapillaMm)
        : m_jaw(jaw), m_curve(curve), m_teeth(teeth), m_firstPapillaMm(firstPapillaMm), m_lastMm(teeth.back().toMm),
          m_endMm(m_lastMm + kBehindMm), m_facial(curve, teeth, 1.0, m_endMm), m_lingual(curve, teeth, -1.0, m_endMm),
          m_stations(static_cast<int>(std::ceil(m_endMm / kStationMm)) + 1)
    {}

    Gums build()
    {
        for (int s = 0; s < m_stations; ++s)
            addSection(s);
        for (int s = 0; s < m_stations; ++s)
            placeBase(s);
        addPatch(m_all, 0, m_stations - 1, 0, m_columns - 1);
        smoothNormals(m_all);
        joinHalves();
        return divided();
    }

private:
    /// Returns the height of the margin: scalloped, tooth by tooth.
    [[nodiscard]] double marginAt(double along, bool isFacial) const
    {
        for (std::size_t k = 0; k < m_teeth.size(); ++k) {
            const GumTooth& tooth = m_teeth[k];
            if (along > tooth.toMm)
                continue;
            const double half = 0.5 * (tooth.toMm - tooth.fromMm);
            const double t = (along - tooth.fromMm - half) / half;
            const double neck = (isFacial ? tooth.facialNeckMm : tooth.lingualNeckMm) + kGumMarginMm;
            const double tip = t > 0.0 ? tooth.papillaMm : k == 0 ? m_firstPapillaMm : m_teeth[k - 1].papillaMm;
            return neck + (tip - neck) * std::pow(std::min(std::abs(t), 1.0), kScallop);
        }
        const double behind = std::min((along - m_lastMm) / kBehindMm, 1.0);
        return m_teeth.back().papillaMm + (kGumFootMm + 0.8 - m_teeth.back().papillaMm) * behind * behind;
    }

    /// Returns the height of a margin without scallops.
    [[nodiscard]] double evenMarginAt(double along, bool isFacial) const
    {
        double sum = 0.0;
        constexpr int kSteps = 16;
        for (int k = -kSteps; k <= kSteps; ++k)
            sum += marginAt(std::abs(along + kEvenMm * k / kSteps), isFacial);
        return sum / (2 * kSteps + 1);
    }

    /// Returns the thickness of the gum over teeth and roots. Further down it uses the depth below a margin without
    /// scallops: otherwise there would be a fold below each papilla.
    [[nodiscard]] double thicknessMm(double depth, double evenDepth, bool isFacial) const
    {
        const double even = 0.30 + 0.55 * eased(0.0, 2.2, depth);
        if (isFacial)
            return even + 0.10 * std::max(evenDepth - 5.0, 0.0);
        return even + (m_jaw == Jaw::Upper ? 0.55 : 0.12) * std::max(evenDepth - 1.2, 0.0);
    }

    [[nodiscard]] Side sideAt(double along, bool isFacial, std::span<const double> depths) const
    {
        const Contour& contour = isFacial ? m_facial : m_lingual;
        const double margin = marginAt(along, isFacial);
        const double behind = std::clamp((along - m_lastMm) / kBehindMm, 0.0, 1.0);
        std::vector<double> all(depths.begin(), depths.end());
        const double foot = margin - kGumFootMm;
        const double evenMargin = evenMarginAt(along, isFacial);
        // Deep down, the rows are straight along the jaw.
        const double deepest = std::clamp(depths.back() + margin - evenMargin, 0.3, std::max(0.9 * foot, 0.3));
        for (double& depth : all)
            depth *= 1.0 + (deepest / depths.back() - 1.0) * depth / depths.back();
        for (int k = 1; isFacial && k <= kFootColumns; ++k)
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
    }

    /// Adds the vertices of one section: shell, facial side, crest, lingual side, and space for the base.
    void addSection(int station)
    {
        const double along = std::min(station * kStationMm, m_endMm);
        const glm::dvec2 middle = m_curve.point(along);
        const glm::dvec2 outward = m_curve.outward(along);
        Side front = sideAt(along, true, kFacialDepthsMm);
        Side back = sideAt(along, false, kLingualDepthsMm);
        // Where teeth touch, the two margins meet but must not cross.
        if (const double crossed = -front.points.front().x - back.points.front().x; crossed > 0.0) {
            front.points.front().x += 0.5 * crossed + 0.02;
            back.points.front().x += 0.5 * crossed + 0.02;
        }
        const auto add = [&](double out, double z) {
            const glm::dvec2 p = middle + out * outward;
            // The mirror plane is the end of the left half.
            addVertex(glm::vec3(station == 0 ? 0.0 : std::max(p.x, 0.0), p.y, z), Tissue::Gum);
        };
        addShell(station, along, middle + front.points.back().x * outward);
        for (auto p = front.points.rbegin(); p != front.points.rend(); ++p)
            add(p->x, p->y);
        const glm::dvec2 from = front.points.front();
        const glm::dvec2 to{-back.points.front().x, back.points.front().y};
        for (int k = 1; k <= kCrestColumns; ++k) {
            const double t = static_cast<double>(k) / (kCrestColumns + 1);
            const glm::dvec2 p = from + t * (to - from);
            const double dome =
                along > m_lastMm ? 0.15 * (from.x - to.x) * 4.0 * t * (1.0 - t) * eased(m_lastMm, m_lastMm + 2.0, along)
                                 : 0.0;
            add(p.x, p.y + dome);
        }
        for (const glm::dvec2& p : back.points)
            add(-p.x, p.y);
        m_ends.push_back(m_all.vertices.back().positionMm);
        m_gumColumns = static_cast<int>(m_all.vertices.size()) - station * m_columns;
        for (int k = 0; k < kBaseColumns; ++k)
            addVertex(glm::vec3(0.0F), Tissue::Mucosa);
        m_columns = m_gumColumns + kBaseColumns;
    }

    /// Adds the shell of one section, from the midline to the foot of the gum. It is vertical where the two meet.
    void addShell(int station, double along, const glm::dvec2& foot)
    {
        if (station == 0)
            m_frontMm = foot.y;
        const double backMm = (m_curve.point(m_endMm).y - m_frontMm) * along / m_endMm;
        const double rising = 1.0 - std::min(backMm / kShellFrontMm, 1.0);
        const double bulge = kShellMm * std::sqrt(1.0 - rising * rising);
        const double x = station == 0 ? 0.0 : std::max(foot.x, 0.0);
        const double start = m_frontMm + backMm;
        for (int k = 0; k < kShellColumns; ++k) {
            const double angle = 0.5 * std::numbers::pi * k / kShellColumns;
            addVertex(glm::vec3(x * std::sin(angle), start + (foot.y - start) * std::sin(angle),
                                kGumFootMm - bulge * std::cos(angle)),
                      Tissue::Gum);
        }
    }

    /// Places the base of one section, from the gum's lingual end to the midline. It is a vault below the tongue, whose
    /// rows gradually lose the shape of single teeth.
    void placeBase(int station)
    {
        glm::vec3 even(0.0F);
        constexpr int kWide = static_cast<int>(kEvenMm / kStationMm);
        for (int k = station - kWide; k <= station + kWide; ++k) {
            const glm::vec3 end = m_ends[static_cast<std::size_t>(std::min(std::abs(k), m_stations - 1))];
            even += k < 0 ? glm::vec3(-end.x, end.y, end.z) : end;
        }
        even /= static_cast<float>(2 * kWide + 1);
        const glm::vec3 own = m_ends[static_cast<std::size_t>(station)];
        for (int k = 1; k <= kBaseColumns; ++k) {
            const double t = static_cast<double>(k) / kBaseColumns;
            const glm::vec3 from = glm::mix(own, even, static_cast<float>(eased(0.0, 0.4, t)));
            const double vault = (m_jaw == Jaw::Upper ? -0.42 : 0.30) * from.x;
            const double arc = 1.0 - (1.0 - t) * (1.0 - t);
            m_all.vertices[at(station, m_gumColumns - 1 + k)].positionMm =
                glm::vec3(from.x * (1.0 - t), from.y, from.z + vault * arc);
        }
    }

    /// Joins the two halves so that there is no visible edge.
    void joinHalves()
    {
        for (LookVertex& v : m_all.vertices)
            if (v.positionMm.x < 1.0e-4F && glm::length(glm::vec2(v.normal.y, v.normal.z)) > 1.0e-6F)
                v.normal = glm::normalize(glm::vec3(0.0F, v.normal.y, v.normal.z));
    }

    [[nodiscard]] Gums divided() const
    {
        Gums gums;
        int from = 0;
        for (const GumTooth& tooth : m_teeth) {
            const bool last = &tooth == &m_teeth.back();
            const int to = last ? m_stations - 1 : static_cast<int>(std::lround(tooth.toMm / kStationMm));
            gums.around.push_back(cutOut(from, to, kShellColumns, m_gumColumns - 1));
            from = to;
        }
        gums.base = cutOut(0, m_stations - 1, m_gumColumns - 1, m_columns - 1);
        gums.shell = cutOut(0, m_stations - 1, 0, kShellColumns);
        closeBack(gums.shell);
        return gums;
    }

    /// Returns a part of the mesh with only the vertices that this part uses.
    [[nodiscard]] LookMesh cutOut(int fromStation, int toStation, int fromColumn, int toColumn) const
    {
        LookMesh part;
        addPatch(part, fromStation, toStation, fromColumn, toColumn);
        std::vector<std::uint32_t> moved(m_all.vertices.size(), 0xFFFFFFFFU);
        for (std::uint32_t& k : part.indices) {
            if (moved[k] == 0xFFFFFFFFU) {
                moved[k] = static_cast<std::uint32_t>(part.vertices.size());
                part.vertices.push_back(m_all.vertices[k]);
            }
            k = moved[k];
        }
        return part;
    }

    /// Closes the back of the shell, from its last line to the last line of the base; both run from the midline
    /// outwards.
    void closeBack(LookMesh& shell) const
    {
        const auto first = static_cast<std::uint32_t>(shell.vertices.size());
        for (int k = 0; k <= kShellColumns; ++k) {
            for (const int column : {k, m_columns - 1 - k * kBaseColumns / kShellColumns}) {
                LookVertex vertex = m_all.vertices[at(m_stations - 1, column)];
                vertex.normal = glm::vec3(0.0F, 1.0F, 0.0F);
                shell.vertices.push_back(vertex);
            }
            for (const std::uint32_t corner : {0U, 1U, 2U, 1U, 3U, 2U})
                if (k < kShellColumns)
                    shell.indices.push_back(first + 2U * static_cast<std::uint32_t>(k) + corner);
        }
    }

    void addVertex(const glm::vec3& positionMm, Tissue tissue)
    {
        m_all.vertices.push_back({positionMm, glm::vec3(0.0F), 1.0F, static_cast<float>(tissue)});
    }

    [[nodiscard]] std::uint32_t at(int station, int column) const
    {
        return static_cast<std::uint32_t>(station * m_columns + column);
    }

    /// Adds two triangles for every cell of a range of stations and columns.
    void addPatch(LookMesh& mesh, int fromStation, int toStation, int fromColumn, int toColumn) const
    {
        for (int s = fromStation; s < toStation; ++s)
            for (int c = fromColumn; c < toColumn; ++c)
                for (const std::uint32_t k :
                     {at(s, c), at(s + 1, c), at(s + 1, c + 1), at(s, c), at(s + 1, c + 1), at(s, c + 1)})
                    mesh.indices.push_back(k);
    }

    Jaw m_jaw;
    const ArchCurve& m_curve;
    std::span<const GumTooth> m_teeth;
    double m_firstPapillaMm;
    double m_lastMm;  ///< end of the last tooth along the arch
    double m_endMm;   ///< end of the gum along the arch
    Contour m_facial;
    Contour m_lingual;
    int m_stations;
    LookMesh m_all;
    int m_columns = 0;
    int m_gumColumns = 0;           ///< with the shell before them
    std::vector<glm::vec3> m_ends;  ///< of the gum's lingual side
    double m_frontMm = 0.0;         ///< y of the gum's foot at the midline
};

}  // namespace

Gums makeGums(Jaw jaw, const ArchCurve& curve, std::span<const GumTooth> teeth, double firstPapillaMm)
{
    return GumBuilder(jaw, curve, teeth, firstPapillaMm).build();
}

}  // namespace core::teeth
