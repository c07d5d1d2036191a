// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/falcon/EmulatedFalcon.h"

#include <utility>

#include "tests/support/falcon/UsbObjects.h"

namespace support {

using falcon::Clock;
using falcon::Time;

EmulatedFalcon::EmulatedFalcon(EmulatedBus& bus, std::string serial, int port)
    : m_bus(bus), m_serial(std::move(serial)), m_port(port), m_hardware(static_cast<std::uint64_t>(port))
{}

template <typename Change>
void EmulatedFalcon::change(Change&& change)
{
    const std::lock_guard lock(m_bus.m_mutex);
    const Time now = Clock::now();
    m_bus.advance(now);
    change(now);
    m_bus.advance(now);
    m_bus.m_changed.notify_all();
}

void EmulatedFalcon::plug()
{
    change([this](Time) { m_bus.attach(*this); });
}

void EmulatedFalcon::unplug()
{
    change([this](Time) { m_bus.detach(*this); });
}

void EmulatedFalcon::setMains(bool on)
{
    change([&](Time) { m_hardware.setMains(on); });
}

void EmulatedFalcon::losePower(bool replugs)
{
    change([&](Time) {
        m_hardware.losePower();
        if (replugs && m_plugged) {
            m_bus.detach(*this);
            m_bus.attach(*this);
        }
    });
}

void EmulatedFalcon::plan(Accident what, Moment when, int count)
{
    change([&](Time) { m_hardware.plan(what, when, count); });
}

void EmulatedFalcon::setDenied(bool denied)
{
    change([&](Time) { m_denied = denied; });
}

void EmulatedFalcon::setBusy(bool busy)
{
    change([&](Time) { m_busy = busy; });
}

void EmulatedFalcon::setKernelDriver(bool attached)
{
    change([&](Time) { m_kernelDriver = attached; });
}

void EmulatedFalcon::setBoot(const falcon::BootOptions& options)
{
    change([&](Time) { m_hardware.loader.setOptions(options); });
}

void EmulatedFalcon::startFirmware()
{
    change([&](Time) { m_hardware.startFirmware(); });
}

void EmulatedFalcon::setButton(haptics::falcon::Button button, bool down)
{
    change([&](Time) { m_hardware.setButton(button, down); });
}

void EmulatedFalcon::setFault(Fault fault, double share)
{
    change([&](Time) { m_hardware.faults.setShare(fault, share); });
}

void EmulatedFalcon::setFaults(double share)
{
    change([&](Time) {
        for (const Fault fault : kAllFaults)
            m_hardware.faults.setShare(fault, share / kFaults);
    });
}

void EmulatedFalcon::addFault(Fault fault, int exchanges)
{
    change([&](Time) { m_hardware.faults.addNext(fault, exchanges); });
}

void EmulatedFalcon::moveTo(const glm::dvec3& deviceMm, std::chrono::milliseconds duration)
{
    change([&](Time now) { m_hardware.arm.moveTo(deviceMm, duration, now); });
}

void EmulatedFalcon::moveTip(const glm::dvec3& toothMm, std::chrono::milliseconds duration)
{
    moveTo(haptics::falcon::deviceFromTooth(toothMm), duration);
}

void EmulatedFalcon::setHand(const std::optional<haptics::HandFigures>& hand)
{
    change([&](Time now) { m_hardware.arm.setHand(hand, now); });
}

void EmulatedFalcon::setCommandsPerNm(double commands)
{
    change([&](Time) { m_hardware.arm.setCommandsPerNm(commands); });
}

void EmulatedFalcon::pullOutAndPushIn()
{
    const glm::dvec3 before = state().gripMm;
    moveTo({0.0, 0.0, 165.0});
    moveTo({0.0, 0.0, 95.0});
    moveTo(before);
}

FalconState EmulatedFalcon::state()
{
    FalconState state;
    change([&](Time) { state = stateNow(); });
    return state;
}

FalconState EmulatedFalcon::stateNow() const
{
    FalconState state;
    state.plugged = m_plugged;
    state.claimed = m_claimed;
    state.mains = m_hardware.mains();
    state.firmwareRuns = m_hardware.firmwareRuns();
    state.motors = m_hardware.firmware.motors();
    state.leds = m_hardware.firmware.leds();
    state.homing = m_hardware.firmware.homing();
    state.homed = m_hardware.firmware.homed();
    state.counts = m_hardware.firmware.counts();
    state.requests = m_hardware.requests();
    state.answers = m_hardware.answers();
    state.queries = m_hardware.loader.queries();
    state.loads = m_hardware.loads();
    state.imageBytes = m_hardware.loader.image().size();
    state.lastRequest = m_hardware.lastRequest();
    state.lastNonZero = m_hardware.lastNonZero();
    state.gripMm = m_hardware.arm.gripMm();
    state.forceN = m_hardware.arm.forceN();
    for (const Fault fault : kAllFaults)
        state.faults[static_cast<std::size_t>(fault)] = m_hardware.faults.count(fault);
    return state;
}

std::vector<std::uint8_t> EmulatedFalcon::image()
{
    std::vector<std::uint8_t> image;
    change([&](Time) { image = m_hardware.loader.image(); });
    return image;
}

std::vector<SentAnswer> EmulatedFalcon::history()
{
    std::vector<SentAnswer> answers;
    change([&](Time) {
        for (std::size_t n = 0; n < m_hardware.history().size(); ++n)
            answers.push_back(m_hardware.history()[n]);
    });
    return answers;
}

EmulatedFalcon& EmulatedBus::plug(std::string serial, falcon::Pace pace)
{
    EmulatedFalcon* device = nullptr;
    {
        const std::lock_guard lock(m_mutex);
        const int port = static_cast<int>(m_devices.size()) + 1;
        m_devices.push_back(std::make_unique<EmulatedFalcon>(*this, std::move(serial), port));
        device = m_devices.back().get();
        device->m_pace = pace;
    }
    device->plug();
    return *device;
}

EmulatedFalcon* EmulatedBus::find(std::string_view serial)
{
    const std::lock_guard lock(m_mutex);
    for (const auto& device : m_devices)
        if (device->serial() == serial)
            return device.get();
    return nullptr;
}

void EmulatedBus::clear()
{
    const std::lock_guard lock(m_mutex);
    for (const auto& device : m_devices)
        detach(*device);
    m_devices.clear();
    m_usbPresent = true;
}

void EmulatedBus::setUsbPresent(bool present)
{
    const std::lock_guard lock(m_mutex);
    m_usbPresent = present;
}

UsbObjects EmulatedBus::objects()
{
    const std::lock_guard lock(m_mutex);
    return usbObjects();
}

void EmulatedBus::setObserver(std::function<void(const EmulatedFalcon&, const FalconState&)> observer)
{
    const std::lock_guard lock(m_mutex);
    m_observer = std::move(observer);
}

void EmulatedBus::advance(Time now)
{
    for (const auto& device : m_devices) {
        device->m_hardware.advance(now);
        if (const auto accident = device->m_hardware.takeAccident()) {
            if (*accident != Accident::Unplug)
                device->m_hardware.losePower();
            if (*accident != Accident::PowerLoss)
                detach(*device);
            if (*accident == Accident::PowerLossWithReplug)
                attach(*device);
        }
        if (m_observer)
            m_observer(*device, device->stateNow());
    }
}

void EmulatedBus::attach(EmulatedFalcon& device)
{
    if (std::exchange(device.m_plugged, true))
        return;
    device.m_address = m_lastAddress = m_lastAddress % 127 + 1;
    device.m_hardware.resetChip(device.m_pace);
    usbArrived(device);
}

void EmulatedBus::detach(EmulatedFalcon& device)
{
    if (!std::exchange(device.m_plugged, false))
        return;
    device.m_claimed = false;
    device.m_hardware.chip.dropLine();
    usbLeft(device);
}

EmulatedBus& emulatedBus()
{
    // Never destroyed: the program may use libusb until its very end.
    static auto* const bus = new EmulatedBus;
    return *bus;
}

}  // namespace support
