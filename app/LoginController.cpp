// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/LoginController.h"

#include <string>
#include <utility>

#include <QTimer>

#include "app/school/SchoolService.h"
#include "app/school/SchoolSettings.h"
#include "app/threads/Background.h"
#include "database/Passwords.h"
#include "database/Repositories.h"
#include "ui/people/LoginPage.h"
#include "ui/scoring/ScorePage.h"

namespace app {

using database::Secret;
using ui::window::MainWindow;

LoginController::LoginController(const AttemptContext& context, const Others& others,
                                 std::chrono::milliseconds patience)
    : m_context(context), m_school(others.school), m_data(others.data), m_lessons(others.lessons),
      m_attempts(others.attempts), m_resume(others.resume), m_grading(others.grading), m_patience(patience)
{
    connectWindow();
    connect(&m_data, &SchoolController::opened, this, [this] {
        m_context.presets.setSchool(m_school.service);
        updateMayEdit();
    });
}

void LoginController::connectService()
{
    SchoolService* const service = m_data.service();
    connect(service, &SchoolService::isBack, this, [this] {
        if (m_school.user.isGuest())
            return;
        m_context.presets.refresh();
        m_context.window.readAgain();
    });
    connect(service, &SchoolService::disabled, this, [this] {
        if (m_school.user.isGuest())  // has been logged out already
            return;
        leave();
        m_context.window.account().say(
            [] { return tr("This account was disabled, and you were logged out. Ask an admin."); });
    });
    connect(service, &SchoolService::refused, this, &LoginController::leaveIfRoleChanged);
    connect(service, &SchoolService::otherSchool, this, [this] {
        const bool wasIn = !m_school.user.isGuest();
        if (wasIn)
            leave();
        m_data.service()->takeOtherSchool();
        m_data.openSchool();
        if (wasIn)
            m_context.window.account().say(
                [] { return tr("Your login has ended, or another school is now where yours was. Log in again."); });
    });
    updateMayEdit();
}

void LoginController::leaveToRestore(const QString& backup)
{
    const database::Login who = m_school.user;
    leave();
    m_data.restore(who, backup);
}

/// The idle limit is a setting of the school.
void LoginController::readIdleLimit()
{
    m_school.service->ask(
        this, [who = m_school.user](const database::Repositories& school) { return school.settings.read(who); },
        [this](const core::Result<database::SettingsMap>& settings) {
            if (settings)
                m_context.window.account().idleLock().setLimit(std::chrono::minutes(idleMinutesOf(*settings)));
        });
}

void LoginController::changePassword(const QString& old, const QString& password)
{
    m_school.service->ask(
        this,
        [who = m_school.user, old = Secret(old), next = Secret(password)](const database::Repositories& school) {
            return school.logins.changePassword(who, old.text(), next.text());
        },
        [this](const core::Status& done) {
            if (!done) {
                m_context.window.account().refuse(done.error());
                return;
            }
            readOwnHash();
            m_context.window.setWho(m_school.user);
            m_context.window.showMessage(tr("Your password was changed."));
        });
}

void LoginController::connectWindow()
{
    using ui::window::MainWindow;
    connect(&m_context.window.loginPage(), &ui::people::LoginPage::loginRequested, this,
            [this](const QString& name, const QString& password) {
                ask([name = name.toStdString(), password = Secret(password)](
                        const database::Repositories& school) { return school.logins.login(name, password.text()); },
                    [this, isOwner = name.toStdString() == m_school.user.username(),
                     password = Secret(password)](const core::Error& why) {
                        if (isOwner && isUnreachable(why.code))
                            unlockOffline(password, why);
                        else
                            m_data.refuseLogin(why);
                    });
            });
    connect(&m_context.window.loginPage(), &ui::people::LoginPage::codeRequested, this,
            [this](const QString& name, const QString& code, const QString& password) {
                ask([name = name.toStdString(), code = Secret(code),
                     password = Secret(password)](const database::Repositories& school) {
                    return school.logins.redeem(name, code.text(), password.text());
                });
            });
    connect(&m_context.window.loginPage(), &ui::people::LoginPage::schoolRequested, this,
            [this](const database::NewPerson& admin, const QString& password) {
                ask(
                    [admin, password = Secret(password)](const database::Repositories& school) {
                        return school.logins.createFirstAdmin(admin, password.text());
                    },
                    [this](const core::Error& why) {
                        if (why.code == core::ErrorCode::NotAllowed) {  // another computer was faster
                            m_data.endNewSchool();
                            updateMayEdit();
                            m_context.window.account().askLogin();
                        }
                        m_context.window.account().refuse(why);
                    });
            });
    connect(&m_context.window.loginPage(), &ui::people::LoginPage::guestRequested, this, &LoginController::becomeGuest);
    connect(&m_context.window.account(), &ui::window::AccountController::logoutRequested, this,
            &LoginController::leave);
    connect(&m_context.window.loginPage(), &ui::people::LoginPage::passwordChangeRequested, this,
            &LoginController::changePassword);
    const auto logInToKeep = [this] {
        m_keepsOnLogin = true;
        m_context.window.account().askLoginToKeep();
    };
    connect(&m_context.window.account(), &ui::window::AccountController::keepRequested, this, logInToKeep);
    connect(&m_context.window.scorePage(), &ui::scoring::ScorePage::keepRequested, this, logInToKeep);
}

/// Logs in the user that the database returns. Ignores an answer that arrives after the user has left the login page:
/// by then somebody else may sit there.
/// @param refuse  handles an error; empty: the login page shows it
void LoginController::ask(const std::function<core::Result<database::Login>(const database::Repositories&)>& work,
                          const std::function<void(const core::Error&)>& refuse)
{
    const auto answer = [this, refuse, turn = ++m_turn](const core::Result<database::Login>& who) {
        if (turn != m_turn || !m_context.window.navigation().isAtLogin()) {
            if (who && m_context.window.account().isNewSchool())
                m_data.endNewSchool();
            return;
        }
        ++m_turn;
        if (who)
            enter(*who);
        else if (refuse)
            refuse(who.error());
        else
            m_data.refuseLogin(who.error());
    };
    if (!m_school.service) {
        answer(tl::unexpected(m_data.whyNone()));
        return;
    }
    m_school.service->ask(this, work, answer);
    // A server that hangs never answers. A file answers sooner or later: it may be large, and its disk busy. But a user
    // who has work behind the login page does not have to wait for it.
    if (m_data.isServer() || !m_school.user.isGuest())
        QTimer::singleShot(m_patience, this, [answer, isServer = m_data.isServer()] {
            answer(core::unexpected(isServer ? core::ErrorCode::ConnectionLost : core::ErrorCode::Busy,
                                    "there was no answer"));
        });
}

void LoginController::readOwnHash()
{
    m_school.service->ask(
        this, [who = m_school.user](const database::Repositories& school) { return school.logins.ownHash(who); },
        [this, who = m_school.user](const core::Result<std::string>& hash) {
            if (hash && m_school.user == who)
                m_unlock.setHash(*hash);
        });
}

/// Lets the user who locked the window return to their work while the database cannot be reached.
/// @param why  it cannot be reached
void LoginController::unlockOffline(const database::Secret& password, const core::Error& why)
{
    if (!m_unlock.isPossible()) {
        m_data.refuseLogin(why);
        return;
    }
    if (const auto wait = m_unlock.wait(); wait.count() > 0) {
        m_context.window.account().refuse({core::ErrorCode::TooSoon, "wait " + std::to_string(wait.count()) + " s"});
        return;
    }
    inBackground(
        this, [password, hash = m_unlock.hash()] { return database::fits(password.text(), hash); },
        [this, who = m_school.user](const core::Result<bool>& fits) {
            if (m_school.user != who)
                return;
            if (fits && *fits) {
                enter(who);
                return;
            }
            m_unlock.reject();
            m_context.window.account().refuse(fits ? core::Error{core::ErrorCode::WrongLogin, "the password is wrong"}
                                                   : fits.error());
        });
}

/// Handles that a user has logged in, or has unlocked the window.
void LoginController::enter(const database::Login& who)
{
    m_unlock.resetTries();
    if (who.person() == m_school.user.person()) {
        m_school.user = who;  // a server may have ended the earlier login
        m_context.window.setWho(who);
        return;
    }
    if (m_context.window.account().isNewSchool())
        m_data.endNewSchool();
    m_school.user = who;
    m_lessons.forget();
    m_unlock.setHash({});
    readOwnHash();
    m_attempts.forgetFeelByHand();
    m_context.presets.refresh();
    // Work of a guest belongs to nobody, unless they log in to save its grade.
    const bool keeps =
        std::exchange(m_keepsOnLogin, false) && m_context.window.account().keepsOnLogin() && m_grading.isGuests();
    if (keeps)
        m_attempts.notePerson();
    else if (m_context.attempt.hasTooth())
        m_attempts.beginWholeTooth();
    m_context.window.setWho(who);
    updateMayEdit();
    readIdleLimit();
    m_resume.startJournal();
    if (keeps)
        m_grading.saveGuestsGrade();
    else
        m_context.window.openHome();
    if (m_tour != nullptr && !keeps)
        m_tour->welcome(m_school.service, m_school.user);
    if (who.role() == database::Role::Admin && m_school.service)
        raisePasswordCost();
    if (m_data.isOnNetworkDrive() && who.role() == database::Role::Admin)
        m_context.window.showWarning(
            tr("The school's database is on a network drive, where only one computer at a time can "
               "use it. For several computers, use a PostgreSQL server."));
    if (!m_data.isProtected() && (who.role() == database::Role::Admin || who.role() == database::Role::Instructor))
        m_context.window.showWarning(
            tr("The connection to the school's server is not protected: someone on the network "
               "can read or change names and marks. Ask whoever looks after the server."));
}

/// Passwords are hashed at a cost that suits today's computers.
void LoginController::raisePasswordCost()
{
    if (std::exchange(m_hasTimedCost, true))
        return;
    inBackground(
        this, [] { return database::timedCost(); },
        [this](const database::PasswordCost& cost) {
            m_school.service->ask(
                this,
                [who = m_school.user, cost](const database::Repositories& school) {
                    return school.logins.raiseCost(who, cost);
                },
                [](const core::Status&) {});
        });
}

/// Logs out. The attempt stays on the disk, in the user's folder, and is offered when they are back.
void LoginController::leave()
{
    if (m_school.service && !m_school.user.isGuest())
        m_school.service->ask(
            this, [who = m_school.user](const database::Repositories& school) { return school.logins.logout(who); },
            [](const core::Status&) {});
    // A saved attempt is not offered again. The note in its journal may be on its way still, for example during a
    // replay.
    m_resume.stopJournal(m_grading.isSaved());
    m_context.loads.begin();  // a tooth that is being made for them opens for nobody else
    m_context.window.stopBusy();
    m_school.user = {};
    m_lessons.forget();
    m_unlock.setHash({});
    m_unlock.resetTries();
    m_attempts.forgetFeelByHand();
    m_context.presets.refresh();
    m_context.window.leaveAll();
    emit left();
    m_context.window.setWho(m_school.user);
    updateMayEdit();
    m_attempts.beginWholeTooth();
    m_context.window.account().askLogin();
}

/// The window shows the pages of the role that the user had when they logged in.
void LoginController::leaveIfRoleChanged()
{
    if (m_school.user.isGuest())
        return;
    m_school.service->ask(
        this, [who = m_school.user](const database::Repositories& school) { return school.logins.role(who); },
        [this, who = m_school.user](const core::Result<database::Role>& now) {
            if (!now || m_school.user != who || *now == who.role())
                return;
            leave();
            m_context.window.account().say(
                [] { return tr("Your role was changed, and you were logged out. Log in again."); });
        });
}

/// In a school only instructors and admins edit lessons.
void LoginController::updateMayEdit()
{
    const bool teaches =
        m_school.user.role() == database::Role::Instructor || m_school.user.role() == database::Role::Admin;
    m_context.window.setMayEdit(!m_school.service || m_context.window.account().isNewSchool() || teaches);
}

void LoginController::becomeGuest()
{
    ++m_turn;
    m_keepsOnLogin = false;
    m_context.window.setWho(m_school.user);
    if (m_resume.isRunning())  // they have only looked at the login page
        return;
    m_resume.startJournal();
    if (m_tour != nullptr)
        m_tour->welcome(nullptr, m_school.user);
}

}  // namespace app
