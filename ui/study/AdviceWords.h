// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "lessons/Advice.h"

namespace ui::study {

/// Returns one or two sentences that tell a student what went wrong and what to do next time, in the current language.
[[nodiscard]] QString adviceWords(const ::lessons::Advice& advice, const ::lessons::Criterion& criterion);

}  // namespace ui::study
