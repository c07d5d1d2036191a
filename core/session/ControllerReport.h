// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/Result.h"
#include "core/settings/PedalSettings.h"

/// The report of foot pedals and gamepads to the ui. Plain values.
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
    int instance = -1;                   ///< a new number each time it is plugged in
    bool isGamepad = false;              ///< axes and buttons are those of GamepadAxis and GamepadButton
    std::vector<float> axes;             ///< -1 to 1
    std::uint32_t held = 0;              ///< the buttons that are down, one bit each
    std::vector<std::uint32_t> presses;  ///< number of presses of each button since it was plugged in
    bool operator==(const Controller&) const = default;

    [[nodiscard]] bool isHeld(std::size_t button) const { return (held >> button & 1U) != 0; }
};

/// The axis and the button of one kind of controller that control the speed of the bur. The higher of both speeds
/// applies.
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
    WaitsForRest,  ///< has been down since it was plugged in or chosen: counts as released
    Ready,
};

struct ControllerReport
{
    core::Error error{};  ///< why no controller can be read; empty: no error
    std::vector<Controller> controllers;
    PedalStage pedal = PedalStage::NotChosen;
    int percent = 0;              ///< speed of the bur that the pedal requests, per cent
    std::uint32_t unplugged = 0;  ///< number of times that the chosen pedal was unplugged
};

}  // namespace core::session
