// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/preparation/OcclusalOutline.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>

namespace core::preparation {
namespace {

using Spot = OcclusalCavity::Spot;
using Line = std::vector<glm::dvec2>;

constexpr double kStepMm = 0.04;    ///< between the points of a line
constexpr double kSmoothMm = 0.45;  ///< width over which the small bends of a groove are smoothed
constexpr double kSearchMm = 4.5;   ///< radius around the middle of the tooth in which grooves are searched
constexpr double kJoinMm = 0.4;     ///< a stroke that branches off another begins this far beside it
constexpr std::size_t kOutlinePoints = 360;
constexpr double kShortestMm = 0.8;     ///< of a main stroke
constexpr double kRoundReachMm = 0.6;   ///< two strokes are joined by a round within this distance
constexpr double kRoundErrorMm = 0.01;  ///< a round may remove this much of the ridge

/// Returns weighted means along a line, which is continued straight beyond its ends.
Line smoothed(const Line& line, double sigmaMm)
{
    if (line.size() < 3)
        return line;
    const int reach = static_cast<int>(std::ceil(3.0 * sigmaMm / kStepMm));
    const int last = static_cast<int>(line.size()) - 1;
    const auto at = [&](int k) {
        if (k < 0)
            return 2.0 * line.front() - line[static_cast<std::size_t>(std::min(-k, last))];
        if (k > last)
            return 2.0 * line.back() - line[static_cast<std::size_t>(std::max(2 * last - k, 0))];
        return line[static_cast<std::size_t>(k)];
    };
    Line result;
    for (int k = 0; k <= last; ++k) {
        glm::dvec2 sum{0.0};
        double weights = 0.0;
        for (int n = -reach; n <= reach; ++n) {
            const double away = n * kStepMm / sigmaMm;
            const double weight = std::exp(-0.5 * away * away);
            sum += weight * at(k + n);
            weights += weight;
        }
        result.push_back(sum / weights);
    }
    return result;
}

double distanceToLine(const Line& line, glm::dvec2 point)
{
    double nearest = std::numeric_limits<double>::max();
    for (std::size_t k = 0; k + 1 < line.size(); ++k) {
        const glm::dvec2 along = line[k + 1] - line[k];
        const double length = std::max(1.0e-12, glm::dot(along, along));
        const glm::dvec2 off =
            point - line[k] - along * std::clamp(glm::dot(point - line[k], along) / length, 0.0, 1.0);
        nearest = std::min(nearest, glm::dot(off, off));
    }
    return std::sqrt(nearest);
}

/// The grooves of one tooth and the strokes along them. Works in (u, v): u from mesial to distal, v towards the cheek.
class Planner
{
public:
    Planner(Kind kind, int fdi, const teeth::PosteriorForm& form, const ToothDesign& design)
        : m_kind(kind), m_fdi(fdi), m_form(form), m_design(design), m_radius(design.burRadiusMm),
          m_half(0.5 * design.isthmusMm - design.burRadiusMm)
    {
        for (const glm::dvec2& point : form.outline(static_cast<int>(kOutlinePoints)))
            m_silhouette.push_back(uv(point));
        // The silhouette is rotated so that the mesial and the distal quarter are separate lines.
        for (std::size_t k = 0; k <= kOutlinePoints / 4; ++k) {
            m_distal.push_back(m_silhouette[(k + kOutlinePoints * 7 / 8) % kOutlinePoints]);
            m_mesial.push_back(m_silhouette[k + kOutlinePoints * 3 / 8]);
        }
        m_silhouette.push_back(m_silhouette.front());
        for (const glm::dvec2& point : obliqueCrest(fdi, form))
            m_crest.push_back(uv(point));
    }

    Result<std::vector<OcclusalCavity>> plan()
    {
        if (isSlot(m_kind)) {
            planSlot(m_kind == Kind::SlotMesial);
            return std::move(m_cavities);
        }
        Status status;
        switch (m_fdi) {
        case 26:
        case 27:
            status = planUpperMolar();
            break;
        case 34:
            status = planTwoPits();
            break;
        default:
            status = planCentralGroove();
        }
        if (!status)
            return tl::unexpected(std::move(status).error());
        return std::move(m_cavities);
    }

private:
    using Lobes = std::vector<std::size_t>;

    [[nodiscard]] glm::dvec2 uv(glm::dvec2 tooth) const { return {tooth.x, tooth.y * m_form.ySign}; }
    [[nodiscard]] glm::dvec2 tooth(glm::dvec2 p) const { return {p.x, p.y * m_form.ySign}; }

    /// Returns the lobes of some groups whose tips are between two lines from mesial to distal.
    [[nodiscard]] Lobes lobes(std::initializer_list<int> groups, double lowY = -100.0, double highY = 100.0) const
    {
        Lobes found;
        const auto& all = m_form.crown.design().lobes;
        for (std::size_t k = 0; k < all.size(); ++k)
            if (std::find(groups.begin(), groups.end(), all[k].group) != groups.end() && all[k].y > lowY &&
                all[k].y < highY)
                found.push_back(k);
        return found;
    }

    [[nodiscard]] double height(const Lobes& set, glm::dvec2 p) const
    {
        double highest = -1.0e9;
        for (const std::size_t lobe : set)
            highest = std::max(highest, m_form.lobeMm(lobe, tooth(p)));
        return highest;
    }
    [[nodiscard]] double mouth(glm::dvec2 p) const { return m_form.mouthMm(tooth(p)); }

    /// Returns where `over` becomes higher than `under` along one coordinate, nearest to a guess.
    [[nodiscard]] std::optional<double> crossing(const std::function<glm::dvec2(double)>& at, const Lobes& under,
                                                 const Lobes& over, double guess) const
    {
        constexpr double kScanMm = 0.1;
        std::vector<double> ends;
        for (double t = -kSearchMm; t < kSearchMm; t += kScanMm)
            ends.push_back(t);
        ends.push_back(ends.back() + kScanMm);
        std::vector<std::optional<double>> known(ends.size());
        const auto rise = [&](double t) { return height(over, at(t)) - height(under, at(t)); };
        const auto riseAtEnd = [&](std::size_t k) { return known[k] ? *known[k] : known[k].emplace(rise(ends[k])); };
        // Searches outwards from the guess, until no nearer crossing is possible.
        const std::size_t cells = ends.size() - 1;
        const auto after = std::upper_bound(ends.begin() + 1, ends.end() - 1, guess);
        auto next = static_cast<std::size_t>(after - ends.begin()) - 1;
        std::size_t before = next;  // index after the cell
        constexpr double kNever = std::numeric_limits<double>::max();
        std::optional<double> best;
        while (next < cells || before > 0) {
            const double ahead = next < cells ? ends[next] - guess : kNever;
            const double behind = before > 0 ? guess - ends[before] : kNever;
            if (best && std::abs(*best - guess) <= std::min(ahead, behind))
                break;
            const std::size_t cell = ahead < behind ? next++ : --before;
            if (riseAtEnd(cell) >= 0.0 || riseAtEnd(cell + 1) < 0.0)
                continue;
            double low = ends[cell];
            double high = ends[cell + 1];
            for (int k = 0; k < 30; ++k) {
                const double middle = 0.5 * (low + high);
                (rise(middle) < 0.0 ? low : high) = middle;
            }
            if (!best || std::abs(high - guess) < std::abs(*best - guess))
                best = high;
        }
        return best;
    }

    /// Returns the groove between a lingual and a buccal set of lobes, over a range of u.
    [[nodiscard]] Line grooveAlongU(const Lobes& lingual, const Lobes& buccal, double fromU, double toU) const
    {
        Line line;
        double v = 0.0;
        for (double u = fromU; u <= toU; u += kStepMm)
            if (const auto found = crossing([u](double t) { return glm::dvec2{u, t}; }, lingual, buccal, v)) {
                v = *found;
                line.emplace_back(u, v);
            }
        return line;
    }

    /// Returns the groove between a mesial and a distal set of lobes, over a range of v.
    [[nodiscard]] Line grooveAlongV(const Lobes& mesial, const Lobes& distal, double fromV, double toV,
                                    double guess) const
    {
        Line line;
        const int steps = static_cast<int>(std::abs(toV - fromV) / kStepMm);
        double u = guess;
        for (int k = 0; k <= steps; ++k) {
            const double v = fromV + (toV > fromV ? kStepMm : -kStepMm) * k;
            if (const auto found = crossing([v](double t) { return glm::dvec2{t, v}; }, mesial, distal, u)) {
                u = *found;
                line.emplace_back(u, v);
            }
        }
        return line;
    }

    [[nodiscard]] double ridgeLeft(glm::dvec2 axis, double half, double leanMm) const
    {
        return distanceToLine(axis.x < 0.0 ? m_mesial : m_distal, axis) - m_radius - half - leanMm;
    }
    /// Returns whether a place is on the occlusal table. A groove leaves the table at the sides, but pits are searched
    /// on the table only.
    [[nodiscard]] bool isOnTable(glm::dvec2 p) const { return distanceToLine(m_silhouette, p) > 1.4 && p.y > -0.9; }
    /// Returns the deepest place of a groove on the occlusal table; empty if the groove is not on it.
    [[nodiscard]] std::optional<std::size_t> pitOf(const Line& groove) const
    {
        std::optional<std::size_t> pit;
        for (std::size_t k = 0; k < groove.size(); ++k)
            if (isOnTable(groove[k]) && (!pit || mouth(groove[k]) < mouth(groove[*pit])))
                pit = k;
        return pit;
    }
    [[nodiscard]] bool sparesCrest(glm::dvec2 axis, double half) const
    {
        return m_crest.empty() || distanceToLine(m_crest, axis) >= m_design.obliqueMm + m_radius + half;
    }

    /// Returns whether an outline spares the transverse ridge of a lower first premolar, which is between its two
    /// cavities.
    [[nodiscard]] bool sparesTransverse(glm::dvec2 axis, double half) const
    {
        return m_fdi != 34 || std::abs(axis.x) >= m_design.obliqueMm + m_radius + half;
    }

    /// Returns how much wider the outline gets from the floor to the surface because the wall leans.
    [[nodiscard]] double leanMm(glm::dvec2 axis, double floorMm) const
    {
        const double tangent = std::tan(m_design.divergeDeg * std::numbers::pi / 180.0);
        return std::max(0.0, mouth(axis) + 0.4 - floorMm) * tangent;
    }

    /// Returns a box at the mesial or distal end of the tooth, at a distance v from its middle line.
    [[nodiscard]] OcclusalCavity::Box proximalAt(double v, bool mesial) const
    {
        std::size_t nearest = mesial ? kOutlinePoints / 2 : 0;
        for (std::size_t k = 0; k < kOutlinePoints; ++k)
            if ((m_silhouette[k].x < 0.0) == mesial &&
                std::abs(m_silhouette[k].y - v) < std::abs(m_silhouette[nearest].y - v))
                nearest = k;
        OcclusalCavity::Box box = boxAt(nearest);
        box.outwards *= (box.outwards.x < 0.0) == mesial ? 1.0 : -1.0;
        return box;
    }

    /// Returns a box at a point of the silhouette, at right angles to it. Its direction is not limited: it may point
    /// into the tooth.
    [[nodiscard]] OcclusalCavity::Box boxAt(std::size_t nearest) const
    {
        constexpr std::size_t kAside = kOutlinePoints / 30;
        const glm::dvec2 along = glm::normalize(m_silhouette[(nearest + kAside) % kOutlinePoints] -
                                                m_silhouette[(nearest + kOutlinePoints - kAside) % kOutlinePoints]);
        return {m_silhouette[nearest], {along.y, -along.x}};
    }

    /// Returns the place where the tooth is widest on its mesial or distal side.
    [[nodiscard]] glm::dvec2 contact(bool mesial) const
    {
        const Line& side = mesial ? m_mesial : m_distal;
        return *std::max_element(side.begin(), side.end(),
                                 [](glm::dvec2 a, glm::dvec2 b) { return std::abs(a.x) < std::abs(b.x); });
    }

    /// Like proximalAt(), but nearly at right angles to the tooth.
    [[nodiscard]] OcclusalCavity::Box squareBoxAt(double v, bool mesial) const
    {
        constexpr double kMostSkew = 0.2;
        OcclusalCavity::Box box = proximalAt(v, mesial);
        glm::dvec2& out = box.outwards;
        out = glm::normalize(glm::dvec2{out.x, std::clamp(out.y, -kMostSkew, kMostSkew)});
        return box;
    }

    /// Adds a stroke from a place of the axis straight outwards through a proximal box.
    void openInto(OcclusalCavity& cavity, glm::dvec2 from, bool mesial) const
    {
        // The box is between the groove and the contact, which is nearer to the cheek.
        cavity.box = squareBoxAt(0.5 * (from.y + contact(mesial).y), mesial);
        std::vector<Spot> spots;
        const double length = glm::distance(from, cavity.box->atMm);
        for (double away = 0.0; away <= length; away += kStepMm)
            spots.push_back({from + (cavity.box->atMm - from) * (away / length), m_half});
        cavity.strokes.push_back(std::move(spots));
    }

    /// Returns a stroke across the end of the main stroke, parallel to the marginal ridge: the bar of a dovetail.
    [[nodiscard]] std::vector<Spot> bar(glm::dvec2 middle) const
    {
        const double half = std::max(0.0, 0.5 * m_design.isthmusMm + m_design.dovetailMm - m_radius);
        const glm::dvec2 out = proximalAt(middle.y, middle.x < 0.0).outwards;
        glm::dvec2 along{-out.y, out.x};
        along *= along.y < 0.0 ? -1.0 : 1.0;
        // The direction is half way between that of the ridge and the perpendicular of the tooth, because grooves fork
        // at such an angle.
        along = glm::normalize(along + glm::dvec2{0.0, 1.0});
        std::vector<Spot> spots;
        const int steps = std::max(1, static_cast<int>(2.0 * half / kStepMm));
        for (int k = 0; k <= steps; ++k)
            spots.push_back({middle + along * (half * (2.0 * k / steps - 1.0)), 0.0});
        return spots;
    }

    [[nodiscard]] bool fits(const Spot& spot, double floorMm) const
    {
        return ridgeLeft(spot.atMm, spot.halfMm, leanMm(spot.atMm, floorMm)) >= m_design.ridgeMm &&
               sparesCrest(spot.atMm, spot.halfMm) && sparesTransverse(spot.atMm, spot.halfMm);
    }
    [[nodiscard]] bool fits(const std::vector<Spot>& spots, double floorMm) const
    {
        return std::all_of(spots.begin(), spots.end(), [&](const Spot& spot) { return fits(spot, floorMm); });
    }

    /// Returns the part of a bar that spares the ridge, because the tooth is hollow beside some bars. Empty if the
    /// middle does not spare it, or if less than two thirds of the bar remain.
    [[nodiscard]] std::vector<Spot> fittingBar(glm::dvec2 middle, double floorMm) const
    {
        const std::vector<Spot> whole = bar(middle);
        const std::size_t centre = whole.size() / 2;
        std::size_t first = centre;
        std::size_t last = centre;
        if (!fits(whole[centre], floorMm))
            return {};
        while (first > 0 && fits(whole[first - 1], floorMm))
            --first;
        while (last + 1 < whole.size() && fits(whole[last + 1], floorMm))
            ++last;
        if (3 * (last - first) < 2 * (whole.size() - 1))
            return {};
        return {whole.begin() + static_cast<std::ptrdiff_t>(first),
                whole.begin() + static_cast<std::ptrdiff_t>(last + 1)};
    }

    /// Returns the mean height of the mouth along part of a line, minus the depth.
    [[nodiscard]] double floorBelow(const Line& line, double fromU, double toU) const
    {
        double sum = 0.0;
        double count = 0.0;
        for (const glm::dvec2& p : line)
            if (p.x >= fromU && p.x <= toU) {
                sum += mouth(p);
                count += 1.0;
            }
        return sum / std::max(1.0, count) - m_design.depthMm;
    }

    [[nodiscard]] static tl::unexpected<Error> noRoom(const char* where, const char* figures)
    {
        return unexpected(ErrorCode::OutOfRange,
                          LocalizableText{"there is no room for the %1 on this tooth; make one of these less: %2",
                                          {{where}, {figures}}});
    }

    [[nodiscard]] static std::size_t nearestTo(const Line& line, double u)
    {
        std::size_t best = 0;
        for (std::size_t k = 0; k < line.size(); ++k)
            if (std::abs(line[k].x - u) < std::abs(line[best].x - u))
                best = k;
        return best;
    }

    /// Returns where a ridge's lobe becomes higher than the cusps beside the groove, along the groove from the middle.
    [[nodiscard]] double pitTowards(const Line& line, const Lobes& cusps, const Lobes& ridge, bool mesial,
                                    double fromU) const
    {
        double pit = fromU;
        const int count = static_cast<int>(line.size());
        for (int k = static_cast<int>(nearestTo(line, fromU)); k >= 0 && k < count; k += mesial ? -1 : 1) {
            const glm::dvec2 p = line[static_cast<std::size_t>(k)];
            pit = p.x;
            if (height(ridge, p) >= height(cusps, p))
                break;
        }
        return pit;
    }

    [[nodiscard]] bool boxIs(bool mesial) const
    {
        return m_kind == (mesial ? Kind::ClassTwoMesial : Kind::ClassTwoDistal);
    }

    /// Returns a stroke along part of a line.
    [[nodiscard]] std::vector<Spot> stroke(const Line& line, double fromU, double toU) const
    {
        std::vector<Spot> spots;
        for (const glm::dvec2& p : line)
            if (p.x >= fromU && p.x <= toU)
                spots.push_back({p, m_half});
        return spots;
    }

    /// Returns the place where the groove between two cusps leaves the main groove.
    [[nodiscard]] std::optional<glm::dvec2> branchAt(const Line& main, const Lobes& mesial, const Lobes& distal,
                                                     double fromU, double toU) const
    {
        for (const glm::dvec2& p : main)
            if (p.x >= fromU && p.x <= toU && height(distal, p) >= height(mesial, p))
                return p;
        return {};
    }

    /// Adds a stroke from the main stroke into a groove towards the cheek or the tongue.
    void extend(OcclusalCavity& cavity, const Line& main, const Lobes& mesial, const Lobes& distal, bool buccal,
                double fromU, double toU) const
    {
        const double reach = 0.5 * m_design.isthmusMm + m_design.grooveMm - m_radius;
        if (reach <= kJoinMm)
            return;
        const auto start = branchAt(main, mesial, distal, fromU, toU);
        if (!start)
            return;
        const double sign = buccal ? 1.0 : -1.0;
        Line groove = grooveAlongV(mesial, distal, start->y, start->y + sign * (reach + 1.0), start->x);
        groove = smoothed(groove, kSmoothMm);
        std::vector<Spot> spots;
        for (const glm::dvec2& p : groove) {
            const double away = distanceToLine(main, p);
            if (away < kJoinMm || std::abs(p.x - start->x) > 1.5 * reach)
                continue;
            if (away > reach || !sparesCrest(p, 0.0))
                break;
            spots.push_back({p, 0.0});
        }
        if (!spots.empty())
            cavity.strokes.push_back(std::move(spots));
    }

    /// Adds a stroke from the main stroke along a buccal groove to a box in the buccal surface.
    void openToCheek(OcclusalCavity& cavity, const Line& main, const Lobes& mesial, const Lobes& distal, double fromU,
                     double toU) const
    {
        const auto start = branchAt(main, mesial, distal, fromU, toU);
        if (!start)
            return;
        constexpr double kMostAsideMm = 1.5;  // a groove farther aside is ignored
        constexpr double kAtSurfaceMm = 0.3;
        std::vector<Spot> spots;
        for (const glm::dvec2& p :
             smoothed(grooveAlongV(mesial, distal, start->y, start->y + 8.0, start->x), kSmoothMm)) {
            if (std::abs(p.x - start->x) > kMostAsideMm)
                break;
            spots.push_back({p, m_half});
            if (distanceToLine(m_silhouette, p) < kAtSurfaceMm)
                break;
        }
        const glm::dvec2 end = spots.empty() ? *start : spots.back().atMm;
        std::size_t nearest = 0;
        for (std::size_t k = 0; k < kOutlinePoints; ++k)
            if (glm::distance(m_silhouette[k], end) < glm::distance(m_silhouette[nearest], end))
                nearest = k;
        cavity.box = boxAt(nearest);
        cavity.box->outwards *= cavity.box->outwards.y > 0.0 ? 1.0 : -1.0;
        cavity.strokes.push_back(std::move(spots));
    }

    /// Returns whether the round that joins a bar to the main stroke spares the ridge.
    /// @param end  end of the main stroke
    [[nodiscard]] bool roundFits(const std::vector<Spot>& bar, glm::dvec2 end, double floorMm) const
    {
        const glm::dvec2 middle = bar[bar.size() / 2].atMm;
        const glm::dvec2 out = proximalAt(middle.y, middle.x < 0.0).outwards;
        return std::all_of(bar.begin(), bar.end(), [&](const Spot& spot) {
            const double toMain = glm::distance(spot.atMm + out * m_radius, end) - m_half;
            const double roundMm = std::min(m_radius, toMain) - roundJoin(m_radius, toMain);
            return ridgeLeft(spot.atMm, roundMm, leanMm(spot.atMm, floorMm)) >= m_design.ridgeMm - kRoundErrorMm;
        });
    }

    Status finishMain(OcclusalCavity& cavity, const Line& line, double mesialU, double distalU, bool mesialBar,
                      bool distalBar)
    {
        const auto findEnd = [&](bool mesial, double& end, bool hasBar) {
            const double middle = 0.5 * (mesialU + distalU);
            if (boxIs(mesial))
                return true;
            for (int k = static_cast<int>(nearestTo(line, end));
                 mesial ? line[static_cast<std::size_t>(k)].x < middle : line[static_cast<std::size_t>(k)].x > middle;
                 k += mesial ? 1 : -1) {
                const glm::dvec2 p = line[static_cast<std::size_t>(k)];
                end = p.x;
                if (hasBar ? !fittingBar(p, cavity.floorMm).empty()
                           : ridgeLeft(p, m_half, 0.0) >= m_design.ridgeMm && sparesCrest(p, m_half))
                    return true;
            }
            return false;
        };
        double mesialEnd = mesialU;
        double distalEnd = distalU;
        if (!findEnd(true, mesialEnd, mesialBar) || !findEnd(false, distalEnd, distalBar) ||
            distalEnd - mesialEnd < kShortestMm)
            return noRoom("occlusal outline", "ridge_mm, oblique_mm, dovetail_mm, isthmus_mm");
        const auto addBar = [&](bool mesial, double end) {
            std::vector<Spot> spots = fittingBar(line[nearestTo(line, end)], cavity.floorMm);
            double outermost = spots.front().atMm.x;
            for (const Spot& spot : spots)
                outermost = mesial ? std::max(outermost, spot.atMm.x) : std::min(outermost, spot.atMm.x);
            (mesial ? cavity.mesialEndX : cavity.distalEndX) = outermost;
            cavity.strokes.push_back(std::move(spots));
        };
        // The main stroke ends before a bar; otherwise the round between them would bulge towards the ridge.
        const bool mesialStop = mesialBar && !boxIs(true);
        const bool distalStop = distalBar && !boxIs(false);
        const auto stopAt = [&](bool mesial, double end) {
            const std::vector<Spot> spots = fittingBar(line[nearestTo(line, end)], cavity.floorMm);
            double stop = end;
            for (double shortOf = m_half + 0.25; shortOf < m_half + kRoundReachMm; shortOf += kStepMm) {
                stop = mesial ? end + shortOf : end - shortOf;
                if (roundFits(spots, line[nearestTo(line, stop)], cavity.floorMm))
                    break;
            }
            return stop;
        };
        cavity.strokes.insert(cavity.strokes.begin(), stroke(line, mesialStop ? stopAt(true, mesialEnd) : mesialEnd,
                                                             distalStop ? stopAt(false, distalEnd) : distalEnd));
        for (const bool mesial : {true, false})
            if (boxIs(mesial))
                openInto(cavity, line[nearestTo(line, mesial ? mesialEnd : distalEnd)], mesial);
        if (mesialStop)
            addBar(true, mesialEnd);
        if (distalStop)
            addBar(false, distalEnd);
        return {};
    }

    /// Plans a box at the contact. The depth of its floor is measured from the marginal ridge.
    void planSlot(bool mesial)
    {
        constexpr double kRidgeEndsMm = 2.5;  // distance from the proximal surface
        OcclusalCavity cavity;
        cavity.box = squareBoxAt(contact(mesial).y, mesial);
        cavity.floorMm = mouth(cavity.box->atMm);
        for (double in = 0.0; in <= kRidgeEndsMm; in += kStepMm)
            cavity.floorMm = std::max(cavity.floorMm, mouth(cavity.box->atMm - cavity.box->outwards * in));
        add(std::move(cavity));
    }

    Status planCentralGroove()
    {
        Lobes buccal;
        Lobes lingual;
        Lobes mesialRidge;
        Lobes distalRidge;
        switch (m_fdi) {
        case 36:
            buccal = lobes({1, 2, 3});
            lingual = lobes({4, 5});
            mesialRidge = lobes({6});
            distalRidge = lobes({7});
            break;
        case 37:
            buccal = lobes({1, 2});
            lingual = lobes({3, 4});
            mesialRidge = lobes({5});
            distalRidge = lobes({6});
            break;
        case 35:
            buccal = lobes({1});
            lingual = lobes({2, 3});
            mesialRidge = lobes({4});
            distalRidge = lobes({5});
            break;
        default:  // 24, 25
            buccal = lobes({1});
            lingual = lobes({2});
            mesialRidge = m_fdi == 24 ? lobes({3, 4}) : lobes({3});
            distalRidge = lobes({m_fdi == 24 ? 5 : 4});
        }
        const Line groove = grooveAlongU(lingual, buccal, -6.0, 6.0);
        if (groove.size() < 10)
            return noRoom("central groove", "none: the tooth has no such groove");
        Lobes cusps = buccal;
        cusps.insert(cusps.end(), lingual.begin(), lingual.end());
        const double mesialPit = pitTowards(groove, cusps, mesialRidge, true, 0.0);
        const double distalPit = pitTowards(groove, cusps, distalRidge, false, 0.0);
        const Line line = smoothed(groove, kSmoothMm);
        OcclusalCavity cavity;
        cavity.floorMm = floorBelow(line, mesialPit, distalPit);
        if (Status done = finishMain(cavity, line, mesialPit, distalPit, true, true); !done)
            return done;
        if (m_kind == Kind::ClassOneBuccal)
            openToCheek(cavity, line, lobes({1}), lobes({2}), mesialPit, distalPit);
        else if (m_fdi == 36 || m_fdi == 37)
            extend(cavity, line, lobes({1}), lobes({2}), true, mesialPit, distalPit);
        if (m_fdi == 36) {
            extend(cavity, line, lobes({2}), lobes({3}), true, mesialPit, distalPit);
            extend(cavity, line, lobes({4}), lobes({5}), false, mesialPit, distalPit);
        } else if (m_fdi == 37) {
            extend(cavity, line, lobes({3}), lobes({4}), false, mesialPit, distalPit);
        } else if (m_fdi == 35 && !lobes({3}).empty()) {
            extend(cavity, line, lobes({2}), lobes({3}), false, mesialPit, distalPit);
        }
        placeIsthmus(cavity);
        add(std::move(cavity));
        return {};
    }

    /// Plans the central fossa mesial of the oblique ridge, and the distal pit behind it.
    Status planUpperMolar()
    {
        const Lobes mesiobuccal = lobes({1});
        const Lobes mesiolingual = lobes({2}, -100.0, -1.5);
        const Lobes beyond = lobes({2}, -1.5, 100.0);  // oblique ridge and distobuccal cusp
        Line groove = grooveAlongU(mesiolingual, mesiobuccal, -6.0, 2.0);
        if (groove.size() < 10)
            return noRoom("central groove", "none: the tooth has no such groove");
        double centralPit = groove.back().x;
        for (const glm::dvec2& p : groove)
            if (p.x > -2.0 && height(beyond, p) >= height(mesiobuccal, p)) {
                centralPit = p.x;
                break;
            }
        const double mesialPit = pitTowards(groove, mesiobuccal, lobes({4}), true, centralPit);
        const Line line = smoothed(groove, kSmoothMm);
        OcclusalCavity cavity;
        cavity.floorMm = floorBelow(line, mesialPit, centralPit);
        if (!boxIs(false)) {
            if (Status done = finishMain(cavity, line, mesialPit, centralPit, true, false); !done)
                return done;
            extend(cavity, line, mesiobuccal, beyond, true, mesialPit, centralPit + 1.0);
            placeIsthmus(cavity);
            add(std::move(cavity));
        }
        return boxIs(true) ? Status() : planDistalPit();
    }

    Status planDistalPit()
    {
        const Lobes ridge = lobes({2});
        const Lobes distolingual = lobes({3});
        const Lobes distalRidge = lobes({5});
        Lobes behind = distolingual;
        behind.insert(behind.end(), distalRidge.begin(), distalRidge.end());
        const Line groove = grooveAlongV(ridge, behind, -3.0, 2.0, 2.0);
        if (groove.size() < 10)
            return noRoom("distal pit", "none: the tooth has no such groove");
        // The place where the grooves on both sides of the distolingual cusp meet. A small cusp has no such place.
        std::optional<std::size_t> pit;
        for (std::size_t k = 0; k < groove.size(); ++k)
            if (!distolingual.empty() && height(distalRidge, groove[k]) < height(distolingual, groove[k]))
                pit = k;
        if (!pit)
            pit = pitOf(groove);
        if (!pit)
            return noRoom("distal pit", "none: the groove lies beside the occlusal table");
        const double lingually = 0.5 * m_design.isthmusMm + m_design.grooveMm;
        return planShort(groove, *pit, lingually, 0.5 * m_design.isthmusMm + m_design.dovetailMm - m_radius,
                         "distal pit", false, {1.4, 0.0});
    }

    /// Plans two pits on either side of a transverse ridge.
    Status planTwoPits()
    {
        constexpr double kLingualV = -2.2;
        constexpr double kBuccalV = 1.5;
        constexpr double kInwardsMm = 0.04;
        constexpr int kMostSteps = 40;
        for (const bool mesial : {true, false}) {
            if (m_kind != Kind::ClassOne && !boxIs(mesial))
                continue;
            const Lobes cusps = lobes({1});
            const Lobes ridge = lobes({mesial ? 3 : 4});
            Line groove = mesial ? grooveAlongV(ridge, cusps, kLingualV, kBuccalV, -2.0)
                                 : grooveAlongV(cusps, ridge, kLingualV, kBuccalV, 2.0);
            if (groove.size() < 10)
                return noRoom("pits", "none: the tooth has no such groove");
            // If the groove is beside the table, its line is moved inwards to where the table begins.
            std::optional<std::size_t> pit = pitOf(groove);
            for (int step = 0; !pit && step < kMostSteps; ++step) {
                for (glm::dvec2& p : groove)
                    p.x += mesial ? kInwardsMm : -kInwardsMm;
                pit = pitOf(groove);
            }
            if (!pit)
                return noRoom("pits", "none: the groove lies beside the occlusal table");
            // The stroke is longer towards the cheek, because the lingual cusp is small.
            const double half = 0.5 * m_design.isthmusMm + m_design.dovetailMm - m_radius;
            if (Status done = planShort(groove, *pit, 0.5 * half, 1.5 * half, mesial ? "mesial pit" : "distal pit",
                                        mesial, {1.6, 1.35});
                !done)
                return done;
        }
        return {};
    }

    /// The distance by which a short stroke is moved from its pit.
    struct Shift
    {
        double inwardsMm = 0.0;  ///< away from the marginal ridge
        double buccalMm = 0.0;
    };

    /// Plans a short stroke across the tooth through a pit. It is moved away from the marginal ridge so far that the
    /// ridge retains its width.
    /// @param lingualMm, buccalMm  range of the axis on either side of the pit
    /// @param most  largest shift: a transverse ridge behind the stroke has to retain its width as well
    Status planShort(const Line& groove, std::size_t pit, double lingualMm, double buccalMm, const char* name,
                     bool mesial, Shift most)
    {
        Line line = smoothed(groove, kSmoothMm);
        const double pitV = line[pit].y;
        std::erase_if(line, [&](const glm::dvec2& p) { return p.y < pitV - lingualMm || p.y > pitV + buccalMm; });
        OcclusalCavity cavity;
        double sum = 0.0;
        for (const glm::dvec2& p : line)
            sum += mouth(p);
        cavity.floorMm = std::min(sum / static_cast<double>(line.size()), mouth(groove[pit])) - m_design.depthMm;
        // The possible changes of its position and shape, smallest first.
        struct Change
        {
            double shift;
            double cheekwards;
            double lingually;  ///< shorter
            double buccally;
            double half;
            [[nodiscard]] double cost(double wide) const
            {
                return shift + cheekwards + 0.6 * (lingually + buccally) + wide - half;
            }
        };
        std::vector<Change> changes;
        for (double shift = 0.0; shift <= most.inwardsMm; shift += 0.08)
            for (double cheekwards = 0.0; cheekwards <= most.buccalMm; cheekwards += 0.15)
                for (double lingually = 0.0; lingually <= lingualMm; lingually += 0.12)
                    for (double buccally = 0.0; buccally <= buccalMm; buccally += 0.12)
                        for (const double half : {m_half, 0.5 * m_half, 0.0})
                            changes.push_back({shift, cheekwards, lingually, buccally, half});
        std::stable_sort(changes.begin(), changes.end(),
                         [&](const Change& a, const Change& b) { return a.cost(m_half) < b.cost(m_half); });
        for (const Change& change : changes) {
            std::vector<Spot> spots;
            bool fit = true;
            for (const glm::dvec2& p : line)
                if (p.y >= pitV - lingualMm + change.lingually && p.y <= pitV + buccalMm - change.buccally && fit) {
                    spots.push_back(
                        {p + glm::dvec2{mesial ? change.shift : -change.shift, change.cheekwards}, change.half});
                    fit = fits(spots.back(), cavity.floorMm);
                }
            if (spots.empty() || !fit)
                continue;
            finishShort(cavity, std::move(spots), mesial);
            add(std::move(cavity));
            return {};
        }
        return noRoom(name, "ridge_mm, oblique_mm, isthmus_mm, dovetail_mm");
    }

    /// Continues a short stroke into the box of a Class II, or gives its end a leaning wall.
    void finishShort(OcclusalCavity& cavity, std::vector<Spot> spots, bool mesial) const
    {
        if (boxIs(mesial)) {
            openInto(cavity, spots[spots.size() / 2].atMm, mesial);
        } else {
            double end = spots.front().atMm.x;
            for (const Spot& spot : spots)
                end = mesial ? std::max(end, spot.atMm.x) : std::min(end, spot.atMm.x);
            (mesial ? cavity.mesialEndX : cavity.distalEndX) = end;
        }
        cavity.strokes.push_back(std::move(spots));
    }

    /// Places the isthmus on the main stroke, as far as possible from all other strokes. There the stroke has the
    /// design width.
    static void placeIsthmus(OcclusalCavity& cavity)
    {
        const std::vector<Spot>& main = cavity.strokes.front();
        const std::size_t aside = std::min<std::size_t>(8, main.size() / 4);
        std::size_t best = main.size() / 2;
        double furthest = 0.0;
        for (std::size_t k = aside; k + aside < main.size(); ++k) {
            double away = std::numeric_limits<double>::max();
            for (std::size_t n = 1; n < cavity.strokes.size(); ++n)
                for (const Spot& spot : cavity.strokes[n])
                    away = std::min(away, glm::distance(spot.atMm, main[k].atMm));
            if (away > furthest) {
                furthest = away;
                best = k;
            }
        }
        const glm::dvec2 along = glm::normalize(main[std::min(best + aside, main.size() - 1)].atMm -
                                                main[best - std::min(best, aside)].atMm);
        cavity.isthmus =
            OcclusalCavity::Isthmus{main[best].atMm, {-along.y, along.x}, kStepMm * static_cast<double>(aside)};
    }

    /// Adds a cavity to the result, in the tooth frame.
    void add(OcclusalCavity cavity)
    {
        for (std::vector<Spot>& spots : cavity.strokes)
            for (Spot& spot : spots)
                spot.atMm = tooth(spot.atMm);
        if (cavity.isthmus) {
            cavity.isthmus->atMm = tooth(cavity.isthmus->atMm);
            cavity.isthmus->across = tooth(cavity.isthmus->across);
        }
        if (cavity.box) {
            cavity.box->atMm = tooth(cavity.box->atMm);
            cavity.box->outwards = tooth(cavity.box->outwards);
        }
        m_cavities.push_back(std::move(cavity));
    }

    Kind m_kind;
    int m_fdi;
    const teeth::PosteriorForm& m_form;
    const ToothDesign& m_design;
    double m_radius;
    double m_half;  ///< range of the axis beside the groove in the main stroke
    Line m_silhouette;
    Line m_mesial;  ///< part of the silhouette: the proximal surfaces
    Line m_distal;
    Line m_crest;
    std::vector<OcclusalCavity> m_cavities;
};

}  // namespace

Result<std::vector<OcclusalCavity>> occlusalCavities(Kind kind, int fdi, const teeth::PosteriorForm& form,
                                                     const ToothDesign& design)
{
    return Planner(kind, fdi, form, design).plan();
}

double roundJoin(double a, double b)
{
    const double gap = std::max(kRoundReachMm - std::abs(a - b), 0.0);
    return std::min(a, b) - gap * gap / (4.0 * kRoundReachMm);
}

std::vector<glm::dvec2> obliqueCrest(int fdi, const teeth::PosteriorForm& form)
{
    if (fdi != 26 && fdi != 27)
        return {};
    // Tips of the mesiolingual cusp, the ridge and the distobuccal cusp, lingual first.
    std::vector<glm::dvec2> tips;
    for (const teeth::Lobe& lobe : form.crown.design().lobes)
        if (lobe.group == 2)
            tips.emplace_back(lobe.x, lobe.y);
    std::sort(tips.begin(), tips.end(), [](glm::dvec2 a, glm::dvec2 b) { return a.y < b.y; });
    Line crest;
    for (std::size_t k = 0; k + 1 < tips.size(); ++k) {
        const glm::dvec2 from = form.toTooth(tips[k]);
        const glm::dvec2 to = form.toTooth(tips[k + 1]);
        const glm::dvec2 along = glm::normalize(to - from);
        const int steps = static_cast<int>(glm::length(to - from) / kStepMm);
        for (int n = 0; n < steps; ++n) {
            // The ridge is not straight between its tips, so its highest place beside the line counts.
            const glm::dvec2 middle = from + along * (kStepMm * n);
            glm::dvec2 highest = middle;
            for (double aside = -0.6; aside <= 0.6; aside += 0.02) {
                const glm::dvec2 p = middle + glm::dvec2{-along.y, along.x} * aside;
                if (form.mouthMm(p) > form.mouthMm(highest))
                    highest = p;
            }
            crest.push_back(highest);
        }
    }
    return smoothed(crest, 0.3);
}

}  // namespace core::preparation
