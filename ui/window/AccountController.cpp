// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/AccountController.h"

#include <utility>

#include <QAbstractButton>
#include <QAction>
#include <QDateTime>
#include <QWidget>

#include "ui/kit/Actions.h"
#include "ui/kit/ConfirmOverlay.h"
#include "ui/people/LoginPage.h"
#include "ui/text/Texts.h"
#include "ui/window/AccountMenu.h"
#include "ui/window/Navigation.h"
#include "ui/window/UnsavedWork.h"

namespace ui::window {

using people::LoginMode;
using people::LoginPage;

AccountController::AccountController(QWidget& window, const PracticeState& state, LoginPage& login,
                                     kit::Actions& actions, Navigation& navigation, UnsavedWork& unsaved)
    : QObject(&window), m_window(window), m_state(state), m_login(login), m_actions(actions), m_navigation(navigation),
      m_unsaved(unsaved), m_menu(new AccountMenu(actions, &window)), m_idle(IdleLock::steadyClock(), nullptr)
{
    connect(m_actions.account, &QAction::triggered, this, &AccountController::showMenu);
    connect(m_actions.lock, &QAction::triggered, this, &AccountController::change);
    connect(m_menu, &AccountMenu::passwordRequested, this, &AccountController::changePassword);
    connect(&m_idle, &IdleLock::expired, this, &AccountController::lock);
    // leaveWork() is not needed: the user's attempt is stored and offered to them at their next login.
    connect(&m_login, &LoginPage::otherRequested, this,
            [this] { m_unsaved.leaveChanges([this] { emit logoutRequested(); }, absentUser()); });
}

void AccountController::setUser(const database::Login& user)
{
    m_user = user;
    m_actions.showAccount(QString::fromStdString(user.username()));
    m_actions.attempts->setVisible(!user.isGuest());
    m_actions.school->setVisible(user.role() == database::Role::Admin);
    m_actions.classes->setVisible(user.role() == database::Role::Instructor || user.role() == database::Role::Admin);
    m_actions.readAgain->setVisible(!user.isGuest());
    if (m_navigation.isAtLogin()) {
        m_navigation.setMayLeaveLogin(true);
        m_navigation.leaveLogin();
    }
}

bool AccountController::isLocked() const
{
    return m_navigation.isAtLogin() && !m_navigation.mayLeaveLogin() && !m_user.isGuest();
}

QString AccountController::absentUser() const
{
    return isLocked() ? QString::fromStdString(m_user.fullName()) : QString();
}

void AccountController::ask(LoginMode mode)
{
    closeAllOver();
    m_login.setLockedBy(QString::fromStdString(m_user.username()), m_state.isExamRunning() && !m_state.isOver);
    m_login.offerToKeep({});
    m_login.ask(mode);
    m_navigation.openLogin();
}

void AccountController::askLoginToKeep()
{
    askLogin();
    m_login.offerToKeep([this] { return m_state.title(); }, !m_isGuestGone);
}

bool AccountController::keepsOnLogin() const
{
    return m_login.keeps();
}

void AccountController::setOpening(bool isOpening)
{
    m_login.setOpening(isOpening);
}

void AccountController::refuse(const core::Error& error)
{
    if (error.code == core::ErrorCode::NewPassword)
        m_login.ask(LoginMode::NewPassword);
    else if (error.code == core::ErrorCode::WrongLogin && m_login.door() == LoginMode::NewPassword)
        m_login.refuse([] { return tr("The one-time code is no longer valid. Ask an admin for a new one."); });
    else if (error.code == core::ErrorCode::OutOfRange)
        m_login.refuseNewPassword([error] { return text::loginFault(error); });
    else
        m_login.refuse([error] { return text::loginFault(error); });
}

void AccountController::say(std::function<QString()> sentence)
{
    m_login.say(std::move(sentence));
}

void AccountController::setUnreachable(const std::optional<core::Error>& error, const QString& where,
                                       const QDateTime& backupMade)
{
    m_unreachable = error;
    m_where = where;
    showUnreachable();
    m_login.offerBackup(backupMade, where);
}

void AccountController::showUnreachable()
{
    m_login.setUnreachable(m_unreachable
                               ? text::errorText(*m_unreachable, text::FailedOperation::KeepingGrades) + u'\n' + m_where
                               : QString());
}

void AccountController::retranslateUi()
{
    if (m_unreachable)
        showUnreachable();
}

/// Opens the menu below the user's name.
void AccountController::showMenu()
{
    const auto* button = m_navigation.current()->findChild<QAbstractButton*>(QStringLiteral("accountButton"));
    if (m_user.isGuest() || m_navigation.isAtLogin() || button == nullptr)
        change();
    else
        m_menu->popup(button->mapToGlobal(QPoint(button->width() - m_menu->sizeHint().width(), button->height())));
}

void AccountController::change()
{
    if (!m_user.isGuest()) {
        ask(LoginMode::Locked);
    } else if (m_navigation.isAtLogin()) {
        if (m_navigation.mayLeaveLogin())
            m_navigation.leaveLogin();
    } else if (m_state.isGraded && m_unsaved.isAsGraded() && m_navigation.isAtScore()) {
        emit keepRequested();
    } else {
        // The user who logs in does not get the guest's work.
        m_unsaved.leaveWork([this] {
            m_unsaved.leaveChanges(
                [this] {
                    askLogin();
                    m_navigation.setMayLeaveLogin(true);
                    emit changed();
                },
                absentUser());
        });
    }
}

void AccountController::changePassword()
{
    ask(LoginMode::OwnPassword);
    m_login.ask(LoginMode::OwnPassword, true);
    m_navigation.setMayLeaveLogin(true);
    emit changed();
}

/// Closes questions and dialogs, which would stay usable over the login page.
void AccountController::closeAllOver()
{
    m_unsaved.forgetAction();
    for (auto* question : m_window.findChildren<kit::ConfirmOverlay*>(QString(), Qt::FindDirectChildrenOnly)) {
        question->hide();
        question->setObjectName({});
        question->deleteLater();  // an answer to it may have called this function
    }
    for (QWidget* one : m_window.findChildren<QWidget*>())
        if (one->isWindow() && one->isVisible())
            one->close();
}

/// Locks the window, or ends the offer to save a guest's grade. Called when the idle time has passed.
void AccountController::lock()
{
    if (!m_user.isGuest() && (!m_navigation.isAtLogin() || m_navigation.mayLeaveLogin()))
        ask(LoginMode::Locked);
    else if (m_login.keeps())  // the next person to log in is probably another one
        m_login.offerToKeep({});
    else if (m_user.isGuest())
        m_isGuestGone = true;
}

}  // namespace ui::window
