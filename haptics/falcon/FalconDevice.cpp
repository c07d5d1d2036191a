// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/falcon/FalconDevice.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <utility>
#include <vector>

#include <pthread.h>
#include <sched.h>
#include <time.h>

#include <glm/geometric.hpp>

#include "haptics/falcon/FirmwareLoader.h"

namespace haptics::falcon {
namespace {

using namespace std::chrono_literals;
using core::ErrorCode;
using core::LocalizableText;
using core::session::DeviceStage;

constexpr auto kLookAgain = 500ms;     ///< interval between two searches for a missing device
constexpr auto kTryAgain = 5s;         ///< time until the next try after a temporary error
constexpr int kMostLoads = 10;         ///< attempts to load firmware: real devices sometimes fail
constexpr auto kReopens = 200ms;       ///< time between two attempts to load firmware
constexpr auto kAnswerPatience = 5ms;  ///< a device that has not answered by then has lost the request
constexpr auto kQuiet = 2ms;           ///< after this time without bytes, the line is silent
constexpr auto kMostDrain = 20ms;
constexpr auto kForcePatience = 300us;  ///< time for the servo to answer a reading
constexpr auto kServoPatience = 20ms;   ///< a servo silent for longer has stopped
constexpr auto kReadingPatience = 2ms;  ///< time that the servo waits for a late reading
constexpr auto kFreshReading = 10ms;
constexpr auto kSilentAfter = 250ms;  ///< after this time the device is reported as silent
constexpr auto kGoneAfter = 1500ms;   ///< after this time it is opened again, because it may have lost its firmware
constexpr auto kTestLasts = 500ms;
constexpr double kMostTestN = 1.0;
constexpr double kRampS = 0.5;
constexpr int kSilentRequests = 2;  ///< after this many, requests carry no force
constexpr int kSurely = 3;          ///< number of answers in a row that must agree on a bit
constexpr int kMostRefused = 20;
constexpr int kPublishEvery = 16;
constexpr double kWireS = 0.0001;     ///< 16 bytes at 1.5 Mbaud
constexpr double kFarthestMm = 90.0;  ///< from the middle of the work area
constexpr int kPriority = 10;         ///< like the servo's

std::atomic<bool> g_letGo{false};
std::atomic<int> g_pressing{0};  ///< number of devices that may have a force
thread_local bool t_isDeviceThread = false;

/// The buttons in the order of DeviceReport::presses: drill, undo, mirror, centre.
constexpr std::array kButtons{Button::Centre, Button::Minus, Button::Plus, Button::Forward};
constexpr std::uint8_t kDrillBit = 1;

core::Error errorOf(ErrorCode code, LocalizableText words)
{
    return core::unexpected(code, std::move(words)).value();
}

core::Result<FirmwareImage> readFirmware(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    std::vector<std::uint8_t> bytes(FirmwareImage::kLargestBytes + 1);
    file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    if (!file.is_open() || file.bad())
        return core::unexpected(ErrorCode::FileUnreadable,
                                LocalizableText{"The firmware file cannot be read; choose it again."});
    bytes.resize(static_cast<std::size_t>(file.gcount()));
    return FirmwareImage::check(std::move(bytes));
}

/// Requests a real-time priority. Without the permission for it, the thread keeps its normal priority.
void askForPriority()
{
    sched_param parameter{};
    parameter.sched_priority = kPriority;
    static_cast<void>(pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameter));
}

}  // namespace

void letGoOfAll() noexcept
{
    if (t_isDeviceThread)
        return;
    g_letGo.store(true);
    constexpr timespec kMs{0, 1'000'000};
    for (int n = 0; n < 100 && g_pressing.load() > 0; ++n)
        nanosleep(&kMs, nullptr);
}

FalconDevice::FalconDevice(Options options) : m_serial(std::move(options.serial)), m_calibration(options.calibration) {}

FalconDevice::~FalconDevice()
{
    FalconDevice::stop();
}

void FalconDevice::start()
{
    if (m_thread.joinable())
        return;
    m_isStopping = false;
    g_letGo = false;
    m_thread = std::thread([this] { run(); });
}

void FalconDevice::stop()
{
    if (!m_thread.joinable())
        return;
    {
        const std::lock_guard lock(m_mutex);
        m_isStopping = true;
    }
    m_woken.notify_all();
    m_thread.join();
    tell(Stage::Absent);
}

core::session::DeviceReport FalconDevice::report() const
{
    core::session::DeviceReport report;
    {
        const std::lock_guard lock(m_mutex);
        report = m_told;
    }
    const Live& live = m_live.latest();
    report.homed = live.homed;
    report.tipMm = live.tipMm;
    report.forceN = live.forceN;
    report.buttons = live.buttons;
    report.presses = live.presses;
    report.exchange = live.exchange;
    return report;
}

void FalconDevice::setUp(const core::session::DeviceSetup& setup)
{
    const std::lock_guard lock(m_mutex);
    m_wishes.setup = setup;
    m_hasWishes = true;
}

void FalconDevice::setFirmware(const std::string& path)
{
    {
        const std::lock_guard lock(m_mutex);
        m_wishes.firmware = path;
        m_hasWishes = true;
    }
    m_woken.notify_all();
}

void FalconDevice::setTestForce(const glm::dvec3& forceN)
{
    const double newtons = glm::length(forceN);
    if (!std::isfinite(newtons))
        return;
    m_test.publish({newtons > kMostTestN ? forceN * (kMostTestN / newtons) : forceN, Clock::now() + kTestLasts});
}

DeviceSample FalconDevice::exchange(const glm::dvec3& /*forceOnHandN*/) noexcept
{
    const Reading& reading = m_reading.latest();
    m_readTaken = reading.taken;
    DeviceSample sample;
    sample.tipInToothMm = reading.tipMm;
    sample.present = isReady() && reading.serial != 0 && Clock::now() - reading.taken < kFreshReading;
    sample.delayS = reading.serial != m_readSerial ? reading.delayS : 0.0F;
    sample.pedal = sample.present && reading.drill;
    m_readSerial = reading.serial;
    return sample;
}

void FalconDevice::give(const glm::dvec3& forceOnHandN) noexcept
{
    m_given.give({forceOnHandN, Clock::now(), m_readTaken});
}

bool FalconDevice::waitForReading(Clock::time_point due) noexcept
{
    if (isReady())
        return m_hasReading.waitUntil(due + kReadingPatience);
    std::this_thread::sleep_until(due);
    return false;
}

// --- Device thread: from plugging in to homing ---

void FalconDevice::run()
{
    t_isDeviceThread = true;
    askForPriority();
    std::unique_ptr<Usb> usb;
    while (!m_isStopping) {
        takeWishes();
        if (!usb) {
            auto opened = Usb::open();
            if (!opened) {
                tell(Stage::Unavailable, opened.error());
                rest(kTryAgain);
                continue;
            }
            usb = std::move(*opened);
        }
        if (const auto port = bringUp(*usb))
            exchangeFrames(*port);
        else
            rest(kLookAgain);
    }
}

/// Opens the device and loads its firmware if needed. Returns null if the device cannot exchange frames yet.
std::unique_ptr<FtdiPort> FalconDevice::bringUp(const Usb& usb)
{
    auto port = FtdiPort::open(usb, m_serial);
    if (!port) {
        tell(port.error().code == ErrorCode::FileMissing ? Stage::Absent : Stage::Unavailable, port.error());
        return nullptr;
    }
    tellWhich(**port);
    const auto runs = firmwareRuns(**port);
    if (!runs) {
        tell(Stage::Unavailable, runs.error());
        return nullptr;
    }
    return *runs ? std::move(*port) : load(usb, std::move(*port));
}

std::unique_ptr<FtdiPort> FalconDevice::load(const Usb& usb, std::unique_ptr<FtdiPort> port)
{
    takeWishes();
    const auto image =
        m_firmware.empty()
            ? core::unexpected(ErrorCode::FileMissing,
                               LocalizableText{"The Falcon needs its firmware, which cannot be shipped with Cusp. "
                                               "Choose the firmware file of your Falcon's software."})
            : readFirmware(m_firmware);
    if (!image) {
        tell(Stage::NeedsFirmware, image.error());
        waitWith(*port, std::chrono::hours(1));
        return nullptr;
    }
    core::Error why;
    for (int n = 0; n < kMostLoads && !m_isStopping; ++n) {
        if (!port) {
            rest(kReopens);
            auto again = FtdiPort::open(usb, m_serial);
            if (!again) {
                tell(Stage::Unavailable, again.error());
                return nullptr;
            }
            port = std::move(*again);
        }
        const auto loaded = loadFirmware(*port, *image, [this](double share) {
            tell(Stage::LoadingFirmware, {}, share);
            return !m_isStopping;
        });
        if (loaded) {
            const auto runs = firmwareRuns(*port);
            if (runs && *runs)
                return port;
        }
        why = loaded
                  ? errorOf(ErrorCode::ConnectionLost,
                            LocalizableText{"The firmware was loaded, but does not answer. Try another firmware file."})
                  : loaded.error();
        port.reset();
    }
    tell(Stage::Unavailable, why);
    if (auto again = FtdiPort::open(usb, m_serial))
        waitWith(**again, kTryAgain);
    return nullptr;
}

void FalconDevice::tell(Stage stage, core::Error error, double progress)
{
    const std::lock_guard lock(m_mutex);
    m_told.stage = stage;
    m_told.error = std::move(error);
    m_told.progress = progress;
    if (stage == Stage::Absent) {
        m_told.serial.clear();
        m_told.others = 0;
    }
}

void FalconDevice::tellWhich(const FtdiPort& port)
{
    const std::lock_guard lock(m_mutex);
    m_told.serial = port.serial();
    m_told.others = port.others();
}

/// Waits, unless the device shall stop or its settings have changed.
void FalconDevice::rest(std::chrono::milliseconds time)
{
    std::unique_lock lock(m_mutex);
    m_woken.wait_for(lock, time, [this] { return m_isStopping || m_hasWishes; });
}

/// Waits with the device open, to detect when it is unplugged.
void FalconDevice::waitWith(FtdiPort& port, std::chrono::milliseconds time)
{
    const auto until = Clock::now() + time;
    while (!m_isStopping && !m_hasWishes && !port.isGone() && Clock::now() < until)
        static_cast<void>(port.receive(50ms));
}

void FalconDevice::takeWishes() noexcept
{
    if (!m_hasWishes.load(std::memory_order_relaxed))
        return;
    const std::lock_guard lock(m_mutex);
    m_hasWishes = false;
    m_placement = Placement(m_wishes.setup);
    m_firmware = m_wishes.firmware;
}

// --- Device thread: exchanging frames ---

void FalconDevice::exchangeFrames(FtdiPort& port)
{
    ++g_pressing;
    FrameReader reader;
    m_check.restart();
    m_watch = {};
    m_now = {};
    m_unhomed = m_refused = m_silent = 0;
    m_answeredAt = Clock::now();
    tell(Stage::Homing);
    while (!m_isStopping && !g_letGo.load(std::memory_order_relaxed) && exchangeOnce(port, reader)) {
        if (m_hasWishes.load(std::memory_order_relaxed))
            takeWishes();
    }
    setReady(false);
    letGo(port);
    --g_pressing;
    while (g_letGo && !m_isStopping) {
        takeWishes();
        rest(kLookAgain);
    }
}

/// Exchanges one request and answer. Returns false if the device is gone.
bool FalconDevice::exchangeOnce(FtdiPort& port, FrameReader& reader)
{
    const auto sent = Clock::now();
    m_watch.update(sent);
    if (port.isGone())
        return false;
    std::optional<Answer> answer;
    if (port.send(encode(nextRequest()))) {
        m_watch.addRequest();
        for (auto left = kAnswerPatience + 0us; !answer && left > 0us && !port.isGone();
             left = std::chrono::duration_cast<std::chrono::microseconds>(sent + kAnswerPatience - Clock::now())) {
            // Reads all waiting bytes, because only the newest of several answers is current.
            for (auto transfer = port.receive(left); !transfer.empty(); transfer = port.receive(0us))
                if (const auto received = reader.read(transfer); received.answers > 0)
                    answer = received.newest;
        }
    } else {
        static_cast<void>(port.receive(1ms));
    }
    const auto received = Clock::now();
    if (answer && received - sent <= kAnswerPatience) {
        m_silent = 0;
        m_answeredAt = received;
        m_watch.addAnswer(sent, received);
        take(*answer, sent);
    } else {
        // The answer was lost, or it is too old because this thread paused.
        ++m_silent;
        m_watch.addLost();
        drain(port, reader);
        const auto silence = Clock::now() - m_answeredAt;
        if (silence > kSilentAfter && isReady()) {
            setReady(false);
            tell(Stage::Silent);
        }
        publishLive();
        return silence < kGoneAfter && !port.isGone();
    }
    if (++m_sincePublished >= kPublishEvery)
        publishLive();
    return true;
}

void FalconDevice::take(const Answer& answer, Clock::time_point sent) noexcept
{
    m_unhomed = answer.allHomed() ? 0 : std::min(m_unhomed + 1, kSurely);
    if (m_unhomed == 0 || m_unhomed == kSurely)
        m_now.homed = answer.homed;
    if (m_unhomed == kSurely) {
        if (isReady()) {
            setReady(false);
            tell(Stage::Homing);
        }
        m_check.restart();
        return;
    }
    if (m_unhomed > 0)
        return;
    const auto counts = m_check.take(answer, sent.time_since_epoch());
    const auto grip = counts ? gripAt(anglesAt(*counts, m_calibration), m_gripMm, m_calibration.geometry)
                             : std::optional<glm::dvec3>();
    if (!grip || glm::distance(*grip, kCentreMm) > kFarthestMm) {
        m_watch.addRejected();
        if (!grip)
            m_gripMm = counts ? kCentreMm : m_gripMm;
        if (++m_refused >= kMostRefused) {
            m_refused = 0;
            m_check.restart();
        }
        return;
    }
    m_refused = 0;
    m_gripMm = *grip;
    takeButtons(answer.buttons);
    if (!isReady()) {
        m_ramp = 0.0;
        m_rampedAt = sent;
        setReady(true);
        tell(Stage::Ready);
    }
    m_now.tipMm = glm::vec3(m_placement.toothFromGripMm(m_gripMm));
    m_reading.publish({++m_nextSerial, m_now.tipMm, sent, m_delayS, (m_now.buttons & kDrillBit) != 0});
    m_hasReading.raise();
    // If the servo does not answer in time, the next request carries its force.
    static_cast<void>(m_given.waitFor(sent, Clock::now() + kForcePatience));
}

/// Accepts the button bits on which several answers in a row agree.
void FalconDevice::takeButtons(std::uint8_t buttons) noexcept
{
    m_buttonsAgree = buttons == m_buttonsSeen ? std::min(m_buttonsAgree + 1, kSurely) : 1;
    m_buttonsSeen = buttons;
    if (m_buttonsAgree < kSurely)
        return;
    std::uint8_t held = 0;
    for (std::size_t n = 0; n < kButtons.size(); ++n)
        if ((buttons & static_cast<std::uint8_t>(kButtons.at(n))) != 0)
            held = static_cast<std::uint8_t>(held | (1U << n));
    for (std::size_t n = 0; n < kButtons.size(); ++n)
        if ((held & ~m_now.buttons & (1U << n)) != 0)
            ++m_now.presses.at(n);
    m_now.buttons = held;
}

void FalconDevice::setReady(bool ready) noexcept
{
    m_isReady.store(ready, std::memory_order_release);
    if (!ready) {
        m_now.buttons = 0;
        m_buttonsAgree = 0;
        m_ramp = 0.0;
        m_check.restart();
        publishLive();
    }
}

Request FalconDevice::nextRequest() noexcept
{
    Request request;
    const auto now = Clock::now();
    const glm::dvec3 wanted = wantedN(now);
    const bool isInUse = now - m_given.latest().given < kServoPatience;
    const bool drills = isInUse && (m_now.buttons & kDrillBit) != 0;
    request.leds = {.red = !isReady(), .green = isReady() && drills, .blue = isReady() && !drills};
    m_now.forceN = glm::vec3(wanted);
    if (const auto arms = armsAt(m_gripMm, m_calibration.geometry); arms && isReady())
        request.motors = motorCommands(*arms, m_placement.deviceFromToothN(wanted), m_calibration);
    return request;
}

/// Returns the force to send to the hand, tooth frame.
glm::dvec3 FalconDevice::wantedN(Clock::time_point now) noexcept
{
    const GivenForce::Value& given = m_given.latest();
    if (!isReady() || m_silent >= kSilentRequests)
        return glm::dvec3(0.0);
    m_ramp = std::min(1.0, m_ramp + std::chrono::duration<double>(now - m_rampedAt).count() / kRampS);
    m_rampedAt = now;
    glm::dvec3 forceN(0.0, 0.0, m_calibration.gripWeightN);
    if (now - given.given < kServoPatience) {
        forceN += given.forceN;
        if (given.answers != Clock::time_point{})
            m_delayS = static_cast<float>(std::chrono::duration<double>(now - given.answers).count() + kWireS);
    }
    if (const TestForce& test = m_test.latest(); now < test.until)
        forceN += test.forceN;
    return forceN * m_ramp;
}

/// Waits until the line is silent, so that a late answer is not mistaken for the next one.
void FalconDevice::drain(FtdiPort& port, FrameReader& reader)
{
    const auto most = Clock::now() + kMostDrain;
    for (auto quiet = Clock::now() + kQuiet; Clock::now() < std::min(quiet, most) && !port.isGone();) {
        auto transfer = port.receive(500us);
        while (const auto packet = takePacket(transfer))
            if (!packet->data.empty())
                quiet = Clock::now() + kQuiet;
    }
    reader.dropIncomplete();
}

/// Sends a last request, without force and with the lights off.
void FalconDevice::letGo(FtdiPort& port)
{
    const Frame request = encode({});
    for (const auto until = Clock::now() + kMostDrain; Clock::now() < until && !port.isGone();) {
        if (!port.isSending() && port.send(request))
            break;
        static_cast<void>(port.receive(1ms));
    }
    for (const auto until = Clock::now() + kMostDrain; Clock::now() < until && port.isSending() && !port.isGone();)
        static_cast<void>(port.receive(1ms));
    m_now.forceN = glm::vec3(0.0F);
}

void FalconDevice::publishLive() noexcept
{
    m_sincePublished = 0;
    m_now.exchange = m_watch.figures();
    m_live.publish(m_now);
}

}  // namespace haptics::falcon
