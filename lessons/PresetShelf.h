// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QString>
#include <QStringList>

#include "core/base/Result.h"
#include "core/settings/FeelPreset.h"
#include "lessons/PresetFile.h"

namespace lessons {

/// Returns all stored and shipped presets: every version of every preset, by name, the newest version of each first;
/// then unreadable files with their faults. If a version exists with two contents, the later one counts as unreadable.
/// If the school has made a version with the number of a shipped one, the shipped one gets the next free number.
[[nodiscard]] std::vector<ReadPreset> shelved(std::vector<ReadPreset> kept);

/// Returns the default preset if none has been chosen: the newest shipped one.
/// @param all  from shelved()
[[nodiscard]] core::settings::FeelPreset usualPreset(const std::vector<ReadPreset>& all);

/// A preset with the version it is saved as.
struct Placed
{
    core::settings::FeelPreset preset;  ///< with its version and hash
    bool isThere = false;               ///< it exists already
};
/// Returns the version under which a preset is saved. If its version exists with other contents, or is 0, it becomes
/// the next version of its name. A preset that is equal to that version, or to the newest, exists already. Errors:
/// those of checkPreset(), and OutOfRange if no version number is left.
/// @param all  from shelved()
[[nodiscard]] core::Result<Placed> place(core::settings::FeelPreset preset, const std::vector<ReadPreset>& all);

/// Returns each name once, in order, without retired presets.
[[nodiscard]] QStringList namesOf(const std::vector<ReadPreset>& all);

/// Returns the newest version of that name, or the version given as "name v2". The error UnknownName lists all names.
[[nodiscard]] core::Result<core::settings::FeelPreset> findPreset(const std::vector<ReadPreset>& all,
                                                                  const QString& name);

/// A folder with a file for each version. An existing version is never changed.
class PresetFolder
{
public:
    /// @param folder  created when the first preset is saved
    explicit PresetFolder(QString folder) : m_folder(std::move(folder)) {}

    /// Returns all presets, as shelved().
    [[nodiscard]] std::vector<ReadPreset> list() const;
    /// Saves a preset as decided by place(). Errors: those of place(), and write errors.
    [[nodiscard]] core::Result<core::settings::FeelPreset> save(const core::settings::FeelPreset& preset) const;

private:
    QString m_folder;
};

/// Returns the default folder: "presets" in the user's data folder of Cusp.
[[nodiscard]] QString presetsFolder();

}  // namespace lessons
