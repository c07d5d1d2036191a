// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include <QElapsedTimer>
#include <QHash>
#include <QList>
#include <QModelIndex>
#include <QSet>
#include <QString>
#include <QWidget>

#include "database/Person.h"

class QComboBox;
class QFrame;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;
class QVBoxLayout;

namespace ui::kit {
class ListTable;
class ScrollPane;
class InlineConfirmation;
class WordFilter;
}  // namespace ui::kit

namespace ui::admin {

class PeopleModel;

/// Everybody of the school, and beside them a form for one: entering, changing, classes, a one-time code for who has
/// forgotten his password.
class PeoplePart final : public QWidget
{
    Q_OBJECT
public:
    explicit PeoplePart(QWidget* parent);

    /// A sentence in the language there is.
    using Words = std::function<QString()>;

    /// Who is chosen stays chosen.
    void setPeople(const QList<database::Person>& people, const QList<database::SchoolClass>& classes);
    /// Lets a person in once; it is kept nowhere else, so their form shows it until it is used, another is made, or the
    /// user logs out.
    void showCode(const database::Person& person, const QString& code);
    /// What was wanted has been done; the form is that of this person from now on.
    void confirm(database::PersonId person, const Words& sentence);
    void refuse(const Words& sentence);
    /// The same of a class that was added, or has another name now.
    void confirmClass(const QString& name);
    /// The name that was typed stays, to be corrected.
    void refuseClass(const Words& sentence);

    /// The admin who is logged in, by uid; empty: none.
    void setAdmin(const QString& uid) { m_admin = uid; }
    /// Describes a form that is not saved, and one-time codes that are shown. Empty: neither.
    [[nodiscard]] QString unsavedChanges() const;
    void discardChanges();

signals:
    /// @param classes  to belong to
    void addRequested(const database::NewPerson& person, const QSet<qint64>& classes);
    void changeRequested(const database::Person& person, const QSet<qint64>& classes);
    void resetRequested(qint64 person);
    void classRequested(const QString& name);
    void classNameRequested(qint64 id, const QString& name);

private:
    /// What stands in a form and is not entered.
    struct Typed
    {
        database::Person asItWas;  ///< whom it is about, when it was filled; without an id: somebody new
        QString username;
        QString given;
        QString family;
        int role = 0;
        QSet<qint64> classes;

        [[nodiscard]] qint64 person() const { return asItWas.id.value; }
    };
    struct Code
    {
        QString fullName;
        QString code;
        std::string untilUtc;
        bool isCopied = false;
    };
    /// What is asked before it is done.
    enum class Question { Password, OwnRole, OwnAccount };

    QWidget* makeList();
    QWidget* makeForm();
    QWidget* makeCodeCard(QWidget* form);
    void addFields(QVBoxLayout* column, QWidget* form);
    void addClassFields(QVBoxLayout* column, QWidget* form);
    void addButtons(QVBoxLayout* stack, QWidget* whole);
    void connectForm();
    void connectClasses();
    void addClass();
    void keepAsItIs();
    void retranslateUi();
    void fill();
    void filter();
    void showFound();
    [[nodiscard]] QModelIndex rowOf(qint64 person) const;
    void choose(qint64 person);
    void select(qint64 person);
    void fillClasses(const QSet<qint64>& wanted);
    void endThought();
    [[nodiscard]] bool isAnswered(Question question);
    void say(const Words& sentence, const Words& fault = {});
    void showButtons(const database::Person* person);
    void showForm();
    void submit();
    void askToReset();
    void toggleDisabled();
    [[nodiscard]] const database::Person* find(qint64 person) const;
    [[nodiscard]] const database::Person* chosen() const { return find(m_chosen); }
    [[nodiscard]] QSet<qint64> tickedClasses() const;
    [[nodiscard]] static Typed asEntered(const database::Person& person);
    [[nodiscard]] static Typed onto(const database::Person& now, const Typed& typed);
    void rebase(const database::Person& now, const Typed& typed);
    void write(const Typed& typed);
    [[nodiscard]] Typed typed() const;
    [[nodiscard]] bool isHalfFilled() const;
    [[nodiscard]] QString formWords() const;
    [[nodiscard]] bool isOwn(const database::Person* person) const;
    [[nodiscard]] bool isSecondClick() const;
    [[nodiscard]] QString stateOf(const database::Person& person, const std::string& nowUtc) const;

    QList<database::Person> m_people;
    QList<database::SchoolClass> m_classes;
    QString m_admin;
    qint64 m_chosen = 0;        ///< 0: somebody new
    database::Person m_inForm;  ///< the person in the form, as they were when it was filled; no id: a new person
    bool m_isTouched = false;   ///< something in it was changed by hand, and outlives news of what others have entered
    std::optional<Typed> m_submitted;  ///< what is on its way
    QElapsedTimer m_sinceSubmitted;
    QHash<qint64, Code> m_codes;  ///< by whom they let in
    PeopleModel* m_rows = nullptr;
    kit::WordFilter* m_shown = nullptr;
    QLineEdit* m_search = nullptr;
    kit::ListTable* m_table = nullptr;
    QLabel* m_count = nullptr;
    QPushButton* m_new = nullptr;
    kit::ScrollPane* m_pane = nullptr;
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
    QPushButton* m_keep = nullptr;  ///< what is asked about
    QPushButton* m_disable = nullptr;
    kit::InlineConfirmation* m_thought = nullptr;
    Question m_question = Question::Password;
    QLabel* m_said = nullptr;
    QLabel* m_fault = nullptr;
    Words m_sentence;
    Words m_faultSentence;
    QFrame* m_codeCard = nullptr;
    QLabel* m_codeWords = nullptr;
    QLabel* m_code = nullptr;
    QPushButton* m_copy = nullptr;
    std::string m_classAdded;  ///< just now: it is ticked when it is there
};

}  // namespace ui::admin
