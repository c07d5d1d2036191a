// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <QString>
#include <QStringList>

#include "core/base/Result.h"
#include "core/settings/FeelPreset.h"
#include "database/Login.h"
#include "database/Repositories.h"
#include "lessons/PresetFile.h"

/// The rules for the hardness presets of a school. Each function may be called while other admins change the same
/// presets: it repeats its change up to 16 times, and then returns Busy. Thread: that of the repositories.
namespace app {

/// The presets of a school.
struct SchoolPresets
{
    std::vector<lessons::ReadPreset> all;  ///< as stored; a preset that cannot be read is among them
    QString inUse;                         ///< "name v2"; empty: the one that is shipped
    QStringList retired;                   ///< names
};
[[nodiscard]] core::Result<SchoolPresets> readPresets(const database::Repositories& school, const database::Login& who);

/// Saves a preset under the next free version of its name. Returns it with its version. Admins.
[[nodiscard]] core::Result<core::settings::FeelPreset>
savePreset(const database::Repositories& school, const database::Login& who, core::settings::FeelPreset preset);

/// Retires all versions of a preset, or offers them again. Returns false, and changes nothing, if the preset is in use
/// or too many are retired. Admins.
[[nodiscard]] core::Result<bool> retirePreset(const database::Repositories& school, const database::Login& who,
                                              const QString& name, bool isRetired);

/// The outcome of choosing the preset in use.
struct ChosenPreset
{
    bool isDone = false;
    std::string before;       ///< the preset in use until then; empty: the one that is shipped
    bool wasRetired = false;  ///< the chosen preset had been retired, and is offered again
};
/// Chooses the preset in use. Admins.
/// @param name       with its version
/// @param insteadOf  chooses it only if this one is in use; empty: in any case
[[nodiscard]] core::Result<ChosenPreset> choosePreset(const database::Repositories& school, const database::Login& who,
                                                      const QString& name, const std::optional<QString>& insteadOf);

}  // namespace app
