// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace core {

/// A sentence, and apart from it what it speaks of, so that a window can say it in its own language.
struct LocalizableText
{
    std::string english;                    ///< with "%1" for the first of the values
    std::vector<LocalizableText> values{};  ///< words again, or what was noted
    bool isNoted = false;                   ///< a name, a number, a key of a file: the same in every language
};

/// A name or a number.
[[nodiscard]] LocalizableText noted(std::string text);

/// Puts each value where "%1" to "%9" call for it; what a value itself contains is not looked at.
[[nodiscard]] std::string filled(const std::string& words, const std::vector<std::string>& values);

/// @param sentence  what an English sentence or part of one is in the language
[[nodiscard]] std::string said(const LocalizableText& words,
                               const std::function<std::string(const std::string&)>& sentence);
[[nodiscard]] std::string inEnglish(const LocalizableText& words);

}  // namespace core
