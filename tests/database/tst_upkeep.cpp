// SPDX-License-Identifier: GPL-3.0-or-later
// Migrations, copies between engines, class lists, and the findings of a check.
#include <QDir>
#include <QSqlError>
#include <QTest>

#include "database/Csv.h"
#include "database/sql/Backups.h"
#include "database/sql/Copy.h"
#include "database/sql/Dialect.h"
#include "database/sql/Export.h"
#include "database/sql/Migrations.h"
#include "database/sql/Overview.h"
#include "database/sql/Roster.h"
#include "tests/database/SchoolRig.h"
#include "tests/support/Suite.h"
#include "tests/support/Tables.h"

using namespace database;
using namespace database::sql;
using core::ErrorCode;
using support::addAttempt;
using support::SchoolRig;

class TestUpkeep : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { m_rig.populate(); }
    /// The content is preserved.
    void everyOlderSchemaIsBroughtToTheNewest_data() { support::addEngines(); }
    void everyOlderSchemaIsBroughtToTheNewest()
    {
        QFETCH(bool, onServer);
        if (onServer)
            NEEDS_SERVER();
        const auto steps = shippedMigrations();
        VERIFY_DONE(steps);
        for (std::size_t version = 1; version < steps->size(); ++version) {
            QTemporaryDir folder;
            const QString where = onServer ? support::sharedServer().newDatabase() : folder.filePath("old.sqlite");
            const Address address = Address::parse(where).value();
            const QString name = QStringLiteral("old-%1").arg(version);
            {
                QSqlDatabase db = QSqlDatabase::addDatabase(onServer ? "QPSQL" : "QSQLITE", name);
                db.setDatabaseName(onServer ? address.name : address.file);
                db.setHostName(address.host);
                db.setUserName(address.user);
                if (address.port > 0)
                    db.setPort(address.port);
                QVERIFY2(db.open(), qPrintable(db.lastError().text()));
                if (!onServer)
                    VERIFY_DONE(execute(db, QStringLiteral("PRAGMA application_id = %1").arg(dialect::kApplicationId),
                                        "mark it"));
                VERIFY_DONE(migrate(db, std::span(*steps).first(version)));
                const QString columns = version == 1  ? QStringLiteral("score_points, score_sheet_json, recording_file")
                                        : version < 4 ? QStringLiteral("score_tenths, score_sheet_json, recording_file")
                                                      : QStringLiteral("score_tenths, uid");
                const QString values = version == 1  ? QStringLiteral("82, '{\"old\":1}', 'x.cusprec'")
                                       : version < 4 ? QStringLiteral("820, '{\"old\":1}', 'x.cusprec'")
                                                     : QStringLiteral("820, 'legacy-1'");
                VERIFY_DONE(
                    execute(db,
                            QStringLiteral("INSERT INTO attempts (finished_utc, tooth, duration_ms, state_hash, %1)"
                                           " VALUES ('2026-03-01T10:00:00Z', '36', 1000, '0123456789abcdef', %2)")
                                .arg(columns, values),
                            "fill it"));
                if (version >= 4)
                    VERIFY_DONE(
                        execute(db, "INSERT INTO score_sheets SELECT id, '{\"old\":1}' FROM attempts", "fill it"));
            }
            QSqlDatabase::removeDatabase(name);
            Database::Options careful;
            careful.mayMigrate = false;
            VERIFY_REFUSED(Database::open(address, careful), ErrorCode::OlderVersion);
            const auto database = Database::open(address).value();
            const QSqlDatabase db = database->handle();
            QCOMPARE(dialect::schemaVersion(db).value(), static_cast<int>(steps->size()));
            QCOMPARE(ask(db, "SELECT score_tenths FROM attempts", "read")->toInt(), 820);
            QCOMPARE(ask(db, "SELECT json FROM score_sheets", "read")->toString(), QString("{\"old\":1}"));
            QVERIFY(!ask(db, "SELECT uid FROM attempts", "read")->toString().isEmpty());
            QCOMPARE(support::faultsOf(db), QString());
            if (onServer)
                continue;
            // The copy from before the migration can be restored, and is then migrated.
            const QDir backups(backupFolder(where));
            const QStringList copies = backups.entryList({QStringLiteral("before-schema-%1-*").arg(version + 1)});
            QCOMPARE(copies.size(), 1);
            const QString restored = folder.filePath("restored.sqlite");
            VERIFY_DONE(restoreBackup(backups.filePath(copies.first()), restored, QDateTime::currentDateTimeUtc()));
            QCOMPARE(
                ask(Database::open(restored).value()->handle(), "SELECT score_tenths FROM attempts", "read")->toInt(),
                820);
        }
    }

    void aSchoolMovesBetweenEnginesAndBack()
    {
        NEEDS_SERVER();
        SchoolRig first(support::populatedSchool(false));
        AttemptRecord attempt = SchoolRig::attempt("class1-36", 823);
        attempt.device = "Gerät 歯 \\ ' \"";
        const QByteArray recording("recording\0with a zero", 21);
        const AttemptId id = first.add(first.student, attempt, recording).value();
        VERIFY_DONE(addComment(first.school(), first.instructor, id, {"Well done.", {{1.0, 2.0, -0.5}}, 90'000}));
        VERIFY_DONE(withdrawComment(first.school(), first.instructor,
                                    addComment(first.school(), first.instructor, id, {"Of another.", {}, {}}).value()));
        VERIFY_DONE(overrideScore(first.school(), first.instructor, id, 900, "It is better than that."));
        SchoolRig server(true);
        QVERIFY(server.isOpen());
        const auto there = copySchool(first.school(), first.admin, server.school());
        VERIFY_DONE(there);
        QCOMPARE(there->recordings, 1);
        VERIFY_REFUSED(copySchool(first.school(), first.admin, server.school()), ErrorCode::OutOfRange);
        SchoolRig back(false);
        VERIFY_DONE(copySchool(server.school(), server.logIn("admin").value(), back.school()));
        for (SchoolRig* rig : {&server, &back}) {
            const auto report = checkDatabase(rig->school().db, {auditHead(first.school())->code()});
            VERIFY_DONE(report);
            QVERIFY2(report->findings.empty(), qPrintable(support::wordsOf(report->findings)));
            const auto session = Logins::login(rig->school(), "s1001", SchoolRig::kPassword);
            VERIFY_DONE(session);
            QVERIFY(*openAttempt(rig->school(), *session, id) == *openAttempt(first.school(), first.student, id));
            QCOMPARE(openRecording(rig->school(), *session, id).value(), recording);
            QVERIFY(*readTalk(rig->school(), *session, id) == *readTalk(first.school(), first.student, id));
            // New numbers continue after the copied ones.
            const auto next = addAttempt(rig->school(), *session, SchoolRig::attempt("class1-36", 1), {});
            VERIFY_DONE(next);
            QVERIFY(next->value > id.value);
        }
    }

    void aCopyThatFailsBringsNoRow()
    {
        SchoolRig first(support::populatedSchool(false));
        VERIFY_DONE(first.add(first.student, SchoolRig::attempt("class1-36", 500), "a recording"));
        SchoolRig target(false);
        // The seal is written last.
        target.run({"CREATE TRIGGER stop BEFORE UPDATE ON audit_seal BEGIN SELECT RAISE(ABORT, 'stop'); END"});
        const auto isEmpty = [&target] { return target.count("people") == 0 && target.count("audit") == 0; };
        QVERIFY(!copySchool(first.school(), first.admin, target.school()).has_value());
        QVERIFY(isEmpty());
        target.run({"DROP TRIGGER stop"});
        QVERIFY(!copySchool(first.school(), first.admin, target.school(), [](const QString& table, std::int64_t) {
                     return table != u"recordings";
                 }).has_value());
        QVERIFY(isEmpty());
        const auto copied = copySchool(first.school(), first.admin, target.school());
        VERIFY_DONE(copied);
        QCOMPARE(copied->recordings, 1);
    }

    void aCheckNamesTheAttemptThatWasChanged_data() { support::addEngines(); }
    void aCheckNamesTheAttemptThatWasChanged()
    {
        COPY_OF(support::populatedSchool, rig);
        std::vector<AttemptRecord> attempts;
        for (int k = 0; k < 5; ++k) {
            attempts.push_back(SchoolRig::attempt("class1-36", 500 + k));
            VERIFY_DONE(rig.add(rig.student, attempts.back()));
        }
        const QString changed = QString::fromStdString(attempts[1].uid);
        const QString removed = QString::fromStdString(attempts[2].uid);
        QCOMPARE(support::faultsOf(rig.school().db), QString());
        rig.run({"UPDATE attempts SET score_tenths = 999 WHERE uid = '" + changed + "'",
                 "DELETE FROM score_sheets WHERE attempt_id = (SELECT id FROM attempts WHERE uid = '" + removed + "')",
                 "DELETE FROM attempts WHERE uid = '" + removed + "'"});
        const QString all = support::faultsOf(rig.school().db);
        for (const QString& finding : {changed + " (2026-11-20T10:15:00Z, class1-36) was changed",
                                       removed + " was removed", QStringLiteral("do not add up")})
            QVERIFY2(all.contains(finding), qPrintable(all));
        QCOMPARE(all.count('\n'), 2);
    }

    /// Changes that other stations make during a check cause no findings.
    void itIsCheckedWhileOthersWrite_data() { support::addEngines(); }
    void itIsCheckedWhileOthersWrite()
    {
        COPY_OF(support::populatedSchool, rig);
        // More rows than the check reads at once.
        VERIFY_DONE(inTurn(rig.school(), "note backups", [&]() -> core::Status {
            AuditBatch batch(rig.school());
            for (int k = 0; k < 2100; ++k)
                if (auto noted = batch.note("system", "backup.made", "backup:" + std::to_string(k)); !noted)
                    return noted;
            return batch.seal();
        }));
        const auto elsewhere = Database::open(rig.address()).value();
        DatabaseContext other = rig.school();
        other.db = elsewhere->handle();
        int written = 0;
        const auto report = checkDatabase(rig.school().db, {}, [&](const char*, std::int64_t) {
            const std::string name = "late" + std::to_string(++written);
            return addPerson(other, rig.admin, {name, "", "", Role::Student}).has_value();
        });
        VERIFY_DONE(report);
        QVERIFY(written > 1 && !report->isStopped);
        QVERIFY2(report->findings.empty(), qPrintable(support::wordsOf(report->findings)));
        QVERIFY(checkDatabase(rig.school().db, {}, [](const char*, std::int64_t) { return false; })->isStopped);
    }

    /// A name that begins like a formula is quoted, so that a spreadsheet does not evaluate it.
    void whatASpreadsheetWouldRunIsQuoted()
    {
        for (const char* sign : {"=", "+", "-", "@", "\uFF1D", "\uFF0B", "\uFF0D", "\uFF20"})
            QCOMPARE(csvField(std::string(sign) + "1+1"), "'" + std::string(sign) + "1+1");
        for (const char* harmless : {"", "Ada", "1-1", "\uFF21da"})
            QCOMPARE(csvField(harmless), std::string(harmless));
        SchoolRig rig(support::populatedSchool(false));
        VERIFY_DONE(rig.add(rig.student, "=cmd|'/c calc'!A0", 1));
        std::string csv;
        VERIFY_DONE(exportAttempts(rig.school(), rig.admin, [&](std::string_view line) {
            csv += line;
            return true;
        }));
        QVERIFY2(csv.find(",'=cmd|'/c calc'!A0,") != std::string::npos, csv.c_str());
        QVERIFY2(csv.find(",0.1,no,,80.0,345.678,0.850,2.400,") != std::string::npos, csv.c_str());
    }

    /// The score and whether it passes are those of the class page: a teacher's score counts instead of the automatic
    /// one.
    void exportSaysWhatTheClassPageSays()
    {
        SchoolRig rig(support::populatedSchool(false));
        const AttemptId failed = rig.add(rig.student, "class1-36", 300).value();
        VERIFY_DONE(overrideScore(rig.school(), rig.instructor, failed, 800, "neat"));
        const AttemptId passed = rig.add(rig.student, "class1-36", 900).value();
        VERIFY_DONE(overrideScore(rig.school(), rig.instructor, passed, 100, "not their work"));
        QStringList lines;
        VERIFY_DONE(exportAttempts(rig.school(), rig.admin, [&](std::string_view line) {
            lines += QString::fromUtf8(line.data(), static_cast<qsizetype>(line.size())).trimmed();
            return true;
        }));
        const QStringList head = lines.front().split(',');
        const auto row = [&](qsizetype fromEnd) {
            const QStringList fields = lines.at(lines.size() - fromEnd).split(',');
            QStringList said;
            for (const char* column : {"score", "passed", "given_score", "automatic_score"})
                said += fields.value(head.indexOf(QLatin1String(column)));
            return said;
        };
        QCOMPARE(row(2), QStringList({"80.0", "yes", "80.0", "30.0"}));
        QCOMPARE(row(1), QStringList({"10.0", "no", "10.0", "90.0"}));
    }

    /// A character outside Unicode's Basic Multilingual Plane takes two elements of a QString, but counts as one.
    void lettersAreCountedAndNotTheirHalves()
    {
        SchoolRig rig(support::populatedSchool(false));
        const auto of = [](int count) { return QString::fromUtf8("𠮷").repeated(count).toStdString(); };
        VERIFY_DONE(addClass(rig.school(), rig.admin, of(100)));
        VERIFY_REFUSED(addClass(rig.school(), rig.admin, of(101)), ErrorCode::OutOfRange);
        VERIFY_DONE(checkPersonName(of(200)));
        VERIFY_REFUSED(checkPersonName(of(201)), ErrorCode::OutOfRange);
        // A bar is not allowed in a class name, because it separates the classes in a list.
        VERIFY_REFUSED(addClass(rig.school(), rig.admin, "DEN|101"), ErrorCode::OutOfRange);
        QVERIFY(!renameClass(rig.school(), rig.admin, rig.second, "DEN|101"));
    }

    /// A setting of the school applies even if a user has stored one of the same name.
    void nobodySetsForThemselvesWhatTheSchoolSets_data() { support::addEngines(); }
    void nobodySetsForThemselvesWhatTheSchoolSets()
    {
        COPY_OF(support::populatedSchool, rig);
        VERIFY_DONE(changeSetting(rig.school(), rig.admin, "idle.minutes", "12"));
        VERIFY_DONE(changeOwnSetting(rig.school(), rig.student, "idle.minutes", "600"));
        VERIFY_DONE(changeOwnSetting(rig.school(), rig.student, "language", "de"));
        const auto settings = readSettings(rig.school(), rig.student);
        VERIFY_DONE(settings);
        QCOMPARE(settings->at("idle.minutes"), std::string("12"));
        QCOMPARE(settings->at("language"), std::string("de"));
        const std::string most(16'000, 'x');
        VERIFY_DONE(changeOwnSetting(rig.school(), rig.student, "language", most));
        VERIFY_REFUSED(changeOwnSetting(rig.school(), rig.student, "language", most + 'x'), ErrorCode::OutOfRange);
        VERIFY_REFUSED(changeSetting(rig.school(), rig.admin, "idle.minutes", most + 'x'), ErrorCode::OutOfRange);
    }

    /// The same applies to a year of five digits. Neither a row of the audit nor the name of a backup can hold such a
    /// date.
    void aClockWithoutAYearIsSaidToBeWrong_data() { support::addEngines(); }
    void aClockWithoutAYearIsSaidToBeWrong()
    {
        COPY_OF(support::populatedSchool, rig);
        QTemporaryDir folder;
        for (const int year : {-75, 10'002}) {
            rig.nowUtc.setDate(QDate(year, 1, 1));
            VERIFY_REFUSED(addClass(rig.school(), rig.admin, "new"), ErrorCode::OutOfRange);
            if (!onServer)
                VERIFY_REFUSED(backUp(rig.school().db, folder.path(), rig.nowUtc), ErrorCode::OutOfRange);
        }
        QVERIFY(QDir(folder.path()).isEmpty());
    }

    void aClassListSaysWhatIsWrongWithItsFile_data()
    {
        // A fault is "line/column/value".
        support::columns<QByteArray, QStringList>("file", "faults");
        const auto row = [](const char* name, const QByteArray& file, const QStringList& faults) {
            QTest::newRow(name) << file << faults;
        };
        row("in Latin-1", "username,given_name\nok,Zo\xC3\xAB\nbad,J\xC3\xBCr\xFC\n", {"3//8"});
        row("in UTF-16", QByteArray("\xFF\xFEu\0s\0", 6), {"1//1"});
        row("a slip, and a column twice", "user_name,family_name,family_name\nx,y,z\n",
            {"1/user_name/username", "1/family_name/", "1/username/"});
        row("a word that may mean two", "name,first_name,username\nx,y,z\n", {"1/name/", "1/first_name/given_name"});
        const QString all = "1/%1/username 1/%2/given_name 1/%3/family_name 1/%4/role 1/%5/class 1/username/";
        const auto headOf = [&all](const QString& head) {
            const QStringList c = head.toLower().split(',');
            return all.arg(c[0], c[1], c[2], c[3], c[4]).split(' ');
        };
        for (const char* head : {"Benutzername,Vorname,Nachname,Rolle,Klasse", "Usuario,Nombre,Apellidos,Rol,Grupo",
                                 "ユーザー名,名,姓,役割,クラス"})
            row(head, QByteArray(head) + '\n', headOf(head));
        row("an open quote", "username,given_name\nok,\"Ada\n", {"2//4"});
        row("no user, no role",
            "username,role,class\nok1,student,A\nt w o,student,A\nok1,student,A\nok2,boss,A\n"
            "teach,student,A\nok3,student,A,more\n",
            {"3/username/", "4/username/", "5/role/", "6/role/", "7//"});
        row("a head that is not the first line", "sep=;\n\nusername;nickname\nx;y\n", {"3/nickname/"});
        row("names that are too long, or not to be seen",
            "username,given_name,family_name\nlong1," + QByteArray(201, 'x') + ",\nok9,,\nhid,,a\u200bb\n",
            {"2/given_name/", "4/family_name/"});
    }

    void aClassListSaysWhatIsWrongWithItsFile()
    {
        QFETCH(QByteArray, file);
        QFETCH(QStringList, faults);
        const auto outcome = importRoster(m_rig.school(), m_rig.admin, file.toStdString(), false);
        VERIFY_DONE(outcome);
        QStringList found;
        for (const RosterFault& fault : outcome->faults) {
            using Kind = RosterFault::Kind;
            const bool namesSomething =
                fault.kind == Kind::NoUtf8 || fault.kind == Kind::OpenQuote || fault.kind == Kind::NoSuchColumn;
            found += QStringLiteral("%1/%2/%3")
                         .arg(fault.line)
                         .arg(QString::fromStdString(fault.column),
                              namesSomething ? QString::fromStdString(fault.value) : QString());
        }
        QCOMPARE(found, faults);
        QCOMPARE(listPeople(m_rig.school(), m_rig.admin)->size(), std::size_t{6});
    }

    /// A program that is killed between the two loses nothing: the codes are kept first.
    void codesAreKeptBeforeTheyAreValid_data() { support::addEngines(); }
    void codesAreKeptBeforeTheyAreValid()
    {
        COPY_OF(support::populatedSchool, rig);
        const auto people = [&] { return listPeople(rig.school(), rig.admin)->size(); };
        const std::size_t before = people();
        const char* list = "username\nnew1\nnew2\n";
        const auto refuse = [](const std::vector<RosterPerson>&) -> core::Status {
            return core::unexpected(ErrorCode::FileUnwritable, "the disk is full");
        };
        VERIFY_REFUSED(importRoster(rig.school(), rig.admin, list, false, nullptr, refuse), ErrorCode::FileUnwritable);
        QCOMPARE(people(), before);
        std::string code;
        const auto keep = [&](const std::vector<RosterPerson>& entered) -> core::Status {
            code = entered[0].code;
            return {};
        };
        VERIFY_DONE(importRoster(rig.school(), rig.admin, list, true, nullptr, keep));
        QVERIFY(code.empty());
        VERIFY_DONE(importRoster(rig.school(), rig.admin, list, false, nullptr, keep));
        VERIFY_DONE(Logins::redeem(rig.school(), "new1", code, "another horse"));
    }

    void classListsAreTakenWholeOrNotAtAll_data() { support::addEngines(); }
    void classListsAreTakenWholeOrNotAtAll()
    {
        COPY_OF(support::populatedSchool, rig);
        const auto people = [&] { return listPeople(rig.school(), rig.admin)->size(); };
        const std::size_t before = people();
        const std::string before1001 = findPerson(rig.school(), rig.admin, "s1001")->fullName();
        const char* good = "\xEF\xBB\xBFusername;given_name;family_name;role;class\r\n"
                           "new1;Åsa;\"Berg; af\";student;DEN101-A|Evening\r\n\r\n"
                           "s1001;Sam;Renamed;;Evening\r\n";
        const auto dry = importRoster(rig.school(), rig.admin, good, true);
        VERIFY_DONE(dry);
        QVERIFY(dry->faults.empty());
        QCOMPARE(dry->people.size(), std::size_t{2});
        QVERIFY(dry->people[0].isNew && dry->people[0].code.empty() && !dry->people[1].isNew);
        // Another name in the list may be an error in the line, so the old name is shown.
        QVERIFY(dry->people[0].nameBefore.empty());
        QCOMPARE(dry->people[1].nameBefore, before1001);
        const auto shorter =
            importRoster(rig.school(), rig.admin, "username,given_name,family_name\nnew8,Eve,\nnew9,Eve\n", true);
        VERIFY_DONE(shorter);
        QVERIFY(!shorter->people[0].isShort && shorter->people[1].isShort);
        QCOMPARE(people(), before);
        const auto done = importRoster(rig.school(), rig.admin, good, false);
        VERIFY_DONE(done);
        QCOMPARE(people(), before + 1);
        VERIFY_DONE(Logins::redeem(rig.school(), "new1", done->people[0].code, "another horse"));
        QCOMPARE(findPerson(rig.school(), rig.admin, "new1")->familyName, std::string("Berg; af"));
        QCOMPARE(findPerson(rig.school(), rig.admin, "s1001")->familyName, std::string("Renamed"));
        QCOMPARE(listClasses(rig.school(), rig.admin)->size(), std::size_t{3});
        // A kanji outside the Basic Multilingual Plane. If the list leaves the role empty, the role stays as it is.
        const auto rare = importRoster(rig.school(), rig.admin,
                                       "username,given_name,family_name,role\nteach,,,\nrare1,太,𠮷田,\n", true);
        VERIFY_DONE(rare);
        QVERIFY2(rare->faults.empty(), rare->faults.empty() ? "" : rare->faults.front().what.c_str());
        QCOMPARE(rare->people[0].role, Role::Instructor);
        // Variants that spreadsheets write: rows of separators only, a line that names the separator, old line ends.
        for (const char* odd :
             {"username,class\ns1001,\n,,\n , \n", "sep=;\nusername;class\ns1001;\n", "username,class\rs1001,\r,\r"}) {
            const auto same = importRoster(rig.school(), rig.admin, odd, false);
            QVERIFY2(same.has_value() && same->faults.empty() && same->people.size() == 1,
                     same ? odd : same.error().detail.c_str());
        }
        // Empty columns behind the last one, also without a name of their own, and blanks beside quotes.
        for (const char* spaced :
             {"username,given_name,class,\nnew7,Ana,A,\n", "username;given_name;class;;\nnew7;Ana;A; ;\n",
              "username,given_name,class\nnew7, \"Ana\", A,\n",
              "username,given_name,class\n\"new7\" ,\"Ana\"\t, \"A\"\n",
              "username,given_name,class\nnew7,\u00A0\"Ana\",\u3000\"A\"\n"}) {
            const auto read = importRoster(rig.school(), rig.admin, spaced, true);
            QVERIFY2(read.has_value() && read->faults.empty() && read->people.size() == 1, spaced);
            QCOMPARE(read->people[0].username, std::string("new7"));
            QCOMPARE(read->people[0].fullName, std::string("Ana"));
            QCOMPARE(read->people[0].classes, std::vector<std::string>{"A"});
        }
        for (const char* broken : {"", "name\nx\n", "username,username\nx,y\n", "username\n\"x\n", "username\n\"x\"y\n",
                                   "username\n\xFF\xFE\n", "username,role\nok1,student\nok2,boss\n",
                                   "username,,class\nok1,lost,A\n", "username,class,\nok1,A,lost\n"}) {
            const auto whole = importRoster(rig.school(), rig.admin, broken, false);
            QVERIFY2(!whole || !whole->faults.empty(), broken);
        }
        QCOMPARE(people(), before + 1);
    }

private:
    SchoolRig m_rig{false};
};

CUSP_TEST(TestUpkeep)
#include "tst_upkeep.moc"
