// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include <array>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/base/Rng.h"
#include "core/imaging/Bitewing.h"
#include "core/imaging/Radiograph.h"
#include "core/teeth/ToothBuilder.h"
#include "tests/support/Checks.h"
#include "tests/support/Scenes.h"
#include "tests/support/Suite.h"
#include "tests/support/SyntheticTooth.h"
#include "tests/support/Tables.h"

using namespace core;
using namespace core::terrain;
using namespace core::imaging;
using support::near;

namespace {

constexpr double kQuarter = std::numbers::pi / 2.0;

/// Returns 64 x 64 cells of 0.1 mm around the origin, top 0, bottom -10, all enamel: 6.4 x 6.4 x 10 mm.
std::shared_ptr<ToothAnatomy> enamelBlock()
{
    return support::slab(-10.0F);
}

/// Casts a shadow whose pixels are half a cell wide and begin where a cell begins. For a beam along an axis, nothing
/// changes within a pixel except at the edges of columns, so the sum over the pixels is the exact integral.
Shadow alignedShadowOf(const Tooth& tooth, const Beam& beam, const PerMaterial& perMm)
{
    const std::array<XrayedTooth, 1> one{{{&tooth}}};
    const Grid& grid = tooth.grid();
    const double pixelMm = 0.5 * grid.cellMm;
    const glm::dvec2 low = grid.originMm - pixelMm;
    const glm::dvec2 high = low + grid.cellMm * grid.side;
    FilmArea area = shadowArea(one, beam, 0.5);
    const bool alongX = std::abs(std::sin(beam.angleRad)) < 0.5;
    area.lowMm.x = alongX ? -high.y : low.x;
    area.highMm.x = alongX ? -low.y : high.x;
    if (std::sin(beam.tiltRad) > 0.5) {
        area.lowMm.y = -high.x;
        area.highMm.y = -low.x;
    }
    return castShadow(one, beam, area, pixelMm, perMm);
}

Shadow shadowOf(const Tooth& tooth, const Beam& beam, double pixelMm, const PerMaterial& perMm = kAttenuationPerMm)
{
    const std::array<XrayedTooth, 1> one{{{&tooth}}};
    return castShadow(one, beam, shadowArea(one, beam, 0.5), pixelMm, perMm);
}

/// Returns the attenuation of one ray, as a picture of one very small pixel.
Shadow rayThrough(const Tooth& tooth, const Beam& beam, glm::dvec2 at)
{
    const std::array<XrayedTooth, 1> one{{{&tooth}}};
    return castShadow(one, beam, {at - 5e-4, at + 5e-4}, 1.0e-3);
}
double total(const Shadow& shadow)
{
    double sum = 0.0;
    for (const float attenuation : shadow.attenuation)
        sum += static_cast<double>(attenuation);
    return sum * shadow.pixelMm * shadow.pixelMm;
}

/// Returns the attenuation at the pixel that shows a point of the tooth frame.
float at(const Shadow& shadow, double u, double v)
{
    return shadow.at(static_cast<int>((u - shadow.area.lowMm.x) / shadow.pixelMm),
                     static_cast<int>((shadow.area.highMm.y - v) / shadow.pixelMm));
}

double light(const Shadow& shadow, double u, double v)
{
    const double quanta =
        kQuantaPerMm2 * shadow.pixelMm * shadow.pixelMm * std::exp(-static_cast<double>(at(shadow, u, v)));
    return std::pow(10.0, -opticalDensity(quanta, shadow.pixelMm));
}

}  // namespace

class TestRadiograph : public QObject
{
    Q_OBJECT

private slots:
    void aKnownThicknessGivesAKnownTransmission_data()
    {
        support::columns<double, double, double, double, double>("angleRad", "tiltRad", "u", "v", "throughMm");
        QTest::newRow("along x") << 0.0 << 0.0 << 0.33 << -5.0 << 6.4;
        QTest::newRow("along y") << kQuarter << 0.0 << -1.27 << -9.9 << 6.4;
        QTest::newRow("along -x") << 2 * kQuarter << 0.0 << 0.33 << -5.0 << 6.4;
        QTest::newRow("corner to corner") << kQuarter / 2 << 0.0 << 0.0 << -5.0 << 6.4 * std::numbers::sqrt2;
        QTest::newRow("past a corner") << kQuarter / 2 << 0.0 << 1.0 << -5.0 << 6.4 * std::numbers::sqrt2 - 2.0;
        QTest::newRow("rising by 30 degrees")
            << 0.0 << std::numbers::pi / 6 << 0.2 << -5.0 * std::cos(std::numbers::pi / 6)
            << 6.4 / std::cos(std::numbers::pi / 6);
        QTest::newRow("falling by 30 degrees")
            << kQuarter << -std::numbers::pi / 6 << 0.2 << -5.0 * std::cos(std::numbers::pi / 6)
            << 6.4 / std::cos(std::numbers::pi / 6);
        QTest::newRow("straight up") << 0.0 << kQuarter << 0.2 << 0.1 << 10.0;
        QTest::newRow("beside it") << kQuarter << 0.0 << 3.4 << -5.0 << 0.0;
        QTest::newRow("above it") << kQuarter << 0.0 << 0.0 << 0.3 << 0.0;
    }

    void aKnownThicknessGivesAKnownTransmission()
    {
        QFETCH(double, angleRad);
        QFETCH(double, tiltRad);
        QFETCH(double, u);
        QFETCH(double, v);
        QFETCH(double, throughMm);
        const Shadow shadow = rayThrough(Tooth(enamelBlock()), {angleRad, tiltRad}, {u, v});
        QVERIFY(near(static_cast<double>(shadow.at(0, 0)), 0.28 * throughMm, 1.0e-5));
        const float quanta = quantaOn(shadow, {}).front();
        QVERIFY(near(static_cast<double>(quanta) / (kQuantaPerMm2 * 1.0e-6), std::exp(-0.28 * throughMm), 1.0e-5));
    }

    void integralsAddUpToTheVolumes_data()
    {
        support::columns<int, double, double, bool>("fdi", "angleRad", "tiltRad", "aligned");
        for (const int fdi : {36, 21})
            for (const auto& [name, angle, tilt, aligned] : {std::tuple("along z", 0.0, kQuarter, true),
                                                             {"along x", 0.0, 0.0, true},
                                                             {"along y", kQuarter, 0.0, true},
                                                             {"oblique", 0.9, 0.3, false},
                                                             {"oblique from above", 4.0, -1.1, false}})
                QTest::addRow("%d %s", fdi, name) << fdi << angle << tilt << aligned;
    }

    void integralsAddUpToTheVolumes()
    {
        QFETCH(int, fdi);
        QFETCH(double, angleRad);
        QFETCH(double, tiltRad);
        QFETCH(bool, aligned);
        Tooth tooth(support::builtTooth(fdi));
        support::eachOf(tooth.grid(), {60, 89, 65, 84}, [&](std::size_t k) {
            if (tooth.isSolid(k))
                tooth.top[k] -= 1.5F;
        });
        const PerMaterial expected = volumes(tooth);
        for (std::size_t m = 0; m < expected.size(); ++m) {
            PerMaterial only{};
            only.at(m) = 1.0;
            const Beam beam{angleRad, tiltRad};
            const double sum = total(aligned ? alignedShadowOf(tooth, beam, only) : shadowOf(tooth, beam, 0.05, only));
            QVERIFY(near(sum, expected[m], 0.01 * expected[m]));
        }
    }

    void raysAgreeWithASlowWalk()
    {
        const Tooth tooth(support::builtTooth(36));
        const Grid& grid = tooth.grid();
        Rng rng(17);
        constexpr double kStepMm = 0.002;
        for (int round = 0; round < 80; ++round) {
            const Beam beam{rng.uniform(0.0, 4.0 * kQuarter), rng.uniform(-1.2, 1.2)};
            const glm::dvec2 uv(rng.uniform(-4.0, 4.0), rng.uniform(-6.0, 0.0));
            const glm::dvec3 along(std::cos(beam.tiltRad) * std::cos(beam.angleRad),
                                   std::cos(beam.tiltRad) * std::sin(beam.angleRad), std::sin(beam.tiltRad));
            const glm::dvec3 across(std::sin(beam.angleRad), -std::cos(beam.angleRad), 0.0);
            const glm::dvec3 up = glm::cross(across, along);
            double slow = 0.0;
            for (double q = -40.0; q < 40.0; q += kStepMm) {
                const glm::dvec3 point = uv.x * across + uv.y * up + (q + 0.5 * kStepMm) * along;
                const glm::ivec2 node(glm::floor(grid.latticeOf(glm::dvec2(point)) + 0.5));
                if (!grid.contains(node.x, node.y))
                    continue;
                const std::size_t k = grid.index(node.x, node.y);
                if (point.z <= static_cast<double>(tooth.bottom[k]) || point.z >= static_cast<double>(tooth.top[k]))
                    continue;
                const auto material =
                    static_cast<std::size_t>(materialAt(tooth.anatomy->layers[k], static_cast<float>(point.z)));
                slow += kStepMm * kAttenuationPerMm.at(material) * static_cast<double>(tooth.anatomy->areaMm2[k]) /
                        (grid.cellMm * grid.cellMm);
            }
            QVERIFY(near(static_cast<double>(rayThrough(tooth, beam, uv).at(0, 0)), slow, 0.01));
        }
    }

    void mesialIsLeftAndUpIsUp()
    {
        Tooth tooth(enamelBlock());
        support::cut(tooth, {32, 63, 0, 63}, -4.0F);  // the distal half, x > 0
        const Shadow shadow = shadowOf(tooth, {}, 0.05);
        QVERIFY(at(shadow, -1.0, -2.0) > 1.0F);
        QCOMPARE(at(shadow, 1.0, -2.0), 0.0F);
        QVERIFY(at(shadow, 1.0, -6.0) > 1.0F);
        QCOMPARE(shadow.at(shadow.width / 2, 0), 0.0F);
    }

    void eachTissueHasItsTone()
    {
        // Four quarters along x, of enamel, dentin, decay and pulp through the full height, with air around.
        auto anatomy = enamelBlock();
        const ColumnLayers quarters[]{
            {0.0F, 0.0F, 10.0F, 0.0F, 0.0F}, {1.0F, -11.0F, 10.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 10.0F, 1.0F, -11.0F}};
        for (int n = 1; const ColumnLayers& quarter : quarters) {
            support::eachOf(anatomy->grid, {16 * n, 16 * n + 15, 0, 63},
                            [&](std::size_t k) { anatomy->layers[k] = quarter; });
            ++n;
        }
        const Shadow shadow = shadowOf(Tooth(anatomy), {}, 0.05);
        for (const double u : {-2.4, -0.8, 0.8, 2.4})
            QVERIFY2(light(shadow, u, -5.0) > light(shadow, std::min(u + 1.6, 3.6), -5.0),
                     qPrintable(QString::number(u)));
    }

    void aCavityIsDarkerThanBefore()
    {
        const Tooth before(enamelBlock());
        Tooth now = before;
        support::cut(now, {25, 38, 20, 43}, -3.0F);
        const Shadow whole = shadowOf(before, {}, 0.05);
        const Shadow cut = shadowOf(now, {}, 0.05);
        QVERIFY(light(cut, 0.0, -1.5) < light(whole, 0.0, -1.5));
        // Of 64 cells of enamel 24 are air there: 0.28 * 2.4 less.
        QVERIFY(near(static_cast<double>(at(whole, 0.0, -1.5)) - static_cast<double>(at(cut, 0.0, -1.5)), 0.28 * 2.4,
                     1e-5));
        QCOMPARE(at(cut, 0.0, -4.0), at(whole, 0.0, -4.0));
        QCOMPARE(at(cut, -2.0, -1.5), at(whole, -2.0, -1.5));
    }

    void noiseGrowsWithTheSquareRoot()
    {
        const Tooth tooth(enamelBlock());
        const std::array<XrayedTooth, 1> one{{{&tooth}}};
        // Inside the block every ray passes through 6.4 mm.
        const Shadow shadow = castShadow(one, {}, {{-3.0, -9.0}, {3.0, -1.0}}, 0.02);
        const auto deviationAt = [&](double exposure) {
            double sum = 0.0;
            double squares = 0.0;
            const std::vector<float> quanta = quantaOn(shadow, {exposure, 99});
            for (const float caught : quanta) {
                sum += static_cast<double>(caught);
                squares += static_cast<double>(caught) * static_cast<double>(caught);
            }
            const double count = static_cast<double>(quanta.size());
            const double mean = sum / count;
            const double deviation = std::sqrt(squares / count - mean * mean);
            return near(mean, exposure * kQuantaPerMm2 * 4.0e-4 * std::exp(-0.28 * 6.4), 0.005 * mean) &&
                           near(deviation, std::sqrt(mean), 0.02 * deviation)
                       ? deviation
                       : std::nan("");
        };
        QVERIFY(near(deviationAt(4.0) / deviationAt(1.0), 2.0, 0.04));
    }

    void theSameSeedGivesTheSameFilm()
    {
        const Shadow shadow = shadowOf(Tooth(enamelBlock()), {}, 0.1);
        QVERIFY(quantaOn(shadow, {1.0, 5}) == quantaOn(shadow, {1.0, 5}));
        QVERIFY(quantaOn(shadow, {1.0, 5}) != quantaOn(shadow, {1.0, 6}));
        QVERIFY(quantaOn(shadow, {1.0, 5}) != quantaOn(shadow, {}));
    }

    void moreExposureMakesADarkerFilm()
    {
        double before = opticalDensity(0.0, 0.05);
        for (const double exposure : {0.25, 0.5, 1.0, 2.0, 4.0}) {
            const double now = opticalDensity(exposure * kQuantaPerMm2 * 0.05 * 0.05, 0.05);
            QVERIFY(now > before);
            before = now;
        }
        // An unexposed film is fogged, and no exposure makes it blacker than the maximum.
        QVERIFY(near(opticalDensity(0.0, 0.05), 0.2, 1e-9));
        QVERIFY(near(opticalDensity(1.0e9, 0.05), 3.0, 1e-9));
    }

    void aMirroredToothThrowsAMirroredShadow()
    {
        const Tooth tooth(support::builtTooth(36));
        const std::array<XrayedTooth, 1> plain{{{&tooth, {0.5, 0.2, 0.1}, false}}};
        const std::array<XrayedTooth, 1> mirrored{{{&tooth, {-0.5, 0.2, 0.1}, true}}};
        const FilmArea area{{-8.0, -16.0}, {8.0, 2.0}};
        const Shadow a = castShadow(plain, {1.1, 0.2}, area, 0.1);
        const Shadow b = castShadow(mirrored, {std::numbers::pi - 1.1, 0.2}, area, 0.1);
        QCOMPARE(a.width, b.width);
        for (int row = 0; row < a.height; row += 7)
            for (int column = 0; column < a.width; ++column)
                QVERIFY(near(static_cast<double>(a.at(column, row)),
                             static_cast<double>(b.at(a.width - 1 - column, row)), 1.0e-4));
    }

    void neighboursTouch()
    {
        // Seen from above, the nearest columns of two teeth touch: the teeth neither overlap nor are apart.
        const auto outline = [](const XrayedTooth& xrayed) {
            std::vector<glm::dvec2> nodes;
            support::eachNode(xrayed.tooth->grid(), [&](std::size_t k, const glm::dvec2& node) {
                if (xrayed.tooth->isSolid(k))
                    nodes.push_back(glm::dvec2(xrayed.mirrored ? -node.x : node.x, node.y) +
                                    glm::dvec2(xrayed.placeMm));
            });
            return nodes;
        };
        for (const auto& [fdi, count] : {std::pair(36, 2), {21, 2}, {38, 1}}) {
            const Tooth tooth(support::builtTooth(fdi));
            const auto neighbours = neighboursOf(*tooth.anatomy);
            QVERIFY(neighbours.has_value());
            QCOMPARE(static_cast<int>(neighbours->size()), count);
            const std::vector<glm::dvec2> own = outline({&tooth});
            for (const Neighbour& neighbour : *neighbours) {
                QCOMPARE(neighbour.placeMm.x < 0.0, &neighbour == &neighbours->front());
                double gap = 1.0e9;
                for (const glm::dvec2& other : outline(neighbour.xrayed()))
                    for (const glm::dvec2& mine : own)
                        if (std::abs(other.y - mine.y) < 0.06)
                            gap = std::min(gap, std::abs(other.x - mine.x));
                QVERIFY2(gap > 0.03 && gap < 0.2, qPrintable(QString("%1: %2").arg(fdi).arg(gap)));
                QCOMPARE(neighbour.mirrored, neighbour.tooth.anatomy->fdi == fdi);
            }
        }
    }

    void aScanHasNoNeighbours()
    {
        auto scan = enamelBlock();
        scan->fdi = 36;
        scan->name = "lower molar.stl";
        QVERIFY(!teeth::isGenerated(*scan));
        QVERIFY(support::isRefused(neighboursOf(*scan), ErrorCode::UnknownName));
    }
};

CUSP_TEST(TestRadiograph)
#include "tst_radiograph.moc"
