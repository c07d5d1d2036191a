// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <QDateTime>
#include <QList>
#include <QString>

#include "database/ClassOverview.h"
#include "database/Person.h"
#include "ui/kit/Page.h"
#include "ui/people/AssignTerms.h"

class QLabel;
class QLineEdit;
class QListView;
class QPushButton;
class QStackedWidget;
class QStandardItemModel;

namespace ui::kit {
class ListTable;
}

namespace ui::people {

/// A lesson that can be assigned.
struct LessonOffer
{
    std::string id;
    QString title;
    QString tooth;     ///< "Lower left first molar (36)"
    QString group;     ///< its heading in the list
    std::string hash;  ///< of this version (lessons::Lesson::hash)
    int version = 0;
};

/// A change of one assignment. Empty terms mean "not assigned".
struct AssignmentChange
{
    std::optional<database::ClassAssignment> before;
    std::optional<database::ClassAssignment> after;
    bool operator==(const AssignmentChange&) const = default;
};

/// The page where lessons are assigned to a class. It lists all lessons with a search, of which several can be assigned
/// at once, and the assigned ones with due date, attempts and the number of students who passed. The last change can be
/// undone.
class AssignPage final : public kit::Page
{
    Q_OBJECT
public:
    AssignPage(const kit::Actions& actions, QWidget* parent);

    /// @param lessons  in the order of the list
    void setLessons(const std::vector<LessonOffer>& lessons);
    /// Sets the class and its assignments. Resets the page if the class has changed.
    /// @param now  the time from which days are counted
    void setAssignments(const database::ClassOverview& overview, const QList<database::ClassAssignment>& given,
                        const QDateTime& now = QDateTime::currentDateTimeUtc());
    /// Shows that the requested changes have been made, with a button that undoes them.
    void confirm(const QList<AssignmentChange>& changes);
    /// Shows why some or all of the requested changes have failed.
    void refuse(const QString& sentence);

    /// Resets the page for another user: selection, messages, undo and terms.
    void forget();

    [[nodiscard]] database::ClassId ofClass() const { return m_overview.id; }

signals:
    void changeRequested(const QList<ui::people::AssignmentChange>& changes);

protected:
    void showEvent(QShowEvent* event) override;

private:
    QWidget* makeOffers();
    QWidget* makeGiven();
    void connectGiven();
    QWidget* makeFeet();
    void retell();
    void beginAfresh();
    void fillOffers();
    void search();
    void keepCurrentInSight();
    void fillGiven();
    void updateChosen();
    void updateLater();
    void take(const QList<AssignmentChange>& changes);
    [[nodiscard]] std::vector<LessonOffer> ticked() const;
    [[nodiscard]] QList<database::ClassAssignment> chosen() const;
    [[nodiscard]] QString titleOf(const std::string& lessonId) const;
    [[nodiscard]] const LessonOffer* laterVersionOf(const database::ClassAssignment& given) const;
    [[nodiscard]] std::set<std::size_t> usedUp(const database::ClassAssignment& given) const;

    std::vector<LessonOffer> m_lessons;
    database::ClassOverview m_overview;
    QList<database::ClassAssignment> m_given;
    QDateTime m_now;
    QList<AssignmentChange> m_last;  ///< the changes that can be undone
    bool m_isUndoing = false;
    bool m_isAsking = false;  ///< a request is pending
    bool m_hadFocus = false;  ///< the button that sent the request had the focus

    QLabel* m_offersTitle = nullptr;
    QLineEdit* m_search = nullptr;
    QStandardItemModel* m_offers = nullptr;
    QListView* m_list = nullptr;
    QLabel* m_noneFits = nullptr;  ///< shown instead of the list
    AssignTerms* m_newTerms = nullptr;
    QPushButton* m_assign = nullptr;
    QLabel* m_givenTitle = nullptr;
    QStackedWidget* m_stack = nullptr;
    QStandardItemModel* m_rows = nullptr;
    kit::ListTable* m_table = nullptr;
    QLabel* m_empty = nullptr;
    AssignTerms* m_terms = nullptr;
    QPushButton* m_change = nullptr;
    QPushButton* m_update = nullptr;  ///< assigns later versions of the chosen lessons
    QPushButton* m_takeBack = nullptr;
    QLabel* m_said = nullptr;
    std::function<QString()> m_saying;  ///< returns the message in the current language; empty: the message is not
                                        ///< translated again
    QPushButton* m_undo = nullptr;
};

}  // namespace ui::people
