// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <vector>

#include <glm/geometric.hpp>

#include "core/rt/TripleBuffer.h"
#include "core/servo/ServoState.h"
#include "core/servo/ServoTick.h"
#include "haptics/DeviceSwitch.h"
#include "haptics/pointer/PointerDevice.h"
#include "tests/support/Allocations.h"
#include "tests/support/Suite.h"
#include "tests/support/SyntheticTooth.h"

using namespace core;
using namespace std::chrono_literals;

namespace {

/// Reports a position that the test sets, and stores the values that it receives.
struct StubDevice final : haptics::HapticDevice
{
    glm::vec3 tipMm{0.0F, 0.0F, 5.0F};
    glm::dvec3 seenMm{0.0};
    glm::dvec3 forceN{0.0};
    glm::dvec3 givenN{0.0};
    int exchanges = 0;
    int beginnings = 0;
    int waits = 0;

    void seeBur(const glm::dvec3& burMm) noexcept override { seenMm = burMm; }
    haptics::DeviceSample exchange(const glm::dvec3& force) noexcept override
    {
        ++exchanges;
        forceN = force;
        haptics::DeviceSample sample;
        sample.tipInToothMm = tipMm;
        sample.pedal = true;
        return sample;
    }
    void give(const glm::dvec3& force) noexcept override { givenN = force; }
    bool waitForReading(std::chrono::steady_clock::time_point) noexcept override
    {
        ++waits;
        return true;
    }
    void takeOver() noexcept override { ++beginnings; }
};

constexpr glm::dvec3 kSomeN{0.0, 0.0, 2.0};

}  // namespace

class TestDeviceSwitch : public QObject
{
    Q_OBJECT
private slots:
    void everyCallReachesTheSelectedDeviceOnly()
    {
        StubDevice first;
        StubDevice second;
        haptics::DeviceSwitch devices(first, 1ms);
        devices.seeBur({1.0, 2.0, 3.0});
        const haptics::DeviceSample sample = devices.exchange(kSomeN);
        devices.give(kSomeN);
        QVERIFY(devices.waitForReading(std::chrono::steady_clock::now()));
        QVERIFY(sample.present);
        QVERIFY(sample.tipInToothMm == first.tipMm);
        QVERIFY(sample.pedal.value_or(false));
        QVERIFY(first.seenMm == glm::dvec3(1.0, 2.0, 3.0));
        QVERIFY(first.forceN == kSomeN);
        QVERIFY(first.givenN == kSomeN);
        QCOMPARE(first.waits, 1);
        QCOMPARE(first.beginnings, 0);
        QCOMPARE(second.exchanges, 0);
    }

    void aFootPedalTakesThePlaceOfTheDevicesOwn()
    {
        StubDevice device;
        haptics::FootPedal pedal;
        haptics::DeviceSwitch devices(device, 1ms);
        devices.setPedal(&pedal);
        QVERIFY(devices.hasPedal());
        haptics::DeviceSample sample = devices.exchange(kSomeN);
        QCOMPARE(sample.pedal, std::optional(false));
        pedal.set(42);
        sample = devices.exchange(kSomeN);
        QCOMPARE(sample.pedal, std::optional(true));
        QCOMPARE(sample.speedPercent, std::uint8_t{42});
        QVERIFY(sample.tipInToothMm == device.tipMm);
        pedal.set(0);
        sample = devices.exchange(kSomeN);
        QCOMPARE(sample.pedal, std::optional(false));
        QCOMPARE(sample.speedPercent, std::uint8_t{42});
        devices.setPedal(nullptr);
        sample = devices.exchange(kSomeN);
        QCOMPARE(sample.pedal, std::optional(true));
        QCOMPARE(sample.speedPercent, std::uint8_t{100});
    }

    void afterAChangeThereIsNoReadingForAWhile_data()
    {
        QTest::addColumn<int>("periodUs");
        QTest::addColumn<int>("ticks");
        QTest::newRow("1 kHz") << 1000 << 20;
        QTest::newRow("4 kHz") << 250 << 80;
        QTest::newRow("3 kHz") << 333 << 61;
    }
    void afterAChangeThereIsNoReadingForAWhile()
    {
        QFETCH(int, periodUs);
        QFETCH(int, ticks);
        StubDevice first;
        StubDevice second;
        second.tipMm = {3.0F, 0.0F, 6.0F};
        haptics::DeviceSwitch devices(first, std::chrono::microseconds(periodUs));
        devices.give(kSomeN);
        devices.select(second);
        QCOMPARE(&devices.selected(), &second);
        int absent = 0;
        for (; absent < 1000; ++absent) {
            devices.seeBur({});
            if (devices.exchange(kSomeN).present)
                break;
            devices.give(kSomeN);
            QVERIFY(second.forceN == glm::dvec3(0.0));
            if (absent + 1 < ticks)
                QVERIFY(second.givenN == glm::dvec3(0.0));
        }
        QCOMPARE(absent, ticks);
        QVERIFY(first.givenN == glm::dvec3(0.0));
        QCOMPARE(first.exchanges, 0);
        QCOMPARE(second.beginnings, 1);
        QVERIFY(second.forceN == kSomeN);
    }

    void aDeviceThatIsSelectedAgainAtOnceGoesOnWithoutAPause()
    {
        StubDevice first;
        StubDevice second;
        haptics::DeviceSwitch devices(first, 1ms);
        devices.select(second);
        devices.select(first);
        QVERIFY(devices.exchange({}).present);
        QCOMPARE(first.beginnings, 0);
    }

    /// The lost device held the bur deep in the tooth. After the change the bur is above the tooth, without any force.
    void theHandOfThePointerHoversAfterADeviceIsLost()
    {
        rt::TripleBuffer<core::servo::PointerInput> input;
        core::servo::PointerInput want;
        want.targetMm = {1.0, 0.0};
        want.hoverMm = 2.5;
        want.feedMmPerS = 1.0;
        want.pushing = true;  // the mouse button is held down
        want.buttonIsPedal = true;
        input.publish(want);
        haptics::PointerDevice pointer(input, contact::ForceSettings{}.stiffnessNPerMm, 0.001);
        StubDevice arm;
        arm.tipMm = {0.0F, 0.0F, 1.0F};
        haptics::DeviceSwitch devices(arm, 1ms);
        contact::LiveTooth tooth(terrain::Tooth(support::makeBlock({})));
        const auto servo = core::servo::makeServoTick({}).value();
        servo->swapTooth(&tooth, true);
        const auto tick = [&] {
            devices.seeBur(servo->state().anchorMm);
            const haptics::DeviceSample sample = devices.exchange(servo->state().forceN);
            if (sample.pedal)
                servo->setDrill(*sample.pedal);
            servo->step(sample.present ? &sample.tipInToothMm : nullptr, 1ms);
            devices.give(servo->state().forceN);
            return sample;
        };
        for (int n = 0; n < 50; ++n)
            tick();
        arm.tipMm.z = -0.3F;
        for (int n = 0; n < 500; ++n)
            tick();
        QVERIFY(servo->state().touching);
        QVERIFY(glm::length(servo->state().forceN) > 0.1);

        devices.select(pointer);
        for (int n = 0; n < 500; ++n) {
            // The servo bridges a few ticks without a reading. No device receives that force.
            const bool isRead = tick().present;
            QVERIFY(!isRead || glm::length(servo->state().forceN) < 0.01);
            QVERIFY(!servo->state().cutting);
        }
        QVERIFY(!servo->state().drillOn);
        QVERIFY(std::abs(servo->state().anchorMm.z - 2.5) < 0.01);
        QVERIFY(std::abs(servo->state().anchorMm.x - 1.0) < 0.01);

        want.pushing = false;
        input.publish(want);
        tick();
        want.pushing = true;  // pressed a second time
        input.publish(want);
        for (int n = 0; n < 1500; ++n)
            tick();
        QVERIFY(servo->state().touching);
        QVERIFY(servo->state().drillOn);
    }

    void aChangeAllocatesNothing()
    {
        StubDevice first;
        StubDevice second;
        haptics::DeviceSwitch devices(first, 1ms);
        const long before = support::allocationsOnThisThread();
        for (int n = 0; n < 200; ++n) {
            devices.select(n % 50 < 25 ? static_cast<haptics::HapticDevice&>(first) : second);
            devices.seeBur({});
            static_cast<void>(devices.exchange({}));
            devices.give({});
        }
        QCOMPARE(support::allocationsOnThisThread() - before, 0L);
    }
};

CUSP_TEST(TestDeviceSwitch)
#include "tst_device_switch.moc"
