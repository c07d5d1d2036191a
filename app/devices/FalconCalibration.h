// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "haptics/falcon/Calibration.h"

/// Reads and writes the JSON file with the calibration of the Falcon of this computer.
namespace app {

/// Returns the path of that file: falcon.json in the folder of the settings file.
[[nodiscard]] QString falconCalibrationFile();

/// Reads a calibration. Errors: FileMissing, FileUnreadable, FileTooLarge, BadStructure (no calibration in JSON),
/// OutOfRange.
[[nodiscard]] core::Result<haptics::falcon::Calibration> readFalconCalibration(const QString& path);

/// Returns the calibration of this computer, or the default values if there is none. If the file exists but cannot be
/// used, sets `why` to the error.
[[nodiscard]] haptics::falcon::Calibration stationsFalconCalibration(core::Status* why = nullptr);

[[nodiscard]] core::Status writeFalconCalibration(const QString& path, const haptics::falcon::Calibration& calibration);

}  // namespace app
