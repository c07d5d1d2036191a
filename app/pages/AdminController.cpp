// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/AdminController.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLocale>
#include <QTimer>

#include "app/school/DailyBackup.h"
#include "app/school/SchoolSettings.h"
#include "app/threads/Background.h"
#include "database/AuditHead.h"
#include "database/Outbox.h"
#include "database/Repositories.h"
#include "database/SchoolSettings.h"
#include "database/Usernames.h"
#include "ui/admin/AdminPage.h"
#include "ui/admin/AuditPart.h"
#include "ui/admin/BackupPart.h"
#include "ui/admin/PeoplePart.h"
#include "ui/admin/RosterPart.h"
#include "ui/admin/StationPart.h"
#include "ui/text/Texts.h"

namespace app {
namespace {

using database::ClassId;
using database::Login;
using database::Person;
using database::PersonId;
using database::Repositories;
using ui::admin::AdminPage;
using ui::text::errorText;
using ui::text::FailedOperation;

constexpr int kAuditRows = 500;
constexpr qint64 kLargestRoster = 16 * 1024 * 1024;
constexpr int kProgressMs = 100;

/// The absolute path of the file, or the URL of the server. Says if the connection to the server is not protected.
QString placeOf(const database::Address& address)
{
    if (!address.isServer())
        return QDir::toNativeSeparators(QFileInfo(address.file).absoluteFilePath());
    //: %1: address of the server; %2: an option of the connection, such as sslmode=require
    return address.isProtected() ? address.shown()
                                 : AdminController::tr("%1 (not protected on the network: %2)")
                                       .arg(address.shown(), QStringLiteral("sslmode=") + address.sslMode);
}

QString why(const core::Error& error)
{
    switch (error.code) {
    case core::ErrorCode::OutOfRange:
        return AdminController::tr("That cannot be: the username is empty or taken, or has other characters than the "
                                   "letters a to z, digits and . _ - @.");
    default:
        return errorText(error, FailedOperation::ChangingSchool);
    }
}

/// Why a class cannot have this name.
QString whyNoClass(const core::Error& error)
{
    return error.code == core::ErrorCode::OutOfRange
               ? AdminController::tr(
                     "No class can be called that. Its name has 1 to 100 characters that can be seen, without "
                     "|, which parts classes in a class list, and no other class has it.")
               : why(error);
}

/// Why a class list was refused as a whole; empty: for another reason than its file.
QString classListFault(core::ErrorCode code, const QString& file)
{
    switch (code) {
    case core::ErrorCode::FileEmpty:
        return AdminController::tr(
                   "%1 is empty. The first line of a class list names its columns: username, given_name, "
                   "family_name, role, class.")
            .arg(file);
    case core::ErrorCode::FileTooLarge:
        return AdminController::tr("%1 has more than %2 lines. Split it, and enter the parts one after another.")
            .arg(file, QLocale().toString(static_cast<qulonglong>(database::kMostRosterLines)));
    default:
        return {};
    }
}

QString nameOf(const Person& person)
{
    return QString::fromStdString(person.fullName().empty() ? person.username : person.fullName());
}

std::vector<ClassId> classIds(const QSet<qint64>& classes)
{
    std::vector<ClassId> ids;
    for (const qint64 id : classes)
        ids.push_back({id});
    std::sort(ids.begin(), ids.end());
    return ids;
}

}  // namespace

AdminController::AdminController(ui::window::MainWindow& window, SchoolAccess& school, Place place,
                                 std::function<Login()> who)
    : m_window(window), m_queries(school, std::move(who)), m_place(std::move(place)),
      m_isStopped(std::make_shared<std::atomic<bool>>(false))
{
    connect(&window.adminPage(), &AdminPage::partOpened, this, &AdminController::refresh);
    connectPeople();
    connectRoster();
    connectBackups();
    connectStation();
    connect(&window.adminPage().audit(), &ui::admin::AuditPart::olderRequested, this, &AdminController::readAudit);
    connect(&window.adminPage().audit(), &ui::admin::AuditPart::newestRequested, this, [this] { readAudit(0); });
}

AdminController::~AdminController()
{
    *m_isStopped = true;
}

void AdminController::showReadError(const core::Error& error)
{
    m_window.showError(error, FailedOperation::ReadingSchool);
}

void AdminController::refresh(int part)
{
    switch (part) {
    case AdminPage::People:
        readPeople();
        break;
    case AdminPage::Backups:
        readBackups();
        break;
    case AdminPage::Audit:
        readPeople([this] { readAudit(0); });
        break;
    case AdminPage::Station:
        readStation();
        break;
    default:
        break;
    }
}

void AdminController::readPeople(const std::function<void()>& then)
{
    struct Found
    {
        std::vector<Person> people;
        std::vector<database::SchoolClass> classes;
    };
    m_queries.ask(
        this,
        [](const Repositories& school, const Login& who) -> core::Result<Found> {
            auto people = school.people.list(who);
            auto classes = school.classes.list(who);
            if (!people || !classes)
                return tl::unexpected(people ? classes.error() : people.error());
            return Found{std::move(*people), std::move(*classes)};
        },
        [this, then](const core::Result<Found>& found) {
            if (!found) {
                showReadError(found.error());
                return;
            }
            m_people = QList<Person>(found->people.begin(), found->people.end());
            AdminPage& page = m_window.adminPage();
            page.people().setPeople(m_people,
                                    QList<database::SchoolClass>(found->classes.begin(), found->classes.end()));
            ui::admin::NamesByUid names;
            for (const Person& person : m_people) {
                const QString name = person.fullName().empty()
                                         ? QString::fromStdString(person.username)
                                         : QString::fromStdString(person.fullName() + " (" + person.username + ")");
                names[person.uid] = name;
                names[database::nameInAudit(database::nameHash(person.username))] = name;
            }
            for (const database::SchoolClass& one : found->classes)
                names["class:" + std::to_string(one.id.value)] = QString::fromStdString(one.name);
            page.audit().setNames(names);
            page.backups().setNames(names);
            if (then)
                then();
        });
}

void AdminController::connectPeople()
{
    using ui::admin::PeoplePart;
    PeoplePart& part = m_window.adminPage().people();
    connect(&part, &PeoplePart::addRequested, this, &AdminController::addPerson);
    connect(&part, &PeoplePart::changeRequested, this, &AdminController::changePerson);
    connect(&part, &PeoplePart::resetRequested, this, [this](qint64 id) { resetPassword({id}); });
    connect(&part, &PeoplePart::eraseRequested, this, [this](qint64 id) { erasePerson({id}); });
    connect(&part, &PeoplePart::classRequested, this, [this](const QString& className) {
        m_queries.ask(
            this,
            [name = className.toStdString()](const Repositories& school, const Login& who) {
                return school.classes.add(who, name);
            },
            [this, className](const core::Status& changed) { showClassChange(className, changed); });
    });
    connect(&part, &PeoplePart::classNameRequested, this, [this](qint64 id, const QString& className) {
        m_queries.ask(
            this,
            [id, name = className.toStdString()](const Repositories& school, const Login& who) {
                return school.classes.rename(who, {id}, name);
            },
            [this, className](const core::Status& changed) { showClassChange(className, changed); });
    });
}

void AdminController::showClassChange(const QString& className, const core::Status& changed)
{
    ui::admin::PeoplePart& part = m_window.adminPage().people();
    if (changed)
        part.confirmClass(className);
    else
        part.refuseClass([error = changed.error()] { return whyNoClass(error); });
    readPeople();
}

void AdminController::addPerson(const database::NewPerson& person, const QSet<qint64>& classes)
{
    m_queries.ask(
        this,
        [person, ids = classIds(classes)](const Repositories& school, const Login& who) {
            return school.people.add(who, person, ids);
        },
        [this](const core::Result<database::Entered>& entered) {
            ui::admin::PeoplePart& part = m_window.adminPage().people();
            if (!entered) {
                part.refuse([error = entered.error()] { return why(error); });
                return;
            }
            part.confirm(entered->person.id,
                         [said = nameOf(entered->person)] { return tr("%1 was entered.").arg(said); });
            part.showCode(entered->person, QString::fromStdString(entered->code));
            readPeople();
        });
}

void AdminController::changePerson(Person person, const QSet<qint64>& classes)
{
    const auto before =
        std::find_if(m_people.begin(), m_people.end(), [&](const Person& one) { return one.id == person.id; });
    if (before == m_people.end())
        return;
    Person asItWas = *before;
    std::sort(asItWas.classes.begin(), asItWas.classes.end());
    person.classes = classIds(classes);
    const bool isChanged = person.givenName != asItWas.givenName || person.familyName != asItWas.familyName ||
                           person.role != asItWas.role || person.disabled != asItWas.disabled ||
                           person.classes != asItWas.classes;
    m_queries.ask(
        this,
        [person, asItWas](const Repositories& school, const Login& who) {
            return school.people.change(who, person, asItWas);
        },
        [this, isChanged](const core::Result<Person>& changed) {
            ui::admin::PeoplePart& part = m_window.adminPage().people();
            if (changed)
                part.confirm(changed->id, [isChanged, said = nameOf(*changed)] {
                    return isChanged ? tr("%1 was changed.").arg(said)
                                     : tr("There is nothing to save: everything is as it was.");
                });
            else
                part.refuse([error = changed.error()] { return why(error); });
            readPeople();
        });
}

void AdminController::resetPassword(PersonId person)
{
    m_queries.ask(
        this,
        [person](const Repositories& school, const Login& who) { return school.people.resetPassword(who, person); },
        [this](const core::Result<database::Entered>& reset) {
            ui::admin::PeoplePart& part = m_window.adminPage().people();
            if (reset)
                part.showCode(reset->person, QString::fromStdString(reset->code));
            else
                part.refuse([error = reset.error()] { return why(error); });
            readPeople();
        });
}

void AdminController::erasePerson(PersonId person)
{
    m_queries.ask(
        this, [person](const Repositories& school, const Login& who) { return school.people.erase(who, person); },
        [this](const core::Result<database::ErasedPerson>& erased) {
            ui::admin::PeoplePart& part = m_window.adminPage().people();
            if (erased)
                part.confirm(erased->person.id,
                             [isClean = erased->isFileClean, name = QString::fromStdString(erased->person.username)] {
                                 return isClean ? tr("The person was erased. The attempts stay as %1.").arg(name)
                                                : tr("The person was erased, and the attempts stay as %1. Another "
                                                     "program was using the database file, so unused parts of it may "
                                                     "contain the names until another person is erased.")
                                                      .arg(name);
                             });
            else
                part.refuse([error = erased.error()] { return why(error); });
            readPeople();
        });
}

void AdminController::connectRoster()
{
    using ui::admin::RosterPart;
    RosterPart& part = m_window.adminPage().roster();
    connect(&part, &RosterPart::fileChosen, this, [this, &part](const QString& path) {
        QFile file(path);
        if (!file.open(QIODevice::ReadOnly) || file.size() > kLargestRoster) {
            part.refuseFile(path, tr("%1 cannot be read, or is too large.").arg(QDir::toNativeSeparators(path)),
                            file.errorString());
            return;
        }
        m_roster = file.readAll();
        m_rosterFile = path;
        import(true);
    });
    connect(&part, &RosterPart::enterRequested, this, [this] { import(false); });
}

void AdminController::import(bool isDryRun, bool isOther)
{
    const auto isOver = std::make_shared<bool>(false);
    QTimer::singleShot(kProgressMs, this, [this, isOver, isDryRun, who = m_queries.who()] {
        if (!*isOver && m_queries.who() == who)
            m_window.adminPage().roster().say(isDryRun ? tr("The class list is looked at …")
                                                       : tr("These people are being entered …"));
    });
    m_queries.ask(
        this,
        [csv = m_roster.toStdString(), isDryRun, seen = m_rosterSeen](const Repositories& school, const Login& who) {
            return school.people.import(who, csv, isDryRun, seen);
        },
        [this, isDryRun, isOther, isOver](const core::Result<database::RosterOutcome>& outcome) {
            *isOver = true;
            ui::admin::RosterPart& part = m_window.adminPage().roster();
            if (outcome) {
                part.showOutcome(*outcome, m_rosterFile, !isDryRun);
                if (isOther)
                    part.say(tr("Nothing was entered: somebody else has entered or changed people meanwhile. This is "
                                "what the list would do now."));
                m_rosterSeen = isDryRun ? *outcome : database::RosterOutcome();
            } else if (outcome.error().code == core::ErrorCode::ChangedSince) {
                import(true, true);
            } else if (const QString fault = classListFault(outcome.error().code, QFileInfo(m_rosterFile).fileName());
                       !fault.isEmpty())
                part.refuseFile(m_rosterFile, fault, QString::fromStdString(outcome.error().detail));
            else
                part.refuse(why(outcome.error()));
        });
}

template <class Job, class Done>
void AdminController::runBeside(const QString& what, Job job, Done done)
{
    *m_isStopped = true;  // the work before
    m_isStopped = std::make_shared<std::atomic<bool>>(false);
    m_window.adminPage().backups().showProgress(what);
    m_queries.school().askBeside(
        this,
        [who = m_queries.who(), isStopped = m_isStopped, job](const Repositories& school) {
            return job(school, who, [isStopped] { return !*isStopped; });
        },
        std::move(done));
}

void AdminController::showFailure(const core::Error& error)
{
    m_window.adminPage().backups().finish(
        [isStopped = m_isStopped->load(), error] {
            return isStopped ? tr("It was stopped.") : errorText(error, FailedOperation::ChangingSchool);
        },
        {}, !m_isStopped->load());
}

void AdminController::check(const QString& code)
{
    const std::vector<std::string> witnesses =
        code.isEmpty() ? std::vector<std::string>() : std::vector{code.toStdString()};
    runBeside(
        tr("Everything is looked at …"),
        [witnesses](const Repositories& school, const Login& who, const GoesOn& goesOn) {
            return school.maintenance.check(who, witnesses, goesOn);
        },
        [this, code](const core::Result<database::CheckReport>& report) {
            if (report)
                showReport(*report, code);
            else
                showFailure(report.error());
        });
}

void AdminController::showReport(const database::CheckReport& report, const QString& code)
{
    ui::admin::BackupPart& part = m_window.adminPage().backups();
    if (report.isStopped) {
        part.finish([] { return tr("It was stopped."); });
        return;
    }
    const auto sentence = [count = static_cast<int>(report.findings.size()), attempts = report.attempts,
                           rows = report.auditRows, code] {
        if (count > 0)
            return tr("%n thing(s) are not as they should be.", nullptr, count);
        const QString sound = tr("Nothing is wrong: %1 attempts and %2 rows of the audit are as they were noted.")
                                  .arg(QLocale().toString(static_cast<qlonglong>(attempts)),
                                       QLocale().toString(static_cast<qlonglong>(rows)));
        return code.isEmpty()
                   ? sound
                   : sound + u' ' + tr("The audit is still the one that the report with the code %1 names.").arg(code);
    };
    std::vector<database::IntegrityIssue> shown = report.findings;
    shown.insert(shown.end(), report.notes.begin(), report.notes.end());
    part.finish(sentence, shown, !report.findings.empty());
}

void AdminController::connectBackups()
{
    using ui::admin::BackupPart;
    BackupPart& part = m_window.adminPage().backups();
    connect(&part, &BackupPart::stopRequested, this, [this] { *m_isStopped = true; });
    connect(&part, &BackupPart::backUpRequested, this, &AdminController::backUp);
    connect(&part, &BackupPart::checkRequested, this, [this, &part](const QString& code) {
        if (code.isEmpty() || database::readAuditCode(code.toStdString()))
            check(code);
        else
            part.refuseCode();
    });
    connect(&part, &BackupPart::restoreRequested, this, &AdminController::restore);
}

void AdminController::backUp()
{
    runBeside(
        tr("The data are being backed up …"),
        [place = m_place](const Repositories& school, const Login& who, const GoesOn& goesOn) {
            return makeBackup(school, who, place.address, place.stationFolder, QDateTime::currentDateTimeUtc(), goesOn);
        },
        [this](const core::Result<QString>& made) {
            if (!made)
                return showFailure(made.error());
            readBackups();
            m_window.adminPage().backups().finish([file = QDir::toNativeSeparators(*made)] {
                return tr("Backed up: %1. Its pages and keys are whole.").arg(file);
            });
        });
}

void AdminController::restore(const QString& backup)
{
    m_window.adminPage().backups().showProgress(tr("The backup is looked at …"));
    inBackground(
        this, [backup] { return checkBackup(backup); },
        [this, backup, who = m_queries.who()](const core::Status& sound) {
            ui::admin::BackupPart& part = m_window.adminPage().backups();
            if (m_queries.who() != who) {  // a restore would log the present user out
                part.finish([] { return QString(); }, {});
                return;
            }
            part.finish(
                [isSound = sound.has_value(), name = QFileInfo(backup).fileName()] {
                    return isSound ? QString()
                                   : tr("%1 is no whole backup of a school, and was not restored. Choose another one.")
                                         .arg(name);
                },
                {}, !sound);
            if (sound)
                restoreAlone(backup);
        });
}

QString AdminController::whyNotRestored(const core::Error& error)
{
    if (error.code == core::ErrorCode::Busy)
        return tr("The school's file is in use: another window of Cusp, or another program, has it open, or a backup "
                  "is being made. Close what has it open, and restore then.");
    return error.code == core::ErrorCode::WrongKind ? tr("It is no backup of this school.")
                                                    : errorText(error, FailedOperation::ReadingSchool);
}

/// Requests the restore, for which everybody is logged out, unless it is known before that it would be refused.
void AdminController::restoreAlone(const QString& backup)
{
    const Login who = m_queries.who();
    m_queries.school().expectAlone(this, who, [this, backup, who](const core::Status& alone) {
        if (m_queries.who() != who)
            return;
        if (!alone) {
            m_window.adminPage().backups().finish(
                [error = alone.error()] {
                    return tr("The backup was not restored; nothing has been changed. %1").arg(whyNotRestored(error));
                },
                {}, true);
            return;
        }
        emit restoreRequested(backup);
    });
}

void AdminController::readBackups()
{
    ui::admin::BackupPart& part = m_window.adminPage().backups();
    const database::Address& address = m_place.address;
    part.setDatabase(placeOf(address), address.isServer());
    if (address.isServer())
        return;
    inBackground(
        this, [address] { return backupsOf(address); },
        [&part](const std::vector<BackupFile>& files) {
            QList<ui::admin::Backup> backups;
            for (const BackupFile& one : files)
                backups << ui::admin::Backup{one.path, one.madeUtc, one.bytes};
            part.setBackups(backups);
        });
}

void AdminController::readAudit(qint64 beforeSeq)
{
    using database::AuditRows;
    struct Found
    {
        std::vector<database::AuditRow> rows;
        database::AuditHead head;
        bool hasOlder = false;
    };
    ui::admin::AuditPart& part = m_window.adminPage().audit();
    m_queries.ask(
        this,
        [beforeSeq, which = part.leavesOutAttempts() ? AuditRows::WithoutAttempts : AuditRows::All](
            const Repositories& school, const Login& who) -> core::Result<Found> {
            // One row more tells whether there are older ones.
            auto rows = school.audit.read(who, kAuditRows + 1, beforeSeq, which);
            const auto head = school.audit.head();
            if (!rows || !head)
                return tl::unexpected(rows ? head.error() : rows.error());
            const bool hasOlder = rows->size() > kAuditRows;
            if (hasOlder)
                rows->pop_back();
            return Found{std::move(*rows), *head, hasOlder};
        },
        [this, beforeSeq, &part, without = part.leavesOutAttempts()](const core::Result<Found>& found) {
            if (without != part.leavesOutAttempts())  // another request is on its way
                return;
            if (!found) {
                part.keepRows();
                showReadError(found.error());
                return;
            }
            const QList<database::AuditRow> rows(found->rows.begin(), found->rows.end());
            if (beforeSeq == 0)
                part.setRows(rows, QString::fromStdString(found->head.code()), found->hasOlder);
            else
                part.addRows(beforeSeq, rows, found->hasOlder);
        });
}

void AdminController::connectStation()
{
    connect(&m_window.adminPage().station(), &ui::admin::StationPart::idleMinutesRequested, this, [this](int minutes) {
        m_queries.ask(
            this,
            [minutes](const Repositories& school, const Login& who) {
                return school.settings.replace(who, kIdleMinutes, std::to_string(minutes), {});
            },
            [this, minutes](const core::Result<database::ReplacedSetting>& done) {
                if (done) {
                    emit idleMinutesChanged(minutes);
                    m_window.showMessage(tr("A place that was left is locked after %n minute(s).", nullptr, minutes));
                } else {
                    m_window.showError(done.error(), FailedOperation::ChangingSchool);
                }
            });
    });
}

void AdminController::readStation()
{
    struct Found
    {
        std::string key;
        int waiting = 0;
        int idleMinutes = 0;
    };
    m_queries.ask(
        this,
        [folder = m_place.stationFolder](const Repositories& school, const Login& who) -> core::Result<Found> {
            const auto settings = school.settings.read(who);
            if (!settings)
                return tl::unexpected(settings.error());
            const database::Outbox outbox(QDir(folder).filePath(QStringLiteral("outbox")), school.stationKey);
            return Found{school.stationKey.publicHex(), static_cast<int>(outbox.waiting().size()),
                         idleMinutesOf(*settings)};
        },
        [this](const core::Result<Found>& found) {
            if (!found) {
                showReadError(found.error());
                return;
            }
            ui::admin::StationPart& part = m_window.adminPage().station();
            part.setFacts({m_place.hand(), m_place.servoHz, 1.0e-3 * m_window.periodUs(0.5),
                           1.0e-3 * m_window.periodUs(0.99), QString::fromStdString(found->key),
                           placeOf(m_place.address), QStringLiteral(CUSP_VERSION), found->waiting});
            part.setIdleMinutes(found->idleMinutes);
        });
}

}  // namespace app
