// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "core/rt/Signal.h"
#include "core/rt/TripleBuffer.h"
#include "haptics/ForceDevice.h"
#include "haptics/falcon/AnswerCheck.h"
#include "haptics/falcon/Calibration.h"
#include "haptics/falcon/ExchangeWatch.h"
#include "haptics/falcon/FtdiPort.h"
#include "haptics/falcon/GivenForce.h"
#include "haptics/falcon/Placement.h"

namespace haptics::falcon {

/// Sets the force of every Falcon to zero and waits up to 0.1 s until that is sent. The force stays zero until a device
/// is started. It only accesses atomics and sleeps, so that the handler of a signal that ends the program can call it.
/// In a device's own thread it returns at once without effect.
void letGoOfAll() noexcept;

/// Drives a Novint Falcon in a thread of its own. The thread finds and opens the device, loads its firmware and waits
/// until the user has homed the grip. It then exchanges frames as fast as the device answers, about 1,000 a second.
/// Each answer wakes the servo, whose force is sent with the next request.
///
/// The force is zero unless the grip is homed and the servo has answered within the last 20 ms. It rises over half a
/// second when the device becomes ready.
class FalconDevice final : public ForceDevice
{
public:
    /// Options for tests and commands.
    struct Options
    {
        std::string serial;  ///< empty: the first that can be opened
        Calibration calibration{};
    };

    FalconDevice() : FalconDevice(Options{}) {}
    /// @param options  the calibration must have passed its check
    explicit FalconDevice(Options options);
    ~FalconDevice() override;

    void start() override;
    void stop() override;
    [[nodiscard]] core::session::DeviceReport report() const override;
    [[nodiscard]] bool isReady() const noexcept override { return m_isReady.load(std::memory_order_acquire); }
    void setUp(const core::session::DeviceSetup& setup) override;
    void setFirmware(const std::string& path) override;
    void setTestForce(const glm::dvec3& forceN) override;

    DeviceSample exchange(const glm::dvec3& forceOnHandN) noexcept override;
    void give(const glm::dvec3& forceOnHandN) noexcept override;
    bool waitForReading(std::chrono::steady_clock::time_point due) noexcept override;

private:
    using Clock = std::chrono::steady_clock;
    using Stage = core::session::DeviceStage;

    /// From the device thread to the servo.
    struct Reading
    {
        std::uint64_t serial = 0;  ///< 0: none yet
        glm::vec3 tipMm{0.0F};
        Clock::time_point taken;  ///< when the request was sent
        float delayS = 0.0F;      ///< of the last force: time since the reading that it answers
        bool drill = false;       ///< the button is held
    };
    /// From the ui to the device thread.
    struct TestForce
    {
        glm::dvec3 forceN{0.0};
        Clock::time_point until{};
    };
    /// From the device thread to the ui: values of each exchange.
    struct Live
    {
        glm::vec3 tipMm{0.0F};
        glm::vec3 forceN{0.0F};
        std::array<bool, 3> homed{};
        std::uint8_t buttons = 0;
        std::array<std::uint32_t, 4> presses{};
        core::session::ExchangeFigures exchange;
    };
    struct Wishes
    {
        core::session::DeviceSetup setup;
        std::string firmware;
    };

    void run();
    [[nodiscard]] std::unique_ptr<FtdiPort> bringUp(const Usb& usb);
    [[nodiscard]] std::unique_ptr<FtdiPort> load(const Usb& usb, std::unique_ptr<FtdiPort> port);
    void tell(Stage stage, core::Error error = {}, double progress = 0.0);
    void tellWhich(const FtdiPort& port);
    void rest(std::chrono::milliseconds time);
    void waitWith(FtdiPort& port, std::chrono::milliseconds time);

    void exchangeFrames(FtdiPort& port);
    [[nodiscard]] bool exchangeOnce(FtdiPort& port, FrameReader& reader);
    void take(const Answer& answer, Clock::time_point sent) noexcept;
    void takeButtons(std::uint8_t buttons) noexcept;
    void setReady(bool ready) noexcept;
    void takeWishes() noexcept;
    [[nodiscard]] Request nextRequest() noexcept;
    [[nodiscard]] glm::dvec3 wantedN(Clock::time_point now) noexcept;
    void drain(FtdiPort& port, FrameReader& reader);
    void letGo(FtdiPort& port);
    void publishLive() noexcept;

    const std::string m_serial;
    const Calibration m_calibration;

    // Shared between the threads.
    std::atomic<bool> m_isStopping{false};
    std::atomic<bool> m_isReady{false};
    std::atomic<bool> m_hasWishes{false};
    mutable std::mutex m_mutex;  ///< guards the next three
    std::condition_variable m_woken;
    core::session::DeviceReport m_told;  ///< stage, serial, error, progress
    Wishes m_wishes;
    core::rt::TripleBuffer<Reading> m_reading;
    GivenForce m_given;
    core::rt::TripleBuffer<TestForce> m_test;
    mutable core::rt::TripleBuffer<Live> m_live;
    core::rt::Signal m_hasReading;

    // Servo thread.
    std::uint64_t m_readSerial = 0;
    Clock::time_point m_readTaken{};

    // Device thread.
    std::string m_firmware;
    Placement m_placement;
    AnswerCheck m_check;
    ExchangeWatch m_watch;
    Live m_now;
    glm::dvec3 m_gripMm{kCentreMm};
    std::uint64_t m_nextSerial = 0;
    double m_ramp = 0.0;
    Clock::time_point m_rampedAt{};
    float m_delayS = 0.0F;
    int m_unhomed = 0;  ///< answers in a row with an arm that is not homed
    int m_refused = 0;  ///< answers in a row that were not accepted
    int m_silent = 0;   ///< requests in a row without an answer
    Clock::time_point m_answeredAt{};
    Clock::time_point m_silentSince{};
    std::uint8_t m_buttonsSeen = 0;
    int m_buttonsAgree = 0;
    int m_sincePublished = 0;

    std::thread m_thread;  ///< last: it uses all members above
};

}  // namespace haptics::falcon
