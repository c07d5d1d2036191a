// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/grading/MeasureTable.h"
#include "lessons/PointLossTimeline.h"

namespace lessons {

/// What to do better in the next attempt, for one criterion that lost points.
struct Advice
{
    enum class Rule : std::uint8_t {
        TooLittleDone,  ///< a criterion cannot be judged yet; amount: what was measured of its condition
        Perforated,
        PulpOpenedFast,  ///< amount: feed, mm/s
        PulpOpened,
        PulpNotReached,   ///< of an access cavity
        NearPulp,         ///< amount: mm of dentin that is left
        DecayLeft,        ///< amount: per cent of the lesion
        SoundTissueFast,  ///< amount: feed, mm/s
        SoundTissue,      ///< amount: mm3
        FarFromDecay,     ///< amount: mm
        BelowDecay,       ///< amount: mm
        SoftDecayLeft,    ///< amount: per cent of the soft decay
        LeatheryLeft,     ///< amount: mm2, of decay that has zones
        LeftAtJunction,   ///< amount: mm2
        BelowFirmDecay,   ///< amount: mm, below the decay that had to go
        TooDeepFast,      ///< amount: feed, mm/s
        TooDeep,          ///< amount: mm, or the unit of the criterion where no depth was measured
        TooShallow,       ///< amount: mm
        FloorInEnamel,
        NotAllCut,         ///< amount: per cent of the preparation that still stands
        OutlineBeyond,     ///< amount: mm, 0 where no outline was measured
        OutlineShort,      ///< amount: mm
        RidgeThin,         ///< amount: mm
        RidgeThinned,      ///< amount: mm that are missing
        IsthmusWide,       ///< amount: mm
        IsthmusNarrow,     ///< amount: mm
        WallsLean,         ///< amount: degrees from the ideal
        WallsRough,        ///< amount: mm
        FloorUneven,       ///< amount: mm
        FloorTilted,       ///< amount: degrees
        ObliqueRidgeThin,  ///< amount: mm
        GingivalFloorOff,  ///< amount: mm
        AxialWallDeep,     ///< amount: mm too far in
        AxialWallShallow,  ///< amount: mm too far out
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
        DentinCut,      ///< where enamel alone was to be cut; amount: mm3
        EnamelLeft,     ///< there; amount: mm
    };
    Rule rule = Rule::TooLittleDone;
    std::size_t criterion = 0;     ///< index in the sheet
    double amount = 0.0;           ///< as the rule says
    double askedMm = 0.0;          ///< of a pit: the depth that was asked for
    std::optional<Moment> moment;  ///< when most was lost; empty: no single moment caused it, or it is not found yet
    bool operator==(const Advice&) const = default;
};

/// From this feed on, the advice is to go slower. A pointer starts with 0.5 mm/s.
inline constexpr double kFastFeedMmPerS = 0.8;

/// Finds what to do better: one piece of advice for each rule, for the criteria that lost points. Of two criteria with
/// the same advice it names the one with a weight, which tells what is asked for. Critical errors come first, then the
/// criterion that lost most. Pure; any thread.
/// @param moments  the moments of each criterion of the sheet; empty while they are not known
[[nodiscard]] std::vector<Advice> adviceOn(const ScoreSheet& sheet, const core::grading::Measured& measured,
                                           const std::vector<std::vector<Moment>>& moments);

}  // namespace lessons
