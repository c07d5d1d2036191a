// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/base/Result.h"

namespace ui::devices {

/// Ids of the two hands that need no device.
inline constexpr const char* kPointer = "pointer";
inline constexpr const char* kSimulated = "simulated";
/// Id of the row for head tracking, which is no hand.
inline constexpr const char* kHeadTracking = "head tracking";
/// The same for foot pedals and gamepads.
inline constexpr const char* kPedals = "pedals";
/// Id of the row for sound, which is no hand either.
inline constexpr const char* kSound = "sound";

/// A kind of force device, as the page of devices shows it.
struct DeviceKind
{
    QString id;                 ///< as in database::AttemptRecord::device
    QString name;               ///< of the product, the same in every language
    bool isInBuild = true;      ///< false: this program was built without the library for it
    bool needsFirmware = true;  ///< it gets its firmware from a file of the user
    QString rule;               ///< line that lets every user of the station open it; empty: none is needed
    QString ruleFile;           ///< file for the rule
    QString ruleCommand;        ///< prints the rule
    QString badCalibration;     ///< file with its calibration that cannot be used; empty: there is none
};

/// A firmware file that the user has chosen.
struct FirmwareFile
{
    QString path;         ///< empty: none is chosen
    QString name;         ///< of a firmware that is known
    QString sha256;       ///< 64 hexadecimal digits; empty if the file is not firmware
    core::Error error{};  ///< why it is not
    bool operator==(const FirmwareFile& other) const
    {
        return path == other.path && name == other.name && sha256 == other.sha256 && error.detail == other.error.detail;
    }
};

}  // namespace ui::devices
