// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/base/Result.h"

namespace database {

/// Returns a username as it is stored and compared: without surrounding spaces, in lower case. OutOfRange with one
/// sentence: empty, over 64 characters, or with characters other than the letters a to z, digits and . _ - @.
[[nodiscard]] core::Result<std::string> normalUsername(const std::string& typed);

/// Returns whether a username is one that an erased person may have (Person::pseudonym()).
[[nodiscard]] bool isPseudonym(const std::string& username);

/// Returns the hash under which failed logins with this name are counted: the BLAKE2b-256 of normalUsername(), or of
/// the typed text if it is no valid username; 64 hex digits.
[[nodiscard]] std::string nameHash(const std::string& typed);
/// Returns the short form of such a hash in the audit, beginning with "name:".
[[nodiscard]] std::string nameInAudit(const std::string& hash);

/// Returns whether all characters of a name are visible: false for a line feed, for example. Joiners (U+200C, U+200D)
/// are allowed because Persian and Hindi names need them.
[[nodiscard]] bool canBeSeen(const std::string& name);

}  // namespace database
