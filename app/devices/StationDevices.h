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

/// A kind of force device that a station can have: one row of the table of devices.
struct DeviceRow
{
    ui::devices::DeviceKind kind;
    /// Empty: this program was built without it.
    std::function<std::unique_ptr<haptics::ForceDevice>()> make;
    /// Checks a firmware file. Empty: the device needs none.
    std::function<ui::devices::FirmwareFile(const QString& path)> checkFirmware;
};

/// All kinds that Cusp knows. Another device is a class and a row here.
[[nodiscard]] std::vector<DeviceRow> stationDevices();

/// Returns the ids of the hands that this program can use: the pointer, the simulated hand, and the force devices.
[[nodiscard]] QStringList handIds();

}  // namespace app
