// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include <QString>
#include <QStringList>

#include "core/session/ControllerReport.h"
#include "ui/devices/ControllerSettings.h"
#include "ui/devices/DeviceWords.h"

/// Texts about pedals and gamepads in the user's language.
namespace ui::devices {

struct ControllerState
{
    bool isInBuild = true;  ///< false: this program was built without SDL 2
    core::session::ControllerReport report;
    QString pedalName;  ///< the chosen pedal, also while it is not plugged in; empty: none is chosen
};

[[nodiscard]] Sign signOf(const ControllerState& state);
/// Returns a sentence on the state, such as "The pedal is ready."
[[nodiscard]] QString stateWords(const ControllerState& state);
/// Returns one or two sentences on what to do in this state.
[[nodiscard]] QString helpWords(const ControllerState& state);

/// Returns the name of a function, such as "Undo".
[[nodiscard]] QString actionName(ControllerAction action);
/// Returns "Left trigger" or the like for a gamepad, otherwise "Axis 1".
[[nodiscard]] QString axisName(const core::session::Controller& controller, std::size_t axis);
/// Returns "A" or the like for a gamepad, otherwise "3".
[[nodiscard]] QString buttonName(const core::session::Controller& controller, std::size_t button);
/// Returns the fixed controls of a gamepad, one per line: control, tab, function.
[[nodiscard]] QStringList gamepadLayout();

}  // namespace ui::devices
