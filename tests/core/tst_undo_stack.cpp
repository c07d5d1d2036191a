// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>

#include "core/base/Rng.h"
#include "core/history/UndoStack.h"

using namespace core;
using history::Tile;
using history::TiledHeights;
using history::ToothMoment;
using history::UndoStack;

namespace {

const terrain::Grid kGrid{64, 0.1, {0.0, 0.0}};  // 4 x 4 tiles
constexpr std::size_t kTiles = 16;

TiledHeights flat(float height)
{
    return {kGrid, std::vector<float>(kGrid.count(), height)};
}

/// The map with one tile replaced.
TiledHeights with(TiledHeights map, int tileX, int tileY, float height)
{
    Tile tile;
    tile.fill(height);
    map.setTile(tileX, tileY, tile);
    return map;
}

}  // namespace

class TestUndoStack : public QObject
{
    Q_OBJECT
private slots:
    void tilesGiveBackWhatWentIn_data();
    void tilesGiveBackWhatWentIn();
    void copiesShareTiles();
    void updateTouchesOnlyWhatDiffers();
    void patchesAreTheWholeDifference();
    void goesBackAndForth();
    void newStrokeCutsOffRedo();
    void countsSharedTilesOnce();
    void memoryLimitForgetsTheOldest();
    void restartForgetsEverything();
};

void TestUndoStack::tilesGiveBackWhatWentIn_data()
{
    QTest::addColumn<int>("side");
    for (const int side : {64, 65, 79, 80, 100, 150, 256})
        QTest::addRow("%d", side) << side;
}

void TestUndoStack::tilesGiveBackWhatWentIn()
{
    QFETCH(int, side);
    const terrain::Grid grid{side, 0.07, {0.0, 0.0}};
    Rng rng(static_cast<std::uint64_t>(side));
    std::vector<float> heights(grid.count());
    for (float& height : heights)
        height = static_cast<float>(rng.uniform(-5.0, 5.0));
    QCOMPARE(TiledHeights(grid, heights).flat(), heights);
}

void TestUndoStack::copiesShareTiles()
{
    const TiledHeights first = flat(1.0F);
    const TiledHeights second = with(first, 2, 1, 0.5F);
    QCOMPARE(second.tilesNotIn(first), 1U);
    QCOMPARE(first.tilesNotIn(second), 1U);
    QCOMPARE(first.tilesNotIn(first), 0U);
    QCOMPARE(second.tile(0, 0).get(), first.tile(0, 0).get());
    QCOMPARE(first.flat(), std::vector<float>(kGrid.count(), 1.0F));  // the older one is as it was
    QCOMPARE(second.flat()[kGrid.index(32, 16)], 0.5F);
    QCOMPARE(second.flat()[kGrid.index(31, 16)], 1.0F);
}

void TestUndoStack::updateTouchesOnlyWhatDiffers()
{
    const TiledHeights first = flat(1.0F);
    TiledHeights second = first;
    std::vector<float> heights(kGrid.count(), 1.0F);
    second.update(heights);
    QCOMPARE(second.tilesNotIn(first), 0U);
    heights[kGrid.index(15, 15)] = 0.0F;
    heights[kGrid.index(16, 16)] = 0.0F;
    second.update(heights);
    QCOMPARE(second.tilesNotIn(first), 2U);
    QCOMPARE(second.flat(), heights);
}

void TestUndoStack::patchesAreTheWholeDifference()
{
    const TiledHeights from = flat(1.0F);
    const TiledHeights to = with(with(from, 3, 3, 0.2F), 0, 2, 0.1F);
    const auto group = history::patchesBetween(from, to, 17, 5);
    QCOMPARE(group.size(), 2U);
    QCOMPARE(group[0].last, false);
    QCOMPARE(group[1].last, true);
    TiledHeights rebuilt = from;
    for (const session::TilePatch& patch : group) {
        QCOMPARE(patch.tick, 17U);
        QCOMPARE(patch.toothGeneration, 5U);
        rebuilt.setTile(patch.tileX, patch.tileY, patch.top);
    }
    QCOMPARE(rebuilt.flat(), to.flat());
    QVERIFY(history::patchesBetween(to, to, 1, 1).empty());
}

void TestUndoStack::goesBackAndForth()
{
    UndoStack stack;
    stack.restart({flat(0.0F), 0});
    QVERIFY(!stack.undo());
    QVERIFY(!stack.redo());
    for (std::uint64_t n = 1; n <= 5; ++n)
        stack.push({flat(-static_cast<float>(n)), n * 100});
    QCOMPARE(stack.undoSteps(), 5);
    QCOMPARE(stack.redoSteps(), 0);
    for (std::uint64_t n = 5; n-- > 0;) {
        QVERIFY(stack.undo());
        QCOMPARE(stack.current().tick, n * 100);
        QCOMPARE(stack.redoSteps(), static_cast<int>(5 - n));
    }
    QVERIFY(!stack.undo());
    QVERIFY(stack.redo());
    QCOMPARE(stack.current().tick, 100U);
    QCOMPARE(stack.current().top.flat(), flat(-1.0F).flat());
}

void TestUndoStack::newStrokeCutsOffRedo()
{
    UndoStack stack;
    stack.restart({flat(0.0F), 0});
    for (std::uint64_t n = 1; n <= 4; ++n)
        stack.push({flat(-static_cast<float>(n)), n});
    QVERIFY(stack.undo() && stack.undo() && stack.undo());
    const std::size_t before = stack.bytes();
    stack.push({flat(-9.0F), 9});
    QCOMPARE(stack.redoSteps(), 0);
    QCOMPARE(stack.undoSteps(), 2);
    QVERIFY(!stack.redo());
    QCOMPARE(stack.bytes(), before - 2 * kTiles * sizeof(Tile));  // three moments gone, one come
    QVERIFY(stack.undo());
    QCOMPARE(stack.current().tick, 1U);
}

void TestUndoStack::countsSharedTilesOnce()
{
    UndoStack stack;
    TiledHeights map = flat(0.0F);
    stack.restart({map, 0});
    QCOMPARE(stack.bytes(), kTiles * sizeof(Tile));
    for (std::uint64_t n = 1; n <= 100; ++n) {
        map = with(map, static_cast<int>(n % 4), static_cast<int>(n / 4 % 4), -static_cast<float>(n));
        stack.push({map, n});
    }
    QCOMPARE(stack.bytes(), (kTiles + 100) * sizeof(Tile));
    QCOMPARE(stack.undoSteps(), 100);
}

void TestUndoStack::memoryLimitForgetsTheOldest()
{
    constexpr std::size_t kLimit = (kTiles + 10) * sizeof(Tile);
    UndoStack stack(kLimit);
    TiledHeights map = flat(0.0F);
    stack.restart({map, 0});
    for (std::uint64_t n = 1; n <= 500; ++n) {
        map = with(map, static_cast<int>(n % 4), static_cast<int>(n / 4 % 4), -static_cast<float>(n));
        stack.push({map, n});
        QVERIFY(stack.bytes() <= kLimit);
        QCOMPARE(stack.current().tick, n);
    }
    QCOMPARE(stack.undoSteps(), 10);
    // The oldest that is left is whole.
    while (stack.undo()) {
    }
    QCOMPARE(stack.current().tick, 490U);
    const std::vector<float> heights = stack.current().top.flat();
    QCOMPARE(*std::min_element(heights.begin(), heights.end()), -490.0F);
    QCOMPARE(*std::max_element(heights.begin(), heights.end()), -475.0F);

    // However small the limit, one step back is kept.
    UndoStack tiny(1);
    tiny.restart({flat(0.0F), 0});
    tiny.push({flat(-1.0F), 1});
    tiny.push({flat(-2.0F), 2});
    QCOMPARE(tiny.undoSteps(), 1);
    QVERIFY(tiny.undo());
    QCOMPARE(tiny.current().tick, 1U);
}

void TestUndoStack::restartForgetsEverything()
{
    UndoStack stack;
    stack.restart({flat(0.0F), 0});
    stack.push({flat(-1.0F), 1});
    stack.push({flat(-2.0F), 2});
    stack.restart({flat(5.0F), 0});
    QCOMPARE(stack.undoSteps(), 0);
    QCOMPARE(stack.redoSteps(), 0);
    QCOMPARE(stack.bytes(), kTiles * sizeof(Tile));
}

QTEST_APPLESS_MAIN(TestUndoStack)
#include "tst_undo_stack.moc"
