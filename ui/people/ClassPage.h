// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <string>

#include <QDateTime>
#include <QList>
#include <QPoint>

#include "database/ClassOverview.h"
#include "database/Person.h"
#include "ui/kit/Page.h"
#include "ui/people/ClassModel.h"

class QButtonGroup;
class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QStackedWidget;
class QToolButton;

namespace ui::kit {
class ListTable;
}

namespace ui::charts {
class ChartPanel;
}

namespace ui::people {

/// The page of a class for its teacher: the students who need help, the best score of every student at every lesson,
/// and charts of the class at one lesson (distribution, learning curve, difficulty).
class ClassPage final : public kit::Page
{
    Q_OBJECT
public:
    ClassPage(const kit::Actions& actions, QWidget* parent);

    /// Sets whether the user may add people and classes.
    void setMayEnter(bool may);
    /// Sets the user's classes. The selection stays if it is among them.
    void setClasses(const QList<database::SchoolClass>& classes);
    /// Resets the page for another user: contents, search and filters.
    void forget();
    /// Sets the contents of a class. If the class is the same, selection and scroll position do not change.
    /// @param now  the time from which days are counted
    void setOverview(const database::ClassOverview& overview, const QDateTime& now = QDateTime::currentDateTimeUtc());
    /// Sets the assignments of the class. Call after setOverview().
    void setAssignments(const QList<database::ClassAssignment>& given);
    /// Shows why the class, or the list of classes, could not be read. Does nothing if the class has been read before.
    /// @param why  returns the reason in the current language
    void refuse(std::function<QString()> why);
    /// Returns whether the selected class has been read, or the list of classes if there is none.
    [[nodiscard]] bool isRead() const { return m_isListed && m_model->overview().id == chosenClass(); }
    void setLessonTitles(const text::LessonTitles& titles);
    /// Sets the results of the selected lesson.
    /// @param passMarkTenths  of its rubric; 0: unknown
    /// @param criteria        names by id
    void setResults(const database::LessonResults& results, int passMarkTenths,
                    const std::map<std::string, QString>& criteria);

    [[nodiscard]] database::ClassId chosenClass() const;
    /// Returns the id of the selected lesson; empty: none.
    [[nodiscard]] QString chosenLesson() const;
    [[nodiscard]] charts::Table table() const { return m_model->table(); }
    /// Writes the matrix to a file and shows the result below the matrix. Returns whether it succeeded.
    bool saveTable(const QString& path);
    /// csv() returns the matrix as CSV. save() writes such data to a file and shows the result.
    [[nodiscard]] QByteArray csv() const;
    bool save(const QString& path, const QByteArray& csv);
    void say(std::function<QString()> words);
    /// Requests the selected class again, because other users may have changed it.
    void readAgain();

signals:
    /// Emitted when a class was selected or must be read again.
    void classChosen(qint64 classId);
    /// Emitted when the list of classes must be read.
    void listRequested();
    /// Emitted when the results of a lesson are needed.
    void lessonChosen(const QString& lessonId);
    void attemptsRequested(qint64 personId, const QString& lessonId);
    /// Emitted when the user requests all attempts of a student.
    void studentRequested(qint64 personId);
    void assignRequested();
    /// Emitted when the user requests the page where people and classes are added.
    void peopleRequested();
    void pdfRequested();
    /// Emitted when the user has chosen a file for the table. The receiver calls save().
    void tableRequested(const QString& path);
    void printRequested();

protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QWidget* makeHead();
    QWidget* makeMatrix();
    QWidget* makeEmpty();
    QWidget* makeCharts();
    void fillLessons();
    void listClasses(const QList<database::SchoolClass>& classes);
    void fillClasses();
    void takeClass();
    void clear();
    /// A position in the matrix.
    struct Place
    {
        database::PersonId student;  ///< student of the current cell
        std::string lesson;          ///< empty: the column of the last attempt
        QPoint scrolled;
    };
    [[nodiscard]] Place place() const;
    void goTo(const Place& place);
    void takeLesson();
    void takeCell(const QModelIndex& index);
    void retell();
    void updateSaying();
    void updateNeeds();
    void updateEmpty();
    void search();
    void drawCharts();
    void fitColumns();
    void askForFile();

    QList<database::SchoolClass> m_classes;
    bool m_isListed = false;            ///< the list of classes has been read
    std::function<QString()> m_whyNot;  ///< why the class or the list could not be read
    bool m_mayEnter = false;
    database::LessonResults m_results;
    int m_passMarkTenths = 0;
    std::map<std::string, QString> m_criteria;
    text::LessonTitles m_titles;
    ClassModel* m_model;
    ClassFilter* m_filter;
    QComboBox* m_class = nullptr;
    QLineEdit* m_search = nullptr;  ///< search for a student
    QLabel* m_found = nullptr;      ///< the number of matches
    QLabel* m_needs = nullptr;
    QButtonGroup* m_need = nullptr;
    QPushButton* m_assign = nullptr;
    QToolButton* m_report = nullptr;
    QAction* m_saveCsv = nullptr;
    QAction* m_savePdf = nullptr;
    QAction* m_print = nullptr;
    QStackedWidget* m_stack = nullptr;
    kit::ListTable* m_table = nullptr;
    QLabel* m_legend = nullptr;
    QLabel* m_empty = nullptr;
    QPushButton* m_people = nullptr;  ///< below m_empty
    QWidget* m_charts = nullptr;
    QLabel* m_lessonWord = nullptr;
    QComboBox* m_lesson = nullptr;
    QString m_lastLesson;  ///< the lesson selected last, also if the class does not have it
    QLabel* m_said = nullptr;
    std::function<QString()> m_saying;
    charts::ChartPanel* m_distribution = nullptr;
    charts::ChartPanel* m_learning = nullptr;
    charts::ChartPanel* m_difficulty = nullptr;
};

}  // namespace ui::people
