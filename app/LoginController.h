// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <functional>

#include <QObject>
#include <QString>

#include "app/SchoolController.h"
#include "app/attempt/AttemptContext.h"
#include "app/attempt/GradingController.h"
#include "app/attempt/ResumeController.h"
#include "app/pages/LessonsController.h"
#include "app/pages/TourController.h"
#include "app/school/OfflineUnlock.h"
#include "database/Secret.h"

namespace app {

/// Logs users in and out, as students, instructors, admins or guests, and changes their passwords. Ui thread.
class LoginController final : public QObject
{
    Q_OBJECT

public:
    /// What a login works with besides the attempt; all of them outlive the controller.
    struct Others
    {
        SchoolSession& school;
        SchoolController& data;
        LessonsController& lessons;
        AttemptController& attempts;
        ResumeController& resume;
        GradingController& grading;
    };
    /// @param patience  how long the login waits for a database that hangs
    LoginController(const AttemptContext& context, const Others& others, std::chrono::milliseconds patience);

    /// Connects to the database's service, which has been started.
    void connectService();
    /// Sets the tour that new users are shown; null: none.
    void setTour(TourController* tour) { m_tour = tour; }
    /// Logs out, and replaces the database by a backup.
    void leaveToRestore(const QString& backup);

signals:
    /// Emitted while a user is logged out, before the window shows the login page.
    void left();

private:
    void readIdleLimit();
    void changePassword(const QString& old, const QString& password);
    void connectWindow();
    void ask(const std::function<core::Result<database::Login>(const database::Repositories&)>& work,
             const std::function<void(const core::Error&)>& refuse = {});
    void readOwnHash();
    void unlockOffline(const database::Secret& password, const core::Error& why);
    void enter(const database::Login& who);
    void raisePasswordCost();
    void leave();
    void leaveIfRoleChanged();
    void updateMayEdit();
    void becomeGuest();
    AttemptContext m_context;
    SchoolSession& m_school;
    SchoolController& m_data;
    LessonsController& m_lessons;
    AttemptController& m_attempts;
    ResumeController& m_resume;
    GradingController& m_grading;
    std::chrono::milliseconds m_patience;
    TourController* m_tour = nullptr;
    OfflineUnlock m_unlock;
    int m_turn = 0;  ///< grows when nobody waits for an answer on the login page any more
    bool m_hasTimedCost = false;
    bool m_keepsOnLogin = false;  ///< the grade that a guest was shown is saved for the user who logs in now
};

}  // namespace app
