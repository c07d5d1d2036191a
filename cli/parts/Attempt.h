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

/// Functions for the commands that make or replay an attempt: the hardness option, and results as JSON.
namespace cli {

/// Applies a hardness preset: "natural" or "typodont", the file of a preset (lessons/PresetFile.h), or the name of a
/// saved one. A file with faults, even with missing numbers, is an error.
[[nodiscard]] core::Status takePreset(const QString& nameOrFile, core::servo::ServoSettings& settings);

/// Returns the label of an attempt's preset, "natural v1 #1a2b3c4d", and whether it was changed during the attempt.
[[nodiscard]] QString presetText(const core::recording::Recording& recording);

/// Returns the values of caries, enamel, dentin and pulp.
[[nodiscard]] QJsonObject toJson(const core::terrain::PerMaterial& values);
/// Returns every measure by its id (null: not measured), and the list of aspects that a height map cannot represent.
[[nodiscard]] QJsonObject toJson(const core::grading::Measured& measured);
/// Returns all rule violations, each with its rule, time and place.
[[nodiscard]] QJsonArray toJson(const std::vector<core::grading::Infraction>& infractions);
[[nodiscard]] QJsonObject toJsonObject(const lessons::ScoreSheet& sheet);
/// Returns p50, p99, p999 and max of tick times in microseconds.
[[nodiscard]] QJsonObject toJson(const haptics::TickTimes& times);
/// Returns a hash as sixteen hex digits.
[[nodiscard]] QString hashText(std::uint64_t hash);

/// Returns the score as text, one line per criterion.
[[nodiscard]] QString toText(const lessons::ScoreSheet& sheet);
/// Return the moments at which the points of each criterion were lost: as JSON by the criterion's id, or as one line
/// each.
[[nodiscard]] QJsonObject toJson(const lessons::PointLossTimeline& moments);
[[nodiscard]] QString toText(const lessons::PointLossTimeline& moments);
/// Returns one line per rule violation; empty if there are none.
[[nodiscard]] QString toText(const std::vector<core::grading::Infraction>& infractions);

}  // namespace cli
