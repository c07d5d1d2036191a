// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include <QString>
#include <QStringList>

#include "haptics/ForceDevice.h"
#include "ui/devices/DeviceKind.h"

namespace app {

/// A kind of force device that a computer can have: one row of the table of devices.
struct DeviceRow
{
    ui::devices::DeviceKind kind;
    /// Creates the device. Empty: this program was built without support for it.
    std::function<std::unique_ptr<haptics::ForceDevice>()> make;
    /// Checks a firmware file. Empty: the device needs no firmware.
    std::function<ui::devices::FirmwareFile(const QString& path)> checkFirmware;
};

/// Returns all kinds of force devices that Cusp supports. To support another one, write a class and add a row here.
[[nodiscard]] std::vector<DeviceRow> stationDevices();

/// Returns the ids of the hands that this program can use: the pointer, the simulated hand, and the force devices.
[[nodiscard]] QStringList handIds();

}  // namespace app
