// SPDX-License-Identifier: GPL-3.0-or-later
#include "lessons/LessonCatalog.h"

#include <algorithm>
#include <set>

#include <QDir>
#include <QStandardPaths>

namespace lessons {
namespace {

const QString kPattern = QStringLiteral("*.lesson.json");
constexpr qsizetype kMostFiles = 2000;

void addFolder(const QDir& folder, bool isShipped, std::vector<CatalogEntry>& entries)
{
    QStringList names = folder.entryList({kPattern}, QDir::Files, QDir::Name);
    if (names.size() > kMostFiles)
        names.resize(kMostFiles);
    for (const QString& name : names)
        entries.push_back({readLesson(folder.filePath(name)), isShipped});
}

}  // namespace

std::vector<CatalogEntry> readCatalog(const QString& folder)
{
    std::vector<CatalogEntry> entries;
    addFolder(QDir(QStringLiteral(":/lessons")), true, entries);
    if (!folder.isEmpty())
        addFolder(QDir(folder), false, entries);
    std::set<std::string> ids;
    for (CatalogEntry& entry : entries) {
        if (!entry.read.lesson || ids.insert(entry.read.lesson->id).second)
            continue;
        entry.read.faults.push_back({entry.read.file, QStringLiteral("id"),
                                     QStringLiteral("\"%1\" belongs to another lesson; give this one an id of its own")
                                         .arg(QString::fromStdString(entry.read.lesson->id)),
                                     true});
        entry.read.lesson.reset();
    }
    return entries;
}

QString teachersFolder()
{
    return QDir(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation)).filePath(QStringLiteral("lessons"));
}

}  // namespace lessons
