// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "lab/Stability.h"

namespace {

lab::StabilityResult tried(const char* scene, const char* method, double delayMs = 1.0, std::size_t hand = 1)
{
    lab::StabilityTrial trial;
    trial.settings.method = method;
    trial.falcon.delayS = delayMs * 0.001;
    trial.falcon.delayJitterS = 0.0;
    trial.hand = haptics::kHands[hand];
    return lab::tryStability(scene, trial).value();
}

QString told(const lab::StabilityResult& result)
{
    const std::string_view name = lab::nameOf(result.outcome);
    return QString("%1: swing %2 mm, ripple %3 N, lag %4 mm")
        .arg(QLatin1String(name.data(), static_cast<qsizetype>(name.size())))
        .arg(result.swingMm)
        .arg(result.rippleN)
        .arg(result.lagMm);
}

}  // namespace

class TestStability : public QObject
{
    Q_OBJECT
private slots:
    void whatWeShipComesToRest_data();
    void whatWeShipComesToRest();
    void penaltyGoesThroughARidge();
    void aBurThatBeginsInsideIsLeftAlone();
    void theSameTrialTwiceIsTheSame();
    void unknownSceneIsRefused();
};

void TestStability::whatWeShipComesToRest_data()
{
    QTest::addColumn<QString>("scene");
    QTest::addColumn<std::size_t>("hand");
    for (const QString& scene : QStringList{"push", "pit", "groove", "slope", "wall", "ridge, 1 cell", "step 0.2",
                                            "drill 2", "dropout 100", "inside"})
        for (std::size_t hand = 0; hand < haptics::kHands.size(); ++hand)
            QTest::addRow("%s, hand %zu", qPrintable(scene), hand) << scene << hand;
}

void TestStability::whatWeShipComesToRest()
{
    QFETCH(QString, scene);
    QFETCH(std::size_t, hand);
    for (const double delayMs : {0.0, 1.0, 2.0}) {
        const lab::StabilityResult result = tried(qPrintable(scene), "continuous", delayMs, hand);
        QVERIFY2(result.outcome == lab::Outcome::Holds || result.outcome == lab::Outcome::Buzzes,
                 qPrintable(QString("%1 ms: %2").arg(delayMs).arg(told(result))));
    }
}

void TestStability::penaltyGoesThroughARidge()
{
    const lab::StabilityResult result = tried("ridge, 1 cell", "penalty");
    QVERIFY2(result.outcome == lab::Outcome::Crosses, qPrintable(told(result)));
    QVERIFY(tried("ridge, 1 cell", "lattice").outcome != lab::Outcome::Crosses);
}

void TestStability::aBurThatBeginsInsideIsLeftAlone()
{
    for (std::size_t hand = 0; hand < haptics::kHands.size(); ++hand) {
        const lab::StabilityResult result = tried("inside", "continuous", 1.0, hand);
        QVERIFY2(result.outcome != lab::Outcome::Crosses, qPrintable(told(result)));
    }
}

void TestStability::theSameTrialTwiceIsTheSame()
{
    const lab::StabilityResult one = tried("groove", "lattice");
    const lab::StabilityResult two = tried("groove", "lattice");
    QCOMPARE(one.rippleN, two.rippleN);
    QCOMPARE(one.swingMm, two.swingMm);
}

void TestStability::unknownSceneIsRefused()
{
    QCOMPARE(lab::tryStability("nowhere", {}).error().code, core::ErrorCode::UnknownName);
}

QTEST_APPLESS_MAIN(TestStability)
#include "tst_stability.moc"
