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

/// The login page: name and password, setting up a school, or practice without a login.
class LoginPage final : public QWidget
{
    Q_OBJECT
public:
    explicit LoginPage(QWidget* parent);

    /// Resets the inputs and shows those of a mode. The name is not cleared between a one-time code and the new
    /// password.
    /// @param isIn  the user is logged in and may leave the page without an answer
    void ask(LoginMode door, bool isIn = false);
    [[nodiscard]] LoginMode door() const { return m_door; }
    /// Sets the user who locked the window, for LoginMode::Locked.
    /// @param inExam  an exam is running, and its time continues
    void setLockedBy(const QString& username, bool inExam);
    /// Shows why the database cannot be used. Empty: it can be used. Practice without a login is still possible.
    void setUnreachable(const QString& sentence);
    /// Sets whether the database is being opened. For a large file this takes seconds, during which no user can log in.
    void setOpening(bool isOpening);
    /// Shows the result of an operation that logged all users out, until the next ask().
    /// @param sentence  returns it in the current language; empty: no message
    void say(std::function<QString()> sentence);
    /// Offers to replace a damaged or missing database by a backup.
    /// @param made   time of the backup, UTC; invalid: no offer
    /// @param where  the database, for display
    void offerBackup(const QDateTime& made, const QString& where);
    /// Offers to save a guest's grade for the user who logs in.
    /// @param work  returns the name of the graded work in the current language; empty: no offer
    /// @param isTicked  the initial state: ticked right after grading
    void offerToKeep(std::function<QString()> work, bool isTicked = true);
    [[nodiscard]] bool keeps() const;
    /// Disables the inputs while a request is pending.
    void setBusy(bool busy);
    /// Shows the error of the last request.
    void refuse(std::function<QString()> sentence);
    /// Shows the error of a chosen password, and clears both of its inputs.
    void refuseNewPassword(std::function<QString()> sentence);

signals:
    void loginRequested(const QString& username, const QString& password);
    void codeRequested(const QString& username, const QString& code, const QString& newPassword);
    void schoolRequested(const database::NewPerson& admin, const QString& password);
    void guestRequested();
    /// Emitted when the user requests that the database is opened again.
    void againRequested();
    void restoreRequested();
    /// Emitted when another user than the one who locked the window wants to log in.
    void otherRequested();
    /// Emitted when the user leaves the page without changing the password.
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
    void showFault(std::function<QString()> sentence);
    void updateWaiting();
    /// Returns whether the names of a new school's admin are valid. Shows the error if they are not.
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
    std::map<QLineEdit*, QLabel*> m_captions;  ///< above each input
    QCheckBox* m_keep;
    std::function<QString()> m_kept;
    QLabel* m_fault;
    std::function<QString()> m_faultWords;  ///< empty: no error
    QLabel* m_waiting;                      ///< shown if a request takes long
    QTimer* m_untilTold;
    QPushButton* m_go;
    QPushButton* m_other;
    QPushButton* m_guest;
    QPushButton* m_change;  ///< the button that changes the user's own password
    QLabel* m_said;         ///< the result of an operation that logged all users out
    std::function<QString()> m_saying;
    QLabel* m_unreachable;
    QPushButton* m_tryAgain;
    QPushButton* m_restore;
    QDateTime m_backupMade;
    QString m_where;  ///< the database, for display
    QToolButton* m_language;
    QString m_code;  ///< the one-time code, typed as the password
};

}  // namespace ui::people
