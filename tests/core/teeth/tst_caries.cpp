// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include <algorithm>
#include <cmath>

#include "core/teeth/Caries.h"
#include "core/teeth/Layers.h"
#include "tests/support/Checks.h"
#include "tests/support/Suite.h"
#include "tests/support/SyntheticTooth.h"
#include "tests/support/Tables.h"
#include "tests/support/ToothMaps.h"
#include "tests/support/Trials.h"

using namespace core;
using namespace core::terrain;
using support::ToothMaps;
using teeth::CariesRule;

namespace {

constexpr CariesRule kRules[] = {CariesRule::FissureWalk, CariesRule::LowPointFill2011};

std::vector<ColumnLayers> soundLayers(const ToothMaps& maps, int fdi, std::uint64_t seed)
{
    return teeth::buildLayers(maps.grid, maps.top, maps.bottom, {teeth::LayerRule::Anatomical, fdi, seed});
}

std::vector<ColumnLayers> decayed(const ToothMaps& maps, std::vector<ColumnLayers> layers,
                                  const teeth::CariesOptions& how)
{
    teeth::addCaries(maps.grid, maps.top, maps.bottom, layers, how);
    return layers;
}

std::vector<ColumnLayers> decay(const ToothMaps& maps, int fdi, CariesRule rule, double extent, std::uint64_t seed = 0)
{
    return decayed(maps, soundLayers(maps, fdi, seed), {rule, extent, seed});
}

bool hasCaries(const ColumnLayers& column)
{
    return column.cariesRoof > column.cariesFloor;
}

double volume(const ToothMaps& maps, const std::vector<ColumnLayers>& layers)
{
    return support::volumesOf(maps, layers)[static_cast<std::size_t>(Material::Caries)];
}

/// Returns the least distance from decay down or sideways to pulp, mm, at most 3.
double leastOverPulp(const ToothMaps& maps, const std::vector<ColumnLayers>& layers)
{
    const Grid& grid = maps.grid;
    const int reach = static_cast<int>(std::ceil(0.6 / grid.cellMm));
    const int step = std::max(1, grid.side / 150);  // a fine grid is sampled
    double least = 3.0;
    for (int j = 0; j < grid.side; j += step)
        for (int i = 0; i < grid.side; i += step) {
            if (!hasCaries(layers[grid.index(i, j)]))
                continue;
            const auto floor = static_cast<double>(layers[grid.index(i, j)].cariesFloor);
            for (int nj = std::max(0, j - reach); nj <= std::min(grid.side - 1, j + reach); ++nj)
                for (int ni = std::max(0, i - reach); ni <= std::min(grid.side - 1, i + reach); ++ni) {
                    const ColumnLayers& pulp = layers[grid.index(ni, nj)];
                    if (pulp.pulpRoof > pulp.pulpFloor)
                        least = std::min(least, std::hypot(grid.cellMm * std::hypot(ni - i, nj - j),
                                                           std::max(0.0, floor - static_cast<double>(pulp.pulpRoof))));
                }
        }
    return least;
}

QString brokenDecay(const ToothMaps& maps, const std::vector<ColumnLayers>& layers)
{
    for (std::size_t k = 0; k < layers.size(); ++k) {
        if (!hasCaries(layers[k]))
            continue;
        const QString where = QStringLiteral("node %1: ").arg(k);
        if (!maps.isSolid(k))
            return where + "decay in an empty column";
        if (layers[k].cariesFloor < maps.bottom[k] || layers[k].cariesRoof > maps.top[k])
            return where + "decay outside the tooth";
    }
    return {};
}

}  // namespace

class TestCaries : public QObject
{
    Q_OBJECT

private slots:
    void extentZeroIsNone()
    {
        const ToothMaps maps = support::generatedMaps(36, 0, 150);
        for (const CariesRule rule : kRules)
            for (const double extent : {0.0, -1.0, std::nan("")})
                QCOMPARE(volume(maps, decay(maps, 36, rule, extent)), 0.0);
        QVERIFY(decay(maps, 36, CariesRule::FissureWalk, 7.0) == decay(maps, 36, CariesRule::FissureWalk, 1.0));
    }

    void invariantsHoldOnEveryTooth_data() { support::rows<int>("side", {64, 150, 512}); }

    void invariantsHoldOnEveryTooth()
    {
        QFETCH(int, side);
        for (const support::NamedMaps& tooth : support::everyTooth(side)) {
            for (const CariesRule rule : kRules) {
                for (const std::uint64_t seed : {0U, 3U, 8U}) {
                    if (side == 512 && seed != 3)
                        continue;
                    const auto layers = decay(tooth.maps, tooth.fdi, rule, 1.0, seed);
                    const QString wrong = brokenDecay(tooth.maps, layers);
                    QVERIFY2(wrong.isEmpty(), qPrintable(tooth.name.c_str() + QStringLiteral(": ") + wrong));
                    QVERIFY2(volume(tooth.maps, layers) > 0.5, tooth.name.c_str());
                    QVERIFY2(leastOverPulp(tooth.maps, layers) >= 0.5, tooth.name.c_str());
                }
            }
        }
    }

    void largerExtentsContainSmallerOnes()
    {
        for (const support::NamedMaps& tooth : support::everyTooth(150)) {
            for (const CariesRule rule : kRules) {
                const auto sound = decay(tooth.maps, tooth.fdi, rule, 0.0, 4);
                auto smaller = sound;
                constexpr double kStep = support::kSanitized ? 0.25 : 0.05;
                for (double extent = kStep; extent <= 1.0; extent += kStep) {
                    const auto larger = decayed(tooth.maps, sound, {rule, extent, 4});
                    for (std::size_t k = 0; k < larger.size(); ++k)
                        if (hasCaries(smaller[k]))
                            QVERIFY2(hasCaries(larger[k]) && larger[k].cariesRoof >= smaller[k].cariesRoof - 1e-5F &&
                                         larger[k].cariesFloor <= smaller[k].cariesFloor + 1e-5F,
                                     qPrintable(QStringLiteral("%1, extent %2").arg(tooth.name.c_str()).arg(extent)));
                    smaller = larger;
                }
            }
        }
    }

    void volumeGrowsStrictly()
    {
        for (const int side : {64, 150}) {
            const ToothMaps maps = support::generatedMaps(36, 0, side);
            for (const CariesRule rule : kRules) {
                double before = 0.0;
                for (double extent = 0.1; extent <= 1.0; extent += 0.1) {
                    const double now = volume(maps, decay(maps, 36, rule, extent));
                    QVERIFY2(now > before, qPrintable(QStringLiteral("%1 mm3 at %2").arg(now).arg(extent)));
                    before = now;
                }
            }
        }
    }

    void fissureLesionIsNarrowOutsideAndWideAtTheJunction()
    {
        const ToothMaps maps = support::generatedMaps(36, 0, 150);
        const auto layers = decay(maps, 36, CariesRule::FissureWalk, 0.6);
        int mouth = 0;
        int base = 0;
        int undermined = 0;
        for (std::size_t k = 0; k < layers.size(); ++k) {
            if (!hasCaries(layers[k]))
                continue;
            if (layers[k].cariesRoof >= maps.top[k])
                ++mouth;
            if (layers[k].cariesRoof >= layers[k].dej && layers[k].cariesFloor < layers[k].dej)
                ++base;
            if (layers[k].cariesRoof < maps.top[k] - 0.3F)
                ++undermined;
        }
        const QString found = QStringLiteral("mouth %1, base %2, undermined %3").arg(mouth).arg(base).arg(undermined);
        QVERIFY2(mouth > 0 && base > 3 * mouth && undermined > mouth, qPrintable(found));
    }

    void earlyLesionStaysInEnamel()
    {
        const ToothMaps maps = support::generatedMaps(36, 0, 150);
        const auto layers = decay(maps, 36, CariesRule::FissureWalk, 0.2);
        QVERIFY(volume(maps, layers) > 0.0);
        for (const ColumnLayers& column : layers)
            QVERIFY(!hasCaries(column) || column.cariesFloor >= column.dej);
    }

    void lowPointLesionIsOpenAndLow()
    {
        const ToothMaps maps = support::generatedMaps(36, 0, 150);
        const auto layers = decay(maps, 36, CariesRule::LowPointFill2011, 0.5);
        double area = 0.0;
        float lowest = 0.0F;  // near the centre
        float highest = -100.0F;
        support::eachNode(maps.grid, [&](std::size_t k, const glm::dvec2& at) {
            if (maps.isSolid(k) && std::hypot(at.x, at.y) < 1.0)
                lowest = std::min(lowest, maps.top[k]);
            if (!hasCaries(layers[k]))
                return;
            area += maps.grid.cellMm * maps.grid.cellMm;
            QCOMPARE(layers[k].cariesRoof, maps.top[k]);
            highest = std::max(highest, maps.top[k]);
        });
        QVERIFY(support::near(area, 6.0, 0.1));
        QVERIFY(highest - lowest <= 1.2F);
    }

    void seedsVaryAndRepeat()
    {
        const ToothMaps maps = support::generatedMaps(36, 0, 150);
        for (const CariesRule rule : kRules) {
            const auto sound = soundLayers(maps, 36, 0);
            const auto first = decayed(maps, sound, {rule, 0.6, 9});
            QVERIFY(first == decayed(maps, sound, {rule, 0.6, 9}));
            int different = 0;
            for (std::uint64_t seed = 10; seed < 20; ++seed)
                different += decayed(maps, sound, {rule, 0.6, seed}) != first ? 1 : 0;
            QVERIFY(different >= 5);
        }
    }

    void onlyCariesChanges()
    {
        const ToothMaps maps = support::generatedMaps(36, 0, 100);
        const auto sound = soundLayers(maps, 36, 1);
        for (const CariesRule rule : kRules) {
            auto sick = decayed(maps, sound, {rule, 0.8, 1});
            QVERIFY(sick != sound);
            for (ColumnLayers& column : sick) {
                column.cariesRoof = 0.0F;
                column.cariesFloor = 0.0F;
            }
            QVERIFY(sick == sound);
        }
    }

    void oddMapsAreSurvived()
    {
        for (const support::NamedMaps& odd : support::oddMaps())
            for (const CariesRule rule : kRules)
                QVERIFY2(brokenDecay(odd.maps, decay(odd.maps, 36, rule, 1.0, 2)).isEmpty(), odd.name.c_str());
    }
};

CUSP_TEST(TestCaries)
#include "tst_caries.moc"
