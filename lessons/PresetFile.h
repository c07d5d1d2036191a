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

/// Hardness presets as files, *.cusppreset: one JSON object with "format", "kind", "name", "version", "notes", and the
/// numbers of core::settings::feelFields() under their ids, the part before a point being an object's key. Format 2
/// brought the share of flat ends and the full load. A preset without them is written in format 1, so that its hash
/// stays what it was.
namespace lessons {

inline constexpr const char* kPresetSuffix = "cusppreset";
inline constexpr int kPresetFormat = 2;
inline constexpr qint64 kLargestPresetBytes = 64 * 1024;
inline constexpr qsizetype kLongestPresetName = 60;
inline constexpr qsizetype kLongestPresetNotes = 2000;
inline constexpr int kNewestPresetVersion = 1'000'000;

/// A preset as its file says it, and what is wrong with it.
struct ReadPreset
{
    QString file;
    std::optional<core::settings::FeelPreset> preset;  ///< nothing where a fault is grave
    std::vector<ValidationIssue> faults;
    /// Sound, but for the bound: what is in the file all the same.
    std::optional<core::settings::FeelPreset> beyondBound{};
    /// Numbers that the file does not say, so that they are as shipped: "pulp.threshold_n", or "pulp" where it says
    /// nothing of it.
    QStringList leftOut{};
    bool isRetired = false;  ///< by the school: attempts go on naming it, and nobody is offered it
};

/// Number by number and with its hash. What is left out is as shipped, but for flat_end_share and full_load_n, which
/// then make no difference; "caries" stands for soft and firm alike, and a
/// file without a name is called as it is called itself. A preset that no light hand is held with is refused with the
/// bound (core::settings::checkStability). Unknown keys warn.
/// @param file  what the faults call it
[[nodiscard]] ReadPreset readPresetText(const QByteArray& json, const QString& file);
[[nodiscard]] ReadPreset readPreset(const QString& file);

/// A warning that names what the file leaves out, which may be meant so; nothing where it says all.
[[nodiscard]] std::optional<ValidationIssue> leftOutFault(const ReadPreset& read);

/// Whether it may be kept: a name that can be seen, numbers in their ranges, and within the bound.
[[nodiscard]] core::Status checkPreset(const core::settings::FeelPreset& preset);

[[nodiscard]] QJsonObject toJson(const core::settings::FeelPreset& preset);
/// Of what toJson() holds, so of name, version and notes as well: SHA-256, 64 hex digits.
[[nodiscard]] std::string hashOf(const core::settings::FeelPreset& preset);
/// The same with its hash filled in.
[[nodiscard]] core::settings::FeelPreset hashed(core::settings::FeelPreset preset);
/// An older file survives any failure.
[[nodiscard]] core::Status writePreset(const QString& file, const core::settings::FeelPreset& preset);

/// What Cusp brings along, the one to use first: "natural", version 2, and version 1, in which a bur's end and the load
/// made no difference.
[[nodiscard]] const std::vector<core::settings::FeelPreset>& shippedPresets();

/// The preset that an attempt was made with, as it is told and kept.
struct PresetUsed
{
    QString name;
    int version = 0;         ///< 0: it has none, as one that a lesson gives, or of an older Cusp
    QString hash;            ///< first eight hex digits; empty: none
    bool isChanged = false;  ///< by hand, while the attempt went on
    bool operator==(const PresetUsed&) const = default;
};
/// @param label  of core::settings::HardnessPreset, as core::settings::labelOf() makes it
[[nodiscard]] PresetUsed presetUsed(const std::string& label, bool isChanged);
[[nodiscard]] PresetUsed presetUsed(const core::recording::Recording& recording);

}  // namespace lessons
