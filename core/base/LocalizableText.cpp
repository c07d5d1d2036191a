// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/LocalizableText.h"

#include <cstddef>
#include <utility>

namespace core {

LocalizableText noted(std::string text)
{
    return {std::move(text), {}, true};
}

std::string filled(const std::string& words, const std::vector<std::string>& values)
{
    std::string whole;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const char next = words[i] == '%' && i + 1 < words.size() ? words[i + 1] : '0';
        if (next >= '1' && next <= '9' && static_cast<std::size_t>(next - '1') < values.size()) {
            whole += values[static_cast<std::size_t>(next - '1')];
            ++i;
        } else {
            whole += words[i];
        }
    }
    return whole;
}

std::string said(const LocalizableText& words, const std::function<std::string(const std::string&)>& sentence)
{
    if (words.isNoted)
        return words.english;
    std::vector<std::string> values;
    for (const LocalizableText& value : words.values)
        values.push_back(said(value, sentence));
    return filled(sentence(words.english), values);
}

std::string inEnglish(const LocalizableText& words)
{
    return said(words, [](const std::string& english) { return english; });
}

}  // namespace core
