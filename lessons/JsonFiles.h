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
/// Of the files of lessons and rubrics; the key "format".
inline constexpr int kLessonFormat = 1;
/// The folder of what we ship.
inline constexpr const char* kShippedFolder = ":/lessons/";

/// A name as a file may give it: of a file beside it or in a folder below. What leads elsewhere is none.
[[nodiscard]] bool isNameBeside(const QString& name);

/// "1.5 MB", "200 bytes".
[[nodiscard]] core::LocalizableText sizeWords(qint64 bytes);

/// What is wrong with a format from the future.
[[nodiscard]] core::LocalizableText newerFormat(double format);

/// The object that a JSON text holds; nothing, and faults, if it holds none, or says a key twice.
/// @param file  what the faults call it
[[nodiscard]] std::optional<QJsonObject> parseObject(QByteArray json, const QString& file,
                                                     std::vector<ValidationIssue>& faults);

/// An object with all that it is based on.
struct Gathered
{
    QJsonObject whole;
    std::vector<std::pair<QString, QJsonObject>> parts;  ///< the files it came from, the one that was asked for first

    /// The file in which a key of the whole stands ("rules.air_limit_s"); the first if none has it.
    [[nodiscard]] QString fileThatSays(const QString& key) const;
};

/// Gathers objects from files that are based on one another, and notes faults and names on the way. At most 8 files
/// follow one another.
class JsonFiles
{
public:
    /// @param faults  must outlive this
    explicit JsonFiles(std::vector<ValidationIssue>& faults) : m_faults(faults) {}

    /// Nothing, and a fault, if any of it cannot be read.
    [[nodiscard]] std::optional<Gathered> gather(const QString& file) { return gather(file, {}, {}); }
    /// The same of an object that would stand there.
    [[nodiscard]] std::optional<Gathered> underlaid(const QJsonObject& object, const QString& file)
    {
        return underlaid(object, file, QStringList{file});
    }
    /// Where a name in `file` leads: beside it, or to what we ship. Empty, and a fault, if it may not be named.
    [[nodiscard]] QString find(const QString& file, const QString& key, const QString& name);

    /// All that was read or found so far, but what we ship.
    [[nodiscard]] const QStringList& uses() const { return m_uses; }
    void note(const QString& file);
    /// A grave fault.
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
