// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include <QByteArray>

#include "lessons/PresetFile.h"
#include "lessons/Rubric.h"
#include "lessons/ScoreSheet.h"

namespace lessons {

/// Returns a score sheet as one line of UTF-8 JSON, {"format": 2, "rubric": ..., "criteria": [...], "total_tenths":
/// ..., "pass_mark_tenths": ...}. Numbers are read back bit for bit. Measured values must be finite (JSON has no NaN).
[[nodiscard]] QByteArray toJson(const ScoreSheet& sheet, const std::optional<PresetUsed>& preset = {});

/// Reads a score sheet from such JSON; empty if the text is not a complete sheet.
[[nodiscard]] std::optional<ScoreSheet> sheetIn(std::string_view json);

/// Reads the measured values of such a score sheet, by the ids of measures; empty if the text is no sheet. With them an
/// attempt can be graded again by a rubric with the same measures.
[[nodiscard]] Values measuredIn(std::string_view json);

}  // namespace lessons
