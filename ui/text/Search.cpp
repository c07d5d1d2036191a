// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/Search.h"

#include <algorithm>

#include <QStringList>

namespace ui::text {
namespace {

/// Returns whether a character is a Japanese voicing mark, which turns "ka" into "ga" or "ha" into "pa". The results
/// are other letters, not accented ones.
bool isVoicing(QChar letter)
{
    return letter == QChar(0x3099) || letter == QChar(0x309A);
}

}  // namespace

QString plain(const QString& words)
{
    QString parted = words.normalized(QString::NormalizationForm_KD);
    parted.removeIf([](QChar letter) { return letter.category() == QChar::Mark_NonSpacing && !isVoicing(letter); });
    parted.replace(QChar(0xDF), QStringLiteral("ss"));  // Qt does not decompose it
    return parted.toCaseFolded().normalized(QString::NormalizationForm_C);
}

bool holds(const QString& all, const QString& part)
{
    return plain(all).contains(plain(part));
}

bool holdsEach(const QString& all, const QString& words)
{
    const QStringList parts = plain(words).split(u' ', Qt::SkipEmptyParts);
    const QString within = plain(all);
    return std::all_of(parts.begin(), parts.end(), [&](const QString& part) { return within.contains(part); });
}

}  // namespace ui::text
