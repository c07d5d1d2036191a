// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/base/Result.h"

namespace database {

/// A username as it is kept and compared: without spaces around it, in small letters. OutOfRange with a sentence:
/// empty, over 64 characters, or with others than the letters a to z, digits and . _ - @.
[[nodiscard]] core::Result<std::string> normalUsername(const std::string& typed);

/// Whether a name holds no characters that nothing is shown for, such as a line feed. Joiners (U+200C, U+200D) are
/// allowed: Persian and Hindi names are written with them.
[[nodiscard]] bool canBeSeen(const std::string& name);

}  // namespace database
