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

/// All measures of an attempt.
struct Measured
{
    Measures measures;
    std::optional<LesionCut> lesion;     ///< empty without a lesion
    std::optional<Deviation> deviation;  ///< empty without an ideal preparation
    std::optional<Process> process;      ///< empty without a recording
    std::optional<int> neighbourHits;    ///< times that the turning bur touched a neighbouring tooth; empty without a
                                         ///< recording
    std::optional<int> infractions;      ///< number of broken rules of the lesson; empty without a recording
    std::optional<int> aidsUsed;         ///< number of aids used, of servo::Aid; empty without a recording
    std::optional<Practised> practised;  ///< empty without an exercise and a recording
};

/// Share of the ideal's volume that must be removed before walls and floor are measured: a few holes drilled into it
/// could have perfectly upright walls and flat floors.
inline constexpr double kFormedShare = 0.5;

/// A measure with the id that rubrics use.
struct MeasureInfo
{
    std::string_view id;          ///< never changes: rubrics and results contain it
    std::string_view unit;        ///< "mm3", "mm2", "mm", "deg", "percent", "s", "N", "mm/s3", or "" for no unit
    std::string_view definition;  ///< one English sentence
    std::string_view source;
    /// Returns the value; empty if it was not measured.
    std::optional<double> (*value)(const Measured&);
    /// Returns the node where the measure is worst, for a section through it; empty if it has no place. May be null.
    std::optional<std::size_t> (*node)(const Measured&);

    [[nodiscard]] std::optional<std::size_t> nodeIn(const Measured& measured) const
    {
        return node == nullptr ? std::nullopt : node(measured);
    }
};

/// Returns all measures, those of the tooth first.
[[nodiscard]] std::span<const MeasureInfo> measureTable();

/// Returns the measure with this id; empty if there is none.
[[nodiscard]] std::optional<MeasureInfo> findMeasure(std::string_view id);

/// Returns whether a measure applies to exercises only.
[[nodiscard]] bool isOfExercise(const MeasureInfo& measure);

/// Returns whether a measure is about the process (time, force, air, broken rules, aids) and not about the tooth.
[[nodiscard]] bool isOfProcess(const MeasureInfo& measure);

}  // namespace core::grading
