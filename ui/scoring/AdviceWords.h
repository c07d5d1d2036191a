// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "lessons/Advice.h"

namespace ui::scoring {

/// Returns what went wrong and what to do next time, as one or two sentences in the current language.
[[nodiscard]] QString adviceWords(const ::lessons::Advice& advice, const ::lessons::Criterion& criterion);

}  // namespace ui::scoring
