// SPDX-License-Identifier: GPL-3.0-or-later
#include "lessons/LessonVersion.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>
#include <vector>

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStandardPaths>

#include "core/base/WholeFile.h"
#include "lessons/LessonPack.h"
#include "lessons/LessonReader.h"

namespace lessons {
namespace {

using core::ErrorCode;

const QString kTextSuffix = QStringLiteral(".lesson.json");

/// A file that the text of a lesson names, and the SHA-256 that the text has of it.
struct NamedFile
{
    QString name;
    std::string hash;
};

std::string sha256Of(const QByteArray& content)
{
    return QCryptographicHash::hash(content, QCryptographicHash::Sha256).toHex().toStdString();
}

/// Returns the files that a lesson's text names: scan, captured ideal, expert's recording.
std::vector<NamedFile> filesNamedIn(const QJsonObject& text)
{
    std::vector<NamedFile> files;
    for (const auto& [owner, key] :
         {std::pair("tooth", "scan"), std::pair("ideal", "captured"), std::pair("expert", "recording")}) {
        const QJsonObject object = text.value(QLatin1String(owner)).toObject();
        if (const QString name = object.value(QLatin1String(key)).toString(); !name.isEmpty())
            files.push_back({name, object.value(QStringLiteral("content")).toString().toStdString()});
    }
    return files;
}

/// Returns the paths of the same files on this computer, in the same order.
std::vector<std::string> pathsOf(const Lesson& lesson)
{
    std::vector<std::string> paths;
    if (const auto* scan = std::get_if<Scan>(&lesson.tooth))
        paths.push_back(scan->file);
    if (lesson.ideal && lesson.ideal->captured)
        paths.push_back(lesson.ideal->captured->file);
    if (lesson.expert)
        paths.push_back(lesson.expert->file);
    return paths;
}

tl::unexpected<core::Error> changed(const QString& name)
{
    return core::unexpected(ErrorCode::BadStructure,
                            core::LocalizableText{QT_TRANSLATE_NOOP("Fault", "\"%1\" has changed since the lesson was "
                                                                             "read; open the page again."),
                                                  {noted(name)}});
}

QString cacheFile(const std::string& hash)
{
    return QDir(QStandardPaths::writableLocation(QStandardPaths::CacheLocation))
        .filePath(QStringLiteral("versions/") + QString::fromStdString(hash) + u'.' + QLatin1String(kPackSuffix));
}

}  // namespace

core::Result<QByteArray> packVersion(const Lesson& lesson)
{
    const QByteArray text = QByteArray::fromStdString(lesson.json);
    std::vector<PackedFile> files{{QString::fromStdString(lesson.id) + kTextSuffix, text}};
    const std::vector<NamedFile> named = filesNamedIn(QJsonDocument::fromJson(text).object());
    const std::vector<std::string> paths = pathsOf(lesson);
    for (std::size_t k = 0; k < named.size() && k < paths.size(); ++k) {
        QFile file(QString::fromStdString(paths[k]));
        if (file.size() > kLargestPackBytes || !file.open(QIODevice::ReadOnly))
            return core::unexpected(
                ErrorCode::FileTooLarge,
                core::LocalizableText{QT_TRANSLATE_NOOP("Fault", "\"%1\" cannot be read, or has more than %2 MB, which "
                                                                 "a lesson may take along; use a coarser scan."),
                                      {noted(named[k].name), noted(kLargestPackBytes >> 20)}});
        const QByteArray content = file.readAll();
        if (sha256Of(content) != named[k].hash)
            return changed(named[k].name);
        const auto isThere = [&](const PackedFile& one) { return one.name == named[k].name; };
        if (std::none_of(files.begin(), files.end(), isThere))
            files.push_back({named[k].name, content});
    }
    return packFiles(files);
}

core::Result<LessonVersion> versionIn(const QByteArray& pack)
{
    const auto files = unpackLessons(pack);
    if (!files)
        return tl::unexpected(files.error());
    const auto text = std::find_if(files->begin(), files->end(),
                                   [](const PackedFile& file) { return file.name.endsWith(kTextSuffix); });
    if (text == files->end())
        return core::unexpected(ErrorCode::BadStructure, "the pack contains no lesson");
    const QJsonObject object = QJsonDocument::fromJson(text->content).object();
    for (const NamedFile& named : filesNamedIn(object)) {
        const auto file =
            std::find_if(files->begin(), files->end(), [&](const PackedFile& one) { return one.name == named.name; });
        if (file == files->end() || sha256Of(file->content) != named.hash)
            return changed(named.name);
    }
    return LessonVersion{object.value(QStringLiteral("id")).toString().toStdString(),
                         object.value(QStringLiteral("version")).toInt(1), sha256Of(text->content)};
}

core::Status cacheVersion(const std::string& hash, const QByteArray& pack)
{
    const auto found = versionIn(pack);
    if (!found)
        return tl::unexpected(found.error());
    if (found->hash != hash)
        return core::unexpected(ErrorCode::OutOfRange, "the database has another lesson under the name of this one");
    const QString file = cacheFile(hash);
    QDir().mkpath(QFileInfo(file).absolutePath());
    return core::writeWhole(std::filesystem::path(file.toStdU16String()),
                            {pack.constData(), static_cast<std::size_t>(pack.size())}, "The assigned lesson");
}

bool isVersionCached(const std::string& hash)
{
    return QFileInfo::exists(cacheFile(hash));
}

core::Result<Lesson> cachedVersion(const std::string& hash)
{
    const QString file = cacheFile(hash);
    if (!isVersionCached(hash))
        return core::unexpected(
            ErrorCode::FileMissing,
            core::LocalizableText{QT_TRANSLATE_NOOP("Fault", "The version that was assigned is not on this computer "
                                                             "yet. Open this page again when the database can be "
                                                             "reached.")});
    const auto folder = openPack(file);
    if (!folder && folder.error().code == ErrorCode::FileUnwritable)  // the disk may be full
        return tl::unexpected(folder.error());
    const QStringList names = folder ? QDir(*folder).entryList({u'*' + kTextSuffix}, QDir::Files) : QStringList();
    ReadLesson read = names.isEmpty() ? ReadLesson{} : readLesson(QDir(*folder).filePath(names.front()));
    if (!read.lesson || read.lesson->hash != hash) {
        QFile::remove(file);  // the next try fetches it again
        return core::unexpected(
            ErrorCode::BadStructure,
            core::LocalizableText{QT_TRANSLATE_NOOP("Fault", "The version that was assigned cannot be read by this "
                                                             "version of Cusp. Ask who keeps Cusp to update it.")});
    }
    return std::move(*read.lesson);
}

}  // namespace lessons
