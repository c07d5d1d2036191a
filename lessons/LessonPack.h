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
/// so `zstd -dc NAME.cusplessons` shows it. Debian's archive libraries (libarchive, libzip, QuaZip) would add a
/// dependency, and Cusp would still have to check for decompression bombs, links and names outside the folder.
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

/// Returns the bytes of a pack with these lessons. Error: a lesson has faults, two different files would have the same
/// name, or a limit is exceeded.
[[nodiscard]] core::Result<QByteArray> packLessons(const QStringList& lessonFiles);

/// Returns the bytes of a pack with these files. Error: their number or a name is not allowed.
[[nodiscard]] core::Result<QByteArray> packFiles(const std::vector<PackedFile>& files);

/// Returns the files in a pack, each checked against its hash. Its memory is limited to kLargestPackBytes plus the
/// base64 text of the files. The error does not name the pack.
[[nodiscard]] core::Result<std::vector<PackedFile>> unpackLessons(const QByteArray& bytes);
[[nodiscard]] core::Result<std::vector<PackedFile>> readPack(const QString& file);

/// Writes all files into a folder and creates it if necessary. Files with the same content are not written again.
/// Writes nothing if there is a link or a file with other content under one of the names.
[[nodiscard]] core::Status putInto(const QString& folder, const std::vector<PackedFile>& files);

/// Returns a folder with the checked files of a pack, for reading its lessons. The first call creates it; later calls
/// find it by the pack's hash. It is in the user's cache, so changes to it are lost.
[[nodiscard]] core::Result<QString> openPack(const QString& file);

}  // namespace lessons
