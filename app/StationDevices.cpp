// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/StationDevices.h"

#include <QFile>

#include "haptics/falcon/FirmwareImage.h"

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
    row.kind.rule =
        QStringLiteral(R"(SUBSYSTEM=="usb", ATTR{idVendor}=="0403", ATTR{idProduct}=="cb48", TAG+="uaccess")");
    row.kind.ruleFile = QStringLiteral("/etc/udev/rules.d/70-cusp-falcon.rules");
    row.kind.ruleCommand = QStringLiteral("cusp falcon rules");
    row.checkFirmware = checkFalconFirmware;
    row.kind.isInBuild = static_cast<bool>(row.make);
    return row;
}

}  // namespace

std::vector<DeviceRow> stationDevices()
{
    return {falconRow()};
}

}  // namespace app
