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

/// Exercises for the first five minutes, without a preparation: finding a place, holding a force, and recognising
/// tissues.
namespace core::grading {

/// Points of the tooth to touch with the drill off, in any order.
struct PointsToTouch
{
    std::vector<glm::dvec2> pointsMm;  ///< tooth frame, seen from above
    double reachMm = 0.6;              ///< distance from a point at which the tip touches it
    bool operator==(const PointsToTouch&) const = default;
};

/// An exercise: the student presses on the tooth with a given force while the drill is off.
struct ForceToHold
{
    double forceN = 1.0;
    double withinN = 0.2;   ///< tolerance
    double seconds = 10.0;  ///< duration without interruption
    bool operator==(const ForceToHold&) const = default;
};

/// Number of pads of a block of layers (teeth::padMaterials).
inline constexpr std::size_t kPads = 3;

/// Pads of a block whose tissues are to be recognised by feel, unseen.
struct PadsToName
{
    std::array<terrain::Material, kPads> madeOf{};  ///< in the order of +x
    bool operator==(const PadsToName&) const = default;
};

using Exercise = std::variant<PointsToTouch, ForceToHold, PadsToName>;

/// The points that were touched. Seconds from the start of the attempt, as the sum of the ticks' steps.
struct Touched
{
    std::vector<std::optional<double>> atS;  ///< time of the first touch of each point
    [[nodiscard]] std::size_t count() const;
    bool operator==(const Touched&) const = default;
};

/// The result of holding a force, up to the first success; later contact changes nothing. Only time with the drill off
/// counts.
struct Held
{
    double longestS = 0.0;    ///< longest stretch, including the current one
    double nowS = 0.0;        ///< current stretch; 0: none
    double heldS = 0.0;       ///< total
    double pressedS = 0.0;    ///< in contact, from the first moment with the right force
    double meanErrorN = 0.0;  ///< mean distance from the requested force over pressedS
    bool isDone = false;
    bool operator==(const Held&) const = default;
};

/// The tissues that the student named.
struct Named
{
    std::array<std::optional<terrain::Material>, kPads> saidToBe{};  ///< the latest answers
    std::size_t right = 0;
    bool operator==(const Named&) const = default;
};

/// The result of an exercise; the alternatives are in the order of Exercise.
using Practised = std::variant<Touched, Held, Named>;

/// Returns whether the exercise is complete. For pads: each has an answer, right or wrong.
[[nodiscard]] bool isDone(const Practised& practised);
/// Returns whether anything has been done.
[[nodiscard]] bool isBegun(const Practised& practised);

/// Least force of a contact that touches a point, N; less is a graze.
inline constexpr double kTouchN = 0.1;
/// Time for which the force may leave its band without ending the stretch; that time does not count as held.
inline constexpr std::chrono::milliseconds kHoldPatience{200};

/// Returns the note (session::AddNote) that records the answer for a pad.
[[nodiscard]] std::uint64_t answerNote(std::size_t pad, terrain::Material said);
/// The answer in a note.
struct Answer
{
    std::size_t pad = 0;
    terrain::Material said = terrain::Material::Enamel;
    bool operator==(const Answer&) const = default;
};
/// Returns the answer in a note; empty for other notes.
[[nodiscard]] std::optional<Answer> answerOf(std::uint64_t note);

/// Measures an exercise tick by tick, live or in a replay: the same ticks and notes give the same bits. One thread; no
/// allocation after construction.
class ExerciseMeter
{
public:
    explicit ExerciseMeter(Exercise exercise);

    /// Processes the state after a tick of `dt`. Without a device nothing is touched or held.
    void take(const servo::ServoState& state, std::chrono::microseconds dt);
    /// Processes a note of the recording. Ignores notes that are no answer.
    void noted(std::uint64_t note);

    [[nodiscard]] const Practised& practised() const { return m_practised; }

private:
    void take(const PointsToTouch& asked, const glm::dvec3& tipMm, double newtons);
    void take(const ForceToHold& asked, bool presses, double newtons, std::chrono::microseconds dt);

    Exercise m_exercise;
    Practised m_practised;
    std::chrono::microseconds m_time{0};
    // State for holding a force:
    std::chrono::microseconds m_stretch{0};
    std::chrono::microseconds m_off{0};  ///< time outside the band since the stretch last grew
    std::chrono::microseconds m_longest{0};
    std::chrono::microseconds m_held{0};
    std::chrono::microseconds m_pressed{0};
    double m_errorNS = 0.0;
};

}  // namespace core::grading
