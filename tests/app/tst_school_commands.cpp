// SPDX-License-Identifier: GPL-3.0-or-later
// `cusp db`, `user`, `import` and `export`, as a technician types them.
#include <csignal>
#include <future>

#include <QDeadlineTimer>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QProcess>
#include <QScopeGuard>
#include <QTemporaryDir>
#include <QTest>
#include <QThread>
#include <pty.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include "app/cli/SchoolParts.h"
#include "database/Outbox.h"
#include "database/Passwords.h"
#include "database/sql/Backups.h"
#include "database/sql/Logins.h"
#include "database/sql/Statement.h"
#include "tests/database/Sample.h"
#include "tests/database/SchoolRig.h"
#include "tests/support/Program.h"

using support::Ending;
using support::runCusp;
using support::SchoolRig;

namespace {

const QByteArray kPassword = "correct horse\n";

QByteArray contentOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void put(const QString& path, const QByteArray& content)
{
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size())
        qWarning("%s was not written", qPrintable(path));
}

}  // namespace

class TestSchoolCommands : public QObject
{
    Q_OBJECT

private slots:
    void init();

    void aSchoolIsMadeAndPeopled();
    void withoutAFileItIsTheUsersOwn();
    void aClassListIsTriedAndEntered();
    void whoseCodeIsLostIsEnteredAllTheSame();
    void codesAndTablesOverwriteNothingElse();
    void tablesGoWhereALinkLeadsAndNeverIntoTheSchool();
    void tablesAreForTheirOwner();
    void pipesAndDevicesAreNoFiles();
    void attemptsAreExported();
    void whatABackupMissesIsSentAgain();
    void whatWaitsForASchoolThatWasRenamedIsSent();
    void aDamagedLetterIsSetAside();
    void whatWaitsForASchoolMovesWithIt();
    void aBackupOfAnotherSchoolIsNotRestored();
    void ofTwoSchoolsInOneFolderItIsAskedWhich();
    void whatIsNoFileIsNoBackup();
    void whatIsSentByManyIsCountedOnce();
    void aSignalLeavesNothingBehind_data();
    void aSignalLeavesNothingBehind();
    void nothingIsRestoredOverWhatIsNoDatabase();
    void anEmptySchoolReplacesNone();
    void aBackupOfAChangedAuditSaysSo();
    void aMigrationLetsRowsBeNumberedAgain();
    void whereTheSchoolCannotBeUsedABackupIsNamed();
    void aNewSchoolBesideBackupsSaysSo();
    void aFileThatIsGoneIsLookedForWhereARestoreMovedIt();
    void aFailedRestoreNamesWhatWasThere();
    void aLinkedFileIsRestoredWhereItLies();
    void aCopyIsSoundAndKnownHere();
    void ofTwoCopiesAtOnceOneIsThere();
    void aCopyThatFailsLeavesNothingBehind();
    void ofACopyThatFailsAServerHasNothing();
    void aCopyOfABusySchoolLeavesNothingBehind();
    void whoMayNotReadTheKeyLooksAllTheSame();
    void lookingLeavesNothingBehind();
    void namesThatAreNoFilesAreRefused();
    void whoStopsAtThePasswordSeesWhatHeTypes_data();
    void whoStopsAtThePasswordSeesWhatHeTypes();
    void wrongUsageIsExplained();

private:
    [[nodiscard]] QString at(const char* name) const { return m_folder->filePath(QLatin1String(name)); }
    [[nodiscard]] QString school() const { return at("school.sqlite"); }
    /// A part of the command on the school, done by the admin.
    [[nodiscard]] Ending byAdmin(QStringList words) const
    {
        words << "--db" << school() << "--as"
              << "admin";
        return runCusp(words, {}, kPassword);
    }
    [[nodiscard]] Ending onFile(QStringList words) const
    {
        words << "--db" << school();
        return runCusp(words);
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

void TestSchoolCommands::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    const Ending made = runCusp({"db", "init", "--db", school(), "--admin", "admin"}, {}, kPassword);
    QVERIFY2(made.exitCode == 0, made.error);
}

void TestSchoolCommands::aSchoolIsMadeAndPeopled()
{
    // A password that everybody guesses makes no school.
    const Ending weak = runCusp({"db", "init", "--db", at("weak.sqlite"), "--admin", "admin"}, {}, "password1\n");
    QCOMPARE(weak.exitCode, 1);
    QVERIFY(weak.isOneSentence());
    QVERIFY(!QFile::exists(at("weak.sqlite")));
    // Nor does a name that cannot be one.
    for (const QString& name : {QString("a b"), QString(" "), QString(""), QString(65, 'a')}) {
        const Ending unfit = runCusp({"db", "init", "--db", at("weak.sqlite"), "--admin", name}, {}, kPassword);
        QVERIFY2(unfit.exitCode == 1 && unfit.isOneSentence(), unfit.error);
        QVERIFY(!QFile::exists(at("weak.sqlite")));
    }
    // A file that was written on Windows ends its lines in its own way.
    QCOMPARE(runCusp({"user", "list", "--db", school(), "--as", "admin"}, {}, "correct horse\r\n").exitCode, 0);
    const Ending added =
        byAdmin({"user", "add", "s1", "--given", "Sam", "--family", "One", "--role", "student", "--json"});
    QVERIFY2(added.exitCode == 0, added.error);
    QVERIFY(added.json()["code"].toString().size() == 14);
    QCOMPARE(byAdmin({"user", "add", "s1"}).exitCode, 1);
    QCOMPARE(byAdmin({"user", "add", "x", "--role", "boss"}).exitCode, 2);
    QVERIFY(byAdmin({"user", "disable", "s1"}).out.contains("can no longer log in"));
    const QJsonArray people = byAdmin({"user", "list", "--json"}).json()["people"].toArray();
    QCOMPARE(people.size(), 2);
    QCOMPARE(people.last().toObject()["disabled"].toBool(), true);
    QVERIFY(byAdmin({"user", "disable", "s1", "--enable"}).out.contains("s1 can log in"));
    const Ending reset = byAdmin({"user", "reset", "s1", "--json"});
    QVERIFY(reset.json()["code"].toString() != added.json()["code"].toString());
    // Without the password, or the right, nothing is done.
    const Ending wrong = runCusp({"user", "list", "--db", school(), "--as", "admin"}, {}, "wrong horse\n");
    QCOMPARE(wrong.exitCode, 1);
    QVERIFY2(wrong.isOneSentence(), wrong.error);
    const Ending given = runCusp({"user", "list", "--db", school(), "--as", "admin"}, {}, {});  // as by Ctrl+D
    QCOMPARE(given.exitCode, 1);
    QVERIFY2(given.isOneSentence() && given.error.contains("no password was given"), given.error);
    QVERIFY(onFile({"user", "list"}).error.contains("--as"));
    QCOMPARE(byAdmin({"user", "disable", "admin"}).exitCode, 1);
    const QJsonObject checked = onFile({"db", "check", "--json"}).json();
    QCOMPARE(checked["sound"].toBool(), true);
    QVERIFY(checked["audit_rows"].toInt() > 5);
    QVERIFY(onFile({"db", "stats"}).out.contains("students     1"));
}

/// In the folder that the desktop keeps for the data of programs.
void TestSchoolCommands::withoutAFileItIsTheUsersOwn()
{
    const QStringList where{"XDG_DATA_HOME=" + at("data")};
    const QString own = at("data/cusp/cusp.sqlite");
    // Who only looks makes nothing.
    QCOMPARE(runCusp({"db", "stats"}, where).exitCode, 1);
    QVERIFY(!QFile::exists(own));
    const Ending made = runCusp({"db", "init", "--admin", "admin"}, where, kPassword);
    QVERIFY2(made.exitCode == 0, made.error);
    QVERIFY(QFile::exists(own));
    QCOMPARE(runCusp({"db", "stats", "--json"}, where).exitCode, 0);
    QCOMPARE(runCusp({"user", "list", "--as", "admin", "--json"}, where, kPassword).json()["people"].toArray().size(),
             1);
}

void TestSchoolCommands::aClassListIsTriedAndEntered()
{
    put(at("list.csv"), "username,given_name,family_name,role,class\nn1,Ada,One,,A\nn2,Bo,Two,instructor,A|B\n");
    const QJsonObject dry = byAdmin({"import", "roster", at("list.csv"), "--dry-run", "--json"}).json();
    QCOMPARE(dry["dry_run"].toBool(), true);
    QCOMPARE(dry["people"].toArray().size(), 2);
    QCOMPARE(byAdmin({"user", "list", "--json"}).json()["people"].toArray().size(), 1);
    put(at("short.csv"), "username,given_name,family_name,role,class\nn8,Ada,Eight\nn9,Ada,Two,,A\n");
    const QByteArray shorter = byAdmin({"import", "roster", at("short.csv"), "--dry-run"}).out;
    QVERIFY2(shorter.contains("fewer fields than the first line names: n8") && !shorter.contains("n9"), shorter);
    // Codes that go into a file are not told as well.
    const Ending done = byAdmin({"import", "roster", at("list.csv"), "--codes", at("codes.csv"), "--json"});
    QVERIFY2(done.exitCode == 0, done.error);
    QCOMPARE(done.json()["people"].toArray()[0].toObject()["code"].toString(), QString());
    const QByteArray codes = contentOf(at("codes.csv"));
    QVERIFY2(codes.contains("n1,Ada One,") && codes.contains("n2,Bo Two,"), codes);
    QVERIFY(!(QFile::permissions(at("codes.csv")) & (QFile::ReadGroup | QFile::ReadOther)));
    put(at("nobody.csv"), "username,given_name,family_name,role,class\n");
    for (const QStringList& way : {QStringList(), QStringList{"--dry-run"}}) {
        const Ending nobody = byAdmin(QStringList{"import", "roster", at("nobody.csv")} + way);
        QCOMPARE(nobody.exitCode, 1);
        QVERIFY2(nobody.error.contains("there is nobody in it") && nobody.out.isEmpty(), nobody.error);
    }
    put(at("bad.csv"), "username,role\nn3,boss\n,student\n");
    const Ending bad = byAdmin({"import", "roster", at("bad.csv")});
    QCOMPARE(bad.exitCode, 1);
    QVERIFY2(bad.error.contains("line 2, column role") && bad.error.contains("line 3, column username"), bad.error);
    QCOMPARE(byAdmin({"user", "list", "--json"}).json()["people"].toArray().size(), 3);
}

/// A full disk takes the answer, and with it the code.
void TestSchoolCommands::whoseCodeIsLostIsEnteredAllTheSame()
{
    put(at("list.csv"), "username\ns1002\n");
    const auto toFullDisk = [this](QStringList words) {
        words << "--db" << school() << "--as"
              << "admin";
        QProcess cusp;
        cusp.setStandardOutputFile("/dev/full");
        cusp.start(QStringLiteral(CUSP_BINARY_DIR "/bin/cusp"), words);
        cusp.write(kPassword);
        cusp.closeWriteChannel();
        cusp.waitForFinished();
        return Ending{cusp.exitCode(), {}, cusp.readAllStandardError(), 0};
    };
    for (const auto& [words, said] :
         {std::pair(QStringList{"user", "add", "s1001"},
                    "s1001 is entered, but the code is lost: \"cusp user reset s1001\" gives another"),
          std::pair(QStringList{"user", "reset", "s1001"},
                    "the password of s1001 is taken away, but the code is lost: \"cusp user reset s1001\" gives "
                    "another"),
          std::pair(QStringList{"import", "roster", at("list.csv")},
                    "the list is entered, but the codes are lost: \"cusp user reset\" gives each of the new ones "
                    "another")}) {
        const Ending full = toFullDisk(words);
        QCOMPARE(full.exitCode, 1);
        QVERIFY2(full.isOneSentence() && full.error.contains(said), full.error);
    }
    // Of what tells no code there is nothing to lose.
    QVERIFY(!toFullDisk({"user", "list"}).error.contains("code"));
    QCOMPARE(byAdmin({"user", "list", "--json"}).json().value("people").toArray().size(), 3);
}

void TestSchoolCommands::codesAndTablesOverwriteNothingElse()
{
    const QByteArray list = "username\nn1\n";
    put(at("list.csv"), list);
    for (const QString& target : {at("list.csv"), at("station.key"), school()}) {
        const QByteArray before = contentOf(target);
        const Ending refused = byAdmin({"import", "roster", at("list.csv"), "--codes", target});
        QVERIFY2(refused.exitCode == 1 && refused.isOneSentence(), refused.error);
        // The login alone is noted in the school.
        QCOMPARE(contentOf(target).left(16), before.left(16));
        QVERIFY(target == school() || contentOf(target) == before);
    }
    QCOMPARE(byAdmin({"user", "list", "--json"}).json()["people"].toArray().size(), 1);
    for (const QString& target : {at("station.key"), school(), QString("/dev/full"), m_folder->path()}) {
        const Ending refused = byAdmin({"export", "attempts", "--csv", target});
        QVERIFY2(refused.exitCode == 1 && refused.isOneSentence(), refused.error);
    }
    QVERIFY(!QFileInfo("/dev/full").isFile());
    // Last night's table is replaced.
    QCOMPARE(byAdmin({"export", "attempts", "--csv", at("attempts.csv")}).exitCode, 0);
    QCOMPARE(byAdmin({"export", "attempts", "--csv", at("attempts.csv")}).exitCode, 0);
    // What SQLite would take for its own is no name for a table, whichever way it is written.
    QVERIFY(QFile::link(m_folder->path(), at("door")));
    for (const QString& target : {school() + "-journal", school() + "-wal", at("door/school.sqlite-journal")}) {
        const bool wasThere = QFile::exists(target);
        for (const QStringList& words : {QStringList{"export", "attempts", "--csv", target},
                                         {"import", "roster", at("list.csv"), "--codes", target}}) {
            const Ending refused = byAdmin(words);
            QVERIFY2(refused.exitCode == 1 && refused.isOneSentence(), refused.error);
        }
        QCOMPARE(QFile::exists(target), wasThere);
    }
    QCOMPARE(byAdmin({"user", "list", "--json"}).json()["people"].toArray().size(), 1);
    QCOMPARE(onFile({"db", "check"}).exitCode, 0);
}

void TestSchoolCommands::tablesGoWhereALinkLeadsAndNeverIntoTheSchool()
{
    QVERIFY(QFile::link(school(), at("link.csv")));
    QVERIFY(QFile::link(at("link.csv"), at("twice.csv")));
    QVERIFY(QFile::link(at("nothing"), at("lost.csv")));
    const auto isRefused = [this](const char* name) {
        const Ending refused = byAdmin({"export", "attempts", "--csv", at(name)});
        return refused.exitCode == 1 && refused.isOneSentence();
    };
    for (const char* name : {"link.csv", "twice.csv", "lost.csv"})
        QVERIFY2(isRefused(name), name);
    QVERIFY(!QFile::exists(at("nothing")));
    // As long as it has two names nothing is done with it.
    QCOMPARE(link(qPrintable(school()), qPrintable(at("hard.csv"))), 0);
    QVERIFY(isRefused("hard.csv"));
    const Ending twoNames = onFile({"db", "check"});
    QVERIFY2(twoNames.exitCode == 1 && twoNames.isOneSentence() && twoNames.error.contains("hard links"),
             twoNames.error);
    QVERIFY(QFile::remove(at("hard.csv")));
    QCOMPARE(onFile({"db", "check"}).exitCode, 0);
    // Whatever the school's file is called.
    QCOMPARE(runCusp({"db", "init", "--db", at("school.csv"), "--admin", "admin"}, {}, kPassword).exitCode, 0);
    const Ending own = runCusp(
        {"export", "attempts", "--csv", at("school.csv"), "--db", at("school.csv"), "--as", "admin"}, {}, kPassword);
    QVERIFY2(own.exitCode == 1 && own.isOneSentence(), own.error);
    QCOMPARE(runCusp({"db", "check", "--db", at("school.csv")}).exitCode, 0);
    // A link to last night's table leads to this night's.
    put(at("table.csv"), "last night");
    QVERIFY(QFile::link(at("table.csv"), at("tonight.csv")));
    const Ending done = byAdmin({"export", "attempts", "--csv", at("tonight.csv")});
    QVERIFY2(done.exitCode == 0, done.error);
    QVERIFY(QFileInfo(at("tonight.csv")).isSymLink());
    QVERIFY(!contentOf(at("table.csv")).contains("last night"));
}

void TestSchoolCommands::tablesAreForTheirOwner()
{
    const QFile::Permissions others = QFile::ReadGroup | QFile::WriteGroup | QFile::ReadOther | QFile::WriteOther;
    QCOMPARE(byAdmin({"export", "attempts", "--csv", at("new.csv")}).exitCode, 0);
    QVERIFY(!(QFile::permissions(at("new.csv")) & others));
    // What somebody has set otherwise stays.
    QVERIFY(QFile::setPermissions(at("new.csv"), QFile::ReadOwner | QFile::WriteOwner | QFile::ReadGroup));
    QCOMPARE(byAdmin({"export", "attempts", "--csv", at("new.csv")}).exitCode, 0);
    QVERIFY(QFile::permissions(at("new.csv")) & QFile::ReadGroup);
}

void TestSchoolCommands::pipesAndDevicesAreNoFiles()
{
    QCOMPARE(mkfifo(qPrintable(at("pipe")), 0600), 0);
    const Ending list = byAdmin({"import", "roster", at("pipe")});
    QVERIFY2(list.exitCode == 1 && list.isOneSentence() && list.error.contains("is no file"), list.error);
    for (const QString& name : {at("pipe"), QString("/dev/zero"), QString("/dev/null")}) {
        const Ending stats = runCusp({"db", "stats", "--db", name});
        QVERIFY2(stats.exitCode == 1 && stats.isOneSentence() && stats.error.contains("is no file"), stats.error);
    }
    QVERIFY(QFile::remove(at("station.key")));
    QCOMPARE(mkfifo(qPrintable(at("station.key")), 0600), 0);
    const Ending checked = onFile({"db", "check"});
    QVERIFY2(checked.exitCode == 1 && checked.isOneSentence() && checked.error.contains("is no file"), checked.error);
}

void TestSchoolCommands::attemptsAreExported()
{
    const auto password = support::makeSchool(at("sample.sqlite"), {5, 40});
    VERIFY_DONE(password);
    const Ending csv = runCusp({"export", "attempts", "--csv", "-", "--db", at("sample.sqlite"), "--as", "admin"}, {},
                               QByteArray::fromStdString(*password) + '\n');
    QVERIFY2(csv.exitCode == 0, csv.error);
    QCOMPARE(csv.out.count("\r\n"), 41);
    QCOMPARE(onFile({"db", "check"}).exitCode, 0);
}

void TestSchoolCommands::aBackupOfAChangedAuditSaysSo()
{
    const Ending sound = onFile({"db", "backup"});
    QVERIFY2(sound.exitCode == 0 && sound.out.contains("and checked") && sound.error.isEmpty(), sound.error);
    const QString firstBackup = onFile({"db", "backup", "--json"}).json()["backup"].toString();
    {
        const auto database = database::sql::Database::open(school());
        QVERIFY(database);
        for (const char* deed : {"DROP TRIGGER audit_no_update", "UPDATE audit SET detail = 'x' WHERE seq = 2"})
            QVERIFY(database::sql::execute((*database)->handle(), deed, "change it"));
    }
    const Ending made = onFile({"db", "backup"});
    QVERIFY2(made.exitCode == 0 && !made.out.contains("checked"), made.out);
    QVERIFY2(made.error.count('\n') == 1 && made.error.contains("the audit in this backup"), made.error);
    const Ending again = onFile({"db", "backup", "--json"});
    QCOMPARE(again.json()["audit_whole"].toBool(true), false);
    // So does who brings it back.
    const QString backup = again.json()["backup"].toString();
    const Ending restored = onFile({"db", "restore", backup, "--json"});
    QVERIFY2(restored.exitCode == 0 && restored.error.contains("the audit in this backup"), restored.error);
    QCOMPARE(restored.json()["audit_whole"].toBool(true), false);
    const Ending whole = onFile({"db", "restore", firstBackup, "--json"});
    QVERIFY2(whole.exitCode == 0 && whole.error.isEmpty(), whole.error);
    QCOMPARE(whole.json()["audit_whole"].toBool(false), true);
}

/// Of a file whose numbers have been used up.
void TestSchoolCommands::aMigrationLetsRowsBeNumberedAgain()
{
    {
        const auto database = database::sql::Database::open(school());
        QVERIFY(database);
        QVERIFY(database::sql::execute((*database)->handle(), "UPDATE sqlite_sequence SET seq = 9223372036854775807",
                                       "use them up"));
    }
    QCOMPARE(byAdmin({"user", "add", "s1"}).exitCode, 1);
    QVERIFY(onFile({"db", "check"}).out.contains("cusp db migrate"));
    QCOMPARE(onFile({"db", "migrate"}).exitCode, 0);
    QCOMPARE(onFile({"db", "check"}).exitCode, 0);
    QCOMPARE(byAdmin({"user", "add", "s1"}).exitCode, 0);
    {
        const auto database = database::sql::Database::open(school());
        QVERIFY(database);
        QVERIFY(database::sql::execute((*database)->handle(),
                                       "UPDATE people SET id = 9223372036854775807 WHERE username = 's1'",
                                       "take the last one"));
    }
    const Ending migrated = onFile({"db", "migrate"});
    QVERIFY2(migrated.exitCode == 1 && migrated.isOneSentence() && migrated.error.contains("table people"),
             migrated.error);
}

/// Attempts that were delivered after the backup was made wait again, for the window to send them.
void TestSchoolCommands::whatABackupMissesIsSentAgain()
{
    const Ending backup = onFile({"db", "backup", "--json"});
    QVERIFY2(backup.exitCode == 0, backup.error);
    const auto key = database::StationKey::readOrMake(at("station.key"));
    QVERIFY(key);
    const database::Outbox outbox(at("outbox"), *key);
    QVERIFY(QDir(m_folder->path()).mkpath("outbox/arrived"));
    put(at("outbox/arrived/abc.attempt"), "a letter");
    QVERIFY(outbox.waiting().isEmpty());
    const Ending restored = onFile({"db", "restore", backup.json()["backup"].toString(), "--json"});
    QVERIFY2(restored.exitCode == 0, restored.error);
    QVERIFY(QFile::exists(restored.json()["replaced"].toString()));
    QCOMPARE(outbox.waiting().size(), 1);
    QVERIFY(outbox.arrived().isEmpty());
    QCOMPARE(onFile({"db", "check"}).exitCode, 0);
    QCOMPARE(onFile({"db", "drill"}).exitCode, 0);
    // Whatever goes wrong behind it: they wait.
    outbox.keepArrived(outbox.waiting().front());
    put(at("station.key"), "noise");
    QCOMPARE(onFile({"db", "restore", backup.json()["backup"].toString()}).exitCode, 1);
    QCOMPARE(outbox.waiting().size(), 1);
    QVERIFY(outbox.arrived().isEmpty());
}

void TestSchoolCommands::whatWaitsForASchoolThatWasRenamedIsSent()
{
    const auto key = database::StationKey::readOrMake(at("station.key"));
    QVERIFY(key);
    SchoolRig rig(false);
    rig.populate();
    const QString copy = database::sql::backUp(rig.school().db, at("b"), rig.nowUtc).value();
    QVERIFY(QFile::copy(copy, at("renamed.sqlite")) && QFile::copy(copy, at("backup-2026-11-20-10.15.00.sqlite")));
    database::Outbox outbox(at("outbox"), *key, "older.sqlite");
    QVERIFY(outbox.put(rig.student, SchoolRig::attempt("class1-36", 500), {}).has_value());
    QVERIFY(outbox.put(rig.student, database::ExamStart{database::newUid(), "exam-36", "2026-11-20T10:00:00Z"}));
    const Ending refused = runCusp({"db", "send", "--db", at("backup-2026-11-20-10.15.00.sqlite")});
    QVERIFY2(refused.exitCode == 1 && refused.isOneSentence(), refused.error);
    // Who sent it is not known in this one.
    QCOMPARE(onFile({"db", "send", "--json"}).json()["waiting"].toInt(), 2);
    QCOMPARE(outbox.waiting().size(), 2);
    const Ending sent = runCusp({"db", "send", "--json", "--db", at("renamed.sqlite")});
    QVERIFY2(sent.exitCode == 0, sent.error);
    QCOMPARE(sent.json()["sent"].toInt(), 2);
    QVERIFY(outbox.waiting().isEmpty());
    QCOMPARE(outbox.arrived().size(), 2);
}

void TestSchoolCommands::aDamagedLetterIsSetAside()
{
    const auto key = database::StationKey::readOrMake(at("station.key"));
    QVERIFY(key && QDir(m_folder->path()).mkpath("outbox"));
    const database::Outbox outbox(at("outbox"), *key);
    put(at("outbox/spoilt.attempt"), "noise");
    const Ending sent = onFile({"db", "send", "--json"});
    QVERIFY2(sent.exitCode == 1 && sent.error.contains("kept in the folder \"damaged\""), sent.error);
    QCOMPARE(sent.json()["damaged"].toInt(), 1);
    QCOMPARE(sent.json()["waiting"].toInt(-1), 0);
    QCOMPARE(contentOf(at("outbox/damaged/spoilt.attempt")), QByteArray("noise"));
    QVERIFY(outbox.waiting().isEmpty());
    QCOMPARE(onFile({"db", "send"}).exitCode, 0);
}

/// Beside the copy nobody would look for it.
void TestSchoolCommands::whatWaitsForASchoolMovesWithIt()
{
    const auto key = database::StationKey::readOrMake(at("station.key"));
    QVERIFY(key && QDir(m_folder->path()).mkpath("new"));
    SchoolRig rig(false);
    rig.populate();
    const QString moving = at("moving.sqlite");
    QVERIFY(QFile::copy(database::sql::backUp(rig.school().db, at("b"), rig.nowUtc).value(), moving));
    database::Outbox own(at("outbox"), *key, "moving.sqlite");
    database::Outbox others(at("outbox"), *key, "school.sqlite");
    const auto keep = [&](database::Outbox& outbox, const database::Session& who) {
        return outbox.put(who, SchoolRig::attempt("class1-36", 500), {}).has_value();
    };
    const auto copy = [&](const char* to) {
        return runCusp({"db", "copy", "--json", "--db", moving, "--as", "admin", "--to", at(to)}, {}, kPassword);
    };
    const auto attemptsIn = [&](const char* file) {
        return runCusp({"db", "stats", "--json", "--db", at(file)}).json()["attempts"].toInt();
    };
    QVERIFY(keep(own, rig.student) && keep(others, rig.student));
    const Ending copied = copy("new/copy.sqlite");
    QVERIFY2(copied.exitCode == 0 && !copied.error.contains("wait"), copied.error);
    QCOMPARE(copied.json()["sent"].toInt(), 1);
    QCOMPARE(attemptsIn("new/copy.sqlite"), 1);
    QCOMPARE(own.waiting().size(), 1);
    QCOMPARE(own.arrived().size(), 1);
    // Of somebody who is not there.
    SchoolRig foreign(false);
    foreign.populate();
    QVERIFY(keep(own, foreign.student));
    const Ending left = copy("new/second.sqlite");
    QVERIFY2(left.exitCode == 0 && left.error.contains("1 attempts and beginnings of exams wait beside"), left.error);
    QCOMPARE(left.json()["waiting"].toInt(), 1);
    QCOMPARE(attemptsIn("new/second.sqlite"), 1);
}

void TestSchoolCommands::aBackupOfAnotherSchoolIsNotRestored()
{
    QVERIFY(runCusp({"db", "init", "--db", at("other.sqlite"), "--admin", "boss"}, {}, kPassword).exitCode == 0);
    QVERIFY(QDir(m_folder->path()).mkdir("drive"));
    const QString mine = onFile({"db", "backup", "--to", at("drive"), "--json"}).json()["backup"].toString();
    const QString others = runCusp({"db", "backup", "--db", at("other.sqlite"), "--to", at("drive"), "--json"})
                               .json()["backup"]
                               .toString();
    QVERIFY(!mine.isEmpty() && !others.isEmpty() && mine != others);
    const Ending refused = onFile({"db", "restore", others});
    QCOMPARE(refused.exitCode, 1);
    QVERIFY2(refused.isOneSentence() && refused.error.contains("another school"), refused.error);
    QCOMPARE(byAdmin({"user", "list"}).exitCode, 0);
    // What cannot be read any more is known by the backups beside it; without those nobody knows, and is told.
    const QByteArray noise(50'000, 'n');
    const QString beside = onFile({"db", "backup", "--json"}).json()["backup"].toString();
    put(school(), noise);
    const Ending still = onFile({"db", "restore", others});
    QVERIFY2(still.exitCode == 1 && still.isOneSentence() && still.error.contains("another school"), still.error);
    QCOMPARE(contentOf(school()), noise);
    QVERIFY(QFile::remove(beside));
    // The folder in which it lies has backups of several.
    const Ending asked = onFile({"db", "restore", others});
    QVERIFY2(asked.exitCode == 1 && asked.isOneSentence() && asked.error.contains("--any-school"), asked.error);
    QCOMPARE(contentOf(school()), noise);
    const Ending untold = onFile({"db", "restore", others, "--any-school", "--json"});
    QVERIFY2(untold.exitCode == 0 && untold.error.contains("is not known"), untold.error);
    QCOMPARE(untold.json()["compared"].toBool(true), false);
}

/// A folder that several schools share says whose a damaged file may have been, and not whose it was.
void TestSchoolCommands::ofTwoSchoolsInOneFolderItIsAskedWhich()
{
    QVERIFY(runCusp({"db", "init", "--db", at("other.sqlite"), "--admin", "boss"}, {}, kPassword).exitCode == 0);
    const QString folder = database::sql::backupFolder(school());
    const QString mine = onFile({"db", "backup", "--json"}).json()["backup"].toString();
    const QString others =
        runCusp({"db", "backup", "--db", at("other.sqlite"), "--to", folder, "--json"}).json()["backup"].toString();
    const QByteArray noise(50'000, 'n');
    put(school(), noise);
    for (const QString& either : {mine, others}) {
        const Ending asked = onFile({"db", "restore", either});
        QVERIFY2(asked.exitCode == 1 && asked.isOneSentence() && asked.error.contains("--any-school"), asked.error);
        QVERIFY2(asked.error.contains("the first of them admin") && asked.error.contains("the first of them boss") &&
                     asked.error.contains(QDate::currentDate().toString("yyyy").toUtf8()),
                 asked.error);
        QCOMPARE(contentOf(school()), noise);
    }
    const Ending done = onFile({"db", "restore", mine, "--any-school", "--json"});
    QVERIFY2(done.exitCode == 0 && done.error.contains("is not known"), done.error);
    QCOMPARE(byAdmin({"user", "list"}).exitCode, 0);
    // A file that can be read says itself whose it is, whatever anybody says.
    const Ending sound = onFile({"db", "restore", others, "--any-school"});
    QVERIFY2(sound.exitCode == 1 && sound.error.contains("another school"), sound.error);
}

void TestSchoolCommands::whatIsNoFileIsNoBackup()
{
    QCOMPARE(mkfifo(qPrintable(at("pipe")), 0600), 0);
    for (const auto& [name, said] :
         {std::pair(QString("/dev/zero"), "no file but a device or a pipe"),
          std::pair(at("pipe"), "no file but a device or a pipe"), std::pair(m_folder->path(), "this is a folder"),
          std::pair(at("nothing"), "there is no such file")}) {
        const Ending refused = onFile({"db", "restore", name});
        QVERIFY2(refused.exitCode == 1 && refused.isOneSentence() && refused.error.contains(said), refused.error);
    }
}

/// Whoever else delivers at the same time.
void TestSchoolCommands::whatIsSentByManyIsCountedOnce()
{
    const auto key = database::StationKey::readOrMake(at("station.key"));
    QVERIFY(key);
    SchoolRig rig(false);
    rig.populate();
    const QString copy = database::sql::backUp(rig.school().db, at("b"), rig.nowUtc).value();
    QVERIFY(QFile::copy(copy, at("busy.sqlite")));
    database::Outbox outbox(at("outbox"), *key, "busy.sqlite");
    constexpr int kLetters = 60;
    for (int k = 0; k < kLetters; ++k)
        QVERIFY(outbox.put(rig.student, SchoolRig::attempt("class1-36", 500 + k), {}).has_value());
    std::vector<std::future<Ending>> all;
    for (int k = 0; k < 4; ++k)
        all.push_back(std::async(std::launch::async, [this] {
            return runCusp({"db", "send", "--json", "--db", at("busy.sqlite")});
        }));
    int sent = 0;
    for (auto& one : all) {
        const Ending ending = one.get();
        sent += ending.json()["sent"].toInt();
    }
    QVERIFY(outbox.waiting().isEmpty());
    QCOMPARE(sent, kLetters);
    QCOMPARE(runCusp({"db", "stats", "--db", at("busy.sqlite"), "--json"}).json()["attempts"].toInt(), kLetters);
}

void TestSchoolCommands::aSignalLeavesNothingBehind_data()
{
    QTest::addColumn<QStringList>("words");
    QTest::newRow("backup") << QStringList{"db", "backup", "--to", "there"};
    QTest::newRow("restore") << QStringList{"db", "restore", "backup.sqlite"};
    QTest::newRow("drill") << QStringList{"db", "drill"};
    QTest::newRow("copy") << QStringList{"db", "copy", "--to", "there/copy.sqlite", "--as", "admin"};
    QTest::newRow("export") << QStringList{"export", "attempts", "--csv", "there/table.csv", "--as", "admin"};
}

/// Whenever it comes: what is there by its name is whole, and nothing half made is there by another.
void TestSchoolCommands::aSignalLeavesNothingBehind()
{
    QFETCH(QStringList, words);
    QFile::remove(school());
    const auto made = support::makeSchool(school(), {20, 3000});
    VERIFY_DONE(made);
    {
        const auto opened = database::sql::Database::open(school());
        VERIFY_DONE(opened);
        for (const char* sql : {"CREATE TABLE ballast (x)", "INSERT INTO ballast VALUES (zeroblob(40000000))"})
            VERIFY_DONE(database::sql::execute((*opened)->handle(), sql, "make it large"));
    }
    const QByteArray password = QByteArray::fromStdString(*made) + '\n';
    const QString backup = onFile({"db", "backup", "--to", at("kept"), "--json"}).json()["backup"].toString();
    QVERIFY(QDir(m_folder->path()).mkdir("there") && QFile::rename(backup, at("backup.sqlite")));
    const auto half = [this] {
        QStringList found;
        for (const char* folder : {"", "there"})
            found << QDir(at(folder))
                         .entryList({"*.part-*", "*.restoring*", "cusp-drill-*", "table.csv?*"},
                                    QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
        return found;
    };
    int stopped = 0;
    for (int round = 0; round < 24; ++round) {
        QProcess cusp;
        cusp.setWorkingDirectory(m_folder->path());
        cusp.start(QStringLiteral(CUSP_BINARY_DIR "/bin/cusp"), words + QStringList{"--db", school()});
        QVERIFY(cusp.waitForStarted());
        cusp.write(password);
        cusp.closeWriteChannel();
        QThread::msleep(static_cast<unsigned long>(round) * 15);
        ::kill(static_cast<pid_t>(cusp.processId()), round % 3 == 0 ? SIGINT : round % 3 == 1 ? SIGTERM : SIGHUP);
        QVERIFY(cusp.waitForFinished());
        stopped += cusp.exitStatus() == QProcess::CrashExit ? 1 : 0;
        QVERIFY2(half().isEmpty(), qPrintable(half().join(u' ')));
        QCOMPARE(runCusp({"db", "stats", "--db", school(), "--json"}).json()["attempts"].toInt(), 3000);
        const QString copy = at("there/copy.sqlite");
        if (QFile::exists(copy)) {
            const Ending there = runCusp({"db", "stats", "--db", copy, "--json"});
            QVERIFY2(there.exitCode != 0 || there.json()["attempts"].toInt() == 3000, there.out);
        }
        QDir(at("there")).removeRecursively();
        QVERIFY(QDir(m_folder->path()).mkdir("there"));
    }
    QVERIFY(stopped > 0);
}

void TestSchoolCommands::nothingIsRestoredOverWhatIsNoDatabase()
{
    const QString backup = onFile({"db", "backup", "--json"}).json()["backup"].toString();
    QVERIFY(QDir(m_folder->path()).mkdir("folder.sqlite"));
    put(at("folder.sqlite/thesis"), "years of work");
    QCOMPARE(mkfifo(qPrintable(at("pipe.sqlite")), 0600), 0);
    QVERIFY(QFile::link(at("pipe.sqlite"), at("link.sqlite")));
    const QStringList before = QDir(m_folder->path()).entryList(QDir::AllEntries | QDir::System);
    for (const char* name : {"folder.sqlite", "pipe.sqlite", "link.sqlite"}) {
        const Ending refused = runCusp({"db", "restore", backup, "--db", at(name)});
        QVERIFY2(refused.exitCode == 1 && refused.isOneSentence(), name);
    }
    QCOMPARE(QDir(m_folder->path()).entryList(QDir::AllEntries | QDir::System), before);
    QVERIFY(QFile::exists(at("folder.sqlite/thesis")));
    QVERIFY(QFile::link(school(), at("itself.sqlite")));
    for (const QString& itself : {school(), at("itself.sqlite")}) {
        const Ending refused = onFile({"db", "restore", itself});
        QVERIFY2(refused.exitCode == 1 && refused.isOneSentence() && refused.error.contains("the database itself"),
                 refused.error);
    }
    QCOMPARE(onFile({"db", "check"}).exitCode, 0);
}

void TestSchoolCommands::anEmptySchoolReplacesNone()
{
    QCOMPARE(runCusp({"db", "init", "--db", at("empty.sqlite")}).exitCode, 0);
    const Ending refused = onFile({"db", "restore", at("empty.sqlite")});
    QVERIFY2(refused.exitCode == 1 && refused.isOneSentence() && refused.error.contains("nobody"), refused.error);
    QCOMPARE(byAdmin({"user", "list"}).exitCode, 0);
    // Where there is no school it takes nothing away.
    QCOMPARE(runCusp({"db", "restore", at("empty.sqlite"), "--db", at("new.sqlite")}).exitCode, 0);
}

void TestSchoolCommands::whereTheSchoolCannotBeUsedABackupIsNamed()
{
    put(at("list.csv"), "username,given_name,family_name,role,class\nn1,Ada,One,,A\n");
    const QByteArray backup = onFile({"db", "backup", "--json"}).json()["backup"].toString().toUtf8();
    for (const bool isThere : {true, false}) {
        put(school(), QByteArray(50'000, 'n'));
        QVERIFY(isThere || QFile::remove(school()));
        for (const QStringList& words : {QStringList{"user", "list"},
                                         {"user", "add", "s1"},
                                         {"import", "roster", at("list.csv")},
                                         {"export", "attempts", "--csv", at("table.csv")},
                                         {"db", "check"}}) {
            const Ending refused = words.front() == u"db" ? onFile(words) : byAdmin(words);
            QVERIFY2(refused.exitCode == 1 && refused.isOneSentence() && refused.error.contains(backup) &&
                         refused.error.contains("cusp db restore"),
                     refused.error);
        }
    }
}

void TestSchoolCommands::aNewSchoolBesideBackupsSaysSo()
{
    const QByteArray backup = onFile({"db", "backup", "--json"}).json()["backup"].toString().toUtf8();
    QVERIFY(!onFile({"db", "init"}).error.contains("backup"));
    QVERIFY(QFile::remove(school()));
    const Ending made = onFile({"db", "init"});
    QVERIFY2(made.exitCode == 0 && made.error.contains("cusp db restore " + backup), made.error);
    const QJsonObject checked = onFile({"db", "check", "--json"}).json();
    QCOMPARE(checked["audit_code"].toString(), QString("0"));
}

/// As a restore leaves it that was stopped between the two.
void TestSchoolCommands::aFileThatIsGoneIsLookedForWhereARestoreMovedIt()
{
    const QString aside = at("replaced-2026-11-20-10.15.00-school.sqlite");
    QVERIFY(QFile::rename(school(), aside));
    const Ending missed = onFile({"db", "stats"});
    QVERIFY2(missed.exitCode == 1 && missed.isOneSentence() && missed.error.contains(aside.toUtf8()), missed.error);
    // Nor is it forgotten when a new one is begun there.
    const Ending made = onFile({"db", "init"});
    QVERIFY2(made.exitCode == 0 && made.error.contains("cusp db restore " + aside.toUtf8()), made.error);
    const Ending checked = onFile({"db", "check"});
    QVERIFY2(checked.exitCode == 0 && checked.error.contains(aside.toUtf8()), checked.error);
    QVERIFY(onFile({"db", "init"}).error.contains("cusp db restore " + aside.toUtf8()));
    QCOMPARE(onFile({"db", "restore", aside}).exitCode, 0);
    QCOMPARE(byAdmin({"user", "list"}).exitCode, 0);
    QVERIFY(onFile({"db", "check"}).error.isEmpty());
}

void TestSchoolCommands::aFailedRestoreNamesWhatWasThere()
{
    const QString backup = onFile({"db", "backup", "--json"}).json()["backup"].toString();
    put(at("station.key"), "noise");
    const Ending failed = onFile({"db", "restore", backup});
    QVERIFY2(failed.exitCode == 1 && failed.isOneSentence(), failed.error);
    const QStringList aside = QDir(m_folder->path()).entryList({"replaced-*-school.sqlite"}, QDir::Files);
    QCOMPARE(aside.size(), 1);
    QVERIFY2(failed.error.contains(aside.front().toUtf8()), failed.error);
}

void TestSchoolCommands::aLinkedFileIsRestoredWhereItLies()
{
    QVERIFY(QDir(m_folder->path()).mkdir("links"));
    const QString link = at("links/link.sqlite");
    QVERIFY(QFile::link(school(), link));
    const QString backup = onFile({"db", "backup", "--json"}).json()["backup"].toString();
    QCOMPARE(byAdmin({"user", "add", "later"}).exitCode, 0);
    QCOMPARE(runCusp({"db", "restore", backup, "--db", link}).exitCode, 0);
    QVERIFY(QFileInfo(link).isSymLink());
    QCOMPARE(byAdmin({"user", "list", "--json"}).json()["people"].toArray().size(), 1);
    QCOMPARE(QDir(at("links")).entryList(QDir::Files | QDir::Hidden).size(), 1);
}

void TestSchoolCommands::aCopyIsSoundAndKnownHere()
{
    QVERIFY(QDir(m_folder->path()).mkdir("new"));
    const Ending copied = byAdmin({"db", "copy", "--to", at("new/copy.sqlite")});
    QVERIFY2(copied.exitCode == 0, copied.error);
    const Ending checked = runCusp({"db", "check", "--db", at("new/copy.sqlite")});
    QVERIFY2(checked.exitCode == 0, checked.out);
}

/// Who comes too late takes nothing away from the other.
void TestSchoolCommands::ofTwoCopiesAtOnceOneIsThere()
{
    for (int round = 0; round < 3; ++round) {
        const QString target = m_folder->filePath(QStringLiteral("copy-%1.sqlite").arg(round));
        const auto copy = [this, target] { return byAdmin({"db", "copy", "--to", target}); };
        std::future<Ending> other = std::async(std::launch::async, copy);
        const Ending one = copy();
        const Ending two = other.get();
        QVERIFY2(one.exitCode == 0 || two.exitCode == 0, one.error + two.error);
        QCOMPARE(runCusp({"db", "stats", "--db", target, "--json"}).json()["admins"].toInt(), 1);
    }
}

void TestSchoolCommands::aCopyThatFailsLeavesNothingBehind()
{
    {
        const auto opened = database::sql::Database::open(school());
        VERIFY_DONE(opened);
        const database::sql::School there{(*opened)->handle(),
                                          database::StationKey::readOrMake(at("station.key")).value()};
        const auto admin = database::sql::Logins::login(there, "admin", kPassword.trimmed().toStdString());
        VERIFY_DONE(admin);
        VERIFY_DONE(support::addAttempt(there, *admin, SchoolRig::attempt("class1-36", 500), "a recording"));
    }
    QVERIFY(QDir(m_folder->path()).mkdir("new"));
    put(at("new/recordings"), "no folder");
    const Ending copied = byAdmin({"db", "copy", "--to", at("new/copy.sqlite")});
    QVERIFY2(copied.exitCode == 1, copied.out);
    QCOMPARE(QDir(at("new")).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot),
             QStringList{"recordings"});
    // Where there was a key it stays.
    QCOMPARE(byAdmin({"db", "copy", "--to", school()}).exitCode, 1);
    QVERIFY(QFile::exists(at("station.key")) && QFile::exists(school()));
    QCOMPARE(onFile({"db", "check"}).exitCode, 0);
}

/// What a server does not take.
void TestSchoolCommands::ofACopyThatFailsAServerHasNothing()
{
    if (!support::sharedServer().fault().isEmpty())
        QSKIP(qPrintable(support::sharedServer().fault()));
    const QString where = support::sharedServer().newDatabase();
    const auto tables = [&where]() -> core::Result<int> {
        const auto address = database::Address::parse(where);
        database::sql::Database::Options options;
        options.isToBeFilled = true;
        const auto opened = database::sql::Database::open(*address, options);
        if (!opened)
            return tl::unexpected(opened.error());
        return database::sql::dialect::countTables((*opened)->handle());
    };
    const auto setName = [this](const char* name) {
        const auto opened = database::sql::Database::open(school());
        return opened &&
               database::sql::execute((*opened)->handle(),
                                      QStringLiteral("UPDATE people SET family_name = %1").arg(name), "do it");
    };
    QVERIFY(setName("'a' || char(0) || 'b'"));
    const Ending refused = byAdmin({"db", "copy", "--to", where});
    QVERIFY2(refused.exitCode == 1 && refused.isOneSentence(), refused.error);
    QCOMPARE(tables().value_or(-1), 0);
    QVERIFY(setName("'b'"));
    const Ending copied = byAdmin({"db", "copy", "--to", where});
    QVERIFY2(copied.exitCode == 0, copied.error);
    QVERIFY(tables().value_or(-1) > 10);
}

/// Another program writes to it, once who copies is logged in: until then it would be the login that waits.
void TestSchoolCommands::aCopyOfABusySchoolLeavesNothingBehind()
{
    QVERIFY(QDir(m_folder->path()).mkdir("new"));
    const QString target = at("new/copy.sqlite");
    const auto opened = database::sql::Database::open(school());
    VERIFY_DONE(opened);
    const QSqlDatabase other = (*opened)->handle();
    std::future<Ending> copying = std::async(std::launch::async, [this, target] {
        return byAdmin({"db", "copy", "--to", target});
    });
    const QDeadlineTimer patience(30'000);
    while (!QFile::exists(target) && !patience.hasExpired())
        QThread::yieldCurrentThread();
    const auto begun = database::sql::execute(other, "BEGIN IMMEDIATE", "keep it busy");
    const Ending copied = copying.get();
    VERIFY_DONE(begun);
    VERIFY_DONE(database::sql::execute(other, "ROLLBACK", "let others write"));
    QVERIFY2(copied.exitCode == 1 && copied.error.contains("another program is writing to it"), copied.error);
    QCOMPARE(QDir(at("new")).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot), QStringList());
}

/// It is its owner's alone.
void TestSchoolCommands::whoMayNotReadTheKeyLooksAllTheSame()
{
    QCOMPARE(chmod(qPrintable(at("station.key")), 0), 0);
    QCOMPARE(chmod(qPrintable(school()), 0644), 0);
    QCOMPARE(chmod(qPrintable(m_folder->path()), 0755), 0);
    // To root no file is closed.
    constexpr uid_t kNobody = 65534;
    const uid_t me = geteuid();
    QCOMPARE(me == 0 ? seteuid(kNobody) : 0, 0);
    const auto back = qScopeGuard([me] { QCOMPARE(seteuid(me), 0); });
    const auto address = database::Address::parse(school());
    VERIFY_DONE(address);
    const auto looked = app::cli::openSchool(*address, app::cli::Opening::ToLook);
    VERIFY_DONE(looked);
    QVERIFY(!looked->hasStationKey);
    QVERIFY2(looked->keyFault.find("station.key") != std::string::npos, looked->keyFault.c_str());
    QVERIFY(!app::cli::openSchool(*address, app::cli::Opening::AsItIs).has_value());
}

void TestSchoolCommands::lookingLeavesNothingBehind()
{
    const QString backup = onFile({"db", "backup", "--json"}).json()["backup"].toString();
    const QDir folder = QFileInfo(backup).dir();
    QCOMPARE(runCusp({"db", "check", "--db", backup}).exitCode, 0);
    QCOMPARE(runCusp({"db", "stats", "--db", backup}).exitCode, 0);
    QCOMPARE(folder.entryList(QDir::Files), QStringList{QFileInfo(backup).fileName()});
}

void TestSchoolCommands::namesThatAreNoFilesAreRefused()
{
    for (const char* name : {":memory:", "file:x?mode=memory", ":x.sqlite", "mysql://x/y", " ", "postgresql://x/%00",
                             "postgresql://x%0A/y"}) {
        const Ending refused = runCusp({"db", "init", "--db", name});
        QVERIFY2(refused.exitCode == 1 && refused.isOneSentence(), name);
    }
    // As a copied address may hold it.
    for (const char* name : {"postgresql://x%E2%80%8B/y", "postgresql://x/y%E2%80%8B", "postgresql://u%E2%80%8B@x/y"}) {
        const Ending refused = runCusp({"db", "init", "--db", name});
        QVERIFY2(refused.exitCode == 1 && refused.error.contains("cannot be seen"), refused.error);
    }
}

void TestSchoolCommands::whoStopsAtThePasswordSeesWhatHeTypes_data()
{
    QTest::addColumn<int>("signal");
    QTest::newRow("Ctrl+C") << SIGINT;
    QTest::newRow("ended") << SIGTERM;
    QTest::newRow("the terminal is closed") << SIGHUP;
}

/// A halt and going on comes first: nothing is shown then, either. As a shell would have begun it, which waits beside.
void TestSchoolCommands::whoStopsAtThePasswordSeesWhatHeTypes()
{
    QFETCH(int, signal);
    const QByteArray file = school().toLocal8Bit();
    int terminal = -1;
    const pid_t shell = forkpty(&terminal, nullptr, nullptr, nullptr);
    if (shell == 0) {
        const pid_t cusp = fork();
        if (cusp == 0) {
            setpgid(0, 0);
            ::signal(SIGTTOU, SIG_IGN);
            tcsetpgrp(STDIN_FILENO, getpid());
            ::signal(SIGTTOU, SIG_DFL);
            execl(CUSP_BINARY_DIR "/bin/cusp", "cusp", "user", "list", "--as", "admin", "--db", file.constData(),
                  nullptr);
            _exit(127);
        }
        int status = 0;
        waitpid(cusp, &status, 0);
        _exit(WIFSIGNALED(status) ? WTERMSIG(status) : 0);
    }
    const auto closed = qScopeGuard([&] {
        kill(shell, SIGKILL);
        waitpid(shell, nullptr, 0);
        close(terminal);
    });
    const auto isShown = [&terminal] {
        termios now{};
        return tcgetattr(terminal, &now) == 0 && (now.c_lflag & ECHO) != 0;
    };
    QTRY_VERIFY(!isShown());
    const pid_t cusp = tcgetpgrp(terminal);
    QVERIFY(cusp > 0 && cusp != shell);
    QCOMPARE(kill(cusp, SIGTSTP), 0);
    QTRY_VERIFY(contentOf(QStringLiteral("/proc/%1/stat").arg(cusp)).contains(") T "));
    QVERIFY(isShown());
    QCOMPARE(kill(cusp, SIGCONT), 0);
    QTRY_VERIFY(!isShown());
    QCOMPARE(kill(cusp, signal), 0);
    int status = 0;
    bool isOver = false;
    QTRY_VERIFY(isOver = isOver || waitpid(shell, &status, WNOHANG) == shell);
    QVERIFY(WIFEXITED(status));
    QCOMPARE(WEXITSTATUS(status), signal);
    QVERIFY(isShown());
}

void TestSchoolCommands::wrongUsageIsExplained()
{
    for (const QStringList& words : {QStringList{"db"},
                                     {"db", "paint"},
                                     {"db", "restore"},
                                     {"db", "copy"},
                                     {"db", "check", "--db", school(), "--witness", "412-9f3ac07be1d"},
                                     {"db", "copy", "--db", school(), "--to", at("copy.sqlite")},
                                     {"db", "measure", "--db", school()},
                                     {"user", "list", "--db", school()},
                                     {"user", "list", "--db", school(), "--as", ""},
                                     {"import", "roster", "list.csv", "--db", school()},
                                     {"export", "attempts", "--csv", "-", "--db", school()},
                                     {"user"},
                                     {"user", "add"},
                                     {"import"},
                                     {"import", "roster"},
                                     {"export", "attempts"}}) {
        const Ending ending = runCusp(words);
        QVERIFY2(ending.exitCode == 2, qPrintable(words.join(' ')));
    }
}

QTEST_GUILESS_MAIN(TestSchoolCommands)
#include "tst_school_commands.moc"
