// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QByteArray>
#include <QString>

namespace database {

/// What kind of drive a file lies on. SQLite's write-ahead log needs memory that all who have the file open share,
/// which a network drive does not give (sqlite.org/wal.html).
enum class FileSystem { Local, Network };

/// Of the file's folder. A file system in user space (FUSE) counts as a network's: sshfs and its like are. Unknown:
/// Local.
[[nodiscard]] FileSystem fileSystemOf(const QString& path);

/// Makes a folder for its owner only, since names and marks will lie in it, and those above it as usual; one that is
/// there stays as somebody has set it.
void makeOwnFolder(const QString& path);

/// What stands in a file. Nothing: there is none, it cannot be read, or has more than `most` bytes. A pipe or a device
/// in its place is not opened: the one may let wait for ever, the other have no end.
[[nodiscard]] std::optional<QByteArray> contentOf(const QString& path, qint64 most);

}  // namespace database
