// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/falcon/Hardware.h"

#include <algorithm>
#include <utility>

namespace support::falcon {
namespace {

constexpr std::uint8_t kFrameStart = '<';
constexpr std::array kErrorBits{FtdiChip::kOverrun, FtdiChip::kParity, FtdiChip::kFraming, FtdiChip::kBreak};

}  // namespace

Hardware::Hardware(std::uint64_t seed) : chip(seed), faults(seed), m_seed(seed), m_history(kRemembered) {}

void Hardware::advance(Time now)
{
    while (!m_accident && chip.nextSent() <= now)
        takeByte(chip.takeSent());
    arm.advance(now);
    firmware.moveLegs(arm.counts(), m_mains);
}

Time Hardware::nextEvent() const
{
    return std::min(chip.nextSent(), chip.nextPacket());
}

std::optional<std::size_t> Hardware::control(std::uint8_t type, std::uint8_t request, std::uint16_t value,
                                             std::uint16_t index, std::span<std::uint8_t> data, Time now)
{
    advance(now);
    const bool dtrBefore = chip.dtr();
    const auto answered = chip.control(type, request, value, index, data);
    // DTR rising while RTS is low resets the controller. (Inferred: libnifalcon does this before each load.)
    if (chip.dtr() && !dtrBefore && !chip.rts())
        losePower();
    loader.setDtr(chip.dtr());
    return answered;
}

void Hardware::setMains(bool on)
{
    m_mains = on;
    arm.setMotors(firmware.motors(), m_mains);
}

void Hardware::setButton(haptics::falcon::Button button, bool down)
{
    const auto bit = static_cast<std::uint8_t>(button);
    m_buttons = static_cast<std::uint8_t>(down ? m_buttons | bit : m_buttons & ~bit);
    firmware.setButtons(m_buttons);
}

void Hardware::startFirmware()
{
    firmware.start(faults.rng(), arm.counts());
    firmware.setButtons(m_buttons);
    arm.setMotors({}, m_mains);
    m_untilDropped = 0;
    m_running = true;
}

void Hardware::losePower()
{
    m_running = false;
    firmware = Firmware{};
    arm.setMotors({}, m_mains);
    loader.reset();
    chip.dropLine();
}

void Hardware::resetChip(Pace pace)
{
    chip = FtdiChip(++m_seed);
    chip.setPace(pace);
    loader.setDtr(false);
}

void Hardware::plan(Accident what, Moment when, int count)
{
    m_plan = Plan{what, when, count};
}

void Hardware::reach(Moment moment)
{
    if (!m_plan || m_plan->when != moment || --m_plan->count > 0)
        return;
    m_accident = m_plan->what;
    m_plan.reset();
}

std::optional<Accident> Hardware::takeAccident()
{
    return std::exchange(m_accident, std::nullopt);
}

void Hardware::takeByte(const LineByte& received)
{
    if (!m_running) {
        takeBootByte(received);
        return;
    }
    if (!isSameBaud(received.baud, Firmware::kBaud))
        return;
    if (received.byte == kFrameStart && faults.happens(Fault::LostRequest))
        m_untilDropped = 1 + faults.rng().below(Firmware::kFrameBytes);
    if (m_untilDropped > 0 && --m_untilDropped == 0)
        return;
    if (firmware.receive(received.byte))
        takeRequest(received.at);
}

void Hardware::takeBootByte(const LineByte& received)
{
    const Reply reply = loader.receive(received.byte, received.baud);
    for (std::size_t n = 0; n < reply.size; ++n)
        chip.receive(reply.bytes[n], reply.baud, received.at);
    if (loader.tookQuery())
        reach(Moment::Query);
    if (loader.tookAutobaud())
        reach(Moment::Autobaud);
    if (loader.tookImageByte())
        reach(Moment::ImageByte);
    if (loader.isFinished()) {
        ++m_loads;
        startFirmware();
    }
}

void Hardware::takeRequest(Time at)
{
    const auto& motors = firmware.motors();
    ++m_requests;
    m_lastRequest = at;
    if (std::any_of(motors.begin(), motors.end(), [](std::int16_t command) { return command != 0; }))
        m_lastNonZero = at;
    arm.setMotors(motors, m_mains);
    arm.advance(at);
    firmware.moveLegs(arm.counts(), m_mains);
    reach(Moment::Exchange);
    if (firmware.homing() && !firmware.allHomed())
        reach(Moment::Homing);
    if (m_accident || faults.happens(Fault::LostAnswer))
        return;
    if (m_history.full())
        m_history.pop();
    m_history.push({++m_answers, at, arm.gripMm(), firmware.counts()});
    if (faults.happens(Fault::LateAnswer))
        at += std::chrono::milliseconds(2 + faults.rng().below(39));
    if (faults.happens(Fault::StrayBytes))
        for (int n = faults.rng().below(5); n >= 0; --n)
            chip.receive(static_cast<std::uint8_t>(faults.rng().below(256)), Firmware::kBaud, at);
    const Firmware::Frame frame = firmware.answer();
    if (faults.happens(Fault::DoubledAnswer))
        send(frame, at);
    send(frame, at);
}

void Hardware::send(const Firmware::Frame& frame, Time from)
{
    core::Rng& rng = faults.rng();
    const auto any = [&] { return static_cast<std::size_t>(rng.below(Firmware::kFrameBytes)); };
    std::size_t missing = Firmware::kFrameBytes;
    std::size_t damaged = Firmware::kFrameBytes;
    Firmware::Frame bytes = frame;
    if (faults.happens(Fault::ShortAnswer))
        missing = any();
    if (faults.happens(Fault::FlippedBit)) {
        std::uint8_t& byte = bytes[any()];
        byte = static_cast<std::uint8_t>(byte ^ 1U << rng.below(8));
    }
    if (faults.happens(Fault::WrongByte))
        bytes[any()] = static_cast<std::uint8_t>(rng.below(256));
    std::uint8_t errors = 0;
    if (faults.happens(Fault::LineError)) {
        damaged = any();
        bytes[damaged] = static_cast<std::uint8_t>(rng.below(256));
        errors = kErrorBits[static_cast<std::size_t>(rng.below(static_cast<int>(kErrorBits.size())))];
    }
    for (std::size_t n = 0; n < bytes.size(); ++n)
        if (n != missing)
            chip.receive(bytes[n], Firmware::kBaud, from, n == damaged ? errors : std::uint8_t{0});
}

}  // namespace support::falcon
