// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/settings/FeelPreset.h"
#include "core/settings/StabilityBound.h"
#include "lessons/PresetFile.h"

/// Hardness presets in the words of the window. Ui thread.
namespace ui::text {

[[nodiscard]] QString substanceName(core::settings::Substance substance);
/// Of a number of core::settings::feelFields(), by its id: "Stiffness", and what it does.
[[nodiscard]] QString feelFieldName(const char* id);
[[nodiscard]] QString fieldHelp(const char* id);
/// "0.01 to 20 N/mm".
[[nodiscard]] QString rangeWords(const core::NumberField<core::settings::FeelPreset>& field);

/// "natural, version 3 (1a2b3c4d), changed by hand".
[[nodiscard]] QString presetWords(const lessons::PresetUsed& used);
[[nodiscard]] QString presetWords(const core::settings::FeelPreset& preset);

/// Up to where the loop holds it, or that it does not and what to change.
[[nodiscard]] QString boundWords(const core::settings::FeelPreset& preset);
/// What is wrong with a preset that was read, or what deserves a look, with file and key.
[[nodiscard]] QString faultWords(const lessons::ReadPreset& read);
[[nodiscard]] bool isHeld(const core::settings::FeelPreset& preset);

}  // namespace ui::text
