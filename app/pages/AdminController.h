// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>
#include <memory>

#include <QObject>
#include <QString>

#include "app/school/SchoolService.h"
#include "database/Person.h"
#include "database/sql/Check.h"
#include "ui/window/MainWindow.h"

namespace app {

/// Fills the page where an admin keeps people, class lists, backups and the audit, and does what is wanted there. Long
/// work is done on a connection of its own and can be stopped. Ui thread.
class AdminController final : public QObject
{
    Q_OBJECT

public:
    /// Of the computer and its database.
    struct Place
    {
        database::Address address;
        QString stationFolder;
        std::function<QString()> hand;  ///< that moves the bur, in the user's language
        double servoHz = 0.0;
    };
    AdminController(ui::window::MainWindow& window, SchoolService& desk, Place place,
                    std::function<database::Login()> who);
    ~AdminController() override;

    /// Why a backup was not put in the place of the school.
    [[nodiscard]] static QString whyNotRestored(const core::Error& error);

signals:
    /// Everybody is to be logged out and this backup put in the place of the database.
    void restoreRequested(const QString& backup);
    /// Another limit holds from now on.
    void idleMinutesChanged(int minutes);

private:
    /// Of long work: false once it is to be stopped.
    using GoesOn = std::function<bool()>;
    void refresh(int part);
    void refuse(const core::Error& error);
    void connectPeople();
    void tellPeople(const std::function<void()>& then = {});
    void connectRoster();
    /// @param isOther  it was to be entered, and would do something else by now than was seen
    void import(bool isDryRun, bool isOther = false);
    void connectBackups();
    void tellBackups();
    void restoreAlone(const QString& backup);
    void tellFailed(const core::Error& error);
    /// @param code  of a report; empty: there is none
    void check(const QString& code);
    void tellChecked(const database::sql::CheckReport& report, const QString& code);
    void tellAudit(qint64 beforeSeq);
    void tellStation();
    /// @param job  takes School and GoesOn, answers core::Result
    template <class Job, class Done>
    void beside(const QString& what, Job job, Done done);

    ui::window::MainWindow& m_window;
    SchoolService& m_desk;
    Place m_place;
    std::function<database::Login()> m_who;
    QList<database::Person> m_people;
    QByteArray m_roster;
    QString m_rosterFile;
    database::RosterOutcome m_rosterSeen;  ///< what the list would do, as it was shown last
    std::shared_ptr<std::atomic<bool>> m_isStopped;
};

}  // namespace app
