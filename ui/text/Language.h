// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocale>
#include <QStringList>

namespace ui::text {

/// The language of all words, numbers and dates of the program. Ui thread, with an application.
class Language
{
public:
    /// Codes of the languages that this build speaks: "en", "de" and so on.
    [[nodiscard]] static QStringList available();
    /// Whether a code, with or without a country ("de_AT"), means one of them.
    [[nodiscard]] static bool isAvailable(const QString& code);
    /// What a language is called by those who retranslateUi it: "Deutsch". Empty for a code that is not available.
    [[nodiscard]] static QString nameOf(const QString& code);

    /// One of available(): the one that was chosen last.
    [[nodiscard]] static QString current();
    /// From now on every window speaks this one; what is not available becomes English, with the numbers and dates of
    /// `code`. Where the system has the same language with a country, its dates and numbers are taken.
    static void choose(const QString& code);
};

}  // namespace ui::text
