// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/devices/TrackingWords.h"

#include <QCoreApplication>

#include "ui/text/ValidationTexts.h"

namespace ui::devices {
namespace {

using core::tracking::PictureTrouble;
using core::tracking::TrackerStage;

struct TrackingText
{
    Q_DECLARE_TR_FUNCTIONS(ui::devices::TrackingText)
};

bool isVideo(const TrackingState& state)
{
    return !state.settings.video.isEmpty();
}

/// Returns whether the camera is much slower than requested, as cameras are when low light needs long exposures.
bool isSlow(const TrackingState& state)
{
    constexpr double kEnough = 0.7;
    return !isVideo(state) && state.report.hz > 0.0 && state.report.hz < kEnough * state.settings.hz;
}

QString helpWithoutTag(const TrackingState& state)
{
    //: %1: a number; the button "Print the tag …" is on the same page
    return TrackingText::tr("Turn to the camera so that the whole tag and its white border are in the picture. The tag "
                            "must have the number %1. A lamp or a window behind you makes it too dark.")
        .arg(state.settings.tagId);
}

}  // namespace

bool hasPictures(const TrackingState& state)
{
    const TrackerStage stage = state.report.stage;
    return state.isInBuild && state.settings.isOn && (stage == TrackerStage::NoTag || stage == TrackerStage::Tracking);
}

Sign signOf(const TrackingState& state)
{
    if (!state.isInBuild)
        return Sign::Missing;
    if (!state.settings.isOn)
        return Sign::Off;
    if (state.report.stage == TrackerStage::Opening)
        return Sign::Working;
    const bool isWell = state.report.stage == TrackerStage::Tracking && state.report.trouble == PictureTrouble::None &&
                        state.report.sameTags <= 1;
    return isWell ? Sign::Ready : Sign::Attention;
}

QString stateWords(const TrackingState& state)
{
    if (!state.isInBuild)
        return TrackingText::tr("Not available: head tracking is left out of this program.");
    if (!state.settings.isOn)
        //: Of head tracking
        return TrackingText::tr("Off.");
    switch (state.report.stage) {
    case TrackerStage::Opening:
        return isVideo(state) ? TrackingText::tr("The pictures are being opened.")
                              : TrackingText::tr("The camera is being opened.");
    case TrackerStage::NoCamera:
        return isVideo(state) ? TrackingText::tr("The pictures cannot be read.")
                              : TrackingText::tr("The camera sends no pictures.");
    case TrackerStage::Ended:
        return TrackingText::tr("The last picture has been shown.");
    case TrackerStage::NoTag:
    case TrackerStage::Tracking:
        break;
    }
    if (state.report.trouble == PictureTrouble::Dark)
        return TrackingText::tr("The pictures are dark.");
    if (state.report.trouble == PictureTrouble::Bright)
        return TrackingText::tr("The pictures are nearly white.");
    if (state.report.trouble == PictureTrouble::Frozen)
        return TrackingText::tr("The pictures do not change.");
    if (state.report.sameTags > 1)
        //: %1: a number
        return TrackingText::tr("Several tags with the number %1 are in the picture.").arg(state.settings.tagId);
    return state.report.stage == TrackerStage::Tracking ? TrackingText::tr("The view follows your head.")
                                                        : TrackingText::tr("The tag is not in the picture.");
}

QString helpWords(const TrackingState& state)
{
    if (!state.isInBuild)
        return TrackingText::tr(
            "Install the libraries AprilTag and OpenCV and build Cusp again, or use a package that has them. The mouse "
            "turns the view without them.");
    if (!state.settings.isOn)
        return TrackingText::tr("The view turns when you move your head. Print the tag, glue it to stiff card and wear "
                                "it on a headband, tilted by about 20°. Then turn on “Follow my head”.");
    switch (state.report.stage) {
    case TrackerStage::Opening:
        return TrackingText::tr("This takes a few seconds at most.");
    case TrackerStage::NoCamera:
        //: %1: what went wrong and what to do, one or two sentences
        return TrackingText::tr("%1 Cusp tries again by itself. The mouse turns the view meanwhile.")
            .arg(text::faultWords(core::wordsOf(state.report.error)));
    case TrackerStage::Ended:
        return TrackingText::tr("To see the pictures again, turn “Follow my head” off and on.");
    case TrackerStage::NoTag:
    case TrackerStage::Tracking:
        break;
    }
    if (state.report.trouble == PictureTrouble::Dark)
        return TrackingText::tr("Turn on more light, and check that no cover is in front of the camera.");
    if (state.report.trouble == PictureTrouble::Bright)
        return TrackingText::tr("Turn the camera away from lamps and windows, or lower its exposure.");
    if (state.report.trouble == PictureTrouble::Frozen)
        return isVideo(state) ? TrackingText::tr("Choose other pictures, or a camera.")
                              : TrackingText::tr("Unplug the camera and plug it in again, or choose another one.");
    if (state.report.sameTags > 1)
        return TrackingText::tr("The view follows the largest one. Take the others out of the picture.");
    if (state.report.stage == TrackerStage::NoTag)
        return helpWithoutTag(state);
    if (isSlow(state))
        //: %1 and %2: numbers
        return TrackingText::tr("The camera gives %1 pictures a second, not %2: in little light it exposes for longer. "
                                "Turn on more light, or choose smaller pictures.")
            .arg(qRound(state.report.hz))
            .arg(state.settings.hz);
    return TrackingText::tr("Sit as you do when you drill, look at the screen, and press “Straight ahead is here”.");
}

}  // namespace ui::devices
