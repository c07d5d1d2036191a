// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/settings/Parameters.h"

/// Parameters in the words of the window. Ui thread.
namespace ui::console {

/// "2.5 N/mm", "on", "–" where there is nothing to read.
[[nodiscard]] QString valueWords(const core::settings::Parameter& parameter, double value);
/// "0.2 to 20 N/mm", "0 (off) or 1 (on)"; of a live value that it is one.
[[nodiscard]] QString rangeWords(const core::settings::Parameter& parameter);
/// Why a value was not taken; empty if it was.
[[nodiscard]] QString answerWords(const core::settings::SetAnswer& answer, const QString& name,
                                  const core::settings::Parameter* parameter);
/// Why a value is kept from view; empty: it is not.
[[nodiscard]] QString withheldWords(const core::settings::Parameter& parameter);
/// Whether all that is felt is kept from view: two presets are being compared blind.
[[nodiscard]] bool isFeelVeiled(const core::settings::Parameters& parameters);
/// The sentence that says so, and what ends it.
[[nodiscard]] QString blindWords();
/// What stands before the first point: "force" is "Force".
[[nodiscard]] QString groupName(const QString& group);

}  // namespace ui::console
