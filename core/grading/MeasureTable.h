// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "core/grading/Deviation.h"
#include "core/grading/Exercise.h"
#include "core/grading/LesionCut.h"
#include "core/grading/Measures.h"
#include "core/grading/Process.h"

namespace core::grading {

/// All that was measured of an attempt.
struct Measured
{
    Measures measures;
    std::optional<LesionCut> lesion;     ///< nothing without a lesion
    std::optional<Deviation> deviation;  ///< nothing without an ideal preparation
    std::optional<Process> process;      ///< nothing without a recording
    std::optional<int> neighbourHits;    ///< times the turning bur touched a tooth beside; nothing without a recording
    std::optional<int> infractions;      ///< against the lesson's rules; nothing without a recording
    std::optional<int> aidsUsed;         ///< how many of servo::Aid; nothing without a recording
    std::optional<Practised> practised;  ///< nothing without an exercise and a recording
};

/// So much of the ideal's volume has to be gone before walls and floor are measured against it: of some holes drilled
/// into it they would be as upright and flat as can be.
inline constexpr double kFormedShare = 0.5;

/// A measure by the name that a rubric knows it by.
struct MeasureInfo
{
    std::string_view id;          ///< never changes: rubrics and results name it
    std::string_view unit;        ///< "mm3", "mm2", "mm", "deg", "percent", "s", "N", "mm/s3", or "" for a bare number
    std::string_view definition;  ///< one English sentence
    std::string_view source;
    /// The value, or nothing where it was not measured.
    std::optional<double> (*value)(const Measured&);
    /// The node where it is worst, for a section through it; nothing where it has no place. May be null.
    std::optional<std::size_t> (*node)(const Measured&);

    [[nodiscard]] std::optional<std::size_t> nodeIn(const Measured& measured) const
    {
        return node == nullptr ? std::nullopt : node(measured);
    }
};

/// Every measure there is, outcome first.
[[nodiscard]] std::span<const MeasureInfo> measureTable();

/// Nothing for an id that is none.
[[nodiscard]] std::optional<MeasureInfo> findMeasure(std::string_view id);

/// Whether a measure is about an exercise of the first minutes, and is told of nothing else.
[[nodiscard]] bool isOfExercise(const MeasureInfo& measure);

/// Whether a measure is about the way an attempt went (time, force, air, breaches, aids) and not about the tooth.
[[nodiscard]] bool isOfProcess(const MeasureInfo& measure);

}  // namespace core::grading
