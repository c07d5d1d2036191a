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
#include "ui/admin/TypedPerson.h"

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

/// The people of the school, and a form to add or change a person, their classes, and a one-time code if they have
/// forgotten the password.
class PeoplePart final : public QWidget
{
    Q_OBJECT
public:
    explicit PeoplePart(QWidget* parent);

    /// Returns a sentence in the current language.
    using Words = std::function<QString()>;

    /// Sets the people and classes. Keeps the selection.
    void setPeople(const QList<database::Person>& people, const QList<database::SchoolClass>& classes);
    /// Shows a one-time code, with which the person can log in once. No plain copy of it is stored, so the form shows
    /// it until it is used or replaced, or the user logs out.
    void showCode(const database::Person& person, const QString& code);
    /// Shows that the request has succeeded, and selects this person unless the form contains other changes.
    void confirm(database::PersonId person, const Words& sentence);
    void refuse(const Words& sentence);
    /// Shows that a class was added or renamed.
    void confirmClass(const QString& name);
    /// Shows why a class could not be added or renamed. Keeps the typed name.
    void refuseClass(const Words& sentence);

    /// Sets the uid of the admin who is logged in; empty: none.
    void setAdmin(const QString& uid) { m_admin = uid; }
    /// Returns a description of an unsaved form and the one-time codes on display. Empty if there are none.
    [[nodiscard]] QString unsavedChanges() const;
    void discardChanges();

signals:
    /// Emitted when the user adds a person.
    /// @param classes  ids of the person's classes
    void addRequested(const database::NewPerson& person, const QSet<qint64>& classes);
    void changeRequested(const database::Person& person, const QSet<qint64>& classes);
    void resetRequested(qint64 person);
    /// Emitted when the user has confirmed that a person is to be erased.
    void eraseRequested(qint64 person);
    void classRequested(const QString& name);
    void classNameRequested(qint64 id, const QString& name);

private:
    struct Code
    {
        QString fullName;
        QString code;
        std::string untilUtc;
        bool isCopied = false;
    };
    /// Changes that need a confirmation.
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
    void askToErase();
    [[nodiscard]] const database::Person* find(qint64 person) const;
    [[nodiscard]] const database::Person* chosen() const { return find(m_chosen); }
    [[nodiscard]] QSet<qint64> tickedClasses() const;
    void rebase(const database::Person& now, const TypedPerson& typed);
    void write(const TypedPerson& typed);
    [[nodiscard]] TypedPerson typed() const;
    [[nodiscard]] bool isHalfFilled() const;
    [[nodiscard]] QString formWords() const;
    [[nodiscard]] bool isOwn(const database::Person* person) const;
    [[nodiscard]] bool isSecondClick() const;
    [[nodiscard]] QString stateOf(const database::Person& person, const std::string& nowUtc) const;

    QList<database::Person> m_people;
    QList<database::SchoolClass> m_classes;
    QString m_admin;
    qint64 m_chosen = 0;        ///< id; 0: a new person
    database::Person m_inForm;  ///< the person of the form, as it was when the form was filled; without an id: a new
                                ///< person
    bool m_isTouched = false;   ///< the user has changed the form; a reload of the people keeps the changes
    std::optional<TypedPerson> m_submitted;  ///< the pending request
    QElapsedTimer m_sinceSubmitted;
    QHash<qint64, Code> m_codes;  ///< by person id
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
    QPushButton* m_keep = nullptr;  ///< cancels the change while it is being confirmed
    QPushButton* m_disable = nullptr;
    QPushButton* m_erase = nullptr;
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
    std::string m_classAdded;  ///< requested, and ticked once it is in the list
};

}  // namespace ui::admin
