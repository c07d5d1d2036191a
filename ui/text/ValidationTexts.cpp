// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/ValidationTexts.h"

#include <utility>

#include <QCoreApplication>
#include <QFileInfo>
#include <QRegularExpression>

#include "ui/text/Texts.h"

namespace ui::text {
namespace {

// Texts of core about a lesson's texts and numbers, for translators. Core itself does not use Qt.
[[maybe_unused]] constexpr const char* kSaidByCore[] = {
    //: %1: what has no words of its own but English ones
    QT_TRANSLATE_NOOP("Fault", "%1"),
    //: %1: a number of an ideal or a block, %2: its key, %3: the number that was given
    QT_TRANSLATE_NOOP("Fault", "the %1 (%2) is not a number"),
    QT_TRANSLATE_NOOP("Fault", "the %1 (%2) must be from %4 to %5, not %3"),
    QT_TRANSLATE_NOOP("Fault", "the %1 (%2) must be from %4 to %5 %6, not %3"),
    QT_TRANSLATE_NOOP("Fault", "the %1 (%2) must be a whole number, not %3"),
    QT_TRANSLATE_NOOP("Fault", "there is no size \"%1\"; there are %2"),
    QT_TRANSLATE_NOOP("Fault",
                      "the thickness of the enamel layer (enamel_mm) is more than the block's height (height_mm)"),
    QT_TRANSLATE_NOOP("Fault", "the block's side or height (side_mm, height_mm) is too small for three pads: they take "
                               "%1 and %2 mm"),
    QT_TRANSLATE_NOOP("Fault", "the length of the shape (length_mm) leaves less than %1 mm of the block around it"),
    QT_TRANSLATE_NOOP("Fault", "the depth of the channel (depth_mm) leaves less than %1 mm of the block below it"),
    QT_TRANSLATE_NOOP("Fault", "the radius of inner corners (corner_radius_mm) is more than half of the width of the "
                               "channel (width_mm)"),
    QT_TRANSLATE_NOOP("Fault", "the radius between floor and wall (line_angle_mm) is more than the radius of inner "
                               "corners (corner_radius_mm): no bur leaves that"),
    QT_TRANSLATE_NOOP("Fault", "the radius between floor and wall (line_angle_mm) is more than the depth (depth_mm)"),
    QT_TRANSLATE_NOOP("Fault",
                      "the length of the shape (length_mm) must be at least %1 mm with a channel of that width "
                      "(width_mm)"),
    QT_TRANSLATE_NOOP("Fault", "the length of the shape (length_mm) is less than the width of the channel (width_mm)"),
    QT_TRANSLATE_NOOP("Fault",
                      "the length of the shape (length_mm) leaves each of its steps shorter than the channel is "
                      "wide (width_mm)"),
    QT_TRANSLATE_NOOP("Fault", "the length of the shape (length_mm) leaves less than %1 mm of the block between its "
                               "pits (width_mm, steps)"),
    QT_TRANSLATE_NOOP("Fault", "the enamel is thinner where it is thickest (depth_mm) than where it is thinnest "
                               "(enamel_mm)"),
    QT_TRANSLATE_NOOP("Fault", "there is no practice block '%1'; choose one of %2"),
    QT_TRANSLATE_NOOP("Fault", "there is no preparation '%1'; choose one of %2"),
    QT_TRANSLATE_NOOP("Fault", "the preparation '%1' is not made for tooth %2; it is for %3"),
    QT_TRANSLATE_NOOP("Fault", "the radius between floor and wall (line_angle_mm) is more than the radius of the bur "
                               "(bur_radius_mm): no bur leaves that"),
    QT_TRANSLATE_NOOP("Fault",
                      "the width of the isthmus (isthmus_mm) is less than the bur is wide (twice bur_radius_mm)"),
    QT_TRANSLATE_NOOP("Fault", "this preparation would open the pulp; make its depth (depth_mm) less"),
    QT_TRANSLATE_NOOP("Fault", "this preparation would open the pulp; make the reduction (reduction_mm, "
                               "functional_mm) less"),
    QT_TRANSLATE_NOOP("Fault", "this preparation would open the pulp; make its depth (depth_mm) or that of the box "
                               "(box_floor_mm, box_axial_mm) less"),
    QT_TRANSLATE_NOOP("Fault", "this preparation would open the pulp; make the depth of the box (box_floor_mm, "
                               "box_axial_mm) less"),
    QT_TRANSLATE_NOOP("Fault", "nobody knows where the fissures of '%1' run or which side is mesial; choose a tooth by "
                               "its FDI number, or take an ideal from attempts at this one"),
    //: %1: a part of a preparation, %2: keys of numbers
    QT_TRANSLATE_NOOP("Fault", "there is no room for the %1 on this tooth; make one of these less: %2"),
    QT_TRANSLATE_NOOP("Fault", "occlusal outline"), QT_TRANSLATE_NOOP("Fault", "central groove"),
    QT_TRANSLATE_NOOP("Fault", "mesial pit"), QT_TRANSLATE_NOOP("Fault", "distal pit"),
    QT_TRANSLATE_NOOP("Fault", "pits"), QT_TRANSLATE_NOOP("Fault", "none: the tooth has no such groove"),
    QT_TRANSLATE_NOOP("Fault", "tooth %1 has no pulp chamber that could be opened from above"),
    QT_TRANSLATE_NOOP("Fault", "\"%1\" is no side of a tooth; write occlusal, mesial, distal, buccal or lingual"),
    QT_TRANSLATE_NOOP("Fault", "\"%1\" is no side of a scan; write occlusal, -x, +x, -y or +y"),
    QT_TRANSLATE_NOOP("Fault", "a tooth is tilted by %1 to %2 degrees, not by %3"),
    QT_TRANSLATE_NOOP("Fault", "a bur reaches no fissure of a tooth that is tilted by more than %1 degrees"),
    QT_TRANSLATE_NOOP("Fault", "decay below a contact is on the mesial or distal side; let the tooth lie that way"),
    QT_TRANSLATE_NOOP("Fault",
                      "decay at the neck or in a pit of a side is on the buccal or lingual side; let the tooth "
                      "lie that way"),
    QT_TRANSLATE_NOOP("Fault", "there is no pit on the side that tooth '%1' shows"),
    QT_TRANSLATE_NOOP("Fault",
                      "this preparation is made for a tooth that stands upright; leave out \"lies\", or take an "
                      "ideal from attempts at this tooth"),
    QT_TRANSLATE_NOOP("Fault", "The captured ideal is damaged. Use a copy of the file, or capture it again."),
    QT_TRANSLATE_NOOP("Fault",
                      "The ideal was captured on the tooth '%1' (seed %2, grid %3) and does not fit '%4' (seed "
                      "%5, grid %6); name that tooth, seed and grid, or capture it on this one."),
    QT_TRANSLATE_NOOP("Fault", "The captured ideal is empty; choose another file."),
    QT_TRANSLATE_NOOP("Fault", "This is not a captured ideal; choose a file that Cusp has saved as one (*.cuspideal)."),
    QT_TRANSLATE_NOOP("Fault", "The captured ideal is of version %1, this Cusp reads up to version %2; open it with a "
                               "newer Cusp."),
    QT_TRANSLATE_NOOP("Fault",
                      "The captured ideal ends early: it was cut off while being written or copied. Use a whole "
                      "copy."),
    QT_TRANSLATE_NOOP("Fault", "The firmware file is empty; choose another file."),
    QT_TRANSLATE_NOOP("Fault",
                      "The file is larger than %1 KiB and cannot be firmware for the Falcon; choose another file."),
    QT_TRANSLATE_NOOP("Fault", "This is not firmware for the Falcon; choose another file."),
    QT_TRANSLATE_NOOP(
        "Fault", "The firmware file is too short: it has %1 bytes, and its header alone has %2. Use a complete copy."),
    QT_TRANSLATE_NOOP("Fault", "The firmware file ends before its block %1 is complete. Use a complete copy."),
    QT_TRANSLATE_NOOP("Fault", "The firmware ends after %1 bytes, but the file has %2. Use an unchanged copy."),
    QT_TRANSLATE_NOOP("Fault", "The USB of this computer cannot be used (%1). The mouse works without it."),
    QT_TRANSLATE_NOOP("Fault", "You have no permission to use the Falcon. Install the rule that %1 "
                               "prints, then unplug the Falcon and plug it in again."),
    QT_TRANSLATE_NOOP("Fault", "Another program uses the Falcon. Close that program."),
    QT_TRANSLATE_NOOP("Fault", "Another driver of the system holds the Falcon. Give it the driver WinUSB."),
    QT_TRANSLATE_NOOP("Fault", "The USB connection to the Falcon failed (%1). Unplug the Falcon and plug it in again."),
    QT_TRANSLATE_NOOP("Fault", "No Falcon is plugged in."),
    QT_TRANSLATE_NOOP("Fault", "No Falcon with the serial number %1 is plugged in."),
    QT_TRANSLATE_NOOP("Fault", "The Falcon does not answer. Check that its mains adapter is plugged in, then unplug "
                               "its USB cable and plug it in again."),
    QT_TRANSLATE_NOOP("Fault", "The Falcon was unplugged while its firmware was loaded."),
    QT_TRANSLATE_NOOP("Fault",
                      "The Falcon received byte %1 of the firmware wrongly. Try another USB port, without a hub."),
    QT_TRANSLATE_NOOP("Fault", "Loading the firmware was stopped."),
    QT_TRANSLATE_NOOP("Fault", "The firmware file cannot be read; choose it again."),
    QT_TRANSLATE_NOOP("Fault", "The Falcon needs its firmware, which cannot be shipped with Cusp. Choose the firmware "
                               "file of your Falcon's software."),
    QT_TRANSLATE_NOOP("Fault", "The firmware was loaded, but does not answer. Try another firmware file."),
    QT_TRANSLATE_NOOP("Fault", "This program was built without libusb: force devices are left out."),
    QT_TRANSLATE_NOOP("Fault", "This program was built without SDL 2: pedals and gamepads are left out."),
    QT_TRANSLATE_NOOP("Fault",
                      "Pedals and gamepads cannot be read (%1). The mouse and the keyboard work without them."),
    QT_TRANSLATE_NOOP("Fault", "Cusp cannot read pictures: its file %1 or a library of OpenCV is missing. Install Cusp "
                               "again. The mouse works without it."),
    QT_TRANSLATE_NOOP("Fault", "There is no camera %1. Plug in a camera, or choose another one."),
    QT_TRANSLATE_NOOP("Fault", "You have no permission to use camera %1. An administrator of this computer can add you "
                               "to the group \"video\"."),
    QT_TRANSLATE_NOOP("Fault", "Camera %1 gives no pictures. Close other programs that use it, or choose another one."),
    QT_TRANSLATE_NOOP("Fault", "Camera %1 gives no more pictures. Check that it is plugged in."),
    QT_TRANSLATE_NOOP("Fault", "There is no file %1."), QT_TRANSLATE_NOOP("Fault", "The file %1 cannot be read."),
    QT_TRANSLATE_NOOP("Fault", "%1 is no video, or of a kind that cannot be read here."),
    QT_TRANSLATE_NOOP("Fault", "The file %1 is too large for a calibration."),
    QT_TRANSLATE_NOOP("Fault", "%1 is no calibration of a camera."),
    QT_TRANSLATE_NOOP("Fault", "%1: a value is missing or is not a number."), QT_TRANSLATE_NOOP("Fault", "%1: %2"),
    QT_TRANSLATE_NOOP("Fault", "The size of the pictures must be 1 to 16384 pixels a side."),
    QT_TRANSLATE_NOOP("Fault", "The optical centre of a camera must lie within its pictures."),
    QT_TRANSLATE_NOOP("Fault", "The coefficients of a lens must lie between -5 and 5."),
    QT_TRANSLATE_NOOP("Fault", "The focal length of a camera must be 0.1 to 20 times the width of its pictures."),
    QT_TRANSLATE_NOOP("Fault", "The calibration is for pictures of %1 x %2 pixels, and these have %3 x %4. Calibrate "
                               "the camera at this size."),
    QT_TRANSLATE_NOOP("Fault", "There is no handpiece '%1'; choose one of %2."),
    QT_TRANSLATE_NOOP("Fault", "There is no bur '%1'; choose one of %2."),
    QT_TRANSLATE_NOOP("Fault", "There is no hardness preset '%1'; choose natural or typodont, or name a file."),
    QT_TRANSLATE_NOOP("Fault", "the force limit is %1 N, and the device gives at most %2 N; lower it"),
    QT_TRANSLATE_NOOP("Fault",
                      "the stiffness is %1 N/mm, and a light hand at %2 ms of delay is held up to %3 N/mm with "
                      "this damping; lower the stiffness, or damp more"),
    QT_TRANSLATE_NOOP("Fault", "the stiffness is %1 N/mm, and a light hand at %2 ms of delay is held up to %3 N/mm "
                               "however it is damped; lower the stiffness"),
    QT_TRANSLATE_NOOP("Fault", "the stiffness is %1 N/mm, and a light hand at %2 ms of delay is held up to %3 N/mm "
                               "before it buzzes; lower the stiffness"),
    // Units that are words.
    QT_TRANSLATE_NOOP("Fault", "points"), QT_TRANSLATE_NOOP("Fault", "percent"), QT_TRANSLATE_NOOP("Fault", "degrees"),
    QT_TRANSLATE_NOOP("Fault", "minutes")};

/// Returns the translation of a text. Names of numbers may be translated in the form of an ideal.
std::string translated(const std::string& english)
{
    QString words = QCoreApplication::translate("Fault", english.c_str());
    if (words == QString::fromStdString(english))
        words = QCoreApplication::translate("Field", english.c_str());
    return words.toStdString();
}

/// Returns a decimal number, with or without a unit, in the format of the language. Returns any other text unchanged.
std::string localised(const std::string& noted)
{
    static const QRegularExpression fraction(QStringLiteral("^(-?\\d+\\.(\\d+))( MB)?$"));
    const auto found = fraction.match(QString::fromStdString(noted));
    if (!found.hasMatch())
        return noted;
    return (number(found.captured(1).toDouble(), static_cast<int>(found.capturedLength(2))) + found.captured(3))
        .toStdString();
}

core::LocalizableText localised(core::LocalizableText words)
{
    if (words.isNoted)
        words.english = localised(words.english);
    for (core::LocalizableText& value : words.values)
        value = localised(std::move(value));
    return words;
}

}  // namespace

QString faultWords(const core::LocalizableText& what)
{
    return QString::fromStdString(core::said(localised(what), translated));
}

QString faultWords(const lessons::ValidationIssue& fault)
{
    const QString file = QFileInfo(fault.file).fileName();
    const QString what = faultWords(fault.what);
    return fault.key.isEmpty()
               //: %1: the name of a file; %2: what is wrong with it: "is empty"
               ? QCoreApplication::translate("Fault", "%1 %2").arg(file, what)
               : QStringLiteral("%1, %2: %3").arg(file, fault.key, what);
}

}  // namespace ui::text
