// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include <QByteArray>

#include "lessons/PresetFile.h"
#include "lessons/Rubric.h"
#include "lessons/ScoreSheet.h"

namespace lessons {

/// One line of UTF-8 JSON, {"format": 2, "rubric": ..., "criteria": [...], "total_tenths": ..., "pass_mark_tenths":
/// ...}. Numbers come back bit for bit. What was measured must be finite (a NaN has no JSON): write a sheet made from
/// real measures.
[[nodiscard]] QByteArray toJson(const ScoreSheet& sheet, const std::optional<PresetUsed>& preset = {});

/// The sheet that was written so; nothing of what is none, or has not all that a sheet says.
[[nodiscard]] std::optional<ScoreSheet> sheetIn(std::string_view json);

/// What a score sheet that was written so says was measured, by the ids of measures; nothing of what is no score sheet.
/// Enough to mark the attempt again by a rubric with the same measures.
[[nodiscard]] Values measuredIn(std::string_view json);

}  // namespace lessons
