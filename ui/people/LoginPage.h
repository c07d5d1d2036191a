// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>

#include <QDateTime>
#include <QString>
#include <QWidget>

#include "database/Person.h"
#include "ui/people/LoginMode.h"

class QCheckBox;
class QFrame;
class QLabel;
class QLineEdit;
class QPushButton;
class QTimer;
class QToolButton;
class QVBoxLayout;

namespace ui::people {

class WelcomeChoices;

/// The door: name and password, or a school that is to be created, or practice without a login.
class LoginPage final : public QWidget
{
    Q_OBJECT
public:
    explicit LoginPage(QWidget* parent);

    /// Empties what was typed, but for the name where it goes on being asked of the same person.
    /// @param isIn  who sees it has been let in and may go on without an answer
    void ask(LoginMode door, bool isIn = false);
    [[nodiscard]] LoginMode door() const { return m_door; }
    /// Who has left his place, for LoginMode::Locked.
    /// @param inExam  whose time goes on
    void setLockedBy(const QString& username, bool inExam);
    /// The database cannot be used: why. Practice without a login still works. Empty: it can.
    void setUnreachable(const QString& sentence);
    /// The school's data are being opened; of a large file that takes seconds, in which nobody can be let in.
    void setOpening(bool isOpening);
    /// How something ended that everybody was logged out for; it stands until somebody is asked anew.
    /// @param sentence  in the language of the moment; empty: nothing is said
    void say(std::function<QString()> sentence);
    /// A backup of then, UTC, can be put in the place of a database that is damaged or gone; invalid: there is none.
    /// @param where  the database, to read
    void offerBackup(const QDateTime& made, const QString& where);
    /// A guest's grade becomes that of who logs in, unless he says that it is not his.
    /// @param work  of what it is, in the language of the moment; empty: there is none
    /// @param isTicked  to begin with: who asks for it has just been graded
    void offerToKeep(std::function<QString()> work, bool isTicked = true);
    [[nodiscard]] bool keeps() const;
    /// What was typed is being looked at: nothing can be typed meanwhile.
    void setBusy(bool busy);
    /// Says what was wrong, beside where it was typed.
    void refuse(std::function<QString()> sentence);
    /// The same of a password that was chosen: both of its inputs begin anew.
    void refuseNewPassword(std::function<QString()> sentence);

signals:
    void loginRequested(const QString& username, const QString& password);
    void codeRequested(const QString& username, const QString& code, const QString& newPassword);
    void schoolRequested(const database::NewPerson& admin, const QString& password);
    void guestRequested();
    /// The database that cannot be used is to be tried again.
    void againRequested();
    void restoreRequested();
    /// Not who has locked the place.
    void otherRequested();
    /// Who changes his password leaves it as it is, and was let in already.
    void leaveRequested();
    void passwordChangeRequested(const QString& old, const QString& newPassword);

protected:
    void showEvent(QShowEvent* event) override;

private:
    QLineEdit* field(const char* name, bool isPassword);
    void fillCard();
    void addButtons();
    void connectInputs();
    void arrange();
    [[nodiscard]] QWidget* firstInput() const;
    void retranslateUi();
    void nameQuestion();
    void submit();
    void tellFault(std::function<QString()> sentence);
    void tellWaiting();
    /// Of a new school's admin; else says what is wrong.
    [[nodiscard]] bool areNamesFit();

    LoginMode m_door = LoginMode::Login;
    bool m_isIn = false;
    bool m_isBusy = false;
    bool m_isOpening = false;
    QString m_lockedBy;
    bool m_isLockedInExam = false;
    QFrame* m_card;
    QVBoxLayout* m_column;
    QLabel* m_title;
    QLabel* m_words;
    WelcomeChoices* m_choices;
    QLineEdit* m_name;
    QLineEdit* m_given;
    QLineEdit* m_family;
    QLineEdit* m_old;
    QLineEdit* m_password;
    QLineEdit* m_again;
    std::map<QLineEdit*, QLabel*> m_captions;  ///< above each
    QCheckBox* m_keep;
    std::function<QString()> m_kept;
    QLabel* m_fault;
    std::function<QString()> m_faultWords;  ///< empty: nothing is wrong
    QLabel* m_waiting;                      ///< for what, where it takes longer
    QTimer* m_untilTold;
    QPushButton* m_go;
    QPushButton* m_other;
    QPushButton* m_guest;
    QPushButton* m_change;  ///< of one's own password
    QLabel* m_said;         ///< how something ended that everybody was logged out for
    std::function<QString()> m_saying;
    QLabel* m_unreachable;
    QPushButton* m_tryAgain;
    QPushButton* m_restore;
    QDateTime m_backupMade;
    QString m_where;  ///< the database, to read
    QToolButton* m_language;
    QString m_code;  ///< that was typed as the password
};

}  // namespace ui::people
