// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include <QAbstractTableModel>
#include <QList>
#include <QSortFilterProxyModel>

#include "database/AttemptRecord.h"
#include "ui/text/PeopleTexts.h"

namespace ui::people {

/// A table of attempts, in the order given.
class HistoryModel final : public QAbstractTableModel
{
    Q_OBJECT
public:
    enum Column { When, Lesson, Score, Result, Time, Force, Feedback, Columns };

    explicit HistoryModel(QObject* parent) : QAbstractTableModel(parent) {}

    void setAttempts(const QList<database::AttemptRecord>& attempts);
    /// Sets the attempts that other users have commented on.
    /// @param isNew  by attempt: whether the student has not read the comments
    /// @param isOwn  the user is that student
    void setFeedback(std::map<std::int64_t, bool> isNew, bool isOwn);
    void setTitles(const text::LessonTitles& titles);
    /// Updates all texts after the language has changed.
    void retell();
    [[nodiscard]] const database::AttemptRecord& at(int row) const { return m_attempts[row]; }
    [[nodiscard]] const text::LessonTitles& titles() const { return m_titles; }

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    [[nodiscard]] QString words(const database::AttemptRecord& attempt, int column) const;

    QList<database::AttemptRecord> m_attempts;
    std::map<std::int64_t, bool> m_feedback;
    bool m_isOwn = true;
    text::LessonTitles m_titles;
};

/// Filters attempts by lesson. Sorts by value, not by text.
class HistoryFilter final : public QSortFilterProxyModel
{
    Q_OBJECT
public:
    explicit HistoryFilter(HistoryModel* source);

    /// @param lessonId  empty: all lessons
    void setLesson(const std::optional<std::string>& lessonId);

protected:
    [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex& parent) const override;
    [[nodiscard]] bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;

private:
    HistoryModel* m_source;
    std::optional<std::string> m_lesson;
};

}  // namespace ui::people
