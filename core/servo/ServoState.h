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

/// The state of the servo loop (1 kHz), the cut tiles it sends, and the commands it obeys. Plain values only.
namespace core::servo {

/// Bits of ServoState::health.
enum Health : std::uint32_t {
    kDeviceLost = 1U << 0U,      ///< no sample from the device: force is zero
    kForceClamped = 1U << 1U,    ///< the wanted force passed the clamp this tick
    kPatchQueueFull = 1U << 2U,  ///< the session is late: cut tiles wait in the servo
    kRecordGap = 1U << 3U,       ///< the session was so late that ticks are missing from the recording
    kBegunInside = 1U << 4U,     ///< the bur began inside the tooth: no force and no cutting until it has been out
    kLoopIsSlow = 1U << 5U,      ///< force comes late: the spring is softer than set
    kLedHome = 1U << 6U,         ///< the hand is led home over the tooth (contact::WorkArea)
    kHeldInside = 1U << 7U,      ///< a fixture holds the hand within the outline (guidance::Fixture)
};

/// Where the bur was at one moment.
struct Pose
{
    std::int64_t takenNs = 0;  ///< steady clock, when the device was read; 0: never
    glm::dvec3 deviceMm{0.0};  ///< as in ServoState
    glm::dvec3 anchorMm{0.0};
};

/// Newest state of the servo. Servo thread writes, ui reads.
struct ServoState
{
    std::uint64_t tick = 0;
    std::uint64_t missedPeriods = 0;      ///< periods skipped since the start, never made up for
    std::uint64_t toothGeneration = 0;    ///< grows by one with every tooth handed to the servo
    glm::dvec3 deviceMm{0.0, 0.0, 10.0};  ///< where the hand is, tooth frame
    glm::dvec3 anchorMm{0.0, 0.0, 10.0};  ///< tip of the bur as it is drawn: never inside the tooth
    glm::dvec3 forceN{0.0};               ///< on the hand
    bool touching = false;
    bool drillOn = false;           ///< the bur turns
    bool drillSwitchedOn = false;   ///< with a pedal, the bur turns only while the pedal is down
    bool cutting = false;           ///< material came away this tick
    bool handpieceOnCrown = false;  ///< the crown holds the handpiece up: what is pushed beyond presses on no bur
    std::uint8_t burIndex = 0;
    std::uint8_t handpieceIndex = 0;                                 ///< into the attempt's handpieces (ServoSettings)
    terrain::Material materialUnderBur = terrain::Material::Enamel;  ///< meaningful while touching
    double burRpm = 0.0;    ///< turns of the bur a minute under its load; 0 with the drill off
    double depthMm = 0.0;   ///< of the tip below the original surface, 0 outside
    bool hasDepth = false;  ///< the tip stands over the tooth, away from its flanks: only there depthMm says something
    terrain::PerMaterial removedMm3{};  ///< since the tooth was taken anew
    terrain::PerMaterial brokenMm3{};   ///< of it, what broke off
    std::uint32_t health = 0;
    /// Where the bur has been of late, a pose a tick, as a ring: what is drawn at some moment is found between two of
    /// them. Empty where no device is read.
    std::array<Pose, 16> trail{};
};

/// Side of the square tiles in which cut heights travel and are remembered.
inline constexpr int kTileSide = 16;

/// New top heights of one tile. A height of kEmptyTop means the column is gone: its bottom is empty as well.
/// Patches come in groups, each group the whole difference between two moments of the tooth; `last` closes a group,
/// and a reader applies a group only when it has all of it, so it never sees the model half done.
struct TilePatch
{
    std::uint64_t tick = 0;             ///< the tooth after this servo tick
    std::uint64_t toothGeneration = 0;  ///< which tooth; patches of an older one are to be ignored
    std::uint16_t tileX = 0;
    std::uint16_t tileY = 0;
    bool last = false;
    bool strokeEnded = false;  ///< with `last`: the bur has left the material, an undo step ends here
    std::array<float, static_cast<std::size_t>(kTileSide) * kTileSide> top{};  ///< row by row, i fast
};

/// What the mouse, pen or keys ask of the pointer device. Ui writes (TripleBuffer), the pointer device reads.
struct PointerInput
{
    glm::dvec2 targetMm{0.0, 0.0};  ///< where over the tooth, tooth frame
    double hoverMm = 4.0;           ///< height of the tip while not pushing, tooth frame z
    bool pushing = false;           ///< button held: lean on the tooth
    double pushForceN = 1.0;        ///< how hard
    /// How fast the bur goes down at most while pushing, mm/s. 0: as fast as the force drives it.
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
    kBurColourAid = 1U << 6U,  ///< the bur coloured by what is left to the limit
    kFixtureAid = 1U << 7U,    ///< a hand held within the outline
    kAllAids = (1U << 8U) - 1U,
};
/// The note that the work was graded at this moment: "GRADED".
inline constexpr std::uint64_t kGradedNote = 0x475241444544ULL << 16U;
/// The notes that the student has turned from the work ("RESTED"), and is back at it ("WORKED"): what is between them
/// is no time of the attempt (LiveAssessor).
inline constexpr std::uint64_t kRestNote = 0x524553544544ULL << 16U;
inline constexpr std::uint64_t kWorkNote = 0x574F524B4544ULL << 16U;
/// Commands to the servo. The session passes them on.
struct SetBur
{
    std::uint8_t index = 0;
};
struct SetDrill
{
    bool on = false;
};
/// Another of the handpieces at hand.
struct SetHandpiece
{
    std::uint8_t index = 0;  ///< into the attempt's handpieces (ServoSettings)
};
/// One of the numbers of the servo's settings (ServoParameters.h) is this from now on, until a tooth is taken anew.
/// Goes on the recording.
struct SetParameter
{
    std::uint8_t index = 0;
    float value = 0.0F;
};
/// Holds the hand within an outline until this command comes again. The pointer owns; it comes back by
/// ServoChannels::retiredFixtures.
struct SetFixture
{
    const guidance::Fixture* fixture = nullptr;  ///< null: none
};
/// Lead the hand home over the tooth; nothing where the device has no work area.
struct BringHome
{};
}  // namespace core::servo
