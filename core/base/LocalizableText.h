// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace core {

/// A sentence and, separately, its values, so that a window can translate it.
struct LocalizableText
{
    std::string english;                    ///< with "%1" for the first value
    std::vector<LocalizableText> values{};  ///< texts to translate, or noted values
    bool isNoted = false;                   ///< a name, a number, a key of a file: the same in every language
};

/// Returns a name or a number that is not translated.
[[nodiscard]] LocalizableText noted(std::string text);

/// Replaces "%1" to "%9" by the values. The values themselves are not searched.
[[nodiscard]] std::string filled(const std::string& words, const std::vector<std::string>& values);

/// Returns a text in another language.
/// @param sentence  translates an English sentence or a part of one
[[nodiscard]] std::string said(const LocalizableText& words,
                               const std::function<std::string(const std::string&)>& sentence);
[[nodiscard]] std::string inEnglish(const LocalizableText& words);

}  // namespace core
