// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/devices/SoundWords.h"

#include <QCoreApplication>

namespace ui::devices {
namespace {

using sound::SoundStage;

struct SoundText
{
    Q_DECLARE_TR_FUNCTIONS(ui::devices::SoundText)
};

}  // namespace

Sign signOf(const sound::SoundReport& report)
{
    switch (report.stage) {
    case SoundStage::Off:
        return Sign::Off;
    case SoundStage::NoOutput:
        return Sign::Missing;
    case SoundStage::Refused:
        return Sign::Attention;
    case SoundStage::Ready:
    case SoundStage::Playing:
        break;
    }
    return report.isFallback ? Sign::Attention : Sign::Ready;
}

QString stateWords(const sound::SoundReport& report)
{
    switch (report.stage) {
    case SoundStage::Off:
        //: Of sound
        return SoundText::tr("Off.");
    case SoundStage::NoOutput:
        return SoundText::tr("Silent: this computer has no audio output.");
    case SoundStage::Refused:
        //: %1: an audio output, as the system calls it
        return SoundText::tr("Silent: %1 does not play.").arg(report.output);
    case SoundStage::Ready:
    case SoundStage::Playing:
        break;
    }
    if (report.isFallback)
        //: %1: an audio output, as the system calls it
        return SoundText::tr("The chosen output is missing; %1 plays instead.").arg(report.output);
    //: %1: an audio output, as the system calls it
    return SoundText::tr("Plays on %1.").arg(report.output);
}

QString helpWords(const sound::SoundReport& report)
{
    switch (report.stage) {
    case SoundStage::NoOutput:
        return SoundText::tr("Plug in headphones or loudspeakers: the sound then starts without a restart. Everything "
                             "else works without sound.");
    case SoundStage::Refused:
        return SoundText::tr("Choose another output, or close the program that uses this one. Cusp tries again every "
                             "second.");
    case SoundStage::Off:
    case SoundStage::Ready:
    case SoundStage::Playing:
        break;
    }
    if (report.isFallback)
        return SoundText::tr("Plug the output in again: the sound then returns to it.");
    return SoundText::tr("The handpiece drops in pitch under load. Enamel sounds bright, dentin dull. The sound plays "
                         "while you see the tooth.");
}

}  // namespace ui::devices
