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

/// A stroke, in seconds from the start of the attempt.
struct Stroke
{
    double fromS = 0.0;
    double toS = 0.0;
    double doneS = 0.0;  ///< moment at which its whole cut is visible
    std::uint8_t burIndex = 0;
    bool operator==(const Stroke&) const = default;
};

/// An event between the strokes.
struct Mark
{
    enum class Kind : std::uint8_t {
        Undo,
        Redo,
        StartAgain,
        Bur,        ///< value: index of the new bur
        Handpiece,  ///< name: the new handpiece
        Aids,       ///< value: the aids in use from now on, bits of core::servo::Aid
        Note,       ///< value: its code
        Home,       ///< the device moved the hand to its start
        Resumed,    ///< the attempt was resumed
        Touched     ///< value: index of a point of an exercise, touched for the first time
    };
    Kind kind = Kind::Undo;
    double atS = 0.0;
    std::uint64_t value = 0;
    std::string name = {};
    bool operator==(const Mark&) const = default;
};

/// A point that an exercise asks to touch.
struct TouchPoint
{
    glm::dvec2 placeMm{0.0};  ///< tooth frame, seen from above
    double reachMm = 0.6;
    std::optional<double> touchedAtS;
    bool operator==(const TouchPoint&) const = default;
};

/// A comment pinned to a moment of the attempt.
struct Remark
{
    double atS = 0.0;
    std::optional<glm::dvec3> placeMm;  ///< tooth frame
    std::string author;                 ///< full name
    std::string words;
    bool operator==(const Remark&) const = default;
};

/// An idle interval, which does not count as time of the attempt.
struct Rest
{
    double fromS = 0.0;
    double toS = 0.0;
    bool operator==(const Rest&) const = default;
};

/// The known part of an attempt, for a time line. All lists are sorted by time.
struct AttemptTimeline
{
    double lengthS = 0.0;
    double readyS = 0.0;  ///< the attempt is known, and can be shown, up to this moment
    std::vector<Stroke> strokes;
    std::vector<Mark> marks;
    std::vector<core::grading::Infraction> infractions;
    std::vector<TouchPoint> points;
    std::vector<Remark> remarks;
    std::vector<Rest> rests;

    /// Returns the first moment after this one at which a stroke, an undo step or the touch of a point ends. Returns
    /// the end of the attempt if there is none.
    [[nodiscard]] double stepAfter(double seconds) const;
    /// Returns the last such moment before this one, or 0 if there is none.
    [[nodiscard]] double stepBefore(double seconds) const;
    /// Returns the comments to show at a moment. A comment is shown from kLeadUpS before its own moment until kReadS
    /// after it.
    [[nodiscard]] std::vector<Remark> remarksAt(double seconds) const;
};

/// Lead time with which a rule violation or a comment is replayed, s.
inline constexpr double kLeadUpS = 1.0;
/// Lead time with which a moment of lost points is replayed, s.
inline constexpr double kBeforeMomentS = 2.0;
inline constexpr double kReadS = 4.0;  ///< time for which a comment stays visible after its moment

}  // namespace ui::replay
