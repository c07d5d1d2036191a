// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>

#include <QAbstractTableModel>
#include <QDateTime>
#include <QFontMetrics>
#include <QHeaderView>
#include <QSortFilterProxyModel>
#include <QStyledItemDelegate>
#include <QTableView>

#include "database/ClassOverview.h"
#include "database/Person.h"
#include "ui/charts/Table.h"
#include "ui/text/PeopleTexts.h"

namespace ui::people {

/// The reason why a student needs help.
enum class Need {
    Nothing,
    NoneLeft,       ///< no attempts left at an assigned lesson that is not passed: only the teacher can help
    Stuck,          ///< lessons::needsHelp() at the lesson tried last
    NeverLoggedIn,  ///< may be unable to log in
    Late,           ///< an assigned lesson is overdue and not passed
    NotBegun        ///< has logged in, but has no graded attempt
};

/// Returns whether the exam that the student began last may still be running. A cancelled exam is not recorded, so only
/// its time limit decides.
[[nodiscard]] bool mayGoOn(const database::MatrixCell& cell, const QDateTime& now);

/// Returns the most urgent need of a student.
/// @param hasNoneLeft, isLate  at any lesson
[[nodiscard]] Need needOf(const database::MatrixStudent& student, bool hasNoneLeft, bool isLate);
/// Returns "out of tries", "stuck", "no login", "late" or "new"; empty for no need.
[[nodiscard]] QString needWord(Need need);
/// Returns the full name, or the user name if there is none.
[[nodiscard]] QString nameOf(const database::MatrixStudent& student);
/// Elides a row heading of ClassModel to a width. Elides the name first, and never the sign and the word of the need.
[[nodiscard]] QString shortened(const QString& head, const QFontMetrics& metrics, int widthPx);

/// A class as a matrix: a row for each student; a column for the last attempt and one for each lesson.
class ClassModel final : public QAbstractTableModel
{
    Q_OBJECT
public:
    static constexpr int kLast = 0;         ///< column of the last attempt
    static constexpr int kFirstLesson = 1;  ///< columns before the first lesson

    explicit ClassModel(QObject* parent) : QAbstractTableModel(parent) {}

    /// @param now  the time from which days are counted
    void setOverview(const database::ClassOverview& overview, const QDateTime& now);
    /// Sets the assignments of the class; those of other classes are ignored. Call after setOverview().
    void setAssignments(const QList<database::ClassAssignment>& given);
    void setTitles(const text::LessonTitles& titles);
    /// Updates all texts after the language has changed.
    void retell();

    [[nodiscard]] const database::ClassOverview& overview() const { return m_overview; }
    /// Returns whether a student has this need. Late also applies to students with a more urgent need.
    [[nodiscard]] bool needs(int row, Need need) const;
    /// Returns the number of students with this need.
    [[nodiscard]] int count(Need need) const;
    /// How many students passed a lesson, and how many tried it.
    struct Passed
    {
        int passed = 0;
        int tried = 0;
    };
    [[nodiscard]] Passed passed(std::size_t lesson) const;
    [[nodiscard]] const database::MatrixCell* cell(const QModelIndex& index) const;
    /// Returns whether the lesson is overdue and this student has not passed it.
    [[nodiscard]] bool isLate(const QModelIndex& index) const;
    /// Returns whether this student has used all attempts at the lesson without passing. False while the last attempt
    /// may still be running.
    [[nodiscard]] bool hasNoneLeft(const QModelIndex& index) const;
    /// Returns whether any lesson has a due date.
    [[nodiscard]] bool hasDueDates() const;
    /// Returns the index into the overview's lessons; empty for the column of the last attempt.
    [[nodiscard]] static std::optional<std::size_t> lessonOf(int column);
    /// Returns the whole matrix: names, needs, last attempt, and the best score and number of attempts for each lesson.
    [[nodiscard]] charts::Table table() const;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    [[nodiscard]] QString cellWords(const QModelIndex& index) const;
    [[nodiscard]] QString markOf(int row) const;
    [[nodiscard]] QString headWords(std::size_t lesson, bool isTip) const;
    [[nodiscard]] bool isLate(std::size_t student, std::size_t lesson) const;
    [[nodiscard]] bool hasNoneLeft(std::size_t student, std::size_t lesson) const;
    void findNeeds();

    database::ClassOverview m_overview;
    std::map<std::string, database::ClassAssignment> m_given;  ///< by lesson
    QList<Need> m_needs;
    QList<bool> m_areLate;
    text::LessonTitles m_titles;
    QDateTime m_now;
};

/// Filters students by need and name. Sorts by value; students without one come last.
class ClassFilter final : public QSortFilterProxyModel
{
    Q_OBJECT
public:
    explicit ClassFilter(ClassModel* source);

    /// @param need  Nothing: all students
    void setNeed(Need need);
    /// @param words  of a name or a user name; empty: all students
    void setWords(const QString& words);
    void sort(int column, Qt::SortOrder order) override;

protected:
    [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex& parent) const override;
    [[nodiscard]] bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;

private:
    ClassModel* m_source;
    Need m_need = Need::Nothing;
    QString m_words;
    bool m_isDescending = false;
};

/// The row headings of the matrix.
class NameHeads final : public QHeaderView
{
public:
    explicit NameHeads(QTableView* table);

protected:
    void initStyleOptionForIndex(QStyleOptionHeader* option, int logicalIndex) const override;
};

/// Draws a cell of the matrix: the best score on a background that is stronger for higher scores, with a tick if the
/// lesson was passed; a dash if it was not tried.
class ScoreCell final : public QStyledItemDelegate
{
    Q_OBJECT
public:
    ScoreCell(const QSortFilterProxyModel* filter, const ClassModel* model, QObject* parent)
        : QStyledItemDelegate(parent), m_filter(filter), m_model(model)
    {}
    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;

private:
    const QSortFilterProxyModel* m_filter;
    const ClassModel* m_model;
};

}  // namespace ui::people
