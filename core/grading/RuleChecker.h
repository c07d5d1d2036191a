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

/// What must not happen in an attempt, the gravest first.
enum class RuleViolation : std::uint8_t {
    PulpExposed,   ///< a column was cut down to pulp
    Perforated,    ///< a hole goes through the tooth where none was asked for
    TooDeep,       ///< deeper below the original surface than the limit
    RidgeCut,      ///< nearer to the mesial or distal surface than the limit
    WrongPlace,    ///< cut farther beside what was to be cut than the limit
    TooMuchForce,  ///< more than the limit for 0.2 s
    BurInAir,      ///< after the first cut, the drill ran without touching anything for longer than the limit
    WrongBur,      ///< cut with a bur that is not allowed
    NeighbourHit   ///< the bur, turning, touched a tooth beside
};

/// Which breaches are watched, and from where on. What is absent is not.
struct Rules
{
    bool pulpExposed = false;
    bool perforated = false;
    std::optional<double> depthLimitMm;
    std::optional<double> ridgeLimitMm;
    std::optional<double> besideLimitMm;
    std::optional<double> forceLimitN;
    std::optional<double> airLimitS;
    std::shared_ptr<const terrain::HeightMaps> neighbours;  ///< teeth beside, tooth frame; null: not watched
    std::bitset<bur::kMostBurs> allowedBurs = std::bitset<bur::kMostBurs>().set();  ///< bit k: burs()[k]
    bool operator==(const Rules&) const = default;
};

/// One breach, when and where.
struct Infraction
{
    RuleViolation breach = RuleViolation::PulpExposed;
    std::uint64_t tick = 0;   ///< of the attempt, in which it was found
    double seconds = 0.0;     ///< into the attempt
    glm::dvec3 placeMm{0.0};  ///< the bur's tip, tooth frame
    double value = 0.0;       ///< mm, N or s, as the limit; 0 for those without
    double limit = 0.0;
    bool operator==(const Infraction&) const = default;
};

/// So deep the head of a bur has to reach into a tooth beside before it counts: that one is known no better, and in a
/// contact the two touch.
inline constexpr double kGrazeMm = 0.1;

/// How long a force over the limit is let pass: a tremble is no fault.
inline constexpr std::chrono::milliseconds kForcePatience{200};

/// Watches an attempt tick by tick. Each breach is told once and again only after it was mended: the tooth put back,
/// the force let go, the bur stopped or brought to the tooth, another bur taken. The same ticks give the same
/// infractions, live and in a replay.
///
/// A cut counts from 0.1 mm depth on: what is shallower is a scratch. Any one thread; allocates.
class RuleChecker
{
public:
    /// @param ideal  what is to be cut; null: nothing is, so no place is wrong and
    ///               every hole is one
    RuleChecker(const Rules& rules, std::shared_ptr<const terrain::ToothAnatomy> anatomy, const IdealTop& ideal);

    /// After a step: the new infractions, few if any.
    /// @param changed  columns that the step lowered
    [[nodiscard]] std::vector<Infraction> look(const servo::ServoState& state, const cutting::CutRect& changed,
                                               const terrain::Tooth& tooth, std::chrono::microseconds dt);
    /// The tooth was put back to an earlier state.
    void restored(const terrain::Tooth& tooth);

private:
    static constexpr std::size_t kBreaches = 9;

    void lookBeside(const servo::ServoState& state);
    void lookAtColumns(const cutting::CutRect& rect, const terrain::Tooth& tooth);
    [[nodiscard]] bool hasHole(const terrain::Tooth& tooth) const;
    void find(RuleViolation breach, double value, double limit);
    [[nodiscard]] bool& standing(RuleViolation breach) { return m_standing[static_cast<std::size_t>(breach)]; }

    Rules m_rules;
    std::shared_ptr<const terrain::ToothAnatomy> m_anatomy;
    IdealTop m_ideal;
    std::vector<float> m_besideMm;  ///< distance from what is to be cut, [side * side]; empty: not watched
    std::vector<float> m_ridgeMm;   ///< distance to the nearer of mesial and distal outline along x; empty: not watched
    std::array<bool, kBreaches> m_standing{};
    std::vector<Infraction> m_found;
    Infraction m_now;  ///< when and where, filled by look()
    std::chrono::microseconds m_time{0};
    std::chrono::microseconds m_pressed{0};
    std::chrono::microseconds m_inAir{0};
    std::uint64_t m_holesAskedAt = 0;
    bool m_mayBeHole = false;
    bool m_hasCut = false;
};

}  // namespace core::grading
