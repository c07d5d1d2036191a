// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/base/Result.h"

namespace database {

/// Returns a username as it is stored and compared: without surrounding spaces, in lower case. OutOfRange with one
/// sentence: empty, over 64 characters, or with characters other than the letters a to z, digits and . _ - @.
[[nodiscard]] core::Result<std::string> normalUsername(const std::string& typed);

/// Returns whether a name has no invisible characters, such as a line feed. Joiners (U+200C, U+200D) are allowed:
/// Persian and Hindi names need them.
[[nodiscard]] bool canBeSeen(const std::string& name);

}  // namespace database
