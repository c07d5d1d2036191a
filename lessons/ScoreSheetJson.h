// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

#include "lessons/ScoreSheet.h"

namespace lessons {

/// One line of UTF-8 JSON, {"format": 1, "rubric": ..., "criteria": [...], "total": ..., "pass_mark": ...}. Numbers
/// come back bit for bit. What was measured must be finite (a NaN has no JSON): write a sheet made from real measures.
[[nodiscard]] QByteArray toJson(const ScoreSheet& sheet);

}  // namespace lessons
