// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QString>

#include "ui/devices/ControllerSettings.h"

namespace app {

/// Settings of pedals and gamepads on this computer, each kind by its GUID. A stored value out of its range does not
/// count.
[[nodiscard]] std::optional<ui::devices::ControllerSettings> storedController(const QString& guid);
void storeController(const QString& guid, const ui::devices::ControllerSettings& settings);

/// The controller that runs the bur.
struct ChosenPedal
{
    QString guid;  ///< empty: none
    QString name;
};
[[nodiscard]] ChosenPedal storedPedal();
void storePedal(const ChosenPedal& pedal);

}  // namespace app
