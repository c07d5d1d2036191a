// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <QJsonObject>
#include <QJsonValue>
#include <QString>

#include "core/base/Result.h"
#include "lessons/JsonFiles.h"
#include "lessons/JsonKeys.h"
#include "lessons/Rubric.h"

namespace lessons {

/// Reads the id of a lesson, a rubric or a criterion; a missing or invalid one is a fault.
[[nodiscard]] std::string takeId(JsonKeys& keys);

/// Returns the rubric that a lesson names or contains, merged with all that it is based on. Empty, with a fault, if
/// there is none.
/// @param value  the lesson's key "rubric"
/// @param file   the lesson's file
[[nodiscard]] std::optional<Gathered> gatherRubric(const QJsonValue& value, const QString& file, JsonFiles& files);

/// Builds the rubric of an object. It is not usable if there are grave faults.
/// @param file, path  place of the object, for the faults
[[nodiscard]] Rubric rubricFrom(const QJsonObject& object, const QString& file, const QString& path,
                                std::vector<ValidationIssue>& faults);

/// Returns a shipped rubric by its id.
[[nodiscard]] core::Result<Rubric> shippedRubric(const QString& id);

}  // namespace lessons
