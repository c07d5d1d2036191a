// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of the emulated Falcon by itself. The host here uses libusb directly and follows the facts of the device, so
// that the emulator is checked without the driver that it is made for.
#include <QTest>
#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <functional>
#include <numeric>
#include <span>
#include <thread>
#include <vector>

#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <libusb-1.0/libusb.h>

#include <glm/geometric.hpp>

#include "haptics/falcon/Packets.h"
#include "tests/support/Allocations.h"
#include "tests/support/Checks.h"
#include "tests/support/Tables.h"
#include "tests/support/falcon/BootStream.h"
#include "tests/support/falcon/EmulatedFalcon.h"

using namespace std::chrono_literals;
using haptics::falcon::Answer;
using haptics::falcon::FrameReader;
using haptics::falcon::Request;
using support::Accident;
using support::emulatedBus;
using support::EmulatedFalcon;
using support::Fault;
using support::Moment;
using support::falcon::bootStream;
using support::falcon::Pace;
using Clock = std::chrono::steady_clock;
using Bytes = std::vector<std::uint8_t>;

namespace {

constexpr std::uint16_t kBaud9600 = 0x4138;
constexpr std::uint16_t kBaudLoading = 0x0015;
constexpr std::uint16_t kBaudRunning = 0x0002;
const Bytes kQuery{0x0A, 0x43, 0x0D};
const Bytes kQueryAnswer{0x0A, 0x44, 0x2C, 0x0D};

/// A program that uses a Falcon through libusb calls. Of the driver it uses only the codec.
class Host
{
public:
    Host()
    {
        if (libusb_init(&m_context) != LIBUSB_SUCCESS)
            m_context = nullptr;
    }
    ~Host()
    {
        close();
        if (m_context != nullptr)
            libusb_exit(m_context);
    }
    Host(const Host&) = delete;
    Host& operator=(const Host&) = delete;

    [[nodiscard]] libusb_context* context() const { return m_context; }
    [[nodiscard]] libusb_device_handle* handle() const { return m_handle; }

    [[nodiscard]] int devices() const
    {
        libusb_device** list = nullptr;
        const auto count = libusb_get_device_list(m_context, &list);
        libusb_free_device_list(list, 1);
        return static_cast<int>(count);
    }

    int open(std::size_t number = 0)
    {
        libusb_device** list = nullptr;
        const auto count = libusb_get_device_list(m_context, &list);
        const int code = static_cast<std::size_t>(count) > number ? libusb_open(list[number], &m_handle)
                                                                  : static_cast<int>(LIBUSB_ERROR_NOT_FOUND);
        libusb_free_device_list(list, 1);
        return code;
    }
    int claim() { return libusb_claim_interface(m_handle, 0); }
    bool openAndClaim() { return open() == LIBUSB_SUCCESS && claim() == LIBUSB_SUCCESS; }

    void close()
    {
        if (m_handle != nullptr)
            libusb_close(m_handle);
        m_handle = nullptr;
    }

    int control(std::uint8_t request, std::uint16_t value)
    {
        return libusb_control_transfer(m_handle, 0x40, request, value, 0, nullptr, 0, 1000);
    }
    void setBaud(std::uint16_t divisor) { control(3, divisor); }

    int write(Bytes bytes)
    {
        return libusb_bulk_transfer(m_handle, 0x02, bytes.data(), static_cast<int>(bytes.size()), nullptr, 1000);
    }

    /// Reads until there are this many bytes, or the time is over.
    Bytes read(std::size_t count, std::chrono::milliseconds patience = 100ms)
    {
        Bytes received;
        const auto until = Clock::now() + patience;
        while (received.size() < count && Clock::now() < until && error == LIBUSB_SUCCESS) {
            std::array<std::uint8_t, 64> packet{};
            int size = 0;
            error = libusb_bulk_transfer(m_handle, 0x81, packet.data(), 64, &size, 1000);
            if (size > 2)
                lineErrors |= packet[1] & 0x1E;
            received.insert(received.end(), packet.begin() + std::min(size, 2), packet.begin() + size);
        }
        return received;
    }

    void prepareQuery()
    {
        control(0, 1);
        control(0, 2);
        control(9, 16);
        setBaud(kBaud9600);
        control(4, 8);
        control(2, 0);
        control(1, 0x0200);
        control(1, 0x0100);
        control(1, 0x0101);
    }
    Bytes query(std::size_t count = 4)
    {
        write(kQuery);
        return read(count);
    }
    void prepareAutobaud()
    {
        control(1, 0x0100);
        setBaud(kBaudLoading);
    }
    Bytes autobaud(std::size_t count = 1)
    {
        write({'A'});
        return read(count);
    }
    /// @returns the number of bytes that were echoed correctly, in whole blocks
    std::size_t sendImage(const Bytes& image)
    {
        std::size_t sent = 0;
        while (sent < image.size()) {
            const auto from = image.begin() + static_cast<std::ptrdiff_t>(sent);
            const Bytes block(from, from + static_cast<std::ptrdiff_t>(std::min<std::size_t>(62, image.size() - sent)));
            if (write(block) != LIBUSB_SUCCESS || read(block.size()) != block)
                break;
            sent += block.size();
        }
        return sent;
    }
    void prepareRunning()
    {
        control(9, 1);
        setBaud(kBaudRunning);
        control(0, 1);
        control(0, 2);
    }
    bool load(const Bytes& image)
    {
        prepareQuery();
        if (query() != kQueryAnswer)
            return false;
        prepareAutobaud();
        if (autobaud() != Bytes{'A'} || sendImage(image) != image.size())
            return false;
        prepareRunning();
        return true;
    }

    /// Makes one exchange. Returns null if no answer came in time.
    std::optional<Answer> exchange(const Request& request, std::chrono::milliseconds patience = 100ms)
    {
        const auto frame = haptics::falcon::encode(request);
        if (write({frame.begin(), frame.end()}) != LIBUSB_SUCCESS)
            return std::nullopt;
        const auto until = Clock::now() + patience;
        while (Clock::now() < until && error == LIBUSB_SUCCESS) {
            std::array<std::uint8_t, 64> packet{};
            int size = 0;
            error = libusb_bulk_transfer(m_handle, 0x81, packet.data(), 64, &size, 1000);
            const auto received = m_reader.read({packet.data(), static_cast<std::size_t>(size)});
            if (received.answers > 0)
                return received.newest;
        }
        m_reader.dropIncomplete();
        return std::nullopt;
    }

    int error = LIBUSB_SUCCESS;
    int lineErrors = 0;

private:
    libusb_context* m_context = nullptr;
    libusb_device_handle* m_handle = nullptr;
    FrameReader m_reader;
};

/// Runs a function in a process of its own. Returns whether that process was aborted.
bool aborts(const std::function<void()>& misuse)
{
    const pid_t child = fork();
    if (child == 0) {
        // The abort is expected: no crash report and no message.
        std::signal(SIGABRT, SIG_DFL);
        std::fclose(stderr);
        misuse();
        _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFSIGNALED(status) && WTERMSIG(status) == SIGABRT;
}

/// A transfer with its buffer and result.
struct Transfer
{
    explicit Transfer(libusb_device_handle* handle, unsigned char endpoint = 0x81, int length = 64,
                      unsigned timeout = 0)
    {
        libusb_fill_bulk_transfer(
            usb, handle, endpoint, buffer.data(), length,
            [](libusb_transfer* transfer) { ++static_cast<Transfer*>(transfer->user_data)->calls; }, this, timeout);
    }
    ~Transfer() { libusb_free_transfer(usb); }
    Transfer(const Transfer&) = delete;
    Transfer& operator=(const Transfer&) = delete;

    libusb_transfer* usb = libusb_alloc_transfer(0);
    std::array<std::uint8_t, 256> buffer{};
    int calls = 0;
};

void handleEvents(libusb_context* context, std::chrono::milliseconds wait)
{
    timeval time{0, static_cast<suseconds_t>(std::chrono::microseconds(wait).count())};
    libusb_handle_events_timeout_completed(context, &time, nullptr);
}

}  // namespace

class TestEmulatedFalcon : public QObject
{
    Q_OBJECT
private slots:
    void init() { emulatedBus().clear(); }
    void cleanup()
    {
        QCOMPARE(emulatedBus().objects().handles, 0);
        QCOMPARE(emulatedBus().objects().contexts, 0);
        QCOMPARE(emulatedBus().objects().deviceReferences, 0);
        QCOMPARE(emulatedBus().objects().transfers, 0);
    }

    void aMachineWithoutUsb()
    {
        emulatedBus().setUsbPresent(false);
        QCOMPARE(Host().context(), nullptr);
    }

    void devicesAreListedByTheirStrings()
    {
        Host host;
        QCOMPARE(host.devices(), 0);
        emulatedBus().plug("AAA");
        EmulatedFalcon& second = emulatedBus().plug("BBB");
        QCOMPARE(host.devices(), 2);
        QCOMPARE(host.open(1), static_cast<int>(LIBUSB_SUCCESS));
        libusb_device_descriptor descriptor{};
        libusb_get_device_descriptor(libusb_get_device(host.handle()), &descriptor);
        QCOMPARE(descriptor.idVendor, std::uint16_t{0x0403});
        QCOMPARE(descriptor.idProduct, std::uint16_t{0xCB48});
        unsigned char text[64]{};
        QCOMPARE(libusb_get_string_descriptor_ascii(host.handle(), descriptor.iSerialNumber, text, 64), 3);
        QCOMPARE(reinterpret_cast<const char*>(text), "BBB");
        QCOMPARE(libusb_get_string_descriptor_ascii(host.handle(), descriptor.iProduct, text, 7), 6);
        QCOMPARE(reinterpret_cast<const char*>(text), "FALCON");
        second.unplug();
        QCOMPARE(libusb_get_string_descriptor_ascii(host.handle(), descriptor.iProduct, text, 64),
                 static_cast<int>(LIBUSB_ERROR_NO_DEVICE));
        QCOMPARE(host.devices(), 1);
    }

    void firmwareIsLoadedAndRuns_data()
    {
        support::columns<int>("pace");
        QTest::newRow("real") << static_cast<int>(Pace::Real);
        QTest::newRow("fast") << static_cast<int>(Pace::Fast);
    }
    void firmwareIsLoadedAndRuns()
    {
        QFETCH(int, pace);
        EmulatedFalcon& falcon = emulatedBus().plug("F", static_cast<Pace>(pace));
        Host host;
        QVERIFY(host.openAndClaim());
        const Bytes image = bootStream();
        QVERIFY(host.load(image));
        QCOMPARE(falcon.image(), image);
        QVERIFY(falcon.state().firmwareRuns);
        QCOMPARE(falcon.state().loads, 1);
        QVERIFY(host.exchange({.motors = {100, -200, 4095}, .leds = {.red = true, .blue = true}}));
        const auto state = falcon.state();
        QCOMPARE(state.motors, (std::array<std::int16_t, 3>{100, -200, 4095}));
        QCOMPARE(state.leds, (haptics::falcon::Leds{.red = true, .blue = true}));
        QVERIFY(state.homing);
        QVERIFY(state.lastNonZero == state.lastRequest);
        QVERIFY(host.exchange({}));
        QVERIFY(falcon.state().motorsAreZero());
        QVERIFY(*falcon.state().lastNonZero < *falcon.state().lastRequest);
        // The firmware survives a restart of the program, and a pulse of DTR ends it.
        host.prepareQuery();
        QVERIFY(!falcon.state().firmwareRuns);
        QVERIFY(host.load(image));
        QCOMPARE(falcon.state().loads, 2);
    }

    /// 8492 bytes take 0.59 s at the loader's rate, and longer in blocks. An exchange takes one period of the latency
    /// timer.
    void realPaceTakesItsTime()
    {
        EmulatedFalcon& falcon = emulatedBus().plug("F");
        Host host;
        QVERIFY(host.openAndClaim());
        auto start = Clock::now();
        QVERIFY(host.load(bootStream(4000)));
        QVERIFY(Clock::now() - start > 560ms);
        start = Clock::now();
        for (int n = 0; n < 100; ++n)
            QVERIFY(host.exchange({}));
        QVERIFY(Clock::now() - start > 95ms);
        QCOMPARE(falcon.state().requests, std::uint64_t{100});
    }

    void toleranceIsNeeded()
    {
        EmulatedFalcon& falcon = emulatedBus().plug("F", Pace::Fast);
        falcon.setBoot({.leadingZero = true, .answersAtTry = 3, .strayByte = true});
        Host host;
        QVERIFY(host.openAndClaim());
        host.prepareQuery();
        QCOMPARE(host.query(), Bytes{});
        QCOMPARE(host.query(), Bytes{});
        QCOMPARE(host.query(5), (Bytes{0x00, 0x0A, 0x44, 0x2C, 0x0D}));
        host.prepareAutobaud();
        QCOMPARE(host.autobaud(2), (Bytes{0x13, 'A'}));
        const Bytes image = bootStream();
        QCOMPARE(host.sendImage(image), image.size());
        QVERIFY(falcon.state().firmwareRuns);
    }

    void whatIsOutOfOrderGetsNoAnswer()
    {
        EmulatedFalcon& falcon = emulatedBus().plug("F", Pace::Fast);
        Host host;
        QVERIFY(host.openAndClaim());
        host.setBaud(kBaud9600);
        QCOMPARE(host.query(), Bytes{});  // DTR is low
        host.prepareQuery();
        host.setBaud(kBaudLoading);
        QCOMPARE(host.query(), Bytes{});
        host.prepareQuery();
        host.prepareAutobaud();
        QCOMPARE(host.autobaud(), Bytes{});  // without a query before
        host.prepareQuery();
        QCOMPARE(host.query(), kQueryAnswer);
        host.control(1, 0x0100);
        QCOMPARE(host.autobaud(), Bytes{});  // at 9600 baud
        host.prepareQuery();
        QCOMPARE(host.query(), kQueryAnswer);
        host.prepareAutobaud();
        QCOMPARE(host.autobaud(), Bytes{'A'});
        QCOMPARE(host.sendImage(Bytes(100, 0x55)), std::size_t{0});  // not a boot stream
        host.prepareRunning();
        QVERIFY(!host.exchange({}, 5ms));
        QVERIFY(!falcon.state().firmwareRuns);
        QVERIFY(host.load(bootStream()));
        host.setBaud(kBaudLoading);
        QVERIFY(!host.exchange({}, 5ms));
        host.setBaud(kBaudRunning);
        QVERIFY(host.exchange({}));
    }

    void aWrongEchoHappensOnce()
    {
        EmulatedFalcon& falcon = emulatedBus().plug("F", Pace::Fast);
        falcon.setBoot({.wrongEchoAt = 700});
        Host host;
        QVERIFY(host.openAndClaim());
        QVERIFY(!host.load(bootStream()));
        QVERIFY(!falcon.state().firmwareRuns);
        QVERIFY(host.load(bootStream()));
    }

    /// The chip sends an answer without data each time the latency timer expires, even if that takes long.
    void statusOnlyPackets()
    {
        emulatedBus().plug("F");
        Host host;
        QVERIFY(host.openAndClaim());
        host.control(9, 10);
        std::array<std::uint8_t, 64> packet{};
        int size = 0;
        const auto start = Clock::now();
        for (int n = 0; n < 4; ++n) {
            QCOMPARE(libusb_bulk_transfer(host.handle(), 0x81, packet.data(), 64, &size, 1000), 0);
            QCOMPARE(size, 2);
            QCOMPARE(packet[0], std::uint8_t{0x01});
            QCOMPARE(packet[1], std::uint8_t{0x60});
        }
        QVERIFY(Clock::now() - start >= 29ms);
        std::array<std::uint8_t, 2> status{};
        QCOMPARE(libusb_control_transfer(host.handle(), 0xC0, 10, 0, 0, status.data(), 1, 1000), 1);
        QCOMPARE(status[0], std::uint8_t{10});
        QCOMPARE(libusb_control_transfer(host.handle(), 0xC0, 5, 0, 0, status.data(), 2, 1000), 2);
        QCOMPARE(host.control(77, 0), static_cast<int>(LIBUSB_ERROR_PIPE));
    }

    void countsAreHomedAtTheirMarks()
    {
        EmulatedFalcon& falcon = emulatedBus().plug("F", Pace::Fast);
        falcon.startFirmware();
        Host host;
        QVERIFY(host.openAndClaim());
        host.prepareRunning();
        QVERIFY(!host.exchange({.homing = true})->allHomed());
        falcon.setMains(false);
        falcon.pullOutAndPushIn();
        QVERIFY(!host.exchange({.homing = true})->allHomed());
        falcon.setMains(true);
        falcon.pullOutAndPushIn();
        QVERIFY(host.exchange({.homing = true})->allHomed());
        const glm::dvec3 place(12.0, -20.0, 140.0);
        falcon.moveTo(place);
        falcon.setButton(haptics::falcon::Button::Forward, true);
        const auto answer = *host.exchange({.homing = true});
        const auto counts = haptics::falcon::countsAt(haptics::falcon::armsAt(place)->angleRad);
        for (int leg = 0; leg < 3; ++leg)
            QVERIFY(support::near(answer.counts[static_cast<std::size_t>(leg)], counts[leg], 0.5));
        QCOMPARE(answer.buttons, std::uint8_t{2});
        const auto history = falcon.history();
        QCOMPARE(history.back().counts, answer.counts);
        QVERIFY(glm::length(history.back().gripMm - place) < 1e-9);
        // As libnifalcon notes, the legs count as homed only while the bit is set.
        QVERIFY(!host.exchange({.homing = false})->allHomed());
        falcon.losePower();
        QVERIFY(!host.exchange({.homing = true}, 5ms));
    }

    void motorsPressWithTheForceThatWasMeant()
    {
        EmulatedFalcon& falcon = emulatedBus().plug("F", Pace::Fast);
        falcon.startFirmware();
        const glm::dvec3 place(-10.0, 25.0, 118.0);
        falcon.moveTo(place);
        Host host;
        QVERIFY(host.openAndClaim());
        host.prepareRunning();
        const glm::dvec3 force(1.5, -2.0, 3.0);
        const auto torques = haptics::falcon::torquesNm(*haptics::falcon::armsAt(place), force);
        Request request;
        for (int leg = 0; leg < 3; ++leg)
            request.motors[static_cast<std::size_t>(leg)] =
                static_cast<std::int16_t>(std::lround(-10000.0 * torques[leg]));
        QVERIFY(host.exchange(request));
        QVERIFY(glm::length(falcon.state().forceN - force) < 0.02);
        falcon.setCommandsPerNm(5000.0);
        QVERIFY(host.exchange(request));
        QVERIFY(glm::length(falcon.state().forceN - 2.0 * force) < 0.04);
        falcon.setMains(false);
        QCOMPARE(falcon.state().forceN, glm::dvec3(0.0));
    }

    void aHandGivesWay()
    {
        EmulatedFalcon& falcon = emulatedBus().plug("F", Pace::Fast);
        falcon.startFirmware();
        falcon.setHand(haptics::HandFigures{"still", 0.1, 15.0, 250.0, 0.0, 0.0});
        Host host;
        QVERIFY(host.openAndClaim());
        host.prepareRunning();
        const auto torques =
            haptics::falcon::torquesNm(*haptics::falcon::armsAt(haptics::falcon::kCentreMm), glm::dvec3(0.0, 0.0, 2.0));
        Request request;
        for (int leg = 0; leg < 3; ++leg)
            request.motors[static_cast<std::size_t>(leg)] =
                static_cast<std::int16_t>(std::lround(-10000.0 * torques[leg]));
        QVERIFY(host.exchange(request));
        // 2 N against 250 N/m, less the dry friction: 7 to 8 mm.
        QTRY_VERIFY(falcon.state().gripMm.z > haptics::falcon::kCentreMm.z + 6.0);
        QVERIFY(falcon.state().gripMm.z < haptics::falcon::kCentreMm.z + 10.0);
        QVERIFY(host.exchange({}));
        QTRY_VERIFY(falcon.state().gripMm.z < haptics::falcon::kCentreMm.z + 2.0);
        falcon.moveTo({0.0, 0.0, 150.0}, 50ms);
        QTRY_VERIFY(falcon.state().gripMm.z > 148.0);
    }

    void everyFaultHappensWhenAsked_data()
    {
        support::columns<int, bool>("fault", "answered");
        QTest::newRow("lost request") << static_cast<int>(Fault::LostRequest) << false;
        QTest::newRow("lost answer") << static_cast<int>(Fault::LostAnswer) << false;
        QTest::newRow("short answer") << static_cast<int>(Fault::ShortAnswer) << false;
        QTest::newRow("late answer") << static_cast<int>(Fault::LateAnswer) << true;
        QTest::newRow("doubled answer") << static_cast<int>(Fault::DoubledAnswer) << true;
        QTest::newRow("stray bytes") << static_cast<int>(Fault::StrayBytes) << true;
        QTest::newRow("line error") << static_cast<int>(Fault::LineError) << false;
    }
    void everyFaultHappensWhenAsked()
    {
        QFETCH(int, fault);
        QFETCH(bool, answered);
        EmulatedFalcon& falcon = emulatedBus().plug("F", Pace::Fast);
        falcon.startFirmware();
        Host host;
        QVERIFY(host.openAndClaim());
        host.prepareRunning();
        QVERIFY(host.exchange({}));
        falcon.addFault(static_cast<Fault>(fault));
        QCOMPARE(host.exchange({}, 200ms).has_value(), answered);
        QCOMPARE(falcon.state().faults[static_cast<std::size_t>(fault)], std::uint64_t{1});
        QVERIFY(host.exchange({}));
    }

    /// With faults, most exchanges succeed and all requests that arrive are answered. Wrong positions are possible only
    /// where a byte was changed into another valid one.
    void faultsHaveTheirShares()
    {
        EmulatedFalcon& falcon = emulatedBus().plug("F", Pace::Fast);
        falcon.startFirmware();
        Host host;
        QVERIFY(host.openAndClaim());
        host.prepareRunning();
        constexpr int kExchanges = 20000;
        constexpr double kShare = 0.01;
        falcon.setFaults(kShare);
        int answers = 0;
        for (int n = 0; n < kExchanges; ++n)
            answers += host.exchange({}, 2ms) ? 1 : 0;
        falcon.setFaults(0.0);
        const auto state = falcon.state();
        const auto faults =
            static_cast<double>(std::accumulate(state.faults.begin(), state.faults.end(), std::uint64_t{0}));
        QVERIFY(support::between(faults, 0.7 * kShare * kExchanges, 1.3 * kShare * kExchanges));
        for (const std::uint64_t count : state.faults)
            QVERIFY(count > 0);
        QVERIFY(answers > kExchanges * 95 / 100);
        QVERIFY(answers < kExchanges);
        QVERIFY(host.exchange({}));
    }

    void theDeviceVanishesAtEachMoment_data()
    {
        support::columns<int, int>("moment", "count");
        QTest::newRow("open") << static_cast<int>(Moment::Open) << 1;
        QTest::newRow("claim") << static_cast<int>(Moment::Claim) << 1;
        QTest::newRow("query") << static_cast<int>(Moment::Query) << 1;
        QTest::newRow("autobaud") << static_cast<int>(Moment::Autobaud) << 1;
        QTest::newRow("image") << static_cast<int>(Moment::ImageByte) << 500;
        QTest::newRow("homing") << static_cast<int>(Moment::Homing) << 3;
        QTest::newRow("exchange") << static_cast<int>(Moment::Exchange) << 10;
    }
    void theDeviceVanishesAtEachMoment()
    {
        QFETCH(int, moment);
        QFETCH(int, count);
        EmulatedFalcon& falcon = emulatedBus().plug("F", Pace::Fast);
        falcon.plan(Accident::Unplug, static_cast<Moment>(moment), count);
        Host host;
        int exchanges = 0;
        if (host.openAndClaim() && host.load(bootStream()))
            while (exchanges < 100 && host.exchange({}))
                ++exchanges;
        QVERIFY(!falcon.state().plugged);
        QVERIFY(exchanges < 10);
        if (host.handle() != nullptr) {
            QCOMPARE(host.control(9, 1), static_cast<int>(LIBUSB_ERROR_NO_DEVICE));
            QCOMPARE(host.write({1}), static_cast<int>(LIBUSB_ERROR_NO_DEVICE));
        }
        host.close();
        host.error = LIBUSB_SUCCESS;
        falcon.losePower();
        falcon.plug();
        QVERIFY(host.openAndClaim());
        QVERIFY(host.load(bootStream()));
        QVERIFY(host.exchange({}));
    }

    void powerLossLeavesTheUsb()
    {
        EmulatedFalcon& falcon = emulatedBus().plug("F", Pace::Fast);
        falcon.startFirmware();
        falcon.plan(Accident::PowerLoss, Moment::Exchange, 3);
        Host host;
        QVERIFY(host.openAndClaim());
        host.prepareRunning();
        QVERIFY(host.exchange({}));
        QVERIFY(host.exchange({.motors = {1, 1, 1}}));
        QVERIFY(!host.exchange({.motors = {1, 1, 1}}, 5ms));
        QVERIFY(!falcon.state().firmwareRuns);
        QVERIFY(falcon.state().motorsAreZero());
        QVERIFY(host.load(bootStream()));
        falcon.losePower(true);
        QCOMPARE(host.control(9, 1), static_cast<int>(LIBUSB_ERROR_NO_DEVICE));
        QCOMPARE(host.devices(), 1);
    }

    void permissionsAndOtherPrograms()
    {
        EmulatedFalcon& falcon = emulatedBus().plug("F");
        Host host;
        falcon.setDenied(true);
        QCOMPARE(host.open(), static_cast<int>(LIBUSB_ERROR_ACCESS));
        falcon.setDenied(false);
        QCOMPARE(host.open(), static_cast<int>(LIBUSB_SUCCESS));
        falcon.setBusy(true);
        QCOMPARE(host.claim(), static_cast<int>(LIBUSB_ERROR_BUSY));
        falcon.setBusy(false);
        falcon.setKernelDriver(true);
        QCOMPARE(libusb_kernel_driver_active(host.handle(), 0), 1);
        QCOMPARE(host.claim(), static_cast<int>(LIBUSB_ERROR_BUSY));
        libusb_set_auto_detach_kernel_driver(host.handle(), 1);
        QCOMPARE(host.claim(), static_cast<int>(LIBUSB_SUCCESS));
        QCOMPARE(libusb_kernel_driver_active(host.handle(), 0), 0);
        QVERIFY(falcon.state().claimed);
        Host other;
        QCOMPARE(other.open(), static_cast<int>(LIBUSB_SUCCESS));
        QCOMPARE(other.claim(), static_cast<int>(LIBUSB_ERROR_BUSY));
        libusb_release_interface(host.handle(), 0);
        QCOMPARE(libusb_kernel_driver_active(host.handle(), 0), 1);
        QVERIFY(!falcon.state().claimed);
    }

    void transfersEndAsLibusbSays()
    {
        EmulatedFalcon& falcon = emulatedBus().plug("F");
        Host host;
        QVERIFY(host.openAndClaim());
        host.control(9, 255);
        std::array<std::uint8_t, 64> packet{};
        int size = 0;
        libusb_bulk_transfer(host.handle(), 0x81, packet.data(), 64, &size, 1000);  // restarts the latency timer
        {
            Transfer transfer(host.handle(), 0x81, 64, 100);
            QCOMPARE(libusb_submit_transfer(transfer.usb), 0);
            handleEvents(host.context(), 0ms);
            QCOMPARE(transfer.calls, 0);
            handleEvents(host.context(), 900ms);
            QCOMPARE(transfer.calls, 1);
            QCOMPARE(transfer.usb->status, LIBUSB_TRANSFER_TIMED_OUT);
            QCOMPARE(libusb_cancel_transfer(transfer.usb), static_cast<int>(LIBUSB_ERROR_NOT_FOUND));
        }
        {
            Transfer transfer(host.handle());
            QCOMPARE(libusb_submit_transfer(transfer.usb), 0);
            QCOMPARE(libusb_cancel_transfer(transfer.usb), 0);
            QCOMPARE(libusb_cancel_transfer(transfer.usb), static_cast<int>(LIBUSB_ERROR_NOT_FOUND));
            QCOMPARE(transfer.calls, 0);
            handleEvents(host.context(), 0ms);
            QCOMPARE(transfer.calls, 1);
            QCOMPARE(transfer.usb->status, LIBUSB_TRANSFER_CANCELLED);
        }
        {
            Transfer in(host.handle());
            Transfer out(host.handle(), 0x02, 100);
            host.setBaud(kBaud9600);
            QCOMPARE(libusb_submit_transfer(in.usb), 0);
            QCOMPARE(libusb_submit_transfer(out.usb), 0);
            handleEvents(host.context(), 100ms);
            QCOMPARE(out.calls, 1);  // the chip's buffer takes 128 bytes at once
            QCOMPARE(out.usb->actual_length, 100);
            falcon.unplug();
            QCOMPARE(in.calls, 0);
            handleEvents(host.context(), 0ms);
            QCOMPARE(in.calls, 1);
            QCOMPARE(in.usb->status, LIBUSB_TRANSFER_NO_DEVICE);
            QCOMPARE(libusb_submit_transfer(in.usb), static_cast<int>(LIBUSB_ERROR_NO_DEVICE));
        }
    }

    void hotplugIsToldWhileEventsAreHandled()
    {
        struct Seen
        {
            int arrived = 0;
            int left = 0;
        } seen;
        const auto callback = [](libusb_context*, libusb_device*, libusb_hotplug_event event, void* user) {
            auto& counts = *static_cast<Seen*>(user);
            ++(event == LIBUSB_HOTPLUG_EVENT_DEVICE_ARRIVED ? counts.arrived : counts.left);
            return 0;
        };
        EmulatedFalcon& falcon = emulatedBus().plug("F");
        Host host;
        libusb_hotplug_callback_handle number = 0;
        QCOMPARE(libusb_hotplug_register_callback(
                     host.context(), LIBUSB_HOTPLUG_EVENT_DEVICE_ARRIVED | LIBUSB_HOTPLUG_EVENT_DEVICE_LEFT,
                     LIBUSB_HOTPLUG_ENUMERATE, 0x0403, 0xCB48, LIBUSB_HOTPLUG_MATCH_ANY, callback, &seen, &number),
                 0);
        QCOMPARE(seen.arrived, 1);
        falcon.unplug();
        falcon.plug();
        QCOMPARE(seen.left, 0);
        handleEvents(host.context(), 100ms);
        QCOMPARE(seen.left, 1);
        QCOMPARE(seen.arrived, 2);
        libusb_hotplug_deregister_callback(host.context(), number);
        falcon.unplug();
        handleEvents(host.context(), 0ms);
        QCOMPARE(seen.left, 1);
    }

    void eventsEndTheWaitOfAnotherThread()
    {
        emulatedBus().plug("F");
        Host host;
        std::thread interrupter([&] { libusb_interrupt_event_handler(host.context()); });
        QCOMPARE(libusb_handle_events(host.context()), 0);
        interrupter.join();
    }

    void aTestControlsTheDeviceFromAnotherThread()
    {
        EmulatedFalcon& falcon = emulatedBus().plug("F", Pace::Fast);
        falcon.startFirmware();
        Host host;
        QVERIFY(host.openAndClaim());
        host.prepareRunning();
        std::atomic<int> exchanges = 0;
        std::thread program([&] {
            while (host.exchange({.motors = {1, 2, 3}}))
                ++exchanges;
        });
        for (int n = 0; n < 200; ++n) {
            falcon.moveTo({0.0, 0.0, 100.0 + 0.2 * n});
            static_cast<void>(falcon.history());
        }
        QTRY_VERIFY(exchanges > 1000);
        falcon.unplug();
        program.join();
        QCOMPARE(host.control(9, 1), static_cast<int>(LIBUSB_ERROR_NO_DEVICE));
    }

    void theExchangeAllocatesNothing()
    {
        EmulatedFalcon& falcon = emulatedBus().plug("F", Pace::Fast);
        falcon.startFirmware();
        falcon.setFaults(0.05);
        falcon.setHand(haptics::kHands[1]);
        Host host;
        QVERIFY(host.openAndClaim());
        host.prepareRunning();
        Transfer in(host.handle());
        Transfer out(host.handle(), 0x02, 16);
        const auto frame = haptics::falcon::encode({.motors = {300, 300, 300}});
        std::copy(frame.begin(), frame.end(), out.buffer.begin());
        const auto before = support::allocationsOnThisThread();
        for (int n = 0; n < 1000; ++n) {
            in.calls = out.calls = 0;
            libusb_submit_transfer(in.usb);
            libusb_submit_transfer(out.usb);
            while (in.calls == 0 || out.calls == 0)
                handleEvents(host.context(), 10ms);
        }
        QCOMPARE(support::allocationsOnThisThread() - before, 0L);
    }

    void misuseEndsTheProgram()
    {
        emulatedBus().plug("F");
        Host host;
        QVERIFY(host.open() == LIBUSB_SUCCESS);
        QVERIFY(!aborts([] {}));
        QVERIFY(aborts([&] { host.write({1}); }));  // not claimed
        QVERIFY(host.claim() == LIBUSB_SUCCESS);
        Transfer transfer(host.handle());
        QVERIFY(aborts([&] {
            libusb_submit_transfer(transfer.usb);
            libusb_submit_transfer(transfer.usb);
        }));
        QVERIFY(aborts([&] {
            libusb_submit_transfer(transfer.usb);
            libusb_free_transfer(transfer.usb);
        }));
        QVERIFY(aborts([&] {
            libusb_submit_transfer(transfer.usb);
            libusb_close(host.handle());
        }));
        QVERIFY(aborts([&] {
            libusb_close(host.handle());
            libusb_submit_transfer(transfer.usb);
        }));
        QVERIFY(aborts([&] {
            libusb_free_transfer(transfer.usb);
            libusb_free_transfer(transfer.usb);
        }));
        QVERIFY(aborts([&] {
            transfer.usb->length = 63;
            libusb_submit_transfer(transfer.usb);
        }));
        QVERIFY(aborts([&] { libusb_exit(host.context()); }));
        QVERIFY(aborts([&] { libusb_unref_device(reinterpret_cast<libusb_device*>(&host)); }));
    }
};

QTEST_GUILESS_MAIN(TestEmulatedFalcon)
#include "tst_emulated_falcon.moc"
