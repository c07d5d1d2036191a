// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>

#include <QDateTime>
#include <QFile>
#include <QScopeGuard>
#include <QTemporaryDir>
#include <QTest>
#include <unistd.h>

#include "database/Passwords.h"
#include "database/sql/Attempts.h"
#include "database/sql/Audit.h"
#include "database/sql/Check.h"
#include "database/sql/Classes.h"
#include "database/sql/Database.h"
#include "database/sql/Grants.h"
#include "database/sql/Logins.h"
#include "database/sql/People.h"
#include "database/sql/Settings.h"
#include "database/sql/Statement.h"
#include "tests/support/PostgresServer.h"

namespace support {

/// Adds the engines that each test of the database runs on as rows of the test's data.
inline void addEngines()
{
    QTest::addColumn<bool>("onServer");
    QTest::newRow("sqlite") << false;
    QTest::newRow("postgresql") << true;
}

/// Returns the server that all tests of a program share. The first call starts it.
inline PostgresServer& sharedServer()
{
    static PostgresServer server;
    return server;
}

/// Delivers an attempt of the logged-in user, as the outbox of a station does.
inline core::Result<database::AttemptId> addAttempt(const database::sql::DatabaseContext& school,
                                                    const database::Login& session,
                                                    const database::AttemptRecord& attempt, const QByteArray& recording)
{
    database::AttemptRecord own = attempt;
    own.personUid = session.uid();
    return database::sql::deliverAttempt(school, own, recording);
}

/// Returns the findings of a check, one per line.
inline QString wordsOf(const std::vector<database::IntegrityIssue>& findings)
{
    QStringList lines;
    for (const database::IntegrityIssue& finding : findings)
        lines << finding.english();
    return lines.join(u'\n');
}

/// Checks a database and returns the findings; empty if it is sound.
inline QString faultsOf(const QSqlDatabase& db)
{
    const auto report = database::sql::checkDatabase(db, {});
    return report ? wordsOf(report->findings) : QString::fromStdString(report.error().detail);
}

/// Returns an empty string if the result is an error with this code whose sentence contains these words; otherwise the
/// reason.
template <class T>
QString whyNotRefused(const core::Result<T>& result, core::ErrorCode code, std::string_view words = {})
{
    if (result)
        return QStringLiteral("it was not refused");
    const std::string& detail = result.error().detail;
    const bool isRefused = result.error().code == code && !detail.empty() && detail.find(words) != std::string::npos;
    return isRefused ? QString() : QStringLiteral("refused with: ") + QString::fromStdString(detail);
}

/// A school with users of every role. Password hashes have the lowest cost, and the test sets the clock.
class SchoolRig
{
public:
    static constexpr database::PasswordCost kCheap{1, 8192};
    static inline const std::string kPassword = "correct horse";

    explicit SchoolRig(bool onServer)
        : m_address(onServer ? sharedServer().newDatabase() : m_folder.filePath("school.sqlite"))
    {
        reopen();
    }
    /// Makes a copy of another rig, with its station and its sessions. This is cheaper than populate().
    explicit SchoolRig(SchoolRig& like)
        : nowUtc(like.nowUtc), admin(like.admin), instructor(like.instructor), student(like.student),
          classmate(like.classmate), stranger(like.stranger), otherInstructor(like.otherInstructor), guest(like.guest),
          first(like.first), second(like.second), m_key(like.m_key)
    {
        like.close();  // for good: a server copies only a database without connections, and a file is complete only
                       // when closed
        const bool onServer = like.m_address.startsWith(QStringLiteral("postgresql:"));
        m_address = onServer ? sharedServer().newDatabase(like.m_address) : m_folder.filePath("school.sqlite");
        if (!onServer && !QFile::copy(like.m_address, m_address))
            qWarning("not copied");
        reopen();
    }

    /// Opens the database again, as the next run of the program does.
    void reopen()
    {
        close();
        auto opened = database::sql::Database::open(m_address, std::chrono::milliseconds(200));
        if (!opened) {
            qWarning("%s", opened.error().detail.c_str());
            return;
        }
        m_database = std::move(*opened);
        m_school = std::make_unique<database::sql::DatabaseContext>(
            database::sql::DatabaseContext{m_database->handle(), m_key, [this] { return nowUtc; }, kCheap});
    }
    /// For a populated school on a server: goes on with the account of a station, and logs everybody in again. The time
    /// is that of the server.
    void becomeStation()
    {
        run({"DO $$ BEGIN CREATE ROLE station LOGIN; EXCEPTION WHEN duplicate_object THEN NULL; END $$"});
        if (!database::sql::applyGrants(school().db, "station"))
            qWarning("not granted");
        nowUtc = QDateTime::currentDateTimeUtc();
        m_address.replace("//school@", "//station@");
        reopen();
        for (database::Login* who : {&admin, &instructor, &student, &classmate, &stranger, &otherInstructor})
            *who = logIn(who->username()).value();
    }
    void close()
    {
        m_school.reset();
        m_database.reset();
    }
    [[nodiscard]] bool isOpen() const { return m_database != nullptr; }
    [[nodiscard]] const database::sql::DatabaseContext& school() const { return *m_school; }
    [[nodiscard]] database::sql::Database& database() { return *m_database; }
    [[nodiscard]] const QString& address() const { return m_address; }

    /// Returns the number of rows, or -1 if they cannot be read.
    [[nodiscard]] int count(const QString& rows) const
    {
        const auto counted = database::sql::ask(m_school->db, "SELECT count(*) FROM " + rows, "count");
        return counted ? counted->toInt() : -1;
    }
    /// Executes SQL statements directly, without the permission checks of the program.
    void run(const QStringList& statements) const
    {
        for (const QString& statement : statements) {
            const auto done = database::sql::execute(m_school->db, statement, "run it");
            QVERIFY2(done, done ? "" : done.error().detail.c_str());
        }
    }

    /// Adds the first admin, two classes with an instructor and a student each, and a second student in the first
    /// class.
    void populate()
    {
        using namespace database;
        using namespace database::sql;
        admin = Logins::createFirstAdmin(school(), {"admin", "Ada", "Admin", Role::Admin}, kPassword, kCheap).value();
        first = addClass(school(), admin, "DEN101-A").value();
        second = addClass(school(), admin, "DEN101-B").value();
        instructor = join({"teach", "Ines", "Teach", Role::Instructor}, first);
        student = join({"s1001", "Sam", "One", Role::Student}, first);
        classmate = join({"s1002", "Sue", "Two", Role::Student}, first);
        stranger = join({"s2001", "Kim", "Far", Role::Student}, second);
        otherInstructor = join({"teach2", "Otto", "Teach", Role::Instructor}, second);
    }
    [[nodiscard]] core::Result<database::Login> logIn(const std::string& name,
                                                      const std::string& password = kPassword) const
    {
        return database::sql::Logins::login(school(), name, password);
    }
    /// Adds a user with the common password, enrols them in a class and logs them in.
    database::Login join(const database::NewPerson& who, database::ClassId into)
    {
        using namespace database::sql;
        const Entered entered = addPerson(school(), admin, who).value();
        if (!enrol(school(), admin, into, entered.person.id, true))
            qWarning("not enrolled");
        return Logins::redeem(school(), who.username, entered.code, kPassword).value();
    }

    /// Delivers an attempt of a user, as the outbox of a station does.
    core::Result<database::AttemptId> add(const database::Login& who, const database::AttemptRecord& attempt,
                                          const QByteArray& recording = {}) const
    {
        return addAttempt(school(), who, attempt, recording);
    }
    core::Result<database::AttemptId> add(const database::Login& who, const std::string& lesson, int tenths,
                                          const std::string& finished = "2026-11-20T10:15:00Z",
                                          const QByteArray& recording = {}) const
    {
        return addAttempt(school(), who, attempt(lesson, tenths, finished), recording);
    }
    /// Returns a graded attempt with all fields set.
    static database::AttemptRecord attempt(const std::string& lesson, int tenths,
                                           const std::string& finished = "2026-11-20T10:15:00Z")
    {
        database::AttemptRecord record;
        record.uid = database::newUid();
        record.finishedUtc = finished;
        record.tooth = "36";
        record.lessonId = lesson;
        record.lessonHash = std::string(64, 'a');
        record.rubricHash = std::string(64, 'b');
        record.scoreTenths = tenths;
        record.passMarkTenths = 750;
        record.passed = tenths >= 750;
        record.expectedTenths = 800;
        record.durationMs = 345'678;
        record.criteria = {{"depth", 100, 300}, {"outline", 50, 200}};
        record.scoreSheetJson = "{\"format\":2}";
        record.stateHash = "0123456789abcdef";
        record.device = "pointer";
        record.method = "clearance";
        record.grid = 150;
        record.viewMode = "flat";
        record.seed = "18446744073709551615";
        record.preset = "natural v1";
        record.presetHash = std::string(64, 'c');
        record.program = "0.1.0";
        record.meanForceMn = 850;
        record.peakForceMn = 2400;
        return record;
    }

    QDateTime nowUtc = QDateTime(QDate(2026, 11, 20), QTime(10, 15), Qt::UTC);
    database::Login admin, instructor, student, classmate, stranger, otherInstructor, guest;
    database::ClassId first, second;

private:
    QTemporaryDir m_folder;
    QString m_address;
    database::StationKey m_key = database::StationKey::make();
    std::unique_ptr<database::sql::Database> m_database;
    std::unique_ptr<database::sql::DatabaseContext> m_school;
};

/// A connection to a database file that bypasses the checks of the program.
class RawFile
{
public:
    explicit RawFile(const QString& file)
    {
        QSqlDatabase db = QSqlDatabase::addDatabase("QSQLITE", kName);
        db.setDatabaseName(file);
        db.open();
    }
    ~RawFile()
    {
        handle().close();
        QSqlDatabase::removeDatabase(kName);
    }
    RawFile(const RawFile&) = delete;
    RawFile& operator=(const RawFile&) = delete;
    [[nodiscard]] QSqlDatabase handle() const { return QSqlDatabase::database(kName, false); }

private:
    static constexpr const char* kName = "raw";
};

/// Returns the number of attempts in a file, or -1 if it cannot be opened.
inline int attemptsIn(const QString& file)
{
    const auto database = database::sql::Database::open(file);
    return database ? database::sql::ask((*database)->handle(), "SELECT count(*) FROM attempts", "count")->toInt() : -1;
}

/// Runs the rest of the scope as another user, because root may open every file.
inline auto asNobody()
{
    constexpr uid_t kNobody = 65534;
    const uid_t me = geteuid();
    if (me == 0 && seteuid(kNobody) != 0)
        qWarning("still root");
    return qScopeGuard([me] { QCOMPARE(seteuid(me), 0); });
}

/// Returns a populated school on the given engine, made once, for tests to copy.
inline SchoolRig& populatedSchool(bool onServer)
{
    static std::array<std::unique_ptr<SchoolRig>, 2> schools;
    auto& school = schools.at(onServer ? 1 : 0);
    if (!school) {
        school = std::make_unique<SchoolRig>(onServer);
        school->populate();
    }
    return *school;
}

/// Another station that uses the rig's database. It is made and used in one thread.
class Station
{
public:
    explicit Station(const QString& address, std::chrono::milliseconds patience = std::chrono::seconds(5))
        : m_database(database::sql::Database::open(address, patience).value())
    {}
    [[nodiscard]] database::sql::DatabaseContext school() const
    {
        database::sql::DatabaseContext school{m_database->handle(), m_key};
        school.leastCost = SchoolRig::kCheap;
        return school;
    }

private:
    std::unique_ptr<database::sql::Database> m_database;
    database::StationKey m_key = database::StationKey::make();
};

}  // namespace support

/// Skips the test if there is no PostgreSQL server.
#define NEEDS_SERVER()                                                                                                 \
    if (!support::sharedServer().fault().isEmpty())                                                                    \
    QSKIP(qPrintable(support::sharedServer().fault()))

/// Defines a rig on the engine of the test's row. Skips the test if there is no server.
#define SCHOOL_RIG(name)                                                                                               \
    QFETCH(bool, onServer);                                                                                            \
    if (onServer)                                                                                                      \
        NEEDS_SERVER();                                                                                                \
    support::SchoolRig name(onServer);                                                                                 \
    QVERIFY(name.isOpen())

/// Defines a rig like SCHOOL_RIG, but as a copy of a school such as support::populatedSchool.
#define COPY_OF(school, name)                                                                                          \
    QFETCH(bool, onServer);                                                                                            \
    if (onServer)                                                                                                      \
        NEEDS_SERVER();                                                                                                \
    support::SchoolRig name(school(onServer));                                                                         \
    QVERIFY(name.isOpen())

/// Checks that a result is not an error. Otherwise prints the error's sentence.
#define VERIFY_DONE(expression)                                                                                        \
    do {                                                                                                               \
        const auto& verifiedResult = (expression);                                                                     \
        QVERIFY2(verifiedResult.has_value(), verifiedResult ? "" : verifiedResult.error().detail.c_str());             \
    } while (false)

/// Checks that the result is an error with this code and, if given, these words in its sentence.
#define VERIFY_REFUSED(expression, ...) QCOMPARE(support::whyNotRefused(expression, __VA_ARGS__), QString())
