// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>

#include "core/base/Rng.h"
#include "core/grading/Measures.h"
#include "core/history/RemovedTally.h"
#include "core/teeth/ToothBuilder.h"

using namespace core;

namespace {

/// Cuts square pits of random depth, some through the tooth.
void cutPits(terrain::Tooth& tooth, Rng& rng, int count)
{
    const int side = tooth.grid().side;
    for (int n = 0; n < count; ++n) {
        const int midI = rng.below(side);
        const int midJ = rng.below(side);
        const int reach = 2 + rng.below(side / 12);
        const auto depth = static_cast<float>(rng.uniform(0.05, 4.0));
        for (int j = std::max(0, midJ - reach); j <= std::min(side - 1, midJ + reach); ++j) {
            for (int i = std::max(0, midI - reach); i <= std::min(side - 1, midI + reach); ++i) {
                const std::size_t k = tooth.grid().index(i, j);
                if (!tooth.isSolid(k))
                    continue;
                tooth.top[k] -= depth;
                if (!tooth.isSolid(k)) {
                    tooth.top[k] = terrain::kEmptyTop;
                    tooth.bottom[k] = terrain::kEmptyBottom;
                }
            }
        }
    }
}

}  // namespace

class TestRemovedTally : public QObject
{
    Q_OBJECT
private slots:
    void agreesWithTheSumOverColumns_data()
    {
        QTest::addColumn<int>("side");
        QTest::newRow("whole tiles") << 64;
        QTest::newRow("tiles cut off by the edge") << 150;
    }

    void agreesWithTheSumOverColumns()
    {
        QFETCH(int, side);
        teeth::BuildOptions options;
        options.gridSide = side;
        const auto built = teeth::buildTooth({36}, options);
        QVERIFY(built);
        terrain::Tooth tooth(built->anatomy);
        history::TiledHeights tiles(tooth.grid(), tooth.top);
        history::RemovedTally tally(built->anatomy);
        QCOMPARE(tally.of(tiles), history::Removed{});
        Rng rng(5);
        for (int round = 0; round < 20; ++round) {
            cutPits(tooth, rng, 3);
            tiles.update(tooth.top);
            const terrain::PerMaterial right = terrain::removedVolumes(tooth);
            const terrain::PerMaterial found = tally.of(tiles).volumesMm3;
            for (std::size_t m = 0; m < right.size(); ++m)
                QVERIFY2(std::abs(found[m] - right[m]) < 1.0e-9,
                         qPrintable(QString("material %1: %2, not %3").arg(m).arg(found[m]).arg(right[m])));
            QVERIFY(std::abs(tally.of(tiles).overcutMm3 - grading::measure(tooth).overcutMm3) < 1.0e-9);
            QCOMPARE(tally.of(tiles).perforated, !terrain::perforations(tooth).empty());
        }
        QVERIFY(!terrain::perforations(tooth).empty());
        QVERIFY(tally.of(tiles).perforated);
        QVERIFY(tally.of(tiles).volumesMm3[static_cast<std::size_t>(terrain::Material::Dentin)] > 1.0);
    }

    void answersTheSameWhateverWasAskedBefore()
    {
        const auto built = teeth::buildTooth({36}, {});
        QVERIFY(built);
        terrain::Tooth tooth(built->anatomy);
        history::RemovedTally used(built->anatomy);
        history::TiledHeights tiles(tooth.grid(), tooth.top);
        Rng rng(9);
        std::vector<history::TiledHeights> moments;
        for (int round = 0; round < 5; ++round) {
            cutPits(tooth, rng, 2);
            tiles.update(tooth.top);
            moments.push_back(tiles);
            static_cast<void>(used.of(tiles));
        }
        // Undo goes back to older tiles; the figures shown must be those shown then.
        for (const history::TiledHeights& moment : moments) {
            history::RemovedTally fresh(built->anatomy);
            QCOMPARE(used.of(moment), fresh.of(moment));
        }
    }
};

QTEST_APPLESS_MAIN(TestRemovedTally)
#include "tst_removed_tally.moc"
