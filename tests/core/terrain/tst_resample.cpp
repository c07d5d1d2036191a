// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include <cmath>
#include <numeric>

#include "core/grading/Columns.h"
#include "core/grading/Measures.h"
#include "core/terrain/Resample.h"
#include "tests/support/Suite.h"
#include "tests/support/SyntheticTooth.h"

using core::terrain::Sampling;

namespace {

double volumeOf(const core::terrain::Tooth& tooth)
{
    const auto volumes = core::terrain::volumes(tooth);
    return std::accumulate(volumes.begin(), volumes.end(), 0.0);
}

}  // namespace

class TestResample : public QObject
{
    Q_OBJECT

private slots:
    void theSameToothOnOtherGrids()
    {
        const auto anatomy = support::wavyDisc(101, 0.1);
        const core::terrain::Tooth tooth = support::hollowed(anatomy, 1.5);
        for (const Sampling sampling : {Sampling::Half, Sampling::Double}) {
            const auto other = core::terrain::resampled(*anatomy, sampling);
            QCOMPARE(other->grid.side, sampling == Sampling::Half ? 51 : 201);
            const core::terrain::Tooth same = core::terrain::resampled(tooth, other, sampling);
            // Nodes of both grids are at the same place and have the same content.
            for (int j = 0; j < 51; ++j)
                for (int i = 0; i < 51; ++i) {
                    const std::size_t here = anatomy->grid.index(2 * i, 2 * j);
                    const std::size_t there =
                        sampling == Sampling::Half ? other->grid.index(i, j) : other->grid.index(4 * i, 4 * j);
                    if (core::grading::wasSolid(*anatomy, here)) {
                        QCOMPARE(same.top[there], tooth.top[here]);
                        QCOMPARE(same.bottom[there], tooth.bottom[here]);
                    }
                }
            const double share = sampling == Sampling::Half ? 0.01 : 0.005;
            const double volume = volumeOf(same) / volumeOf(tooth);
            QVERIFY2(std::abs(volume - 1.0) < share, qPrintable(QString::number(volume)));
            const auto gone = core::terrain::removedVolumes(tooth);
            const auto goneThere = core::terrain::removedVolumes(same);
            for (const std::size_t material : {1U, 2U})
                QVERIFY2(std::abs(goneThere[material] / gone[material] - 1.0) < share,
                         qPrintable(QString::number(goneThere[material] / gone[material])));
        }
        // The whole area is distributed.
        const auto area = [](const core::terrain::ToothAnatomy& of) {
            return std::accumulate(of.areaMm2.begin(), of.areaMm2.end(), 0.0);
        };
        const auto twice = core::terrain::resampled(*anatomy, Sampling::Double);
        QVERIFY(std::abs(area(*twice) / area(*anatomy) - 1.0) < 1.0e-4);
    }

    void aHoleStaysAHole()
    {
        const auto anatomy = support::wavyDisc(101, 0.1);
        const core::terrain::Tooth tooth = support::hollowed(anatomy, 100.0);
        const double area = core::grading::measure(tooth).perforatedMm2;
        QVERIFY(area > 1.0);
        for (const Sampling sampling : {Sampling::Half, Sampling::Double}) {
            const core::terrain::Tooth same =
                core::terrain::resampled(tooth, core::terrain::resampled(*anatomy, sampling), sampling);
            const double there = core::grading::measure(same).perforatedMm2;
            QVERIFY2(std::abs(there / area - 1.0) < 0.1, qPrintable(QString::number(there / area)));
        }
    }
};

CUSP_TEST(TestResample)
#include "tst_resample.moc"
