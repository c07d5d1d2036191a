// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <bitset>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include "core/bur/Bur.h"
#include "core/cutting/Drill.h"
#include "core/grading/IdealCavity.h"
#include "core/servo/ServoState.h"
#include "core/terrain/Rasteriser.h"

namespace core::grading {

/// Rules that an attempt can break, the most severe first.
enum class RuleViolation : std::uint8_t {
    PulpExposed,   ///< more of the pulp was opened than the limit
    Perforated,    ///< a hole goes through the tooth that was not asked for
    TooDeep,       ///< deeper below the original surface than the limit
    RidgeCut,      ///< nearer to the mesial or distal surface than the limit
    WrongPlace,    ///< cut farther beside the ideal than the limit
    TooMuchForce,  ///< above the limit for longer than kForcePatience
    BurInAir,      ///< after the first cut, the drill ran without contact for longer than the limit
    WrongBur,      ///< cut with a bur that is not allowed
    NeighbourHit   ///< the turning bur touched a neighbouring tooth
};

/// The rules that are checked, with their limits. Empty members are not checked.
struct Rules
{
    std::optional<double> pulpLimitMm2;  ///< area of opened pulp, seen from above
    bool perforated = false;
    std::optional<double> depthLimitMm;
    std::optional<double> ridgeLimitMm;
    std::optional<double> besideLimitMm;
    std::optional<double> forceLimitN;
    std::optional<double> airLimitS;
    std::shared_ptr<const terrain::HeightMaps> neighbours;  ///< neighbouring teeth, tooth frame; null: not checked
    std::bitset<bur::kMostBurs> allowedBurs = std::bitset<bur::kMostBurs>().set();  ///< bit k: burs()[k]
    bool operator==(const Rules&) const = default;
};

/// One broken rule, with time and place.
struct Infraction
{
    RuleViolation breach = RuleViolation::PulpExposed;
    std::uint64_t tick = 0;   ///< tick of the attempt in which it was found
    double seconds = 0.0;     ///< into the attempt
    glm::dvec3 placeMm{0.0};  ///< the bur's tip, tooth frame
    double value = 0.0;       ///< mm, N or s, as the limit; 0 if there is no limit
    double limit = 0.0;
    bool operator==(const Infraction&) const = default;
};

/// Depth of the head of a bur in a neighbouring tooth from which on the contact counts, mm: the surface is known no
/// better, and at a contact point the two teeth touch.
inline constexpr double kGrazeMm = 0.1;

/// Area of opened pulp from which on it counts if a rubric does not say otherwise, mm2. docs/scoring.md gives the
/// reason.
inline constexpr double kPulpLimitMm2 = 0.05;

/// Time for which a force over the limit is tolerated: trembling is no error.
inline constexpr std::chrono::milliseconds kForcePatience{200};

/// Checks the rules of an attempt tick by tick. A broken rule is reported once, and again only after it was complied
/// with in between: the tooth restored, the force released, the bur stopped or in contact, another bur chosen. The same
/// ticks give the same infractions, live and in a replay.
///
/// Cuts of less than 0.1 mm depth are scratches and do not count. One thread; allocates.
class RuleChecker
{
public:
    /// @param ideal  the surface to be cut; null: none, so no place is wrong and every hole counts
    RuleChecker(const Rules& rules, std::shared_ptr<const terrain::ToothAnatomy> anatomy, const IdealTop& ideal);

    /// Returns the new infractions of a step; usually none.
    /// @param changed  columns that the step lowered
    [[nodiscard]] std::vector<Infraction> look(const servo::ServoState& state, const cutting::CutRect& changed,
                                               const terrain::Tooth& tooth, std::chrono::microseconds dt);
    /// Must be called after the tooth was restored to an earlier state.
    void restored(const terrain::Tooth& tooth);

private:
    static constexpr std::size_t kBreaches = 9;

    void lookBeside(const servo::ServoState& state);
    void lookAtColumns(const cutting::CutRect& rect, const terrain::Tooth& tooth);
    void lookAtPulp(std::size_t k, float end);
    [[nodiscard]] bool hasHole(const terrain::Tooth& tooth) const;
    void find(RuleViolation breach, double value, double limit);
    [[nodiscard]] bool& standing(RuleViolation breach) { return m_standing[static_cast<std::size_t>(breach)]; }

    Rules m_rules;
    std::shared_ptr<const terrain::ToothAnatomy> m_anatomy;
    IdealTop m_ideal;
    std::vector<float> m_besideMm;  ///< distance from the ideal cavity, [side * side]; empty: not checked
    std::vector<float> m_ridgeMm;   ///< distance along x to the nearer of mesial and distal outline; empty: not checked
    std::vector<std::uint8_t> m_isPulpOpen;  ///< 1: the pulp of this column is open, [side * side]
    double m_pulpOpenMm2 = 0.0;
    std::array<bool, kBreaches> m_standing{};
    std::vector<Infraction> m_found;
    Infraction m_now;  ///< time and place, set by look()
    std::chrono::microseconds m_time{0};
    std::chrono::microseconds m_pressed{0};
    std::chrono::microseconds m_inAir{0};
    std::uint64_t m_holesAskedAt = 0;
    bool m_mayBeHole = false;
    bool m_hasCut = false;
};

}  // namespace core::grading
