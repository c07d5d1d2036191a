// SPDX-License-Identifier: GPL-3.0-or-later
#include "lessons/LessonCatalog.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

#include "lessons/LessonPack.h"
#include "lessons/LessonVersion.h"

namespace lessons {
namespace {

const QString kPattern = QStringLiteral("*.lesson.json");
constexpr qsizetype kMostLessons = 2000;

void addFolder(const QDir& folder, bool isShipped, std::vector<CatalogEntry>& entries)
{
    QStringList names = folder.entryList({kPattern}, QDir::Files, QDir::Name);
    if (names.size() > kMostLessons)
        names.resize(kMostLessons);
    for (const QString& name : names)
        entries.push_back({readLesson(folder.filePath(name)), isShipped, {}});
}

/// Returns whether a lesson of a pack was extracted into the folder, perhaps with changes since.
bool isUnpacked(const ReadLesson& packed, const QDir& folder, const std::vector<CatalogEntry>& entries)
{
    const QString file = folder.filePath(QFileInfo(packed.file).fileName());
    return std::any_of(entries.begin(), entries.end(), [&](const CatalogEntry& entry) {
        return entry.read.file == file && entry.read.lesson && packed.lesson &&
               entry.read.lesson->id == packed.lesson->id;
    });
}

/// Adds the lessons of each pack, or the error of the pack.
void addPacks(const QDir& folder, std::vector<CatalogEntry>& entries)
{
    QStringList names = folder.entryList({QStringLiteral("*.") + QLatin1String(kPackSuffix)}, QDir::Files, QDir::Name);
    if (names.size() > kMostLessons)
        names.resize(kMostLessons);
    for (const QString& name : names) {
        const QString file = folder.filePath(name);
        const auto opened = openPack(file);
        if (!opened) {
            entries.push_back({{file, {}, {{file, {}, core::wordsOf(opened.error()), true}}, {}}, false, file});
            continue;
        }
        std::vector<CatalogEntry> packed;
        addFolder(QDir(*opened), false, packed);
        for (CatalogEntry& entry : packed) {
            if (isUnpacked(entry.read, folder, entries))
                continue;
            entry.pack = file;
            for (ValidationIssue& fault : entry.read.faults)
                fault.what = {QT_TRANSLATE_NOOP("Fault", "%1 (in the pack %2)"), {fault.what, noted(name)}};
            entries.push_back(std::move(entry));
        }
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
    // A lesson that is in a pack and also extracted from it is listed once.
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
        entry.read.faults.push_back(
            {entry.read.file,
             QStringLiteral("id"),
             {QT_TRANSLATE_NOOP("Fault", "\"%1\" belongs to another lesson; give this one an id of its own"),
              {core::noted(entry.read.lesson->id)}},
             true});
        entry.read.lesson.reset();
    }
    return entries;
}

std::vector<std::string> useVersions(std::vector<CatalogEntry>& entries,
                                     const std::map<std::string, std::string>& assigned)
{
    std::vector<std::string> missing;
    for (const auto& [id, hash] : assigned) {
        auto entry = std::find_if(entries.begin(), entries.end(), [&id = id](const CatalogEntry& one) {
            return one.read.lesson && one.read.lesson->id == id;
        });
        if (hash.empty() || (entry != entries.end() && entry->read.lesson->hash == hash))
            continue;
        if (entry == entries.end())
            entry = entries.insert(entries.end(), CatalogEntry{});
        auto version = cachedVersion(hash);
        entry->read = {};
        entry->read.file = QString::fromStdString(id);
        entry->pack.clear();
        if (version) {
            entry->read.lesson = std::move(*version);
            continue;
        }
        entry->read.faults = {{entry->read.file, {}, core::wordsOf(version.error()), true}};
        if (version.error().code == core::ErrorCode::FileMissing)
            missing.push_back(hash);
    }
    return missing;
}

core::Result<QString> lessonFile(const QString& fileOrId)
{
    if (fileOrId.endsWith(QStringLiteral(".json")) || QFileInfo::exists(fileOrId))
        return fileOrId;
    for (const CatalogEntry& entry : readCatalog(teachersFolder()))
        if (entry.read.lesson && entry.read.lesson->id == fileOrId.toStdString())
            return entry.read.file;
    return core::unexpected(core::ErrorCode::UnknownName,
                            QStringLiteral("there is no lesson \"%1\"; \"cusp lesson list\" names them")
                                .arg(fileOrId.left(80))
                                .toStdString());
}

core::Result<Lesson> lessonNamed(const QString& fileOrId)
{
    const auto file = lessonFile(fileOrId);
    if (!file)
        return tl::unexpected(file.error());
    ReadLesson read = readLesson(*file);
    if (read.lesson)
        return std::move(*read.lesson);
    const auto grave =
        std::find_if(read.faults.begin(), read.faults.end(), [](const ValidationIssue& fault) { return fault.grave; });
    return core::unexpected(core::ErrorCode::BadStructure, grave->sentence().toStdString());
}

QString teachersFolder()
{
    return QDir(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation)).filePath(QStringLiteral("lessons"));
}

}  // namespace lessons
