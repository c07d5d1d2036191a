// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QElapsedTimer>
#include <QHash>
#include <QList>
#include <QSet>
#include <QString>
#include <QWidget>

#include "database/people.h"

class QComboBox;
class QFrame;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;
class QStandardItemModel;

namespace ui::shell {
class ScrollPane;
}
namespace ui::people {
class ListTable;
class WordFilter;
}  // namespace ui::people

namespace ui::admin {

class SecondThought;

/// Everybody of the school, and beside them a form for one: entering, changing, classes, a one-time code for who has
/// forgotten his password.
class PeoplePart final : public QWidget
{
    Q_OBJECT
public:
    explicit PeoplePart(QWidget* parent);

    /// Who is chosen stays chosen.
    void setPeople(const QList<database::Person>& people, const QList<database::SchoolClass>& classes);
    /// Lets a person in once; it is kept nowhere else, so his form shows it until it is used or the page is left.
    void showCode(database::PersonId person, const QString& fullName, const QString& code);
    /// The page is left, and perhaps by who made them.
    void forgetCodes();
    /// Whether the page may be left by Esc, perhaps one key too many: codes would be gone. No, the first time, and says
    /// so.
    [[nodiscard]] bool mayLeave();
    /// What was wanted has been done; the form is that of this person from now on.
    void confirm(database::PersonId person, const QString& sentence);
    void refuse(const QString& sentence);
    /// That somebody's form is half filled in, in a sentence. Empty: none is.
    [[nodiscard]] QString unkept() const;

signals:
    /// @param classes  to belong to
    void addWanted(const database::NewPerson& person, const QSet<qint64>& classes);
    void changeWanted(const database::Person& person, const QSet<qint64>& classes);
    void resetWanted(qint64 person);
    void classWanted(const QString& name);
    void classNameWanted(qint64 id, const QString& name);

private:
    /// What stands in a form and is not entered.
    struct Typed
    {
        qint64 person = 0;  ///< 0: somebody new
        QString username;
        QString given;
        QString family;
        int role = 0;
        QSet<qint64> classes;
    };
    struct Code
    {
        QString fullName;
        QString code;
    };

    QWidget* makeList();
    QWidget* makeForm();
    QWidget* makeAside(QWidget* parent);
    void speak();
    void fill();
    void fitColumns();
    void filter();
    void choose(qint64 person);
    void select(qint64 person);
    void putAside();
    void dropAside(const Typed& what);
    void tellAside();
    void bringBack();
    void fillClasses(const database::Person* person);
    void endThought();
    void showButtons(const database::Person* person);
    void showForm();
    void submit();
    void askToReset();
    void toggleDisabled();
    [[nodiscard]] const database::Person* find(qint64 person) const;
    [[nodiscard]] const database::Person* chosen() const { return find(m_chosen); }
    [[nodiscard]] QSet<qint64> tickedClasses() const;
    [[nodiscard]] Typed typed() const;
    [[nodiscard]] bool isHalfFilled() const;
    [[nodiscard]] QString asideWords(qint64 person) const;
    [[nodiscard]] bool isSecondClick() const;
    [[nodiscard]] QString stateOf(const database::Person& person) const;

    QList<database::Person> m_people;
    QList<database::SchoolClass> m_classes;
    qint64 m_chosen = 0;       ///< 0: somebody new
    qint64 m_inForm = 0;       ///< whom the form shows
    bool m_isTouched = false;  ///< something in it was changed by hand, and outlives news of what others have entered
    std::optional<Typed> m_submitted;  ///< what is on its way
    QElapsedTimer m_sinceSubmitted;
    QList<Typed> m_aside;         ///< when another row was chosen; the latest last
    QHash<qint64, Code> m_codes;  ///< by whom they let in
    QStandardItemModel* m_rows = nullptr;
    people::WordFilter* m_shown = nullptr;
    QLineEdit* m_search = nullptr;
    people::ListTable* m_table = nullptr;
    QLabel* m_count = nullptr;
    QPushButton* m_new = nullptr;
    shell::ScrollPane* m_pane = nullptr;
    QLabel* m_title = nullptr;
    QLabel* m_usernameWord = nullptr;
    QLabel* m_givenWord = nullptr;
    QLabel* m_familyWord = nullptr;
    QLabel* m_roleWord = nullptr;
    QLineEdit* m_username = nullptr;
    QLineEdit* m_given = nullptr;
    QLineEdit* m_family = nullptr;
    QComboBox* m_role = nullptr;
    QLabel* m_classesWord = nullptr;
    QListWidget* m_classList = nullptr;
    QLineEdit* m_className = nullptr;
    QPushButton* m_addClass = nullptr;
    QPushButton* m_renameClass = nullptr;
    QPushButton* m_save = nullptr;
    QPushButton* m_reset = nullptr;
    QPushButton* m_keepPassword = nullptr;
    QPushButton* m_disable = nullptr;
    SecondThought* m_thought = nullptr;  ///< whether the password is to be taken away
    QWidget* m_asideRow = nullptr;
    QLabel* m_asideWords = nullptr;
    QLabel* m_said = nullptr;
    QLabel* m_fault = nullptr;
    QFrame* m_codeCard = nullptr;
    QLabel* m_codeWords = nullptr;
    QLabel* m_code = nullptr;
    QPushButton* m_copy = nullptr;
    std::string m_classAdded;  ///< just now: it is ticked when it is there
};

}  // namespace ui::admin
