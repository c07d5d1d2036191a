// SPDX-License-Identifier: GPL-3.0-or-later
// Cutting as felt by a hand, through the whole servo tick: rate, layers, ripple.
#include <QTest>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/bur/Bur.h"
#include "core/servo/ServoState.h"
#include "lab/Block.h"
#include "lab/CuttingTrials.h"
#include "tests/support/Tables.h"
#include "tests/support/Trials.h"

using core::terrain::Material;

namespace {

constexpr double kDejMm = -0.9;
constexpr double kCellMm = lab::kBlockExtentMm / 150;

/// Returns whether a bur removes the same volume, within three per cent, with each of some values of a parameter.
template <class Put>
bool isIndependent(const lab::PaceTrial& trial, const std::vector<double>& values, const Put& put)
{
    std::vector<double> volumes;
    for (const double value : values) {
        lab::PaceTrial varied = trial;
        put(varied, value);
        volumes.push_back(lab::removedMm3(varied));
    }
    const auto [least, most] = std::minmax_element(volumes.begin(), volumes.end());
    if (*most < 1.03 * *least)
        return true;
    qWarning("from %g to %g mm3", *least, *most);
    return false;
}

lab::PaceTrial trialOf(std::size_t bur, double headingDeg, double downDeg)
{
    lab::PaceTrial trial;
    trial.bur = bur;
    trial.towards = lab::feed(headingDeg, downDeg);
    return trial;
}

core::terrain::ColumnLayers enamelAbove(double dejMm)
{
    core::terrain::ColumnLayers layers;
    layers.dej = static_cast<float>(dejMm);
    return layers;
}

/// Presses a bur straight down on a block and calls `see` with the state of each tick, until it returns false.
template <class See>
void press(const std::function<core::terrain::ColumnLayers(glm::dvec2)>& layers, std::size_t bur, double newtons,
           See&& see)
{
    core::contact::LiveTooth tooth{core::terrain::Tooth(lab::layeredBlock([](glm::dvec2) { return 0.0; }, layers))};
    const core::servo::ServoSettings settings;
    const auto servo = core::servo::makeServoTick(settings).value();
    servo->setBur(bur);
    servo->swapTooth(&tooth, true);
    servo->setDrill(true);
    glm::vec3 device(0.0F, 0.0F, 0.01F);
    servo->step(&device, std::chrono::milliseconds(1));
    do {
        device.z = static_cast<float>(servo->state().anchorMm.z - newtons / settings.force.stiffnessNPerMm);
        servo->step(&device, std::chrono::milliseconds(1));
    } while (see(servo->state()));
}

/// Returns the depth of the tip in each tick until it is this far past the junction of enamel and dentin.
std::vector<double> depthsThroughTheJunction(std::size_t bur, double pastMm)
{
    std::vector<double> depth;
    press([](glm::dvec2) { return enamelAbove(kDejMm); }, bur, 1.0,
          [&](const core::servo::ServoState& state) {
              depth.push_back(-state.anchorMm.z);
              return depth.back() < -kDejMm + pastMm;
          });
    return depth;
}

}  // namespace

class TestCutting : public QObject
{
    Q_OBJECT
private slots:
    void paceIsThatOfTheLaw_data()
    {
        support::columns<int, double>("material", "newtons");
        for (const int material : {0, 1, 2})
            for (const double newtons : {0.5, 1.0, 1.5, 2.0})
                QTest::addRow("material %d, %g N", material, newtons) << material << newtons;
    }

    void paceIsThatOfTheLaw()
    {
        QFETCH(int, material);
        QFETCH(double, newtons);
        for (const double down : {0.0, 90.0}) {
            lab::PaceTrial trial;
            trial.material = static_cast<Material>(material);
            trial.newtons = newtons;
            const double seconds = material == 1 ? 1.0 : 0.25;  // in soft material the bur is soon through the block
            trial.towards = lab::feed(20.0, down);
            const double lawful = lab::lawfulMm3PerS(trial) * seconds;
            // Measures after the start, because a contact must first be more than a brush.
            trial.seconds = seconds;
            const double begun = lab::removedMm3(trial);
            trial.seconds = 2.0 * seconds;
            const double removed = lab::removedMm3(trial) - begun;
            QVERIFY2(std::abs(removed - lawful) < 0.03 * lawful,
                     qPrintable(QString("%1 degrees down: %2 against %3 mm3").arg(down).arg(removed).arg(lawful)));
        }
    }

    void paceIsIndependentOfTheGrid_data() { burs(); }

    void paceIsIndependentOfTheGrid()
    {
        QFETCH(std::size_t, bur);
        for (const double down : {0.0, 45.0, 90.0})
            QVERIFY(isIndependent(trialOf(bur, 20.0, down), {100.0, 150.0, 300.0, 600.0},
                                  [](lab::PaceTrial& trial, double side) { trial.side = static_cast<int>(side); }));
    }

    void paceIsIndependentOfTheRate_data() { burs(); }

    void paceIsIndependentOfTheRate()
    {
        QFETCH(std::size_t, bur);
        for (const double down : {0.0, 45.0, 90.0})
            QVERIFY(isIndependent(trialOf(bur, 20.0, down), {500.0, 1000.0, 2000.0, 4000.0},
                                  [](lab::PaceTrial& trial, double rateHz) { trial.rateHz = rateHz; }));
    }

    void paceIsIndependentOfTheHeading_data() { burs(); }

    void paceIsIndependentOfTheHeading()
    {
        QFETCH(std::size_t, bur);
        std::vector<double> headings;
        for (int heading = 0; heading < 360; heading += support::trials(75, 15))
            headings.push_back(heading);
        for (const int side : {100, 150}) {
            for (const double down : {0.0, 45.0}) {
                lab::PaceTrial trial = trialOf(bur, 0.0, down);
                trial.side = side;
                QVERIFY(isIndependent(trial, headings, [down](lab::PaceTrial& varied, double heading) {
                    varied.towards = lab::feed(heading, down);
                }));
            }
        }
    }

    void sidewaysIsEasierByTheSetting()
    {
        for (const double share : {0.4, 0.65, 1.0}) {
            lab::PaceTrial trial;
            trial.seconds = 1.0;
            trial.settings.hardness.axialShare = share;
            trial.settings.hardness.flatEndShare = 1.0;
            const double down = lab::removedMm3(trial);
            trial.towards = lab::feed(20.0, 0.0);
            const double sideways = lab::removedMm3(trial);
            QVERIFY2(std::abs(down / sideways - share) < 0.03 * share,
                     qPrintable(QString("%1 down, %2 sideways for a share of %3").arg(down).arg(sideways).arg(share)));
        }
    }

    void rippleIsNotFelt_data() { burs(); }

    void rippleIsNotFelt()
    {
        QFETCH(std::size_t, bur);
        int n = static_cast<int>(bur);
        for (const int side : {100, 150})
            for (const Material material : {Material::Enamel, Material::Dentin})
                for (const double heading : {0.0, 30.0})
                    for (const double down : {0.0, 90.0})
                        for (const lab::Feeder feeder : {lab::Feeder::Speed, lab::Feeder::Force}) {
                            if (!support::isTried(n++))
                                continue;
                            lab::PaceTrial trial = trialOf(bur, heading, down);
                            trial.side = side;
                            trial.material = material;
                            trial.newtons =
                                material == Material::Enamel ? 1.0 : 0.5;  // or it is soon through the block
                            trial.seconds = 3.0;
                            const lab::Ripple ripple = lab::measureRipple(trial, feeder);
                            QVERIFY2(ripple.rmsN < 0.1, qPrintable(QString("%1 N").arg(ripple.rmsN)));
                            // The bur drilled steadily. A slide at the speed of the whole section needs less force
                            // while the end of the bur is not yet down.
                            QVERIFY2(std::abs(ripple.meanN - trial.newtons) < 0.25 * trial.newtons,
                                     qPrintable(QString("mean %1 N").arg(ripple.meanN)));
                        }
    }

    void feedChangesAtTheJunction_data() { burs(); }

    /// Presses 1 N straight down through enamel into dentin. Up to the junction the feed is that of enamel. A cell past
    /// it the change must be felt, even with a ball, whose tip alone is there.
    void feedChangesAtTheJunction()
    {
        QFETCH(std::size_t, bur);
        const std::vector<double> depth = depthsThroughTheJunction(bur, 3.0 * kCellMm);
        const auto secondsAt = [&](double mm) {
            const auto reached = std::lower_bound(depth.begin(), depth.end(), mm);
            const auto k = static_cast<double>(reached - depth.begin());
            return 0.001 * (k - (*reached - mm) / (*reached - *(reached - 1)));
        };
        const auto feedOver = [&](double from, double to) { return (to - from) / (secondsAt(to) - secondsAt(from)); };
        const double enamel = feedOver(-kDejMm - 3.0 * kCellMm, -kDejMm - 2.0 * kCellMm);
        const double before = feedOver(-kDejMm - kCellMm, -kDejMm);
        const double after = feedOver(-kDejMm + kCellMm, -kDejMm + 2.0 * kCellMm);
        QVERIFY2(std::abs(before / enamel - 1.0) < 0.03, qPrintable(QString("%1 and %2 mm/s").arg(enamel).arg(before)));
        QVERIFY2(after / enamel > 1.15, qPrintable(QString("%1 and %2 mm/s").arg(enamel).arg(after)));
    }

    /// The whole of a flat end reaches the junction at the same time, so half of the change is within one cell.
    void flatEndFeelsTheJunctionWithinACell()
    {
        const std::vector<double> depth = depthsThroughTheJunction(core::bur::findBur("57").value(), 0.5);
        const auto feedAt = [&](std::size_t tick) { return (depth[tick] - depth[tick - 10]) / 0.01; };
        const auto tickAt = [&](double mm) {
            return static_cast<std::size_t>(std::lower_bound(depth.begin(), depth.end(), mm) - depth.begin());
        };
        const double half = 0.5 * (feedAt(tickAt(-kDejMm - 0.2)) + feedAt(tickAt(-kDejMm + 0.4)));
        std::size_t tick = tickAt(-kDejMm - 0.2);
        while (feedAt(tick) < half)
            ++tick;
        QVERIFY2(std::abs(depth[tick] + kDejMm) < kCellMm, qPrintable(QString("at %1 mm").arg(depth[tick])));
    }

    void mixedGroundSharesTheTime()
    {
        // Enamel under one half of the bur and dentin under the other: the time is sum V_m / rate_m, in any order.
        for (std::size_t bur = 0; bur < core::bur::kCommonBurs; ++bur) {
            constexpr int kTicks = 1500;
            int ticks = 0;
            core::terrain::PerMaterial removed{};
            press([](glm::dvec2 p) { return enamelAbove(p.x < 0.0 ? -50.0 : 50.0); }, bur, 1.0,
                  [&](const core::servo::ServoState& state) {
                      removed = state.removedMm3;
                      return ++ticks < kTicks;
                  });
            double seconds = 0.0;
            for (const Material material : {Material::Enamel, Material::Dentin}) {
                const auto m = static_cast<std::size_t>(material);
                QVERIFY(removed[m] > 0.1);
                lab::PaceTrial alone;
                alone.bur = bur;
                alone.material = material;
                seconds += removed[m] / lab::lawfulMm3PerS(alone);
            }
            QVERIFY2(std::abs(seconds - 0.001 * kTicks) < 0.03 * 0.001 * kTicks, qPrintable(QString::number(seconds)));
            // Both halves sink at the same rate, so their volumes are equal.
            const double ratio = removed[1] / removed[2];
            QVERIFY2(std::abs(ratio - 1.0) < 0.2, qPrintable(QString::number(ratio)));
        }
    }

private:
    static void burs()
    {
        QTest::addColumn<std::size_t>("bur");
        for (std::size_t bur = 0; bur < 4; ++bur)
            QTest::addRow("bur %zu", bur) << bur;
    }
};

QTEST_APPLESS_MAIN(TestCutting)
#include "tst_cutting.moc"
