// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/school/BackupSchedule.h"

#include <utility>

#include <QDateTime>

#include "app/school/DailyBackup.h"

namespace app {
namespace {

constexpr int kBackupPeriodMs = 3'600'000;

}  // namespace

BackupSchedule::BackupSchedule(SchoolService& service, database::Address address, QString stationFolder)
    : m_service(service), m_address(std::move(address)), m_stationFolder(std::move(stationFolder))
{
    m_timer.setObjectName(QStringLiteral("backupWatch"));
    m_timer.setInterval(kBackupPeriodMs);
    connect(&m_timer, &QTimer::timeout, this, &BackupSchedule::backUpToday);
}

BackupSchedule::~BackupSchedule()
{
    *m_isStopped = true;
}

void BackupSchedule::start()
{
    backUpToday();
    m_timer.start();
}

void BackupSchedule::backUpToday()
{
    const QDateTime now = QDateTime::currentDateTimeUtc();
    if (m_isRunning || m_isEmpty || !isBackupDue(m_address, now))
        return;
    m_isRunning = true;
    m_service.askDatabaseBeside(
        this,
        [address = m_address, folder = m_stationFolder, now,
         isStopped = m_isStopped](const database::sql::DatabaseContext& school) {
            return makeBackup(school, address, folder, now, [isStopped] { return !*isStopped; });
        },
        [this](const core::Result<QString>& made) {
            m_isRunning = false;
            if (!made)
                emit failed(made.error());
        });
}

}  // namespace app
