// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QByteArray>
#include <QString>

namespace database {

/// The kind of drive of a file. SQLite's write-ahead log needs memory shared by all programs that have the file open,
/// which a network drive does not provide (sqlite.org/wal.html).
enum class FileSystem { Local, Network };

/// Returns the kind of drive of the file's folder. A file system in user space (FUSE) counts as a network drive,
/// because sshfs is one. Unknown: Local.
[[nodiscard]] FileSystem fileSystemOf(const QString& path);

/// Creates a folder for its owner only, because it will contain names and scores; missing parent folders get the usual
/// permissions. An existing folder is not changed.
void makeOwnFolder(const QString& path);

/// Reads a file. Empty if it does not exist, cannot be read, or has more than `most` bytes. Does not open a pipe or a
/// device: reading might never end.
[[nodiscard]] std::optional<QByteArray> contentOf(const QString& path, qint64 most);

}  // namespace database
