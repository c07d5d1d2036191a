// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>

#include "lessons/LessonReader.h"
#include "tests/support/Files.h"

namespace support {

inline QString sentencesOf(const lessons::ReadLesson& read)
{
    QStringList all;
    for (const lessons::ValidationIssue& fault : read.faults)
        all << fault.sentence();
    return all.join(u'\n');
}

/// Returns whether the lesson was read without faults.
[[nodiscard]] inline bool isSound(const lessons::ReadLesson& read)
{
    if (!read.faults.empty())
        qWarning("%s", qPrintable(sentencesOf(read)));
    return read.lesson && read.faults.empty();
}

/// Returns whether one of the faults contains these words.
[[nodiscard]] inline bool says(const lessons::ReadLesson& read, const QString& words)
{
    const bool is = sentencesOf(read).contains(words);
    if (!is)
        qWarning("%s", qPrintable(sentencesOf(read)));
    return is;
}

/// A temporary folder of lesson files.
class LessonFolder
{
public:
    [[nodiscard]] QString path() const { return m_folder.path(); }
    [[nodiscard]] QString at(const QString& name) const { return m_folder.filePath(name); }
    QString write(const QString& name, const QByteArray& content) const
    {
        support::write(at(name), content.toStdString());
        return at(name);
    }
    QString write(const QString& name, const QJsonObject& object) const
    {
        return write(name, QJsonDocument(object).toJson());
    }
    /// Writes a file and reads it as a lesson.
    template <class Content>
    [[nodiscard]] lessons::ReadLesson read(const QString& name, const Content& content) const
    {
        return lessons::readLesson(write(name, content));
    }

private:
    QTemporaryDir m_folder;
};

}  // namespace support
