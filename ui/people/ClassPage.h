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

/// A class as its teacher sees it: who needs him, every student's best score at every lesson, and of one lesson how the
/// class does: distribution, learning curve, difficulty.
class ClassPage final : public kit::Page
{
    Q_OBJECT
public:
    ClassPage(const kit::Actions& actions, QWidget* parent);

    /// Whether who looks at it enters people and makes classes.
    void setMayEnter(bool may);
    /// Those that are his. What is chosen stays, where it is among them.
    void setClasses(const QList<database::SchoolClass>& classes);
    /// Somebody else comes: nothing that was shown, searched and filtered stays.
    void forget();
    /// @param now  days are counted from here
    /// What is chosen and seen of the same class stays.
    void setOverview(const database::ClassOverview& overview, const QDateTime& now = QDateTime::currentDateTimeUtc());
    /// What the class is to do: when it is due, and who is late. After setOverview().
    void setAssignments(const QList<database::ClassAssignment>& given);
    /// The class that is chosen, or which there are, could not be read. Until it can be, that stands in its place;
    /// where it was read before, it stays.
    /// @param why  said again in another language
    void refuse(std::function<QString()> why);
    /// The class that is chosen is there; without a class, that there is none.
    [[nodiscard]] bool isRead() const { return m_isListed && m_model->overview().id == chosenClass(); }
    void setLessonTitles(const text::LessonTitles& titles);
    /// Of the lesson that is chosen.
    /// @param passMarkTenths  of its rubric; 0: not known
    /// @param criteria        names by id
    void setResults(const database::LessonResults& results, int passMarkTenths,
                    const std::map<std::string, QString>& criteria);

    [[nodiscard]] database::ClassId chosenClass() const;
    /// Empty: there is none.
    [[nodiscard]] QString chosenLesson() const;
    [[nodiscard]] charts::Table table() const { return m_model->table(); }
    /// Writes the matrix and says below it what became of that.
    bool saveTable(const QString& path);
    /// The matrix as a file, and what writes such a one and says what became of it.
    [[nodiscard]] QByteArray csv() const;
    bool save(const QString& path, const QByteArray& csv);
    void say(std::function<QString()> words);
    /// Asks for the class that is chosen once more: others work at it, too.
    void readAgain();

signals:
    /// Or it is to be read again.
    void classChosen(qint64 classId);
    /// Which classes there are is to be read: none is known.
    void listRequested();
    /// How the class does at it is wanted.
    void lessonChosen(const QString& lessonId);
    void attemptsRequested(qint64 personId, const QString& lessonId);
    /// All attempts of a student.
    void studentRequested(qint64 personId);
    void assignRequested();
    /// The page where people are entered and classes are made.
    void peopleRequested();
    void pdfRequested();
    /// save() is to follow.
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
    /// Of the matrix.
    struct Place
    {
        database::PersonId student;  ///< of the current cell
        std::string lesson;          ///< empty: its last attempt
        QPoint scrolled;
    };
    [[nodiscard]] Place place() const;
    void goTo(const Place& place);
    void takeLesson();
    void takeCell(const QModelIndex& index);
    void retell();
    void tellSaying();
    void tellNeeds();
    void tellEmpty();
    void search();
    void drawCharts();
    void fitColumns();
    void askForFile();

    QList<database::SchoolClass> m_classes;
    bool m_isListed = false;            ///< the classes are those that there are
    std::function<QString()> m_whyNot;  ///< the class that is chosen is not there, or which there are
    bool m_mayEnter = false;
    database::LessonResults m_results;
    int m_passMarkTenths = 0;
    std::map<std::string, QString> m_criteria;
    text::LessonTitles m_titles;
    ClassModel* m_model;
    ClassFilter* m_filter;
    QComboBox* m_class = nullptr;
    QLineEdit* m_search = nullptr;  ///< for a student
    QLabel* m_found = nullptr;      ///< how many are called so
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
    QPushButton* m_people = nullptr;  ///< below it
    QWidget* m_charts = nullptr;
    QLabel* m_lessonWord = nullptr;
    QComboBox* m_lesson = nullptr;
    QString m_lastLesson;  ///< that was chosen, also while there is none
    QLabel* m_said = nullptr;
    std::function<QString()> m_saying;
    charts::ChartPanel* m_distribution = nullptr;
    charts::ChartPanel* m_learning = nullptr;
    charts::ChartPanel* m_difficulty = nullptr;
};

}  // namespace ui::people
