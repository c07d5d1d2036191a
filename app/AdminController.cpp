// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/AdminController.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLocale>
#include <QTimer>

#include "app/school/DailyBackup.h"
#include "app/school/SchoolSettings.h"
#include "app/threads/Background.h"
#include "database/Outbox.h"
#include "database/sql/Audit.h"
#include "database/sql/Classes.h"
#include "database/sql/Logins.h"
#include "database/sql/People.h"
#include "database/sql/Roster.h"
#include "database/sql/Settings.h"
#include "ui/admin/AdminPage.h"
#include "ui/admin/AuditPart.h"
#include "ui/admin/BackupPart.h"
#include "ui/admin/PeoplePart.h"
#include "ui/admin/RosterPart.h"
#include "ui/admin/StationPart.h"

namespace app {
namespace {

using database::ClassId;
using database::Login;
using database::Person;
using database::PersonId;
using database::sql::DatabaseContext;
using ui::admin::AdminPage;
using ui::text::errorText;
using ui::text::FailedOperation;

constexpr int kAuditRows = 500;
constexpr qint64 kLargestRoster = 16 * 1024 * 1024;
constexpr int kProgressMs = 100;

core::Status belong(const DatabaseContext& school, const Login& who, PersonId person, const QSet<qint64>& wanted,
                    const std::vector<ClassId>& present)
{
    for (const qint64 id : wanted)
        if (std::find(present.begin(), present.end(), ClassId{id}) == present.end())
            if (auto done = database::sql::enrol(school, who, {id}, person, true); !done)
                return done;
    for (const ClassId id : present)
        if (!wanted.contains(id.value))
            if (auto done = database::sql::enrol(school, who, id, person, false); !done)
                return done;
    return {};
}

/// The result of entering a person. They have a code, even if they could not be put into their classes.
struct Newcomer
{
    database::sql::Entered entered;
    core::Status put;
};

/// For people: the file with its whole path, however it was named, or the URL.
QString placeOf(const database::Address& address)
{
    return address.isServer() ? address.shown() : QDir::toNativeSeparators(QFileInfo(address.file).absoluteFilePath());
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

/// Why a class cannot be called so.
QString whyNoClass(const core::Error& error)
{
    return error.code == core::ErrorCode::OutOfRange
               ? AdminController::tr(
                     "No class can be called that. Its name has 1 to 100 characters that can be seen, without "
                     "|, which parts classes in a class list, and no other class has it.")
               : why(error);
}

/// What is wrong with a class list as a whole; empty: it is not the file's fault.
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
            .arg(file, QLocale().toString(static_cast<qulonglong>(database::sql::kMostRosterLines)));
    default:
        return {};
    }
}

}  // namespace

AdminController::AdminController(ui::window::MainWindow& window, SchoolService& desk, Place place,
                                 std::function<Login()> who)
    : m_window(window), m_desk(desk), m_place(std::move(place)), m_who(std::move(who)),
      m_isStopped(std::make_shared<std::atomic<bool>>(false))
{
    connect(&window.adminPage(), &AdminPage::partOpened, this, &AdminController::refresh);
    connectPeople();
    connectRoster();
    connectBackups();
    connect(&window.adminPage().audit(), &ui::admin::AuditPart::olderRequested, this, &AdminController::tellAudit);
    connect(&window.adminPage().audit(), &ui::admin::AuditPart::newestRequested, this, [this] { tellAudit(0); });
    connect(&window.adminPage().station(), &ui::admin::StationPart::idleMinutesRequested, this, [this](int minutes) {
        m_desk.ask(
            this,
            [who = m_who(), minutes](const DatabaseContext& school) -> core::Result<bool> {
                if (auto done = database::sql::changeSetting(school, who, kIdleMinutes, std::to_string(minutes)); !done)
                    return tl::unexpected(done.error());
                return true;
            },
            [this, minutes](const core::Result<bool>& done) {
                if (done) {
                    emit idleMinutesChanged(minutes);
                    m_window.showMessage(tr("A place that was left is locked after %n minute(s).", nullptr, minutes));
                } else {
                    m_window.showError(done.error(), FailedOperation::ChangingSchool);
                }
            });
    });
}

AdminController::~AdminController()
{
    *m_isStopped = true;
}

void AdminController::refuse(const core::Error& error)
{
    m_window.showError(error, FailedOperation::ReadingSchool);
}

void AdminController::refresh(int part)
{
    switch (part) {
    case AdminPage::People:
        tellPeople();
        break;
    case AdminPage::Backups:
        tellBackups();
        break;
    case AdminPage::Audit:
        tellPeople([this] { tellAudit(0); });
        break;
    case AdminPage::Station:
        tellStation();
        break;
    default:
        break;
    }
}

void AdminController::tellPeople(const std::function<void()>& then)
{
    struct Found
    {
        std::vector<Person> people;
        std::vector<database::SchoolClass> classes;
    };
    m_desk.ask(
        this,
        [who = m_who()](const DatabaseContext& school) -> core::Result<Found> {
            auto people = database::sql::listPeople(school, who);
            auto classes = database::sql::listClasses(school, who);
            if (!people || !classes)
                return tl::unexpected(people ? classes.error() : people.error());
            return Found{std::move(*people), std::move(*classes)};
        },
        [this, then](const core::Result<Found>& found) {
            if (m_who().role() != database::Role::Admin)  // the admin has left
                return;
            if (!found) {
                refuse(found.error());
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
                names[database::sql::Logins::nameInAudit(person.username)] = name;
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
    const auto name = [](const Person& person) {
        return QString::fromStdString(person.fullName().empty() ? person.username : person.fullName());
    };
    connect(
        &part, &PeoplePart::addRequested, this,
        [this, name, &part](const database::NewPerson& person, const QSet<qint64>& classes) {
            m_desk.ask(
                this,
                [who = m_who(), person, classes](const DatabaseContext& school) -> core::Result<Newcomer> {
                    auto entered = database::sql::addPerson(school, who, person);
                    if (!entered)
                        return tl::unexpected(entered.error());
                    core::Status put = belong(school, who, entered->person.id, classes, {});
                    return Newcomer{std::move(*entered), std::move(put)};
                },
                [this, name, who = m_who(), &part](const core::Result<Newcomer>& newcomer) {
                    if (m_who() != who)
                        return;
                    if (newcomer) {
                        const Person& entered = newcomer->entered.person;
                        part.confirm(entered.id, [said = name(entered)] { return tr("%1 was entered.").arg(said); });
                        part.showCode(entered, QString::fromStdString(newcomer->entered.code));
                    }
                    if (const core::Status done = newcomer ? newcomer->put : tl::unexpected(newcomer.error()); !done)
                        part.refuse([error = done.error()] { return why(error); });
                    if (newcomer)
                        tellPeople();
                });
        });
    connect(&part, &PeoplePart::changeRequested, this,
            [this, name, &part](const Person& person, const QSet<qint64>& classes) {
                const auto before = std::find_if(m_people.begin(), m_people.end(),
                                                 [&](const Person& one) { return one.id == person.id; });
                if (before == m_people.end())
                    return;
                QSet<qint64> present;
                for (const ClassId id : before->classes)
                    present.insert(id.value);
                const bool isAnything = person.givenName != before->givenName ||
                                        person.familyName != before->familyName || person.role != before->role ||
                                        person.disabled != before->disabled || classes != present;
                m_desk.ask(
                    this,
                    [who = m_who(), person, classes,
                     asItWas = *before](const DatabaseContext& school) -> core::Result<Person> {
                        auto changed = database::sql::changePerson(school, who, person, asItWas);
                        if (!changed)
                            return changed;
                        if (auto put = belong(school, who, person.id, classes, asItWas.classes); !put)
                            return tl::unexpected(put.error());
                        return changed;
                    },
                    [this, name, isAnything, who = m_who(), &part](const core::Result<Person>& changed) {
                        if (m_who() != who)  // nothing of it is for who works here now
                            return;
                        if (changed)
                            part.confirm(changed->id, [isAnything, said = name(*changed)] {
                                return isAnything ? tr("%1 was changed.").arg(said)
                                                  : tr("There is nothing to save: everything is as it was.");
                            });
                        else
                            part.refuse([error = changed.error()] { return why(error); });
                        tellPeople();
                    });
            });
    connect(&part, &PeoplePart::resetRequested, this, [this, &part](qint64 id) {
        m_desk.ask(
            this,
            [who = m_who(), id](const DatabaseContext& school) {
                return database::sql::resetPassword(school, who, {id});
            },
            [this, who = m_who(), &part](const core::Result<database::sql::Entered>& reset) {
                if (m_who() != who)
                    return;
                if (reset)
                    part.showCode(reset->person, QString::fromStdString(reset->code));
                else
                    part.refuse([error = reset.error()] { return why(error); });
                tellPeople();
            });
    });
    const auto classDone = [this, &part](const QString& className) {
        return [this, className, who = m_who(), &part](const core::Result<bool>& changed) {
            if (m_who() != who)
                return;
            if (changed)
                part.confirmClass(className);
            else
                part.refuseClass([error = changed.error()] { return whyNoClass(error); });
            tellPeople();
        };
    };
    connect(&part, &PeoplePart::classRequested, this, [this, classDone](const QString& className) {
        m_desk.ask(
            this,
            [who = m_who(), className = className.toStdString()](const DatabaseContext& school) {
                return database::sql::addClass(school, who, className).map([](ClassId) { return true; });
            },
            classDone(className));
    });
    connect(&part, &PeoplePart::classNameRequested, this, [this, classDone](qint64 id, const QString& className) {
        m_desk.ask(
            this,
            [who = m_who(), id,
             className = className.toStdString()](const DatabaseContext& school) -> core::Result<bool> {
                if (auto renamed = database::sql::renameClass(school, who, {id}, className); !renamed)
                    return tl::unexpected(renamed.error());
                return true;
            },
            classDone(className));
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
    QTimer::singleShot(kProgressMs, this, [this, isOver, isDryRun, who = m_who()] {
        if (!*isOver && m_who() == who)
            m_window.adminPage().roster().say(isDryRun ? tr("The class list is looked at …")
                                                       : tr("These people are being entered …"));
    });
    m_desk.ask(
        this,
        [who = m_who(), csv = m_roster.toStdString(), isDryRun, seen = m_rosterSeen](const DatabaseContext& school) {
            return database::sql::importRoster(school, who, csv, isDryRun, &seen);
        },
        [this, isDryRun, isOther, isOver, who = m_who()](const core::Result<database::RosterOutcome>& outcome) {
            *isOver = true;
            ui::admin::RosterPart& part = m_window.adminPage().roster();
            if (m_who() != who)
                return;
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
void AdminController::beside(const QString& what, Job job, Done done)
{
    *m_isStopped = true;  // what there was before
    m_isStopped = std::make_shared<std::atomic<bool>>(false);
    m_window.adminPage().backups().showProgress(what);
    using Answer = decltype(job(std::declval<const DatabaseContext&>(), std::declval<const GoesOn&>()));
    m_desk.askBeside(
        this,
        [who = m_who(), isStopped = m_isStopped, job](const DatabaseContext& school) -> Answer {
            if (auto may = database::sql::authorize(school, who, database::Operation::KeepBackups); !may)
                return tl::unexpected(may.error());
            return job(school, [isStopped] { return !*isStopped; });
        },
        [this, who = m_who(), done = std::move(done)](auto& answer) mutable {
            if (!answer && m_who() == who) {  // as for any other request
                if (answer.error().code == core::ErrorCode::Disabled)
                    emit m_desk.disabled();
                if (answer.error().code == core::ErrorCode::NotAllowed)
                    emit m_desk.refused();
            }
            done(answer);
        });
}

void AdminController::tellFailed(const core::Error& error)
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
    beside(
        tr("Everything is looked at …"),
        [isServer = m_place.address.isServer(), witnesses](const DatabaseContext& school, const GoesOn& goesOn) {
            return database::sql::checkDatabase(
                school.db, witnesses, [&goesOn](const char*, std::int64_t) { return goesOn(); },
                isServer ? std::string() : school.key.publicHex());
        },
        [this, code](const core::Result<database::sql::CheckReport>& report) {
            if (report)
                tellChecked(*report, code);
            else
                tellFailed(report.error());
        });
}

void AdminController::tellChecked(const database::sql::CheckReport& report, const QString& code)
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
    connect(&part, &BackupPart::backUpRequested, this, [this, &part] {
        beside(
            tr("The data are being backed up …"),
            [place = m_place, who = m_who()](const DatabaseContext& school,
                                             const GoesOn& goesOn) -> core::Result<QString> {
                auto made =
                    makeBackup(school, place.address, place.stationFolder, QDateTime::currentDateTimeUtc(), goesOn);
                if (made)
                    if (auto noted = database::sql::noteBackup(school, who, *made); !noted)
                        return tl::unexpected(noted.error());
                return made;
            },
            [this, &part](const core::Result<QString>& made) {
                if (!made)
                    return tellFailed(made.error());
                tellBackups();
                part.finish([file = QDir::toNativeSeparators(*made)] {
                    return tr("Backed up: %1. Its pages and keys are whole.").arg(file);
                });
            });
    });
    connect(&part, &BackupPart::checkRequested, this, [this](const QString& code) {
        if (code.isEmpty() || database::sql::isAuditCode(code.toStdString()))
            check(code);
        else
            m_window.adminPage().backups().refuseCode();
    });
    connect(&part, &BackupPart::restoreRequested, this, [this, &part](const QString& backup) {
        part.showProgress(tr("The backup is looked at …"));
        inBackground(
            this, [backup] { return database::sql::verifyBackup(backup); },
            [this, &part, backup, who = m_who()](const core::Status& sound) {
                if (m_who() != who) {  // another person must not lose their work
                    part.finish([] { return QString(); }, {});
                    return;
                }
                part.finish(
                    [isSound = sound.has_value(), name = QFileInfo(backup).fileName()] {
                        return isSound
                                   ? QString()
                                   : tr("%1 is no whole backup of a school, and was not restored. Choose another one.")
                                         .arg(name);
                    },
                    {}, !sound);
                if (sound)
                    restoreAlone(backup);
            });
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

/// Everybody is logged out for it; not where it is known before that it would be refused.
void AdminController::restoreAlone(const QString& backup)
{
    m_desk.expectAlone(this, m_who(), [this, backup, who = m_who()](const core::Status& alone) {
        if (m_who() != who)
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

void AdminController::tellBackups()
{
    ui::admin::BackupPart& part = m_window.adminPage().backups();
    const database::Address& address = m_place.address;
    part.setDatabase(placeOf(address), address.isServer());
    if (address.isServer())
        return;
    inBackground(
        this,
        [folder = database::sql::backupFolder(address.file)] {
            QList<ui::admin::Backup> backups;
            for (const QString& file : database::sql::backupsIn(folder))
                if (!database::sql::schoolOf(file).empty())
                    backups << ui::admin::Backup{file, database::sql::madeAt(file), QFileInfo(file).size()};
            return backups;
        },
        [&part](const QList<ui::admin::Backup>& backups) { part.setBackups(backups); });
}

void AdminController::tellAudit(qint64 beforeSeq)
{
    using database::sql::AuditRows;
    struct Found
    {
        std::vector<database::AuditRow> rows;
        database::sql::AuditHead head;
        bool hasOlder = false;
    };
    ui::admin::AuditPart& part = m_window.adminPage().audit();
    m_desk.ask(
        this,
        [who = m_who(), beforeSeq, which = part.leavesOutAttempts() ? AuditRows::WithoutAttempts : AuditRows::All](
            const DatabaseContext& school) -> core::Result<Found> {
            // One more, to know whether there are any.
            auto rows = database::sql::readAudit(school, who, kAuditRows + 1, beforeSeq, which);
            const auto head = database::sql::auditHead(school);
            if (!rows || !head)
                return tl::unexpected(rows ? head.error() : rows.error());
            const bool hasOlder = rows->size() > kAuditRows;
            if (hasOlder)
                rows->pop_back();
            return Found{std::move(*rows), *head, hasOlder};
        },
        [this, beforeSeq, &part, without = part.leavesOutAttempts()](const core::Result<Found>& found) {
            if (without != part.leavesOutAttempts())  // what is wanted now was asked for after it
                return;
            if (!found) {
                part.keepRows();
                refuse(found.error());
                return;
            }
            const QList<database::AuditRow> rows(found->rows.begin(), found->rows.end());
            if (beforeSeq == 0)
                part.setRows(rows, QString::fromStdString(found->head.code()), found->hasOlder);
            else
                part.addRows(beforeSeq, rows, found->hasOlder);
        });
}

void AdminController::tellStation()
{
    struct Found
    {
        std::string key;
        int waiting = 0;
        int idleMinutes = 0;
    };
    m_desk.ask(
        this,
        [who = m_who(), folder = m_place.stationFolder](const DatabaseContext& school) -> core::Result<Found> {
            auto settings = database::sql::readSettings(school, who);
            if (!settings)
                return tl::unexpected(settings.error());
            const database::Outbox outbox(QDir(folder).filePath(QStringLiteral("outbox")), school.key);
            return Found{school.key.publicHex(), static_cast<int>(outbox.waiting().size()), idleMinutesOf(*settings)};
        },
        [this](const core::Result<Found>& found) {
            if (!found) {
                refuse(found.error());
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
