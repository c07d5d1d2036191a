// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <functional>
#include <optional>

#include <QObject>

#include "core/base/Result.h"
#include "database/Person.h"
#include "ui/people/LoginMode.h"
#include "ui/window/IdleLock.h"
#include "ui/window/PracticeState.h"

class QDateTime;

namespace ui::kit {
class Actions;
}
namespace ui::people {
class LoginPage;
}

namespace ui::window {

class AccountMenu;
class Navigation;
class UnsavedWork;

/// The user of the window: login, guests, password, and the lock after a time without use.
class AccountController final : public QObject
{
    Q_OBJECT
public:
    AccountController(QWidget& window, const PracticeState& state, people::LoginPage& login, kit::Actions& actions,
                      Navigation& navigation, UnsavedWork& unsaved);

    [[nodiscard]] const database::Login& user() const { return m_user; }
    /// Sets the user. If the login page is shown, opens the page behind it.
    void setUser(const database::Login& user);
    /// Returns whether somebody else may be in front of the window of a user who locked it.
    [[nodiscard]] bool isLocked() const;
    /// Returns the full name of the user of a locked window; empty if it is not locked.
    [[nodiscard]] QString absentUser() const;

    /// Closes what is open over the window, and asks for a login, the first user of a school, or another password.
    void ask(people::LoginMode mode);
    void askLogin() { ask(m_isNewSchool ? people::LoginMode::Welcome : people::LoginMode::Login); }
    /// Asks a guest to log in, and offers to save the guest's grade.
    void askLoginToKeep();
    /// Returns whether the grade shall be saved for whoever logs in.
    [[nodiscard]] bool keepsOnLogin() const;
    void setNewSchool(bool isNew) { m_isNewSchool = isNew; }
    [[nodiscard]] bool isNewSchool() const { return m_isNewSchool; }
    void setOpening(bool isOpening);
    void refuse(const core::Error& error);
    void say(std::function<QString()> sentence);
    /// Tells whether the database cannot be used.
    /// @param where       its file or server
    /// @param backupMade  time of the backup that can replace it; invalid: there is none
    void setUnreachable(const std::optional<core::Error>& error, const QString& where, const QDateTime& backupMade);
    /// Logs a guest in, or locks the window.
    void change();
    /// Asks the user for another password.
    void changePassword();

    [[nodiscard]] IdleLock& idleLock() { return m_idle; }
    /// A grade is shown to the guest who is here.
    void setGuestPresent() { m_isGuestGone = false; }
    void retranslateUi();

signals:
    /// Emitted when a guest wants to log in to save the grade that is shown.
    void keepRequested();
    /// Emitted when the user lets somebody else log in.
    void logoutRequested();
    /// Emitted when actions and overlays need an update.
    void changed();

private:
    void showMenu();
    void closeAllOver();
    void lock();
    void showUnreachable();

    QWidget& m_window;
    const PracticeState& m_state;
    people::LoginPage& m_login;
    kit::Actions& m_actions;
    Navigation& m_navigation;
    UnsavedWork& m_unsaved;
    AccountMenu* m_menu;
    IdleLock m_idle;
    database::Login m_user;
    std::optional<core::Error> m_unreachable;  ///< why the database cannot be used
    QString m_where;                           ///< the database
    bool m_isNewSchool = false;
    bool m_isGuestGone = false;  ///< nobody has used the program for long since the guest's work was graded
};

}  // namespace ui::window
