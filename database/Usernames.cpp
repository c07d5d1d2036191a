// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/Usernames.h"

#include <algorithm>
#include <cassert>

#include <QList>
#include <QRegularExpression>
#include <QString>

#include "database/Passwords.h"

namespace database {

core::Result<std::string> normalUsername(const std::string& typed)
{
    constexpr qsizetype kLongest = 64;
    // A Japanese keyboard may type full-width Latin letters.
    const QString name = QString::fromStdString(typed).normalized(QString::NormalizationForm_KC).trimmed().toLower();
    const auto isFit = [](QChar c) {
        return (c >= u'a' && c <= u'z') || (c >= u'0' && c <= u'9') || QStringView(u"._-@").contains(c);
    };
    if (name.isEmpty())
        return core::unexpected(core::ErrorCode::OutOfRange, "the username is empty; give one");
    if (name.size() > kLongest)
        return core::unexpected(core::ErrorCode::OutOfRange,
                                "the username is longer than " + std::to_string(kLongest) + " characters; shorten it");
    if (!std::all_of(name.begin(), name.end(), isFit))
        return core::unexpected(core::ErrorCode::OutOfRange,
                                "the username \"" + name.toStdString() +
                                    "\" has other characters than the letters a to z, digits and . _ - @; correct it");
    return name.toStdString();
}

bool isPseudonym(const std::string& username)
{
    static const QRegularExpression kPseudonym(QStringLiteral("^erased-[0-9a-f]{12}$"));
    return kPseudonym.match(QString::fromStdString(username)).hasMatch();
}

std::string nameHash(const std::string& typed)
{
    const auto name = normalUsername(typed);
    return digestOf(name ? *name : typed);
}

std::string nameInAudit(const std::string& hash)
{
    constexpr std::size_t kDigits = 16;
    assert(hash.size() >= kDigits);
    return hash.substr(0, kDigits);
}

bool canBeSeen(const std::string& name)
{
    const QList<uint> letters = QString::fromStdString(name).toUcs4();
    return std::all_of(letters.begin(), letters.end(),
                       [](uint c) { return QChar::isPrint(c) || c == 0x200C || c == 0x200D; });
}

}  // namespace database
