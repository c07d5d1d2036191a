// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/SchoolController.h"

#include <utility>

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QLocale>
#include <QStandardPaths>

#include "app/pages/AdminController.h"
#include "database/sql/Backups.h"
#include "ui/people/LoginPage.h"

namespace app {
namespace {

using ui::text::FailedOperation;
using ui::window::MainWindow;

QString dataFolder()
{
    return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
}

/// Whether an error is about the file of the database itself.
bool isOfTheFile(core::ErrorCode code)
{
    using core::ErrorCode;
    return code == ErrorCode::FileMissing || code == ErrorCode::FileUnreadable || code == ErrorCode::FileUnwritable ||
           code == ErrorCode::BadStructure || code == ErrorCode::WrongKind;
}

}  // namespace

bool isUnreachable(core::ErrorCode code)
{
    using core::ErrorCode;
    return code == ErrorCode::ConnectionLost || code == ErrorCode::ServerRefuses || code == ErrorCode::ServerUnknown ||
           code == ErrorCode::Busy || code == ErrorCode::OpenElsewhere || isOfTheFile(code);
}

SchoolController::SchoolController(MainWindow& window, SchoolSession& school, Options options)
    : m_window(window), m_school(school), m_options(std::move(options))
{}

SchoolController::~SchoolController()
{
    close();
}

void SchoolController::close()
{
    m_checker.reset();
    m_backups.reset();
    m_uploader.reset();
    m_school.service = nullptr;
    m_service.reset();
}

bool SchoolController::openDatabase()
{
    const QString where =
        m_options.database.isEmpty() ? QDir(dataFolder()).filePath(QStringLiteral("cusp.sqlite")) : m_options.database;
    const auto address = database::Address::parse(where);
    if (!address) {
        m_whyNone = address.error();
        m_window.showError(m_whyNone, FailedOperation::KeepingGrades, where);
        return false;
    }
    m_where = address->isServer() ? address->shown() : QDir::toNativeSeparators(address->file);
    m_stationFolder = address->isServer() ? dataFolder() : QFileInfo(address->file).absolutePath();
    m_address = *address;
    makeStationFolder();
    m_window.lessonEditing().setRecoveryFolder(m_stationFolder);
    m_service = std::make_unique<SchoolService>(*address, m_stationFolder, m_options.opening, m_options.retry);
    m_school.service = m_service.get();
    m_uploader = std::make_unique<AttemptUploader>(*m_service);
    m_backups = std::make_unique<BackupSchedule>(*m_service, *address, m_stationFolder);
    m_backups->setParent(this);
    connectService();
    beginChecks();
    connect(m_backups.get(), &BackupSchedule::failed, this, [this](const core::Error& error) {
        if (m_school.user.role() == database::Role::Admin)
            m_window.showMessage(
                tr("Today's backup was not made. %1").arg(ui::text::errorText(error, FailedOperation::ReadingSchool)));
    });
    m_openWatch.setInterval(m_options.retry);
    connect(&m_openWatch, &QTimer::timeout, this, &SchoolController::openSchool);
    connect(&m_window.loginPage(), &ui::people::LoginPage::againRequested, this, &SchoolController::openSchool);
    connect(&m_window.loginPage(), &ui::people::LoginPage::restoreRequested, this, [this] { restore(m_school.user); });
    return true;
}

void SchoolController::connectService()
{
    SchoolService* const service = m_service.get();
    connect(service, &SchoolService::damaged, this,
            [this](const core::Error& error) { m_window.showError(error, FailedOperation::SendingAttempt); });
    connect(service, &SchoolService::unanswered, &m_window, &MainWindow::showDatabaseSilent);
    connect(service, &SchoolService::answered, &m_window, &MainWindow::hideDatabaseSilent);
    connect(service, &SchoolService::foundOlder, this, [this] {
        m_window.showMessage(
            tr("The database is older than when this computer last used it: attempts and changes may be "
               "missing. If nobody restored a backup, somebody put an older copy in its place. The "
               "audit has a row about it."));
    });
    connect(service, &SchoolService::waitOn, this, [this](int count) {
        m_window.showMessage(tr("%n attempt(s) on this computer cannot be sent to this school: the student is "
                                "unknown, or another station.key signed them. They stay on this computer.",
                                nullptr, count));
    });
    connect(service, &SchoolService::waitForOthers, this, [this](int count, const QString& schools) {
        m_window.showMessage(
            //: %1: a file's name, or the address of a server
            tr("%n attempt(s) on this computer wait for another school: %1. If that is this one under an "
               "earlier name, \"cusp db send\" brings them here.",
               nullptr, count)
                .arg(schools));
    });
}

/// Marks attempts again while a teacher or an admin is logged in.
void SchoolController::beginChecks()
{
    m_checker = std::make_unique<AttemptChecker>(m_school, m_options.retry);
    connect(m_checker.get(), &AttemptChecker::doubted, this, [this] {
        m_window.showMessage(tr("An attempt does not match its recording, so its score does not count. It is marked in "
                                "the student's attempts and in the table of the class."));
    });
}

void SchoolController::restore(const database::Login& who, const QString& backup)
{
    m_backup = backup;
    restore(who);
}

/// The folder of a file that the user named has to exist.
void SchoolController::makeStationFolder() const
{
    if (m_options.database.isEmpty() || m_address->isServer())
        QDir().mkpath(m_stationFolder);
}

void SchoolController::openSchool()
{
    makeStationFolder();  // the disk may be writable by now
    m_window.account().setOpening(true);
    m_service->open(this, [this](const SchoolService::Opening& opening) { takeOpening(opening); });
}

void SchoolController::refuseLogin(const core::Error& why)
{
    if (!m_service || m_address->isServer() || !isOfTheFile(why.code)) {
        m_window.account().refuse(why);
        return;
    }
    m_service->open(this, [this, why](const SchoolService::Opening& opening) {
        if (opening.status)
            m_window.account().refuse(why);
        else
            takeOpening(opening);
    });
}

void SchoolController::takeOpening(const SchoolService::Opening& opening)
{
    m_window.account().setOpening(false);
    m_backup = opening.soundBackup;
    const QDateTime backupMade = database::sql::madeAt(m_backup);
    if (!opening.status) {
        const core::Error& error = opening.status.error();
        m_window.account().setUnreachable(error, m_where, backupMade);
        if (!m_options.asksWho && !m_openWatch.isActive())
            m_window.showError(error, FailedOperation::KeepingGrades, m_options.database);
        // A server may return by itself; a file that cannot be used does not.
        if (error.code == core::ErrorCode::ConnectionLost || error.code == core::ErrorCode::ServerRefuses ||
            error.code == core::ErrorCode::ServerUnknown || error.code == core::ErrorCode::Busy ||
            error.code == core::ErrorCode::OpenElsewhere)
            m_openWatch.start();
        return;
    }
    m_openWatch.stop();
    m_window.account().setUnreachable({}, m_where, backupMade);
    m_isOnNetworkDrive = !isServer() && !opening.notice.empty();
    const bool wasNew = m_window.account().isNewSchool();
    m_window.account().setNewSchool(opening.isNew);
    m_backups->setEmpty(opening.isNew);
    m_backups->start();
    emit opened();
    if (m_window.navigation().isAtLogin() && wasNew != opening.isNew)
        m_window.account().askLogin();
}

void SchoolController::restore(const database::Login& who)
{
    m_service->restore(this, who, m_backup, [this](const SchoolService::Opening& opening) {
        const QDateTime made = database::sql::madeAt(m_backup).toLocalTime();
        takeOpening(opening);
        m_window.account().say([made, restored = opening.restored, isOpen = opening.status.has_value(),
                                replaced = QFileInfo(opening.replaced).fileName()] {
            if (!restored)
                return (isOpen ? tr("The backup was not restored; nothing has been changed. %1")
                               : tr("The backup was not restored. %1"))
                    .arg(AdminController::whyNotRestored(restored.error()));
            const QString when = QLocale().toString(made, QLocale::ShortFormat);
            //: %2: a file's name
            return replaced.isEmpty() ? tr("The backup of %1 was restored.").arg(when)
                                      : tr("The backup of %1 was restored. The previous file is kept next to it as %2.")
                                            .arg(when, replaced);
        });
    });
}

void SchoolController::endNewSchool()
{
    m_window.account().setNewSchool(false);
    m_backups->setEmpty(false);
    m_backup.clear();
    m_window.account().setUnreachable({}, m_where, {});
}

}  // namespace app
