// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMetaType>
#include <QString>

namespace ui::devices {

/// The user's settings for head tracking.
struct HeadTrackingSettings
{
    static constexpr int kMostTagId = 586;  ///< highest id of the family 36h11
    static constexpr double kLeastTagMm = 10.0;
    static constexpr double kMostTagMm = 200.0;
    static constexpr double kLeastFovDeg = 20.0;
    static constexpr double kMostFovDeg = 150.0;
    static constexpr int kMeasuredMm = 500;  ///< distance from the lens to the tag for measuring the field of view
    static constexpr double kLeastGain = 1.0;
    static constexpr double kMostGain = 4.0;

    bool isOn = false;
    int camera = 0;    ///< as in core::tracking::CameraInfo
    QString video{};   ///< path of a video or of a folder of images that replaces the camera; empty: the camera is used
    int width = 1280;  ///< size of the camera's pictures
    int height = 720;
    int hz = 30;  ///< frame rate requested from the camera
    int tagId = 0;
    double tagMm = 50.0;    ///< edge of the black square
    double fovDeg = 60.0;   ///< horizontal field of view
    QString calibration{};  ///< path of a calibration of the camera's lens; empty: fovDeg is used
    double gain = 2.0;      ///< rotation of the view per rotation of the head
    bool isWindow = false;  ///< the screen acts as a window in front of the tooth, which does not turn
    bool mirrored = true;   ///< the picture on the page is mirrored
    bool operator==(const HeadTrackingSettings&) const = default;
};

}  // namespace ui::devices

Q_DECLARE_METATYPE(ui::devices::HeadTrackingSettings)
