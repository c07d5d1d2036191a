// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <set>
#include <vector>

#include <QTest>

#include "database/sql/Roster.h"
#include "tests/database/SchoolRig.h"
#include "tests/support/Suite.h"

using namespace database;
using namespace database::sql;
using core::ErrorCode;
using support::SchoolRig;

namespace {

/// Returns the processor time of this thread, ms, so that other programs do not count.
double cpuMs(const std::function<void()>& work)
{
    timespec begun{};
    timespec ended{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &begun);
    work();
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &ended);
    return 1e3 * static_cast<double>(ended.tv_sec - begun.tv_sec) +
           1e-6 * static_cast<double>(ended.tv_nsec - begun.tv_nsec);
}

double failedLoginMs(SchoolRig& rig, const std::string& name)
{
    rig.nowUtc = rig.nowUtc.addDays(1);  // so that no waiting time applies
    return cpuMs([&] { VERIFY_REFUSED(rig.logIn(name, "wrong horse"), ErrorCode::WrongLogin); });
}

struct FailedLogins
{
    double knownMs = 0.0;
    double unknownMs = 0.0;

    [[nodiscard]] QString words() const
    {
        return QStringLiteral("unknown %1 ms, known %2 ms").arg(unknownMs).arg(knownMs);
    }
};

/// Returns the median time of nine failed logins with an existing username, and with unknown ones.
FailedLogins timeFailedLogins(SchoolRig& rig)
{
    std::vector<double> known;
    std::vector<double> unknown;
    for (int k = 0; k < 9; ++k) {
        known.push_back(failedLoginMs(rig, "s1001"));
        unknown.push_back(failedLoginMs(rig, "nobody" + std::to_string(k)));
    }
    std::nth_element(known.begin(), known.begin() + 4, known.end());
    std::nth_element(unknown.begin(), unknown.begin() + 4, unknown.end());
    return {known[4], unknown[4]};
}

/// Returns a column of Sam's row in the database.
QString kept(const DatabaseContext& school, const QString& column)
{
    return ask(school.db, "SELECT " + column + " FROM people WHERE username = 's1001'", "look").value().toString();
}

/// Fails to log in as many times as are possible without a waiting time.
void fail(const SchoolRig& rig, const std::string& name)
{
    for (int k = 0; k < Logins::kFreeFailures; ++k)
        VERIFY_REFUSED(rig.logIn(name, "wrong"), ErrorCode::WrongLogin);
}

}  // namespace

class TestLogins : public QObject
{
    Q_OBJECT

private slots:
    void theFirstPersonIsAnAdminAndEnteredOnce_data() { support::addEngines(); }
    void theFirstPersonIsAnAdminAndEnteredOnce()
    {
        SCHOOL_RIG(rig);
        QCOMPARE(Logins::isNew(rig.school()).value(), true);
        // There is no user yet, and no default password.
        for (const char* guess : {"", "admin", "password", "cusp"}) {
            VERIFY_REFUSED(rig.logIn("admin", guess), ErrorCode::WrongLogin);
            rig.nowUtc = rig.nowUtc.addSecs(3600);
        }
        const auto session = Logins::createFirstAdmin(rig.school(), {" Admin ", "Ada", "Admin", Role::Student},
                                                      SchoolRig::kPassword, SchoolRig::kCheap);
        VERIFY_DONE(session);
        QCOMPARE(session->role(), Role::Admin);
        QCOMPARE(session->username(), std::string("admin"));
        QCOMPARE(session->fullName(), std::string("Ada Admin"));
        QCOMPARE(Logins::isNew(rig.school()).value(), false);
        VERIFY_REFUSED(Logins::createFirstAdmin(rig.school(), {"second", "", "", Role::Admin}, SchoolRig::kPassword,
                                                SchoolRig::kCheap),
                       ErrorCode::NotAllowed);
        rig.reopen();
        VERIFY_DONE(rig.logIn("ADMIN"));
    }

    void unknownWrongAndDisabledGetTheSameAnswer_data() { support::addEngines(); }
    void unknownWrongAndDisabledGetTheSameAnswer()
    {
        COPY_OF(support::populatedSchool, rig);
        Person disabled = findPerson(rig.school(), rig.admin, "s1002").value();
        disabled.disabled = true;
        VERIFY_DONE(changePerson(rig.school(), rig.admin, disabled));
        std::set<std::string> answers;
        for (const auto& [name, password] : {std::pair("nobody", "correct horse"), std::pair("s1001", "wrong horse"),
                                             std::pair("s1002", "correct horse"), std::pair("no such name!", "x"),
                                             std::pair("", ""), std::pair("s1001", "AAAA-BBBB-CCCC")}) {
            const auto refused = rig.logIn(name, password);
            VERIFY_REFUSED(refused, ErrorCode::WrongLogin);
            answers.insert(refused.error().detail);
        }
        QCOMPARE(answers.size(), std::size_t{1});
    }

    /// Existing hashes keep the old cost until their users log in. So must the comparison for an unknown username.
    void unknownNamesTakeAsLongAfterTheCostWasRaised()
    {
        SchoolRig rig(support::populatedSchool(false));
        constexpr PasswordCost kDear{12, 8 << 20};
        VERIFY_DONE(raisePasswordCost(rig.school(), rig.admin, kDear));
        const FailedLogins times = timeFailedLogins(rig);
        // A comparison at the new cost would take a hundred times as long.
        QVERIFY2(times.unknownMs < 5.0 * times.knownMs, qPrintable(times.words()));
    }

    /// A login with an unknown username must take no longer either. A difference in time would reveal which usernames
    /// exist.
    void unknownNamesAreNotAnsweredAtOnce()
    {
        SchoolRig rig(support::populatedSchool(false));
        const double cheapMs = timeFailedLogins(rig).knownMs;
        VERIFY_DONE(raisePasswordCost(rig.school(), rig.admin, {12, 8 << 20}));
        for (const char* name : {"admin", "teach", "teach2", "s1001", "s1002", "s2001"})
            VERIFY_DONE(rig.logIn(name));  // which rehashes the password at the new cost
        const FailedLogins times = timeFailedLogins(rig);
        // Otherwise the comparison would not dominate the time, and the test would show nothing.
        QVERIFY2(times.knownMs > 5.0 * cheapMs,
                 qPrintable(times.words() + QStringLiteral(", cheap %1 ms").arg(cheapMs)));
        QVERIFY2(times.unknownMs < 2.0 * times.knownMs && times.knownMs < 2.0 * times.unknownMs,
                 qPrintable(times.words()));
    }

    void codesAreReadAsTheyAreTyped()
    {
        SchoolRig rig(support::populatedSchool(false));
        const auto entered = addPerson(rig.school(), rig.admin, {"slip", "", "", Role::Student});
        VERIFY_DONE(entered);
        const QString code = QString::fromStdString(entered->code);
        for (const QString& typed : {code, code.toLower(), QString(code).replace('-', ' '), QString(code).remove('-'),
                                     ' ' + QString(code).replace('-', QChar(0x2013)) + ' '})
            VERIFY_REFUSED(rig.logIn("slip", typed.toStdString()), ErrorCode::NewPassword);
        VERIFY_DONE(Logins::redeem(rig.school(), "slip", QString(code).remove('-').toStdString(), "another horse"));
        // A word of twelve letters may be a password.
        VERIFY_DONE(Logins::changePassword(rig.school(), rig.logIn("slip", "another horse").value(), "another horse",
                                           "zebrafinches"));
        VERIFY_DONE(rig.logIn("slip", "zebrafinches"));
    }

    void failuresDoubleTheWaitAcrossRuns_data() { support::addEngines(); }
    void failuresDoubleTheWaitAcrossRuns()
    {
        COPY_OF(support::populatedSchool, rig);
        // The same applies to an unknown username.
        for (const char* name : {"s1001", "nobody"}) {
            fail(rig, name);
            for (int wait = 1; wait <= 8; wait *= 2) {
                rig.reopen();
                const auto refused = rig.logIn(name);
                VERIFY_REFUSED(refused, ErrorCode::TooSoon);
                QVERIFY2(refused.error().detail.find("wait " + std::to_string(wait) + " second") != std::string::npos,
                         refused.error().detail.c_str());
                rig.nowUtc = rig.nowUtc.addMSecs(wait * 1000 - 1);
                VERIFY_REFUSED(rig.logIn(name), ErrorCode::TooSoon);
                rig.nowUtc = rig.nowUtc.addMSecs(1);
                VERIFY_REFUSED(rig.logIn(name, "wrong"), ErrorCode::WrongLogin);
            }
            rig.nowUtc = rig.nowUtc.addSecs(16);
        }
        VERIFY_DONE(rig.logIn("s1001"));
        // A successful login resets the count: the next failure causes no wait.
        VERIFY_REFUSED(rig.logIn("s1001", "wrong"), ErrorCode::WrongLogin);
        VERIFY_DONE(rig.logIn("s1001"));
        // The waiting time has an upper limit, however many logins fail.
        for (int k = 0; k < 40; ++k) {
            static_cast<void>(rig.logIn("s1002", "wrong"));
            rig.nowUtc = rig.nowUtc.addSecs(std::chrono::seconds(Logins::kLongestWait).count());
        }
        VERIFY_DONE(rig.logIn("s1002"));
    }

    /// Somebody who guesses on one computer does not keep the person out of the others.
    void failuresElsewhereKeepNobodyOut_data() { support::addEngines(); }
    void failuresElsewhereKeepNobodyOut()
    {
        COPY_OF(support::populatedSchool, rig);
        DatabaseContext elsewhere = rig.school();
        elsewhere.key = StationKey::make();
        const auto guess = [&](const DatabaseContext& at) { return Logins::login(at, "s1001", "wrong"); };
        for (int k = 0; k < Logins::kFreeFailures; ++k)
            VERIFY_REFUSED(guess(elsewhere), ErrorCode::WrongLogin);
        VERIFY_REFUSED(guess(elsewhere), ErrorCode::TooSoon);
        VERIFY_DONE(rig.logIn("s1001"));
        // Their own login here does not forgive the computer where it was guessed.
        VERIFY_REFUSED(guess(elsewhere), ErrorCode::TooSoon);
        // With a new key for each guess, guessing is slowed down, and the person waits for some seconds at most.
        core::ErrorCode code = ErrorCode::WrongLogin;
        for (int k = 0; k < Logins::kFreeFailuresAnywhere && code == ErrorCode::WrongLogin; ++k) {
            elsewhere.key = StationKey::make();
            code = guess(elsewhere).error().code;
        }
        QVERIFY(code == ErrorCode::TooSoon);
        rig.nowUtc = rig.nowUtc.addSecs(Logins::kLongestWaitAnywhere.count());
        VERIFY_DONE(rig.logIn("s1001"));
        // A one-time code of an admin ends every wait.
        VERIFY_DONE(resetPassword(rig.school(), rig.admin, rig.student.person()));
        QCOMPARE(rig.count("failed_logins"), 0);
    }

    void failuresOfTheDayBeforeAreForgotten_data() { support::addEngines(); }
    void failuresOfTheDayBeforeAreForgotten()
    {
        COPY_OF(support::populatedSchool, rig);
        for (int day = 0; day < 3; ++day) {
            fail(rig, "s1001");
            VERIFY_REFUSED(rig.logIn("s1001"), ErrorCode::TooSoon);
            rig.nowUtc = rig.nowUtc.addDays(1).addSecs(1);
        }
        VERIFY_DONE(rig.logIn("s1001"));
    }

    /// The clock is set back by a year, or one station's clock is a year ahead of another's.
    void aWrongClockLocksNobodyOutForLong_data() { support::addEngines(); }
    void aWrongClockLocksNobodyOutForLong()
    {
        COPY_OF(support::populatedSchool, rig);
        for (int k = 0; k < Logins::kFreeFailures + 2; ++k) {
            static_cast<void>(rig.logIn("s1001", "wrong"));
            rig.nowUtc = rig.nowUtc.addSecs(10);
        }
        rig.nowUtc = rig.nowUtc.addYears(-1);
        VERIFY_REFUSED(rig.logIn("s1001"), ErrorCode::TooSoon);
        rig.nowUtc = rig.nowUtc.addYears(1).addSecs(10);
        VERIFY_DONE(rig.logIn("s1001"));
        rig.nowUtc = rig.nowUtc.addYears(1);
        fail(rig, "s1002");
        rig.nowUtc = rig.nowUtc.addYears(-1);
        VERIFY_REFUSED(rig.logIn("s1002"), ErrorCode::TooSoon);
        rig.nowUtc = rig.nowUtc.addSecs(1);
        VERIFY_DONE(rig.logIn("s1002"));
    }

    void aClockThatIsAheadForgivesNobodyElse_data() { support::addEngines(); }
    void aClockThatIsAheadForgivesNobodyElse()
    {
        COPY_OF(support::populatedSchool, rig);
        fail(rig, "s1001");
        rig.nowUtc = rig.nowUtc.addDays(2);
        VERIFY_REFUSED(rig.logIn("nobody", "wrong"), ErrorCode::WrongLogin);
        rig.nowUtc = rig.nowUtc.addDays(-2);
        VERIFY_REFUSED(rig.logIn("s1001"), ErrorCode::TooSoon);
    }

    /// Failed logins with very many usernames must not fill the disk.
    void oldFailuresOfManyNamesAreForgotten_data() { support::addEngines(); }
    void oldFailuresOfManyNamesAreForgotten()
    {
        COPY_OF(support::populatedSchool, rig);
        rig.run({QStringLiteral("INSERT INTO failed_logins WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 "
                                "FROM n WHERE i < %1) SELECT 'x' || i, 1, %2 FROM n")
                     .arg(Logins::kMostFailedNames)
                     .arg(rig.nowUtc.toMSecsSinceEpoch())});
        rig.nowUtc = rig.nowUtc.addDays(2);
        VERIFY_REFUSED(rig.logIn("nobody", "wrong"), ErrorCode::WrongLogin);
        QCOMPARE(rig.count("failed_logins"), Logins::kMostFailedNames + 2);
        VERIFY_REFUSED(rig.logIn("nobody", "wrong"), ErrorCode::WrongLogin);
        QCOMPARE(rig.count("failed_logins"), 2);
    }

    void aServersClockIsTaken()
    {
        {
            SchoolRig file(false);
            QVERIFY(std::abs(clockOf(file.school().db)().secsTo(QDateTime::currentDateTimeUtc())) < 60);
        }
        NEEDS_SERVER();
        SchoolRig rig(true);
        QVERIFY(rig.isOpen());
        const QSqlDatabase& db = rig.school().db;
        QVERIFY(std::abs(clockOf(db)().secsTo(QDateTime::currentDateTimeUtc())) < 60);
        // The server's clock is two hours ahead.
        rig.run({"CREATE FUNCTION clock_timestamp() RETURNS timestamptz LANGUAGE sql AS $$ SELECT "
                 "pg_catalog.clock_timestamp() + interval '2 hours' $$",
                 "SET search_path = public, pg_catalog"});
        const qint64 ahead = QDateTime::currentDateTimeUtc().secsTo(clockOf(db)());
        QVERIFY2(std::abs(ahead - 7200) < 60, qPrintable(QString::number(ahead)));
    }

    void aCodeIsGoodOnceAndForThreeDays_data() { support::addEngines(); }
    void aCodeIsGoodOnceAndForThreeDays()
    {
        COPY_OF(support::populatedSchool, rig);
        const PersonId sam = rig.student.person();
        const std::string code = resetPassword(rig.school(), rig.admin, sam).value().code;
        VERIFY_REFUSED(rig.logIn("s1001"), ErrorCode::WrongLogin);
        VERIFY_REFUSED(rig.logIn("s1001", code), ErrorCode::NewPassword);
        VERIFY_REFUSED(Logins::redeem(rig.school(), "s1002", code, "another horse"), ErrorCode::WrongLogin);
        VERIFY_REFUSED(Logins::redeem(rig.school(), "s1001", code, "short"), ErrorCode::OutOfRange);
        VERIFY_REFUSED(Logins::redeem(rig.school(), "s1001", code, "WXYZ-WXYZ-2345"), ErrorCode::OutOfRange);
        // The code as a user types it from paper: a leading space and small letters.
        const std::string typed = ' ' + QString::fromStdString(code).toLower().toStdString();
        VERIFY_DONE(Logins::redeem(rig.school(), "s1001", typed, "another horse"));
        VERIFY_REFUSED(Logins::redeem(rig.school(), "s1001", code, "third horse!"), ErrorCode::WrongLogin);
        VERIFY_DONE(rig.logIn("s1001", "another horse"));

        const std::string late = resetPassword(rig.school(), rig.admin, sam).value().code;
        rig.nowUtc = rig.nowUtc.addSecs(std::chrono::seconds(Logins::kCodeLife).count() + 1);
        VERIFY_REFUSED(rig.logIn("s1001", late), ErrorCode::WrongLogin);
        // Neither code nor password is in the database.
        QCOMPARE(kept(rig.school(), "password_hash"), QString());
        QVERIFY(!kept(rig.school(), "reset_hash").contains(QString::fromStdString(late)));
    }

    void aHashIsRaisedOnLogin_data() { support::addEngines(); }
    void aHashIsRaisedOnLogin()
    {
        COPY_OF(support::populatedSchool, rig);
        const auto hash = [&rig] { return kept(rig.school(), "password_hash"); };
        const QString before = hash();
        QVERIFY2(before.startsWith("$argon2id$v=19$m=8,t=1,p=1$"), qPrintable(before));
        VERIFY_DONE(rig.logIn("s1001"));
        QCOMPARE(hash(), before);
        VERIFY_DONE(putSetting(rig.school(), "", "password.passes", "3"));
        VERIFY_DONE(rig.logIn("s1001"));
        QVERIFY2(hash().startsWith("$argon2id$v=19$m=8,t=3,p=1$"), qPrintable(hash()));
        // Only an admin can raise the cost. A small increase and any decrease are ignored.
        VERIFY_DONE(raisePasswordCost(rig.school(), rig.admin, {5, 8192}));
        VERIFY_DONE(raisePasswordCost(rig.school(), rig.admin, {1, 8192}));
        QVERIFY(passwordCost(rig.school()).value() == (PasswordCost{3, 8192}));
        VERIFY_REFUSED(raisePasswordCost(rig.school(), rig.instructor, {6, 8192}), ErrorCode::NotAllowed);
        VERIFY_DONE(raisePasswordCost(rig.school(), rig.admin, {6, 8192}));
        VERIFY_DONE(rig.logIn("s1001"));
        QVERIFY2(hash().startsWith("$argon2id$v=19$m=8,t=6,p=1$"), qPrintable(hash()));
        VERIFY_REFUSED(rig.logIn("nobody", "whatever it is"), ErrorCode::WrongLogin);
        VERIFY_DONE(rig.logIn("s1001"));
        // The cost of passwords cannot be changed or read as an ordinary setting.
        VERIFY_REFUSED(changeSetting(rig.school(), rig.admin, "password.passes", "1"), ErrorCode::NotAllowed);
        const auto settings = readSettings(rig.school(), rig.admin);
        VERIFY_DONE(settings);
        for (const auto& [name, value] : *settings)
            QVERIFY(name.rfind("password.", 0) != 0);
    }

    /// The audit notes each change, so that a check detects a hash that was written into the database directly.
    void everyChangeOfAPasswordIsNoted_data() { support::addEngines(); }
    void everyChangeOfAPasswordIsNoted()
    {
        COPY_OF(support::populatedSchool, rig);
        const DatabaseContext& school = rig.school();
        const Entered entered = addPerson(school, rig.admin, {"s1003", "Cod", "Three", Role::Student}).value();
        QCOMPARE(support::faultsOf(school.db), QString());
        const auto list = importRoster(school, rig.admin, "username\ns1004\n", false);
        VERIFY_DONE(list);
        QCOMPARE(support::faultsOf(school.db), QString());
        VERIFY_DONE(Logins::redeem(school, "s1004", list->people[0].code, SchoolRig::kPassword));
        const auto session = Logins::redeem(school, "s1003", entered.code, SchoolRig::kPassword);
        VERIFY_DONE(session);
        QCOMPARE(support::faultsOf(school.db), QString());
        VERIFY_DONE(Logins::changePassword(school, *session, SchoolRig::kPassword, "another horse"));
        QCOMPARE(support::faultsOf(school.db), QString());
        VERIFY_DONE(raisePasswordCost(school, rig.admin, {3, 8192}));
        VERIFY_DONE(Logins::login(school, "s1003", "another horse"));
        QCOMPARE(readAudit(school, rig.admin, 2)->back().action, std::string("password.rehash"));
        QCOMPARE(support::faultsOf(school.db), QString());
        VERIFY_DONE(resetPassword(school, rig.admin, entered.person.id));
        QCOMPARE(support::faultsOf(school.db), QString());
    }

    /// A hash keeps its cost even if the settings in the database ask for less.
    void aHashIsNeverMadeCheaper()
    {
        SchoolRig rig(support::populatedSchool(false));
        DatabaseContext school = rig.school();
        school.leastCost = {};  // the value outside of tests
        const auto hash = [&school] { return kept(school, "password_hash"); };
        QVERIFY(passwordCost(school).value() == PasswordCost{});
        VERIFY_DONE(Logins::login(school, "s1001", SchoolRig::kPassword));
        QVERIFY2(hash().startsWith("$argon2id$v=19$m=65536,t=2,p=1$"), qPrintable(hash()));
        VERIFY_DONE(putSetting(school, "", "password.passes", "3"));
        VERIFY_DONE(Logins::login(school, "s1001", SchoolRig::kPassword));
        const QString dear = hash();
        QVERIFY2(dear.startsWith("$argon2id$v=19$m=65536,t=3,p=1$"), qPrintable(dear));
        VERIFY_DONE(putSetting(school, "", "password.passes", "1"));
        VERIFY_DONE(putSetting(school, "", "password.memory", "8192"));
        VERIFY_DONE(Logins::login(school, "s1001", SchoolRig::kPassword));
        QCOMPARE(hash(), dear);
        // An excessive cost in the settings is limited as well, so that no login takes for ever.
        VERIFY_DONE(putSetting(school, "", "password.passes", "100000"));
        VERIFY_DONE(putSetting(school, "", "password.memory", "99999999999999"));
        QVERIFY(passwordCost(school).value() == (PasswordCost{16, std::size_t{1} << 30U}));
        std::string endless = dear.toStdString();
        endless.replace(endless.find("t=3"), 3, "t=100000");
        QVERIFY(!isPasswordHash(endless) && !fits(SchoolRig::kPassword, endless).value());
        QVERIFY(!wantsRehash(dear.toStdString(), {2, std::size_t{128} << 20U}));
    }

    /// A password is refused if it is too short or too long, contains the username, or is a common word or a sequence
    /// of keys, digits or letters.
    void passwordsThatEverybodyGuessesAreRefused()
    {
        for (const std::string& guessed :
             {std::string(), std::string("1234567"), std::string("S1001-abc"), std::string("s1001-ABC!2026"),
              std::string("password1234"), std::string("P@ssw0rd!"), std::string("qwertzui"), std::string("12345678"),
              std::string("987654321"), std::string("aaaaaaaaaaaa"), std::string(10'000, 'x'), std::string("football7"),
              std::string("abcabcab"), std::string("drowssap"), std::string("Summer2026"), std::string("Geheim!2026"),
              std::string("yxcvbnm,"), std::string("qazwsxedc"), std::string("20.11.2004")})
            QVERIFY2(support::whyNotRefused(checkPassword(guessed, "s1001-ABC"), ErrorCode::OutOfRange).isEmpty(),
                     guessed.c_str());
        for (const char* good : {"eight it", "歯科医院研修用鍵", "my password is long"})
            VERIFY_DONE(checkPassword(good, "s1001-ABC"));
    }

    void ownPasswordIsChangedWithTheOldOne_data() { support::addEngines(); }
    void ownPasswordIsChangedWithTheOldOne()
    {
        COPY_OF(support::populatedSchool, rig);
        VERIFY_REFUSED(Logins::changePassword(rig.school(), rig.student, "wrong", "another horse"),
                       ErrorCode::WrongLogin);
        VERIFY_REFUSED(Logins::changePassword(rig.school(), rig.guest, SchoolRig::kPassword, "another horse"),
                       ErrorCode::NotAllowed);
        VERIFY_DONE(Logins::changePassword(rig.school(), rig.student, SchoolRig::kPassword, "another horse"));
        VERIFY_REFUSED(rig.logIn("s1001"), ErrorCode::WrongLogin);
        VERIFY_DONE(rig.logIn("s1001", "another horse"));
        VERIFY_DONE(rig.logIn("s1002"));
    }

    void whoIsDisabledIsStoppedAtOnce_data() { support::addEngines(); }
    void whoIsDisabledIsStoppedAtOnce()
    {
        COPY_OF(support::populatedSchool, rig);
        VERIFY_DONE(standingsOf(rig.school(), rig.student, rig.student.person()));
        Person sam = findPerson(rig.school(), rig.admin, "s1001").value();
        sam.disabled = true;
        const auto studentsOfHis = [&] { return listClasses(rig.school(), rig.instructor)->front().students; };
        const int before = studentsOfHis();
        VERIFY_DONE(changePerson(rig.school(), rig.admin, sam));
        QCOMPARE(studentsOfHis(), before - 1);
        // Two admins change one user: a field that only the other admin changed keeps the other's value.
        Person asItWas = sam;
        asItWas.disabled = false;
        Person renamed = asItWas;
        renamed.givenName = "Samuel";
        VERIFY_DONE(changePerson(rig.school(), rig.admin, renamed, asItWas));
        QVERIFY(findPerson(rig.school(), rig.admin, sam.username)->disabled);
        QCOMPARE(findPerson(rig.school(), rig.admin, sam.username)->givenName, std::string("Samuel"));
        // A change to a field that the other admin has also changed is refused.
        Person called = asItWas;
        called.givenName = "Sammy";
        called.familyName = "Other";
        VERIFY_REFUSED(changePerson(rig.school(), rig.admin, called, asItWas), ErrorCode::ChangedSince);
        const Person now = findPerson(rig.school(), rig.admin, sam.username).value();
        QCOMPARE(now.givenName, std::string("Samuel"));
        QCOMPARE(now.familyName, asItWas.familyName);
        VERIFY_DONE(changePerson(rig.school(), rig.admin, renamed, asItWas));  // both ask for the same value
        const auto seen = changePerson(rig.school(), rig.admin, called, now);
        VERIFY_DONE(seen);
        QCOMPARE(seen->fullName(), std::string("Sammy Other"));
        QCOMPARE(findPerson(rig.school(), rig.admin, sam.username)->fullName(), seen->fullName());
        VERIFY_DONE(changePerson(rig.school(), rig.admin, sam));
        VERIFY_REFUSED(standingsOf(rig.school(), rig.student, rig.student.person()), ErrorCode::Disabled);
        // An instructor who becomes a student loses the rights of an instructor.
        Person ines = findPerson(rig.school(), rig.admin, "teach").value();
        ines.role = Role::Student;
        VERIFY_DONE(changePerson(rig.school(), rig.admin, ines));
        VERIFY_REFUSED(listPeople(rig.school(), rig.instructor), ErrorCode::NotAllowed);
        // The last admin cannot be disabled or given another role.
        Person ada = findPerson(rig.school(), rig.admin, "admin").value();
        ada.disabled = true;
        VERIFY_REFUSED(changePerson(rig.school(), rig.admin, ada), ErrorCode::NobodyLeft);
        ada.disabled = false;
        ada.role = Role::Instructor;
        VERIFY_REFUSED(changePerson(rig.school(), rig.admin, ada), ErrorCode::NobodyLeft);
        VERIFY_REFUSED(resetPassword(rig.school(), rig.admin, ada.id), ErrorCode::NobodyLeft);
    }

    void namesAreComparedAsPeopleTypeThem()
    {
        SchoolRig rig(support::populatedSchool(false));
        VERIFY_DONE(addPerson(rig.school(), rig.admin, {" Juergen.Gross ", "Jürgen", "Groß", Role::Student}));
        VERIFY_REFUSED(addPerson(rig.school(), rig.admin, {"JUERGEN.GROSS", "", "", Role::Student}),
                       ErrorCode::OutOfRange);
        QCOMPARE(findPerson(rig.school(), rig.admin, "ＪＵＥＲＧＥＮ.Gross").value().givenName, std::string("Jürgen"));
        for (const char* name : {"", "   ", "two words", "semi;colon", "new\nline", "<b>", "../x", "jürgen", "İlhan",
                                 "ılhan", "аdmin", "山田", "admin\u3164", "admin\u034F"})
            VERIFY_REFUSED(addPerson(rig.school(), rig.admin, {name, "", "", Role::Student}), ErrorCode::OutOfRange);
        VERIFY_REFUSED(addPerson(rig.school(), rig.admin, {std::string(65, 'x'), "", "", Role::Student}),
                       ErrorCode::OutOfRange);
        VERIFY_DONE(addPerson(rig.school(), rig.admin, {std::string(64, 'x'), "", "", Role::Student}));
        // Persian and Hindi need the zero-width joiners.
        VERIFY_DONE(addPerson(
            rig.school(), rig.admin,
            {"joined", "\u0639\u0644\u06CC\u200C\u0631\u0636\u0627", "\u0936\u094D\u200D\u0930", Role::Student}));
        for (const char* unseen : {"A\u202Eb", "A\nb", "A\u200Bb", "\u0007"})
            VERIFY_REFUSED(addPerson(rig.school(), rig.admin, {"hidden", unseen, "", Role::Student}),
                           ErrorCode::OutOfRange);
        // A kanji with a variation selector.
        VERIFY_DONE(addPerson(rig.school(), rig.admin, {"rare", "\u845B\U000E0100", "", Role::Student}));
        const char* nasty = "Robert'); DROP TABLE people; --";
        VERIFY_DONE(addPerson(rig.school(), rig.admin, {"bobby", nasty, "Tables", Role::Student}));
        QCOMPARE(findPerson(rig.school(), rig.admin, "bobby").value().givenName, std::string(nasty));
    }

    void theDearestCostIsNotUnderTheMinimum()
    {
        const PasswordCost quick = timedCost(0.0);
        QCOMPARE(quick.passes, 2ULL);
        QCOMPARE(quick.memoryBytes, std::size_t{64} << 20U);
        QVERIFY(timedCost(200.0).passes >= quick.passes);
    }

    /// The expected time is measured here, because it depends on the computer.
    void theCostIsTimedOnThisComputer()
    {
        const auto hashMs = [](const PasswordCost& cost) {
            return cpuMs([&] { VERIFY_DONE(hashPassword(SchoolRig::kPassword, cost)); });
        };
        const double onePassMs = hashMs({2, std::size_t{64} << 20U}) / 2.0;
        const double goalMs = 8.0 * onePassMs;
        const PasswordCost timed = timedCost(goalMs);
        QCOMPARE(timed.memoryBytes, std::size_t{64} << 20U);
        QVERIFY2(timed.passes >= 4 && timed.passes <= 12, qPrintable(QString::number(timed.passes)));
        const double neededMs = hashMs(timed);
        QVERIFY2(neededMs > goalMs / 3.0 && neededMs < 2.0 * goalMs,
                 qPrintable(QStringLiteral("%1 ms instead of %2 ms").arg(neededMs).arg(goalMs)));
        // A longer time gives a higher cost, at most sixteen passes.
        QVERIFY(timedCost(1.5 * onePassMs).passes <= timed.passes);
        QCOMPARE(timedCost(1000.0 * onePassMs).passes, 16ULL);
    }
};

CUSP_TEST(TestLogins)
#include "tst_logins.moc"
