// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

}  // namespace database
