// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <QMetaType>

#include "core/session/ControllerReport.h"

namespace ui::devices {

/// The functions that a button of a pedal or gamepad can have.
enum class ControllerAction : std::uint8_t { Drill, Undo, Redo, Mirror, Centre, NextView, NextBur, Grade };
inline constexpr std::size_t kControllerActions = 8;
inline constexpr int kNoButton = -1;
inline constexpr int kNoAxis = -1;

/// The user's settings for one kind of controller.
struct ControllerSettings
{
    int axis = kNoAxis;  ///< axis of the pedal; kNoAxis until the user has taught it
    core::settings::PedalSettings shape;
    /// Button of each ControllerAction; kNoButton: none.
    std::array<int, kControllerActions> buttons{kNoButton, kNoButton, kNoButton, kNoButton,
                                                kNoButton, kNoButton, kNoButton, kNoButton};
    bool operator==(const ControllerSettings&) const = default;

    [[nodiscard]] int& buttonOf(ControllerAction action) { return buttons.at(static_cast<std::size_t>(action)); }
    [[nodiscard]] int buttonOf(ControllerAction action) const { return buttons.at(static_cast<std::size_t>(action)); }
    /// Returns whether an axis or a button can run the bur.
    [[nodiscard]] bool canRunBur() const { return axis != kNoAxis || buttonOf(ControllerAction::Drill) != kNoButton; }
};

/// Returns the settings of a controller that the user has not changed yet. A gamepad has default buttons, and its left
/// trigger is the pedal. The user must teach any other controller.
[[nodiscard]] inline ControllerSettings firstSettings(bool isGamepad)
{
    ControllerSettings settings;
    if (!isGamepad)
        return settings;
    settings.axis = core::session::kLeftTrigger;
    settings.shape.restReading = 0.0;
    settings.buttonOf(ControllerAction::Undo) = core::session::kButtonB;
    settings.buttonOf(ControllerAction::Redo) = core::session::kLeftShoulder;
    settings.buttonOf(ControllerAction::Mirror) = core::session::kButtonX;
    settings.buttonOf(ControllerAction::Centre) = core::session::kRightStickButton;
    settings.buttonOf(ControllerAction::NextView) = core::session::kButtonY;
    settings.buttonOf(ControllerAction::NextBur) = core::session::kRightShoulder;
    settings.buttonOf(ControllerAction::Grade) = core::session::kButtonStart;
    return settings;
}

}  // namespace ui::devices

Q_DECLARE_METATYPE(ui::devices::ControllerSettings)
