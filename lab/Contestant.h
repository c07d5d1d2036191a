// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <memory>
#include <span>
#include <string_view>

#include "core/servo/ServoState.h"
#include "core/servo/ServoTick.h"
#include "haptics/HapticDevice.h"
#include "lab/Ceds2011.h"

namespace lab {

/// A servo in a trial: our servo loop with any contact method, or the 2011 pipeline. One thread.
class Contestant
{
public:
    Contestant() = default;
    Contestant(const Contestant&) = delete;
    Contestant& operator=(const Contestant&) = delete;
    virtual ~Contestant() = default;

    /// Runs one period: reads the device and sends it a force.
    virtual void tick() noexcept = 0;
    /// Replaces the tooth during the trial, as undo does; from the next tick on.
    virtual void swapTooth(std::unique_ptr<core::contact::LiveTooth> tooth) = 0;
    /// Starts centring, if it is supported; from the next tick on.
    virtual void bringHome() {}
    [[nodiscard]] virtual const core::servo::ServoState& state() const = 0;
    [[nodiscard]] virtual const core::contact::LiveTooth& tooth() const = 0;
};

/// Returns the method names for trials: those of core::contact::makeContactMethod(), and kCeds2011.
[[nodiscard]] std::span<const std::string_view> contestants();
inline constexpr std::string_view kCeds2011 = "ceds 2011";

/// Creates a contestant. Errors: those of makeServoTick().
/// @param settings  for kCeds2011 only stiffness, clamp and hardness are used
/// @param device    must outlive the contestant
[[nodiscard]] core::Result<std::unique_ptr<Contestant>>
makeContestant(const core::servo::ServoSettings& settings, const CedsFigures& ceds, haptics::HapticDevice& device,
               std::unique_ptr<core::contact::LiveTooth> tooth, bool drill, std::chrono::microseconds period);

/// Checks settings. OutOfRange or UnknownName if makeContestant() would refuse them.
[[nodiscard]] core::Status checkContestant(const core::servo::ServoSettings& settings);

}  // namespace lab
