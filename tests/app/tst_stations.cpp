// SPDX-License-Identifier: GPL-3.0-or-later
// Many stations at once, a station that is killed while it saves, a server that stops. Each station is this program in
// a process of its own. CUSP_STATIONS and CUSP_KILLS set the numbers.
#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <optional>
#include <set>

#include <QCoreApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QProcess>
#include <QSqlQuery>
#include <QTest>

#include "app/school/DailyBackup.h"
#include "app/school/SchoolService.h"
#include "core/base/Rng.h"
#include "core/teeth/Block.h"
#include "core/teeth/ToothBuilder.h"
#include "database/sql/Check.h"
#include "database/sql/Statement.h"
#include "tests/database/SchoolRig.h"

using namespace database;
using namespace database::sql;
using support::SchoolRig;

namespace {

int fromEnvironment(const char* name, int otherwise)
{
    const int value = qEnvironmentVariableIntValue(name);
    return value > 0 ? value : otherwise;
}

core::recording::Recording ofNothing()
{
    return {
        {},
        core::teeth::buildTooth(core::teeth::parseSource(core::teeth::blockName(core::teeth::BlockShape::Layers)), {})
            .value()
            .anatomy};
}

QByteArray recordingOfNothing()
{
    return QByteArray::fromStdString(ofNothing().toBytes());
}

ExamStart anExam()
{
    return {newUid(), "exam-36", "2026-11-20T10:00:00Z"};
}

/// A station. It logs in; then, for each attempt, it saves it to the outbox, reports that, waits until it is delivered,
/// and reports how long that took. Arguments: address, folder, username, number of attempts.
class Station : public QObject
{
public:
    explicit Station(const QStringList& words)
        : m_desk(Address::parse(words[0]).value(), words[1]), m_left(words[3].toInt()), m_recording(ofNothing())
    {
        QDir().mkpath(words[1]);
        connect(&m_desk, &app::SchoolService::delivered, this, [this](const QString& uid) {
            if (uid != QString::fromStdString(m_attempt.uid))
                return;  // a pending attempt of a station that was killed
            std::cout << "took " << m_since.nsecsElapsed() / 1000 << std::endl;
            next();
        });
        m_desk.open(this, [this, name = words[2].toStdString()](const app::SchoolService::Opening& opening) {
            if (!opening.status)
                fail(opening.status.error());
            m_desk.askDatabase(
                this,
                [name](const DatabaseContext& school) { return Logins::login(school, name, SchoolRig::kPassword); },
                [this](const core::Result<Login>& session) {
                    if (!session)
                        return fail(session.error());
                    m_session = *session;
                    next();
                });
        });
    }

private:
    void next()
    {
        if (m_left-- <= 0)
            return QCoreApplication::exit(0);
        m_attempt = SchoolRig::attempt("class1-36", 100 + m_left % 900);
        m_since.start();
        m_desk.keep(this, m_session, m_attempt, m_recording, [this](const core::Status& kept) {
            if (!kept)
                return fail(kept.error());
            std::cout << "kept " << m_attempt.uid << std::endl;
        });
    }
    static void fail(const core::Error& error)
    {
        std::cerr << error.detail << std::endl;
        QCoreApplication::exit(1);
    }

    app::SchoolService m_desk;
    Login m_session;
    AttemptRecord m_attempt;
    int m_left = 0;
    core::recording::Recording m_recording;
    QElapsedTimer m_since;
};

std::unique_ptr<QProcess> startStation(const SchoolRig& rig, const QString& folder, const QString& user, int attempts)
{
    QDir().mkpath(folder);
    auto station = std::make_unique<QProcess>();
    station->setProcessChannelMode(QProcess::ForwardedErrorChannel);
    station->start(QCoreApplication::applicationFilePath(),
                   {"--station", rig.address(), folder, user, QString::number(attempts)});
    return station;
}

/// Returns the rest of each line of a station's output that begins with these words.
QStringList said(const QByteArray& output, const char* beginning)
{
    QStringList words;
    for (const QString& line : QString::fromUtf8(output).split('\n'))
        if (line.startsWith(QLatin1String(beginning)))
            words += line.section(' ', 1);
    return words;
}

std::set<QString> keptIn(const DatabaseContext& school)
{
    std::set<QString> uids;
    static_cast<void>(forEach(school.db, "SELECT uid FROM attempts", "list them", {},
                              [&](const QSqlQuery& row) { uids.insert(row.value(0).toString()); }));
    return uids;
}

}  // namespace

/// Declares a school on the PostgreSQL server. Skips the test if there is no server.
#define SERVER_RIG(name)                                                                                               \
    if (!support::sharedServer().fault().isEmpty())                                                                    \
        QSKIP(qPrintable(support::sharedServer().fault()));                                                            \
    SchoolRig name(true);                                                                                              \
    QVERIFY((name).isOpen());                                                                                          \
    (name).populate()

class TestStations : public QObject
{
    Q_OBJECT

private slots:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }

    void manyStationsLoseNothing()
    {
        const int stations = fromEnvironment("CUSP_STATIONS", 6);
        constexpr int kEach = 20;
        SERVER_RIG(rig);
        for (int k = 0; k < stations; ++k)
            static_cast<void>(rig.join({"p" + std::to_string(k), "", "", Role::Student}, rig.first));
        std::vector<std::unique_ptr<QProcess>> running;
        for (int k = 0; k < stations; ++k)
            running.push_back(
                startStation(rig, m_folder->filePath(QString::number(k)), QStringLiteral("p%1").arg(k), kEach));
        std::vector<double> tookMs;
        std::set<QString> confirmed;
        for (const auto& station : running) {
            QVERIFY(station->waitForFinished(240'000));
            QCOMPARE(station->exitCode(), 0);
            const QByteArray output = station->readAllStandardOutput();
            for (const QString& uid : said(output, "kept "))
                confirmed.insert(uid);
            for (const QString& us : said(output, "took "))
                tookMs.push_back(us.toDouble() * 1e-3);
        }
        QCOMPARE(confirmed.size(), static_cast<std::size_t>(stations * kEach));
        QVERIFY(keptIn(rig.school()) == confirmed);
        expectSound(rig);
        std::sort(tookMs.begin(), tookMs.end());
        qInfo("%d stations, %zu attempts, put and delivered: p50 %.1f ms, p99 %.1f ms", stations, tookMs.size(),
              tookMs[tookMs.size() / 2], tookMs[tookMs.size() * 99 / 100]);
    }

    void killedStationsKeepWhatTheyConfirmed_data() { support::addEngines(); }

    void killedStationsKeepWhatTheyConfirmed()
    {
        SCHOOL_RIG(rig);
        rig.populate();
        const int kills = fromEnvironment("CUSP_KILLS", 12);
        std::set<QString> confirmed;
        core::Rng rng(20261123);
        for (int round = 0; round < kills; ++round) {
            const auto station = startStation(rig, m_folder->filePath("station"), "s1001", 10'000);
            QVERIFY(station->waitForStarted());
            QByteArray output;
            while (!output.contains("kept ")) {
                QVERIFY(station->waitForReadyRead(60'000));
                output += station->readAllStandardOutput();
            }
            QTest::qWait(rng.below(60));  // kills at a random moment
            ::kill(static_cast<pid_t>(station->processId()), SIGKILL);
            QVERIFY(station->waitForFinished(30'000));
            output += station->readAllStandardOutput();
            // An attempt was confirmed if its line was output completely.
            for (const QString& uid : said(output.left(output.lastIndexOf('\n') + 1), "kept "))
                confirmed.insert(uid);
        }
        // The next start delivers the pending attempts.
        const auto last = startStation(rig, m_folder->filePath("station"), "s1001", 0);
        QVERIFY(last->waitForFinished(60'000));
        QCOMPARE(last->exitCode(), 0);
        const std::set<QString> kept = keptIn(rig.school());
        for (const QString& uid : confirmed)
            QVERIFY2(kept.count(uid) == 1, qPrintable(uid + " was confirmed, and is lost"));
        rig.reopen();
        QVERIFY(rig.isOpen());
        expectSound(rig);
        QVERIFY(!QDir(m_folder->filePath("station/outbox/damaged")).exists());
        qInfo("%d kills, %zu attempts confirmed, %zu kept", kills, confirmed.size(), kept.size());
    }

    /// Saves graded attempts and an exam start through SchoolService, as the window does, whether or not the server
    /// answers.
    void aServerThatGoesAwayGetsEverythingOnce()
    {
        SERVER_RIG(rig);
        std::set<QString> put;
        int exams = 0;
        const auto countExams = [&] {
            return ask(rig.school().db, "SELECT count(*) FROM exam_starts", "count")->toInt();
        };
        const auto letters = [&] { return Outbox(m_folder->filePath("outbox"), StationKey::make()).waiting(); };
        const auto work = [&](app::SchoolService& desk) {
            int kept = 0;
            const auto count = [&kept](const core::Status& status) {
                VERIFY_DONE(status);
                ++kept;
            };
            const AttemptRecord attempt = SchoolRig::attempt("class1-36", 500);
            desk.keep(this, rig.student, anExam(), count);
            desk.keep(this, rig.student, attempt, ofNothing(), count);
            put.insert(QString::fromStdString(attempt.uid));
            ++exams;
            // An attempt is on the disk before the callback is called.
            QTRY_COMPARE(kept, 2);
        };
        {
            app::SchoolService desk(addressOf(rig), m_folder->path());
            open(desk);
            work(desk);
            QTRY_VERIFY(letters().isEmpty());
            support::sharedServer().kill();
            work(desk);
            work(desk);
            QCOMPARE(letters().size(), 4);
            desk.deliver();
        }
        // The program is closed without a server and started without one.
        QCOMPARE(letters().size(), 4);
        app::SchoolService desk(addressOf(rig), m_folder->path());
        bool isAway = false;
        desk.open(this, [&](const app::SchoolService::Opening& opening) { isAway = !opening.status; });
        QTRY_VERIFY(isAway);
        QCOMPARE(letters().size(), 4);
        QVERIFY(support::sharedServer().start());
        desk.deliver();
        QTRY_VERIFY(letters().isEmpty());
        VERIFY_DONE(rig.database().reconnect());
        QVERIFY(keptIn(rig.school()) == put);
        QCOMPARE(countExams(), exams);
        expectSound(rig);
    }

    /// The server restarts between two requests of a window. The service reconnects without an error.
    void ofAServerThatWasStartedAnewNobodyHears()
    {
        auto& server = support::sharedServer();
        SERVER_RIG(rig);
        app::SchoolService desk(addressOf(rig), m_folder->path());
        std::optional<core::Result<Login>> answered;
        const auto logIn = [&] {
            answered.reset();
            desk.askDatabase(
                this,
                [](const DatabaseContext& school) { return Logins::login(school, "s1001", SchoolRig::kPassword); },
                [&answered](const core::Result<Login>& session) { answered = session; });
            QTRY_VERIFY(answered);
        };
        logIn();
        VERIFY_DONE(*answered);
        server.stop();
        QVERIFY(server.start());
        logIn();
        VERIFY_DONE(*answered);
        server.stop();
        logIn();
        VERIFY_REFUSED(*answered, core::ErrorCode::ConnectionLost);
        QVERIFY(server.start());
        logIn();
        VERIFY_DONE(*answered);
    }

    void aLetterIsTakenOnce()
    {
        SchoolRig rig(false);
        rig.populate();
        const StationKey key = StationKey::make();
        Outbox outbox(m_folder->filePath("outbox"), key, "school.sqlite");
        std::set<QString> put;
        const auto keep = [&] {
            const AttemptRecord attempt = SchoolRig::attempt("class1-36", 500);
            VERIFY_DONE(outbox.put(rig.student, attempt, "recording"));
            put.insert(QString::fromStdString(attempt.uid));
        };
        const auto deliver = [&]() -> core::Status {
            for (const QString& file : outbox.waiting()) {
                const auto letter = outbox.read(file);
                if (!letter)
                    return tl::unexpected(letter.error());
                if (const auto id = deliverAttempt(rig.school(), letter->attempt, letter->recording); !id)
                    return tl::unexpected(id.error());
                outbox.remove(file);
            }
            return {};
        };
        // The confirmation of a delivery was lost, so the same attempt is delivered again.
        keep();
        const QString file = outbox.waiting().front();
        QVERIFY(QFile::copy(file, file + ".again"));
        VERIFY_DONE(deliver());
        QVERIFY(QFile::rename(file + ".again", file));
        VERIFY_DONE(deliver());
        QVERIFY(keptIn(rig.school()) == put);
        // A database that was restored to an older state receives again the attempts that it had received.
        keep();
        const QString arrived = outbox.waiting().front();
        outbox.keepArrived(arrived);
        QVERIFY(outbox.waiting().isEmpty());
        QCOMPARE(outbox.arrived().size(), 1);
        // Attempts for another school in this folder are not moved as long as that school exists.
        const Outbox ofOther(m_folder->filePath("outbox"), key, "other.sqlite");
        QFile school(m_folder->filePath("school.sqlite"));
        QVERIFY(school.open(QIODevice::WriteOnly));
        ofOther.sendAgain();
        QVERIFY(outbox.waiting().isEmpty());
        outbox.sendAgain();
        QCOMPARE(outbox.waiting(), QStringList{arrived});
        outbox.keepArrived(arrived);
        QVERIFY(school.remove());
        ofOther.sendAgain();
        QCOMPARE(outbox.waiting(), QStringList{arrived});
        QVERIFY(outbox.arrived().isEmpty());
        VERIFY_DONE(deliver());
        QVERIFY(keptIn(rig.school()) == put);
    }

    void aLetterIsRefusedThatWasChangedOrIsUnfit()
    {
        SchoolRig rig(false);
        rig.populate();
        Outbox outbox(m_folder->filePath("outbox"), StationKey::make(), "school.sqlite");
        VERIFY_DONE(outbox.put(rig.student, SchoolRig::attempt("class1-36", 500), "recording"));
        // An attempt signed with another key waits until that key is back.
        VERIFY_REFUSED(Outbox(m_folder->filePath("outbox"), StationKey::make()).read(outbox.waiting().front()),
                       core::ErrorCode::NotAllowed);
        // The database refuses an attempt whose file was changed, and one that it could never store and that would
        // block the others.
        const auto expectRefusalOfTheFirst = [&] {
            VERIFY_REFUSED(outbox.read(outbox.waiting().front()), core::ErrorCode::BadStructure);
            outbox.setAside(outbox.waiting().front());
        };
        QFile changed(outbox.waiting().front());
        QVERIFY(changed.open(QIODevice::ReadWrite) && changed.seek(400));
        changed.write("x");
        changed.close();
        expectRefusalOfTheFirst();
        QVERIFY(outbox.waiting().isEmpty());
        AttemptRecord unfit = SchoolRig::attempt("class1-36", 500);
        unfit.lessonId += '\0';
        VERIFY_DONE(outbox.put(rig.student, unfit, "recording"));
        expectRefusalOfTheFirst();
        unfit = SchoolRig::attempt("class1-36", 500);
        unfit.uid.pop_back();
        VERIFY_DONE(outbox.put(rig.student, unfit, "recording"));
        expectRefusalOfTheFirst();
        // A file of the other kind is not accepted.
        VERIFY_DONE(outbox.put(rig.student, anExam()));
        QVERIFY(Outbox::isExam(outbox.waiting().front()));
        QCOMPARE(outbox.readExam(outbox.waiting().front())->personUid, rig.student.uid());
        VERIFY_REFUSED(outbox.read(outbox.waiting().front()), core::ErrorCode::BadStructure);
        VERIFY_REFUSED(outbox.put(rig.guest, SchoolRig::attempt("class1-36", 1), {}), core::ErrorCode::NotAllowed);
    }

    /// Two windows of one user deliver from the same folder. An attempt that the other window has delivered is gone,
    /// not damaged.
    void twoWindowsDeliverWithoutAnAlarm()
    {
        SchoolRig rig(false);
        rig.populate();
        Outbox outbox = ownOutbox();
        constexpr int kLetters = 60;
        for (int k = 0; k < kLetters; ++k)
            VERIFY_DONE(outbox.put(rig.student, SchoolRig::attempt("class1-36", k), recordingOfNothing()));
        const QString gone = outbox.waiting().front();
        {
            app::SchoolService one(addressOf(rig), m_folder->path());
            app::SchoolService other(addressOf(rig), m_folder->path());
            for (app::SchoolService* desk : {&one, &other}) {
                connect(desk, &app::SchoolService::damaged, this,
                        [](const core::Error& error) { QFAIL(error.detail.c_str()); });
                connect(desk, &app::SchoolService::waitOn, this, [](int) { QFAIL("one waits on"); });
                open(*desk);
            }
            QTRY_VERIFY_WITH_TIMEOUT(outbox.waiting().isEmpty(), 60'000);
        }
        QCoreApplication::processEvents();
        QCOMPARE(keptIn(rig.school()).size(), static_cast<std::size_t>(kLetters));
        QVERIFY(!QDir(m_folder->filePath("outbox/damaged")).exists());
        VERIFY_REFUSED(outbox.read(gone), core::ErrorCode::FileMissing);
    }

    /// Two schools are used from one folder. An attempt for one school is not lost while the other is open.
    void aLetterWaitsForItsSchool()
    {
        SchoolRig mine(false);
        SchoolRig others(false);
        mine.populate();
        others.populate();
        const QString key = m_folder->filePath("station.key");
        const Outbox outbox(m_folder->filePath("outbox"), StationKey::readOrMake(key).value());
        AttemptRecord attempt = SchoolRig::attempt("class1-36", 500);
        VERIFY_DONE(Outbox(outbox).put(mine.student, attempt, recordingOfNothing()));
        const auto openOnce = [&](const QString& address) {
            app::SchoolService desk(Address::parse(address).value(), m_folder->path());
            int waiting = 0;
            bool isDelivered = false;
            connect(&desk, &app::SchoolService::waitOn, this, [&](int count) { waiting = count; });
            connect(&desk, &app::SchoolService::delivered, this, [&](const QString&) { isDelivered = true; });
            desk.open(this, [](const app::SchoolService::Opening&) {});
            [&] { QTRY_VERIFY(waiting > 0 || isDelivered); }();
            return waiting;
        };
        QCOMPARE(openOnce(others.address()), 1);
        QCOMPARE(outbox.waiting().size(), 1);
        QCOMPARE(openOnce(mine.address()), 0);
        QVERIFY(keptIn(mine.school()).count(QString::fromStdString(attempt.uid)) == 1);
        QVERIFY(outbox.waiting().isEmpty());
        // A delivered attempt is kept until the next backup of its school. A backup of the other school does not remove
        // it.
        const auto made = [&](const SchoolRig& rig, int day) {
            return app::makeBackup(DatabaseContext{rig.school().db, StationKey::readOrMake(key).value()},
                                   addressOf(rig), m_folder->path(), rig.nowUtc.addDays(day));
        };
        const Outbox ofMine(m_folder->filePath("outbox"), StationKey::readOrMake(key).value(),
                            Outbox::schoolAt(addressOf(mine), m_folder->path()));
        QCOMPARE(ofMine.arrived().size(), 1);
        VERIFY_DONE(made(mine, 0));
        QVERIFY(ofMine.arrived().isEmpty());
        VERIFY_DONE(Outbox(ofMine).put(mine.student, SchoolRig::attempt("class1-36", 600), {}));
        QVERIFY(ofMine.keepArrived(ofMine.waiting().front()));
        VERIFY_DONE(made(others, 0));
        QCOMPARE(ofMine.arrived().size(), 1);
        VERIFY_DONE(made(mine, 1));
        QVERIFY(ofMine.arrived().isEmpty());
    }

    /// The server always rejects one attempt, as its time limit would reject a very large one. The later attempts are
    /// delivered nevertheless.
    void whatAServerAlwaysStopsHoldsNothingUp()
    {
        SERVER_RIG(rig);
        AttemptRecord first = SchoolRig::attempt("class1-36", 500);
        first.uid = std::string(first.uid.size(), '0');  // makes it the first by its file name as well
        for (const QString& sql :
             {QStringLiteral("CREATE FUNCTION stop() RETURNS trigger LANGUAGE plpgsql AS $$ BEGIN RAISE EXCEPTION "
                             "'canceling statement due to statement timeout' USING ERRCODE = '57014'; END $$"),
              QStringLiteral("CREATE TRIGGER stop BEFORE INSERT ON attempts FOR EACH ROW WHEN (NEW.uid = '%1') EXECUTE "
                             "FUNCTION stop()")
                  .arg(QString::fromStdString(first.uid))})
            VERIFY_DONE(execute(rig.school().db, sql, "set a limit"));
        Outbox outbox = ownOutbox();
        VERIFY_DONE(outbox.put(rig.student, first, recordingOfNothing()));
        app::SchoolService desk(addressOf(rig), m_folder->path());
        std::optional<core::Status> opened;
        desk.open(this, [&](const app::SchoolService::Opening& opening) { opened = opening.status; });
        QTRY_VERIFY(opened.has_value());
        VERIFY_DONE(*opened);
        AttemptRecord later = SchoolRig::attempt("class1-36", 600);
        later.finishedUtc = "2026-11-20T11:00:00Z";
        VERIFY_DONE(outbox.put(rig.student, later, recordingOfNothing()));
        desk.deliver();
        desk.deliver();
        QTRY_COMPARE(outbox.waiting().size(), 1);
        QVERIFY(keptIn(rig.school()) == std::set<QString>{QString::fromStdString(later.uid)});
        // The rejected attempt is tried again.
        VERIFY_DONE(execute(rig.school().db, "DROP TRIGGER stop ON attempts", "lift the limit"));
        desk.deliver();
        QTRY_VERIFY(outbox.waiting().isEmpty());
        QCOMPARE(keptIn(rig.school()).size(), std::size_t{2});
    }

    void silenceIsToldAndOver()
    {
        SchoolRig rig(false);
        rig.populate();
        app::SchoolService desk(addressOf(rig), m_folder->path());
        QStringList told;
        connect(&desk, &app::SchoolService::unanswered, this, [&] { told << "unanswered"; });
        connect(&desk, &app::SchoolService::answered, this, [&] { told << "answered"; });
        const auto ask = [&](std::atomic<bool>& mayAnswer) {
            desk.askDatabase(
                this,
                [&mayAnswer](const DatabaseContext&) -> core::Result<bool> {
                    mayAnswer.wait(false);
                    return true;
                },
                [](const core::Result<bool>&) {});
        };
        std::atomic<bool> mayAnswer{true};
        ask(mayAnswer);
        QTRY_COMPARE(told, QStringList{"answered"});
        told.clear();
        mayAnswer = false;
        ask(mayAnswer);
        QTRY_COMPARE_WITH_TIMEOUT(told, QStringList{"unanswered"}, 30'000);
        mayAnswer = true;
        mayAnswer.notify_all();
        QTRY_COMPARE(told, (QStringList{"unanswered", "answered"}));
    }

    /// Opening a copy of the school does not send it any pending attempts.
    void aCopyOfASchoolGetsNoneOfItsLetters()
    {
        SchoolRig rig(false);
        rig.populate();
        const QString school = m_folder->filePath("school.sqlite");
        const QStringList copies{"trial.sqlite", "backup-2026-11-20-10.15.00.sqlite"};
        const QString backup = database::sql::backUp(rig.school().db, m_folder->filePath("b"), rig.nowUtc).value();
        QVERIFY(QFile::copy(backup, school));
        for (const QString& copy : copies)
            QVERIFY(QFile::copy(backup, m_folder->filePath(copy)));
        const auto key = StationKey::readOrMake(m_folder->filePath("station.key")).value();
        const auto addressOf = [&](const QString& name) { return Address::parse(m_folder->filePath(name)).value(); };
        Outbox outbox(m_folder->filePath("outbox"), key,
                      Outbox::schoolAt(addressOf("school.sqlite"), m_folder->path()));
        VERIFY_DONE(outbox.put(rig.student, SchoolRig::attempt("class1-36", 500), recordingOfNothing()));
        VERIFY_DONE(outbox.put(rig.student, anExam()));
        for (const QString& copy : copies) {
            app::SchoolService desk(addressOf(copy), m_folder->path());
            int waiting = 0;
            QString whose = "?";
            connect(&desk, &app::SchoolService::waitForOthers, this, [&](int count, const QString& schools) {
                waiting = count;
                whose = schools;
            });
            open(desk);
            QTRY_COMPARE(waiting, 2);
            QCOMPARE(whose, QString("school.sqlite"));
            QCOMPARE(outbox.waiting().size(), 2);
        }
        app::SchoolService desk(addressOf("school.sqlite"), m_folder->path());
        open(desk);
        QTRY_VERIFY(outbox.waiting().isEmpty());
        QCOMPARE(Outbox::schoolAt(Address::parse("postgresql://me@HOST/a").value(), m_folder->path()),
                 Outbox::schoolAt(Address::parse("postgresql://host:5432/a").value(), m_folder->path()));
        QVERIFY(Outbox::schoolAt(Address::parse("postgresql://host/a").value(), m_folder->path()) !=
                Outbox::schoolAt(Address::parse("postgresql://host/a_trial").value(), m_folder->path()));
    }

    /// Delivery is tried again, whether or not a user logs in.
    void aFileThatWasLockedAtTheStartGetsItsLetters()
    {
        SchoolRig rig(false);
        rig.populate();
        Outbox outbox = ownOutbox();
        VERIFY_DONE(outbox.put(rig.student, SchoolRig::attempt("class1-36", 500), recordingOfNothing()));
        VERIFY_DONE(execute(rig.school().db, "PRAGMA locking_mode = EXCLUSIVE", "lock"));
        VERIFY_DONE(execute(rig.school().db, "BEGIN EXCLUSIVE", "lock"));
        Database::Options hasty;
        hasty.patience = std::chrono::milliseconds(50);
        app::SchoolService desk(addressOf(rig), m_folder->path(), hasty);
        std::optional<core::Status> opened;
        desk.open(this, [&](const app::SchoolService::Opening& opening) { opened = opening.status; });
        QTRY_VERIFY(opened.has_value());
        VERIFY_REFUSED(*opened, core::ErrorCode::Busy);
        rig.close();
        desk.deliver();
        QTRY_VERIFY(outbox.waiting().isEmpty());
        QCOMPARE(outbox.arrived().size(), 1);
    }

private:
    static Address addressOf(const SchoolRig& rig) { return Address::parse(rig.address()).value(); }
    /// Returns the outbox that signs with the station's own key.
    [[nodiscard]] Outbox ownOutbox() const
    {
        return {m_folder->filePath("outbox"), StationKey::readOrMake(m_folder->filePath("station.key")).value()};
    }

    void open(app::SchoolService& desk)
    {
        desk.open(this, [](const app::SchoolService::Opening& opening) { VERIFY_DONE(opening.status); });
    }

    static void expectSound(const SchoolRig& rig)
    {
        const auto report = checkDatabase(rig.school().db, {});
        VERIFY_DONE(report);
        QVERIFY2(report->findings.empty(), qPrintable(support::wordsOf(report->findings)));
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

int main(int argc, char** argv)
{
    QCoreApplication application(argc, argv);
    const QStringList arguments = QCoreApplication::arguments();
    if (arguments.value(1) == u"--station") {
        const Station station(arguments.mid(2));
        return QCoreApplication::exec();
    }
    TestStations test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_stations.moc"
