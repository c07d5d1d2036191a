// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/base/Result.h"

namespace database {

/// A user's name as it is kept and compared: without spaces around it, small letters. OutOfRange with a sentence:
/// empty, over 64 characters, or with others than letters, digits, ". _ - @".
[[nodiscard]] core::Result<std::string> normalUsername(const std::string& typed);

/// The same of somebody who is entered: also OutOfRange with letters that cannot be seen, and with a word in several
/// scripts, which would look like another's name. Who has such a name from before keeps it.
[[nodiscard]] core::Result<std::string> newUsername(const std::string& typed);

/// Whether each character of somebody's or something's name can be seen, those beyond the first plane of Unicode
/// included: rare kanji stand there. A mark stands on a letter. Joiners (U+200C, U+200D) are allowed between letters of
/// scripts that are written with them, as in Persian and Hindi names.
[[nodiscard]] bool canBeSeen(const std::string& name);

}  // namespace database
