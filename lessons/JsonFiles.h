// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <QByteArray>
#include <QJsonObject>
#include <QString>
#include <QStringList>

#include "lessons/ValidationIssue.h"

namespace lessons {

inline constexpr qint64 kLargestLessonBytes = qint64{1} << 20;
/// The key "format" of lessons and rubrics.
inline constexpr int kLessonFormat = 1;
/// The folder of the shipped files.
inline constexpr const char* kShippedFolder = ":/lessons/";

/// Returns whether a name refers to a file in the folder of the file that names it, or in a folder below. Other names
/// are not allowed.
[[nodiscard]] bool isNameBeside(const QString& name);

/// Returns a size such as "1.5 MB" or "200 bytes".
[[nodiscard]] core::LocalizableText sizeWords(qint64 bytes);

/// Returns the error for a format from a newer program.
[[nodiscard]] core::LocalizableText newerFormat(double format);

/// Parses a JSON object. Empty, with faults, if the text is no object or has a key twice.
/// @param file  its name in the faults
[[nodiscard]] std::optional<QJsonObject> parseObject(QByteArray json, const QString& file,
                                                     std::vector<ValidationIssue>& faults);

/// An object merged with all objects that it is based on.
struct Gathered
{
    QJsonObject whole;
    std::vector<std::pair<QString, QJsonObject>> parts;  ///< the files it came from, the requested one first

    /// Returns the file that contains a key of the merged object ("rules.air_limit_s"); the first if none does.
    [[nodiscard]] QString fileThatSays(const QString& key) const;
};

/// Merges objects from files that are based on one another, and collects faults and file names. A chain has at most 8
/// files.
class JsonFiles
{
public:
    /// @param faults  must outlive this
    explicit JsonFiles(std::vector<ValidationIssue>& faults) : m_faults(faults) {}

    /// Reads and merges a file. Empty, with a fault, if any of the files cannot be read.
    [[nodiscard]] std::optional<Gathered> gather(const QString& file) { return gather(file, {}, {}); }
    /// Merges an object as if it were the content of that file.
    [[nodiscard]] std::optional<Gathered> underlaid(const QJsonObject& object, const QString& file)
    {
        return underlaid(object, file, QStringList{file});
    }
    /// Returns the path of a file that `file` names: beside it, or a shipped file. Empty, with a fault, if the name is
    /// not allowed.
    [[nodiscard]] QString find(const QString& file, const QString& key, const QString& name);

    /// Returns all files read or found so far, without shipped ones.
    [[nodiscard]] const QStringList& uses() const { return m_uses; }
    void note(const QString& file);
    /// Adds a grave fault, which makes the lesson unusable.
    void say(const QString& file, const QString& key, core::LocalizableText what)
    {
        m_faults.push_back({file, key, std::move(what), true});
    }

private:
    [[nodiscard]] std::optional<Gathered> gather(const QString& file, const QString& namedIn, QStringList way);
    [[nodiscard]] std::optional<Gathered> underlaid(const QJsonObject& object, const QString& file,
                                                    const QStringList& way);
    [[nodiscard]] std::optional<QJsonObject> read(const QString& file, std::vector<ValidationIssue>& faults);

    std::vector<ValidationIssue>& m_faults;
    QStringList m_uses;
};

}  // namespace lessons
