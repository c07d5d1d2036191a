// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "core/settings/StabilityBound.h"
#include "lab/Stability.h"
#include "lab/StiffnessLimit.h"
#include "tests/support/Suite.h"
#include "tests/support/Tables.h"
#include "tests/support/Trials.h"

using namespace core;

namespace {

/// Returns the loop that the bound applies to: the light hand at 2 ms.
lab::ClosedLoop loopOf(const settings::FeelPreset& preset)
{
    lab::ClosedLoop loop;
    loop.hand = haptics::kHands[0];
    const settings::LoopFigures figures;
    loop.falcon.delayS = figures.delayS;
    loop.falcon.delayJitterS = 0.0;
    settings::putForces(preset, loop.settings.force);
    return loop;
}

settings::FeelPreset damped(double damping, double fast)
{
    settings::FeelPreset preset;
    preset.dampingNSPerM = damping;
    preset.fastDampingNSPerM = fast;
    return preset;
}

}  // namespace

class TestStabilityBound : public QObject
{
    Q_OBJECT
private slots:
    void figuresAreTheSimulatedDevices()
    {
        const settings::LoopFigures figures;
        const haptics::FalconFigures falcon;
        QCOMPARE(figures.massKg, falcon.massKg + haptics::kHands[0].massKg);
        QCOMPARE(figures.viscousNSPerM, falcon.viscousNSPerM + haptics::kHands[0].dampingNSPerM);
        QCOMPARE(figures.coulombN, falcon.coulombN);
        QCOMPARE(figures.motorLagS, falcon.motorLagS);
        QCOMPARE(figures.forceLimitN, falcon.forceLimitN);
    }

    void whatIsInsideHoldsAndTwiceAsMuchDoesNot_data()
    {
        support::columns<double, double>("damping", "fast");
        for (int n = 0; const double damping : {0.0, 3.0, 10.0, 20.0})
            for (const double fast : {0.0, 10.0, 30.0, 60.0})
                if (support::isTried(n++))
                    QTest::addRow("%g and %g N s/m", damping, fast) << damping << fast;
    }

    /// The limit that lab::stiffnessLimit finds by simulation is between the bound and twice the bound, for all values
    /// of both dampers. (Higher stiffnesses may be stable again: the limit is the first that fails.)
    void whatIsInsideHoldsAndTwiceAsMuchDoesNot()
    {
        QFETCH(double, damping);
        QFETCH(double, fast);
        const settings::FeelPreset preset = damped(damping, fast);
        const double bound = settings::stabilityBound(preset).stiffnessNPerMm;
        const double limit = lab::stiffnessLimit(loopOf(preset)).value();
        const QString said = QString("bound %1, limit %2 N/mm").arg(bound).arg(limit);
        QVERIFY2(limit > bound, qPrintable(said));
        QVERIFY2(limit < 2.0 * bound, qPrintable(said));
    }

    /// The same in a scene of its own, with pressing and impacts: a preset just inside the bound comes to rest, and one
    /// of three times the bound swings noticeably.
    void theSimulatedHandSwingsBeyondTheBound()
    {
        settings::FeelPreset preset = damped(3.0, 10.0);
        const double bound = settings::stabilityBound(preset).stiffnessNPerMm;
        const auto outcomeAt = [&](double nPerMm) {
            preset.stiffnessNPerMm = nPerMm;
            const lab::ClosedLoop loop = loopOf(preset);
            lab::StabilityTrial trial;
            trial.settings = loop.settings;
            trial.falcon = loop.falcon;
            trial.hand = loop.hand;
            return lab::tryStability("impact 50", trial).value();
        };
        const lab::StabilityResult inside = outcomeAt(0.95 * bound);
        QVERIFY2(inside.swingMm < lab::kSwingMm, qPrintable(QString::number(inside.swingMm)));
        const lab::StabilityResult beyond = outcomeAt(3.0 * bound);
        QVERIFY2(beyond.swingMm > lab::kSwingMm, qPrintable(QString::number(beyond.swingMm)));
    }

    void whatIsShippedIsInside()
    {
        QVERIFY(settings::checkStability({}));
        const settings::StabilityBound bound = settings::stabilityBound({});
        QVERIFY(bound.stiffnessNPerMm > 2.0 * settings::FeelPreset{}.stiffnessNPerMm);
        QCOMPARE(bound.set, settings::StabilityBound::Set::Damping);
        QCOMPARE(settings::stabilityBound(damped(20.0, 60.0)).set, settings::StabilityBound::Set::Lateness);
        settings::LoopFigures prompt;
        prompt.delayS = 0.0;
        prompt.motorLagS = 0.0;
        QCOMPARE(settings::stabilityBound(damped(20.0, 60.0), prompt).set, settings::StabilityBound::Set::Buzz);
    }

    void refusalNamesValueAndBound()
    {
        settings::FeelPreset stiff;
        stiff.stiffnessNPerMm = 12.0;
        const auto said = [](const settings::FeelPreset& preset) {
            const Status sound = settings::checkStability(preset);
            return sound ? QString() : QString::fromStdString(sound.error().detail);
        };
        QVERIFY2(said(stiff).contains("the stiffness is 12 N/mm") && said(stiff).contains("up to 5.35 N/mm"),
                 qPrintable(said(stiff)));
        settings::FeelPreset bare = damped(0.0, 0.0);
        QVERIFY2(said(bare).contains("2 N/mm") && said(bare).contains("damp more"), qPrintable(said(bare)));
        settings::FeelPreset strong;
        strong.clampN = 12.0;
        QVERIFY2(said(strong).contains("12 N") && said(strong).contains("8.9 N"), qPrintable(said(strong)));
        strong.clampN = 1.0e9;
        QVERIFY2(said(strong).contains("force.limit_n"), qPrintable(said(strong)));
    }
};

CUSP_TEST(TestStabilityBound)
#include "tst_stability_bound.moc"
