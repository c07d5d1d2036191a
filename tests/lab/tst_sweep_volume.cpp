// SPDX-License-Identifier: GPL-3.0-or-later
// The volume that a swept bur removes, compared with closed form (docs/facts/haptics.md, section 8.4, item 5).
#include <QTest>

#include <cmath>
#include <numbers>

#include "core/bur/Bur.h"
#include "lab/SweepVolume.h"
#include "tests/support/Tables.h"
#include "tests/support/Trials.h"

namespace {

constexpr lab::Sweep kSweeps[] = {lab::Sweep::Trench, lab::Sweep::Arc, lab::Sweep::Plunge};

}  // namespace

class TestSweepVolume : public QObject
{
    Q_OBJECT
private slots:
    void closedFormIsThatOfTheCapsule()
    {
        // A ball along a line, A = R^2 acos(1 - d/R) - (R - d) sqrt(2 R d - d^2), and a cap of the ball
        // (docs/facts/haptics.md, section 8.4, item 5).
        const std::size_t ball = core::bur::findBur("2").value();
        constexpr double kRadius = 0.5;
        constexpr double kDeep = 0.3;
        const double area = kRadius * kRadius * std::acos(1.0 - kDeep / kRadius) -
                            (kRadius - kDeep) * std::sqrt(2.0 * kRadius * kDeep - kDeep * kDeep);
        const double cap = std::numbers::pi * kDeep * kDeep * (3.0 * kRadius - kDeep) / 3.0;
        QVERIFY(std::abs(lab::sweptMm3(lab::Sweep::Plunge, ball, kDeep) - cap) < 1.0e-9);
        QVERIFY(std::abs(lab::sweptMm3(lab::Sweep::Trench, ball, kDeep) - (area * 3.0 + cap)) < 1.0e-9);
    }

    void closedFormIsTheIntegralOfTheUnderside()
    {
        constexpr int kRings = 200000;
        for (std::size_t bur = 0; bur < core::bur::burs().size(); ++bur) {
            const core::bur::Bur& shape = core::bur::burs()[bur];
            for (const double depth : {0.05, 0.4, 1.2}) {
                double volume = 0.0;
                const double width = shape.headRadiusMm / kRings;
                for (int ring = 0; ring < kRings; ++ring) {
                    const double r = (ring + 0.5) * width;
                    volume += std::max(0.0, depth - shape.undersideMm(r)) * 2.0 * std::numbers::pi * r * width;
                }
                const double exact = lab::sweptMm3(lab::Sweep::Plunge, bur, depth);
                QVERIFY2(
                    std::abs(volume - exact) < 1.0e-5 * exact,
                    qPrintable(QString("bur %1, %2 mm: %3 against %4").arg(bur).arg(depth).arg(volume).arg(exact)));
            }
        }
    }

    void volumeIsWithinOnePercent_data()
    {
        support::columns<int, int, double>("sweep", "bur", "depthMm");
        for (int n = 0, sweep = 0; sweep < 3; ++sweep)
            for (int bur = 0; bur < 4; ++bur)
                for (const double depth : {0.1, 0.4, 1.2})
                    if (support::isTried(n++))
                        QTest::addRow("sweep %d, bur %d, %g mm", sweep, bur, depth) << sweep << bur << depth;
    }

    void volumeIsWithinOnePercent()
    {
        // A column under a vertical side is removed completely or not at all. Single positions vary by that, but their
        // mean does not.
        QFETCH(int, sweep);
        QFETCH(int, bur);
        QFETCH(double, depthMm);
        const lab::SweepErrors errors = lab::measureSweep(kSweeps[sweep], 150, static_cast<std::size_t>(bur), depthMm);
        QVERIFY2(std::abs(errors.volumePercent) < 1.0, qPrintable(QString("mean %1 %").arg(errors.volumePercent)));
        QVERIFY2(errors.depthRmsUm < 10.0, qPrintable(QString("depth %1 um").arg(errors.depthRmsUm)));
        // A ball no deeper than its radius has no vertical side, so every position is within one per cent.
        if (bur == 0 && depthMm < 0.5)
            QVERIFY2(errors.worstPercent < 1.0, qPrintable(QString("worst %1 %").arg(errors.worstPercent)));
    }

    void finerGridStraysLess()
    {
        const std::size_t pear = core::bur::findBur("330").value();
        for (const lab::Sweep sweep : kSweeps) {
            const lab::SweepErrors coarse = lab::measureSweep(sweep, 100, pear);
            const lab::SweepErrors fine = lab::measureSweep(sweep, 300, pear);
            QVERIFY2(fine.worstPercent < 0.6 * coarse.worstPercent,
                     qPrintable(QString("%1 % on 300, %2 % on 100").arg(fine.worstPercent).arg(coarse.worstPercent)));
        }
    }
};

QTEST_APPLESS_MAIN(TestSweepVolume)
#include "tst_sweep_volume.moc"
