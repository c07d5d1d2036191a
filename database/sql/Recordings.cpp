// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sql/Recordings.h"

#include <string_view>

#include <QDir>
#include <QFileInfo>
#include <QSaveFile>

#include "core/base/WholeFile.h"
#include "database/FileSystem.h"
#include "database/Passwords.h"
#include "database/sql/Statement.h"

namespace database::sql {
namespace {

using core::ErrorCode;

constexpr qint64 kLargest = 1LL << 30U;

std::string_view viewOf(const QByteArray& bytes)
{
    return {bytes.constData(), static_cast<std::size_t>(bytes.size())};
}

/// Returns "recordings/3f/3f9a….cusprec" beside the database.
QString fileOf(const QSqlDatabase& db, const std::string& hash)
{
    const QString name = QString::fromStdString(hash);
    return QFileInfo(dialect::fileOf(db))
        .absoluteDir()
        .filePath(QStringLiteral("recordings/%1/%2.cusprec").arg(name.left(2), name));
}

core::Status writeFile(const QString& path, const QByteArray& bytes)
{
    if (contentOf(path, kLargest) == bytes)
        return {};
    const QString folder = QFileInfo(path).absolutePath();
    makeOwnFolder(QFileInfo(folder).absolutePath());
    makeOwnFolder(folder);
    // QSaveFile would write to the target of a link, which does not belong to the school.
    if (QFileInfo(path).isSymLink())
        QFile::remove(path);
    QSaveFile file(path);  // syncs the content before it renames the file
    if (file.open(QIODevice::WriteOnly) && file.setPermissions(QFile::ReadOwner | QFile::WriteOwner) &&
        file.write(bytes) == bytes.size() && file.flush() && file.commit() &&
        core::bringToDisk(folder.toStdU16String()) && core::bringToDisk((folder + "/..").toStdU16String()))
        return {};
    return core::unexpected(ErrorCode::FileUnwritable, "recording " + path.toStdString() + ": it cannot be written (" +
                                                           file.errorString().toStdString() +
                                                           "); make room on the disk and try again");
}

}  // namespace

core::Result<std::string> putRecording(const DatabaseContext& school, const QByteArray& bytes)
{
    const std::string hash = digestOf(viewOf(bytes));
    const core::Status put =
        dialect::isPostgres(school.db)
            ? execute(school.db, "INSERT INTO recordings (hash, content) VALUES (?, ?) ON CONFLICT DO NOTHING",
                      "keep the recording", {text(hash), bytes})
            : writeFile(fileOf(school.db, hash), bytes);
    if (!put)
        return tl::unexpected(put.error());
    return hash;
}

core::Result<std::vector<std::string>> recordingsNamed(const QSqlDatabase& db)
{
    std::vector<std::string> hashes;
    if (auto read = forEach(db, "SELECT DISTINCT recording_hash FROM attempts WHERE recording_hash <> ''",
                            "list the recordings", {}, [&](const QSqlQuery& row) { hashes.push_back(textOf(row, 0)); });
        !read)
        return tl::unexpected(read.error());
    return hashes;
}

core::Result<QByteArray> recordingOf(const QSqlDatabase& db, const std::string& hash)
{
    const std::string name = "recording " + hash.substr(0, 12) + ": ";
    QByteArray bytes;
    bool isThere = false;
    if (dialect::isPostgres(db)) {
        if (auto read = forEach(db, "SELECT content FROM recordings WHERE hash = ?", "read the recording", {text(hash)},
                                [&](const QSqlQuery& row) {
                                    bytes = row.value(0).toByteArray();
                                    isThere = true;
                                });
            !read)
            return tl::unexpected(read.error());
    } else {
        const QString file = fileOf(db, hash);
        const QFileInfo info(file);
        isThere = info.exists();
        const auto read = contentOf(file, kLargest);
        if (!read && info.isFile() && info.size() <= kLargest)
            return core::unexpected(ErrorCode::FileUnreadable,
                                    name + "it cannot be read; check the disk and who may read it");
        bytes = read.value_or(QByteArray());
    }
    // The server stores a recording before its attempt. A file may come back with its folder.
    if (!isThere && dialect::isPostgres(db))
        return core::unexpected(ErrorCode::BadStructure, name + "the server does not have it");
    if (!isThere)
        return core::unexpected(ErrorCode::FileMissing,
                                name + "it is not there any more; bring the folder \"recordings\" back from a backup");
    if (digestOf(viewOf(bytes)) != hash)
        return core::unexpected(ErrorCode::BadStructure, name + "it was changed or is damaged; bring it back from a "
                                                                "backup");
    return bytes;
}

}  // namespace database::sql
