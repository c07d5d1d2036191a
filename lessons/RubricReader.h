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

/// The id of a lesson, a rubric or a criterion; a fault if it is missing or none.
[[nodiscard]] std::string takeId(JsonKeys& keys);

/// The rubric that a lesson names or holds, with nothing left to look up. Nothing, and a fault, if there is none.
/// @param value  of the lesson's key "rubric"
/// @param file   the lesson's
[[nodiscard]] std::optional<Gathered> gatherRubric(const QJsonValue& value, const QString& file, JsonFiles& files);

/// The rubric that an object says; it can mark nothing where there are grave faults.
/// @param file, path  where the object stands, for the faults
[[nodiscard]] Rubric rubricFrom(const QJsonObject& object, const QString& file, const QString& path,
                                std::vector<ValidationIssue>& faults);

/// One of those that we ship, by its id.
[[nodiscard]] core::Result<Rubric> shippedRubric(const QString& id);

}  // namespace lessons
