// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include <QString>
#include <QStringList>

#include "core/session/ControllerReport.h"
#include "ui/devices/ControllerSettings.h"
#include "ui/devices/DeviceWords.h"

/// Pedals and gamepads in the user's language.
namespace ui::devices {

struct ControllerState
{
    bool isInBuild = true;  ///< false: this program was built without SDL 2
    core::session::ControllerReport report;
    QString pedalName;  ///< of the chosen pedal, also while it is not plugged in; empty: none is chosen
};

[[nodiscard]] Sign signOf(const ControllerState& state);
/// "The pedal is ready."
[[nodiscard]] QString stateWords(const ControllerState& state);
/// What to do about the state, one or two sentences.
[[nodiscard]] QString helpWords(const ControllerState& state);

/// "Undo"
[[nodiscard]] QString actionName(ControllerAction action);
/// "Left trigger" of a gamepad, else "Axis 1".
[[nodiscard]] QString axisName(const core::session::Controller& controller, std::size_t axis);
/// "A" of a gamepad, else "3".
[[nodiscard]] QString buttonName(const core::session::Controller& controller, std::size_t button);
/// What the fixed controls of a gamepad do, a line each: control, tab, what it does.
[[nodiscard]] QStringList gamepadLayout();

}  // namespace ui::devices
