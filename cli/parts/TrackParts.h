// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QString>

#include "core/tracking/PictureSource.h"
#include "core/tracking/TagTracker.h"

namespace cli {

// Functions of `cusp track` other than tracking. Each returns an ExitCode.

/// Writes the PDF with the tags, the headband and the board.
int printTagSheet(const QString& file, int id);

struct CalibrationWish
{
    QString file;     ///< to write
    qint64 most = 0;  ///< pictures to read
    bool isJson = false;
};

/// Calibrates a camera with pictures of the printed board.
int calibrateByBoard(core::tracking::PictureSource& source, const CalibrationWish& wish);

/// Calibrates the field of view with the tag at a known distance from the camera.
int calibrateByDistance(core::tracking::PictureSource& source, const core::tracking::TrackerSettings& settings,
                        double distanceMm, const CalibrationWish& wish);

}  // namespace cli
