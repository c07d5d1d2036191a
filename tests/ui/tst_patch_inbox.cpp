// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "core/servo/ServoState.h"
#include "tests/support/Suite.h"
#include "tests/support/SyntheticTooth.h"
#include "ui/tooth/PatchInbox.h"

using core::servo::TilePatch;
using ui::tooth::PatchInbox;

namespace {

TilePatch patch(std::uint64_t generation, int tile, bool last, float height = -1.0F)
{
    TilePatch made;
    made.toothGeneration = generation;
    made.tileX = static_cast<std::uint16_t>(tile);
    made.last = last;
    made.top.fill(height);
    return made;
}

}  // namespace

class TestPatchInbox : public QObject
{
    Q_OBJECT

private slots:
    void holdsAGroupBackUntilItIsWhole()
    {
        PatchInbox inbox;
        inbox.setGeneration(3);
        inbox.take(patch(3, 0, false));
        inbox.take(patch(3, 1, false));
        QVERIFY(inbox.complete().empty());
        inbox.take(patch(3, 2, true));
        QCOMPARE(inbox.complete().size(), std::size_t{3});
        inbox.complete().clear();
        inbox.take(patch(3, 5, false));
        QVERIFY(inbox.complete().empty());
    }

    void dropsPatchesOfAnOlderTooth()
    {
        PatchInbox inbox;
        inbox.setGeneration(3);
        inbox.take(patch(2, 0, true));
        QVERIFY(inbox.complete().empty());
        // The patches do not reappear when the same generation is used again.
        inbox.setGeneration(2);
        QVERIFY(inbox.complete().empty());
    }

    void keepsPatchesOfAToothToCome()
    {
        PatchInbox inbox;
        inbox.setGeneration(1);
        inbox.take(patch(2, 0, true, -1.0F));
        inbox.take(patch(2, 0, false, -2.0F));
        inbox.take(patch(2, 7, true, -3.0F));
        inbox.take(patch(2, 8, false, -4.0F));
        QVERIFY(inbox.complete().empty());
        inbox.setGeneration(2);
        QCOMPARE(inbox.complete().size(), std::size_t{2});
        QCOMPARE(inbox.complete()[0].top[0], -2.0F);
        QCOMPARE(inbox.complete()[1].tileX, std::uint16_t{7});
        inbox.complete().clear();
        inbox.take(patch(2, 9, true));
        QCOMPARE(inbox.complete().size(), std::size_t{2});
    }

    void dropsAHalfGroupOfTheToothBefore()
    {
        PatchInbox inbox;
        inbox.setGeneration(1);
        inbox.take(patch(1, 0, false));
        inbox.setGeneration(2);
        inbox.take(patch(2, 4, true));
        QCOMPARE(inbox.complete().size(), std::size_t{1});
        QCOMPARE(inbox.complete()[0].tileX, std::uint16_t{4});
    }

    void aPatchIsWrittenIntoATooth()
    {
        core::terrain::Tooth tooth(support::makeBlock({.side = 70}));
        core::servo::TilePatch last = patch(1, 4, true, -1.5F);
        last.tileY = 1;
        last.top[0] = core::terrain::kEmptyTop;
        ui::tooth::write(last, tooth);
        const core::terrain::Grid& grid = tooth.grid();
        // Tile 4 begins at node 64 of 70. The part beyond the grid is ignored.
        QVERIFY(!tooth.isSolid(grid.index(64, 16)));
        QCOMPARE(tooth.bottom[grid.index(64, 16)], core::terrain::kEmptyBottom);
        QCOMPARE(tooth.top[grid.index(65, 16)], -1.5F);
        QCOMPARE(tooth.top[grid.index(69, 31)], -1.5F);
        QCOMPARE(tooth.top[grid.index(63, 16)], 0.0F);
        QCOMPARE(tooth.top[grid.index(0, 17)], 0.0F);
        // An undo restores the column, including its bottom.
        last.top[0] = 0.0F;
        ui::tooth::write(last, tooth);
        QCOMPARE(tooth.bottom[grid.index(64, 16)], tooth.anatomy->bottom[grid.index(64, 16)]);
    }
};

CUSP_TEST(TestPatchInbox)
#include "tst_patch_inbox.moc"
