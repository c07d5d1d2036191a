// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "core/bur/Reach.h"
#include "core/grading/Measures.h"
#include "core/imaging/Canals.h"
#include "core/imaging/Radiograph.h"
#include "core/preparation/ToothPreparation.h"
#include "core/teeth/Lattice.h"
#include "core/teeth/ToothGenerator.h"
#include "tests/support/Checks.h"
#include "tests/support/Scenes.h"
#include "tests/support/Suite.h"
#include "tests/support/SyntheticTooth.h"
#include "tests/support/Tables.h"

using namespace core;
using namespace core::terrain;
using grading::Part;
using preparation::Kind;
using support::between;

/// Checks the values of docs/teeth.md by measuring generated teeth with their tissues, not by reading their design.
class TestToothAnatomy : public QObject
{
    Q_OBJECT

    using Cusp = teeth::Cusp;
    using Anatomy = std::shared_ptr<const ToothAnatomy>;

    static Anatomy tooth(int fdi, int seed) { return support::soundTooth(fdi, 150, static_cast<std::uint64_t>(seed)); }

    static teeth::PosteriorForm formOf(int fdi, int seed)
    {
        return teeth::posteriorForm(fdi, static_cast<std::uint64_t>(seed)).value();
    }

    /// Adds a row for each of the ten seeds.
    static void addSeeds() { support::rows<int>("seed", {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}); }

    static double topAt(const ToothAnatomy& anatomy, std::size_t k) { return static_cast<double>(anatomy.top[k]); }

    /// Returns the highest point of the surface within `reachMm` of a place.
    static glm::dvec3 highestNear(const ToothAnatomy& anatomy, glm::dvec2 place, double reachMm)
    {
        glm::dvec3 best(place, -1.0e9);
        support::eachNode(anatomy.grid, [&](std::size_t k, const glm::dvec2& at) {
            if (glm::distance(at, place) <= reachMm && topAt(anatomy, k) > best.z)
                best = glm::dvec3(at, topAt(anatomy, k));
        });
        return best;
    }

    /// Returns the tip of each cusp of a posterior tooth, found on the map near its place in the design.
    static std::map<Cusp, glm::dvec3> tipsOf(int fdi, int seed)
    {
        const teeth::PosteriorForm form = formOf(fdi, seed);
        std::map<Cusp, glm::dvec3> tips;
        for (const teeth::Lobe& lobe : form.crown.design().lobes)
            if (lobe.cusp != Cusp::None)
                tips[lobe.cusp] = highestNear(*tooth(fdi, seed), form.toTooth({lobe.x, lobe.y}), 0.8);
        return tips;
    }

    /// Returns the surface after filling everything narrower than twice the radius.
    static std::vector<float> filled(const ToothAnatomy& anatomy, double radiusMm)
    {
        const teeth::Lattice lattice(anatomy.grid, anatomy.grid.cellMm);
        return lattice.close(lattice.pick(anatomy.top, kEmptyTop), radiusMm, kEmptyTop);
    }

    /// Returns how far each column is inside the outline of the tooth.
    static std::vector<float> insideMm(const ToothAnatomy& anatomy)
    {
        std::vector<std::uint8_t> solid(anatomy.top.size());
        for (std::size_t k = 0; k < solid.size(); ++k)
            solid[k] = anatomy.top[k] > anatomy.bottom[k] ? 1 : 0;
        return teeth::distanceInside(anatomy.grid, solid);
    }

    /// Returns the lowest point of a map within 1.5 mm of the middle of the tooth.
    static glm::dvec3 lowestInTheMiddle(const ToothAnatomy& anatomy, const std::vector<float>& map)
    {
        glm::dvec3 lowest(0.0, 0.0, 1.0e9);
        support::eachNode(anatomy.grid, [&](std::size_t k, const glm::dvec2& at) {
            if (glm::length(at) < 1.5 && static_cast<double>(map[k]) < lowest.z)
                lowest = glm::dvec3(at, static_cast<double>(map[k]));
        });
        return lowest;
    }

    static double distanceToPulp(const ToothAnatomy& anatomy, const glm::dvec3& from)
    {
        double nearest = 1.0e9;
        support::eachNode(anatomy.grid, [&](std::size_t k, const glm::dvec2& at) {
            if (hasPulp(anatomy, k))
                nearest = std::min(nearest, std::hypot(glm::distance(at, glm::dvec2(from)),
                                                       from.z - static_cast<double>(anatomy.layers[k].pulpRoof)));
        });
        return nearest;
    }

    static grading::Preparation idealOf(Kind kind, const ToothAnatomy& anatomy)
    {
        return preparation::makePreparation(kind, preparation::fittedDesign(kind, anatomy).value(), anatomy).value();
    }

    /// Returns the number of islands of columns for which `isIn` is true.
    template <class IsIn>
    static int islands(const Grid& grid, IsIn&& isIn)
    {
        std::vector<std::uint8_t> left(grid.count());
        for (std::size_t k = 0; k < left.size(); ++k)
            left[k] = isIn(k) ? 1 : 0;
        int count = 0;
        for (std::size_t start = 0; start < left.size(); ++start) {
            if (left[start] == 0)
                continue;
            ++count;
            std::vector<std::size_t> open{start};
            while (!open.empty()) {
                const int i = static_cast<int>(open.back()) % grid.side;
                const int j = static_cast<int>(open.back()) / grid.side;
                open.pop_back();
                // A canal that is one column wide somewhere may be interrupted by a few columns.
                support::Nodes beside = support::around(grid, i, j, 4);
                support::eachOf(grid, beside, [&](std::size_t k) {
                    if (std::exchange(left[k], 0) != 0)
                        open.push_back(k);
                });
            }
        }
        return count;
    }

    static QString shown(double value) { return QString::number(value, 'f', 2); }

private slots:
    void cuspsKeepTheirOrderOfHeight_data()
    {
        QTest::addColumn<int>("fdi");
        for (const int fdi : {24, 25, 26, 27, 28, 34, 35, 36, 37, 38})
            QTest::addRow("%d", fdi) << fdi;
    }

    void cuspsKeepTheirOrderOfHeight()
    {
        QFETCH(int, fdi);
        const std::vector<Cusp> premolar{Cusp::B, Cusp::L};
        const std::vector<Cusp> upperMolar{Cusp::ML, Cusp::MB, Cusp::DB, Cusp::DL};
        const std::vector<Cusp> lowerMolar{Cusp::ML, Cusp::MB, Cusp::DL, Cusp::DB, Cusp::D};
        for (int seed = 0; seed < 10; ++seed) {
            const std::map<Cusp, glm::dvec3> tips = tipsOf(fdi, seed);
            std::vector<Cusp> order = fdi % 10 < 6 ? premolar : fdi < 30 ? upperMolar : lowerMolar;
            if (fdi == 35 && !tips.contains(Cusp::L))
                order = {Cusp::B, Cusp::ML, Cusp::DL};
            // The distal or distolingual cusp may be missing in a variant.
            std::erase_if(order, [&](Cusp cusp) { return !tips.contains(cusp); });
            QCOMPARE(order.size(), tips.size());
            for (std::size_t k = 0; k + 1 < order.size(); ++k)
                QVERIFY2(tips.at(order[k]).z > tips.at(order[k + 1]).z,
                         qPrintable(QString("%1 seed %2: cusp %3").arg(fdi).arg(seed).arg(k)));
            QVERIFY(support::near(tips.at(order.front()).z, 0.0, 0.05));
        }
    }

    void distalCuspOf36IsTheLowest_data() { addSeeds(); }

    void distalCuspOf36IsTheLowest()
    {
        QFETCH(int, seed);
        const auto tips = tipsOf(36, seed);
        const double below = tips.at(Cusp::ML).z - tips.at(Cusp::D).z;
        QVERIFY2(between(below, 0.7, 0.9), qPrintable(shown(below)));
    }

    void mesiobuccalCuspOf36HasNoDimple_data() { addSeeds(); }

    /// The buccal slope of the cusp, from 0.6 mm mesial of its tip to the buccal groove, has no hollow.
    void mesiobuccalCuspOf36HasNoDimple()
    {
        QFETCH(int, seed);
        const Anatomy anatomy = tooth(36, seed);
        const glm::dvec3 tip = tipsOf(36, seed).at(Cusp::MB);
        const std::vector<float> full = filled(*anatomy, 0.5);
        const std::vector<float> inside = insideMm(*anatomy);
        const double buccal = teeth::buccalSign(36);
        double deepest = 0.0;
        support::eachNode(anatomy->grid, [&](std::size_t k, const glm::dvec2& at) {
            const double out = buccal * (at.y - tip.y);
            if (between(at.x - tip.x, -1.0, 1.2) && out > -0.3 && inside[k] > 1.1F)
                deepest = std::max(deepest, static_cast<double>(full[k] - anatomy->top[k]));
        });
        QVERIFY2(deepest < 0.06, qPrintable(shown(deepest)));
    }

    void centralFossaOf36IsFarFromThePulp_data() { addSeeds(); }

    /// A distance of 4.35 mm was measured on a molar with a shallow fissure. The distances from the mouth and from the
    /// base of the generated fissure must enclose it.
    void centralFossaOf36IsFarFromThePulp()
    {
        QFETCH(int, seed);
        const Anatomy anatomy = tooth(36, seed);
        const double mouth = distanceToPulp(*anatomy, lowestInTheMiddle(*anatomy, filled(*anatomy, 0.35)));
        const double base = distanceToPulp(*anatomy, lowestInTheMiddle(*anatomy, anatomy->top));
        QVERIFY2(between(mouth, 4.35, 4.95) && between(base, 3.65, 4.35), qPrintable(shown(mouth) + ' ' + shown(base)));
    }

    void chamberOf36IsWideAndMesial_data() { addSeeds(); }

    void chamberOf36IsWideAndMesial()
    {
        QFETCH(int, seed);
        const Anatomy anatomy = tooth(36, seed);
        double roof = -1.0e9;
        for (std::size_t k = 0; k < anatomy->top.size(); ++k)
            if (hasPulp(*anatomy, k))
                roof = std::max(roof, static_cast<double>(anatomy->layers[k].pulpRoof));
        double mesial = 1.0e9;
        double distal = -1.0e9;
        double sum = 0.0;
        double count = 0.0;
        support::eachNode(anatomy->grid, [&](std::size_t k, const glm::dvec2& at) {
            if (!hasPulp(*anatomy, k) || static_cast<double>(anatomy->layers[k].pulpRoof) < roof - 2.0)
                return;
            mesial = std::min(mesial, at.x);
            distal = std::max(distal, at.x);
            sum += at.x;
            count += 1.0;
        });
        const double share =
            (distal - mesial) / teeth::drawToothSizes(36, static_cast<std::uint64_t>(seed))->cervixWidthMm;
        // 1.5 mm of dentin mesially and 2.5 mm distally leave 0.55 of the mean neck, and less of a small one.
        QVERIFY2(share > 0.45, qPrintable(shown(share)));
        QVERIFY2(between(sum / count, -1.2, -0.7), qPrintable(shown(sum / count)));
    }

    void hornsOf36LieUnderItsCusps_data() { addSeeds(); }

    /// The roof rises towards each of the four large cusps, most towards the two mesial ones.
    void hornsOf36LieUnderItsCusps()
    {
        QFETCH(int, seed);
        const Anatomy anatomy = tooth(36, seed);
        const auto tips = tipsOf(36, seed);
        // The height of the plain roof: the median of the chamber's columns.
        std::vector<float> roofs;
        for (std::size_t k = 0; k < anatomy->top.size(); ++k)
            if (hasPulp(*anatomy, k))
                roofs.push_back(anatomy->layers[k].pulpRoof);
        std::nth_element(roofs.begin(), roofs.begin() + static_cast<std::ptrdiff_t>(roofs.size() / 2), roofs.end());
        const auto plain = static_cast<double>(roofs[roofs.size() / 2]);
        const auto hornUnder = [&](const glm::dvec3& tip) {
            double away = 1.0e9;
            support::eachNode(anatomy->grid, [&](std::size_t k, const glm::dvec2& at) {
                if (hasPulp(*anatomy, k))
                    away = std::min(away, glm::distance(at, glm::dvec2(tip)));
            });
            double highest = -1.0e9;
            support::eachNode(anatomy->grid, [&](std::size_t k, const glm::dvec2& at) {
                if (hasPulp(*anatomy, k) && glm::distance(at, glm::dvec2(tip)) < away + 0.8)
                    highest = std::max(highest, static_cast<double>(anatomy->layers[k].pulpRoof));
            });
            return highest;
        };
        std::map<Cusp, double> horns;
        for (const Cusp cusp : {Cusp::MB, Cusp::ML, Cusp::DB, Cusp::DL})
            horns[cusp] = hornUnder(tips.at(cusp));
        for (const auto& [cusp, horn] : horns)
            QVERIFY2(horn > plain + 0.1, qPrintable(shown(horn - plain)));
        QVERIFY(std::max(horns[Cusp::MB], horns[Cusp::ML]) > std::max(horns[Cusp::DB], horns[Cusp::DL]));
    }

    void idealClassOneOf36SparesThePulp_data() { addSeeds(); }

    void idealClassOneOf36SparesThePulp()
    {
        QFETCH(int, seed);
        const Anatomy anatomy = tooth(36, seed);
        const double left =
            grading::measure(restored(anatomy, *idealOf(Kind::ClassOne, *anatomy).top)).remainingOverPulpMm;
        QVERIFY2(left > 2.0, qPrintable(shown(left)));
    }

    void accessOf36IsATrapezoidInTheMesialHalf_data() { addSeeds(); }

    void accessOf36IsATrapezoidInTheMesialHalf()
    {
        QFETCH(int, seed);
        const Anatomy anatomy = tooth(36, seed);
        const grading::Preparation ideal = idealOf(Kind::Access, *anatomy);
        const Grid& grid = anatomy->grid;
        std::map<int, int> heights;  // of the opening, by column of the grid
        double sum = 0.0;
        double mesial = 0.0;
        double count = 0.0;
        support::eachNode(grid, [&](std::size_t k, const glm::dvec2& at) {
            if (ideal.parts[k] == Part::Keep)
                return;
            ++heights[static_cast<int>(k) % grid.side];
            sum += at.x;
            mesial += at.x < 0.0 ? 1.0 : 0.0;
            count += 1.0;
        });
        const int first = heights.begin()->first;
        const int last = heights.rbegin()->first;
        const auto widthAt = [&](double share) {
            return grid.cellMm * heights[first + static_cast<int>(std::lround(share * (last - first)))];
        };
        QVERIFY2(widthAt(0.2) > widthAt(0.8) + 0.4, qPrintable(shown(widthAt(0.2)) + ' ' + shown(widthAt(0.8))));
        QVERIFY2(sum / count < -0.7, qPrintable(shown(sum / count)));
        QVERIFY2(mesial / count > 0.6, qPrintable(shown(mesial / count)));
    }

    void canalsOf36GoToTheApex_data() { addSeeds(); }

    void canalsOf36GoToTheApex()
    {
        QFETCH(int, seed);
        const Anatomy model = tooth(36, seed);
        const Anatomy pictured = imaging::withCanals(Tooth(model)).anatomy;
        const auto canalsAt = [&](double height) {
            return islands(model->grid, [&](std::size_t k) {
                return hasPulp(*pictured, k) && static_cast<double>(pictured->layers[k].pulpRoof) > height &&
                       static_cast<double>(pictured->layers[k].pulpFloor) < height;
            });
        };
        const auto lowest = static_cast<double>(*std::min_element(model->bottom.begin(), model->bottom.end()));
        // Two canals in the mesial root and one in the distal root, which is slightly shorter.
        for (double height = lowest + 3.0; height < core::bur::lowestTipMm(*model) - 2.0; height += 0.5)
            QCOMPARE(canalsAt(height), 3);
        QVERIFY(canalsAt(lowest + 1.7) >= 1);
    }

    void mesialGrooveOf24CrossesTheRidge_data() { addSeeds(); }

    /// From the mesial fossa to 0.8 mm before the outline, each slice across the tooth has a furrow.
    void mesialGrooveOf24CrossesTheRidge()
    {
        QFETCH(int, seed);
        const Anatomy anatomy = tooth(24, seed);
        const Grid& grid = anatomy->grid;
        const std::vector<float> full = filled(*anatomy, 0.35);
        const double half = 0.5 * teeth::drawToothSizes(24, static_cast<std::uint64_t>(seed))->crownWidthMm;
        double shallowest = 1.0e9;
        for (int i = 0; i < grid.side; ++i) {
            const double x = grid.nodeMm(i, 0).x;
            if (!between(x, 0.9 - half, 1.6 - half))
                continue;
            double deepest = 0.0;
            for (int j = 0; j < grid.side; ++j)
                if (std::abs(grid.nodeMm(i, j).y) < 1.3)
                    deepest =
                        std::max(deepest, static_cast<double>(full[grid.index(i, j)] - anatomy->top[grid.index(i, j)]));
            shallowest = std::min(shallowest, deepest);
        }
        QVERIFY2(shallowest > 0.1, qPrintable(shown(shallowest)));
    }

    void outlineOf24IsAHexagon_data() { addSeeds(); }

    /// The largest hexagon with its corners on an oval covers 0.83 of it.
    void outlineOf24IsAHexagon()
    {
        QFETCH(int, seed);
        constexpr int kPoints = 72;
        const std::vector<glm::dvec2> outline = formOf(24, seed).outline(kPoints);
        const auto cross = [&](int a, int b) {
            const glm::dvec2 p = outline[static_cast<std::size_t>(a)];
            const glm::dvec2 q = outline[static_cast<std::size_t>(b)];
            return 0.5 * std::abs(p.x * q.y - p.y * q.x);
        };
        double whole = 0.0;
        for (int k = 0; k < kPoints; ++k)
            whole += cross(k, (k + 1) % kPoints);
        // Finds the best corners one after another: the areas of the triangles with the middle add up.
        double best = 0.0;
        for (int first = 0; first < kPoints / 6 + 3; ++first) {
            std::vector<double> most(kPoints + 1, -1.0);
            most[0] = 0.0;
            for (int side = 0; side < 6; ++side) {
                std::vector<double> next(kPoints + 1, -1.0);
                for (int a = 0; a <= kPoints; ++a)
                    for (int b = a + 1; b <= kPoints && most[static_cast<std::size_t>(a)] >= 0.0; ++b)
                        if (side < 5 || b == kPoints)
                            next[static_cast<std::size_t>(b)] =
                                std::max(next[static_cast<std::size_t>(b)],
                                         most[static_cast<std::size_t>(a)] +
                                             cross((first + a) % kPoints, (first + b) % kPoints));
                most = std::move(next);
            }
            best = std::max(best, most[kPoints]);
        }
        QVERIFY2(best / whole > 0.9, qPrintable(shown(best / whole)));
    }

    void pitOf22IsLingual_data() { addSeeds(); }

    /// There is no hollow at the edge or on the labial side, and one above the cingulum.
    void pitOf22IsLingual()
    {
        QFETCH(int, seed);
        const Anatomy anatomy = tooth(22, seed);
        const std::vector<float> full = filled(*anatomy, 0.4);
        const std::vector<float> inside = insideMm(*anatomy);
        const double height = teeth::drawToothSizes(22, static_cast<std::uint64_t>(seed))->crownHeightMm;
        const double labial = teeth::buccalSign(22);
        const glm::dvec3 edge = highestNear(*anatomy, {0.0, 0.0}, 9.0);
        double onEdge = 0.0;
        double lingual = 0.0;
        support::eachNode(anatomy->grid, [&](std::size_t k, const glm::dvec2& at) {
            const auto depth = static_cast<double>(full[k] - anatomy->top[k]);
            if (labial * (at.y - edge.y) > -0.3 && inside[k] > 0.9F)
                onEdge = std::max(onEdge, depth);
            if (labial * (at.y - edge.y) < -1.5 && std::abs(at.x) < 1.0 &&
                between(topAt(*anatomy, k), -0.78 * height, -0.5 * height))
                lingual = std::max(lingual, depth);
        });
        QVERIFY2(onEdge < 0.05, qPrintable(shown(onEdge)));
        QVERIFY2(lingual > 0.1, qPrintable(shown(lingual)));
    }

    void rootOf38HasNoSlit_data() { addSeeds(); }

    /// The underside is nowhere more than a millimetre higher than at places 0.6 mm to either side.
    void rootOf38HasNoSlit()
    {
        QFETCH(int, seed);
        const Anatomy anatomy = tooth(38, seed);
        const Grid& grid = anatomy->grid;
        const int aside = static_cast<int>(std::lround(0.6 / grid.cellMm));
        double deepest = 0.0;
        for (int j = aside; j < grid.side - aside; ++j)
            for (int i = aside; i < grid.side - aside; ++i)
                for (const auto& [di, dj] : {std::pair(aside, 0), {0, aside}}) {
                    const std::size_t k = grid.index(i, j);
                    const std::size_t a = grid.index(i - di, j - dj);
                    const std::size_t b = grid.index(i + di, j + dj);
                    const auto isSolid = [&](std::size_t n) { return anatomy->top[n] > anatomy->bottom[n]; };
                    if (isSolid(k) && isSolid(a) && isSolid(b))
                        deepest =
                            std::max(deepest, static_cast<double>(anatomy->bottom[k] -
                                                                  std::max(anatomy->bottom[a], anatomy->bottom[b])));
                }
        QVERIFY2(deepest < 1.0, qPrintable(shown(deepest)));
    }

    void incisalEnamelIsTwoMillimetres_data()
    {
        support::rows<int, int>("fdi", {21, 22, 31, 32}, "seed", {0, 1, 2, 3, 4, 5, 6, 7, 8, 9});
    }

    void incisalEnamelIsTwoMillimetres()
    {
        QFETCH(int, fdi);
        QFETCH(int, seed);
        const Anatomy anatomy = tooth(fdi, seed);
        const Grid& grid = anatomy->grid;
        double sum = 0.0;
        double count = 0.0;
        for (int i = 0; i < grid.side; ++i) {
            if (std::abs(grid.nodeMm(i, 0).x) > 1.2)
                continue;
            std::size_t edge = grid.index(i, 0);
            for (int j = 0; j < grid.side; ++j)
                if (anatomy->top[grid.index(i, j)] > anatomy->top[edge])
                    edge = grid.index(i, j);
            sum += topAt(*anatomy, edge) - static_cast<double>(anatomy->layers[edge].dej);
            count += 1.0;
        }
        // People differ by a tenth of a millimetre.
        QVERIFY2(between(sum / count, 1.7, 2.3), qPrintable(shown(sum / count)));
    }

    void marginalRidgesOf34AreKept_data() { addSeeds(); }

    void marginalRidgesOf34AreKept()
    {
        QFETCH(int, seed);
        const Anatomy anatomy = tooth(34, seed);
        const auto design = preparation::fittedDesign(Kind::ClassOne, *anatomy);
        QVERIFY(support::succeeds(design));
        QCOMPARE(design->ridgeMm, 1.6);
        const grading::Preparation ideal = idealOf(Kind::ClassOne, *anatomy);
        double ridge = 1.0e9;
        for (const glm::dvec2& p : formOf(34, seed).outline(720))
            if (std::abs(p.x) > std::abs(p.y))
                support::eachNode(anatomy->grid, [&](std::size_t k, const glm::dvec2& at) {
                    if (ideal.parts[k] != Part::Keep)
                        ridge = std::min(ridge, glm::distance(p, at));
                });
        QVERIFY2(ridge > 1.59, qPrintable(shown(ridge)));
    }

    void filmsOfAllTeethAreExposedAlike_data() { support::rows<int>("fdi", {21, 22, 23, 24, 26, 31, 33, 34, 36, 38}); }

    /// The crown of a front tooth is as light on its film as that of a molar: an optical density of 1.3 to 1.6 of 3.0
    /// where the tooth weakens the beam most.
    void filmsOfAllTeethAreExposedAlike()
    {
        QFETCH(int, fdi);
        for (int seed = 0; seed < 10; ++seed) {
            const Tooth whole(tooth(fdi, seed));
            const imaging::XrayedTooth one{&whole};
            imaging::Shadow shadow =
                imaging::castShadow(std::span(&one, 1), {}, imaging::shadowArea(std::span(&one, 1), {}, 0.5), 0.1);
            std::erase_if(shadow.attenuation, [](float attenuation) { return attenuation < 0.05F; });
            std::sort(shadow.attenuation.begin(), shadow.attenuation.end());
            const auto crown = static_cast<double>(shadow.attenuation[shadow.attenuation.size() * 9 / 10]);
            const double quanta =
                imaging::kQuantaPerMm2 * 0.01 * imaging::usualExposure(*whole.anatomy, {}) * std::exp(-crown);
            const double density = imaging::opticalDensity(quanta, 0.1);
            QVERIFY2(between(density, 1.3, 1.6), qPrintable(shown(density)));
        }
    }
};

CUSP_TEST(TestToothAnatomy)
#include "tst_tooth_anatomy.moc"
