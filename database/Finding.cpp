// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/Finding.h"

namespace database {

QString filled(const QString& words, const QStringList& values)
{
    QString whole;
    for (qsizetype i = 0; i < words.size(); ++i) {
        const qsizetype n = words[i] == u'%' && i + 1 < words.size() ? words[i + 1].digitValue() : -1;
        if (n >= 1 && n <= values.size()) {
            whole += values[n - 1];
            ++i;
        } else {
            whole += words[i];
        }
    }
    return whole;
}

QString Finding::english() const
{
    QStringList noted;
    for (const std::string& value : values)
        noted << QString::fromStdString(value);
    return filled(QString::fromUtf8(words), noted);
}

}  // namespace database
