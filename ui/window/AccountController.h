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

/// Manages the user of the window: login, guests, password, and the lock after a time without input.
class AccountController final : public QObject
{
    Q_OBJECT
public:
    AccountController(QWidget& window, const PracticeState& state, people::LoginPage& login, kit::Actions& actions,
                      Navigation& navigation, UnsavedWork& unsaved);

    [[nodiscard]] const database::Login& user() const { return m_user; }
    /// Sets the user. If the login page is shown, opens the page that waits behind it.
    void setUser(const database::Login& user);
    /// Returns whether a user has locked the window, so that another person may use the keyboard.
    [[nodiscard]] bool isLocked() const;
    /// Returns the full name of the user of a locked window; empty if it is not locked.
    [[nodiscard]] QString absentUser() const;

    /// Closes dialogs and questions, and opens the login page: for a login, the first user of a school, or another
    /// password.
    void ask(people::LoginMode mode);
    void askLogin() { ask(m_isNewSchool ? people::LoginMode::Welcome : people::LoginMode::Login); }
    /// Asks a guest to log in, and offers to save the guest's grade.
    void askLoginToKeep();
    /// Returns whether the guest's grade is to be saved for the user who logs in.
    [[nodiscard]] bool keepsOnLogin() const;
    void setNewSchool(bool isNew) { m_isNewSchool = isNew; }
    [[nodiscard]] bool isNewSchool() const { return m_isNewSchool; }
    void setOpening(bool isOpening);
    void refuse(const core::Error& error);
    void say(std::function<QString()> sentence);
    /// Shows on the login page that the database cannot be used, or that it can be used again.
    /// @param error       why the database cannot be used; nullopt: it can be used
    /// @param where       file or server of the database
    /// @param backupMade  time of the backup that can replace the database; invalid: there is none
    void setUnreachable(const std::optional<core::Error>& error, const QString& where, const QDateTime& backupMade);
    /// Logs a guest in, or locks the window.
    void change();
    /// Opens the login page for a change of the user's password.
    void changePassword();

    [[nodiscard]] IdleLock& idleLock() { return m_idle; }
    /// Records that the present guest sees a grade, which is theirs if they log in.
    void setGuestPresent() { m_isGuestGone = false; }
    void retranslateUi();

signals:
    /// Emitted when a guest requests to log in to save the grade that is shown.
    void keepRequested();
    /// Emitted when another user requests to log in on a locked window.
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
    QString m_where;                           ///< file or server of the database
    bool m_isNewSchool = false;
    bool m_isGuestGone = false;  ///< the idle time has passed since the guest saw the grade
};

}  // namespace ui::window
