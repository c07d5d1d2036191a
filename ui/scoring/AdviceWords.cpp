// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scoring/AdviceWords.h"

#include <QCoreApplication>

#include "ui/text/Texts.h"

namespace ui::scoring {
namespace {

class AdviceWords
{
    Q_DECLARE_TR_FUNCTIONS(ui::scoring::AdviceWords)
public:
    [[nodiscard]] static QString of(const ::lessons::Advice& advice, const ::lessons::Criterion& criterion);
};

QString AdviceWords::of(const ::lessons::Advice& advice, const ::lessons::Criterion& criterion)
{
    using Rule = ::lessons::Advice::Rule;
    const QString number = text::number(advice.amount, 1);
    const QString whole = text::number(advice.amount, 0);
    const bool isKnown = advice.amount > 0.0;
    switch (advice.rule) {
    case Rule::Perforated:
        return tr("You drilled right through the tooth. Check the depth in the section while you go down.");
    case Rule::PulpOpenedFast:
        //: %1 is a speed in mm/s
        return tr("The bur went down at %1 mm/s when it opened the pulp. Go down slowly, and stop when the floor is "
                  "firm dentin.")
            .arg(number);
    case Rule::PulpOpened:
        return tr("You opened the pulp. Check in the section how much dentin is left before you go deeper, and stop "
                  "when the floor is firm dentin.");
    case Rule::PulpNotReached:
        return tr("The pulp chamber is not open yet. Go on at the place that the X-ray shows until its roof is gone.");
    case Rule::NearPulp:
        //: %1 is a length in mm
        return tr("Only %1 mm of dentin is left over the pulp. Watch the figure for the remaining dentin, and stop "
                  "earlier.")
            .arg(number);
    case Rule::DecayLeft:
        //: %1 is a share in per cent
        return tr("%1 % of the decay is still in the tooth. Clean the walls first and then the floor, until no brown "
                  "is left.")
            .arg(whole);
    case Rule::SoundTissueFast:
        //: %1 is a speed in mm/s
        return tr("The bur went down at %1 mm/s into sound tissue. Lift it as soon as the figure turns yellow.")
            .arg(number);
    case Rule::SoundTissue:
        //: %1 is a volume in mm³
        return tr("You removed %1 mm³ of sound tissue. Follow the brown edge, and take a smaller bur near it.")
            .arg(number);
    case Rule::FarFromDecay:
        //: %1 is a length in mm
        return tr("You cut the tooth %1 mm away from the decay. Lift the bur before you move it, and cut at the decay "
                  "only.")
            .arg(number);
    case Rule::BelowDecay:
        //: %1 is a length in mm
        return tr("The cavity goes %1 mm below the decay. Stop as soon as no brown is left at the bottom.").arg(number);
    case Rule::SoftDecayLeft:
        //: %1 is a share in per cent
        return tr("%1 % of the soft decay is still in the tooth. Remove it from the walls and the floor until the bur "
                  "meets more resistance.")
            .arg(whole);
    case Rule::LeatheryLeft:
        //: %1 is an area in mm²
        return tr("Leathery decay is left on %1 mm² that do not lie over the pulp. Remove it there down to firm "
                  "dentin.")
            .arg(number);
    case Rule::LeftAtJunction:
        //: %1 is an area in mm²
        return tr("Decay is left at the enamel-dentin junction on %1 mm². Clean the junction all the way round.")
            .arg(number);
    case Rule::BelowFirmDecay:
        //: %1 is a length in mm
        return tr("The cavity goes %1 mm deeper than the decay that had to be removed. Stop at firm dentin, and over "
                  "the pulp at leathery dentin.")
            .arg(number);
    case Rule::FloorInEnamel:
        return tr("The floor is still in enamel. Lower it until it lies just inside dentin.");
    case Rule::FloorTilted:
        return tr("The floor is tilted by %1°. Keep the depth stop on, and compare both ends in the section.")
            .arg(whole);
    case Rule::NeighbourTouched:
        return tr(
            "The turning bur touched the neighbouring tooth. Leave a thin shell of enamel towards it, and break it off "
            "last.");
    case Rule::UnsupportedEnamel:
        return tr("Enamel is left without dentin under it. Remove the overhanging edge.");
    case Rule::TooDeepFast:
        //: %1 is a speed in mm/s
        return tr("The bur went down at %1 mm/s and past the floor. Go down slowly, or set the depth stop.")
            .arg(number);
    case Rule::TooDeep:
        return isKnown
                   ? tr("The floor is up to %1 mm too deep. Set the depth stop to the depth that the lesson asks for.")
                         .arg(number)
                   : tr("The floor is too deep. Set the depth stop to the depth that the lesson asks for.");
    case Rule::TooShallow:
        return tr("The floor is up to %1 mm too high. Lower it with the depth stop at the depth that the lesson asks "
                  "for.")
            .arg(number);
    case Rule::NotAllCut:
        //: %1 is a share in per cent
        return tr("%1 % of the preparation is still standing. Compare with the outline and cut what is left inside it.")
            .arg(whole);
    case Rule::OutlineBeyond:
        return isKnown ? tr("You cut up to %1 mm outside the outline. Keep the edge of the bur, not its middle, on the "
                            "line.")
                             .arg(number)
                       : tr("You cut outside the outline. Keep the edge of the bur, not its middle, on the line.");
    case Rule::OutlineShort:
        return tr("The outline stays up to %1 mm inside the ideal one. Widen the cavity to the line.").arg(number);
    case Rule::RidgeThinned:
        return tr("A marginal ridge that should stay is %1 mm thinner than it should be. Stop earlier on the way to "
                  "the ridge.")
            .arg(number);
    case Rule::RidgeThin:
        //: %1 and %2 are lengths in mm
        return tr("The marginal ridge is only %1 mm wide; it should keep %2 mm. Stop earlier on the way to the ridge.")
            .arg(number, text::number(criterion.target, 1));
    case Rule::ObliqueRidgeThin:
        //: %1 and %2 are lengths in mm
        return tr("Only %1 mm of the oblique ridge is left; it should keep %2 mm. Stop earlier on both sides of it.")
            .arg(number, text::number(criterion.target, 1));
    case Rule::GingivalFloorOff:
        //: %1 is a length in mm
        return tr("The gingival floor is %1 mm off the height that the lesson asks for. Check its depth in the section "
                  "before you widen the box.")
            .arg(number);
    case Rule::AxialWallDeep:
        //: %1 is a length in mm
        return tr("The axial wall of the box is %1 mm too far inside the tooth. Compare the depth of the box with the "
                  "width of the bur before you go on inwards.")
            .arg(number);
    case Rule::AxialWallShallow:
        //: %1 is a length in mm
        return tr("The axial wall of the box is %1 mm too far outside. Move the bur inwards along the whole wall.")
            .arg(number);
    case Rule::IsthmusWide:
        return tr("The isthmus is %1 mm too wide. Go through it once, with a bur that is not wider than it.")
            .arg(number);
    case Rule::IsthmusNarrow:
        return tr("The isthmus is %1 mm too narrow. Widen it evenly on both sides.").arg(number);
    case Rule::WallsLean:
        return tr("A wall leans %1° from the ideal. Move the bur along the wall in one stroke at full depth.")
            .arg(whole);
    case Rule::WallsRough:
        return tr("The walls are wavy. Go along each wall once more with the side of the bur, in one light stroke.");
    case Rule::FloorUneven:
        return tr("The floor is uneven. Keep the depth stop on, and sweep the floor in strokes that overlap.");
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
    case Rule::PitTooDeep:
        //: %1 and %2 are lengths in mm
        return tr("The %1 mm pit is %2 mm too deep. Lift the bur sooner, and compare the depth with the head of the "
                  "bur.")
            .arg(text::number(advice.askedMm, 1), number);
    case Rule::PitTooShallow:
        //: %1 and %2 are lengths in mm
        return tr("The %1 mm pit is %2 mm too shallow. Go down in short steps, and compare the depth with the head of "
                  "the bur.")
            .arg(text::number(advice.askedMm, 1), number);
    case Rule::DentinCut:
        //: %1 is a volume in mm³
        return tr("You cut %1 mm³ of dentin. Stop as soon as the bur sinks more easily and the floor looks yellow.")
            .arg(number);
    case Rule::EnamelLeft:
        //: %1 is a length in mm
        return tr("Up to %1 mm of enamel is left on the floor. Cut on with light strokes until the bur meets less "
                  "resistance.")
            .arg(number);
    }
    return {};
}

}  // namespace

QString adviceWords(const ::lessons::Advice& advice, const ::lessons::Criterion& criterion)
{
    return AdviceWords::of(advice, criterion);
}

}  // namespace ui::scoring
