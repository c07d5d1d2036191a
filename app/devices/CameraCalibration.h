// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/base/Result.h"
#include "core/tracking/CameraModel.h"

namespace app {

/// Reads the calibration of a camera: a JSON object with `format` (1), `width`, `height`, `fx`, `fy`, `cx`, `cy`
/// (pixels; the centre of the first pixel is at 0.5, 0.5) and `distortion` (k1, k2, p1, p2, k3; may be missing).
/// Errors: FileMissing, FileUnreadable, FileTooLarge, BadStructure, OutOfRange.
[[nodiscard]] core::Result<core::tracking::CameraModel> readCameraCalibration(const QString& path);

/// Writes the calibration of a camera to a file of that format. Errors: FileUnwritable.
[[nodiscard]] core::Status writeCameraCalibration(const QString& path, const core::tracking::CameraModel& camera);

}  // namespace app
