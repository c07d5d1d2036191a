// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/base/Result.h"

namespace database {

/// Returns a username as it is stored and compared: without surrounding spaces, in lower case. OutOfRange with one
/// sentence: empty, over 64 characters, or with characters other than the letters a to z, digits and . _ - @.
[[nodiscard]] core::Result<std::string> normalUsername(const std::string& typed);

/// The hash under which failed logins with this name are counted: BLAKE2b-256 of normalUsername(), or of the text as it
/// was typed if that is not a username; 64 hex digits.
[[nodiscard]] std::string nameHash(const std::string& typed);
/// How the audit shortens such a hash, behind "name:".
[[nodiscard]] std::string nameInAudit(const std::string& hash);

/// Whether a name holds no characters that nothing is shown for, such as a line feed. Joiners (U+200C, U+200D) are
/// allowed: Persian and Hindi names are written with them.
[[nodiscard]] bool canBeSeen(const std::string& name);

}  // namespace database
