// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace fuzz {

/// Reads the bytes as a device path and walks what comes out. Aborts when a promise of the reader is broken: times that
/// do not rise, a position that is not finite or far away, an error without a sentence.
void exercisePath(std::string_view bytes);

}  // namespace fuzz
