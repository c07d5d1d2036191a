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

/// Why a student needs his teacher.
enum class Need {
    Nothing,
    NoneLeft,       ///< no attempts left at a lesson that he was given and has not passed: he cannot go on
    Stuck,          ///< lessons::needsHelp() at the lesson he tried last
    NeverLoggedIn,  ///< perhaps he cannot
    Late,           ///< a lesson that he was given is overdue, and he has not passed it
    NotBegun        ///< he has logged in, and not had an attempt graded yet
};

/// Whether the exam that a student has begun last may go on still: nobody tells when he breaks it off.
[[nodiscard]] bool mayGoOn(const database::MatrixCell& cell, const QDateTime& now);

/// @param hasNoneLeft, isLate  with any lesson
[[nodiscard]] Need needOf(const database::MatrixStudent& student, bool hasNoneLeft, bool isLate);
/// "out of tries", "stuck", "no login", "late", "new"; empty for nothing.
[[nodiscard]] QString needWord(Need need);
/// The full name, or the user name where there is none.
[[nodiscard]] QString nameOf(const database::MatrixStudent& student);
/// A name as ClassModel heads its row, where it is too long: of the name is left out first, and the sign behind it,
/// with the word of what is needed, is kept.
[[nodiscard]] QString shortened(const QString& head, const QFontMetrics& metrics, int widthPx);

/// A class as a matrix: students down, with their names as headings; the last attempt and then a column for each lesson
/// across.
class ClassModel final : public QAbstractTableModel
{
    Q_OBJECT
public:
    static constexpr int kLast = 0;         ///< column of the last attempt
    static constexpr int kFirstLesson = 1;  ///< columns before the first lesson

    explicit ClassModel(QObject* parent) : QAbstractTableModel(parent) {}

    /// @param now  days are counted from here
    void setOverview(const database::ClassOverview& overview, const QDateTime& now);
    /// What the class is to do; others' assignments are left out. After setOverview().
    void setAssignments(const QList<database::ClassAssignment>& given);
    void setTitles(const text::LessonTitles& titles);
    void retell();

    [[nodiscard]] const database::ClassOverview& overview() const { return m_overview; }
    /// Late are also those who have no attempts left, are stuck or have never logged in.
    [[nodiscard]] bool needs(int row, Need need) const;
    /// How many need so.
    [[nodiscard]] int count(Need need) const;
    /// Nothing for the column of the last attempt.
    /// How many of those who tried a lesson have passed it.
    struct Passed
    {
        int passed = 0;
        int tried = 0;
    };
    [[nodiscard]] Passed passed(std::size_t lesson) const;
    [[nodiscard]] const database::MatrixCell* cell(const QModelIndex& index) const;
    /// The lesson is overdue, and has not been passed by this student.
    [[nodiscard]] bool isLate(const QModelIndex& index) const;
    /// This student has made as many attempts at the lesson as he may, and passed none; the last may not go on still.
    [[nodiscard]] bool hasNoneLeft(const QModelIndex& index) const;
    /// Some lesson has a day when it is due.
    [[nodiscard]] bool hasDueDates() const;
    /// Index into the overview's lessons.
    [[nodiscard]] static std::optional<std::size_t> lessonOf(int column);
    /// The whole matrix: names, what they need, last attempt, and of each lesson the best score and how often.
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

/// All students, or those who need something or are called so; sorted by value, those who have none last.
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

/// The names beside the matrix.
class NameHeads final : public QHeaderView
{
public:
    explicit NameHeads(QTableView* table);

protected:
    void initStyleOptionForIndex(QStyleOptionHeader* option, int logicalIndex) const override;
};

/// A cell of the matrix: the best score on a ground that is the fuller the higher it is, with a tick where the lesson
/// was passed; a dash where it was not tried.
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
