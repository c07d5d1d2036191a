// SPDX-License-Identifier: GPL-3.0-or-later
#include "lessons/LessonCatalog.h"

#include <map>
#include <set>

#include <QDir>
#include <QStandardPaths>

#include "lessons/LessonPack.h"

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

/// The lessons of each pack, or what is wrong with it.
void addPacks(const QDir& folder, std::vector<CatalogEntry>& entries)
{
    QStringList names = folder.entryList({QStringLiteral("*.") + QLatin1String(kPackSuffix)}, QDir::Files, QDir::Name);
    if (names.size() > kMostFiles)
        names.resize(kMostFiles);
    for (const QString& name : names) {
        const QString file = folder.filePath(name);
        const auto opened = openPack(file);
        if (opened)
            addFolder(QDir(*opened), false, entries);
        else
            entries.push_back(
                {{file, {}, {{file, {}, QString::fromStdString(opened.error().detail), true}}, {}}, false});
    }
}

}  // namespace

std::vector<CatalogEntry> readCatalog(const QString& folder)
{
    std::vector<CatalogEntry> entries;
    addFolder(QDir(QStringLiteral(":/lessons")), true, entries);
    if (!folder.isEmpty()) {
        addFolder(QDir(folder), false, entries);
        addPacks(QDir(folder), entries);
    }
    std::map<std::string, std::string> hashes;
    // A lesson that came twice, unpacked and in its pack, is there once.
    std::erase_if(entries, [&](const CatalogEntry& entry) {
        if (!entry.read.lesson || entry.isShipped)
            return false;
        const auto [known, isNew] = hashes.emplace(entry.read.lesson->id, entry.read.lesson->hash);
        return !isNew && known->second == entry.read.lesson->hash;
    });
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
