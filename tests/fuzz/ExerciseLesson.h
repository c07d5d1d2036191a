// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace fuzz {

/// Reads bytes as a lesson that stands on its own. Aborts if what was promised does not hold.
void exerciseLesson(std::string_view bytes);

/// Reads bytes as a pack of lessons, and what is in it as lessons.
void exercisePack(std::string_view bytes);

}  // namespace fuzz
