// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace lessons {

/// One text in several languages: language code ("en", "de", "es", "ja") to UTF-8.
using LocalText = std::map<std::string, std::string>;

/// Returns the text in this language; otherwise in English, otherwise in the first language. Empty if there is no text.
/// A code with a country ("de_AT") matches its language.
[[nodiscard]] const std::string& inLanguage(const LocalText& text, std::string_view language);

}  // namespace lessons
