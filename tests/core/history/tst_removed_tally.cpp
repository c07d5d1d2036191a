// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>

#include "core/base/Rng.h"
#include "core/grading/Measures.h"
#include "core/history/RemovedTally.h"
#include "tests/support/Scenes.h"
#include "tests/support/Suite.h"
#include "tests/support/Tables.h"

using namespace core;

namespace {

/// Cuts square pits of random depth, some through the tooth.
void cutPits(terrain::Tooth& tooth, Rng& rng, int count)
{
    const int side = tooth.grid().side;
    for (int n = 0; n < count; ++n) {
        const int i = rng.below(side);
        const int j = rng.below(side);
        const int reach = 2 + rng.below(side / 12);
        const auto depth = static_cast<float>(rng.uniform(0.05, 4.0));
        support::eachOf(tooth.grid(), support::around(tooth.grid(), i, j, reach), [&](std::size_t k) {
            if (!tooth.isSolid(k))
                return;
            tooth.top[k] -= depth;
            if (!tooth.isSolid(k))
                support::cutThrough(tooth, k);
        });
    }
}

}  // namespace

class TestRemovedTally : public QObject
{
    Q_OBJECT
private slots:
    void agreesWithTheSumOverColumns_data() { support::rows<int>("side", {64, 150}); }

    /// A grid of 64 nodes a side has whole tiles only; one of 150 has partial tiles at the edge.
    void agreesWithTheSumOverColumns()
    {
        QFETCH(int, side);
        terrain::Tooth tooth(support::builtTooth(36, side));
        history::TiledHeights tiles(tooth.grid(), tooth.top);
        history::RemovedTally tally(tooth.anatomy);
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
        QVERIFY(tally.of(tiles).perforated);
        QVERIFY(tally.of(tiles).volumesMm3[static_cast<std::size_t>(terrain::Material::Dentin)] > 1.0);
    }

    /// An undo restores older tiles. The tally must then give the same volumes as before.
    void answersTheSameWhateverWasAskedBefore()
    {
        terrain::Tooth tooth(support::builtTooth(36));
        history::RemovedTally used(tooth.anatomy);
        history::TiledHeights tiles(tooth.grid(), tooth.top);
        Rng rng(9);
        std::vector<history::TiledHeights> moments;
        for (int round = 0; round < 5; ++round) {
            cutPits(tooth, rng, 2);
            tiles.update(tooth.top);
            moments.push_back(tiles);
            static_cast<void>(used.of(tiles));
        }
        for (const history::TiledHeights& moment : moments)
            QCOMPARE(used.of(moment), history::RemovedTally(tooth.anatomy).of(moment));
    }
};

CUSP_TEST(TestRemovedTally)
#include "tst_removed_tally.moc"
