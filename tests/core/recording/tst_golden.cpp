// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QFile>
#include <QTest>
#include <cstdlib>

#include <glm/geometric.hpp>

#include "core/contact/Kernels.h"
#include "core/recording/Replay.h"
#include "core/servo/ServoState.h"
#include "core/session/SessionChannels.h"
#include "tests/support/Checks.h"
#include "tests/support/Rig.h"
#include "tests/support/Suite.h"
#include "tests/support/SyntheticMolar.h"

using namespace core;

namespace {

const QString kGolden = QStringLiteral(CUSP_SOURCE_DIR "/tests/golden/attempt.cusprec");

/// Final state hash of the golden attempt, the same with every compiler, build type and processor. If a change of the
/// engine is meant to change it, see tests/golden/README.md.
constexpr std::uint64_t kStateHash = 0x04A17E80EA46B9F9;
constexpr std::uint64_t kTicks = 8571;

/// Records the attempt of the golden file: all burs, two handpieces, all layers, a wall cut from the side, the rim
/// bored through, a lost device, missed ticks, undo, redo.
recording::Recording makeAttempt()
{
    core::servo::ServoSettings settings;
    settings.handpieces.push_back(settings::findHandpiece("low-speed").value());
    support::Rig rig(settings);
    rig.drill(support::syntheticMolar(80));
    // Cuts through the lesion into dentin and pulp.
    rig.send(core::servo::SetBur{1});
    rig.lean(support::kLesionX, support::kLesionY, 3.0, 3500);
    rig.lift();
    // Cuts a trench along the fissure with the side of the bur.
    rig.send(core::servo::SetBur{3});
    for (int n = 0; n < 1500; ++n) {
        const double x = 0.3 - 0.0012 * n;
        rig.lean(x, -0.1 + 0.2 * std::sin(0.01 * n), 1.5, 1);
    }
    rig.device.present = false;
    rig.run(20);
    rig.device.present = true;
    rig.lift();
    // Cuts through the thin rim.
    rig.send(core::servo::SetBur{2});
    for (int n = 0; n < 1500; ++n)
        rig.lean(4.95, 0.0005 * n, 3.0, 1);
    rig.lift();
    rig.send(core::servo::SetBur{0});
    rig.send(core::servo::SetHandpiece{1});
    rig.lean(-2.0, 1.0, 2.0, 500);
    rig.lift();
    rig.send(session::Undo{});
    rig.run(50);
    rig.send(session::Undo{});
    rig.run(50);
    rig.send(session::Redo{});
    rig.run(50);
    rig.lean(1.5, 1.5, 2.0, 300);
    rig.run(100, std::chrono::milliseconds(3));
    rig.lift();
    recording::Recording made = rig.session->recordingSoFar().value();
    made.setWitness({made.ticks(), rig.liveHash()});
    return made;
}

}  // namespace

/// The bits of a replay must not depend on the build. CTest runs this test a second time with CUSP_PLAIN_KERNELS=1.

class TestGolden : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase()
    {
        if (std::getenv("CUSP_REWRITE_GOLDEN") == nullptr)
            return;
        const recording::Recording made = makeAttempt();
        QVERIFY(recording::writeRecording(kGolden.toStdString(), made));
        qInfo("kStateHash = 0x%016llX, kTicks = %llu", static_cast<unsigned long long>(made.witness()->stateHash),
              static_cast<unsigned long long>(made.ticks()));
    }

    void replaysToTheSameBits()
    {
        qInfo("kernels: %s", contact::kernels().name);
        if (std::getenv("CUSP_PLAIN_KERNELS") != nullptr)
            QCOMPARE(contact::kernels().name, contact::kPlainKernels.name);
        const auto golden = recording::readRecording(kGolden.toStdString());
        QVERIFY(support::succeeds(golden));
        const auto outcome = recording::replay(*golden);
        QVERIFY(outcome);
        QCOMPARE(outcome->stateHash, kStateHash);
        QCOMPARE(outcome->state.tick, kTicks);
        QVERIFY(outcome->agreesWithWitness);
    }

    void goesThroughEverything()
    {
        QVERIFY(QFile(kGolden).size() < 300 * 1024);
        const auto read = recording::readRecording(kGolden.toStdString());
        QVERIFY(read);
        const recording::Recording& golden = *read;
        std::array<bool, 4> burs{};
        int handpieces = 0;
        bool lost = false;
        bool late = false;
        int restores = 0;
        golden.forEach([&](const core::servo::ServoEvent& event) {
            if (event.kind == core::servo::ServoEvent::Kind::Bur)
                burs[event.value] = true;
            handpieces += event.kind == core::servo::ServoEvent::Kind::Handpiece ? 1 : 0;
            lost = lost || event.kind == core::servo::ServoEvent::Kind::NoDevice;
            late = late || event.dtUs > 1000;
            restores += event.kind == core::servo::ServoEvent::Kind::Restore ? 1 : 0;
        });
        QCOMPARE(burs, (std::array{true, true, true, true}));
        QCOMPARE(handpieces, 1);
        QVERIFY(lost);
        QVERIFY(late);
        QCOMPARE(restores, 3);
        const auto outcome = recording::replay(golden);
        const terrain::PerMaterial& removed = outcome->state.removedMm3;
        for (const double part : removed)
            QVERIFY(part > 0.01);
        int bored = 0;
        const terrain::Tooth& tooth = outcome->tooth;
        for (std::size_t k = 0; k < tooth.top.size(); ++k)
            bored += !tooth.isSolid(k) && tooth.anatomy->top[k] > tooth.anatomy->bottom[k] ? 1 : 0;
        QVERIFY2(bored > 3, qPrintable(QString::number(bored)));
    }
};

CUSP_TEST(TestGolden)
#include "tst_golden.moc"
