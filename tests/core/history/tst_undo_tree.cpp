// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <map>
#include <set>

#include "core/base/Rng.h"
#include "core/history/MomentId.h"
#include "core/history/UndoTree.h"
#include "core/servo/ServoState.h"
#include "tests/support/Suite.h"
#include "tests/support/Tables.h"

using namespace core;
using history::MomentId;
using history::Tile;
using history::TiledHeights;
using history::ToothMoment;
using history::UndoTree;

namespace {

const terrain::Grid kGrid{64, 0.1, {0.0, 0.0}};  // 4 x 4 tiles
constexpr std::size_t kTiles = 16;
constexpr std::size_t kListBytes = kTiles * sizeof(std::shared_ptr<const Tile>);

TiledHeights flat(float height)
{
    return {kGrid, std::vector<float>(kGrid.count(), height)};
}

/// Returns the map with one tile replaced.
TiledHeights with(TiledHeights map, int tileX, int tileY, float height)
{
    Tile tile;
    tile.fill(height);
    map.setTile(tileX, tileY, tile);
    return map;
}

/// Returns a tree whose first moment is a whole tooth, with n strokes after it.
UndoTree grown(int strokes)
{
    UndoTree tree;
    tree.restart({flat(0.0F), 0});
    for (int n = 1; n <= strokes; ++n)
        tree.push({flat(-static_cast<float>(n)), static_cast<std::uint64_t>(n)});
    return tree;
}

int tilesApart(const TiledHeights& a, const TiledHeights& b)
{
    int count = 0;
    for (std::size_t k = 0; k < kTiles; ++k)
        count += a.tiles()[k] != b.tiles()[k] ? 1 : 0;
    return count;
}

/// Prints the moments as "id<parent" in the order of the list, with the current one in brackets.
QString drawn(const UndoTree& tree)
{
    QStringList all;
    for (const history::MomentInfo& moment : tree.list()) {
        const QString one = QStringLiteral("%1<%2")
                                .arg(static_cast<std::uint64_t>(moment.id))
                                .arg(static_cast<std::uint64_t>(moment.parent));
        all << (moment.isCurrent ? '[' + one + ']' : one);
    }
    return all.join(' ');
}

}  // namespace

class TestUndoTree : public QObject
{
    Q_OBJECT
private slots:
    void tilesGiveBackWhatWentIn_data() { support::rows<int>("side", {64, 65, 79, 80, 100, 150, 256}); }

    void tilesGiveBackWhatWentIn()
    {
        QFETCH(int, side);
        const terrain::Grid grid{side, 0.07, {0.0, 0.0}};
        Rng rng(static_cast<std::uint64_t>(side));
        std::vector<float> heights(grid.count());
        for (float& height : heights)
            height = static_cast<float>(rng.uniform(-5.0, 5.0));
        QCOMPARE(TiledHeights(grid, heights).flat(), heights);
    }

    void copiesShareTiles()
    {
        const TiledHeights first = flat(1.0F);
        const TiledHeights second = with(first, 2, 1, 0.5F);
        QCOMPARE(tilesApart(first, second), 1);
        QCOMPARE(tilesApart(first, first), 0);
        QCOMPARE(second.tile(0, 0).get(), first.tile(0, 0).get());
        QCOMPARE(first.flat(), std::vector<float>(kGrid.count(), 1.0F));  // the older map is unchanged
        QCOMPARE(second.flat()[kGrid.index(32, 16)], 0.5F);
        QCOMPARE(second.flat()[kGrid.index(31, 16)], 1.0F);
    }

    void updateTouchesOnlyWhatDiffers()
    {
        const TiledHeights first = flat(1.0F);
        TiledHeights second = first;
        std::vector<float> heights(kGrid.count(), 1.0F);
        second.update(heights);
        QCOMPARE(tilesApart(first, second), 0);
        heights[kGrid.index(15, 15)] = 0.0F;
        heights[kGrid.index(16, 16)] = 0.0F;
        second.update(heights);
        QCOMPARE(tilesApart(first, second), 2);
        QCOMPARE(second.flat(), heights);
    }

    void patchesAreTheWholeDifference()
    {
        const TiledHeights from = flat(1.0F);
        const TiledHeights to = with(with(from, 3, 3, 0.2F), 0, 2, 0.1F);
        const auto group = history::patchesBetween(from, to, 17, 5);
        QCOMPARE(group.size(), 2U);
        QCOMPARE(group[0].last, false);
        QCOMPARE(group[1].last, true);
        TiledHeights rebuilt = from;
        for (const core::servo::TilePatch& patch : group) {
            QCOMPARE(patch.tick, 17U);
            QCOMPARE(patch.toothGeneration, 5U);
            rebuilt.setTile(patch.tileX, patch.tileY, patch.top);
        }
        QCOMPARE(rebuilt.flat(), to.flat());
        QVERIFY(history::patchesBetween(to, to, 1, 1).empty());
    }

    void goesBackAndForth()
    {
        UndoTree tree = grown(0);
        QVERIFY(!tree.undo());
        QVERIFY(!tree.redo());
        tree = grown(5);
        QCOMPARE(tree.undoSteps(), 5);
        QCOMPARE(tree.redoSteps(), 0);
        for (int n = 5; n-- > 0;) {
            QVERIFY(tree.undo());
            QCOMPARE(tree.current().tick, static_cast<std::uint64_t>(n));
            QCOMPARE(tree.redoSteps(), 5 - n);
        }
        QVERIFY(!tree.undo());
        QVERIFY(tree.redo());
        QCOMPARE(tree.current().tick, 1U);
        QCOMPARE(tree.current().top.flat(), flat(-1.0F).flat());
    }

    void strokeAfterUndoBeginsABranch()
    {
        UndoTree tree = grown(4);
        QVERIFY(tree.undo() && tree.undo() && tree.undo());
        tree.push({flat(-9.0F), 9});
        QCOMPARE(drawn(tree), "1<0 2<1 3<2 4<3 5<4 [6<2]");
        QCOMPARE(tree.redoSteps(), 0);
        QCOMPARE(tree.undoSteps(), 2);
        QVERIFY(!tree.redo());
        QVERIFY(tree.undo());
        QCOMPARE(tree.current().tick, 1U);
        // Nothing is lost: the other branch is unchanged.
        QCOMPARE(tree.find(MomentId{5})->top.flat(), flat(-4.0F).flat());
        QVERIFY(tree.find(MomentId{7}) == nullptr);
    }

    void theLastBeforeATickLiesOnTheWayHere()
    {
        UndoTree tree;
        tree.restart({TiledHeights{}, 0});
        tree.push({TiledHeights{}, 100});
        const auto left = tree.currentId();
        QVERIFY(tree.undo());
        const auto first = tree.currentId();
        tree.push({TiledHeights{}, 300});
        const auto here = tree.currentId();
        // At tick 250 the tooth was whole again. The moment at tick 100 is more recent, but on another branch.
        QCOMPARE(history::lastBefore(tree.list(), 250), std::optional(first));
        QVERIFY(history::lastBefore(tree.list(), 250) != std::optional(left));
        QCOMPARE(history::lastBefore(tree.list(), 301), std::optional(here));
        QVERIFY(!history::lastBefore(tree.list(), 0).has_value());
        QVERIFY(!history::lastBefore({}, 5).has_value());
    }

    void redoFollowsTheWayLastGone()
    {
        UndoTree tree = grown(2);
        QVERIFY(tree.undo());
        tree.push({flat(-3.0F), 3});  // 4
        QVERIFY(tree.undo());
        QVERIFY(tree.redo());
        QCOMPARE(tree.currentId(), MomentId{4});
        QVERIFY(tree.goTo(MomentId{3}));
        QVERIFY(tree.undo() && tree.undo());
        QCOMPARE(tree.redoSteps(), 2);
        QVERIFY(tree.redo() && tree.redo());
        QCOMPARE(tree.currentId(), MomentId{3});
    }

    void goesToAnyMoment()
    {
        UndoTree tree = grown(3);
        QVERIFY(tree.goTo(MomentId{2}));
        tree.push({flat(-4.0F), 4});
        tree.push({flat(-5.0F), 5});
        QVERIFY(tree.goTo(MomentId{4}));
        QCOMPARE(drawn(tree), "1<0 2<1 3<2 [4<3] 5<2 6<5");
        QCOMPARE(tree.current().top.flat(), flat(-3.0F).flat());
        QCOMPARE(tree.undoSteps(), 3);
        QVERIFY(!tree.goTo(MomentId{4}));  // is the current moment already
        QVERIFY(!tree.goTo(MomentId{7}));
        QVERIFY(!tree.goTo(MomentId{}));
        QVERIFY(tree.goTo(MomentId{1}));
        QCOMPARE(tree.redoSteps(), 3);
    }

    void countsSharedTilesOnce()
    {
        UndoTree tree;
        TiledHeights map = flat(0.0F);
        tree.restart({map, 0});
        QCOMPARE(tree.bytes(), kTiles * sizeof(Tile) + kListBytes);
        for (std::uint64_t n = 1; n <= 100; ++n) {
            map = with(map, static_cast<int>(n % 4), static_cast<int>(n / 4 % 4), -static_cast<float>(n));
            tree.push({map, n});
        }
        QCOMPARE(tree.bytes(), (kTiles + 100) * sizeof(Tile) + 101 * kListBytes);
        QCOMPARE(tree.undoSteps(), 100);
    }

    void memoryLimitForgetsTheOldest()
    {
        constexpr std::size_t kLimit = (kTiles + 10) * sizeof(Tile) + 11 * kListBytes;
        UndoTree tree(kLimit);
        TiledHeights map = flat(0.0F);
        tree.restart({map, 0});
        for (std::uint64_t n = 1; n <= 500; ++n) {
            map = with(map, static_cast<int>(n % 4), static_cast<int>(n / 4 % 4), -static_cast<float>(n));
            tree.push({map, n});
            QVERIFY(tree.bytes() <= kLimit);
            QCOMPARE(tree.current().tick, n);
        }
        QCOMPARE(tree.undoSteps(), 10);
        // The oldest remaining moment is a complete map.
        while (tree.undo()) {
        }
        QCOMPARE(tree.current().tick, 490U);
        const std::vector<float> heights = tree.current().top.flat();
        QCOMPARE(*std::min_element(heights.begin(), heights.end()), -490.0F);
        QCOMPARE(*std::max_element(heights.begin(), heights.end()), -475.0F);

        // One undo step is kept however small the limit is.
        UndoTree tiny(1);
        tiny.restart({flat(0.0F), 0});
        tiny.push({flat(-1.0F), 1});
        tiny.push({flat(-2.0F), 2});
        QCOMPARE(tiny.undoSteps(), 1);
        QVERIFY(tiny.undo());
        QCOMPARE(tiny.current().tick, 1U);
    }

    void memoryLimitForgetsBranchesFirst()
    {
        // Room for six moments that share no tiles.
        UndoTree tree(6 * (kTiles * sizeof(Tile) + kListBytes));
        tree.restart({flat(0.0F), 0});
        tree.push({flat(-1.0F), 1});
        tree.push({flat(-2.0F), 2});  // 3
        tree.push({flat(-3.0F), 3});  // 4, on 3
        QVERIFY(tree.goTo(MomentId{2}));
        tree.push({flat(-4.0F), 4});  // 5, on 2
        tree.push({flat(-5.0F), 5});
        QCOMPARE(drawn(tree), "1<0 2<1 3<2 4<3 5<2 [6<5]");
        tree.push({flat(-6.0F), 6});
        QCOMPARE(drawn(tree), "1<0 2<1 3<2 5<2 6<5 [7<6]");  // without the leaf of the other branch
        tree.push({flat(-7.0F), 7});
        QCOMPARE(drawn(tree), "1<0 2<1 5<2 6<5 7<6 [8<7]");  // without the rest of that branch
        tree.push({flat(-8.0F), 8});
        QCOMPARE(drawn(tree), "2<0 5<2 6<5 7<6 8<7 [9<8]");  // then without the first moment of the current branch
        QVERIFY(tree.goTo(MomentId{2}));
        tree.push({flat(-9.0F), 9});
        QCOMPARE(drawn(tree), "2<0 5<2 6<5 7<6 8<7 [10<2]");  // the undone moments are a branch now
    }

    void memoryStaysTrueInAStorm()
    {
        constexpr std::size_t kLimit = 200 * sizeof(Tile);
        UndoTree tree(kLimit);
        tree.restart({flat(0.0F), 0});
        Rng rng(3);
        std::uint64_t tick = 0;
        for (int n = 0; n < 20000; ++n) {
            const auto all = tree.list();
            switch (rng.below(5)) {
            case 0:
                tree.undo();
                break;
            case 1:
                tree.redo();
                break;
            case 2:
                tree.goTo(all[static_cast<std::size_t>(rng.below(static_cast<int>(all.size())))].id);
                break;
            default:
                tree.push({with(tree.current().top, rng.below(4), rng.below(4), -static_cast<float>(n)), ++tick});
            }
            if (n % 50 != 0)
                continue;
            // Compares with a slow count.
            std::set<const Tile*> tiles;
            std::size_t lists = 0;
            std::map<MomentId, int> known;
            const auto now = tree.list();
            for (const history::MomentInfo& moment : now) {
                QVERIFY(known.empty() ? moment.parent == MomentId{} : known.contains(moment.parent));
                known[moment.id] = known.empty() ? 0 : known[moment.parent] + 1;
                const TiledHeights& top = tree.find(moment.id)->top;
                lists += top.tiles().size_bytes();
                for (const auto& tile : top.tiles())
                    tiles.insert(tile.get());
            }
            QCOMPARE(tree.bytes(), tiles.size() * sizeof(Tile) + lists);
            QVERIFY(tree.bytes() <= kLimit);
            QCOMPARE(tree.undoSteps(), known.at(tree.currentId()));
            QCOMPARE(std::count_if(now.begin(), now.end(), [](const auto& moment) { return moment.isCurrent; }), 1);
        }
    }

    void restartForgetsEverything()
    {
        UndoTree tree = grown(2);
        tree.restart({flat(5.0F), 0});
        QCOMPARE(tree.undoSteps(), 0);
        QCOMPARE(tree.redoSteps(), 0);
        QCOMPARE(tree.bytes(), kTiles * sizeof(Tile) + kListBytes);
        QVERIFY(tree.find(MomentId{1}) == nullptr);  // ids are not reused
    }
};

CUSP_TEST(TestUndoTree)
#include "tst_undo_tree.moc"
