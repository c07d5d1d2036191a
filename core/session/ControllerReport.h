// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/Result.h"
#include "core/settings/PedalSettings.h"

/// What foot pedals and gamepads report to the ui. Plain values.
namespace core::session {

/// Axes of a gamepad, in the order of Controller::axes. Sticks: -1 left or up, 1 right or down; triggers: 0 to 1.
enum GamepadAxis : std::uint8_t { kLeftStickX, kLeftStickY, kRightStickX, kRightStickY, kLeftTrigger, kRightTrigger };
inline constexpr std::size_t kGamepadAxes = 6;

/// Buttons of a gamepad by their place, named as on an Xbox pad, in the order of Controller::presses.
enum GamepadButton : std::uint8_t {
    kButtonA,
    kButtonB,
    kButtonX,
    kButtonY,
    kButtonBack,
    kButtonGuide,
    kButtonStart,
    kLeftStickButton,
    kRightStickButton,
    kLeftShoulder,
    kRightShoulder,
    kPadUp,
    kPadDown,
    kPadLeft,
    kPadRight,
};
inline constexpr std::size_t kGamepadButtons = 15;
inline constexpr std::size_t kMostControllerButtons = 32;
inline constexpr std::size_t kMostControllerAxes = 16;

/// A pedal, joystick or gamepad that is plugged in.
struct Controller
{
    std::string guid;  ///< 32 hexadecimal digits; the same for two devices of one kind
    std::string name;
    int instance = -1;                   ///< another number each time that it is plugged in
    bool isGamepad = false;              ///< axes and buttons are those of GamepadAxis and GamepadButton
    std::vector<float> axes;             ///< -1 to 1
    std::uint32_t held = 0;              ///< buttons that are down, a bit each
    std::vector<std::uint32_t> presses;  ///< of each button since it was plugged in
    bool operator==(const Controller&) const = default;

    [[nodiscard]] bool isHeld(std::size_t button) const { return (held >> button & 1U) != 0; }
};

/// Axis and button of one kind of controller that run the bur. The one that requests the higher speed counts.
struct PedalSource
{
    std::string guid;  ///< empty: no pedal is chosen
    int axis = -1;     ///< -1: none
    int button = -1;   ///< full speed while it is down; -1: none
    settings::PedalSettings shape;
    bool operator==(const PedalSource&) const = default;
};

enum class PedalStage : std::uint8_t {
    NotChosen,
    Missing,       ///< no such controller is plugged in
    WaitsForRest,  ///< pressed since it was plugged in or chosen: counts as released
    Ready,
};

struct ControllerReport
{
    core::Error error{};  ///< why no controller can be read; empty: they are read
    std::vector<Controller> controllers;
    PedalStage pedal = PedalStage::NotChosen;
    int percent = 0;              ///< speed that the pedal asks of the bur
    std::uint32_t unplugged = 0;  ///< times that the chosen pedal was unplugged
};

}  // namespace core::session
