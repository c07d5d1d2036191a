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

/// A lesson that can be given.
struct LessonOffer
{
    std::string id;
    QString title;
    QString tooth;  ///< "Lower left first molar (36)"
    QString group;  ///< that it stands under
    QString file;   ///< its own or its pack's; empty: it is shipped, and on every computer
};

/// One lesson of a class, as it was given and as it shall be; nothing: not given.
struct AssignmentChange
{
    std::optional<database::ClassAssignment> before;
    std::optional<database::ClassAssignment> after;
    bool operator==(const AssignmentChange&) const = default;
};

/// What a class is to do: beside all lessons, which are searched and given, several at once, those that are given, with
/// due date, attempts and how many have passed. What was done can be undone.
class AssignPage final : public kit::Page
{
    Q_OBJECT
public:
    AssignPage(const kit::Actions& actions, QWidget* parent);

    /// In the order in which they are to be listed.
    void setLessons(const std::vector<LessonOffer>& lessons);
    /// What a class is to do, and how far it is. Another class than before is begun with afresh.
    /// @param now  days are counted from here
    void setAssignments(const database::ClassOverview& overview, const QList<database::ClassAssignment>& given,
                        const QDateTime& now = QDateTime::currentDateTimeUtc());
    /// changeRequested() has been done: said, with a button that undoes it.
    void confirm(const QList<AssignmentChange>& changes);
    /// It has not, or not all of it, and why.
    void refuse(const QString& sentence);

    /// Somebody else works here: nothing is ticked, said or can be undone any more, and terms are as to begin with.
    void forget();

    [[nodiscard]] database::ClassId ofClass() const { return m_overview.id; }

signals:
    void changeRequested(const QList<ui::people::AssignmentChange>& changes);

protected:
    void showEvent(QShowEvent* event) override;

private:
    QWidget* makeOffers();
    QWidget* makeGiven();
    QWidget* makeFeet();
    void retell();
    void beginAfresh();
    void fillOffers();
    void search();
    void keepCurrentInSight();
    void fillGiven();
    void tellChosen();
    void tellWhere();
    void take(const QList<AssignmentChange>& changes);
    [[nodiscard]] std::vector<std::string> ticked() const;
    [[nodiscard]] QList<database::ClassAssignment> chosen() const;
    [[nodiscard]] QString titleOf(const std::string& lessonId) const;
    [[nodiscard]] std::set<std::size_t> usedUp(const database::ClassAssignment& given) const;

    std::vector<LessonOffer> m_lessons;
    database::ClassOverview m_overview;
    QList<database::ClassAssignment> m_given;
    QDateTime m_now;
    QList<AssignmentChange> m_last;  ///< can be undone
    bool m_isUndoing = false;
    bool m_isAsking = false;  ///< the answer is still to come
    bool m_hadFocus = false;  ///< what was pressed to ask

    QLabel* m_offersTitle = nullptr;
    QLineEdit* m_search = nullptr;
    QStandardItemModel* m_offers = nullptr;
    QListView* m_list = nullptr;
    QLabel* m_noneFits = nullptr;  ///< in its place
    AssignTerms* m_newTerms = nullptr;
    QLabel* m_where = nullptr;  ///< lessons are that are not shipped
    QPushButton* m_assign = nullptr;
    QLabel* m_givenTitle = nullptr;
    QStackedWidget* m_stack = nullptr;
    QStandardItemModel* m_rows = nullptr;
    kit::ListTable* m_table = nullptr;
    QLabel* m_empty = nullptr;
    AssignTerms* m_terms = nullptr;
    QPushButton* m_change = nullptr;
    QPushButton* m_takeBack = nullptr;
    QLabel* m_said = nullptr;
    std::function<QString()> m_saying;  ///< what stands there, in the language of today; empty: nothing of ours
    QPushButton* m_undo = nullptr;
};

}  // namespace ui::people
