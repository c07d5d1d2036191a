// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/devices/FalconCalibration.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "core/base/WholeFile.h"
#include "ui/kit/AppSettings.h"

namespace app {
namespace {

using core::ErrorCode;
using core::unexpected;
using haptics::falcon::Calibration;
using haptics::falcon::Geometry;

constexpr int kFormat = 1;
constexpr qint64 kLargestBytes = 64 * 1024;
constexpr double kDegree = std::numbers::pi / 180.0;

struct Length
{
    const char* key;
    double Geometry::*value;
};
constexpr Length kLengths[] = {{"a", &Geometry::a}, {"b", &Geometry::b}, {"c", &Geometry::c}, {"de", &Geometry::de},
                               {"f", &Geometry::f}, {"r", &Geometry::r}, {"s", &Geometry::s}};

std::string named(const QString& path, const char* what)
{
    return path.toStdString() + ": " + what;
}

/// Sets `number` to the value of a key. Returns false if the value is no number. If the key is missing, leaves `number`
/// unchanged and returns true.
bool takeNumber(const QJsonValue& value, double& number)
{
    if (value.isUndefined())
        return true;
    number = value.toDouble();
    return value.isDouble();
}

}  // namespace

QString falconCalibrationFile()
{
    return QFileInfo(ui::kit::memory().fileName()).dir().filePath(QStringLiteral("falcon.json"));
}

core::Result<Calibration> readFalconCalibration(const QString& path)
{
    QFile file(path);
    if (!file.exists())
        return unexpected(ErrorCode::FileMissing, named(path, "there is no such file"));
    if (!file.open(QIODevice::ReadOnly))
        return unexpected(ErrorCode::FileUnreadable, named(path, "the file cannot be read"));
    const QByteArray bytes = file.read(kLargestBytes + 1);
    if (bytes.size() > kLargestBytes)
        return unexpected(ErrorCode::FileTooLarge, named(path, "the file is too large for a calibration"));
    const QJsonObject root = QJsonDocument::fromJson(bytes).object();
    if (root[QStringLiteral("format")].toInt() != kFormat)
        return unexpected(ErrorCode::BadStructure,
                          named(path, "this is no calibration of a Falcon; \"cusp falcon calibrate\" makes one"));
    Calibration calibration;
    double countDegrees = calibration.countRad / kDegree;
    bool isSound = takeNumber(root[QStringLiteral("count_deg")], countDegrees) &&
                   takeNumber(root[QStringLiteral("command_per_nm")], calibration.commandPerNm) &&
                   takeNumber(root[QStringLiteral("grip_weight_n")], calibration.gripWeightN);
    if (root.contains(QStringLiteral("count_deg")))
        calibration.countRad = countDegrees * kDegree;
    const QJsonObject lengths = root[QStringLiteral("lengths_mm")].toObject();
    for (const Length& length : kLengths)
        isSound = isSound && takeNumber(lengths[QLatin1String(length.key)], calibration.geometry.*length.value);
    if (const QJsonArray home = root[QStringLiteral("home_deg")].toArray(); !home.isEmpty())
        for (int leg = 0; leg < 3; ++leg) {
            isSound = isSound && home.size() == 3 && home[leg].isDouble();
            calibration.homeRad[leg] = home[leg].toDouble() * kDegree;
        }
    if (!isSound)
        return unexpected(ErrorCode::BadStructure, named(path, "a value is not a number"));
    if (const auto checked = check(calibration); !checked)
        return unexpected(checked.error().code, named(path, checked.error().detail.c_str()));
    return calibration;
}

Calibration stationsFalconCalibration(core::Status* why)
{
    const auto read = readFalconCalibration(falconCalibrationFile());
    if (why != nullptr && !read && read.error().code != ErrorCode::FileMissing)
        *why = tl::unexpected(read.error());
    return read.value_or(Calibration{});
}

core::Status writeFalconCalibration(const QString& path, const Calibration& calibration)
{
    QJsonObject lengths;
    for (const Length& length : kLengths)
        lengths[QLatin1String(length.key)] = calibration.geometry.*length.value;
    QJsonArray home;
    for (int leg = 0; leg < 3; ++leg)
        home.append(calibration.homeRad[leg] / kDegree);
    const QJsonObject root{{QStringLiteral("format"), kFormat},
                           {QStringLiteral("lengths_mm"), lengths},
                           {QStringLiteral("home_deg"), home},
                           {QStringLiteral("count_deg"), calibration.countRad / kDegree},
                           {QStringLiteral("command_per_nm"), calibration.commandPerNm},
                           {QStringLiteral("grip_weight_n"), calibration.gripWeightN}};
    const QByteArray text = QJsonDocument(root).toJson();
    QDir().mkpath(QFileInfo(path).absolutePath());
    return core::writeWhole(path.toStdString(), {text.constData(), static_cast<std::size_t>(text.size())},
                            "The calibration");
}

}  // namespace app
