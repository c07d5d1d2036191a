// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/settings/Parameters.h"

/// Texts for parameters. Ui thread.
namespace ui::console {

/// Returns a value with its unit: "2.5 N/mm", "on", "–" for an unknown value.
[[nodiscard]] QString valueWords(const core::settings::Parameter& parameter, double value);
/// Returns the range of a parameter: "0.2 to 20 N/mm", "0 (off) or 1 (on)". For a live value returns that it is one.
[[nodiscard]] QString rangeWords(const core::settings::Parameter& parameter);
/// Returns why a value was refused. Empty if it was accepted.
[[nodiscard]] QString answerWords(const core::settings::SetAnswer& answer, const QString& name,
                                  const core::settings::Parameter* parameter);
/// Returns why a value is hidden. Empty if it is not hidden.
[[nodiscard]] QString withheldWords(const core::settings::Parameter& parameter);
/// Returns whether all values of hardness and force are hidden, because two presets are being compared blind.
[[nodiscard]] bool isFeelVeiled(const core::settings::Parameters& parameters);
/// Returns the sentence that the values are hidden, and how to end the comparison.
[[nodiscard]] QString blindWords();
/// Returns the title of a group of parameters: "Force" for "force".
[[nodiscard]] QString groupName(const QString& group);

}  // namespace ui::console
