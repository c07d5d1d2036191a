// SPDX-License-Identifier: GPL-3.0-or-later
// The commands `cusp db`, `user`, `import` and `export`, run as a technician does.
#include <csignal>

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QProcess>
#include <QScopeGuard>
#include <QTemporaryDir>
#include <QTest>
#include <pty.h>
#include <pwd.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include "cli/parts/SchoolParts.h"
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
    void initTestCase()
    {
        expectDone(
            runCusp({"db", "init", "--db", m_made.filePath("school.sqlite"), "--admin", "admin"}, {}, kPassword));
        m_rig.populate();
        m_peopled = database::sql::backUp(m_rig.school().db, m_made.filePath("b"), m_rig.nowUtc).value();
    }

    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        for (const char* name : {"school.sqlite", "station.key"})
            QVERIFY(QFile::copy(m_made.filePath(name), at(name)));
    }

    /// A service may run without HOME: its files are in the home folder of its account, not in "/".
    void withoutHomeTheAccountsFolderIsUsed()
    {
        const Ending ending = runCusp({"db", "stats"}, {"HOME=", "XDG_DATA_HOME="});
        QVERIFY2(!ending.error.contains("//"), ending.error);
        if (ending.exitCode != 0)
            QVERIFY2(ending.error.contains(QByteArray(getpwuid(geteuid())->pw_dir) + "/.local/share/cusp/"),
                     ending.error);
    }

    void aSchoolIsMadeAndPeopled()
    {
        // A common password is refused, and no school is created.
        const Ending weak = runCusp({"db", "init", "--db", at("weak.sqlite"), "--admin", "admin"}, {}, "password1\n");
        expectRefusal(weak);
        QVERIFY(!QFile::exists(at("weak.sqlite")));
        // An invalid username is refused likewise.
        for (const QString& name : {QString("a b"), QString(" "), QString(""), QString(65, 'a')}) {
            expectRefusal(runCusp({"db", "init", "--db", at("weak.sqlite"), "--admin", name}, {}, kPassword));
            QVERIFY(!QFile::exists(at("weak.sqlite")));
        }
        // The line ends as in a file written on Windows.
        expectDone(runCusp({"user", "list", "--db", school(), "--as", "admin"}, {}, "correct horse\r\n"));
        const Ending added =
            byAdmin({"user", "add", "s1", "--given", "Sam", "--family", "One", "--role", "student", "--json"});
        expectDone(added);
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
        // Without a password, or with a wrong one, the command does nothing.
        expectRefusal(runCusp({"user", "list", "--db", school(), "--as", "admin"}, {}, "wrong horse\n"));
        expectRefusal(runCusp({"user", "list", "--db", school(), "--as", "admin"}, {}, {}), "no password was given");
        QVERIFY(onFile({"user", "list"}).error.contains("--as"));
        QCOMPARE(byAdmin({"user", "disable", "admin"}).exitCode, 1);
        const QJsonObject checked = onFile({"db", "check", "--json"}).json();
        QCOMPARE(checked["sound"].toBool(), true);
        QVERIFY(checked["audit_rows"].toInt() > 5);
        QVERIFY(onFile({"db", "stats"}).out.contains("students     1"));
    }

    void aPersonIsErasedForGood()
    {
        expectDone(byAdmin({"user", "add", "s1", "--given", "Samantha", "--family", "Onewell"}));
        const Ending unsure = byAdmin({"user", "erase", "s1"});
        QVERIFY(unsure.exitCode == 2 && unsure.error.contains("cannot be undone") && unsure.error.contains("--yes"));
        expectRefusal(byAdmin({"user", "erase", "nobody", "--yes"}), "nobody here is called");
        expectRefusal(byAdmin({"user", "erase", "admin", "--yes"}), "the last admin");
        const Ending erased = byAdmin({"user", "erase", "s1", "--yes"});
        expectDone(erased);
        QVERIFY2(erased.out.contains("erased-") && erased.out.contains("backups"), qPrintable(erased.out));
        const QString listed = byAdmin({"user", "list"}).out;
        QVERIFY(listed.contains("erased-") && !listed.contains("Onewell"));
        expectRefusal(byAdmin({"user", "erase", "s1", "--yes"}), "nobody here is called");
        const QString pseudonym = listed.mid(listed.indexOf("erased-"), 19);
        expectRefusal(byAdmin({"user", "erase", pseudonym, "--yes"}), "erased already");
        expectRefusal(byAdmin({"user", "disable", pseudonym, "--enable"}), "cannot come back");
        expectRefusal(byAdmin({"user", "reset", pseudonym}), "cannot come back");
        expectDone(onFile({"db", "check"}));
        QFile file(school());
        QVERIFY(file.open(QIODevice::ReadOnly) && !file.readAll().contains("Onewell"));
    }

    /// Without --db the commands use a database in the user's data folder.
    void withoutAFileItIsTheUsersOwn()
    {
        const QStringList where{"XDG_DATA_HOME=" + at("data")};
        const QString own = at("data/cusp/cusp.sqlite");
        // A command that only reads does not create the database.
        QCOMPARE(runCusp({"db", "stats"}, where).exitCode, 1);
        QVERIFY(!QFile::exists(own));
        expectDone(runCusp({"db", "init", "--admin", "admin"}, where, kPassword));
        QVERIFY(QFile::exists(own));
        expectDone(runCusp({"db", "stats", "--json"}, where));
        QCOMPARE(
            runCusp({"user", "list", "--as", "admin", "--json"}, where, kPassword).json()["people"].toArray().size(),
            1);
    }

    void aClassListIsTriedAndEntered()
    {
        put(at("list.csv"), "username,given_name,family_name,role,class\nn1,Ada,One,,A\nn2,Bo,Two,instructor,A|B\n");
        const QJsonObject dry = byAdmin({"import", "roster", at("list.csv"), "--dry-run", "--json"}).json();
        QCOMPARE(dry["dry_run"].toBool(), true);
        QCOMPARE(dry["people"].toArray().size(), 2);
        QCOMPARE(people(), 1);
        put(at("short.csv"), "username,given_name,family_name,role,class\nn8,Ada,Eight\nn9,Ada,Two,,A\n");
        const QByteArray shorter = byAdmin({"import", "roster", at("short.csv"), "--dry-run"}).out;
        QVERIFY2(shorter.contains("fewer fields than the first line names: n8") && !shorter.contains("n9"), shorter);
        // Codes that are written to a file are not printed as well.
        const Ending done = byAdmin({"import", "roster", at("list.csv"), "--codes", at("codes.csv"), "--json"});
        expectDone(done);
        QCOMPARE(done.json()["people"].toArray()[0].toObject()["code"].toString(), QString());
        const QByteArray codes = contentOf(at("codes.csv"));
        QVERIFY2(codes.contains("n1,Ada One,") && codes.contains("n2,Bo Two,"), codes);
        QVERIFY(!(QFile::permissions(at("codes.csv")) & (QFile::ReadGroup | QFile::ReadOther)));
        QVERIFY(!QFile::exists(at("codes.csv.part")));
        // A killed program has left its codes under this name.
        put(at("others.csv.part"), "n7,Zoe,CODE");
        expectRefusal(byAdmin({"import", "roster", at("list.csv"), "--codes", at("others.csv")}), "others.csv.part");
        QCOMPARE(contentOf(at("others.csv.part")), QByteArray("n7,Zoe,CODE"));
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
        QCOMPARE(people(), 3);
    }

    /// The output, and with it the one-time code, is lost on a full disk. The user is added nevertheless.
    void whoseCodeIsLostIsEnteredAllTheSame()
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
            expectRefusal(toFullDisk(words), said);
        }
        // A command that prints no code has nothing to lose.
        QVERIFY(!toFullDisk({"user", "list"}).error.contains("code"));
        QCOMPARE(people(), 3);
    }

    void codesAndTablesOverwriteNothingElse()
    {
        put(at("list.csv"), "username\nn1\n");
        const QFile::Permissions others = QFile::ReadGroup | QFile::WriteGroup | QFile::ReadOther | QFile::WriteOther;
        QVERIFY(QFile::link(m_folder->path(), at("door")));
        QVERIFY(QFile::link(school(), at("link.csv")) && QFile::link(at("link.csv"), at("twice.csv")));
        QVERIFY(QFile::link(at("nothing"), at("lost.csv")));
        // Each target is tried with one of the two commands, because both open a file in the same way.
        const auto codes = [this](const QString& target) {
            return QStringList{"import", "roster", at("list.csv"), "--codes", target};
        };
        const auto table = [](const QString& target) { return QStringList{"export", "attempts", "--csv", target}; };
        for (const QStringList& words :
             {codes(at("list.csv")), table(at("station.key")), codes(school()), table(school()), codes("/dev/full"),
              table(m_folder->path()), codes(school() + "-journal"), table(at("door/school.sqlite-wal")),
              codes(at("twice.csv")), table(at("lost.csv"))}) {
            const QString target = words.back();
            const bool wasThere = QFileInfo::exists(target);
            const bool isFile = QFileInfo(target).isFile();  // a device cannot be read to its end
            const QByteArray before = isFile ? contentOf(target) : QByteArray();
            expectRefusal(byAdmin(words));
            QCOMPARE(QFileInfo::exists(target), wasThere);
            // Only the login is noted in the audit.
            QCOMPARE(QFileInfo(target).isFile(), isFile);
            QVERIFY(!isFile || contentOf(target).left(16) == before.left(16));
        }
        QCOMPARE(people(), 1);
        // The table of the night before is replaced, also behind a symbolic link. Only its owner can read it, unless
        // its permissions already allow others.
        put(at("table.csv"), "last night");
        QVERIFY(QFile::link(at("table.csv"), at("tonight.csv")));
        QVERIFY(QFile::setPermissions(at("table.csv"), QFile::ReadOwner | QFile::WriteOwner | QFile::ReadGroup));
        for (const char* name : {"tonight.csv", "new.csv"})
            expectDone(byAdmin({"export", "attempts", "--csv", at(name)}));
        QVERIFY(QFileInfo(at("tonight.csv")).isSymLink());
        QVERIFY(!contentOf(at("table.csv")).contains("last night"));
        QVERIFY(QFile::permissions(at("table.csv")) & QFile::ReadGroup);
        QVERIFY(!(QFile::permissions(at("new.csv")) & others));
        expectDone(onFile({"db", "check"}));
    }

    void pipesAndDevicesAreNoFiles()
    {
        QCOMPARE(mkfifo(qPrintable(at("pipe")), 0600), 0);
        expectRefusal(byAdmin({"import", "roster", at("pipe")}), "is no file");
        for (const QString& name : {at("pipe"), QString("/dev/zero"), QString("/dev/null")}) {
            expectRefusal(runCusp({"db", "stats", "--db", name}), "is no file");
        }
        QVERIFY(QFile::remove(at("station.key")));
        QCOMPARE(mkfifo(qPrintable(at("station.key")), 0600), 0);
        expectRefusal(onFile({"db", "check"}), "is no file");
    }

    void attemptsAreExported()
    {
        const auto password = support::makeSchool(at("sample.sqlite"), {5, 40});
        VERIFY_DONE(password);
        const Ending csv = runCusp({"export", "attempts", "--csv", "-", "--db", at("sample.sqlite"), "--as", "admin"},
                                   {}, QByteArray::fromStdString(*password) + '\n');
        expectDone(csv);
        QCOMPARE(csv.out.count("\r\n"), 41);
        expectDone(runCusp({"db", "check", "--db", at("sample.sqlite")}));
    }

    /// Attempts that were delivered after the backup was made return to the outbox, for the window to send them again.
    void whatABackupMissesIsSentAgain()
    {
        const QString backup = backUp();
        for (const QString& look : {QString("check"), QString("stats")})
            expectDone(runCusp({"db", look, "--db", backup}));
        QCOMPARE(QFileInfo(backup).dir().entryList(QDir::Files), QStringList{QFileInfo(backup).fileName()});
        expectDone(byAdmin({"user", "add", "later"}));
        const database::Outbox outbox = outboxOf("school.sqlite");
        QVERIFY(QDir(m_folder->path()).mkpath("outbox/arrived"));
        put(at("outbox/arrived/abc.attempt"), "a letter");
        QVERIFY(outbox.waiting().isEmpty());
        // If the target is a symbolic link, the file that it points to is replaced.
        QVERIFY(QDir(m_folder->path()).mkdir("links") && QFile::link(school(), at("links/link.sqlite")));
        const Ending restored = onFile({"db", "restore", backup, "--json"});
        expectDone(restored);
        QVERIFY(QFile::exists(restored.json()["replaced"].toString()));
        QCOMPARE(outbox.waiting().size(), 1);
        QVERIFY(outbox.arrived().isEmpty());
        expectDone(onFile({"db", "check"}));
        QCOMPARE(people(), 1);
        expectDone(runCusp({"db", "restore", backup, "--db", at("links/link.sqlite")}));
        QVERIFY(QFileInfo(at("links/link.sqlite")).isSymLink());
        QCOMPARE(QDir(at("links")).entryList(QDir::Files | QDir::Hidden).size(), 1);
        // If a later step fails, the attempts stay in the outbox, and the error names the replaced file.
        outbox.keepArrived(outbox.waiting().front());
        put(at("station.key"), "noise");
        expectRefusal(onFile({"db", "restore", backup}), "replaced-");
        QCOMPARE(outbox.waiting().size(), 1);
    }

    void whatCannotBeRestoredIsRefused()
    {
        QVERIFY(QDir(m_folder->path()).mkdir("folder.sqlite"));
        QCOMPARE(mkfifo(qPrintable(at("pipe")), 0600), 0);
        const QString backup = onFile({"db", "backup", "--to", at("drive"), "--json"}).json()["backup"].toString();
        const QByteArray before = contentOf(school());
        for (const auto& [from, to] :
             {std::pair(m_peopled, school()), std::pair(at("pipe"), school()), std::pair(m_folder->path(), school()),
              std::pair(at("nothing"), school()), std::pair(school(), school()), std::pair(backup, at("pipe")),
              std::pair(backup, at("folder.sqlite"))}) {
            expectRefusal(runCusp({"db", "restore", from, "--db", to}));
        }
        QCOMPARE(contentOf(school()), before);
        QVERIFY(QDir(m_folder->path()).entryList({"replaced-*"}).isEmpty());
    }

    void whatWaitsForASchoolThatWasRenamedIsSent()
    {
        QVERIFY(QFile::copy(m_peopled, at("renamed.sqlite")));
        database::Outbox outbox = outboxOf("older.sqlite");
        VERIFY_DONE(outbox.put(m_rig.student, SchoolRig::attempt("class1-36", 500), {}));
        VERIFY_DONE(
            outbox.put(m_rig.student, database::ExamStart{database::newUid(), "exam-36", "2026-11-20T10:00:00Z"}));
        // The school used by default does not know the sender.
        QCOMPARE(onFile({"db", "send", "--json"}).json()["waiting"].toInt(), 2);
        QCOMPARE(outbox.waiting().size(), 2);
        const Ending sent = runCusp({"db", "send", "--json", "--db", at("renamed.sqlite")});
        expectDone(sent);
        QCOMPARE(sent.json()["sent"].toInt(), 2);
        QVERIFY(outbox.waiting().isEmpty());
        QCOMPARE(outbox.arrived().size(), 2);
    }

    /// Beside a backup, on the computer of the school.
    void attemptsAreMarkedAgain()
    {
        QVERIFY(QFile::copy(m_peopled, at("marked.sqlite")));
        VERIFY_DONE(outboxOf("marked.sqlite").put(m_rig.student, SchoolRig::attempt("class1-36", 500), {}));
        expectDone(runCusp({"db", "send", "--db", at("marked.sqlite")}));
        const QStringList mark{"db", "mark", "--as", "admin", "--json", "--db", at("marked.sqlite")};
        const Ending marked = runCusp(mark, {}, kPassword);
        expectDone(marked);
        QCOMPARE(marked.json()["marked"].toInt(), 1);
        QCOMPARE(marked.json()["doubts"].toArray().size(), 1);
        QCOMPARE(marked.json()["doubts"][0]["doubt"].toString(), QString("recording"));
        QCOMPARE(runCusp(mark, {}, kPassword).json()["marked"].toInt(), 0);
        // A recording that is gone may come back with its folder. One that was changed proves nothing.
        VERIFY_DONE(outboxOf("marked.sqlite").put(m_rig.student, SchoolRig::attempt("class1-36", 500), "recording"));
        expectDone(runCusp({"db", "send", "--db", at("marked.sqlite")}));
        const QString file = QDirIterator(at("recordings"), QDir::Files, QDirIterator::Subdirectories).next();
        QVERIFY(QFile::rename(file, at("away")));
        QCOMPARE(runCusp(mark, {}, kPassword).json()["unreadable"].toInt(), 1);
        put(file, "another recording");
        const Ending changed = runCusp(mark, {}, kPassword);
        QVERIFY(changed.json()["unreadable"].toInt() == 0 && changed.json()["doubts"].toArray().size() == 1);
        QCOMPARE(runCusp({"db", "mark", "--db", at("marked.sqlite")}).exitCode, 2);
        QVERIFY(QFile::remove(file) && QFile::rename(at("away"), file));
        expectDone(runCusp({"db", "check", "--db", at("marked.sqlite")}));
    }

    void aDamagedLetterIsSetAside()
    {
        QVERIFY(QDir(m_folder->path()).mkpath("outbox"));
        put(at("outbox/spoilt.attempt"), "noise");
        const Ending sent = onFile({"db", "send", "--json"});
        QVERIFY2(sent.exitCode == 1 && sent.error.contains("kept in the folder \"damaged\""), sent.error);
        QCOMPARE(sent.json()["damaged"].toInt(), 1);
        QCOMPARE(contentOf(at("outbox/damaged/spoilt.attempt")), QByteArray("noise"));
        expectDone(onFile({"db", "send"}));
    }

    /// Pending attempts move with the school. They are not looked for next to the copy.
    void whatWaitsForASchoolMovesWithIt()
    {
        QVERIFY(QDir(m_folder->path()).mkpath("new") && QFile::copy(m_peopled, at("moving.sqlite")));
        database::Outbox own = outboxOf("moving.sqlite");
        database::Outbox others = outboxOf("school.sqlite");
        SchoolRig foreign(false);
        foreign.populate();
        for (const auto& [outbox, who] :
             {std::pair(&own, &m_rig.student), std::pair(&others, &m_rig.student), std::pair(&own, &foreign.student)})
            VERIFY_DONE(outbox->put(*who, SchoolRig::attempt("class1-36", 500), {}));
        const Ending copied = runCusp(
            {"db", "copy", "--json", "--db", at("moving.sqlite"), "--as", "admin", "--to", at("new/copy.sqlite")}, {},
            kPassword);
        QVERIFY2(copied.exitCode == 0 && copied.error.contains("1 attempts and beginnings of exams wait beside"),
                 copied.error);
        QCOMPARE(copied.json()["sent"].toInt(), 1);
        QCOMPARE(copied.json()["waiting"].toInt(), 1);
        QCOMPARE(runCusp({"db", "stats", "--json", "--db", at("new/copy.sqlite")}).json()["attempts"].toInt(), 1);
        QCOMPARE(own.arrived().size(), 1);
        expectDone(runCusp({"db", "check", "--db", at("new/copy.sqlite")}));
    }

    void whereTheSchoolCannotBeUsedABackupIsNamed()
    {
        const QByteArray backup = backUp().toUtf8();
        QVERIFY(!onFile({"db", "init"}).error.contains(backup));
        put(school(), QByteArray(50'000, 'n'));
        for (const char* how : {"noise", "gone"}) {
            for (const QStringList& words :
                 {QStringList{"user", "list"}, {"export", "attempts", "--csv", at("table.csv")}}) {
                const Ending refused = byAdmin(words);
                expectRefusal(refused, backup);
            }
            const Ending refused = onFile({"db", "check"});
            QVERIFY2(refused.exitCode == 1 && refused.error.contains(backup), how);
            QFile::remove(school());
        }
        const Ending made = onFile({"db", "init"});
        QVERIFY2(made.exitCode == 0 && made.error.contains(backup), made.error);
    }

    void aCopyThatFailsLeavesNothingBehind()
    {
        {
            const auto opened = database::sql::Database::open(school());
            VERIFY_DONE(opened);
            const database::sql::DatabaseContext there{(*opened)->handle(),
                                                       database::StationKey::readOrMake(at("station.key")).value()};
            const auto admin = database::sql::Logins::login(there, "admin", kPassword.trimmed().toStdString());
            VERIFY_DONE(admin);
            VERIFY_DONE(support::addAttempt(there, *admin, SchoolRig::attempt("class1-36", 500), "a recording"));
        }
        QVERIFY(QDir(m_folder->path()).mkdir("new"));
        put(at("new/recordings"), "no folder");
        QCOMPARE(byAdmin({"db", "copy", "--to", at("new/copy.sqlite")}).exitCode, 1);
        QCOMPARE(QDir(at("new")).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot),
                 QStringList{"recordings"});
        // Existing files are preserved.
        QCOMPARE(byAdmin({"db", "copy", "--to", school()}).exitCode, 1);
        QVERIFY(QFile::exists(at("station.key")));
        expectDone(onFile({"db", "check"}));
    }

    void rightsOfStationsArePrinted()
    {
        const Ending printed = runCusp({"db", "grants", "--station", "cusp_station"});
        expectDone(printed);
        QVERIFY(printed.out.contains("TO \"cusp_station\""));
        QCOMPARE(runCusp({"db", "grants"}).exitCode, 2);
        expectRefusal(runCusp({"db", "grants", "--station", "a b"}));
        // A file has no accounts, and none is created in vain.
        QCOMPARE(runCusp({"db", "init", "--db", at("new.sqlite"), "--station", "cusp_station"}).exitCode, 2);
        QVERIFY(!QFile::exists(at("new.sqlite")));
    }

    void namesThatAreNoFilesAreRefused()
    {
        for (const char* name : {":memory:", "file:x?mode=memory", ":x.sqlite", "mysql://x/y", " ",
                                 "postgresql://x/%00", "postgresql://x%0A/y"}) {
            const Ending refused = runCusp({"db", "init", "--db", name});
            expectRefusal(refused);
        }
        // An address copied from a document may contain invisible characters.
        for (const char* name :
             {"postgresql://x%E2%80%8B/y", "postgresql://x/y%E2%80%8B", "postgresql://u%E2%80%8B@x/y"}) {
            const Ending refused = runCusp({"db", "init", "--db", name});
            QVERIFY2(refused.exitCode == 1 && refused.error.contains("cannot be seen"), refused.error);
        }
    }

    void whoStopsAtThePasswordSeesWhatHeTypes_data()
    {
        QTest::addColumn<int>("signal");
        QTest::newRow("Ctrl+C") << SIGINT;
        QTest::newRow("ended") << SIGTERM;
        QTest::newRow("the terminal is closed") << SIGHUP;
    }

    /// The program is first suspended and resumed, as a shell does it: the password stays hidden. The parent process
    /// waits meanwhile.
    void whoStopsAtThePasswordSeesWhatHeTypes()
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

    void wrongUsageIsExplained()
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

private:
    [[nodiscard]] QString at(const char* name) const { return m_folder->filePath(QLatin1String(name)); }
    [[nodiscard]] QString school() const { return at("school.sqlite"); }
    /// Runs a command on the school as the admin.
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

    /// Returns the number of users in the school.
    [[nodiscard]] qsizetype people() const
    {
        return byAdmin({"user", "list", "--json"}).json()["people"].toArray().size();
    }
    /// Makes a backup and returns its path.
    [[nodiscard]] QString backUp() const { return onFile({"db", "backup", "--json"}).json()["backup"].toString(); }
    [[nodiscard]] database::Outbox outboxOf(const char* name) const
    {
        return {at("outbox"), database::StationKey::readOrMake(at("station.key")).value(), name};
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    QTemporaryDir m_made;  ///< a school with only an admin; each test begins with a copy
    SchoolRig m_rig{false};
    QString m_peopled;  ///< a backup of the rig's school
};

QTEST_GUILESS_MAIN(TestSchoolCommands)
#include "tst_school_commands.moc"
