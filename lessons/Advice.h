// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/grading/MeasureTable.h"
#include "lessons/PointLossTimeline.h"

namespace lessons {

/// Advice for the next attempt about one criterion that lost points.
struct Advice
{
    enum class Rule : std::uint8_t {
        TooLittleDone,  ///< the criterion cannot be judged yet; amount: measured value of its condition
        Perforated,
        PulpOpenedFast,  ///< amount: feed, mm/s
        PulpOpened,
        PulpNotReached,   ///< for an access cavity
        NearPulp,         ///< amount: mm of dentin left
        DecayLeft,        ///< amount: per cent of the lesion
        SoundTissueFast,  ///< amount: feed, mm/s
        SoundTissue,      ///< amount: mm3
        FarFromDecay,     ///< amount: mm
        BelowDecay,       ///< amount: mm
        SoftDecayLeft,    ///< amount: per cent of the soft decay
        LeatheryLeft,     ///< amount: mm2, of decay that has zones
        LeftAtJunction,   ///< amount: mm2
        BelowFirmDecay,   ///< amount: mm, below the decay that had to be removed
        TooDeepFast,      ///< amount: feed, mm/s
        TooDeep,          ///< amount: mm, or the unit of the criterion where no depth was measured
        TooShallow,       ///< amount: mm
        FloorInEnamel,
        NotAllCut,         ///< amount: per cent of the preparation that is left
        OutlineBeyond,     ///< amount: mm; 0 if no outline was measured
        OutlineShort,      ///< amount: mm
        RidgeThin,         ///< amount: mm
        RidgeThinned,      ///< amount: mm missing
        IsthmusWide,       ///< amount: mm
        IsthmusNarrow,     ///< amount: mm
        WallsLean,         ///< amount: degrees from the ideal
        WallsRough,        ///< amount: mm
        FloorUneven,       ///< amount: mm
        FloorTilted,       ///< amount: degrees
        ObliqueRidgeThin,  ///< amount: mm
        GingivalFloorOff,  ///< amount: mm
        AxialWallDeep,     ///< amount: mm too deep
        AxialWallShallow,  ///< amount: mm too shallow
        UnsupportedEnamel,
        NeighbourTouched,
        PushedTooHard,
        ForceNotHeld,
        TooSlow,
        NotTouched,     ///< points of an exercise
        NotNamed,       ///< layers of an exercise
        CutInExercise,  ///< amount: mm3
        PitTooDeep,     ///< amount: mm
        PitTooShallow,  ///< amount: mm
        DentinCut,      ///< where only enamel was to be cut; amount: mm3
        EnamelLeft,     ///< likewise; amount: mm
    };
    Rule rule = Rule::TooLittleDone;
    std::size_t criterion = 0;     ///< index in the sheet
    double amount = 0.0;           ///< as described by the rule
    double askedMm = 0.0;          ///< for a pit: depth that the exercise asks for
    std::optional<Moment> moment;  ///< when most was lost; empty: no single moment caused it, or it is not known yet
    bool operator==(const Advice&) const = default;
};

/// Least feed at which the advice is to go slower. The feed of a pointer is 0.5 mm/s initially.
inline constexpr double kFastFeedMmPerS = 0.8;

/// Returns one piece of advice per rule, for the criteria that lost points. If two criteria lead to the same advice, it
/// names the one with a weight, which describes the task. Critical errors come first, then the criterion that lost most
/// points. Pure; any thread.
/// @param moments  the moments of each criterion of the sheet; empty while unknown
[[nodiscard]] std::vector<Advice> adviceOn(const ScoreSheet& sheet, const core::grading::Measured& measured,
                                           const std::vector<std::vector<Moment>>& moments);

}  // namespace lessons
