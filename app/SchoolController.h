// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <memory>
#include <optional>

#include <QObject>
#include <QString>
#include <QTimer>

#include "app/school/AttemptChecker.h"
#include "app/school/AttemptUploader.h"
#include "app/school/BackupSchedule.h"
#include "app/school/SchoolService.h"
#include "app/school/SchoolSession.h"
#include "database/Address.h"
#include "ui/window/MainWindow.h"

namespace app {

/// Whether an error means that the database could not be asked, which says nothing about who may log in.
[[nodiscard]] bool isUnreachable(core::ErrorCode code);

/// Opens the database of the school, restores its backups and makes the backup of the day. Shows the results on the
/// login page. Ui thread.
class SchoolController final : public QObject
{
    Q_OBJECT

public:
    struct Options
    {
        QString database;                          ///< a file or a server's address; empty: the user's own file
        database::sql::Database::Options opening;  ///< for tests
        std::chrono::milliseconds retry = SchoolService::kRetry;
        bool asksWho = false;  ///< the window begins at the login page, which shows errors itself
    };
    /// Both outlive the controller.
    SchoolController(ui::window::MainWindow& window, SchoolSession& school, Options options);
    ~SchoolController() override;

    /// Starts the service of the database. Returns false if the address is wrong; the window then says so. Without a
    /// database students can drill and are graded, but nothing is saved.
    bool openDatabase();
    /// Opens the school in it, and again later if it does not answer.
    void openSchool();
    /// Ends the service.
    void close();

    /// After openDatabase(); null before.
    [[nodiscard]] SchoolService* service() const { return m_service.get(); }
    [[nodiscard]] AttemptUploader* uploader() const { return m_uploader.get(); }
    [[nodiscard]] const database::Address& address() const { return *m_address; }
    /// Returns the folder of this computer's own files: journals, outbox, key.
    [[nodiscard]] const QString& stationFolder() const { return m_stationFolder; }
    [[nodiscard]] bool isServer() const { return m_address && m_address->isServer(); }
    /// Returns whether nobody on the network can read or change what is sent to the server.
    [[nodiscard]] bool isProtected() const { return !m_address || m_address->isProtected(); }
    [[nodiscard]] bool isOnNetworkDrive() const { return m_isOnNetworkDrive; }
    /// Returns why there is no database.
    [[nodiscard]] const core::Error& whyNone() const { return m_whyNone; }

    /// Shows why a login failed. If the file of the database is damaged, offers its newest backup.
    void refuseLogin(const core::Error& why);
    /// Replaces the database by a backup.
    /// @param who  requests it; a guest if nobody could log in
    void restore(const database::Login& who, const QString& backup);
    /// The school has its first user: restoring a backup is no longer offered.
    void endNewSchool();

signals:
    /// Emitted when the database has been opened.
    void opened();

private:
    void connectService();
    void beginChecks();
    void makeStationFolder() const;
    void takeOpening(const SchoolService::Opening& opening);
    void restore(const database::Login& who);

    ui::window::MainWindow& m_window;
    SchoolSession& m_school;
    Options m_options;
    std::optional<database::Address> m_address;
    core::Error m_whyNone;
    QString m_stationFolder;
    QString m_where;     ///< the address of the database, as it is shown
    QString m_backup;    ///< the newest backup, which can replace the database; empty: none
    QTimer m_openWatch;  ///< opens the database again after a failure that may pass
    bool m_isOnNetworkDrive = false;
    std::unique_ptr<SchoolService> m_service;
    std::unique_ptr<AttemptUploader> m_uploader;
    std::unique_ptr<BackupSchedule> m_backups;
    std::unique_ptr<AttemptChecker> m_checker;
};

}  // namespace app
