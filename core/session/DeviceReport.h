// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include <glm/vec3.hpp>

#include "core/base/Result.h"

/// What a force device reports to the ui, and how it is set up. Plain values.
namespace core::session {

/// How far a force device has come from the plug to the hand.
enum class DeviceStage : std::uint8_t {
    Absent,           ///< no device is plugged in
    Unavailable,      ///< plugged in, but cannot be opened; DeviceReport::error says why
    NeedsFirmware,    ///< no firmware file is set, or it is not firmware; the error says why
    LoadingFirmware,  ///< DeviceReport::progress grows from 0 to 1
    Homing,           ///< waits until the user has moved the grip past the index marks
    Ready,            ///< gives positions and takes forces
    Silent,           ///< was ready and has stopped to answer; the force is zero. Becomes Ready when it answers again
};

/// What the exchange of packets with a device has been like since it was opened.
struct ExchangeFigures
{
    /// Intervals between answers, in steps of kBinUs; the last bin has the longer ones too.
    static constexpr std::size_t kBins = 40;
    static constexpr double kBinUs = 50.0;

    std::uint64_t requests = 0;
    std::uint64_t answers = 0;
    std::uint64_t lost = 0;                        ///< requests without an answer in time
    std::uint64_t rejected = 0;                    ///< answers that were not plausible
    double rateHz = 0.0;                           ///< answers per second, over the last second
    double roundTripUs = 0.0;                      ///< median of the last second, from request to answer
    double slowTripUs = 0.0;                       ///< 99th percentile of the last second
    std::array<std::uint32_t, kBins> intervals{};  ///< of the last second
};

struct DeviceReport
{
    DeviceStage stage = DeviceStage::Absent;
    std::string serial;  ///< of the device; empty while absent
    int others = 0;      ///< devices of the same kind that were plugged in when this one was opened
    core::Error
        error{};  ///< why it is Unavailable or NeedsFirmware; else the last one that it recovered from, or empty
    double progress = 0.0;                   ///< of LoadingFirmware
    std::array<bool, 3> homed{};             ///< which arms have passed their index mark
    glm::vec3 tipMm{0.0F};                   ///< tooth frame; valid while Ready
    glm::vec3 forceN{0.0F};                  ///< tooth frame, as sent last
    std::uint8_t buttons = 0;                ///< held; bits in the order of `presses`
    std::array<std::uint32_t, 4> presses{};  ///< of each button since it was opened: drill, undo, mirror, centre
    ExchangeFigures exchange;
};

/// How the device stands before the user.
struct DeviceSetup
{
    enum class Stand : std::uint8_t { Upright, OnItsBack };  ///< as sold; with the arms up
    enum class Side : std::uint8_t { Front, Right, Left };   ///< where it stands, seen by the user
    static constexpr double kLeastScale = 0.5;
    static constexpr double kMostScale = 2.5;

    Stand stand = Stand::Upright;
    Side side = Side::Front;
    double scale = 1.0;   ///< how far the hand moves for one millimetre of the bur
    double restMm = 0.0;  ///< height of the hand for the top of the tooth, above the middle of the work area
    bool operator==(const DeviceSetup&) const = default;
};

}  // namespace core::session
