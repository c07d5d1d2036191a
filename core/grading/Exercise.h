// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include <glm/vec2.hpp>

#include "core/servo/ServoState.h"

/// Exercises of the first five minutes, in which nothing is to be prepared: a hand learns to find a place, to hold a
/// force and to tell tissues apart.
namespace core::grading {

/// Points of the tooth to be touched with the drill off, in any order.
struct PointsToTouch
{
    std::vector<glm::dvec2> pointsMm;  ///< tooth frame, seen from above
    double reachMm = 0.6;              ///< so near to a point the tip touches it
    bool operator==(const PointsToTouch&) const = default;
};

/// A force to be held on the tooth with the drill off.
struct ForceToHold
{
    double forceN = 1.0;
    double withinN = 0.2;   ///< so far off it is still held
    double seconds = 10.0;  ///< at a stretch
    bool operator==(const ForceToHold&) const = default;
};

/// How many pads a block of layers has (teeth::padMaterials).
inline constexpr std::size_t kPads = 3;

/// Pads of a block that are to be told apart by feel, unseen.
struct PadsToName
{
    std::array<terrain::Material, kPads> madeOf{};  ///< in the order of +x
    bool operator==(const PadsToName&) const = default;
};

using Exercise = std::variant<PointsToTouch, ForceToHold, PadsToName>;

/// Which points were touched. Seconds into the attempt, of the ticks' own steps.
struct Touched
{
    std::vector<std::optional<double>> atS;  ///< when each was touched first
    [[nodiscard]] std::size_t count() const;
    bool operator==(const Touched&) const = default;
};

/// How the force was held: until it had been held for long enough once; what comes later changes nothing. Only time
/// with the drill off counts.
struct Held
{
    double longestS = 0.0;    ///< longest stretch; one that goes on counts as far as it has come
    double nowS = 0.0;        ///< the stretch that goes on; 0: none does
    double heldS = 0.0;       ///< in all
    double pressedS = 0.0;    ///< in contact, from the first moment that the force was right
    double meanErrorN = 0.0;  ///< mean distance from the force that was asked for, over pressedS
    bool isDone = false;
    bool operator==(const Held&) const = default;
};

/// What the pads were said to be.
struct Named
{
    std::array<std::optional<terrain::Material>, kPads> saidToBe{};  ///< the answer given last
    std::size_t right = 0;
    bool operator==(const Named&) const = default;
};

/// How an exercise went, the alternative of the same number as the exercise's.
using Practised = std::variant<Touched, Held, Named>;

/// Nothing is left to be done; of pads, each has an answer, right or wrong.
[[nodiscard]] bool isDone(const Practised& practised);
/// Something was done at all.
[[nodiscard]] bool isBegun(const Practised& practised);

/// A contact with less force than this is a graze and touches nothing, N.
inline constexpr double kTouchN = 0.1;
/// So long the force may leave its band without an end of the stretch; that time does not count as held.
inline constexpr std::chrono::milliseconds kHoldPatience{200};

/// The note (session::AddNote) that puts the answer to a pad on the recording.
[[nodiscard]] std::uint64_t answerNote(std::size_t pad, terrain::Material said);
/// What a note answers; nothing where it is no answer.
struct Answer
{
    std::size_t pad = 0;
    terrain::Material said = terrain::Material::Enamel;
    bool operator==(const Answer&) const = default;
};
[[nodiscard]] std::optional<Answer> answerOf(std::uint64_t note);

/// Watches an exercise tick by tick, live or from a replay: the same ticks and notes give the same bits. Any one
/// thread; no allocation after construction.
class ExerciseMeter
{
public:
    explicit ExerciseMeter(Exercise exercise);

    /// The state after a tick of `dt`. Without a device nothing is touched or held.
    void take(const servo::ServoState& state, std::chrono::microseconds dt);
    /// A note on the recording; one that is no answer is nothing here.
    void noted(std::uint64_t note);

    [[nodiscard]] const Practised& practised() const { return m_practised; }

private:
    void take(const PointsToTouch& asked, const glm::dvec3& tipMm, double newtons);
    void take(const ForceToHold& asked, bool presses, double newtons, std::chrono::microseconds dt);

    Exercise m_exercise;
    Practised m_practised;
    std::chrono::microseconds m_time{0};
    // Of a force that is held:
    std::chrono::microseconds m_stretch{0};
    std::chrono::microseconds m_off{0};  ///< out of the band since the stretch last grew
    std::chrono::microseconds m_longest{0};
    std::chrono::microseconds m_held{0};
    std::chrono::microseconds m_pressed{0};
    double m_errorNS = 0.0;
};

}  // namespace core::grading
