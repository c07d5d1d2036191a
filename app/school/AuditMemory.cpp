// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/school/AuditMemory.h"

#include <QDir>
#include <QSettings>
#include <QStandardPaths>
#include <QStringList>

namespace app {

QString AuditMemory::defaultFile()
{
    return QDir(QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation))
        .filePath(QStringLiteral("audit.ini"));
}

std::optional<AuditMemory::Seen> AuditMemory::of(const std::string& school) const
{
    const QSettings stored(m_file, QSettings::IniFormat);
    const QStringList parts = stored.value(QString::fromStdString(school)).toStringList();
    if (parts.size() != 3)
        return std::nullopt;
    return Seen{{parts[0].toLongLong(), parts[1].toStdString()}, parts[2].toStdString()};
}

void AuditMemory::remember(const std::string& school, const database::AuditHead& head, const std::string& nowUtc) const
{
    QSettings stored(m_file, QSettings::IniFormat);
    stored.setValue(
        QString::fromStdString(school),
        QStringList{QString::number(head.seq), QString::fromStdString(head.hash), QString::fromStdString(nowUtc)});
}

void AuditMemory::forget(const std::string& school) const
{
    QSettings(m_file, QSettings::IniFormat).remove(QString::fromStdString(school));
}

}  // namespace app
