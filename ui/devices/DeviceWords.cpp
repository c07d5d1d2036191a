// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/devices/DeviceWords.h"

#include <array>
#include <cmath>

#include <QCoreApplication>

#include "ui/kit/LineIcon.h"
#include "ui/kit/Theme.h"
#include "ui/text/ValidationTexts.h"

namespace ui::devices {
namespace {

using core::session::DeviceReport;
using core::session::DeviceStage;

struct Words
{
    Q_DECLARE_TR_FUNCTIONS(ui::devices::Words)
};

constexpr double kPercent = 100.0;

}  // namespace

bool lacksPermission(const DeviceReport& report)
{
    return report.stage == DeviceStage::Unavailable && report.error.code == core::ErrorCode::NotAllowed;
}

Sign signOf(const DeviceKind& kind, const DeviceReport& report)
{
    if (!kind.isInBuild)
        return Sign::Missing;
    switch (report.stage) {
    case DeviceStage::Absent:
        return Sign::Missing;
    case DeviceStage::LoadingFirmware:
        return Sign::Working;
    case DeviceStage::Ready:
        return Sign::Ready;
    case DeviceStage::Unavailable:
    case DeviceStage::NeedsFirmware:
    case DeviceStage::Homing:
    case DeviceStage::Silent:
        break;
    }
    return Sign::Attention;
}

QPixmap signPixmap(Sign sign, const QPalette& palette, int sizePx, double devicePixelRatio)
{
    const kit::Tones tones = kit::tones(palette);
    switch (sign) {
    case Sign::Ready:
        return kit::linePixmap(QStringLiteral("check"), tones.accent, sizePx, devicePixelRatio);
    case Sign::Working:
        return kit::linePixmap(QStringLiteral("hourglass"), tones.accent, sizePx, devicePixelRatio);
    case Sign::Attention:
        return kit::linePixmap(QStringLiteral("warning"), tones.attention, sizePx, devicePixelRatio);
    case Sign::Off:
        return kit::linePixmap(QStringLiteral("eye"), palette.color(QPalette::PlaceholderText), sizePx,
                               devicePixelRatio);
    case Sign::Missing:
        break;
    }
    return kit::linePixmap(QStringLiteral("cross"), palette.color(QPalette::PlaceholderText), sizePx, devicePixelRatio);
}

QString stateWords(const DeviceKind& kind, const DeviceReport& report)
{
    if (!kind.isInBuild)
        return Words::tr("Not available: this program was built without force devices.");
    switch (report.stage) {
    case DeviceStage::Absent:
        return Words::tr("Not plugged in.");
    case DeviceStage::Unavailable:
        return lacksPermission(report) ? Words::tr("Plugged in, but you are not allowed to open it.")
                                       : Words::tr("Plugged in, but it cannot be opened.");
    case DeviceStage::NeedsFirmware:
        return Words::tr("Plugged in. It needs its firmware file.");
    case DeviceStage::LoadingFirmware:
        //: %1: a number from 0 to 100
        return Words::tr("Loading the firmware: %1 %.").arg(std::lround(kPercent * report.progress));
    case DeviceStage::Homing:
        return Words::tr("Plugged in. Move the grip to home it.");
    case DeviceStage::Ready:
        return Words::tr("Ready.");
    case DeviceStage::Silent:
        return Words::tr("It does not respond. The force is off.");
    }
    return {};
}

QString helpWords(const DeviceKind& kind, const DeviceReport& report)
{
    if (!kind.isInBuild)
        return Words::tr("Install the library libusb and build Cusp again, or use a package that has it.");
    switch (report.stage) {
    case DeviceStage::Absent:
        return Words::tr("Plug in the USB cable and the mains adapter. The device is found by itself.");
    case DeviceStage::Unavailable:
        return lacksPermission(report) || report.error.detail.empty() ? QString()
                                                                      : text::faultWords(core::wordsOf(report.error));
    case DeviceStage::NeedsFirmware:
        return Words::tr("The firmware came with the software of the device and may not be shipped with Cusp.");
    case DeviceStage::Silent:
        return Words::tr("Check both plugs. The device continues by itself when it responds again.");
    case DeviceStage::Homing:
    case DeviceStage::Ready:
        if (!kind.badCalibration.isEmpty())
            //: %1: a path
            return Words::tr(
                       "The calibration in %1 cannot be used, so the usual values are. Calibrate the device again.")
                .arg(kind.badCalibration);
        if (!report.error.detail.empty())
            //: %1: what went wrong, a sentence
            return Words::tr("The last problem, which is over: %1").arg(text::faultWords(core::wordsOf(report.error)));
        break;
    case DeviceStage::LoadingFirmware:
        break;
    }
    return {};
}

QString gripButtonName(std::size_t button)
{
    //: A button on the grip of a force device; pressed, the bur turns
    const std::array<QString, 4> names{Words::tr("Drill"),
                                       //: A button on the grip of a force device
                                       Words::tr("Undo"),
                                       //: A button on the grip of a force device: the dental mirror
                                       Words::tr("Mirror"),
                                       //: A button on the grip of a force device: back over the tooth
                                       Words::tr("Centre")};
    return names.at(button);
}

}  // namespace ui::devices
