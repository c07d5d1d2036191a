// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/grading/RuleChecker.h"

namespace ui::replay {

/// A stroke, in seconds since the attempt began.
struct Stroke
{
    double fromS = 0.0;
    double toS = 0.0;
    double doneS = 0.0;  ///< the moment to look at what it has left: all of it is shown
    std::uint8_t burIndex = 0;
    bool operator==(const Stroke&) const = default;
};

/// What happened beside the strokes.
struct Mark
{
    enum class Kind : std::uint8_t {
        Undo,
        Redo,
        StartAgain,
        Bur,        ///< value: index of the bur taken
        Handpiece,  ///< name: of the handpiece taken
        Aids,       ///< value: those in use from now on, bits of core::servo::Aid
        Note,       ///< value: its code
        Home,       ///< the hand was led home
        Resumed,    ///< the attempt was taken up again
        Touched     ///< value: index of the point of an exercise that was touched, for the first time
    };
    Kind kind = Kind::Undo;
    double atS = 0.0;
    std::uint64_t value = 0;
    std::string name = {};
    bool operator==(const Mark&) const = default;
};

/// A point that was to be touched, of an exercise.
struct TouchPoint
{
    glm::dvec2 placeMm{0.0};  ///< tooth frame, seen from above
    double reachMm = 0.6;
    std::optional<double> touchedAtS;
    bool operator==(const TouchPoint&) const = default;
};

/// What somebody has said of a moment of the attempt.
struct Remark
{
    double atS = 0.0;
    std::optional<glm::dvec3> placeMm;  ///< on the tooth, in its frame
    std::string author;                 ///< full name
    std::string words;
    bool operator==(const Remark&) const = default;
};

/// While its student was elsewhere: no time of the attempt.
struct Rest
{
    double fromS = 0.0;
    double toS = 0.0;
    bool operator==(const Rest&) const = default;
};

/// How an attempt went, as far as it is known: what is drawn on a time line. All in order of time.
struct AttemptTimeline
{
    double lengthS = 0.0;
    double readyS = 0.0;  ///< up to here it is known, and can be shown
    std::vector<Stroke> strokes;
    std::vector<Mark> marks;
    std::vector<core::grading::Infraction> infractions;
    std::vector<TouchPoint> points;
    std::vector<Remark> remarks;
    std::vector<Rest> rests;

    /// The first end of a stroke, step through the history or touched point after a moment; the end of all when there
    /// is none.
    [[nodiscard]] double stepAfter(double seconds) const;
    /// The last such before a moment; the beginning when there is none.
    [[nodiscard]] double stepBefore(double seconds) const;
    /// What is to be read at a moment: from a little before the one that was meant until it has been read.
    [[nodiscard]] std::vector<Remark> remarksAt(double seconds) const;
};

/// What leads to an infraction or to what somebody remarked is seen from so long before it on, s.
inline constexpr double kLeadUpS = 1.0;
/// The replay of a moment at which points were lost begins so long before it, s.
inline constexpr double kBeforeMomentS = 2.0;
inline constexpr double kReadS = 4.0;  ///< a remark stays in sight so long after its moment

}  // namespace ui::replay
