// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <memory>

#include <QObject>
#include <QTimer>

#include "app/school/SchoolService.h"
#include "database/Address.h"

namespace app {

/// Makes one backup a day while the program runs. Checks when the database has been opened and then every hour whether
/// today's backup is due, so a failed backup is tried again after an hour. Ui thread.
class BackupSchedule final : public QObject
{
    Q_OBJECT

public:
    /// @param service        must outlive this object
    /// @param stationFolder  folder with this computer's own files
    BackupSchedule(SchoolService& service, database::Address address, QString stationFolder);
    /// Cancels a running backup.
    ~BackupSchedule() override;

    /// Starts the schedule, and makes today's backup if it is due.
    void start();
    /// Sets whether the school has no users yet. If so, no backups are made.
    void setEmpty(bool isEmpty) { m_isEmpty = isEmpty; }

signals:
    /// Emitted when today's backup could not be made.
    void failed(const core::Error& error);

private:
    void backUpToday();

    SchoolService& m_service;
    database::Address m_address;
    QString m_stationFolder;
    QTimer m_timer{this};
    bool m_isEmpty = false;
    bool m_isRunning = false;  ///< a backup is being made, which may take long on a slow disk
    std::shared_ptr<std::atomic<bool>> m_isStopped = std::make_shared<std::atomic<bool>>(false);
};

}  // namespace app
