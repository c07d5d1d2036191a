// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/study/AdviceWords.h"

#include <QCoreApplication>

#include "ui/text/Texts.h"

namespace ui::study {
namespace {

using ::lessons::Advice;
using Rule = Advice::Rule;

class AdviceWords
{
    Q_DECLARE_TR_FUNCTIONS(ui::study::AdviceWords)
public:
    [[nodiscard]] static QString ofTissue(const Advice& advice);
    [[nodiscard]] static QString ofForm(const Advice& advice, const ::lessons::Criterion& criterion);
    [[nodiscard]] static QString ofTheWay(const Advice& advice);
};

QString AdviceWords::ofTissue(const Advice& advice)
{
    const QString feed = text::number(advice.amount, 1);
    switch (advice.rule) {
    case Rule::Perforated:
        return tr("You drilled right through the tooth. Check the depth in the section while you go down.");
    case Rule::PulpOpenedFast:
        //: %1 is a speed in mm/s
        return tr("The bur went down at %1 mm/s when it opened the pulp. Go down slowly, and stop when the floor is "
                  "firm "
                  "dentin.")
            .arg(feed);
    case Rule::PulpOpened:
        return tr(
            "You opened the pulp. Check in the section how much dentin is left before you go deeper, and stop when "
            "the floor is firm dentin.");
    case Rule::PulpNotReached:
        return tr("The pulp chamber is not open yet. Go on at the place that the X-ray shows until its roof is gone.");
    case Rule::DecayLeft:
        //: %1 is a share in per cent
        return tr("%1 % of the decay is still in the tooth. Clean the walls first and then the floor, until no brown "
                  "is "
                  "left.")
            .arg(text::number(advice.amount, 0));
    case Rule::SoundTissueFast:
        //: %1 is a speed in mm/s
        return tr("The bur went down at %1 mm/s into sound tissue. Lift it as soon as the figure turns yellow.")
            .arg(feed);
    case Rule::SoundTissue:
        //: %1 is a volume in mm³
        return tr("You removed %1 mm³ of sound tissue. Follow the brown edge, and take a smaller bur near it.")
            .arg(text::number(advice.amount, 1));
    case Rule::UnsupportedEnamel:
        return tr("Enamel is left without dentin under it. Remove the overhanging edge.");
    default:
        return {};
    }
}

QString AdviceWords::ofForm(const Advice& advice, const ::lessons::Criterion& criterion)
{
    const QString mm = text::number(advice.amount, 1);
    const bool isKnown = advice.amount > 0.0;
    switch (advice.rule) {
    case Rule::TooDeepFast:
        //: %1 is a speed in mm/s
        return tr("The bur went down at %1 mm/s and past the floor. Go down slowly, or set the depth stop.").arg(mm);
    case Rule::TooDeep:
        return isKnown
                   ? tr("The floor is up to %1 mm too deep. Set the depth stop to the depth that the lesson asks for.")
                         .arg(mm)
                   : tr("The floor is too deep. Set the depth stop to the depth that the lesson asks for.");
    case Rule::TooShallow:
        return tr("The floor is up to %1 mm too high. Lower it with the depth stop at the depth that the lesson asks "
                  "for.")
            .arg(mm);
    case Rule::NotAllCut:
        //: %1 is a share in per cent
        return tr("%1 % of the preparation is still standing. Compare with the outline and cut what is left inside it.")
            .arg(text::number(advice.amount, 0));
    case Rule::OutlineBeyond:
        return isKnown ? tr("You cut up to %1 mm outside the outline. Keep the edge of the bur, not its middle, on the "
                            "line.")
                             .arg(mm)
                       : tr("You cut outside the outline. Keep the edge of the bur, not its middle, on the line.");
    case Rule::OutlineShort:
        return tr("The outline stays up to %1 mm inside the ideal one. Widen the cavity to the line.").arg(mm);
    case Rule::RidgeThin:
        //: %1 and %2 are lengths in mm
        return tr("The marginal ridge is only %1 mm wide; it should keep %2 mm. Stop earlier on the way to the ridge.")
            .arg(mm, text::number(criterion.target, 1));
    case Rule::IsthmusWide:
        return tr("The isthmus is %1 mm too wide. Go through it once, with a bur that is not wider than it.").arg(mm);
    case Rule::IsthmusNarrow:
        return tr("The isthmus is %1 mm too narrow. Widen it evenly on both sides.").arg(mm);
    case Rule::WallsLean:
        return tr("A wall leans %1° from the ideal. Move the bur along the wall in one stroke at full depth.")
            .arg(text::number(advice.amount, 0));
    case Rule::FloorUneven:
        return tr("The floor is uneven. Keep the depth stop on, and sweep the floor in strokes that overlap.");
    default:
        return {};
    }
}

QString AdviceWords::ofTheWay(const Advice& advice)
{
    switch (advice.rule) {
    case Rule::TooLittleDone:
        return tr("Too little is done to judge this. Finish the preparation first.");
    case Rule::PushedTooHard:
        return tr("You pushed too hard. Let the bur do the work.");
    case Rule::ForceNotHeld:
        return tr("Watch the gauge and change the force slowly until it stays in the range.");
    case Rule::TooSlow:
        return tr("You took longer than asked. Plan the strokes before you begin.");
    case Rule::NotTouched:
        return tr("Some points are not touched yet. The ring marks one of them.");
    case Rule::NotNamed:
        return tr("Touch each pad slowly again: enamel is hardest, dentin yields, decay is soft.");
    case Rule::CutInExercise:
        return tr("You cut the tooth. In this exercise the bur only touches it: do not press the drill.");
    default:
        return {};
    }
}

}  // namespace

QString adviceWords(const Advice& advice, const ::lessons::Criterion& criterion)
{
    for (const QString& words :
         {AdviceWords::ofTissue(advice), AdviceWords::ofForm(advice, criterion), AdviceWords::ofTheWay(advice)})
        if (!words.isEmpty())
            return words;
    return {};
}

}  // namespace ui::study
