// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <set>

#include "core/base/Rng.h"
#include "tests/support/Suite.h"
#include "ui/practice/HistoryGraph.h"

using core::history::MomentId;
using core::history::MomentInfo;
using ui::practice::HistoryRow;
using ui::practice::historyRows;

namespace {

std::vector<MomentInfo> tree(const std::vector<std::uint64_t>& parents)
{
    std::vector<MomentInfo> moments;
    for (std::size_t n = 0; n < parents.size(); ++n)
        moments.push_back({MomentId{n + 1}, MomentId{parents[n]}, 100 * n, 0.1 * static_cast<double>(n), false, {}});
    return moments;
}

QList<int> lanes(const std::vector<HistoryRow>& rows)
{
    QList<int> all;
    for (const HistoryRow& row : rows)
        all << row.lane;
    return all;
}

}  // namespace

class TestHistoryGraph : public QObject
{
    Q_OBJECT
private slots:
    void branchesLieBesideEachOther()
    {
        // 1 - 2 - 3; 2 - 4 - 5; 2 - 6
        const auto rows = historyRows(tree({0, 1, 2, 2, 4, 2}));
        QCOMPARE(lanes(rows), (QList<int>{0, 0, 0, 1, 1, 2}));
        QCOMPARE(rows[5].parent, 1);
        QVERIFY(rows[0].fromAbove.empty());
        QCOMPARE(rows[1].toBelow, (std::vector<int>{0, 1, 2}));
        QCOMPARE(rows[2].toBelow, (std::vector<int>{1, 2}));
        QCOMPARE(rows[5].fromAbove, (std::vector<int>{2}));
        QVERIFY(rows[5].toBelow.empty());
    }

    void aLaneIsTakenAgain()
    {
        // The branch from 1 ends before the one from 3 begins.
        QCOMPARE(lanes(historyRows(tree({0, 1, 1, 2, 4, 4}))), (QList<int>{0, 0, 1, 0, 0, 1}));
    }

    void noTwoLinesMeetInAnyTree()
    {
        core::Rng rng(5);
        for (int trial = 0; trial < 300; ++trial) {
            std::vector<std::uint64_t> parents{0};
            while (parents.size() < 60)
                parents.push_back(static_cast<std::uint64_t>(rng.below(3) == 0
                                                                 ? 1 + rng.below(static_cast<int>(parents.size()))
                                                                 : static_cast<int>(parents.size())));
            const auto rows = historyRows(tree(parents));
            for (std::size_t n = 0; n < rows.size(); ++n) {
                for (const auto* lines : {&rows[n].fromAbove, &rows[n].toBelow})
                    QCOMPARE(std::set<int>(lines->begin(), lines->end()).size(), lines->size());
                // A line that leaves a row arrives at the next row.
                const std::set<int> below(rows[n].toBelow.begin(), rows[n].toBelow.end());
                if (n + 1 < rows.size())
                    QCOMPARE(below, std::set<int>(rows[n + 1].fromAbove.begin(), rows[n + 1].fromAbove.end()));
                else
                    QVERIFY(below.empty());
                if (n == 0)
                    continue;
                // Each moment is connected to its parent: its lane begins there and ends at the moment.
                const auto parent = static_cast<std::size_t>(rows[n].parent);
                QCOMPARE(rows[n].parent, static_cast<int>(parents[n]) - 1);
                for (std::size_t row = parent; row < n; ++row)
                    QVERIFY(std::find(rows[row].toBelow.begin(), rows[row].toBelow.end(), rows[n].lane) !=
                            rows[row].toBelow.end());
                // No other moment is in that lane in between.
                for (std::size_t row = parent + 1; row < n; ++row)
                    QVERIFY(rows[row].lane != rows[n].lane);
            }
        }
    }

    void whatCameOffIsSinceTheParent()
    {
        auto moments = tree({0, 1, 2, 2});
        moments[1].removed.volumesMm3 = {0.0, 0.5, 0.0, 0.0};
        moments[2].removed.volumesMm3 = {0.0, 0.75, 0.0, 0.0};
        moments[3].removed.volumesMm3 = {0.25, 0.5, 0.0, 0.0};
        const auto rows = historyRows(moments);
        QCOMPARE(rows[2].takenMm3[1], 0.25);
        QCOMPARE(rows[3].takenMm3[0], 0.25);
        QCOMPARE(rows[3].takenMm3[1], 0.0);
        QVERIFY(historyRows({}).empty());
    }
};

CUSP_TEST(TestHistoryGraph)
#include "tst_history_graph.moc"
