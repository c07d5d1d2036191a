// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/base/Result.h"

namespace ui::devices {

/// Ids of the two input methods that need no force device.
inline constexpr const char* kPointer = "pointer";
inline constexpr const char* kSimulated = "simulated";
/// Id of the row for head tracking, which does not move the bur.
inline constexpr const char* kHeadTracking = "head tracking";
/// Id of the row for foot pedals and gamepads, likewise.
inline constexpr const char* kPedals = "pedals";
/// Id of the row for sound, likewise.
inline constexpr const char* kSound = "sound";

/// The data of one kind of force device that the devices page shows.
struct DeviceKind
{
    QString id;                 ///< as in database::AttemptRecord::device
    QString name;               ///< product name, the same in every language
    bool isInBuild = true;      ///< false: this program was built without the library for it
    bool needsFirmware = true;  ///< its firmware must be loaded from a file that the user provides
    QString rule;               ///< udev rule that lets every user of the computer open it; empty: none is needed
    QString ruleFile;           ///< file for the rule
    QString ruleCommand;        ///< prints the rule
    QString badCalibration;     ///< path of its calibration file if that is invalid, otherwise empty
};

/// The firmware file that the user has chosen.
struct FirmwareFile
{
    QString path;         ///< empty: none is chosen
    QString name;         ///< name of the firmware, if it is known
    QString sha256;       ///< 64 hexadecimal digits; empty if the file is not firmware
    core::Error error{};  ///< the reason why the file is not firmware
    bool operator==(const FirmwareFile& other) const
    {
        return path == other.path && name == other.name && sha256 == other.sha256 && error.detail == other.error.detail;
    }
};

}  // namespace ui::devices
