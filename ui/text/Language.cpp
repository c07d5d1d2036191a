// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/Language.h"

#include <array>
#include <memory>
#include <utility>

#include <QCoreApplication>
#include <QFile>
#include <QLibraryInfo>
#include <QTranslator>

namespace ui::text {
namespace {

constexpr std::array<std::pair<const char*, const char*>, 4> kNames{
    {{"en", "English"}, {"de", "Deutsch"}, {"es", "Español"}, {"ja", "日本語"}}};

QString languageOf(const QString& code)
{
    return code.section(u'_', 0, 0).section(u'-', 0, 0);
}

QString fileOf(const QString& language)
{
    return QStringLiteral(":/i18n/cusp_%1.qm").arg(language);
}

struct Spoken
{
    QString code;
    QList<QTranslator*> translators;
};

Spoken& spoken()
{
    static Spoken now{QStringLiteral("en"), {}};
    return now;
}

}  // namespace

QStringList Language::available()
{
    QStringList codes;
    for (const auto& [code, name] : kNames)
        if (QFile::exists(fileOf(QLatin1String(code))))
            codes << QLatin1String(code);
    return codes;
}

bool Language::isAvailable(const QString& code)
{
    return available().contains(languageOf(code));
}

QString Language::nameOf(const QString& code)
{
    if (isAvailable(code))
        for (const auto& [known, name] : kNames)
            if (languageOf(code) == QLatin1String(known))
                return QString::fromUtf8(name);
    return {};
}

QString Language::current()
{
    return spoken().code;
}

void Language::choose(const QString& code)
{
    Spoken& now = spoken();
    // The locale is set before the translators, because retranslated text contains numbers.
    const QLocale named(code);
    // The C locale writes dates with seconds, and English without a country is American. Both become British English,
    // whether the user chose the language or not.
    const bool isAnywhere = named.language() == QLocale::C || code == u"en";
    const QLocale wanted = isAnywhere ? QLocale(QLocale::English, QLocale::UnitedKingdom) : named;
    const bool isSystems = !code.contains(u'_') && QLocale::system().language() == wanted.language();
    QLocale::setDefault(isSystems ? QLocale::system() : wanted);
    for (QTranslator* before : std::exchange(now.translators, {}))
        delete before;  // the destructor removes it from the application
    now.code = isAvailable(code) ? languageOf(code) : QStringLiteral("en");
    const auto add = [&](const QString& file, const QString& folder) {
        auto translator = std::make_unique<QTranslator>(QCoreApplication::instance());
        if (!translator->load(file, folder))
            return;
        QCoreApplication::installTranslator(translator.get());
        now.translators << translator.release();
    };
    add(fileOf(now.code), {});  // for the plurals of English
    add(QStringLiteral("qtbase_") + now.code, QLibraryInfo::path(QLibraryInfo::TranslationsPath));
}

}  // namespace ui::text
