// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QString>

#include "core/base/Result.h"
#include "core/settings/FeelPreset.h"
#include "lessons/PresetFile.h"

namespace lessons {

/// Where hardness presets are kept. A version that is there is never changed.
class PresetShelf
{
public:
    PresetShelf() = default;
    PresetShelf(const PresetShelf&) = delete;
    PresetShelf& operator=(const PresetShelf&) = delete;
    virtual ~PresetShelf() = default;

    /// Every version of every preset, by name, the newest version of each first; with it what cannot be read and why.
    [[nodiscard]] virtual std::vector<ReadPreset> list() const = 0;

    /// Keeps a preset and says as what. Where its version is taken by another content, or is 0, it becomes the next
    /// version of its name; what is as that version, or as the newest, is not kept again. Errors: checkPreset(), or
    /// what cannot be written.
    [[nodiscard]] virtual core::Result<core::settings::FeelPreset> save(core::settings::FeelPreset preset) = 0;
};

/// A folder with a file for each version, and what is shipped.
class PresetFolder final : public PresetShelf
{
public:
    /// @param folder  made when the first preset is saved
    explicit PresetFolder(QString folder) : m_folder(std::move(folder)) {}

    [[nodiscard]] std::vector<ReadPreset> list() const override;
    [[nodiscard]] core::Result<core::settings::FeelPreset> save(core::settings::FeelPreset preset) override;

private:
    QString m_folder;
};

/// "presets" in the user's data folder of Cusp.
[[nodiscard]] QString presetsFolder();

/// The newest version of that name, or the version that "name v2" asks for. UnknownName lists the names there are.
[[nodiscard]] core::Result<core::settings::FeelPreset> findPreset(const PresetShelf& shelf, const QString& name);

}  // namespace lessons
