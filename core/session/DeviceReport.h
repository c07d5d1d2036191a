// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include <glm/vec3.hpp>

#include "core/base/Result.h"

/// The report of a force device to the ui, and its setup. Plain values.
namespace core::session {

/// The state of a force device on its way to being ready.
enum class DeviceStage : std::uint8_t {
    Absent,           ///< no device is plugged in
    Unavailable,      ///< plugged in, but cannot be opened; DeviceReport::error says why
    NeedsFirmware,    ///< no firmware file is set, or it is not firmware; the error says why
    LoadingFirmware,  ///< DeviceReport::progress grows from 0 to 1
    Homing,           ///< waits until the user has moved the grip past the index marks
    Ready,            ///< delivers positions and accepts forces
    Silent,           ///< has stopped to answer; the force is zero. Becomes Ready when it answers again
};

/// Statistics of the packets exchanged with a device since it was opened.
struct ExchangeFigures
{
    /// Histogram of the intervals between answers, in steps of kBinUs; the last bin includes all longer ones.
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
        error{};  ///< why it is Unavailable or NeedsFirmware; otherwise the last error that it recovered from, or empty
    double progress = 0.0;                   ///< of LoadingFirmware
    std::array<bool, 3> homed{};             ///< the arms that have passed their index mark
    glm::vec3 tipMm{0.0F};                   ///< tooth frame; valid while Ready
    glm::vec3 forceN{0.0F};                  ///< tooth frame, as last sent
    std::uint8_t buttons = 0;                ///< held buttons; bits in the order of `presses`
    std::array<std::uint32_t, 4> presses{};  ///< number of presses of each button since it was opened: drill, undo,
                                             ///< mirror, centre
    ExchangeFigures exchange;
};

/// The placement of the device in front of the user.
struct DeviceSetup
{
    enum class Stand : std::uint8_t { Upright, OnItsBack };  ///< as sold; with the arms up
    enum class Side : std::uint8_t { Front, Right, Left };   ///< side of the user on which it is placed
    static constexpr double kLeastScale = 0.5;
    static constexpr double kMostScale = 2.5;

    Stand stand = Stand::Upright;
    Side side = Side::Front;
    double scale = 1.0;   ///< movement of the hand per movement of the bur
    double restMm = 0.0;  ///< height of the hand, above the middle of the work area, at which the bur is at the top of
                          ///< the tooth
    bool operator==(const DeviceSetup&) const = default;
};

}  // namespace core::session
