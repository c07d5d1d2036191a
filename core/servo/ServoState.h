// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/terrain/Tooth.h"

namespace core::guidance {
class Fixture;
}

/// The state of the servo loop (1 kHz), the cut tiles that it sends, and its commands. Plain values only.
namespace core::servo {

/// Bits of ServoState::health.
enum Health : std::uint32_t {
    kDeviceLost = 1U << 0U,      ///< no sample from the device: force is zero
    kForceClamped = 1U << 1U,    ///< the computed force was above the limit in this tick
    kPatchQueueFull = 1U << 2U,  ///< the session is late: cut tiles wait in the servo
    kRecordGap = 1U << 3U,       ///< the session was so late that ticks are missing from the recording
    kBegunInside = 1U << 4U,     ///< the bur started inside the tooth: no force and no cutting until it has left the
                                 ///< tooth
    kLoopIsSlow = 1U << 5U,      ///< the force is delayed: the stiffness is reduced
    kLedHome = 1U << 6U,         ///< the device leads the hand to its start over the tooth (contact::WorkArea)
    kHeldInside = 1U << 7U,      ///< a fixture keeps the hand within the outline (guidance::Fixture)
};

/// The pose of the bur at one moment.
struct Pose
{
    std::int64_t takenNs = 0;  ///< steady clock, when the device was read; 0: never
    glm::dvec3 deviceMm{0.0};  ///< as in ServoState
    glm::dvec3 anchorMm{0.0};
};

/// The newest state of the servo. The servo thread writes it, the ui reads it.
struct ServoState
{
    std::uint64_t tick = 0;
    std::uint64_t missedPeriods = 0;      ///< periods skipped since the start; they are not caught up
    std::uint64_t toothGeneration = 0;    ///< increases by one with every tooth given to the servo
    glm::dvec3 deviceMm{0.0, 0.0, 10.0};  ///< place of the hand, tooth frame
    glm::dvec3 anchorMm{0.0, 0.0, 10.0};  ///< tip of the bur as drawn, tooth frame: never inside the tooth
    glm::dvec3 forceN{0.0};               ///< on the hand
    bool touching = false;
    bool drillOn = false;           ///< the bur turns
    bool drillSwitchedOn = false;   ///< with a pedal, the bur turns only while the pedal is down
    bool cutting = false;           ///< material came away this tick
    bool handpieceOnCrown = false;  ///< the crown supports the handpiece: force beyond that does not press on the bur
    std::uint8_t burIndex = 0;
    std::uint8_t handpieceIndex = 0;                                 ///< into the attempt's handpieces (ServoSettings)
    terrain::Material materialUnderBur = terrain::Material::Enamel;  ///< meaningful while touching
    double burRpm = 0.0;    ///< speed of the bur under its load, turns per minute; 0 with the drill off
    double depthMm = 0.0;   ///< of the tip below the original surface, 0 outside
    bool hasDepth = false;  ///< the tip is over the tooth and not over its flanks; otherwise depthMm has no meaning
    terrain::PerMaterial removedMm3{};  ///< since the tooth was last replaced or reset
    terrain::PerMaterial brokenMm3{};   ///< part of removedMm3 that broke off
    std::uint32_t health = 0;
    /// The latest poses of the bur, one per tick, in a ring. Drawing interpolates between two of them. Empty if no
    /// device is read.
    std::array<Pose, 16> trail{};
};

/// Side of the square tiles in which cut heights are sent and stored, columns.
inline constexpr int kTileSide = 16;

/// New top heights of one tile. A height of kEmptyTop means that the column is gone: its bottom is empty as well.
/// Patches are sent in groups; each group is the complete difference between two moments of the tooth, and `last` ends
/// it. A reader applies complete groups only, so that it never sees a partial change.
struct TilePatch
{
    std::uint64_t tick = 0;             ///< the tooth after this servo tick
    std::uint64_t toothGeneration = 0;  ///< patches of an older tooth must be ignored
    std::uint16_t tileX = 0;
    std::uint16_t tileY = 0;
    bool last = false;
    bool strokeEnded = false;  ///< with `last`: the bur has left the material, and an undo step ends here
    std::array<float, static_cast<std::size_t>(kTileSide) * kTileSide> top{};  ///< row by row, i fast
};

/// The input of the pointer device from mouse, pen or keys. The ui writes it (TripleBuffer), the pointer device reads
/// it.
struct PointerInput
{
    glm::dvec2 targetMm{0.0, 0.0};  ///< over the tooth, tooth frame
    double hoverMm = 4.0;           ///< height of the tip while not pushing, tooth frame z
    bool pushing = false;           ///< the button is held: the bur pushes on the tooth
    double pushForceN = 1.0;        ///< how hard
    /// Highest speed at which the pushed bur goes down, mm/s. 0: no limit but the force.
    double feedMmPerS = 0.0;
    double stopMm = -std::numeric_limits<double>::infinity();  ///< lowest height of the tip, tooth frame z
    bool buttonIsPedal = false;                                ///< the bur turns only while pushing
    bool operator==(const PointerInput&) const = default;
};

/// Bits of SetAids.
enum Aid : std::uint8_t {
    kSectionAid = 1U << 0U,
    kDepthGaugeAid = 1U << 1U,
    kRadiographAid = 1U << 2U,
    kHeatMapAid = 1U << 3U,
    kMirrorAid = 1U << 4U,
    kIdealAid = 1U << 5U,
    kBurColourAid = 1U << 6U,  ///< the bur coloured by its distance to the limit
    kFixtureAid = 1U << 7U,    ///< a force that keeps the hand within the outline
    kAllAids = (1U << 8U) - 1U,
};
/// The note that the work was graded at this moment: "GRADED".
inline constexpr std::uint64_t kGradedNote = 0x475241444544ULL << 16U;
/// The notes that the student has paused ("RESTED") and resumed ("WORKED"): the time between them does not count
/// (LiveAssessor).
inline constexpr std::uint64_t kRestNote = 0x524553544544ULL << 16U;
inline constexpr std::uint64_t kWorkNote = 0x574F524B4544ULL << 16U;
/// Commands to the servo. The session forwards them.
struct SetBur
{
    std::uint8_t index = 0;
};
struct SetDrill
{
    bool on = false;
};
/// Selects another of the attempt's handpieces.
struct SetHandpiece
{
    std::uint8_t index = 0;  ///< into the attempt's handpieces (ServoSettings)
};
/// Sets a parameter of the servo (ServoParameters.h) until another tooth begins. Recorded.
struct SetParameter
{
    std::uint8_t index = 0;
    float value = 0.0F;
};
/// Keeps the hand within an outline until the next such command. The servo owns the fixture and returns it by
/// ServoChannels::retiredFixtures.
struct SetFixture
{
    const guidance::Fixture* fixture = nullptr;  ///< null: none
};
/// Leads the hand to its start over the tooth. Does nothing if the device has no work area.
struct BringHome
{};
}  // namespace core::servo
