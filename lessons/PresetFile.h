// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <QByteArray>
#include <QJsonObject>
#include <QString>

#include "core/recording/Recording.h"
#include "core/settings/FeelPreset.h"
#include "lessons/ValidationIssue.h"

/// Hardness presets as files, *.cusppreset. A file is one JSON object with "format", "kind", "name", "version",
/// "notes", and the numbers of core::settings::feelFields() under their ids. The part of an id before a point is the
/// key of an object. Format 2 added the share of flat ends and the full load. A preset without them is written in
/// format 1, so that its hash does not change.
namespace lessons {

inline constexpr const char* kPresetSuffix = "cusppreset";
inline constexpr int kPresetFormat = 2;
inline constexpr qint64 kLargestPresetBytes = 64 * 1024;
inline constexpr qsizetype kLongestPresetName = 60;
inline constexpr qsizetype kLongestPresetNotes = 2000;
inline constexpr int kNewestPresetVersion = 1'000'000;

/// A preset as read from its file, with its faults.
struct ReadPreset
{
    QString file;
    std::optional<core::settings::FeelPreset> preset;  ///< empty if a fault is grave
    std::vector<ValidationIssue> faults;
    /// The contents of the file, if it only exceeds the stability bound and has no other fault.
    std::optional<core::settings::FeelPreset> beyondBound{};
    /// Ids of numbers that are missing in the file and have the shipped values: "pulp.threshold_n", or "pulp" if the
    /// whole object is missing.
    QStringList leftOut{};
    bool isRetired = false;  ///< by the school: no longer offered, but attempts may still refer to it
};

/// Reads a preset and its hash. Missing numbers have the shipped values, except flat_end_share and full_load_n, which
/// then have no effect. "caries" applies to soft and firm caries alike. A file without a name has the file's name. A
/// preset that would be unstable in a light hand is refused with the stability bound (core::settings::checkStability).
/// Unknown keys give warnings.
/// @param file  its name in the faults
[[nodiscard]] ReadPreset readPresetText(const QByteArray& json, const QString& file);
[[nodiscard]] ReadPreset readPreset(const QString& file);

/// Returns a warning that lists the numbers missing in the file, which may be intended. Empty if none are missing.
[[nodiscard]] std::optional<ValidationIssue> leftOutFault(const ReadPreset& read);

/// Checks that a preset may be saved: its name is visible, its numbers are in their ranges and within the stability
/// bound.
[[nodiscard]] core::Status checkPreset(const core::settings::FeelPreset& preset);

[[nodiscard]] QJsonObject toJson(const core::settings::FeelPreset& preset);
/// Returns the hash of toJson(), including name, version and notes: SHA-256, 64 hex digits.
[[nodiscard]] std::string hashOf(const core::settings::FeelPreset& preset);
/// Returns the preset with its hash.
[[nodiscard]] core::settings::FeelPreset hashed(core::settings::FeelPreset preset);
/// Writes a preset to a file. If that fails, an existing file is unchanged.
[[nodiscard]] core::Status writePreset(const QString& file, const core::settings::FeelPreset& preset);

/// Returns the shipped presets, the default first: "natural" version 2, then version 1, in which the shape of a bur's
/// end and the load have no effect.
[[nodiscard]] const std::vector<core::settings::FeelPreset>& shippedPresets();

/// The preset of an attempt, for display and storage.
struct PresetUsed
{
    QString name;
    int version = 0;         ///< 0: none, for a lesson's own preset or an older Cusp
    QString hash;            ///< first eight hex digits; empty: none
    bool isChanged = false;  ///< by hand, during the attempt
    bool operator==(const PresetUsed&) const = default;
};
/// Returns the preset of an attempt.
/// @param label  label of the preset, from core::settings::labelOf()
[[nodiscard]] PresetUsed presetUsed(const std::string& label, bool isChanged);
[[nodiscard]] PresetUsed presetUsed(const core::recording::Recording& recording);

}  // namespace lessons
