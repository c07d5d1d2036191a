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

}  // namespace database
