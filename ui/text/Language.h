// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocale>
#include <QStringList>

namespace ui::text {

/// The language of all texts, numbers and dates of the program. Ui thread; needs an application.
class Language
{
public:
    /// Returns the codes of the available languages: "en", "de" and so on.
    [[nodiscard]] static QStringList available();
    /// Returns whether a code, with or without a country ("de_AT"), is an available language.
    [[nodiscard]] static bool isAvailable(const QString& code);
    /// Returns the language's own name, such as "Deutsch"; empty for a code that is not available.
    [[nodiscard]] static QString nameOf(const QString& code);

    /// Returns the code of the current language, one of available().
    [[nodiscard]] static QString current();
    /// Switches all windows to a language. Uses English instead of a language that is not available, but the number and
    /// date formats of `code`. If the system uses the same language with a country, the system's formats are used.
    static void choose(const QString& code);
};

}  // namespace ui::text
