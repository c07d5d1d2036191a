// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <memory>

#include <QObject>
#include <QTimer>

#include "app/school/SchoolService.h"
#include "database/Address.h"

namespace app {

/// Makes the backup of the day, while the program is used: after the database was opened, and every hour while the
/// window stays open. A backup that failed is tried again an hour later. Ui thread.
class BackupSchedule final : public QObject
{
    Q_OBJECT

public:
    /// @param service        outlives this
    /// @param stationFolder  of this computer's own files
    BackupSchedule(SchoolService& service, database::Address address, QString stationFolder);
    /// Stops a backup that is being made.
    ~BackupSchedule() override;

    /// Starts the schedule, and makes today's backup if it is due.
    void start();
    /// Sets whether the school has no users yet: then there is nothing to back up.
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
    bool m_isRunning = false;  ///< a slow disk may take long
    std::shared_ptr<std::atomic<bool>> m_isStopped = std::make_shared<std::atomic<bool>>(false);
};

}  // namespace app
