// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/grading/Exercise.h"
#include "core/guidance/Landmarks.h"
#include "core/settings/FeelPreset.h"
#include "core/settings/Handpiece.h"
#include "core/teeth/LesionSite.h"
#include "core/terrain/Lying.h"
#include "lessons/Aids.h"
#include "lessons/LocalText.h"
#include "lessons/Rubric.h"

namespace lessons {

/// What a student is asked to do.
enum class Task {
    RemoveDecay,  ///< take the lesion out and spare the rest
    CutIdeal,     ///< cut the ideal preparation
    TraceShape,   ///< mill the shape out of a practice block
    TouchPoints,  ///< touch points of the tooth with the drill off
    HoldForce,    ///< hold a force on the tooth with the drill off
    TellLayers    ///< tell the pads of a block of layers apart by feel, unseen
};

/// Something is practised on the tooth, and nothing is to be cut (core::grading::Exercise).
[[nodiscard]] constexpr bool isExercise(Task task)
{
    return task == Task::TouchPoints || task == Task::HoldForce || task == Task::TellLayers;
}

/// A tooth that the program makes.
struct MadeTooth
{
    int fdi = 36;
    std::uint64_t seed = 0;
    core::terrain::Lying lying;
    bool operator==(const MadeTooth&) const = default;
};
/// A practice block that the program makes: "line", "cross", ...
struct Block
{
    std::string shape;
    std::map<std::string, double> sizes;  ///< by id (core::teeth::blockFields), what differs from the usual block
    std::optional<std::uint64_t>
        seed;  ///< of the order or thickness of its layers; nothing: drawn anew for each attempt
    bool operator==(const Block&) const = default;
};
/// The scan of a tooth, a file beside the lesson.
struct Scan
{
    std::string file;  ///< absolute path
    std::string hash;  ///< SHA-256 of its content, 64 hex digits
    std::string unit;  ///< "mm", "cm", "m", "inch", "um"; empty: guessed
    std::string up;    ///< "+z" and so on; empty: guessed
    int fdi = 0;
    core::terrain::Lying lying;
    bool operator==(const Scan&) const = default;
};

/// Decay that is put into the tooth.
struct Lesion
{
    double extent = 0.5;                          ///< 0 none .. 1 deepest; where it runs, the tooth's seed says
    std::optional<core::teeth::LesionSite> site;  ///< none: what is usual for how the tooth lies
    bool operator==(const Lesion&) const = default;
};

/// A preparation that a teacher has cut (core/preparation/CapturedIdeal.h), a file beside the lesson.
struct Captured
{
    std::string file;   ///< absolute path; in a lesson that a recording took along, its name
    std::string hash;   ///< SHA-256 of its content, 64 hex digits
    std::string bytes;  ///< its content, which goes along with a recording
    bool operator==(const Captured& other) const { return hash == other.hash && bytes == other.bytes; }
};

/// The preparation that is asked for: made by a rule whose numbers have names (core::preparation), or captured.
struct Ideal
{
    std::string kind;                     ///< one of core::preparation::kindId(); empty: captured
    std::map<std::string, double> sizes;  ///< by id, what differs from what is usual for the tooth
    std::optional<Captured> captured;
    bool operator==(const Ideal&) const = default;
};

/// An attempt to learn from, a recording beside the lesson.
struct Expert
{
    std::string file;  ///< absolute path; of a lesson that a recording keeps, its name alone
    std::string hash;  ///< SHA-256 of its content, 64 hex digits
    bool operator==(const Expert&) const = default;
};

/// Zones round a shape: so much beside and below the target is forgiven in per cent, beyond it is the container.
struct LeewayZone
{
    double sidesMm = 0.3;
    double bottomMm = 0.3;
    bool operator==(const LeewayZone&) const = default;
};

/// What the program can notice during an attempt. A step that waits for it ends by itself.
enum class Reached : std::uint8_t {
    DecayFound,    ///< the bur has removed some decay
    Junction,      ///< the bur has removed some dentin
    DecayRemoved,  ///< at most 1 % of the decay is left
    Depth,         ///< the bur has reached the first value of the depth stop (depthToCutMm)
};
inline constexpr std::size_t kReachedCount = 4;

/// A step of the work, with a hint on request.
struct Step
{
    LocalText text;
    LocalText hint;
    std::optional<Reached> doneWhen = {};               ///< empty: the student goes on with the arrow
    std::optional<core::guidance::Landmark> mark = {};  ///< marked on the tooth while the step is shown
    bool operator==(const Step&) const = default;
};

/// What counts as an infraction, each with its limit; what is not set is not watched.
struct Rules
{
    bool pulpExposed = true;
    bool perforated = true;
    bool neighbourHit = false;
    std::optional<double> depthLimitMm;  ///< below the original surface
    std::optional<double> ridgeLimitMm;  ///< marginal ridge that must stay
    std::optional<double> besideMm;      ///< so far outside the ideal nothing may be cut
    std::optional<double> forceLimitN;   ///< held for 0.2 s
    std::optional<double> airLimitS;     ///< bur turning without touching anything, at a stretch
    bool operator==(const Rules&) const = default;
};

/// A lesson as its file says it, with the rubric it names read in. A plain value: what it asks is done by others.
struct Lesson
{
    std::string id;  ///< lower-case letters, digits and '-': "decay-36-moderate"
    int version = 1;
    LocalText title;
    LocalText goal;
    LocalText course;  ///< heading under which it is listed; empty: that of its task
    Task task = Task::RemoveDecay;
    std::variant<MadeTooth, Block, Scan> tooth;
    int gridSide = 150;
    std::optional<Lesion> lesion;
    std::optional<Ideal> ideal;
    std::optional<LeewayZone> leeway;
    std::optional<core::grading::PointsToTouch> touch;
    std::optional<core::grading::ForceToHold> hold;
    std::vector<std::string> burs;                           ///< allowed, by id; the first is given; none: all
    std::vector<core::settings::Handpiece> handpieces;       ///< at hand; the first is given; none: all
    std::optional<core::settings::HardnessPreset> hardness;  ///< nothing: as the school has set it
    core::settings::ToothKind kind;                          ///< which rows of the school's preset it is cut by
    bool breakOff = false;  ///< what stands too slender breaks away (core::settings::BreakOff)
    Aids aids;
    std::vector<Step> steps;
    double minutes = 0.0;  ///< 0: as long as it takes
    bool exam = false;
    Rules rules;
    Rubric rubric;
    std::optional<Expert> expert;
    LocalText notModelled;  ///< what the lesson leaves out
    std::string hash;       ///< SHA-256 over the content, with rubric, scan, expert and captured ideal; 64 hex digits
    std::string json;       ///< the whole lesson as one JSON text, rubric included: what a recording keeps
    bool operator==(const Lesson&) const = default;
};

/// What the student removes, if the program shows how much of it is left.
enum class ShownTarget : std::uint8_t { Decay, Ideal, Nothing };

/// Returns what is shown in a lesson.
/// @param lesson  null: practice without a lesson, which is on decay
[[nodiscard]] inline ShownTarget shownTarget(const Lesson* lesson)
{
    // In an exam without aids, the amount of decay that is left would show when to stop.
    if (lesson != nullptr && ((lesson->exam && lesson->aids == Aids::none()) || isExercise(lesson->task)))
        return ShownTarget::Nothing;
    // Decay in zones stays in part: what is left of all decay would not say when to stop.
    const bool isOnAllDecay = lesson == nullptr || (lesson->task == Task::RemoveDecay &&
                                                    lesson->kind.decay != core::settings::DecayKind::Graded);
    return isOnAllDecay ? ShownTarget::Decay : ShownTarget::Ideal;
}

/// Returns whether a lesson is on a block whose layers do not matter. Its material is called "block" on the screen. The
/// layers of a block of pads and of a junction matter.
[[nodiscard]] inline bool isOnPlainBlock(const Lesson& lesson)
{
    const auto* block = std::get_if<Block>(&lesson.tooth);
    return block != nullptr && lesson.task != Task::TellLayers && block->shape != "junction";
}

}  // namespace lessons
