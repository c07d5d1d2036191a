// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "haptics/falcon/Calibration.h"

/// The file with the calibration of the Falcon of this computer (JSON).
namespace app {

/// Beside the settings of the window: falcon.json.
[[nodiscard]] QString falconCalibrationFile();

/// Errors: FileMissing, FileUnreadable, FileTooLarge, BadStructure (no JSON of this kind), OutOfRange.
[[nodiscard]] core::Result<haptics::falcon::Calibration> readFalconCalibration(const QString& path);

/// The calibration of this computer, or the usual values if there is none. `why` is set to the error of a file that
/// cannot be used.
[[nodiscard]] haptics::falcon::Calibration stationsFalconCalibration(core::Status* why = nullptr);

[[nodiscard]] core::Status writeFalconCalibration(const QString& path, const haptics::falcon::Calibration& calibration);

}  // namespace app
