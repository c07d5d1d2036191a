// SPDX-License-Identifier: GPL-3.0-or-later
#include "lessons/LessonPack.h"

#include <algorithm>

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSet>
#include <QStandardPaths>
#include <QTemporaryDir>

#include "core/base/WholeFile.h"
#include "core/recording/Format.h"
#include "lessons/Assignment.h"
#include "lessons/JsonFiles.h"
#include "lessons/LessonReader.h"

namespace lessons {
namespace {

/// Base64 makes files larger by a third, and names and hashes take space.
constexpr qint64 kLargestJsonBytes = kLargestPackBytes / 3 * 4 + qint64{1024} * 1024;
constexpr const char* kNoPack = QT_TRANSLATE_NOOP("Fault", "This is no pack of lessons; choose a file that "
                                                           "\"cusp lesson pack\" has made.");
/// Largest number of commas and opening brackets: three values for each file, and names that contain some.
constexpr std::ptrdiff_t kMostMarks = 20 * kMostPackedFiles;
const QStringList kSuffixes{QStringLiteral("json"),    QStringLiteral("cuspideal"), QStringLiteral("stl"),
                            QStringLiteral("obj"),     QStringLiteral("ply"),       QStringLiteral("mtl"),
                            QStringLiteral("cusprec"), QStringLiteral("cusppreset")};

tl::unexpected<core::Error> refused(core::ErrorCode code, const char* sentence, const QStringList& values = {})
{
    core::LocalizableText words{sentence};
    for (const QString& value : values)
        words.values.push_back(noted(value));
    return core::unexpected(code, std::move(words));
}

QString megabytes(qint64 bytes)
{
    return QStringLiteral("%1 MB").arg(static_cast<double>(bytes) / (1024.0 * 1024.0), 0, 'f', 1);
}

QString hashOf(const QByteArray& content)
{
    return QString::fromLatin1(QCryptographicHash::hash(content, QCryptographicHash::Sha256).toHex());
}

/// Returns whether a file of a pack may have this name: valid on any system, and not executable.
bool isNameInPack(const QString& name)
{
    if (!isNameBeside(name) || !kSuffixes.contains(QFileInfo(name).suffix().toLower()))
        return false;
    const QStringList parts = name.split(u'/');
    return std::all_of(parts.begin(), parts.end(), [](const QString& part) {
        return !part.isEmpty() && !part.startsWith(u'.') && !part.endsWith(u' ') &&
               std::all_of(part.begin(), part.end(), [](QChar letter) {
                   return letter.isPrint() && !QStringLiteral("<>:\"|?*").contains(letter);
               });
    });
}

/// Returns a name in a form that can be shown in a message.
QString shown(const QString& name)
{
    QString safe = name.left(80);
    std::replace_if(
        safe.begin(), safe.end(), [](QChar letter) { return !letter.isPrint(); }, QChar(QChar::ReplacementCharacter));
    return safe;
}

core::Result<QByteArray> contentOf(const QString& path, qint64 most)
{
    QFile file(path);
    if (!QFileInfo(path).isFile() || !file.open(QIODevice::ReadOnly))
        return refused(core::ErrorCode::FileUnreadable,
                       QT_TRANSLATE_NOOP("Fault", "%1 cannot be read; check its name and rights."),
                       {QDir::toNativeSeparators(path)});
    if (file.size() > most)
        return refused(
            core::ErrorCode::FileTooLarge,
            QT_TRANSLATE_NOOP("Fault", "%1 has %2, and a pack takes %3 in all; pack fewer lessons, or coarser scans."),
            {QFileInfo(path).fileName(), megabytes(file.size()), megabytes(kLargestPackBytes)});
    return file.readAll();
}

bool holds(const QString& path, const QByteArray& content)
{
    const auto there = contentOf(path, kLargestPackBytes);
    return there && *there == content;
}

core::Status writeInto(const QString& path, const QByteArray& content)
{
    const QString folder = QFileInfo(path).absolutePath();
    if (!QDir().mkpath(folder))
        return refused(core::ErrorCode::FileUnwritable,
                       QT_TRANSLATE_NOOP("Fault", "The folder %1 cannot be made; name another."),
                       {QDir::toNativeSeparators(folder)});
    return core::writeWhole(std::filesystem::path(path.toStdU16String()),
                            {content.constData(), static_cast<std::size_t>(content.size())}, "A file of the pack");
}

core::Result<PackedFile> packedFile(const QJsonObject& entry)
{
    PackedFile file{entry.value(QStringLiteral("name")).toString(), {}};
    if (!isNameInPack(file.name))
        return refused(core::ErrorCode::BadStructure,
                       QT_TRANSLATE_NOOP("Fault",
                                         "The pack names a file \"%1\", which leads out of its folder or is of no kind "
                                         "that lessons have; nothing was unpacked."),
                       {shown(file.name)});
    const auto decoded = QByteArray::fromBase64Encoding(entry.value(QStringLiteral("base64")).toString().toLatin1(),
                                                        QByteArray::AbortOnBase64DecodingErrors);
    if (!decoded || hashOf(decoded.decoded) != entry.value(QStringLiteral("sha256")).toString())
        return refused(core::ErrorCode::BadStructure,
                       QT_TRANSLATE_NOOP("Fault",
                                         "The file \"%1\" in the pack is not what its hash says: it was damaged or "
                                         "changed; nothing was unpacked. Ask for the pack again."),
                       {file.name});
    file.content = decoded.decoded;
    return file;
}

}  // namespace

core::Result<QByteArray> packLessons(const QStringList& lessonFiles)
{
    std::vector<PackedFile> files;
    QMap<QString, QByteArray> packed;
    qint64 sum = 0;
    for (const QString& lessonFile : lessonFiles) {
        const ReadLesson read = readLesson(lessonFile);
        if (!read.lesson) {
            const auto grave = std::find_if(read.faults.begin(), read.faults.end(),
                                            [](const ValidationIssue& fault) { return fault.grave; });
            return refused(core::ErrorCode::BadStructure, "%1. Only a lesson that can be given is packed.",
                           {grave->sentence()});
        }
        // The file of a scan is checked only when its tooth is built.
        if (std::holds_alternative<Scan>(read.lesson->tooth))
            if (const auto assigned = assign(*read.lesson); !assigned)
                return tl::unexpected(assigned.error());
        const QDir folder = QFileInfo(lessonFile).absoluteDir();
        for (const QString& path : read.uses) {
            const QString name = folder.relativeFilePath(QFileInfo(path).absoluteFilePath());
            const auto content = contentOf(path, kLargestPackBytes - sum);
            if (!content)
                return tl::unexpected(content.error());
            const QString key = name.toLower();
            if (packed.contains(key)) {
                if (packed[key] != *content)
                    return refused(core::ErrorCode::BadStructure,
                                   "Two different files are called \"%1\"; rename one of them.", {name});
                continue;
            }
            packed[key] = *content;
            sum += content->size();
            files.push_back({name, *content});
        }
    }
    return packFiles(files);
}

core::Result<QByteArray> packFiles(const std::vector<PackedFile>& files)
{
    if (files.empty() || files.size() > static_cast<std::size_t>(kMostPackedFiles))
        return refused(core::ErrorCode::OutOfRange, "A pack takes 1 to %1 files of lessons, not %2.",
                       {QString::number(kMostPackedFiles), QString::number(files.size())});
    QJsonArray entries;
    for (const PackedFile& file : files) {
        if (!isNameInPack(file.name))
            return refused(core::ErrorCode::BadStructure,
                           "A file of the name \"%1\" cannot go into a pack; rename it (%2).",
                           {file.name, kSuffixes.join(QStringLiteral(", "))});
        entries.append(QJsonObject{{"name", file.name},
                                   {"sha256", hashOf(file.content)},
                                   {"base64", QString::fromLatin1(file.content.toBase64())}});
    }
    const QByteArray json = QJsonDocument(QJsonObject{{"format", kPackFormat}, {"cusp", "lessons"}, {"files", entries}})
                                .toJson(QJsonDocument::Compact);
    return QByteArray::fromStdString(core::recording::pack({json.constData(), static_cast<std::size_t>(json.size())}));
}

core::Result<std::vector<PackedFile>> unpackLessons(const QByteArray& bytes)
{
    const auto json = core::recording::unpack({bytes.constData(), static_cast<std::size_t>(bytes.size())},
                                              static_cast<std::uint64_t>(kLargestJsonBytes));
    if (!json)
        return refused(
            core::ErrorCode::WrongKind,
            QT_TRANSLATE_NOOP("Fault", "This is no pack of lessons, it is damaged, or it holds more than %1; choose a "
                                       "file that \"cusp lesson pack\" has made."),
            {megabytes(kLargestPackBytes)});
    // Parsed JSON takes thirty times the memory of a text of brackets and commas. A pack has two for each value.
    const auto marks =
        std::count_if(json->begin(), json->end(), [](char letter) { return letter == ',' || letter == '['; });
    if (marks > kMostMarks)
        return refused(core::ErrorCode::WrongKind, kNoPack);
    const QJsonObject pack =
        QJsonDocument::fromJson(QByteArray::fromRawData(json->data(), static_cast<qsizetype>(json->size()))).object();
    const int format = pack.value(QStringLiteral("format")).toInt();
    if (pack.value(QStringLiteral("cusp")).toString() != u"lessons" || format < 1)
        return refused(core::ErrorCode::WrongKind, kNoPack);
    if (format > kPackFormat)
        return refused(core::ErrorCode::NewerVersion,
                       QT_TRANSLATE_NOOP("Fault",
                                         "The pack is of format %1, from a newer Cusp; this one reads %2. Update "
                                         "Cusp."),
                       {QString::number(format), QString::number(kPackFormat)});
    const QJsonArray list = pack.value(QStringLiteral("files")).toArray();
    if (list.isEmpty() || list.size() > kMostPackedFiles)
        return refused(core::ErrorCode::BadStructure,
                       QT_TRANSLATE_NOOP("Fault", "The pack lists %1 files; it may hold 1 to %2."),
                       {QString::number(list.size()), QString::number(kMostPackedFiles)});
    std::vector<PackedFile> files;
    QSet<QString> names;
    for (const QJsonValue entry : list) {
        auto file = packedFile(entry.toObject());
        if (!file)
            return tl::unexpected(file.error());
        if (names.contains(file->name.toLower()))
            return refused(core::ErrorCode::BadStructure,
                           QT_TRANSLATE_NOOP("Fault", "The pack holds \"%1\" twice; nothing was unpacked."),
                           {file->name});
        names << file->name.toLower();
        files.push_back(std::move(*file));
    }
    return files;
}

core::Result<std::vector<PackedFile>> readPack(const QString& file)
{
    const auto bytes = contentOf(file, kLargestJsonBytes);
    auto files = bytes ? unpackLessons(*bytes) : core::Result<std::vector<PackedFile>>(tl::unexpected(bytes.error()));
    if (!files && bytes)
        return core::unexpected(
            files.error().code,
            core::LocalizableText{"%1: %2", {noted(QFileInfo(file).fileName()), core::wordsOf(files.error())}});
    return files;
}

core::Status putInto(const QString& folder, const std::vector<PackedFile>& files)
{
    const QDir into(folder);
    std::vector<const PackedFile*> missing;
    for (const PackedFile& file : files) {
        QString way = folder;
        for (const QString& part : file.name.split(u'/')) {
            way = QDir(way).filePath(part);
            if (QFileInfo(way).isSymLink())
                return refused(
                    core::ErrorCode::FileUnwritable,
                    QT_TRANSLATE_NOOP("Fault", "%1 is a link to elsewhere; nothing was unpacked. Name another folder."),
                    {QDir::toNativeSeparators(way)});
        }
        const QString path = into.filePath(file.name);
        if (!QFileInfo::exists(path)) {
            missing.push_back(&file);
            continue;
        }
        if (!holds(path, file.content))
            return refused(
                core::ErrorCode::FileUnwritable,
                QT_TRANSLATE_NOOP("Fault", "There is another file \"%1\" in %2 already; nothing was unpacked. Move it "
                                           "away, or name another folder."),
                {file.name, QDir::toNativeSeparators(folder)});
    }
    QStringList made;
    for (const PackedFile* const file : missing) {
        const QString path = into.filePath(file->name);
        core::Status written = writeInto(path, file->content);
        if (!written) {
            // If the disk is full, an incomplete pack would block the next try.
            for (const QString& other : made)
                QFile::remove(other);
            return written;
        }
        made << path;
    }
    return {};
}

core::Result<QString> openPack(const QString& file)
{
    const auto bytes = contentOf(file, kLargestJsonBytes);
    if (!bytes)
        return tl::unexpected(bytes.error());
    const QDir cache(
        QDir(QStandardPaths::writableLocation(QStandardPaths::CacheLocation)).filePath(QStringLiteral("packs")));
    const QString folder = cache.filePath(hashOf(*bytes));
    const auto files = unpackLessons(*bytes);
    if (!files)
        return tl::unexpected(files.error());
    if (QFileInfo(folder).isDir()) {
        if (std::all_of(files->begin(), files->end(), [&](const PackedFile& packed) {
                return holds(QDir(folder).filePath(packed.name), packed.content);
            }))
            return folder;
        // A cache cleaner may have removed single files, and other programs may have changed them.
        QDir(folder).removeRecursively();
    }
    // The folder must appear with all files at once, because another Cusp may read it meanwhile.
    QDir().mkpath(cache.path());
    QTemporaryDir beside(cache.filePath(QStringLiteral("part-XXXXXX")));
    const core::Status put =
        beside.isValid() ? putInto(beside.path(), *files)
                         : refused(core::ErrorCode::FileUnwritable,
                                   QT_TRANSLATE_NOOP("Fault", "The folder %1 cannot be written."), {cache.path()});
    if (!put)
        return tl::unexpected(put.error());
    if (QDir().rename(beside.path(), folder))
        beside.setAutoRemove(false);
    else if (!QFileInfo(folder).isDir())
        return refused(core::ErrorCode::FileUnwritable, QT_TRANSLATE_NOOP("Fault", "The folder %1 cannot be written."),
                       {cache.path()});
    return folder;
}

}  // namespace lessons
