// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/devices/CameraCalibration.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "core/base/WholeFile.h"

namespace app {
namespace {

using core::ErrorCode;
using core::tracking::CameraModel;

constexpr int kCameraFormat = 1;
constexpr qint64 kMostBytes = 64 * 1024;

/// Returns an error whose text is a sentence with the path of the file.
/// @param sentence  contains %1 in place of the path
tl::unexpected<core::Error> calibrationFault(ErrorCode code, const char* sentence, const QString& path)
{
    return core::unexpected(code, core::LocalizableText{sentence, {core::noted(path.toStdString())}});
}

}  // namespace

core::Result<CameraModel> readCameraCalibration(const QString& path)
{
    QFile file(path);
    if (!file.exists())
        return calibrationFault(ErrorCode::FileMissing, "There is no file %1.", path);
    if (!file.open(QIODevice::ReadOnly))
        return calibrationFault(ErrorCode::FileUnreadable, "The file %1 cannot be read.", path);
    const QByteArray bytes = file.read(kMostBytes + 1);
    if (bytes.size() > kMostBytes)
        return calibrationFault(ErrorCode::FileTooLarge, "The file %1 is too large for a calibration.", path);
    const QJsonObject root = QJsonDocument::fromJson(bytes).object();
    if (root[QStringLiteral("format")].toInt() != kCameraFormat || !root.contains(QStringLiteral("fx")))
        return calibrationFault(ErrorCode::BadStructure, "%1 is no calibration of a camera.", path);
    bool isSound = true;
    const auto number = [&](const char* key) {
        const QJsonValue value = root[QLatin1String(key)];
        isSound = isSound && value.isDouble();
        return value.toDouble();
    };
    CameraModel camera;
    camera.width = root[QStringLiteral("width")].toInt();  // 0 if it is no integer, which check() refuses
    camera.height = root[QStringLiteral("height")].toInt();
    camera.focalPx = {number("fx"), number("fy")};
    camera.centrePx = {number("cx"), number("cy")};
    if (const QJsonValue lens = root[QStringLiteral("distortion")]; !lens.isUndefined()) {
        const QJsonArray values = lens.toArray();
        isSound = isSound && static_cast<std::size_t>(values.size()) == camera.distortion.size();
        for (std::size_t n = 0; isSound && n < camera.distortion.size(); ++n) {
            isSound = values[static_cast<qsizetype>(n)].isDouble();
            camera.distortion.at(n) = values[static_cast<qsizetype>(n)].toDouble();
        }
    }
    if (!isSound)
        return calibrationFault(ErrorCode::BadStructure, "%1: a value is missing or is not a number.", path);
    if (const auto checked = camera.check(); !checked)
        return core::unexpected(
            checked.error().code,
            core::LocalizableText{"%1: %2", {core::noted(path.toStdString()), core::wordsOf(checked.error())}});
    return camera;
}

core::Status writeCameraCalibration(const QString& path, const CameraModel& camera)
{
    QJsonArray lens;
    for (const double k : camera.distortion)
        lens.append(k);
    const QJsonObject root{{QStringLiteral("format"), kCameraFormat}, {QStringLiteral("width"), camera.width},
                           {QStringLiteral("height"), camera.height}, {QStringLiteral("fx"), camera.focalPx.x},
                           {QStringLiteral("fy"), camera.focalPx.y},  {QStringLiteral("cx"), camera.centrePx.x},
                           {QStringLiteral("cy"), camera.centrePx.y}, {QStringLiteral("distortion"), lens}};
    const QByteArray text = QJsonDocument(root).toJson();
    QDir().mkpath(QFileInfo(path).absolutePath());
    return core::writeWhole(path.toStdString(), {text.constData(), static_cast<std::size_t>(text.size())},
                            "The calibration");
}

}  // namespace app
