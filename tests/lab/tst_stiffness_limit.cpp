// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>

#include "lab/StiffnessLimit.h"
#include "tests/support/Tables.h"
#include "tests/support/Trials.h"

namespace {

/// Returns a loop with spring and dry friction only, as in the table.
lab::ClosedLoop loopWith(std::size_t hand, double delayMs)
{
    lab::ClosedLoop loop;
    loop.settings.force.dampingNSPerM = 0.0;
    loop.settings.force.fastDampingNSPerM = 0.0;
    loop.settings.force.brakeN = 0.0;
    loop.hand = haptics::kHands[hand];
    loop.falcon.delayS = delayMs * 0.001;
    loop.falcon.delayJitterS = 0.0;
    return loop;
}

lab::ClosedLoop shipped(std::size_t hand, double delayMs)
{
    lab::ClosedLoop loop = loopWith(hand, delayMs);
    loop.settings.force = {};
    return loop;
}

double limitOf(const lab::ClosedLoop& loop)
{
    return lab::stiffnessLimit(loop).value();
}

}  // namespace

class TestStiffnessLimit : public QObject
{
    Q_OBJECT
private slots:
    /// docs/facts/haptics.md, section 2.2, uses one axis and motors without lag. The whole servo in three axes must
    /// agree.
    void flatToothIsTheOneAxisWall_data()
    {
        support::columns<std::size_t, double, double>("hand", "delayMs", "nPerMm");
        QTest::newRow("light, 1 ms") << std::size_t{0} << 1.0 << 2.986;
        QTest::newRow("light, 4 ms") << std::size_t{0} << 4.0 << 0.684;
        QTest::newRow("medium, 2 ms") << std::size_t{1} << 2.0 << 3.306;
        QTest::newRow("firm, 4 ms") << std::size_t{2} << 4.0 << 3.332;
    }

    void flatToothIsTheOneAxisWall()
    {
        QFETCH(std::size_t, hand);
        QFETCH(double, delayMs);
        QFETCH(double, nPerMm);
        lab::ClosedLoop loop = loopWith(hand, delayMs);
        loop.falcon.motorLagS = 0.0;
        const double limit = limitOf(loop);
        QVERIFY2(std::abs(limit / nPerMm - 1.0) < 0.05, qPrintable(QString::number(limit)));
    }

    void delayAndLagCostStiffness()
    {
        lab::ClosedLoop prompt = loopWith(1, 1.0);
        prompt.falcon.motorLagS = 0.0;
        const double promptly = limitOf(prompt);
        const double lagging = limitOf(loopWith(1, 1.0));
        const double late = limitOf(loopWith(1, 4.0));
        QVERIFY2(lagging < 0.6 * promptly, qPrintable(QString::number(lagging)));
        QVERIFY2(late < 0.5 * lagging, qPrintable(QString::number(late)));
    }

    void whatWeShipHoldsEveryHand_data()
    {
        support::columns<std::size_t, double>("hand", "delayMs");
        for (std::size_t hand = 0; hand < haptics::kHands.size(); ++hand)
            for (const double delayMs : {0.0, 1.0, 2.0})
                QTest::addRow("%zu, %g ms", hand, delayMs) << hand << delayMs;
        // At this delay the servo loop has halved the stiffness. Even the lightest hand is stable with more than twice
        // that.
        QTest::newRow("a slow loop") << std::size_t{0} << 4.0;
    }

    void whatWeShipHoldsEveryHand()
    {
        QFETCH(std::size_t, hand);
        QFETCH(double, delayMs);
        const double limit = limitOf(shipped(hand, delayMs));
        QVERIFY2(limit > core::contact::ForceSettings{}.stiffnessNPerMm, qPrintable(QString::number(limit)));
    }

    /// Compares with the best setting of the pipeline of 2011 whose friction cannot be felt (CedsFigures), in every
    /// cell of the table.
    void oursIsTwiceAsStiffAsThePipelineOf2011_data()
    {
        support::columns<std::size_t, double>("hand", "delayMs");
        int n = 0;
        for (std::size_t hand = 0; hand < haptics::kHands.size(); ++hand)
            for (const double delayMs : {0.0, 1.0, 2.0, 4.0})
                if (support::isTried(n++))
                    QTest::addRow("%zu, %g ms", hand, delayMs) << hand << delayMs;
    }

    void oursIsTwiceAsStiffAsThePipelineOf2011()
    {
        QFETCH(std::size_t, hand);
        QFETCH(double, delayMs);
        lab::ClosedLoop loop = shipped(hand, delayMs);
        const double ours = limitOf(loop);
        loop.settings.method = lab::kCeds2011;
        const double old = limitOf(loop);
        QVERIFY2(old < lab::kStiffestNPerMm, qPrintable(QString::number(old)));
        QVERIFY2(ours > 2.0 * old, qPrintable(QString("%1 and %2 N/mm").arg(ours).arg(old)));
    }

    void everyMethodAndRateHasALimit_data()
    {
        support::columns<QString, double>("method", "rateHz");
        for (const char* method : {"continuous", "lattice", "penalty"})
            for (const double rateHz : {250.0, 2000.0})
                QTest::addRow("%s, %g Hz", method, rateHz) << QString(method) << rateHz;
    }

    void everyMethodAndRateHasALimit()
    {
        QFETCH(QString, method);
        QFETCH(double, rateHz);
        lab::ClosedLoop loop = loopWith(1, 2.0);
        loop.settings.method = method.toStdString();
        loop.rateHz = rateHz;
        const double limit = limitOf(loop);
        QVERIFY2(limit > 0.5 && limit < 5.0, qPrintable(QString::number(limit)));
    }

    /// The lattice method fails from 7 N/mm on, and is stable again between 11 and 13.
    void islandsBeyondTheLimitDoNotCount()
    {
        lab::ClosedLoop loop = loopWith(2, 1.0);
        loop.settings.method = "lattice";
        const double limit = limitOf(loop);
        QVERIFY2(limit < 9.0, qPrintable(QString::number(limit)));
    }

    void unknownMethodIsRefused()
    {
        lab::ClosedLoop loop;
        loop.settings.method = "magic";
        QCOMPARE(lab::stiffnessLimit(loop).error().code, core::ErrorCode::UnknownName);
    }
};

QTEST_APPLESS_MAIN(TestStiffnessLimit)
#include "tst_stiffness_limit.moc"
