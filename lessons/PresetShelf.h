// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QString>
#include <QStringList>

#include "core/base/Result.h"
#include "core/settings/FeelPreset.h"
#include "lessons/PresetFile.h"

namespace lessons {

/// What is kept, and what is shipped: every version of every preset, by name, the newest version of each first; then
/// what cannot be read, and why. The same version with two contents: the later one cannot be read. A version that Cusp
/// ships later than the first gives way to one that the school made before, and takes the next free number.
[[nodiscard]] std::vector<ReadPreset> shelved(std::vector<ReadPreset> kept);

/// Returns the preset that is in use where nobody has chosen one: the newest that is shipped.
/// @param all  as shelved() puts them
[[nodiscard]] core::settings::FeelPreset usualPreset(const std::vector<ReadPreset>& all);

/// As what a preset is to be kept.
struct Placed
{
    core::settings::FeelPreset preset;  ///< with its version and hash
    bool isThere = false;               ///< nothing is left to do
};
/// Where its version is taken by another content, or is 0, it becomes the next version of its name; what is as that
/// version, or as the newest, is there already. Errors: checkPreset(), and OutOfRange where no version is left.
/// @param all  as shelved() puts them
[[nodiscard]] core::Result<Placed> place(core::settings::FeelPreset preset, const std::vector<ReadPreset>& all);

/// Each name once, in their order; not those that are retired.
[[nodiscard]] QStringList namesOf(const std::vector<ReadPreset>& all);

/// The newest version of that name, or the version that "name v2" asks for. UnknownName lists the names there are.
[[nodiscard]] core::Result<core::settings::FeelPreset> findPreset(const std::vector<ReadPreset>& all,
                                                                  const QString& name);

/// A folder with a file for each version. A version that is there is never changed.
class PresetFolder
{
public:
    /// @param folder  made when the first preset is saved
    explicit PresetFolder(QString folder) : m_folder(std::move(folder)) {}

    /// As shelved().
    [[nodiscard]] std::vector<ReadPreset> list() const;
    /// Keeps it as place() says. Errors also: what cannot be written.
    [[nodiscard]] core::Result<core::settings::FeelPreset> save(const core::settings::FeelPreset& preset) const;

private:
    QString m_folder;
};

/// "presets" in the user's data folder of Cusp.
[[nodiscard]] QString presetsFolder();

}  // namespace lessons
