// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/devices/StationDevices.h"

#include <QFile>

#include "app/devices/FalconCalibration.h"
#include "haptics/falcon/FalconDevice.h"
#include "haptics/falcon/FirmwareImage.h"
#include "haptics/falcon/Usb.h"

namespace app {
namespace {

ui::devices::FirmwareFile checkFalconFirmware(const QString& path)
{
    ui::devices::FirmwareFile found;
    found.path = path;
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        found.error = {core::ErrorCode::FileUnreadable, file.errorString().toStdString()};
        return found;
    }
    const QByteArray bytes = file.read(static_cast<qint64>(haptics::falcon::FirmwareImage::kLargestBytes) + 1);
    const auto image = haptics::falcon::FirmwareImage::check({bytes.begin(), bytes.end()});
    if (!image) {
        found.error = image.error();
        return found;
    }
    found.sha256 = QString::fromStdString(image->sha256());
    const std::string_view name = image->name();
    found.name = QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()));
    return found;
}

DeviceRow falconRow()
{
    DeviceRow row;
    row.kind.id = QStringLiteral("falcon");
    row.kind.name = QStringLiteral("Novint Falcon");
    row.kind.rule = QLatin1String(haptics::falcon::kUdevRule);
    row.kind.ruleFile = QLatin1String(haptics::falcon::kUdevFile);
    row.kind.ruleCommand = QStringLiteral("cusp falcon rules");
    row.checkFirmware = checkFalconFirmware;
    core::Status calibrated;
    static_cast<void>(stationsFalconCalibration(&calibrated));
    if (!calibrated)
        row.kind.badCalibration = falconCalibrationFile();
    if (haptics::falcon::hasUsb())
        row.make = [] {
            return std::make_unique<haptics::falcon::FalconDevice>(
                haptics::falcon::FalconDevice::Options{{}, stationsFalconCalibration()});
        };
    row.kind.isInBuild = static_cast<bool>(row.make);
    return row;
}

}  // namespace

std::vector<DeviceRow> stationDevices()
{
    return {falconRow()};
}

QStringList handIds()
{
    QStringList ids{QLatin1String(ui::devices::kPointer), QLatin1String(ui::devices::kSimulated)};
    for (const DeviceRow& row : stationDevices())
        if (row.make)
            ids.push_back(row.kind.id);
    return ids;
}

}  // namespace app
