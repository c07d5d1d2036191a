// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

#include "core/base/Result.h"
#include "lessons/ScoreSheet.h"

namespace lessons {

/// One line of UTF-8 JSON, {"format": 1, "rubric": ..., "criteria": [...], "total": ..., "pass_mark": ...}. Numbers
/// come back bit for bit. What was measured must be finite (a NaN has no JSON): write a sheet made from real measures.
[[nodiscard]] QByteArray toJson(const ScoreSheet& sheet);

/// Reads what toJson wrote. Refused, each with a sentence that names the key: text that is not JSON, a newer format,
/// a missing key or a wrong type, and a sheet whose points do not follow from its own numbers.
[[nodiscard]] core::Result<ScoreSheet> scoreSheetFromJson(const QByteArray& json);

}  // namespace lessons
