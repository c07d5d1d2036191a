// SPDX-License-Identifier: GPL-3.0-or-later
#include "lessons/LocalText.h"

namespace lessons {

const std::string& inLanguage(const LocalText& text, std::string_view language)
{
    static const std::string kNothing;
    for (const std::string_view code : {language, language.substr(0, language.find_first_of("_-")), {"en"}})
        if (const auto found = text.find(std::string(code)); found != text.end())
            return found->second;
    return text.empty() ? kNothing : text.begin()->second;
}

}  // namespace lessons
