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

/// What answers a device in a trial: our servo loop with any contact method, or the pipeline of 2011. One thread.
class Contestant
{
public:
    Contestant() = default;
    Contestant(const Contestant&) = delete;
    Contestant& operator=(const Contestant&) = delete;
    virtual ~Contestant() = default;

    /// One period: reads the device and answers it.
    virtual void tick() noexcept = 0;
    /// Takes another tooth in the middle of things, as undo does; from the next tick on.
    virtual void swapTooth(std::unique_ptr<core::contact::LiveTooth> tooth) = 0;
    /// The hand is to be led home, as far as it knows how; from the next tick on.
    virtual void bringHome() {}
    [[nodiscard]] virtual const core::servo::ServoState& state() const = 0;
    [[nodiscard]] virtual const core::contact::LiveTooth& tooth() const = 0;
};

/// The method names that trials know: those of core::contact::makeContactMethod(), and kCeds2011.
[[nodiscard]] std::span<const std::string_view> contestants();
inline constexpr std::string_view kCeds2011 = "ceds 2011";

/// Errors: as of makeServoTick().
/// @param settings  of kCeds2011 only stiffness, clamp and hardness count
/// @param device    must outlive it
[[nodiscard]] core::Result<std::unique_ptr<Contestant>>
makeContestant(const core::servo::ServoSettings& settings, const CedsFigures& ceds, haptics::HapticDevice& device,
               std::unique_ptr<core::contact::LiveTooth> tooth, bool drill, std::chrono::microseconds period);

/// OutOfRange or UnknownName for settings that makeContestant() would refuse.
[[nodiscard]] core::Status checkContestant(const core::servo::ServoSettings& settings);

}  // namespace lab
