// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include <algorithm>
#include <cmath>

#include "core/teeth/Caries.h"
#include "core/teeth/Layers.h"
#include "tests/support/Tables.h"
#include "tests/support/ToothMaps.h"
#include "tests/support/Trials.h"

using namespace core;
using namespace core::terrain;
using support::ToothMaps;
using teeth::CariesRule;

namespace {

constexpr CariesRule kRules[] = {CariesRule::FissureWalk, CariesRule::LowPointFill2011};

std::vector<ColumnLayers> decay(const ToothMaps& maps, int fdi, CariesRule rule, double extent, std::uint64_t seed = 0)
{
    auto layers = teeth::buildLayers(maps.grid, maps.top, maps.bottom, {teeth::LayerRule::Anatomical, fdi, seed});
    teeth::addCaries(maps.grid, maps.top, maps.bottom, layers, {rule, extent, seed});
    return layers;
}

bool hasCaries(const ColumnLayers& column)
{
    return column.cariesRoof > column.cariesFloor;
}

double volume(const ToothMaps& maps, const std::vector<ColumnLayers>& layers)
{
    double sum = 0.0;
    for (std::size_t k = 0; k < layers.size(); ++k)
        if (maps.top[k] > maps.bottom[k])
            sum += lengthsBetween(layers[k], maps.bottom[k], maps.top[k])[static_cast<std::size_t>(Material::Caries)];
    return sum * maps.grid.cellMm * maps.grid.cellMm;
}

/// Least distance from decay down or sideways to pulp, mm, capped at 3.
double leastOverPulp(const ToothMaps& maps, const std::vector<ColumnLayers>& layers)
{
    const Grid& grid = maps.grid;
    const int reach = static_cast<int>(std::ceil(0.6 / grid.cellMm));
    const int step = std::max(1, grid.side / 150);  // a fine grid is probed, not searched
    double least = 3.0;
    for (int j = 0; j < grid.side; j += step) {
        for (int i = 0; i < grid.side; i += step) {
            if (!hasCaries(layers[grid.index(i, j)]))
                continue;
            const auto floor = static_cast<double>(layers[grid.index(i, j)].cariesFloor);
            for (int nj = std::max(0, j - reach); nj <= std::min(grid.side - 1, j + reach); ++nj) {
                for (int ni = std::max(0, i - reach); ni <= std::min(grid.side - 1, i + reach); ++ni) {
                    const ColumnLayers& pulp = layers[grid.index(ni, nj)];
                    if (pulp.pulpRoof > pulp.pulpFloor)
                        least = std::min(least, std::hypot(grid.cellMm * std::hypot(ni - i, nj - j),
                                                           std::max(0.0, floor - static_cast<double>(pulp.pulpRoof))));
                }
            }
        }
    }
    return least;
}

QString broken(const ToothMaps& maps, const std::vector<ColumnLayers>& layers)
{
    for (std::size_t k = 0; k < layers.size(); ++k) {
        if (!hasCaries(layers[k]))
            continue;
        const QString where = QStringLiteral("node %1: ").arg(k);
        if (!(maps.top[k] > maps.bottom[k]))
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
                    const QString wrong = broken(tooth.maps, layers);
                    QVERIFY2(wrong.isEmpty(), qPrintable(tooth.name.c_str() + QStringLiteral(": ") + wrong));
                    QVERIFY2(volume(tooth.maps, layers) > 0.5, tooth.name.c_str());
                    const double least = leastOverPulp(tooth.maps, layers);
                    QVERIFY2(least >= 0.5, qPrintable(QStringLiteral("%1, seed %2: %3 mm over the pulp")
                                                          .arg(tooth.name.c_str())
                                                          .arg(seed)
                                                          .arg(least)));
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
                    auto larger = sound;
                    teeth::addCaries(tooth.maps.grid, tooth.maps.top, tooth.maps.bottom, larger, {rule, extent, 4});
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
        double mouth = 0.0;
        double base = 0.0;
        double undermined = 0.0;
        for (std::size_t k = 0; k < layers.size(); ++k) {
            if (!hasCaries(layers[k]))
                continue;
            const double area = maps.grid.cellMm * maps.grid.cellMm;
            if (layers[k].cariesRoof >= maps.top[k])
                mouth += area;
            if (layers[k].cariesRoof >= layers[k].dej && layers[k].cariesFloor < layers[k].dej)
                base += area;
            if (layers[k].cariesRoof < maps.top[k] - 0.3F)
                undermined += area;
        }
        QVERIFY(mouth > 0.0);
        QVERIFY2(base > 3.0 * mouth, qPrintable(QStringLiteral("mouth %1, base %2 mm2").arg(mouth).arg(base)));
        QVERIFY2(undermined > mouth,
                 qPrintable(QStringLiteral("mouth %1, undermined %2 mm2").arg(mouth).arg(undermined)));
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
        for (std::size_t k = 0; k < layers.size(); ++k) {
            const glm::dvec2 at = maps.grid.nodeMm(static_cast<int>(k % 150U), static_cast<int>(k / 150U));
            if (maps.top[k] > maps.bottom[k] && std::hypot(at.x, at.y) < 1.0)
                lowest = std::min(lowest, maps.top[k]);
            if (!hasCaries(layers[k]))
                continue;
            area += maps.grid.cellMm * maps.grid.cellMm;
            QCOMPARE(layers[k].cariesRoof, maps.top[k]);
            highest = std::max(highest, maps.top[k]);
        }
        QVERIFY2(std::abs(area - 6.0) < 0.1, qPrintable(QString::number(area)));
        QVERIFY(highest - lowest <= 1.2F);
    }

    void seedsVaryAndRepeat()
    {
        const ToothMaps maps = support::generatedMaps(36, 0, 150);
        for (const CariesRule rule : kRules) {
            const auto sound =
                teeth::buildLayers(maps.grid, maps.top, maps.bottom, {teeth::LayerRule::Anatomical, 36, 0});
            auto first = sound;
            teeth::addCaries(maps.grid, maps.top, maps.bottom, first, {rule, 0.6, 9});
            auto again = sound;
            teeth::addCaries(maps.grid, maps.top, maps.bottom, again, {rule, 0.6, 9});
            QVERIFY(first == again);
            int different = 0;
            for (std::uint64_t seed = 10; seed < 20; ++seed) {
                auto other = sound;
                teeth::addCaries(maps.grid, maps.top, maps.bottom, other, {rule, 0.6, seed});
                different += other != first ? 1 : 0;
            }
            QVERIFY(different >= 5);
        }
    }

    void onlyCariesChanges()
    {
        const ToothMaps maps = support::generatedMaps(36, 0, 100);
        const auto sound = teeth::buildLayers(maps.grid, maps.top, maps.bottom, {teeth::LayerRule::Anatomical, 36, 1});
        for (const CariesRule rule : kRules) {
            auto sick = sound;
            teeth::addCaries(maps.grid, maps.top, maps.bottom, sick, {rule, 0.8, 1});
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
        ToothMaps empty = support::analyticMolar(64);
        std::fill(empty.top.begin(), empty.top.end(), kEmptyTop);
        std::fill(empty.bottom.begin(), empty.bottom.end(), kEmptyBottom);
        ToothMaps needle = empty;
        needle.top[2000] = 0.0F;
        needle.bottom[2000] = -20.0F;
        ToothMaps full = empty;
        std::fill(full.top.begin(), full.top.end(), 0.0F);
        std::fill(full.bottom.begin(), full.bottom.end(), -20.0F);
        ToothMaps film = full;
        std::fill(film.bottom.begin(), film.bottom.end(), -0.3F);
        for (const ToothMaps& maps : {empty, needle, full, film})
            for (const CariesRule rule : kRules)
                QVERIFY(broken(maps, decay(maps, 36, rule, 1.0, 2)).isEmpty());
    }
};

QTEST_GUILESS_MAIN(TestCaries)
#include "tst_caries.moc"
