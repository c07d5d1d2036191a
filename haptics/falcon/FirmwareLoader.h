// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "core/base/Result.h"
#include "haptics/falcon/FirmwareImage.h"
#include "haptics/falcon/FtdiPort.h"

/// Loads firmware into the Falcon's controller, which has none after power-up. The steps are those of libnifalcon
/// (FalconCommLibUSB.cpp): a greeting at 9,600 baud, then the SCI boot loader of TI's C28x processors, which measures
/// the baud rate by an 'A' and sends every byte back.
namespace haptics::falcon {

/// Sets the line for running firmware, and discards received data.
[[nodiscard]] core::Status setForRunning(FtdiPort& port);

/// Returns whether firmware is running. Sets the line for it and sends requests without force for up to 0.3 s.
[[nodiscard]] core::Result<bool> firmwareRuns(FtdiPort& port);

/// Loads the firmware and sets the line for it. Takes 1 to 3 s. May fail on a good device: retry on a newly opened
/// port.
/// @param goOn  called with the share that is loaded; returns false to cancel
/// Errors: ConnectionLost, each with its own sentence; Busy if goOn returned false.
[[nodiscard]] core::Status loadFirmware(FtdiPort& port, const FirmwareImage& image,
                                        const std::function<bool(double)>& goOn);

}  // namespace haptics::falcon
