// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QByteArray>
#include <QString>
#include <QStringList>

#include "core/base/Result.h"

/// Lessons in one file (*.cusplessons), with all files that they need and that are not shipped: the files they are
/// based on, rubrics, scans, captured ideals, experts' recordings. The file is one Zstandard frame that contains a JSON
/// object,
///
///     {"format": 1, "cusp": "lessons", "files": [{"name": "...", "sha256": "...", "base64": "..."}]}
///
/// so `zstd -dc NAME.cusplessons` shows it. Debian's libraries for archives (libarchive, libzip, QuaZip) would add a
/// dependency without doing the checks for bombs, links and names outside the folder.
namespace lessons {

inline constexpr qsizetype kMostPackedFiles = 500;
/// Limit of all files together, unpacked.
inline constexpr qint64 kLargestPackBytes = qint64{64} * 1024 * 1024;
inline constexpr int kPackFormat = 1;
inline constexpr const char* kPackSuffix = "cusplessons";

struct PackedFile
{
    QString name;  ///< beside the lesson or in a folder below: "scans/tooth.stl"
    QByteArray content;
};

/// Returns the bytes of a pack with these lessons. The error names the lesson that is faulty, or two different files
/// that would have the same name, or says that the limit is exceeded.
[[nodiscard]] core::Result<QByteArray> packLessons(const QStringList& lessonFiles);

/// Returns the files in a pack, each checked against its hash. Uses at most the memory of kLargestPackBytes and their
/// base64. The error does not name the pack.
[[nodiscard]] core::Result<std::vector<PackedFile>> unpackLessons(const QByteArray& bytes);
[[nodiscard]] core::Result<std::vector<PackedFile>> readPack(const QString& file);

/// Writes all files into a folder, which is created if necessary; files with the same content stay. Writes nothing if a
/// file with other content, or a link, is in the way.
[[nodiscard]] core::Status putInto(const QString& folder, const std::vector<PackedFile>& files);

/// Returns a folder with the checked files of a pack, from which lessons are read. Created on the first call and found
/// again by the pack's hash. It is in the user's cache, so changes to it are lost.
[[nodiscard]] core::Result<QString> openPack(const QString& file);

}  // namespace lessons
