// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QString>

#include "ui/devices/ControllerSettings.h"

namespace app {

/// Returns the stored settings of a kind of pedal or gamepad on this computer, or nullopt if there are none. A stored
/// value out of range is replaced by the default value.
/// @param guid  identifies the kind
[[nodiscard]] std::optional<ui::devices::ControllerSettings> storedController(const QString& guid);
void storeController(const QString& guid, const ui::devices::ControllerSettings& settings);

/// The pedal or gamepad that the user has chosen to run the bur.
struct ChosenPedal
{
    QString guid;  ///< empty: none
    QString name;
};
[[nodiscard]] ChosenPedal storedPedal();
void storePedal(const ChosenPedal& pedal);

}  // namespace app
