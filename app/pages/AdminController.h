// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>
#include <memory>

#include <QByteArray>
#include <QList>
#include <QObject>
#include <QSet>
#include <QString>

#include "app/school/SchoolAccess.h"
#include "app/school/UserQueries.h"
#include "core/base/Result.h"
#include "database/Address.h"
#include "database/IntegrityIssue.h"
#include "database/Person.h"
#include "ui/window/MainWindow.h"

namespace app {

/// Fills the page where an admin manages people, class lists, backups and the audit, and does what is requested there.
/// Long work runs on a connection of its own and can be stopped. Ui thread.
class AdminController final : public QObject
{
    Q_OBJECT

public:
    /// This computer and the place of its database.
    struct Place
    {
        database::Address address;
        QString stationFolder;
        std::function<QString()> hand;  ///< name of the device that moves the bur, in the user's language
        double servoHz = 0.0;
    };
    /// @param school  outlives this
    /// @param who     returns the present login
    AdminController(ui::window::MainWindow& window, SchoolAccess& school, Place place,
                    std::function<database::Login()> who);
    ~AdminController() override;

    /// Why a backup did not replace the database, as a sentence.
    [[nodiscard]] static QString whyNotRestored(const core::Error& error);

signals:
    /// Emitted when this backup is to replace the database, for which everybody is logged out.
    void restoreRequested(const QString& backup);
    /// Emitted when the school has another time after which an idle station is locked.
    void idleMinutesChanged(int minutes);

private:
    /// Returns false once long work is to stop.
    using GoesOn = std::function<bool()>;
    void refresh(int part);
    void showReadError(const core::Error& error);
    void connectPeople();
    void readPeople(const std::function<void()>& then = {});
    void addPerson(const database::NewPerson& person, const QSet<qint64>& classes);
    void changePerson(database::Person person, const QSet<qint64>& classes);
    void resetPassword(database::PersonId person);
    void erasePerson(database::PersonId person);
    void showClassChange(const QString& className, const core::Status& changed);
    void connectRoster();
    /// @param isOther  the admin wanted to enter the list, and its outcome has changed since it was shown
    void import(bool isDryRun, bool isOther = false);
    void connectBackups();
    void readBackups();
    void backUp();
    void restore(const QString& backup);
    void restoreAlone(const QString& backup);
    void showFailure(const core::Error& error);
    /// @param code  of a printed report; empty: there is none
    void check(const QString& code);
    void showReport(const database::CheckReport& report, const QString& code);
    void readAudit(qint64 beforeSeq);
    void connectStation();
    void readStation();
    /// @param job  takes Repositories, Login and GoesOn, returns a core::Result
    template <class Job, class Done>
    void runBeside(const QString& what, Job job, Done done);

    ui::window::MainWindow& m_window;
    UserQueries m_queries;
    Place m_place;
    QList<database::Person> m_people;
    QByteArray m_roster;
    QString m_rosterFile;
    database::RosterOutcome m_rosterSeen;  ///< outcome of the class list, as shown last
    std::shared_ptr<std::atomic<bool>> m_isStopped;
};

}  // namespace app
