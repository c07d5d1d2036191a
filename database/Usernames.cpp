// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/Usernames.h"

#include <algorithm>

#include <QString>

namespace database {
namespace {

constexpr int kLongest = 64;

}  // namespace

core::Result<std::string> normalUsername(const std::string& typed)
{
    const QString name =
        QString::fromStdString(typed).normalized(QString::NormalizationForm_KC).trimmed().toCaseFolded();
    const auto isFit = [](QChar c) { return c.isLetterOrNumber() || c.isMark() || QStringLiteral("._-@").contains(c); };
    if (name.isEmpty())
        return core::unexpected(core::ErrorCode::OutOfRange, "the user's name is empty; give one");
    if (name.size() > kLongest)
        return core::unexpected(core::ErrorCode::OutOfRange, "the user's name is longer than " +
                                                                 std::to_string(kLongest) + " characters; shorten it");
    if (!std::all_of(name.begin(), name.end(), isFit))
        return core::unexpected(core::ErrorCode::OutOfRange,
                                "a user's name has letters, digits and . _ - @ only; correct it");
    return name.toStdString();
}

}  // namespace database
