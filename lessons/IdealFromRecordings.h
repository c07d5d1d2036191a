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

/// The ideal that recordings show: each is replayed to its end, and what most of them cut is averaged. Replaying takes
/// a fraction of the time that the attempts took; any thread that may wait. An error names the file; one attempt twice,
/// by whatever names, is an error, since it would outweigh the others.
/// @param mayGoOn  asked between recordings; false ends it with an error. May be empty
[[nodiscard]] core::Result<core::preparation::CapturedIdeal>
captureFrom(std::span<const std::filesystem::path> recordings, const core::preparation::Tolerances& tolerances,
            const std::function<bool()>& mayGoOn = {});

/// A rubric as an object, with a captured ideal's tolerances in the criteria that they are about: the outline
/// ("outline_p95_mm"), depth ("depth_error_p95_mm"), walls ("wall_angle_error_deg") and floor ("floor_flatness_mm").
[[nodiscard]] QJsonObject withTolerances(QJsonObject rubric, const core::preparation::Tolerances& tolerances);

/// What a rubric tolerates of these four; what it has no criterion for is as it was in `otherwise`.
[[nodiscard]] core::preparation::Tolerances tolerancesOf(const Rubric& rubric,
                                                         core::preparation::Tolerances otherwise = {});

}  // namespace lessons
