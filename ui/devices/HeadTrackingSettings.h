// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMetaType>
#include <QString>

namespace ui::devices {

/// What the user sets for head tracking.
struct HeadTrackingSettings
{
    static constexpr int kMostTagId = 586;  ///< of the family 36h11
    static constexpr double kLeastTagMm = 10.0;
    static constexpr double kMostTagMm = 200.0;
    static constexpr double kLeastFovDeg = 20.0;
    static constexpr double kMostFovDeg = 150.0;
    static constexpr int kMeasuredMm = 500;  ///< from the lens to the tag, when the field of view is measured
    static constexpr double kLeastGain = 1.0;
    static constexpr double kMostGain = 4.0;

    bool isOn = false;
    int camera = 0;    ///< as in core::tracking::CameraInfo
    QString video{};   ///< path of a video, or of a folder of images, that stands in for the camera; empty: none does
    int width = 1280;  ///< of the camera's pictures
    int height = 720;
    int hz = 30;  ///< pictures a second that the camera is asked for
    int tagId = 0;
    double tagMm = 50.0;    ///< edge of the black square
    double fovDeg = 60.0;   ///< horizontal field of view
    QString calibration{};  ///< path of a calibration of the camera's lens; empty: fovDeg counts
    double gain = 2.0;      ///< degrees of the view for one of the head
    bool isWindow = false;  ///< the screen is a window before the tooth, which does not turn
    bool mirrored = true;   ///< the picture on the page looks like a mirror
    bool operator==(const HeadTrackingSettings&) const = default;
};

}  // namespace ui::devices

Q_DECLARE_METATYPE(ui::devices::HeadTrackingSettings)
