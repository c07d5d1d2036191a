// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>

#include "core/contact/PathGuide.h"
#include "core/rt/Loop.h"
#include "core/rt/TripleBuffer.h"
#include "haptics/HapticDevice.h"

namespace haptics {

/// The target of a guided hand. The next target follows within kBeat.
struct GuideAim
{
    static constexpr std::chrono::milliseconds kBeat{10};
    std::uint64_t number = 0;  ///< different for each target; 0: no target yet
    glm::dvec3 tipMm{0.0};     ///< tooth frame
};

/// The state of the guidance.
struct GuideState
{
    std::uint64_t ticks = 0;  ///< number of ticks so far; 0: the loop has not run yet
    bool present = false;     ///< the device returned a reading
    bool leading = false;
    bool wasPushed = false;  ///< the hand ended the last guidance by pushing
    glm::dvec3 tipMm{0.0};   ///< position of the hand, tooth frame
    glm::dvec3 forceN{0.0};  ///< on the hand
};

/// The channels between the player of a recording and the loop that guides the hand.
struct GuideLinks
{
    core::rt::TripleBuffer<GuideAim> aim;      ///< player -> servo, every GuideAim::kBeat
    core::rt::TripleBuffer<GuideState> state;  ///< servo -> player
    std::atomic<bool> wanted{false};           ///< ui -> servo: true starts the guidance, false ends it
};

/// A servo loop that guides the hand along a recording (core::contact::PathGuide), without contact or cutting. Replaces
/// the ServoLoop, which must be stopped, so the student's tooth is unchanged. tick() never allocates, locks, throws,
/// logs or waits.
class GuideLoop final : public core::rt::Loop
{
public:
    /// @param device, links  must outlive the loop
    GuideLoop(HapticDevice& device, GuideLinks& links) : m_device(device), m_links(links) {}

    void tick(std::chrono::microseconds dt) noexcept override;
    bool waitForBeat(std::chrono::steady_clock::time_point due) override { return m_device.waitForReading(due); }
    /// Leaves the device without a force.
    void end() override;

private:
    [[nodiscard]] glm::dvec3 aimNow(double seconds) noexcept;

    HapticDevice& m_device;
    GuideLinks& m_links;
    core::contact::PathGuide m_guide;
    GuideAim m_aim;
    glm::dvec3 m_from{0.0};  ///< position between the targets when the present target arrived
    double m_share = 1.0;    ///< share of the way from m_from to m_aim
    glm::dvec3 m_lastMm{0.0};
    double m_unreadS = 1.0;  ///< time since the last reading; initially long, so that no reading is assumed
    glm::dvec3 m_forceN{0.0};
    bool m_wasWanted = false;
    std::uint64_t m_ticks = 0;
};

}  // namespace haptics
