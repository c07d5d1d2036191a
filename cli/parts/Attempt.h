// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCommandLineParser>
#include <QJsonArray>
#include <QJsonObject>

#include "core/base/Result.h"
#include "core/grading/MeasureTable.h"
#include "core/grading/RuleChecker.h"
#include "core/servo/ServoTick.h"
#include "haptics/simulated/TickTimes.h"
#include "lessons/PointLossTimeline.h"
#include "lessons/ScoreSheet.h"

/// What the commands that make or replay an attempt share: the hardness option, and its figures as JSON.
namespace cli {

/// How a tooth feels: "natural" or "typodont", a preset's file (lessons/PresetFile.h), or one that the user has kept,
/// by name. Of a file everything must be known.
[[nodiscard]] core::Status takePreset(const QString& nameOrFile, core::servo::ServoSettings& settings);

/// The preset that an attempt was made with: "natural v1 #1a2b3c4d", and whether it was changed meanwhile.
[[nodiscard]] QString presetText(const core::recording::Recording& recording);

/// caries, enamel, dentin, pulp.
[[nodiscard]] QJsonObject toJson(const core::terrain::PerMaterial& values);
/// Every measure by its id, null where it was not measured, and what no height map can tell.
[[nodiscard]] QJsonObject toJson(const core::grading::Measured& measured);
/// Each with what, when and where.
[[nodiscard]] QJsonArray toJson(const std::vector<core::grading::Infraction>& infractions);
[[nodiscard]] QJsonObject toJsonObject(const lessons::ScoreSheet& sheet);
/// p50, p99, p999 and max of tick times in microseconds.
[[nodiscard]] QJsonObject toJson(const haptics::TickTimes& times);
/// Sixteen hex digits.
[[nodiscard]] QString hashText(std::uint64_t hash);

/// The score as a person reads it, one line a criterion.
[[nodiscard]] QString toText(const lessons::ScoreSheet& sheet);
/// When the points of each criterion were lost: as JSON by the criterion's id, or one line each.
[[nodiscard]] QJsonObject toJson(const lessons::PointLossTimeline& moments);
[[nodiscard]] QString toText(const lessons::PointLossTimeline& moments);
/// One line each; empty for none.
[[nodiscard]] QString toText(const std::vector<core::grading::Infraction>& infractions);

}  // namespace cli
