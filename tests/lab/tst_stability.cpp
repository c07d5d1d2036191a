// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "lab/Stability.h"
#include "tests/support/Tables.h"
#include "tests/support/Trials.h"

using lab::Outcome;

namespace {

constexpr std::size_t kLight = 0;
constexpr std::size_t kMedium = 1;
constexpr std::size_t kFirm = 2;
/// The one scene that is unstable in theory, see withoutDryFrictionEveryLoopTrembles().
const QString kNoFriction = "counts 50, no friction";

lab::StabilityTrial trialOf(const QString& method, double delayMs, std::size_t hand = kMedium, double nPerMm = 2.0)
{
    lab::StabilityTrial trial;
    trial.settings.method = method.toStdString();
    trial.settings.force.stiffnessNPerMm = nPerMm;
    trial.falcon.delayS = delayMs * 0.001;
    trial.falcon.delayJitterS = 0.0;
    trial.hand = haptics::kHands[hand];
    return trial;
}

lab::StabilityResult tried(const QString& scene, const lab::StabilityTrial& trial)
{
    return lab::tryStability(scene.toStdString(), trial).value();
}

QString latin(std::string_view text)
{
    return QString::fromLatin1(text.data(), static_cast<qsizetype>(text.size()));
}

QString told(const lab::StabilityResult& result)
{
    return QString("%1%2: swing %3 mm, ripple %4 N, jump %5 N, lag %6 mm, error %7 mm, leak %8 and %9 uJ")
        .arg(latin(lab::nameOf(result.outcome)), result.missed.empty() ? QString() : ", " + latin(result.missed))
        .arg(result.swingMm)
        .arg(result.rippleN)
        .arg(result.jumpN)
        .arg(result.lagMm)
        .arg(result.errorMm)
        .arg(result.leakUj)
        .arg(result.springLeakUj);
}

/// Returns whether a missed limit is not due to the force law, or cannot be met by any spring of 2 N/mm: see the tests
/// below.
bool isKnownMiss(std::string_view scene, const lab::StabilityResult& result)
{
    const std::string_view missed = result.missed;
    // All three arms step in one tick, 0.08 mm, when the bur comes off the side of the step: 0.52 N instead of 0.5.
    if (scene == "step 0.5")
        return missed == "jump" && result.jumpN < 0.55;
    // A count of 0.05 mm is a step of 0.1 N. The limit of 0.02 N is for a device that reads exactly.
    if (scene.starts_with("groove"))
        return missed == "ripple";
    // The depth that a brush of 0.3 N cuts depends on cutting.
    return scene == "brush, drilling" && missed == "depth";
}

}  // namespace

class TestStability : public QObject
{
    Q_OBJECT
private slots:
    void everySceneOfTheTableIsThere()
    {
        QList<int> numbers;
        for (const lab::StabilitySceneName& scene : lab::stabilityScenesAndBars())
            if (scene.number > 0 && !numbers.contains(scene.number))
                numbers << scene.number;
        std::sort(numbers.begin(), numbers.end());
        QCOMPARE(numbers, (QList<int>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16}));
        QCOMPARE(lab::stabilityScenes().size(), lab::stabilityScenesAndBars().size());
    }

    void whatWeShipHolds_data()
    {
        support::columns<QString, int>("scene", "first");
        for (int first = 0; const std::string_view name : lab::stabilityScenes())
            if (latin(name) != kNoFriction)
                QTest::addRow("%s", qPrintable(latin(name))) << latin(name) << first++;
    }

    /// The loop is stable with every hand and up to 2 ms of delay, and at 4 ms, where the servo loop has halved its
    /// spring. A buzz counts as unstable, with one exception: at 4 ms a light hand feels the columns of the trench that
    /// brushing has cut (0.07 N).
    void whatWeShipHolds()
    {
        QFETCH(QString, scene);
        QFETCH(int, first);
        for (int n = first; const double delayMs : {0.0, 1.0, 2.0, 4.0}) {
            for (std::size_t hand = 0; hand < haptics::kHands.size(); ++hand) {
                if (!support::isTried(n++))
                    continue;
                const lab::StabilityResult result = tried(scene, trialOf("continuous", delayMs, hand));
                const QString where = QString("%1 ms, hand %2: ").arg(delayMs).arg(hand) + told(result);
                const bool mayBuzz = scene == "brush, drilling" && delayMs > 2.0 && hand == 0;
                QVERIFY2(result.outcome == Outcome::Holds || (mayBuzz && result.outcome == Outcome::Buzzes),
                         qPrintable(where));
                if (delayMs <= 2.0 && !isKnownMiss(scene.toStdString(), result))
                    QVERIFY2(result.missed.empty(), qPrintable(where));
            }
        }
    }

    /// The loop diverged here before the damping grew with the speed: dry friction stops only 68 mm/s
    /// (docs/facts/haptics.md, section 2.1).
    void hardImpactsHoldAtThreeNewtonsAMillimetre()
    {
        for (std::size_t hand = 0; hand < haptics::kHands.size(); ++hand) {
            const lab::StabilityResult result = tried("impact 400", trialOf("continuous", 2.0, hand, 3.0));
            QVERIFY2(result.outcome == Outcome::Holds, qPrintable(told(result)));
        }
    }

    /// A buzz in a scene comes from the loop itself: a device that reads exactly and responds at once shows none.
    void exactDeviceTremblesNowhere()
    {
        for (const lab::StabilitySceneName& scene : lab::stabilityScenesAndBars()) {
            lab::StabilityTrial trial = trialOf("continuous", 0.0);
            trial.falcon.countShare = 0.0;
            trial.falcon.motorLagS = 1.0e-6;
            const lab::StabilityResult result = tried(latin(scene.name), trial);
            QVERIFY2(result.outcome == Outcome::Holds && result.rippleN < 0.5 * scene.bars.buzzN,
                     qPrintable(latin(scene.name) + ", " + told(result)));
        }
    }

    void exactDeviceIsSmoothInAGroove()
    {
        for (const char* scene : {"groove", "groove, a quarter", "groove, a half"}) {
            lab::StabilityTrial trial = trialOf("continuous", 1.0);
            trial.falcon.countShare = 0.0;
            const lab::StabilityResult result = tried(scene, trial);
            QVERIFY2(result.missed.empty(), qPrintable(told(result)));
        }
    }

    /// Abbott & Okamura 2005: a count causes a buzz if the spring is stiffer than 2 fc / D, which is 0 without dry
    /// friction.
    void withoutDryFrictionEveryLoopTrembles()
    {
        for (const std::string_view method : lab::contestants()) {
            const lab::StabilityResult result = tried(kNoFriction, trialOf(latin(method), 2.0, kLight));
            QVERIFY2(result.outcome != Outcome::Holds, qPrintable(latin(method) + ", " + told(result)));
            const lab::StabilityResult rubbed = tried("counts 50, least friction", trialOf(latin(method), 1.0, kLight));
            QVERIFY2(rubbed.outcome == Outcome::Holds, qPrintable(latin(method) + ", " + told(rubbed)));
        }
    }

    /// The failures of methods (docs/facts/haptics.md, section 3.3).
    ///
    /// Not seen are the steps of the lattice method at the wall, 0.14 N. They exist (jump), but at 2.5 mm/s they come
    /// 36 times a second and cause no buzz. The lattice method with sixteen steps does not jump over a ridge, because
    /// each step begins where the last one ended.
    void failuresAreSeen_data()
    {
        support::columns<QString, QString, std::size_t, double, int, QString>("method", "scene", "hand", "delayMs",
                                                                              "outcome", "missed");
        const auto add = [](const char* method, const char* scene, std::size_t hand, double delayMs, int outcome,
                            const char* missed = "") {
            QTest::addRow("%s, %s", method, scene)
                << QString(method) << QString(scene) << hand << delayMs << outcome << QString(missed);
        };
        constexpr int kAny = -1;
        constexpr int kNoHold = -2;  // a method without memory is chaotic: it buzzes in one build and swings in another
        const auto code = [](Outcome outcome) { return static_cast<int>(outcome); };
        // Penalty, without memory: crosses the ridge, changes between the walls of a groove, rises beside a wall, and
        // misleads itself while cutting.
        add("penalty", "ridge, 1 cell", kMedium, 1.0, code(Outcome::Crosses));
        add("penalty", "ridge, 2 cells", kLight, 0.0, code(Outcome::Crosses));
        add("penalty", "groove", kMedium, 2.0, kNoHold, "ripple");
        add("penalty", "groove, a half", kMedium, 1.0, kNoHold, "ripple");
        add("penalty", "pit", kFirm, 1.0, kNoHold, "jump");
        add("penalty", "wall", kFirm, 1.0, kAny, "error");
        add("penalty", "drill 2", kMedium, 1.0, kNoHold);
        add("penalty", "loops, ridge", kMedium, 1.0, code(Outcome::Diverges));
        // One cell per tick is 70 mm/s. On a slope the nearer cells are not free, whatever the number of steps.
        add("lattice", "brush", kLight, 1.0, code(Outcome::Sticks), "lag");
        add("lattice", "brush", kFirm, 1.0, code(Outcome::Sticks), "lag");
        add("lattice", "slope", kFirm, 1.0, code(Outcome::Sticks), "lag");
        add("lattice16", "slope", kFirm, 1.0, code(Outcome::Sticks), "lag");
        // The pipeline of 2011: the same anchor; its force filter lags, and it handles neither delay nor a lost device.
        add("ceds 2011", "brush", kLight, 1.0, code(Outcome::Sticks), "lag");
        add("ceds 2011", "slope", kMedium, 1.0, code(Outcome::Sticks), "lag");
        add("ceds 2011", "groove", kFirm, 1.0, code(Outcome::Buzzes), "ripple");
        add("ceds 2011", "impact 50", kLight, 4.0, code(Outcome::Diverges), "settling");
        add("ceds 2011", "impact 400", kLight, 4.0, code(Outcome::Diverges), "settling");
        add("ceds 2011", "dropout 100", kMedium, 1.0, kAny, "jump");
        add("ceds 2011", "inside", kMedium, 1.0, code(Outcome::Crosses));
    }

    void failuresAreSeen()
    {
        QFETCH(QString, method);
        QFETCH(QString, scene);
        QFETCH(std::size_t, hand);
        QFETCH(double, delayMs);
        QFETCH(int, outcome);
        QFETCH(QString, missed);
        const lab::StabilityResult result = tried(scene, trialOf(method, delayMs, hand));
        if (outcome == -2)
            QVERIFY2(result.outcome != Outcome::Holds, qPrintable(told(result)));
        if (outcome >= 0)
            QVERIFY2(static_cast<int>(result.outcome) == outcome, qPrintable(told(result)));
        if (!missed.isEmpty())
            QVERIFY2(latin(result.missed) == missed, qPrintable(told(result)));
    }

    void latticeHangsAboveAPit()
    {
        const double ours = tried("pit", trialOf("continuous", 1.0)).errorMm;
        QVERIFY2(ours < 0.02, qPrintable(QString::number(ours)));
        for (const char* method : {"lattice", "lattice16", "ceds 2011"}) {
            const double error = tried("pit", trialOf(method, 1.0)).errorMm;
            QVERIFY2(error > 0.1, qPrintable(QString("%1: %2 mm").arg(method).arg(error)));
        }
    }

    void onlyTheBetterMethodFollowsASlope()
    {
        for (std::size_t hand = 0; hand < haptics::kHands.size(); ++hand) {
            const double lag = tried("slope", trialOf("continuous", 1.0, hand)).lagMm;
            QVERIFY2(lag < 0.002, qPrintable(QString::number(lag)));
        }
    }

    /// Damping and friction of the force law hide the energy that the method adds. The bare spring shows it
    /// (docs/facts/haptics.md, section 2.5).
    void penaltyMakesEnergyAtARidge()
    {
        for (const lab::StabilitySceneName& scene : lab::stabilityScenesAndBars()) {
            if (scene.number != 16)
                continue;
            const lab::StabilityResult ours = tried(latin(scene.name), trialOf("continuous", 1.0));
            QVERIFY2(ours.leakUj < 0.0 && ours.springLeakUj < 0.1, qPrintable(told(ours)));
        }
        const lab::StabilityResult penalty = tried("loops, ridge", trialOf("penalty", 1.0));
        QVERIFY2(penalty.leakUj < 0.0 && penalty.springLeakUj > 10.0, qPrintable(told(penalty)));
    }

    /// Shows why the pipeline of 2011 cannot simply have more friction: see CedsFigures.
    void strongBackwardDifferenceTrembles()
    {
        lab::StabilityTrial trial = trialOf("ceds 2011", 1.0);
        QVERIFY(tried("push", trial).outcome == Outcome::Holds);
        trial.ceds.frictionNSPerM = 10.0;
        const lab::StabilityResult result = tried("push", trial);
        QVERIFY2(result.outcome == Outcome::Buzzes, qPrintable(told(result)));
    }

    void theSameTrialTwiceIsTheSame()
    {
        for (const char* scene : {"groove", "jitter", "tremor"}) {
            const lab::StabilityResult one = tried(scene, trialOf("lattice", 1.0));
            const lab::StabilityResult two = tried(scene, trialOf("lattice", 1.0));
            QCOMPARE(one.rippleN, two.rippleN);
            QCOMPARE(one.swingMm, two.swingMm);
            QCOMPARE(one.mostN, two.mostN);
        }
    }

    void unknownSceneAndMethodAreRefused()
    {
        QCOMPARE(lab::tryStability("nowhere", {}).error().code, core::ErrorCode::UnknownName);
        QCOMPARE(lab::tryStability("push", trialOf("magic", 1.0)).error().code, core::ErrorCode::UnknownName);
    }
};

QTEST_APPLESS_MAIN(TestStability)
#include "tst_stability.moc"
