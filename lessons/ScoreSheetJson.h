// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include <QByteArray>

#include "lessons/PresetFile.h"
#include "lessons/Rubric.h"
#include "lessons/ScoreSheet.h"

namespace lessons {

/// One line of UTF-8 JSON, {"format": 1, "rubric": ..., "criteria": [...], "total": ..., "pass_mark": ...}. Numbers
/// come back bit for bit. What was measured must be finite (a NaN has no JSON): write a sheet made from real measures.
[[nodiscard]] QByteArray toJson(const ScoreSheet& sheet, const std::optional<PresetUsed>& preset = {});

/// What a score sheet that was written so says was measured, by the ids of measures; nothing of what is no score sheet.
/// Enough to mark the attempt again by a rubric with the same measures.
[[nodiscard]] Values measuredIn(std::string_view json);

}  // namespace lessons
