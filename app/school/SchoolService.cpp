// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/school/SchoolService.h"

#include <algorithm>
#include <utility>

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QScopeGuard>

#include "app/school/AttemptToCheck.h"
#include "app/threads/Background.h"
#include "database/Passwords.h"
#include "database/sql/Attempts.h"
#include "database/sql/Audit.h"
#include "database/sql/Backups.h"
#include "database/sql/Logins.h"
#include "database/sql/Repositories.h"
#include "database/sql/StartedExams.h"

namespace app {
namespace {

using core::ErrorCode;
using database::sql::DatabaseContext;

constexpr std::size_t kPlaceDigits = 16;
constexpr int kPatienceMs = 5000;  ///< time without an answer after which unanswered() is emitted

/// Returns whether a request that failed with this error may succeed later.
bool mayComeBack(ErrorCode code)
{
    return code == ErrorCode::ConnectionLost || code == ErrorCode::OutcomeUnknown || code == ErrorCode::ServerRefuses ||
           code == ErrorCode::ServerUnknown || code == ErrorCode::Busy || code == ErrorCode::FileMissing;
}

/// Returns whether this error means that the database file is damaged, so that opening it again is useless.
bool isDamage(ErrorCode code)
{
    return code == ErrorCode::BadStructure || code == ErrorCode::WrongKind;
}

std::string digestOfLetter(const database::AttemptRecord& attempt, const QByteArray& recording)
{
    database::AttemptRecord whole = attempt;
    whole.recordingHash = database::digestOf({recording.constData(), static_cast<std::size_t>(recording.size())});
    return database::sql::digestOfAttempt(whole);
}

}  // namespace

core::Result<LetterDelivery> readLetter(const database::Outbox& letters, const QString& file)
{
    if (database::Outbox::isExam(file)) {
        auto exam = letters.readExam(file);
        if (!exam)
            return tl::unexpected(exam.error());
        const QString school = exam->school;
        return LetterDelivery{{},
                              school,
                              {},
                              [] { return database::Doubt::None; },
                              [exam = std::move(*exam)](const DatabaseContext& to, database::Doubt) {
                                  return database::sql::deliverExam(to, exam.personUid, exam.start);
                              }};
    }
    auto letter = letters.read(file);
    if (!letter)
        return tl::unexpected(letter.error());
    const auto kept = std::make_shared<const database::Outbox::PendingAttempt>(std::move(*letter));
    const auto check = [kept] { return checkArriving(kept->attempt, kept->recording); };
    const auto deliver = [kept](const DatabaseContext& to, database::Doubt doubt) {
        database::AttemptRecord attempt = kept->attempt;
        attempt.doubt = doubt;
        return database::sql::deliverAttempt(to, attempt, kept->recording).map([](const auto&) {});
    };
    return LetterDelivery{kept->attempt.uid, kept->school, digestOfLetter(kept->attempt, kept->recording), check,
                          deliver};
}

SchoolService::SchoolService(database::Address address, QString folder, database::sql::Database::Options options,
                             std::chrono::milliseconds retry)
    : m_address(std::move(address)), m_folder(std::move(folder)), m_options(options)
{
    m_there.moveToThread(&m_thread);
    m_thread.setObjectName(QStringLiteral("school"));
    m_thread.start();
    m_retry.setInterval(retry);
    QObject::connect(&m_retry, &QTimer::timeout, this, &SchoolService::tryAgain);
    m_retry.start();
    m_patience.setInterval(kPatienceMs);
    m_patience.setSingleShot(true);
    QObject::connect(&m_patience, &QTimer::timeout, this, &SchoolService::unanswered);
}

SchoolService::~SchoolService()
{
    // The database must be closed after all requests, and on the thread that opened it.
    post([this] {
        if (!m_address.isServer())  // it may not answer any more
            rememberAudit();
        m_school.reset();
        m_database.reset();
        m_there.moveToThread(nullptr);
        m_thread.quit();
    });
    m_thread.wait();
}

void SchoolService::post(std::function<void()> job)
{
    QMetaObject::invokeMethod(&m_there, std::move(job), Qt::QueuedConnection);
}

void SchoolService::runOnDatabase(DatabaseJob job)
{
    if (m_asked++ == 0)
        m_patience.start();
    post([this, job = std::move(job)]() mutable {
        const core::Status connected = connect();
        const core::Status status = job.work(connected ? core::Result<const DatabaseContext*>(m_school.get())
                                                       : tl::unexpected(connected.error()));
        if (!status)
            notice(status.error());
        QMetaObject::invokeMethod(
            this,
            [this, job = std::move(job), status] {
                takeAnswer(status ? std::nullopt : std::optional(status.error().code));
                if (job.owner)
                    job.done();
            },
            Qt::QueuedConnection);
    });
}

void SchoolService::runOnDatabaseBeside(DatabaseJob job)
{
    if (!m_allowsOthers) {
        runOnDatabase(std::move(job));
        return;
    }
    ++*m_besides;
    inBackground(
        job.owner,
        [address = m_address, folder = m_folder, options = m_options, besides = m_besides,
         work = std::move(job.work)]() mutable -> core::Status {
            const auto ended = qScopeGuard([besides] { --*besides; });
            options.mayMigrate = false;
            const auto open = database::sql::Database::open(address, options);
            if (!open)
                return work(tl::unexpected(open.error()));
            const auto key = keyOf(folder);
            if (!key)
                return work(tl::unexpected(key.error()));
            const QSqlDatabase db = (*open)->handle();
            const DatabaseContext school{db, *key, database::sql::clockOf(db)};
            return work(&school);
        },
        [service = QPointer<SchoolService>(this), done = std::move(job.done)](const core::Status& status) {
            if (service && !status && status.error().code == ErrorCode::Disabled)
                emit service->disabled();
            if (service && !status && status.error().code == ErrorCode::NotAllowed)
                emit service->refused();
            done();
        });
}

void SchoolService::run(Job job)
{
    runOnDatabase(overRepositories(std::move(job)));
}

void SchoolService::runBeside(Job job)
{
    runOnDatabaseBeside(overRepositories(std::move(job)));
}

SchoolService::DatabaseJob SchoolService::overRepositories(Job job)
{
    return {job.owner,
            [work = std::move(job.work)](const core::Result<const DatabaseContext*>& school) -> core::Status {
                if (!school)
                    return work(tl::unexpected(school.error()));
                core::Status status;
                database::sql::withRepositories(
                    **school, [&](const database::Repositories& repositories) { status = work(&repositories); });
                return status;
            },
            std::move(job.done)};
}

core::Result<database::StationKey> SchoolService::keyOf(const QString& folder)
{
    return database::StationKey::readOrMake(QDir(folder).filePath(QStringLiteral("station.key")));
}

core::Status SchoolService::openDatabase()
{
    // A missing drive or a mistyped address must not create a second school.
    if (!m_address.isServer() && !QFileInfo(m_folder).isDir())
        if (auto there = database::sql::checkPlace(m_address.file); !there)
            return there;
    if (!m_key) {
        auto key = keyOf(m_folder);
        if (!key)
            return tl::unexpected(key.error());
        m_key = std::move(*key);
    }
    database::sql::Database::Options options = m_options;
    options.mayMigrate = !m_address.isServer();
    auto opened = database::sql::Database::open(m_address, options);
    m_isDamaged = !opened && isDamage(opened.error().code);
    m_isReadOnly = !m_address.isServer() && database::sql::isReadOnly(m_address.file);
    if (!opened)
        return tl::unexpected(opened.error());
    if (auto same = expectSameSchool((*opened)->handle()); !same)
        return same;
    m_database = std::move(*opened);
    m_allowsOthers = m_database->allowsOthers();
    m_undeliverable.clear();
    const QSqlDatabase db = m_database->handle();
    m_school = std::make_unique<database::sql::DatabaseContext>(
        database::sql::DatabaseContext{db, *m_key, database::sql::clockOf(db)});
    compareAudit();
    return {};
}

/// A copy of the school in another place, such as a backup that somebody looks into, has a memory of its own.
std::string SchoolService::memoryKey() const
{
    return m_known + '-' + database::digestOf(m_address.shown().toStdString()).substr(0, kPlaceDigits);
}

/// Notices an older copy in the place of the database.
void SchoolService::compareAudit()
{
    const auto seen = m_known.empty() ? std::nullopt : m_memory.of(memoryKey());
    const auto isOlder =
        seen ? database::sql::isOlderThan(*m_school, seen->head, seen->atUtc) : core::Result<bool>(false);
    if (!isOlder)  // it could not be noted, and is compared again at the next start
        return;
    if (*isOlder)
        QMetaObject::invokeMethod(
            this, [this] { emit foundOlder(); }, Qt::QueuedConnection);
    rememberAudit();
}

void SchoolService::rememberAudit()
{
    if (!m_school || m_known.empty())
        return;
    const auto head = database::sql::auditHead(*m_school);
    if (!head || *head == m_seen)
        return;
    m_seen = *head;
    m_memory.remember(memoryKey(), *head, m_school->now());
}

/// Rejects a database whose id differs from the one in which the user logged in, even a copy of it.
core::Status SchoolService::expectSameSchool(const QSqlDatabase& db)
{
    const auto school = database::sql::schoolOf(db);
    if (school && m_known.empty())
        m_known = *school;
    if (!school || m_known == *school)  // a damaged database is reported when it is read
        return {};
    QMetaObject::invokeMethod(
        this, [this] { emit otherSchool(); }, Qt::QueuedConnection);
    return core::unexpected(ErrorCode::OtherSchool, "database " + m_address.shown().toStdString() +
                                                        ": another school has taken its place; log in again");
}

void SchoolService::takeOtherSchool()
{
    post([this] {
        if (!m_database)
            m_known.clear();
    });
}

/// Opens the database, or opens it again if the connection was lost or a read-only file has become writable.
core::Status SchoolService::connect()
{
    if (!m_database)
        return openDatabase();
    if (m_isReadOnly && !database::sql::isReadOnly(m_address.file)) {
        m_school.reset();
        m_database.reset();
        return openDatabase();
    }
    if (auto there = m_database->stillThere(); !there) {
        if (there.error().code == ErrorCode::FileMissing)
            return there;
        m_school.reset();
        m_database.reset();
        return openDatabase();
    }
    // Reconnecting is safe: the request has not been sent yet, so it cannot run twice. The user need not know that the
    // server was restarted.
    if (std::exchange(m_isLost, false) || !m_database->answers()) {
        if (auto again = m_database->reconnect(); !again) {
            m_isLost = true;
            return again;
        }
        if (auto same = expectSameSchool(m_database->handle()); !same) {
            m_school.reset();
            m_database.reset();
            return same;
        }
        m_undeliverable.clear();  // the database may contain their users by now
        m_school->nowUtc = database::sql::clockOf(m_database->handle());
    }
    return {};
}

void SchoolService::notice(const core::Error& error)
{
    m_isLost = m_isLost || error.code == ErrorCode::ConnectionLost;
    if (error.code == ErrorCode::Disabled)
        QMetaObject::invokeMethod(
            this, [this] { emit disabled(); }, Qt::QueuedConnection);
    if (error.code == ErrorCode::OtherSchool &&
        m_database) {  // the open database is a new one, created where the old one had disappeared
        m_school.reset();
        m_database.reset();
        QMetaObject::invokeMethod(
            this, [this] { emit otherSchool(); }, Qt::QueuedConnection);
    }
    if (error.code == ErrorCode::NotAllowed)
        QMetaObject::invokeMethod(
            this, [this] { emit refused(); }, Qt::QueuedConnection);
}

SchoolService::Opening SchoolService::tryToOpen()
{
    Opening opening;
    opening.status = connect();
    if (opening.status) {
        opening.notice = m_database->notice();
        const auto isNew = database::sql::Logins::isNew(*m_school);
        opening.isNew = isNew.value_or(false);
        if (!isNew) {
            notice(isNew.error());
            opening.status = tl::unexpected(isNew.error());
        }
    }
    const bool mayBeRestored = opening.status ? opening.isNew : isDamage(opening.status.error().code);
    if (mayBeRestored && m_key && !m_address.isServer())
        opening.soundBackup = database::sql::newestSound(m_address.file);
    return opening;
}

void SchoolService::open(QObject* owner, const Opened& done)
{
    post([this, guard = QPointer<QObject>(owner), done] {
        const Opening opening = tryToOpen();
        answer(guard, done, opening);
        // If opening failed, m_retry delivers later.
        if (opening.status)
            deliverAll();
    });
}

core::Status SchoolService::mayRestore(const database::Login& session)
{
    if (*m_besides > 0)
        return core::unexpected(ErrorCode::Busy,
                                "database " + m_address.file.toStdString() +
                                    ": a backup or a check of it goes on; try again when it has ended");
    // Everybody may restore a file that is damaged, missing or empty, because everybody can replace it by hand.
    if (!connect() || database::sql::Logins::isNew(*m_school).value_or(true))
        return {};
    return database::sql::mayRestore(*m_school, session);
}

void SchoolService::restore(QObject* owner, const database::Login& session, const QString& backup, const Opened& done)
{
    post([this, guard = QPointer<QObject>(owner), session, backup, done] {
        if (const core::Status may = mayRestore(session); !may) {
            Opening as = tryToOpen();
            as.restored = may;
            answer(guard, done, as);
            return;
        }
        m_school.reset();
        m_database.reset();
        m_undeliverable.clear();
        m_forOthers.clear();
        // This comes first, so that the next start sends the attempts if the restore is interrupted.
        database::Outbox(outboxFolder(), m_key.value_or(database::StationKey::make()),
                         database::Outbox::schoolAt(m_address, m_folder))
            .sendAgain();
        m_memory.forget(memoryKey());
        m_known.clear();  // the id may change: the backup may be of the school that this one was copied from
        const auto replaced = database::sql::restoreBackup(backup, m_address.file, QDateTime::currentDateTimeUtc());
        Opening opening = tryToOpen();
        opening.replaced = replaced.value_or(QString());
        if (!replaced)
            opening.restored = tl::unexpected(replaced.error());
        else if (opening.status) {
            opening.status = database::sql::noteRestored(*m_school, session, backup);
            rememberAudit();
        }
        answer(guard, done, opening);
        deliverAll();
    });
}

void SchoolService::expectAlone(QObject* owner, const database::Login& session,
                                const std::function<void(const core::Status&)>& done)
{
    post([this, guard = QPointer<QObject>(owner), session, done] {
        core::Status alone = mayRestore(session);
        if (alone) {
            m_school.reset();
            m_database.reset();
            alone = database::sql::expectClosed(m_address.file);
            static_cast<void>(connect());
        }
        answer(guard, done, alone);
    });
}

QString SchoolService::outboxFolder() const
{
    return QDir(m_folder).filePath(QStringLiteral("outbox"));
}

database::Outbox SchoolService::outbox() const
{
    return {outboxFolder(), *m_key, database::Outbox::schoolAt(m_address, m_folder)};
}

core::Status SchoolService::putInto(const std::function<core::Status(database::Outbox)>& put)
{
    core::Status status;
    if (!m_key)
        status = connect();  // reads the key, even if the server cannot be reached
    return m_key ? put(outbox()) : status;
}

void SchoolService::keep(QObject* owner, const database::Login& session, const database::AttemptRecord& attempt,
                         const core::recording::Recording& recording,
                         const std::function<void(const core::Status&)>& kept)
{
    post([this, guard = QPointer<QObject>(owner), session, attempt, recording, kept] {
        const QByteArray bytes = QByteArray::fromStdString(recording.toBytes());
        const core::Status status =
            putInto([&](database::Outbox letters) { return letters.put(session, attempt, bytes); });
        database::AttemptRecord own = attempt;
        own.personUid = session.uid();
        m_checked[digestOfLetter(own, bytes)] = database::Doubt::None;
        m_graded.insert(QString::fromStdString(attempt.uid));
        answer(guard, kept, status);
        deliverAll();
    });
}

void SchoolService::keep(QObject* owner, const database::Login& session, const database::ExamStart& start,
                         const std::function<void(const core::Status&)>& kept)
{
    post([this, guard = QPointer<QObject>(owner), session, start, kept] {
        answer(guard, kept, putInto([&](database::Outbox letters) { return letters.put(session, start); }));
        deliverAll();
    });
}

void SchoolService::takeAnswer(const std::optional<core::ErrorCode>& fault)
{
    if (--m_asked == 0)
        m_patience.stop();
    else
        m_patience.start();
    m_wasAway = fault && mayComeBack(*fault);
    if (!fault)
        emit answered();
}

/// Delivers the outbox. Emits isBack() if the database could not be reached before and can be reached now.
void SchoolService::tryAgain()
{
    deliver();
    if (m_wasAway)
        ask(
            this, [](const database::Repositories&) { return core::Status(); },
            [this](const core::Status& there) {
                if (there)
                    emit isBack();
            });
}

void SchoolService::countWaiting(QObject* owner, const database::Login& session, const std::function<void(int)>& done)
{
    post([this, guard = QPointer<QObject>(owner), uid = session.uid(), done] {
        int count = 0;
        if (m_key) {
            const database::Outbox letters = outbox();
            for (const QString& file : letters.waiting())
                if (!database::Outbox::isExam(file))
                    if (const auto letter = letters.read(file); letter && letter->attempt.personUid == uid)
                        ++count;
        }
        answer(guard, done, count);
    });
}

void SchoolService::deliver()
{
    post([this] { deliverAll(); });
}

void SchoolService::deliverAll()
{
    // A damaged file is not opened again, because checking it takes long.
    if (!m_key || (!m_database && m_isDamaged))
        return;
    const database::Outbox letters = outbox();
    const int before = static_cast<int>(m_undeliverable.size());
    const int beforeForOthers = static_cast<int>(m_forOthers.size());
    // Entries that have failed come last, the latest failure at the end. Otherwise an entry that always fails, because
    // it exceeds a limit of the server for example, would block all others.
    QStringList files = letters.waiting();
    if (files.isEmpty())
        return;
    std::stable_sort(files.begin(), files.end(), [this](const QString& one, const QString& other) {
        return m_hasFailed.value(one) < m_hasFailed.value(other);
    });
    for (const QString& file : std::as_const(files)) {
        if (m_undeliverable.contains(file) || m_forOthers.contains(file))
            continue;
        if (m_isChecking && !database::Outbox::isExam(file) && !m_graded.contains(QFileInfo(file).completeBaseName()))
            continue;  // it waits until the attempt before it has been checked
        if (!connect())
            return;
        const auto letter = readLetter(letters, file);
        if (!letter) {
            if (letter.error().code == ErrorCode::BadStructure)
                setAside(letters, file, letter.error());
            else if (letter.error().code != ErrorCode::FileMissing)  // another window has delivered it
                m_undeliverable.insert(file);
            continue;
        }
        if (isForAnother(*letter)) {
            m_forOthers.insert(file);
            m_otherSchools.insert(letter->school);
            continue;
        }
        const std::optional<database::Doubt> doubt = doubtOf(*letter);
        if (!doubt)
            continue;
        const core::Status done = letter->deliver(*m_school, *doubt);
        if (done) {
            m_checked.erase(letter->digest);
            m_hasFailed.remove(file);
            if (!letter->attempt.empty())
                QMetaObject::invokeMethod(
                    this, [this, uid = QString::fromStdString(letter->attempt)] { emit delivered(uid); },
                    Qt::QueuedConnection);
            // Cusp makes no backups of a server, so a delivered entry need not wait for one.
            if (m_address.isServer())
                letters.remove(file);
            else
                letters.keepArrived(file);
        } else if (done.error().code == ErrorCode::UnknownName || done.error().code == ErrorCode::OutOfRange) {
            // The entry may belong to another school that this computer serves from the same folder, or an
            // administrator may repair the server. The entries after it are delivered meanwhile.
            m_undeliverable.insert(file);
        } else {
            m_hasFailed.insert(file, ++m_failures);
            notice(done.error());
            return;
        }
    }
    rememberAudit();
    if (const int now = static_cast<int>(m_undeliverable.size()); now > before)
        QMetaObject::invokeMethod(
            this, [this, now] { emit waitOn(now); }, Qt::QueuedConnection);
    if (const int now = static_cast<int>(m_forOthers.size()); now > beforeForOthers) {
        const QString schools = QStringList(m_otherSchools.values()).join(QStringLiteral(", "));
        QMetaObject::invokeMethod(
            this, [this, now, schools] { emit waitForOthers(now, schools); }, Qt::QueuedConnection);
    }
}

/// Returns the doubt of an entry. Empty: the attempt has to be marked again first, which begins now or later.
std::optional<database::Doubt> SchoolService::doubtOf(const LetterDelivery& letter)
{
    if (letter.digest.empty())
        return database::Doubt::None;
    if (const auto known = m_checked.find(letter.digest); known != m_checked.end())
        return known->second;
    if (std::exchange(m_isChecking, true))
        return std::nullopt;
    inBackground(this, letter.check, [this, digest = letter.digest](database::Doubt doubt) {
        post([this, digest, doubt] {
            m_isChecking = false;
            m_checked[digest] = doubt;
            deliverAll();
        });
    });
    return std::nullopt;
}

bool SchoolService::isForAnother(const LetterDelivery& letter) const
{
    return !letter.school.isEmpty() && letter.school != database::Outbox::schoolAt(m_address, m_folder);
}

void SchoolService::setAside(const database::Outbox& outbox, const QString& file, const core::Error& why)
{
    outbox.setAside(file);
    QMetaObject::invokeMethod(
        this, [this, why] { emit damaged(why); }, Qt::QueuedConnection);
}

}  // namespace app
