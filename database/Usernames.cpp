// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/Usernames.h"

#include <algorithm>

#include <QList>
#include <QString>

namespace database {
namespace {

constexpr int kLongest = 64;

}  // namespace

core::Result<std::string> normalUsername(const std::string& typed)
{
    const QString name =
        QString::fromStdString(typed).normalized(QString::NormalizationForm_KC).trimmed().toCaseFolded();
    const QList<uint> letters = name.toUcs4();
    const auto isFit = [](uint c) {
        return QChar::isLetterOrNumber(c) || QChar::isMark(c) || c == '.' || c == '_' || c == '-' || c == '@';
    };
    if (name.isEmpty())
        return core::unexpected(core::ErrorCode::OutOfRange, "the user's name is empty; give one");
    if (name.size() > kLongest)
        return core::unexpected(core::ErrorCode::OutOfRange, "the user's name is longer than " +
                                                                 std::to_string(kLongest) + " characters; shorten it");
    if (!std::all_of(letters.begin(), letters.end(), isFit))
        return core::unexpected(core::ErrorCode::OutOfRange,
                                "a user's name has letters, digits and . _ - @ only; correct it");
    return name.toStdString();
}

bool canBeSeen(const std::string& name)
{
    const QList<uint> letters = QString::fromStdString(name).toUcs4();
    return std::all_of(letters.begin(), letters.end(), [](uint c) { return QChar::isPrint(c); });
}

}  // namespace database
