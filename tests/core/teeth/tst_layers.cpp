// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include <algorithm>
#include <cmath>

#include "core/teeth/Layers.h"
#include "tests/support/Checks.h"
#include "tests/support/Suite.h"
#include "tests/support/SyntheticTooth.h"
#include "tests/support/Tables.h"
#include "tests/support/ToothMaps.h"

using namespace core;
using namespace core::terrain;
using support::between;
using support::nodeAt;
using support::ToothMaps;
using support::volumesOf;

namespace {

std::vector<ColumnLayers> lay(const ToothMaps& maps, int fdi, std::uint64_t seed = 0,
                              teeth::LayerRule rule = teeth::LayerRule::Anatomical)
{
    return teeth::buildLayers(maps.grid, maps.top, maps.bottom, {rule, fdi, seed});
}

bool hasPulp(const ColumnLayers& column)
{
    return column.pulpRoof > column.pulpFloor;
}

/// Returns the shortest distance from the surface above node k to the dentin: the enamel thickness that a section
/// shows.
double enamelAt(const ToothMaps& maps, const std::vector<ColumnLayers>& layers, std::size_t k, double z)
{
    const Grid& grid = maps.grid;
    const int i0 = static_cast<int>(k % static_cast<std::size_t>(grid.side));
    const int j0 = static_cast<int>(k / static_cast<std::size_t>(grid.side));
    const int reach = static_cast<int>(4.0 / grid.cellMm);
    double nearest = 4.0;
    for (int j = std::max(0, j0 - reach); j <= std::min(grid.side - 1, j0 + reach); ++j) {
        for (int i = std::max(0, i0 - reach); i <= std::min(grid.side - 1, i0 + reach); ++i) {
            const std::size_t q = grid.index(i, j);
            const double aside = grid.cellMm * std::hypot(i - i0, j - j0);
            if (aside >= nearest || !maps.isSolid(q) || layers[q].dej <= maps.bottom[q])
                continue;
            const double above = std::max(0.0, z - static_cast<double>(layers[q].dej));
            nearest = std::min(nearest, std::hypot(aside, above));
        }
    }
    return nearest;
}

double of(const PerMaterial& volumes, Material material)
{
    return volumes[static_cast<std::size_t>(material)];
}

/// Checks the invariants of every tooth. Returns a description of the first column that breaks one, or an empty string.
QString brokenLayers(const ToothMaps& maps, const std::vector<ColumnLayers>& layers)
{
    const Grid& grid = maps.grid;
    if (layers.size() != grid.count())
        return QStringLiteral("wrong size");
    for (int j = 0; j < grid.side; ++j) {
        for (int i = 0; i < grid.side; ++i) {
            const std::size_t k = grid.index(i, j);
            const ColumnLayers& column = layers[k];
            const auto at = [&](const char* what) {
                return QStringLiteral("column %1, %2: %3").arg(i).arg(j).arg(what);
            };
            if (!maps.isSolid(k)) {
                if (column != ColumnLayers{})
                    return at("empty column with layers");
                continue;
            }
            if (!std::isfinite(column.dej) || !std::isfinite(column.pulpRoof) || !std::isfinite(column.pulpFloor))
                return at("not finite");
            if (column.cariesRoof > column.cariesFloor)
                return at("decay in a sound tooth");
            if (column.dej > maps.top[k])
                return at("junction above the surface");
            if (column.pulpFloor > column.pulpRoof)
                return at("floor above roof");
            if (hasPulp(column) && (column.pulpRoof >= column.dej || column.pulpFloor < maps.bottom[k]))
                return at("pulp outside dentin");
        }
    }
    return {};
}

/// Returns the least dentin between the pulp and anything else in any direction, mm, at most 3.
double leastDentin(const ToothMaps& maps, const std::vector<ColumnLayers>& layers)
{
    const Grid& grid = maps.grid;
    const int reach = static_cast<int>(std::ceil(1.6 / grid.cellMm));
    double least = 3.0;
    for (int j = 0; j < grid.side; ++j) {
        for (int i = 0; i < grid.side; ++i) {
            const ColumnLayers& pulp = layers[grid.index(i, j)];
            if (!hasPulp(pulp))
                continue;
            for (int nj = j - reach; nj <= j + reach; ++nj) {
                for (int ni = i - reach; ni <= i + reach; ++ni) {
                    const double aside = grid.cellMm * std::hypot(ni - i, nj - j);
                    if (aside >= least)
                        continue;
                    if (!grid.contains(ni, nj) || !maps.isSolid(grid.index(ni, nj))) {
                        least = std::min(least, aside);
                        continue;
                    }
                    const std::size_t q = grid.index(ni, nj);
                    const double over = static_cast<double>(layers[q].dej) - static_cast<double>(pulp.pulpRoof);
                    const double under = static_cast<double>(pulp.pulpFloor) - static_cast<double>(maps.bottom[q]);
                    least = std::min(
                        {least, std::hypot(aside, std::max(0.0, over)), std::hypot(aside, std::max(0.0, under))});
                }
            }
        }
    }
    return least;
}

}  // namespace

class TestLayers : public QObject
{
    Q_OBJECT

private slots:
    void enamelOfAMolarIsAsTheTableSays()
    {
        const ToothMaps maps = support::analyticMolar(150);
        const auto layers = lay(maps, 36);
        const auto thicknessOver = [&](double x, double y) {
            const std::size_t k = nodeAt(maps.grid, {x, y});
            return enamelAt(maps, layers, k, static_cast<double>(maps.top[k]));
        };
        for (const double sx : {-1.0, 1.0}) {
            for (const double sy : {-1.0, 1.0}) {
                QVERIFY(between(thicknessOver(2.5 * sx, 2.5 * sy), 2.2, 2.8));    // cusp tip
                QVERIFY(between(thicknessOver(1.75 * sx, 1.75 * sy), 1.7, 2.3));  // half way down the inner incline
            }
        }
        QVERIFY(between(thicknessOver(0.0, 2.8), 1.55, 1.95));  // fossa floor away from the fissure

        // The side wall must have t = 0.05 + 0.32 h. The wall of this crown is where its columns end.
        const double cervix = -7.5;
        for (const double height : {2.5, 3.0, 3.5, 4.0, 4.5}) {
            const double z = cervix + height;
            double nearest = 10.0;
            support::eachNode(maps.grid, [&](std::size_t k, const glm::dvec2& at) {
                if (!maps.isSolid(k) || layers[k].dej <= maps.bottom[k] || static_cast<double>(layers[k].dej) < z)
                    return;
                // Along the diagonal through a distal cusp, because the CEJ rises mesially.
                if (at.x > 0.0 && std::abs(at.x - at.y) < 0.1)
                    nearest = std::min(nearest, 5.0 - std::hypot(at.x, at.y));
            });
            // The radius of the outer surface at this height: 5 up to the contour, then the quarter ellipse of the
            // shoulder.
            const double shoulder = z <= -5.0 ? 1.0 : std::sqrt(std::max(0.0, 1.0 - (z + 5.0) * (z + 5.0) / 16.0));
            QVERIFY(between(nearest - (1.0 - shoulder) - (0.05 + 0.32 * height), -0.3, 0.3));
        }
    }

    void enamelEndsAtTheCervix()
    {
        const ToothMaps maps = support::analyticMolar(150);
        const auto layers = lay(maps, 36);
        for (std::size_t k = 0; k < maps.top.size(); ++k)
            if (maps.isSolid(k) && maps.bottom[k] < -7.6F)
                QVERIFY2(layers[k].dej >= -7.51F, "enamel on the root");
    }

    void neckHasOneLineBetweenEnamelAndRoot_data() { support::rows<int>("fdi", {34, 35, 36, 37, 38}); }

    void neckHasOneLineBetweenEnamelAndRoot()
    {
        // The lingual flank (+y) seen from below, from its outline inwards, must be enamel, then dentin, and no more
        // enamel. A junction exactly on the surface counts as neither, because it flickers.
        QFETCH(int, fdi);
        const ToothMaps maps = support::generatedMaps(fdi, 0, 150);
        const auto layers = lay(maps, fdi);
        int flanks = 0;
        int broken = 0;
        for (int i = 45; i < 105; ++i) {
            bool isRoot = false;
            bool comesBack = false;
            int enamel = 0;
            for (int j = 149; j > 90; --j) {
                const std::size_t k = maps.grid.index(i, j);
                if (!maps.isSolid(k))
                    continue;
                const bool isEnamel = layers[k].dej < maps.bottom[k] - 0.05F;
                enamel += isEnamel ? 1 : 0;
                comesBack = comesBack || (isRoot && isEnamel);
                isRoot = isRoot || !isEnamel;
            }
            flanks += enamel > 0 ? 1 : 0;
            broken += comesBack ? 1 : 0;
        }
        QVERIFY(flanks > 30);
        QVERIFY2(broken == 0, qPrintable(QStringLiteral("%1 of %2 sections").arg(broken).arg(flanks)));
    }

    void noColumnIsAllEnamelBetweenDentin_data()
    {
        support::rows<int>("fdi", {24, 25, 26, 27, 28, 34, 35, 36, 37, 38});
    }

    /// Where the root begins, the underside falls by millimetres. This is not a steep flank with much enamel, and a
    /// section there must not show a slit of enamel in the dentin.
    void noColumnIsAllEnamelBetweenDentin()
    {
        QFETCH(int, fdi);
        const ToothMaps maps = support::generatedMaps(fdi, 0, 150);
        const auto layers = lay(maps, fdi);
        int slits = 0;
        const auto junction = [&](int i, int j) {
            const std::size_t k = maps.grid.index(i, j);
            return std::max(layers[k].dej, maps.bottom[k]);
        };
        for (int j = 1; j < 149; ++j) {
            for (int i = 1; i < 149; ++i) {
                bool within = true;
                for (const auto& [di, dj] : {std::pair{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}})
                    within = within && maps.isSolid(maps.grid.index(i + di, j + dj));
                const float around = within ? std::max(std::min(junction(i - 1, j), junction(i + 1, j)),
                                                       std::min(junction(i, j - 1), junction(i, j + 1)))
                                            : -1.0e9F;
                slits += within && junction(i, j) < around - 0.8F ? 1 : 0;
            }
        }
        QCOMPARE(slits, 0);
    }

    void fissureKeepsItsEnamelAndTheJunctionIgnoresItsBase()
    {
        const ToothMaps maps = support::analyticMolar(512);
        const auto layers = lay(maps, 36);
        for (double y = -0.6; y <= 0.6; y += 0.05) {
            const std::size_t k = nodeAt(maps.grid, {0.5, y});
            QVERIFY(between(static_cast<double>(maps.top[k]) - static_cast<double>(layers[k].dej), 0.199, 20.0));
        }
        // The fissure is 0.8 deep. The junction below it does not follow: it is no lower than beside the fissure.
        const std::size_t base = nodeAt(maps.grid, {0.5, 0.0});
        const auto junction = static_cast<double>(layers[base].dej);
        QVERIFY(between(static_cast<double>(maps.top[base]) - junction, 0.2, 0.6));
        for (const double y : {-0.6, 0.6})
            QVERIFY(between(junction - static_cast<double>(layers[nodeAt(maps.grid, {0.5, y})].dej), -0.1, 0.5));
    }

    void invariantsHoldOnEveryTooth_data() { support::rows<int>("side", {64, 150, 512}); }

    void invariantsHoldOnEveryTooth()
    {
        QFETCH(int, side);
        for (const support::NamedMaps& tooth : support::everyTooth(side)) {
            for (const std::uint64_t seed : {0U, 1U, 2U, 77U}) {
                if (side == 512 && seed > 1)
                    continue;
                for (const auto rule : {teeth::LayerRule::Anatomical, teeth::LayerRule::ConstantDepth2011}) {
                    const QString wrong = brokenLayers(tooth.maps, lay(tooth.maps, tooth.fdi, seed, rule));
                    QVERIFY2(wrong.isEmpty(), qPrintable(tooth.name.c_str() + QStringLiteral(": ") + wrong));
                }
            }
        }
    }

    void pulpKeepsItsDentin_data() { support::rows<int>("side", {64, 150}); }

    void pulpKeepsItsDentin()
    {
        QFETCH(int, side);
        for (const support::NamedMaps& tooth : support::everyTooth(side)) {
            for (const std::uint64_t seed : {0U, 5U}) {
                const auto layers = lay(tooth.maps, tooth.fdi, seed);
                QVERIFY2(between(leastDentin(tooth.maps, layers), 1.0 - 1e-6, 100.0), tooth.name.c_str());
                QVERIFY2(of(volumesOf(tooth.maps, layers), Material::Pulp) > 2.0, tooth.name.c_str());
            }
        }
    }

    void molarPulpLiesWhereItIsMeasured()
    {
        const ToothMaps maps = support::analyticMolar(150);
        const auto layers = lay(maps, 36);
        // Under each cusp tip the nearest pulp is 6.3 +- 0.9 away (Deutsch and Musikant 2004).
        for (const double sx : {-1.0, 1.0}) {
            for (const double sy : {-1.0, 1.0}) {
                double nearest = 100.0;
                support::eachNode(maps.grid, [&](std::size_t k, const glm::dvec2& at) {
                    if (hasPulp(layers[k]))
                        nearest = std::min(nearest, std::hypot(at.x - 2.5 * sx, at.y - 2.5 * sy,
                                                               static_cast<double>(layers[k].pulpRoof)));
                });
                QVERIFY(between(nearest, 5.4, 7.2));
            }
        }
        // In the middle, the chamber is 1.6 to 1.9 high and its roof is within a millimetre of the CEJ.
        const ColumnLayers& middle = layers[nodeAt(maps.grid, {0.0, 0.0})];
        QVERIFY(between(static_cast<double>(middle.pulpRoof), -8.0, -6.0));
        const ColumnLayers& beside = layers[nodeAt(maps.grid, {0.0, 0.8})];
        QVERIFY(between(static_cast<double>(beside.pulpRoof) - static_cast<double>(beside.pulpFloor), 1.5, 2.1));
    }

    void incisorPulpLiesWhereItIsMeasured()
    {
        const ToothMaps maps = support::generatedMaps(21, 0, 150);
        const auto layers = lay(maps, 21);
        float highest = -100.0F;
        for (const ColumnLayers& column : layers)
            if (hasPulp(column))
                highest = std::max(highest, column.pulpRoof);
        // The pulp tip is 6.6 below the incisal edge. The 1.5 mm of dentin that it needs at its sides may push it down.
        QVERIFY(between(static_cast<double>(highest), -8.5, -6.2));
        QVERIFY(between(of(volumesOf(maps, layers), Material::Pulp), 10.0, 35.0));  // 19.6 on one measured tooth
    }

    void pulpGoesOnToWhereAScanIsCutOff_data()
    {
        support::columns<int, double>("fdi", "cutMm");
        for (const int fdi : {21, 24, 31, 36, 26}) {
            const double cervix = fdi == 21 ? -10.5 : fdi == 24 ? -8.5 : fdi == 31 ? -9.0 : -7.5;
            // The roof of a molar's chamber is at the cervix.
            for (const double below : {fdi % 10 == 6 ? 0.2 : -0.5, 0.5, 1.5, 3.0, 5.0})
                QTest::addRow("%d, %g mm below the cervix", fdi, below) << fdi << cervix - below;
        }
    }

    void pulpGoesOnToWhereAScanIsCutOff()
    {
        QFETCH(int, fdi);
        QFETCH(double, cutMm);
        const ToothMaps whole = support::generatedMaps(fdi, 0, 150);
        const auto cut = static_cast<float>(cutMm);
        ToothMaps maps = whole;
        for (std::size_t k = 0; k < maps.top.size(); ++k) {
            if (!maps.isSolid(k) || maps.bottom[k] >= cut)
                continue;
            maps.bottom[k] = cut;
            if (!maps.isSolid(k)) {
                maps.top[k] = kEmptyTop;
                maps.bottom[k] = kEmptyBottom;
            }
        }
        const auto layers = lay(maps, fdi);
        const QString wrong = brokenLayers(maps, layers);
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
        // There is as much pulp as the whole tooth has above that height.
        const double pulp = of(volumesOf(maps, layers), Material::Pulp);
        const double expected = of(volumesOf(maps, lay(whole, fdi)), Material::Pulp);
        QVERIFY(expected > 0.3);
        QVERIFY(std::abs(pulp - expected) < 0.2 * expected + 0.5);
    }

    void gridSideDoesNotChangeTheTooth()
    {
        for (const int fdi : {36, 24, 21}) {
            const ToothMaps reference = support::generatedMaps(fdi, 0, 256);
            const PerMaterial expected = volumesOf(reference, lay(reference, fdi));
            for (const int side : {100, 150, 512}) {
                const ToothMaps maps = support::generatedMaps(fdi, 0, side);
                const PerMaterial volumes = volumesOf(maps, lay(maps, fdi));
                // Whether a canal still fits into a slender premolar root depends on tenths of a millimetre, so the
                // pulp may differ by 12 %.
                for (const Material material : {Material::Enamel, Material::Dentin, Material::Pulp})
                    QVERIFY2(std::abs(of(volumes, material) / of(expected, material) - 1.0) <
                                 (material == Material::Pulp ? 0.12 : 0.02),
                             qPrintable(QStringLiteral("%1 at %2: material %3 is %4, not %5 mm3")
                                            .arg(fdi)
                                            .arg(side)
                                            .arg(static_cast<int>(material))
                                            .arg(of(volumes, material))
                                            .arg(of(expected, material))));
            }
        }
    }

    void placeInTheFrameDoesNotCount()
    {
        constexpr float kUpMm = 50.0F;
        for (const support::NamedMaps& tooth : support::everyTooth(100)) {
            ToothMaps moved = tooth.maps;
            moved.grid.originMm += glm::dvec2(7.0, -3.0);
            for (std::size_t k = 0; k < moved.top.size(); ++k) {
                if (!tooth.maps.isSolid(k))
                    continue;
                moved.top[k] += kUpMm;
                moved.bottom[k] += kUpMm;
            }
            for (const std::uint64_t seed : {0U, 5U}) {
                const auto here = lay(tooth.maps, tooth.fdi, seed);
                const auto there = lay(moved, tooth.fdi, seed);
                float apart = 0.0F;
                for (std::size_t k = 0; k < here.size(); ++k) {
                    if (!tooth.maps.isSolid(k))
                        continue;
                    QCOMPARE(hasPulp(there[k]), hasPulp(here[k]));
                    apart = std::max(apart, std::abs(there[k].dej - kUpMm - here[k].dej));
                    if (hasPulp(here[k]))
                        apart = std::max({apart, std::abs(there[k].pulpRoof - kUpMm - here[k].pulpRoof),
                                          std::abs(there[k].pulpFloor - kUpMm - here[k].pulpFloor)});
                }
                QVERIFY2(between(static_cast<double>(apart), -1.0, 1e-4), tooth.name.c_str());
            }
        }
    }

    void seedsVaryAndRepeat()
    {
        const ToothMaps maps = support::generatedMaps(36, 0, 150);
        const auto first = lay(maps, 36, 9);
        QVERIFY(first == lay(maps, 36, 9));
        QVERIFY(first != lay(maps, 36, 10));
        // People differ by tenths of a millimetre, not by millimetres.
        const PerMaterial mean = volumesOf(maps, lay(maps, 36, 0));
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            const PerMaterial person = volumesOf(maps, lay(maps, 36, seed));
            QVERIFY(between(of(person, Material::Enamel) / of(mean, Material::Enamel), 0.8, 1.2));
            QVERIFY(between(of(person, Material::Pulp) / of(mean, Material::Pulp), 0.5, 1.8));
        }
    }

    void leftAndRightAreTheSameTooth()
    {
        const ToothMaps maps = support::generatedMaps(36, 0, 100);
        QVERIFY(lay(maps, 36) == lay(maps, 46));
        const ToothMaps upper = support::generatedMaps(24, 0, 100);
        QVERIFY(lay(upper, 24) == lay(upper, 14));
    }

    void unknownTeethAreGuessedByTheirCrown()
    {
        // A tooth whose kind is guessed must have a volume close to that of the named tooth.
        for (const int fdi : {21, 22, 23, 24, 25, 26, 27, 28, 31, 32, 33, 34, 35, 36, 37, 38}) {
            const ToothMaps maps = support::generatedMaps(fdi, 0, 150);
            const double named = of(volumesOf(maps, lay(maps, fdi)), Material::Enamel);
            const double guessed = of(volumesOf(maps, lay(maps, 0)), Material::Enamel);
            QVERIFY2(between(guessed / named, 0.8, 1.2), qPrintable(QString::number(fdi)));
        }
        const ToothMaps maps = support::generatedMaps(36, 0, 64);
        QVERIFY(lay(maps, 0) == lay(maps, 99));
    }

    void constantDepthIsConstant()
    {
        const ToothMaps maps = support::analyticMolar(150);
        const auto layers = lay(maps, 36, 0, teeth::LayerRule::ConstantDepth2011);
        for (const glm::dvec2 at : {glm::dvec2(0.0, 0.0), glm::dvec2(2.0, 1.0), glm::dvec2(-1.0, -2.0)}) {
            const std::size_t k = nodeAt(maps.grid, at);
            QVERIFY(std::abs(maps.top[k] - layers[k].dej - 2.0F) < 1e-5F);
        }
        const std::size_t rim = nodeAt(maps.grid, {4.5, 0.0});
        QVERIFY(layers[rim].dej <= maps.bottom[rim]);
        QVERIFY(hasPulp(layers[nodeAt(maps.grid, {0.0, 1.0})]));
        QVERIFY(layers == lay(maps, 11, 5, teeth::LayerRule::ConstantDepth2011));  // neither tooth nor seed matters
    }

    void oddMapsAreSurvived()
    {
        for (const support::NamedMaps& odd : support::oddMaps()) {
            const QString wrong = brokenLayers(odd.maps, lay(odd.maps, odd.fdi));
            QVERIFY2(wrong.isEmpty(), qPrintable(odd.name.c_str() + QStringLiteral(": ") + wrong));
        }
    }

    void scansHaveTheTablesThickness_data()
    {
        support::columns<int, double, double, double, double>("fdi", "cuspLow", "cuspHigh", "enamelLowMm3",
                                                              "enamelHighMm3");
        QTest::newRow("molar") << 36 << 2.2 << 2.8 << 200.0 << 330.0;
        QTest::newRow("premolar") << 24 << 2.0 << 2.6 << 80.0 << 150.0;
        QTest::newRow("incisor") << 21 << 1.6 << 2.4 << 50.0 << 110.0;
    }

    void scansHaveTheTablesThickness()
    {
        QFETCH(int, fdi);
        QFETCH(double, cuspLow);
        QFETCH(double, cuspHigh);
        QFETCH(double, enamelLowMm3);
        QFETCH(double, enamelHighMm3);
        const auto maps = support::scanMaps(fdi, 150);
        if (!maps)
            QSKIP("shared/data/teeth is absent");
        const auto layers = lay(*maps, fdi);
        const std::size_t tip =
            static_cast<std::size_t>(std::max_element(maps->top.begin(), maps->top.end()) - maps->top.begin());
        QVERIFY(between(enamelAt(*maps, layers, tip, static_cast<double>(maps->top[tip])), cuspLow, cuspHigh));
        QVERIFY(between(of(volumesOf(*maps, layers), Material::Enamel), enamelLowMm3, enamelHighMm3));
    }
};

CUSP_TEST(TestLayers)
#include "tst_layers.moc"
