// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/devices/HeadTrackingStore.h"

#include "core/tracking/PictureSource.h"
#include "ui/kit/AppSettings.h"

namespace app {
namespace {

using ui::devices::HeadTrackingSettings;
using ui::kit::memory;

const QString kOnKey = QStringLiteral("head/on");
const QString kCameraKey = QStringLiteral("head/camera");
const QString kVideoKey = QStringLiteral("head/video");
const QString kWidthKey = QStringLiteral("head/width");
const QString kHeightKey = QStringLiteral("head/height");
const QString kHzKey = QStringLiteral("head/hz");
const QString kTagKey = QStringLiteral("head/tag");
const QString kTagMmKey = QStringLiteral("head/tag_mm");
const QString kFovKey = QStringLiteral("head/fov_deg");
const QString kCalibrationKey = QStringLiteral("head/calibration");
const QString kGainKey = QStringLiteral("head/gain");
const QString kMirroredKey = QStringLiteral("head/mirrored");
const QString kWindowKey = QStringLiteral("head/window");

/// Sets `value` to the stored number, if there is one between `low` and `high`.
template <class T>
void recallNumber(const QSettings& stored, const QString& key, T low, T high, T& value)
{
    bool isNumber = false;
    const double number = stored.value(key).toDouble(&isNumber);
    if (isNumber && number >= static_cast<double>(low) && number <= static_cast<double>(high))
        value = static_cast<T>(number);
}

/// Returns the key of a setting that is stored for each camera and each video, because each has another lens.
QString lensKeyOf(const QString& key, const HeadTrackingSettings& settings)
{
    QString source = settings.video;
    if (source.isEmpty()) {
        source = QString::number(settings.camera);
        for (const core::tracking::CameraInfo& camera : core::tracking::cameras())
            if (camera.number == settings.camera && !camera.name.empty())
                source = QString::fromStdString(camera.name);
    }
    // QSettings reads a slash as the separator of a group.
    return key + u'/' + source.replace(u'/', u'_').replace(u'\\', u'_');
}

}  // namespace

void recallLens(HeadTrackingSettings& settings)
{
    const QSettings stored = memory();
    settings.fovDeg = HeadTrackingSettings{}.fovDeg;
    recallNumber(stored, lensKeyOf(kFovKey, settings), HeadTrackingSettings::kLeastFovDeg,
                 HeadTrackingSettings::kMostFovDeg, settings.fovDeg);
    settings.calibration = stored.value(lensKeyOf(kCalibrationKey, settings)).toString();
}

HeadTrackingSettings storedHeadTracking()
{
    const QSettings stored = memory();
    HeadTrackingSettings settings;
    settings.isOn = ui::kit::recalled(stored, kOnKey, false);
    recallNumber(stored, kCameraKey, 0, 1000, settings.camera);
    settings.video = stored.value(kVideoKey).toString();
    recallNumber(stored, kWidthKey, 160, 7680, settings.width);
    recallNumber(stored, kHeightKey, 120, 4320, settings.height);
    recallNumber(stored, kHzKey, 1, 240, settings.hz);
    recallNumber(stored, kTagKey, 0, HeadTrackingSettings::kMostTagId, settings.tagId);
    recallNumber(stored, kTagMmKey, HeadTrackingSettings::kLeastTagMm, HeadTrackingSettings::kMostTagMm,
                 settings.tagMm);
    recallLens(settings);
    recallNumber(stored, kGainKey, HeadTrackingSettings::kLeastGain, HeadTrackingSettings::kMostGain, settings.gain);
    settings.mirrored = ui::kit::recalled(stored, kMirroredKey, true);
    settings.isWindow = ui::kit::recalled(stored, kWindowKey, false);
    return settings;
}

void storeHeadTracking(const HeadTrackingSettings& settings)
{
    QSettings stored = memory();
    stored.setValue(kOnKey, settings.isOn);
    stored.setValue(kCameraKey, settings.camera);
    stored.setValue(kVideoKey, settings.video);
    stored.setValue(kWidthKey, settings.width);
    stored.setValue(kHeightKey, settings.height);
    stored.setValue(kHzKey, settings.hz);
    stored.setValue(kTagKey, settings.tagId);
    stored.setValue(kTagMmKey, settings.tagMm);
    stored.setValue(lensKeyOf(kFovKey, settings), settings.fovDeg);
    stored.setValue(lensKeyOf(kCalibrationKey, settings), settings.calibration);
    stored.setValue(kGainKey, settings.gain);
    stored.setValue(kMirroredKey, settings.mirrored);
    stored.setValue(kWindowKey, settings.isWindow);
}

}  // namespace app
