// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>

#include "core/contact/PathGuide.h"
#include "core/rt/Loop.h"
#include "core/rt/TripleBuffer.h"
#include "haptics/HapticDevice.h"

namespace haptics {

/// Where a hand is to be led: the place that follows the one before within kBeat.
struct GuideAim
{
    static constexpr std::chrono::milliseconds kBeat{10};
    std::uint64_t number = 0;  ///< another one with each; 0: none yet
    glm::dvec3 tipMm{0.0};     ///< tooth frame
};

/// What has become of it.
struct GuideState
{
    std::uint64_t ticks = 0;  ///< so far; 0: nobody knows yet
    bool present = false;     ///< the device was read
    bool leading = false;
    bool wasPushed = false;  ///< it is the hand that ended the last lead
    glm::dvec3 tipMm{0.0};   ///< where the hand is
    glm::dvec3 forceN{0.0};  ///< on the hand
};

/// The channels between who plays a recording and who leads the hand along it.
struct GuideLinks
{
    core::rt::TripleBuffer<GuideAim> aim;      ///< player -> servo, every GuideAim::kBeat
    core::rt::TripleBuffer<GuideState> state;  ///< servo -> player
    std::atomic<bool> wanted{false};           ///< ui -> servo: rising, the hand is taken up; falling, let go
};

/// A servo for a device whose hand is led along a recording (core::contact::PathGuide): neither contact nor cutting,
/// for the student's own tooth rests meanwhile. It stands in for the ServoLoop, which must rest.
/// tick() never allocates, locks, throws, logs or waits.
class GuideLoop final : public core::rt::Loop
{
public:
    /// @param device, links  must outlive the loop
    GuideLoop(HapticDevice& device, GuideLinks& links) : m_device(device), m_links(links) {}

    void tick(std::chrono::microseconds dt) noexcept override;
    /// The device is left without a force.
    bool waitForBeat(std::chrono::steady_clock::time_point due) override { return m_device.waitForReading(due); }
    void end() override;

private:
    [[nodiscard]] glm::dvec3 aimNow(double seconds) noexcept;

    HapticDevice& m_device;
    GuideLinks& m_links;
    core::contact::PathGuide m_guide;
    GuideAim m_aim;
    glm::dvec3 m_from{0.0};  ///< where the aim was when this one came
    double m_share = 1.0;    ///< of the way from there to it
    glm::dvec3 m_lastMm{0.0};
    double m_unreadS = 1.0;  ///< until there is a first reading, none can be trusted
    glm::dvec3 m_forceN{0.0};
    bool m_wasWanted = false;
    std::uint64_t m_ticks = 0;
};

}  // namespace haptics
