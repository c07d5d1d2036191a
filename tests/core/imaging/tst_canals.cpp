// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include <algorithm>
#include <utility>
#include <vector>

#include "core/bur/Reach.h"
#include "core/imaging/Canals.h"
#include "core/teeth/ToothBuilder.h"
#include "tests/support/Scenes.h"
#include "tests/support/Suite.h"

using namespace core;

/// Tests the root canals that pictures show below the reach of a bur.
class TestCanals : public QObject
{
    Q_OBJECT

private slots:
    void canalsGoDownIntoTheRoots_data()
    {
        QTest::addColumn<int>("fdi");
        QTest::addColumn<int>("roots");
        for (const auto& [fdi, roots] : {std::pair(21, 1), {24, 2}, {26, 3}, {27, 3}, {36, 3}, {37, 3}})
            QTest::addRow("%d", fdi) << fdi << roots;
    }

    void canalsGoDownIntoTheRoots()
    {
        QFETCH(int, fdi);
        QFETCH(int, roots);
        const auto built = teeth::buildTooth({fdi}, {});
        QVERIFY(built.has_value());
        const auto model = built->anatomy;
        const double reachMm = core::bur::lowestTipMm(*model);
        const auto pictured = imaging::withCanals(terrain::Tooth(model)).anatomy;
        QVERIFY(pictured != model);
        QVERIFY(imaging::withCanals(terrain::Tooth(model)).anatomy == pictured);  // computed once
        QVERIFY(pictured->top == model->top);
        QVERIFY(pictured->bottom == model->bottom);
        float deepest = 0.0F;
        float lowest = 0.0F;
        int changed = 0;
        for (std::size_t k = 0; k < model->top.size(); ++k) {
            if (!(model->top[k] > model->bottom[k]))
                continue;
            lowest = std::min(lowest, model->bottom[k]);
            const terrain::ColumnLayers& was = model->layers[k];
            const terrain::ColumnLayers& is = pictured->layers[k];
            if (was == is)
                continue;
            ++changed;
            deepest = std::min(deepest, is.pulpFloor);
            QVERIFY(is.pulpFloor - model->bottom[k] > 0.5F);
            // The layers change nowhere else, in particular where a bur can reach.
            terrain::ColumnLayers same = is;
            same.pulpRoof = was.pulpRoof;
            same.pulpFloor = was.pulpFloor;
            QVERIFY(same == was);
            if (terrain::hasPulp(*model, k))
                QCOMPARE(is.pulpRoof, was.pulpRoof);
            else
                QVERIFY(static_cast<double>(is.pulpRoof) <= reachMm + 1e-3);
        }
        QVERIFY(changed > 20);
        // The canals end near the apex.
        QVERIFY2(deepest - lowest < 2.0F, qPrintable(QString("%1 over %2").arg(deepest).arg(lowest)));
        // Each root has one canal, the mesial root of a lower molar has two, and there are no others.
        QCOMPARE(canalsAt(*pictured, lowest + 4.5F), roots);
    }

    void whatHasNoRootsIsLeftAlone()
    {
        const auto slab = support::decayedSlab(30, 33);
        QVERIFY(imaging::withCanals(terrain::Tooth(slab)).anatomy == slab);
    }

private:
    /// Returns the number of islands of columns that have pulp at a height.
    static int canalsAt(const terrain::ToothAnatomy& anatomy, float height)
    {
        std::vector<std::uint8_t> isLeft(anatomy.top.size());
        for (std::size_t k = 0; k < isLeft.size(); ++k)
            isLeft[k] = terrain::hasPulp(anatomy, k) && anatomy.layers[k].pulpRoof > height &&
                                anatomy.layers[k].pulpFloor < height
                            ? 1
                            : 0;
        int islands = 0;
        const int side = anatomy.grid.side;
        for (std::size_t start = 0; start < isLeft.size(); ++start) {
            if (isLeft[start] == 0)
                continue;
            ++islands;
            std::vector<std::size_t> open{start};
            while (!open.empty()) {
                const std::size_t k = open.back();
                open.pop_back();
                isLeft[k] = 0;
                const int i = static_cast<int>(k) % side;
                const int j = static_cast<int>(k) / side;
                // A canal that is one column wide somewhere may be interrupted by a few columns.
                for (int b = j - 4; b <= j + 4; ++b)
                    for (int a = i - 4; a <= i + 4; ++a)
                        if (anatomy.grid.contains(a, b) && isLeft[anatomy.grid.index(a, b)] != 0)
                            open.push_back(anatomy.grid.index(a, b));
            }
        }
        return islands;
    }
};

CUSP_TEST(TestCanals)
#include "tst_canals.moc"
