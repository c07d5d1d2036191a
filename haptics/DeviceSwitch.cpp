// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/DeviceSwitch.h"

#include <algorithm>

namespace haptics {
namespace {

int ticksOf(std::chrono::microseconds time, std::chrono::microseconds period)
{
    const auto shortest = std::max(period, std::chrono::microseconds(1));
    return static_cast<int>((time + shortest - std::chrono::microseconds(1)) / shortest);
}

}  // namespace

DeviceSwitch::DeviceSwitch(HapticDevice& first, std::chrono::microseconds period) noexcept
    : m_selected(&first), m_current(&first), m_ticksOfPause(ticksOf(kPause, period))
{}

void DeviceSwitch::followSelection() noexcept
{
    HapticDevice* const next = m_selected.load(std::memory_order_acquire);
    if (next == m_current)
        return;
    m_current->give(glm::dvec3(0.0));
    m_current = next;
    m_current->takeOver();
    m_ticksLeft = m_ticksOfPause;
}

void DeviceSwitch::seeBur(const glm::dvec3& tipMm) noexcept
{
    followSelection();
    m_current->seeBur(tipMm);
}

DeviceSample DeviceSwitch::exchange(const glm::dvec3& forceOnHandN) noexcept
{
    followSelection();
    if (m_ticksLeft == 0)
        return withPedal(m_current->exchange(forceOnHandN));
    --m_ticksLeft;
    DeviceSample sample = m_current->exchange(glm::dvec3(0.0));
    sample.present = false;
    return withPedal(sample);
}

DeviceSample DeviceSwitch::withPedal(DeviceSample sample) noexcept
{
    const FootPedal* const pedal = m_pedal.load(std::memory_order_acquire);
    if (pedal == nullptr)
        return sample;
    const std::uint8_t percent = pedal->percent();
    sample.pedal = percent > 0;
    // A stopped bur retains its speed, so that the recording gets one event instead of two.
    if (percent > 0)
        m_speedPercent = percent;
    sample.speedPercent = m_speedPercent;
    return sample;
}

void DeviceSwitch::give(const glm::dvec3& forceN) noexcept
{
    m_current->give(m_ticksLeft == 0 ? forceN : glm::dvec3(0.0));
}

bool DeviceSwitch::waitForReading(std::chrono::steady_clock::time_point due) noexcept
{
    return m_current->waitForReading(due);
}

}  // namespace haptics
