// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCryptographicHash>
#include <QFile>
#include <QFileInfo>
#include <QScopeGuard>
#include <QSqlQuery>
#include <QStorageInfo>
#include <QTemporaryDir>
#include <QTest>
#include <QUrl>
#include <sys/stat.h>

#include "database/FileSystem.h"
#include "database/sql/Database.h"
#include "database/sql/Dialect.h"
#include "database/sql/Migrations.h"
#include "database/sql/Statement.h"
#include "tests/database/SchoolRig.h"
#include "tests/support/Suite.h"
#include "tests/support/Tables.h"

using namespace database;
using namespace database::sql;
using core::ErrorCode;
using namespace std::chrono_literals;

/// Checks that opening the path is refused with an error that contains the words and the path.
#define REFUSED(path, expected, words)                                                                                 \
    for (const QString& part : {QString(words), QString(path)})                                                        \
    VERIFY_REFUSED(Database::open(path, 10ms), expected, part.toStdString())

/// Defines the location of an empty database on the engine of the test's row. Skips the test if there is no server.
#define WHERE(name, file)                                                                                              \
    QFETCH(bool, onServer);                                                                                            \
    if (onServer)                                                                                                      \
        NEEDS_SERVER();                                                                                                \
    const QString name = onServer ? support::sharedServer().newDatabase() : at(file)

class TestDatabase : public QObject
{
    Q_OBJECT

private slots:
    void init() { QVERIFY(m_folder.emplace().isValid()); }

    void createsTheNewestSchemaWithItsSettings()
    {
        const auto database = Database::open(at("new.db")).value();
        QCOMPARE(ask(*database, "PRAGMA journal_mode").toString(), QStringLiteral("wal"));
        QCOMPARE(ask(*database, "PRAGMA integrity_check").toString(), QStringLiteral("ok"));
        // An empty file becomes a database as well.
        write(at("empty.db"), {});
        VERIFY_DONE(Database::open(at("empty.db")));
        for (const auto& [setting, value] :
             {std::pair("synchronous", 2), std::pair("foreign_keys", 1), std::pair("busy_timeout", 5000),
              std::pair("trusted_schema", 0), std::pair("cell_size_check", 1), std::pair("secure_delete", 1),
              std::pair("wal_autocheckpoint", 1000), std::pair("application_id", int{dialect::kApplicationId}),
              std::pair("user_version", static_cast<int>(shippedMigrations()->size()))})
            QVERIFY2(ask(*database, QStringLiteral("PRAGMA ") + setting) == value, setting);
    }

    /// The tables are STRICT: a text cannot be stored in a number column.
    void everyTableIsStrict()
    {
        const auto database = Database::open(at("strict.db")).value();
        const QString ours =
            "FROM pragma_table_list WHERE schema = 'main' AND type = 'table' AND name NOT LIKE 'sqlite_%'";
        QVERIFY(ask(*database, "SELECT count(*) " + ours).toInt() >= 16);
        QCOMPARE(ask(*database, "SELECT group_concat(name) " + ours + " AND strict = 0").toString(), QString());
        // A wrong type is refused.
        QSqlQuery query(database->handle());
        QVERIFY(!query.exec("INSERT INTO failed_logins VALUES ('x', 'many', 0)"));
        QVERIFY(query.exec("INSERT INTO failed_logins VALUES ('x', 1, 0)"));
    }

    /// The kinds of the real file systems of this computer are recognized.
    void drivesOfThisComputerAreKnown()
    {
        for (const char* folder : {"/dev/shm", "/proc"})
            if (QFileInfo(folder).isDir())
                QVERIFY2(fileSystemOf(QLatin1String(folder) + "/cusp.db") == FileSystem::Local, folder);
        // The folder decides, whether or not the file exists.
        const QByteArray kind = QStorageInfo(m_folder->path()).fileSystemType();
        const QByteArrayList network{"nfs", "nfs4", "cifs", "smb3", "9p", "afs", "ceph", "lustre", "vboxsf"};
        const bool isNetwork = network.contains(kind) || kind.startsWith("fuse");
        QVERIFY2((fileSystemOf(at("cusp.db")) == FileSystem::Network) == isNetwork, kind.constData());
        QVERIFY(fileSystemOf(at("nowhere/cusp.db")) == FileSystem::Local);
        // A database opened without options uses the same test.
        const auto database = Database::open(at("here.db")).value();
        QCOMPARE(database->allowsOthers(), !isNetwork);
    }

    /// SQLite's write-ahead log needs memory that a network drive does not share.
    void aNetworkDriveIsForOneAtATime()
    {
        Database::Options options;
        options.patience = 10ms;
        const auto there = Address::parse(at("drive.db")).value();
        // The database was on a local disk before and has a write-ahead log.
        QVERIFY(Database::open(there, options).has_value());
        options.fileSystemOf = [](const QString&) { return FileSystem::Network; };
        {
            const auto database = Database::open(there, options).value();
            QVERIFY(!database->allowsOthers());
            QVERIFY(database->notice().find("network drive") != std::string::npos);
            QCOMPARE(ask(*database, "PRAGMA journal_mode").toString(), QStringLiteral("delete"));
            QCOMPARE(ask(*database, "PRAGMA locking_mode").toString(), QStringLiteral("exclusive"));
            QCOMPARE(ask(*database, "PRAGMA synchronous").toInt(), 2);
            QVERIFY(!QFile::exists(at("drive.db-wal")));
            VERIFY_REFUSED(Database::open(there, options), ErrorCode::OpenElsewhere, "network drive");
        }
        const auto next = Database::open(at("drive.db")).value();
        QVERIFY(next->allowsOthers());
        QCOMPARE(ask(*next, "PRAGMA journal_mode").toString(), QStringLiteral("wal"));
    }

    /// Closing any descriptor of a file drops all locks of the process on it. If another program closed the database
    /// then, it would remove the write-ahead log that this one uses.
    void aSecondConnectionTakesNoLockAway()
    {
        const auto first = Database::open(at("held.db")).value();
        QCOMPARE(ask(*first, "SELECT count(*) FROM attempts").toInt(), 0);
        struct stat info
        {};
        QCOMPARE(stat(QFile::encodeName(at("held.db")).constData(), &info), 0);
        const QByteArray inode = ':' + QByteArray::number(static_cast<qulonglong>(info.st_ino)) + ' ';
        const auto locks = [&] { return bytes("/proc/locks").count(inode); };
        const auto held = locks();
        if (held == 0)
            QSKIP("this system does not tell of its locks");
        QVERIFY(Database::open(at("held.db")).has_value());
        QCOMPARE(locks(), held);
        // Checking whether a file is a Cusp database must not release the locks either.
        QVERIFY(!Database::open(m_folder->path()).has_value());
        QCOMPARE(locks(), held);
    }

    void refusesAPlaceThatIsNone()
    {
        REFUSED(m_folder->path(), ErrorCode::FileUnreadable, "this is a folder");
        REFUSED(at("missing/new.db"), ErrorCode::FileMissing, "the folder does not exist");
        QVERIFY(!QFileInfo::exists(at("missing")));
    }

    void refusesAPlaceThatCannotBeWritten()
    {
        // Nobody can create a file in /proc, not even root.
        const QString proc = QStringLiteral("/proc/cusp.db");
        if (QFileInfo(QStringLiteral("/proc")).isDir())
            REFUSED(proc, ErrorCode::FileUnwritable, "choose a folder that exists and is writable");

        QVERIFY(chmod(qPrintable(m_folder->path()), 0555) == 0);
        const auto openAgain = qScopeGuard([this] { QCOMPARE(chmod(qPrintable(m_folder->path()), 0700), 0); });
        const auto back = support::asNobody();
        REFUSED(at("locked-folder.db"), ErrorCode::FileUnwritable, "choose a folder that exists and is writable");
        REFUSED(at("missing/deep/new.db"), ErrorCode::FileUnwritable, "none can be created in " + m_folder->path());
    }

    void refusesWhatIsNotADatabase()
    {
        const QByteArray letter = "Dear Sir or Madam, this is no database at all, however long it may go on.";
        write(at("letter.db"), letter);
        REFUSED(at("letter.db"), ErrorCode::WrongKind, "not a database");
        QCOMPARE(bytes(at("letter.db")), letter);
        write(at("short.db"), "SQL");
        REFUSED(at("short.db"), ErrorCode::WrongKind, "not a database");
        // A valid signature followed by garbage.
        write(at("liar.db"), QByteArray("SQLite format 3", 16) + QByteArray(200, 'x'));
        QVERIFY(!Database::open(at("liar.db"), 10ms).has_value());
    }

    void refusesADatabaseOfAnotherProgram()
    {
        VERIFY_DONE(execute(support::RawFile(at("other.db")).handle(), "CREATE TABLE music (title TEXT)", "make it"));
        const QByteArray before = bytes(at("other.db"));
        REFUSED(at("other.db"), ErrorCode::WrongKind, "belongs to another program");
        QCOMPARE(bytes(at("other.db")), before);
    }

    /// The error repeats the address as given, so that the user can enter it again.
    void namesAServerWithItsPort()
    {
        if (!QSqlDatabase::isDriverAvailable("QPSQL"))
            QSKIP("this computer cannot speak with PostgreSQL");
        REFUSED("postgresql://cusp@127.0.0.1:1/school", ErrorCode::ConnectionLost, "does not answer");
        const QString folder = QString(QUrl::toPercentEncoding(at("no-socket")));
        REFUSED("postgresql://cusp@" + folder + ":1/school", ErrorCode::ConnectionLost, "does not answer");
    }

    void refusesADamagedFile()
    {
        {
            const auto database = Database::open(at("hurt.db")).value();
            VERIFY_DONE(execute(database->handle(),
                                "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 400) "
                                "INSERT INTO attempts (finished_utc, tooth, score_tenths, duration_ms, uid, device, "
                                "state_hash) SELECT '2026-11-20T10:15:00Z', '36', 80, 1, i, 'a device of some length "
                                "to fill a page or two', '0123456789abcdef' FROM n",
                                "fill it"));
        }
        QByteArray content = bytes(at("hurt.db"));
        QVERIFY(content.size() > 5 * 4096);
        // Overwrites a page in the middle of the table.
        content.replace(3 * 4096, 4096, QByteArray(4096, '\x5A'));
        write(at("hurt.db"), content);
        REFUSED(at("hurt.db"), ErrorCode::BadStructure, "restore a backup");
    }

    /// The error does not call the file damaged, because the disk is sound.
    void refusesARowThatNoProgramOfOursWrites()
    {
        support::SchoolRig rig(support::populatedSchool(false));
        rig.run({"PRAGMA ignore_check_constraints = ON",
                 "INSERT INTO audit SELECT -3, at_utc, actor, action, object, detail, hash FROM audit WHERE seq = 1"});
        rig.close();
        VERIFY_REFUSED(Database::open(rig.address(), 200ms), ErrorCode::BadStructure,
                       "a row of the table audit holds what");
    }

    void refusesWhatIsFromTheFuture_data() { support::addEngines(); }
    void refusesWhatIsFromTheFuture()
    {
        WHERE(where, "future.db");
        {
            const auto database = Database::open(where).value();
            VERIFY_DONE(dialect::setSchemaVersion(database->handle(), 99));
        }
        const QByteArray before = bytes(at("future.db"));
        const auto refused = Database::open(where, 10ms);
        VERIFY_REFUSED(refused, ErrorCode::NewerVersion, "later program");
        QVERIFY(onServer || refused.error().detail.find(where.toStdString()) != std::string::npos);
        QCOMPARE(bytes(at("future.db")), before);
    }

    void whatAServerConfirmsIsOnItsDisk_data()
    {
        support::columns<QString, QString>("set", "used");
        for (const auto& [set, used] :
             {std::pair("off", "on"), {"on", "on"}, {"local", "local"}, {"remote_apply", "remote_apply"}})
            QTest::newRow(set) << set << used;
    }

    void whatAServerConfirmsIsOnItsDisk()
    {
        QFETCH(QString, set);
        NEEDS_SERVER();
        support::SchoolRig rig(true);
        QVERIFY(rig.isOpen());
        rig.run({"ALTER DATABASE " + rig.database().address().name + " SET synchronous_commit = " + set});
        rig.reopen();
        QVERIFY(rig.isOpen());
        QTEST(ask(rig.database(), "SHOW synchronous_commit").toString(), "used");
    }

    /// A server that is shutting down ends each connection with an error that resembles a refused login.
    void aServerThatWasStoppedIsAway()
    {
        NEEDS_SERVER();
        auto& server = support::sharedServer();
        support::SchoolRig rig(true);
        QVERIFY(rig.isOpen());
        const auto look = [&rig] { return sql::ask(rig.school().db, "SELECT 1", "look"); };
        for (const bool isUpAgain : {false, true}) {
            VERIFY_DONE(look());
            server.stop();
            QVERIFY(!isUpAgain || server.start());
            QVERIFY(rig.database().handle().isOpen());
            VERIFY_REFUSED(look(), ErrorCode::ConnectionLost, "does not answer; check the network");
            QVERIFY(!rig.database().answers());
            if (!isUpAgain) {
                VERIFY_REFUSED(rig.database().reconnect(), ErrorCode::ConnectionLost);
                QVERIFY(server.start());
            }
            VERIFY_DONE(rig.database().reconnect());
            QVERIFY(rig.database().answers());
        }
    }

    void whomAServerDoesNotLetInIsTold()
    {
        NEEDS_SERVER();
        support::SchoolRig rig(true);
        QVERIFY(rig.isOpen());
        const QString name = rig.database().address().name;
        VERIFY_REFUSED(Database::open(QString(rig.address()).replace("school@", "nobody@")), ErrorCode::ServerRefuses);
        VERIFY_REFUSED(Database::open(rig.address() + "0"), ErrorCode::ServerRefuses);
        const QString role = "closed_" + name;
        VERIFY_DONE(execute(rig.school().db, "CREATE ROLE " + role, "make it"));
        const auto refused = Database::open(QString(rig.address()).replace("school@", role + '@'));
        VERIFY_DONE(execute(rig.school().db, "DROP ROLE " + role, "drop it"));
        VERIFY_REFUSED(refused, ErrorCode::ServerRefuses, "not permitted to log in");
    }

    void aServersOwnFunctionsAreFoundFirst_data() { support::rows<QString>("home", {"public", "Cusp \"2\""}); }

    /// The owner of a database may set the search path of its sessions.
    void aServersOwnFunctionsAreFoundFirst()
    {
        QFETCH(QString, home);
        NEEDS_SERVER();
        const QString where = support::sharedServer().newDatabase();
        const QString name = Address::parse(where)->name;
        const QString quoted = '"' + QString(home).replace('"', "\"\"") + '"';
        {
            const auto database = Database::open(where).value();
            for (const QString& sql :
                 {QStringLiteral("ALTER SCHEMA public RENAME TO %1"), QStringLiteral("CREATE SCHEMA first"),
                  QStringLiteral("CREATE TABLE first.people AS SELECT 1 AS id"),
                  QStringLiteral(
                      "CREATE FUNCTION %1.substr(text, int) RETURNS text LANGUAGE sql AS $$ SELECT 'made up' $$"),
                  QStringLiteral("ALTER DATABASE %2 SET search_path = nowhere, first, %1, pg_catalog")})
                if (home != u"public" || !sql.contains("RENAME"))
                    VERIFY_DONE(
                        execute(database->handle(), QString(sql).replace("%1", quoted).replace("%2", name), "set it"));
        }
        const auto database = Database::open(where).value();
        QCOMPARE(ask(*database, "SELECT substr('abc', 2)").toString(), QStringLiteral("bc"));
        QCOMPARE(ask(*database, "SELECT current_schema()").toString(), home);
        QCOMPARE(ask(*database, "SELECT count(*) FROM people").toInt(), 0);
        VERIFY_DONE(database->reconnect());
        QCOMPARE(ask(*database, "SELECT substr('abc', 2)").toString(), QStringLiteral("bc"));
    }

    void saysWhoHoldsTheLock()
    {
        const auto holder = Database::open(at("busy.db")).value();
        const auto waiter = Database::open(at("busy.db"), 10ms).value();
        VERIFY_DONE(execute(holder->handle(), "BEGIN IMMEDIATE", "hold it"));
        std::vector<Migration> further = *shippedMigrations();
        further.push_back({static_cast<int>(further.size()) + 1, "CREATE TABLE later (id {row_id}) {table_options};"});
        VERIFY_REFUSED(migrate(waiter->handle(), further), ErrorCode::Busy, "another program is writing");
        VERIFY_DONE(execute(holder->handle(), "ROLLBACK", "let it go"));
        VERIFY_DONE(migrate(waiter->handle(), further));
    }

    void brokenStepLeavesAllAsItWas_data() { support::addEngines(); }
    void brokenStepLeavesAllAsItWas()
    {
        WHERE(where, "broken.db");
        const auto database = Database::open(where).value();
        const QSqlDatabase db = database->handle();
        std::vector<Migration> steps = *shippedMigrations();
        const int before = static_cast<int>(steps.size());
        steps.push_back({before + 1, "CREATE TABLE half (id {row_id}) {table_options};\nCREATE NONSENSE;\n"});

        QVERIFY(!migrate(db, steps).has_value());
        QCOMPARE(dialect::schemaVersion(db).value(), before);
        QVERIFY(!db.tables().contains("half"));

        steps.back().sql = "CREATE TABLE half (id {row_id}) {table_options};\n";
        VERIFY_DONE(migrate(db, steps));
        QCOMPARE(dialect::schemaVersion(db).value(), before + 1);
        QVERIFY(db.tables().contains("half"));
    }

    /// A shipped migration must never be edited: new databases would differ from existing ones, and no migration could
    /// bring them together. Put every change into a new migration with the next number, and add its line below
    /// (sha256sum database/migrations/*.sql) in the same commit.
    void stepsThatWereShippedAreNeverEdited()
    {
        const QByteArrayList asShipped{
            "d0cd6d8c966ab68d88423640e48d7476827c394ee4a665fba95add47620fffce",  // 0001_attempts.sql
            "88902679a6534ce6164b8da6463a8ef1c94ef74f179871df4af8ca34ab1dd715",  // 0002_lessons.sql
            "1598f18b4d5e8ca0d49114d4d97000beea976e79666251aec011335d100c8cae",  // 0003_people.sql
            "42e2a0d549de1cc59e0007d26641971e9bb160f6a0b1a258782f1798633a4a25",  // 0004_attempts_of_people.sql
            "237cdca8e5b5c491635d71741fe7cbf37306ee5bb1de98a30c449cf746208f74",  // 0005_presets_and_audit.sql
            "cc63a51f32da2d503c5a188886edbc6077ea45deafb36afcbe63332e5c449b8a",  // 0006_exam_starts.sql
            "a2214c4df6915b12d232e0cfda9250b36b40d1bed498daab1d4b7a13256f8a29",  // 0007_withdrawn_comments.sql
            "50e780a091ed98cac13d30c67bb3ff1eb14ad38fa7a208d719821b2c61c0dde4",  // 0008_class_pages.sql
            "b53460b8b1b0abba25a73895ce121676753d3e1f114708f0ded63e21942f23f2",  // 0009_lesson_versions.sql
            "8d8916e2a9518f8422a730aaaae1bac049ab18c62611d8d61a696b3ba83b84c6",  // 0010_erased_people.sql
            // add the next one here
        };
        const auto steps = shippedMigrations();
        VERIFY_DONE(steps);
        for (const Migration& step : *steps) {
            const QByteArray now = QCryptographicHash::hash(step.sql.toUtf8(), QCryptographicHash::Sha256).toHex();
            QVERIFY2(step.number <= asShipped.size(),
                     qPrintable(QStringLiteral("step %1 is new: it gets a line here, %2").arg(step.number).arg(now)));
            QVERIFY2(now == asShipped[step.number - 1],
                     qPrintable(QStringLiteral("step %1 was edited; add a new one instead").arg(step.number)));
        }
        QCOMPARE(static_cast<qsizetype>(steps->size()), asShipped.size());
    }

    void stepsRunInOrderAndOnlyOnce()
    {
        std::vector<Migration> more = *shippedMigrations();
        QVERIFY(!more.empty());
        for (std::size_t k = 0; k < more.size(); ++k)
            QCOMPARE(more[k].number, static_cast<int>(k) + 1);
        const auto database = Database::open(at("twice.db")).value();
        const int base = static_cast<int>(more.size());
        more.push_back({base + 1, "CREATE TABLE marks (mark {int64} NOT NULL) {table_options};\n"
                                  "-- a comment; with a semicolon\nINSERT INTO marks VALUES (1);\n"});
        more.push_back({base + 2, "INSERT INTO marks\n  VALUES (2);\n"});
        for (int round = 0; round < 2; ++round)
            VERIFY_DONE(migrate(database->handle(), more));
        QCOMPARE(ask(*database, "SELECT count(*) FROM marks").toInt(), 2);
    }

private:
    QString at(const char* name) const { return m_folder->filePath(name); }
    static QVariant ask(const Database& database, const QString& query)
    {
        return sql::ask(database.handle(), query, "look").value_or(QVariant());
    }
    static QByteArray bytes(const QString& path)
    {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    static void write(const QString& path, const QByteArray& content)
    {
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        QCOMPARE(file.write(content), content.size());
    }

    std::optional<QTemporaryDir> m_folder;
};

CUSP_TEST(TestDatabase)
#include "tst_database.moc"
