// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <span>

#include <QJsonObject>

#include "core/base/Result.h"
#include "core/preparation/CapturedIdeal.h"
#include "lessons/Rubric.h"

namespace lessons {

/// Computes an ideal from recordings: replays each to its end and averages the cuts. This takes a fraction of the time
/// of the attempts; call it in any thread but the ui thread. The error names the file. Two files with the same attempt
/// are an error, because it would have double weight.
/// @param mayGoOn  called between recordings; false cancels with an error. May be empty
[[nodiscard]] core::Result<core::preparation::CapturedIdeal>
captureFrom(std::span<const std::filesystem::path> recordings, const core::preparation::Tolerances& tolerances,
            const std::function<bool()>& mayGoOn = {});

/// Returns a rubric as an object, in which the criteria for the outline ("outline_p95_mm"), depth
/// ("depth_error_p95_mm"), walls ("wall_angle_error_deg") and floor ("floor_flatness_mm") have the tolerances of a
/// captured ideal.
[[nodiscard]] QJsonObject withTolerances(QJsonObject rubric, const core::preparation::Tolerances& tolerances);

/// Returns the tolerances of these four criteria in a rubric; for missing ones the value of `otherwise`.
[[nodiscard]] core::preparation::Tolerances tolerancesOf(const Rubric& rubric,
                                                         core::preparation::Tolerances otherwise = {});

}  // namespace lessons
