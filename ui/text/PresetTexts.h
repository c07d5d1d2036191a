// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/settings/FeelPreset.h"
#include "core/settings/StabilityBound.h"
#include "lessons/PresetFile.h"

/// Texts about hardness presets. Ui thread.
namespace ui::text {

[[nodiscard]] QString substanceName(core::settings::Substance substance);
/// Return the name and the explanation of a number of core::settings::feelFields(), by its id.
[[nodiscard]] QString feelFieldName(const char* id);
[[nodiscard]] QString fieldHelp(const char* id);
/// Returns a range such as "0.01 to 20 N/mm".
[[nodiscard]] QString rangeWords(const core::NumberField<core::settings::FeelPreset>& field);

/// Returns a preset with its version, such as "natural, version 3 (1a2b3c4d), changed by hand".
[[nodiscard]] QString presetWords(const lessons::PresetUsed& used);
[[nodiscard]] QString presetWords(const core::settings::FeelPreset& preset);

/// Returns the highest stiffness that the servo loop keeps stable. For an unstable preset, returns what to change.
[[nodiscard]] QString boundWords(const core::settings::FeelPreset& preset);
/// Returns the errors and warnings of a preset file, with file and key.
[[nodiscard]] QString faultWords(const lessons::ReadPreset& read);
[[nodiscard]] bool isHeld(const core::settings::FeelPreset& preset);

}  // namespace ui::text
