// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QByteArray>
#include <QString>
#include <QStringList>

#include "core/base/Result.h"

/// Lessons in one file (*.cusplessons), with all that they need and is not shipped: what they are based on, rubrics,
/// scans, captured ideals, experts' recordings. The file is one Zstandard frame with a JSON object in it,
///
///     {"format": 1, "cusp": "lessons", "files": [{"name": "...", "sha256": "...", "base64": "..."}]}
///
/// so `zstd -dc NAME.cusplessons` shows it to anyone. Debian's libraries for archives (libarchive, libzip, QuaZip)
/// would be a dependency more and leave the checks for bombs, links and names that lead elsewhere to us just the same.
namespace lessons {

inline constexpr qsizetype kMostPackedFiles = 500;
/// Of all files together, unpacked.
inline constexpr qint64 kLargestPackBytes = qint64{64} * 1024 * 1024;
inline constexpr int kPackFormat = 1;
inline constexpr const char* kPackSuffix = "cusplessons";

struct PackedFile
{
    QString name;  ///< beside the lesson or in a folder below: "scans/tooth.stl"
    QByteArray content;
};

/// The bytes of a pack with these lessons. An error names the lesson that cannot be given, two files that are different
/// and would have one name, or says that it is too much.
[[nodiscard]] core::Result<QByteArray> packLessons(const QStringList& lessonFiles);

/// What is in a pack, each file checked against its hash. Never holds more than kLargestPackBytes and their base64. An
/// error says what is wrong; it does not name the pack.
[[nodiscard]] core::Result<std::vector<PackedFile>> unpackLessons(const QByteArray& bytes);
[[nodiscard]] core::Result<std::vector<PackedFile>> readPack(const QString& file);

/// Writes all files into a folder, which is made if need be; what is there with the same content stays. Nothing is
/// written if a file of another content, or a link, is in the way.
[[nodiscard]] core::Status putInto(const QString& folder, const std::vector<PackedFile>& files);

/// The folder with the files of a pack, each checked, made when it is asked for first and found again by the pack's
/// hash: lessons are read from there. In the user's cache, so what is put into it is lost.
[[nodiscard]] core::Result<QString> openPack(const QString& file);

}  // namespace lessons
