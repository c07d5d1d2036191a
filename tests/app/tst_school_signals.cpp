// SPDX-License-Identifier: GPL-3.0-or-later
// Many rounds each: commands that a signal stops at a random moment, or that run several times at once.
#include <csignal>
#include <future>

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <unistd.h>

#include "database/Outbox.h"
#include "database/sql/Backups.h"
#include "database/sql/Statement.h"
#include "tests/database/Sample.h"
#include "tests/database/SchoolRig.h"
#include "tests/support/Program.h"

using support::Ending;
using support::runCusp;
using support::SchoolRig;

class TestSchoolSignals : public QObject
{
    Q_OBJECT

private slots:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }

    /// Other processes deliver the same attempts at the same time.
    void whatIsSentByManyIsCountedOnce()
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

    void aSignalLeavesNothingBehind_data()
    {
        QTest::addColumn<QStringList>("words");
        QTest::newRow("backup") << QStringList{"db", "backup", "--to", "there"};
        QTest::newRow("restore") << QStringList{"db", "restore", "backup.sqlite"};
        QTest::newRow("copy") << QStringList{"db", "copy", "--to", "there/copy.sqlite", "--as", "admin"};
        QTest::newRow("export") << QStringList{"export", "attempts", "--csv", "there/table.csv", "--as", "admin"};
    }

    /// The command is stopped by a signal at a random moment. A file under the target's name is complete, and no
    /// temporary file is left.
    void aSignalLeavesNothingBehind()
    {
        QFETCH(QStringList, words);
        const auto password = support::makeSchool(school(), {.students = 20, .attempts = 3000});
        VERIFY_DONE(password);
        {
            const auto opened = database::sql::Database::open(school());
            VERIFY_DONE(opened);
            for (const char* sql : {"CREATE TABLE ballast (x)", "INSERT INTO ballast VALUES (zeroblob(40000000))"})
                VERIFY_DONE(database::sql::execute((*opened)->handle(), sql, "make it large"));
        }
        const QByteArray typed = QByteArray::fromStdString(*password + '\n');
        const QString backup =
            runCusp({"db", "backup", "--db", school(), "--to", at("kept"), "--json"}).json()["backup"].toString();
        QVERIFY(QDir(m_folder->path()).mkdir("there") && QFile::rename(backup, at("backup.sqlite")));
        const auto half = [this] {
            QStringList found;
            for (const char* folder : {"", "there"})
                found << QDir(at(folder))
                             .entryList({"*.part-*", "*.restoring*", "table.csv?*"},
                                        QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
            return found;
        };
        int stopped = 0;
        for (int round = 0; round < 24; ++round) {
            QProcess cusp;
            cusp.setWorkingDirectory(m_folder->path());
            cusp.start(QStringLiteral(CUSP_BINARY_DIR "/bin/cusp"), words + QStringList{"--db", school()});
            QVERIFY(cusp.waitForStarted());
            cusp.write(typed);
            cusp.closeWriteChannel();
            usleep(static_cast<useconds_t>(round) * 15'000);  // later in each round
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

private:
    [[nodiscard]] QString at(const char* name) const { return m_folder->filePath(QLatin1String(name)); }
    [[nodiscard]] QString school() const { return at("school.sqlite"); }

    std::unique_ptr<QTemporaryDir> m_folder;
};

QTEST_GUILESS_MAIN(TestSchoolSignals)
#include "tst_school_signals.moc"
