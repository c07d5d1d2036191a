// SPDX-License-Identifier: GPL-3.0-or-later
#include <QFile>
#include <QFileInfo>
#include <QSqlQuery>
#include <QTemporaryDir>
#include <QTest>

#include "database/sql/Database.h"
#include "database/sql/SqlAttemptRepository.h"

using namespace database;
using namespace std::chrono_literals;

class TestAttemptRepository : public QObject
{
    Q_OBJECT

private slots:
    void init();
    void cleanup();

    void keepsEveryFieldAcrossAReopening();
    void givesEachAttemptANewId();
    void listsALessonsOwn();
    void listsTheNewestFirst();
    void bestIsTheFirstToReachTheHighestScore();
    void answersNothingForAnUnknownTooth();
    void bindsValuesInsteadOfPastingThem();
    void refusesWhatTheSchemaForbids_data();
    void refusesWhatTheSchemaForbids();
    void saysThatTheDiskIsFullAndGoesOnAfterwards();
    void saysThatAnotherProgramWrites();
    void saysThatTheFileIsReadOnly();

private:
    static AttemptRecord attempt(const char* tooth, int score, const char* finished)
    {
        AttemptRecord record;
        record.finishedUtc = finished;
        record.tooth = tooth;
        record.scoreTenths = 10 * score;
        record.durationMs = 600'000;
        record.scoreSheetJson = "{}";
        record.stateHash = "0123456789abcdef";
        record.recordingFile = "attempt.cusprec";
        return record;
    }
    std::int64_t add(const AttemptRecord& record)
    {
        const auto id = m_attempts->add(record);
        if (!id)
            qWarning("%s", id.error().detail.c_str());
        return id.value_or(-1);
    }
    static std::vector<std::int64_t> ids(const core::Result<std::vector<AttemptRecord>>& found)
    {
        std::vector<std::int64_t> list;
        for (const AttemptRecord& record : found.value())
            list.push_back(record.id);
        return list;
    }

    std::optional<QTemporaryDir> m_folder;
    QString m_path;
    std::unique_ptr<sql::Database> m_database;
    std::optional<sql::SqlAttemptRepository> m_attempts;
};

void TestAttemptRepository::init()
{
    m_folder.emplace();
    m_path = m_folder->filePath("attempts.db");
    auto database = sql::Database::open(m_path, 10ms);
    QVERIFY(database.has_value());
    m_database = std::move(*database);
    m_attempts.emplace(m_database->handle());
}

void TestAttemptRepository::cleanup()
{
    m_attempts.reset();
    m_database.reset();
}

void TestAttemptRepository::keepsEveryFieldAcrossAReopening()
{
    AttemptRecord record = attempt("36", 87, "2026-11-20T10:15:00Z");
    record.durationMs = 5'000'000'000;  // more than 32 bits hold
    record.scoreSheetJson = "{\"note\": \"Z\xC3\xA4hne \xE7\x89\x99 'quoted' \\\"\"}";
    record.recordingFile = "";
    record.lessonId = "decay-36-moderate";
    record.lessonHash = std::string(64, 'a');
    record.rubricHash = std::string(64, 'b');
    record.passed = true;
    record.expectedTenths = 715;
    record.id = add(record);
    QVERIFY(record.id > 0);

    cleanup();
    auto database = sql::Database::open(m_path);
    QVERIFY(database.has_value());
    sql::SqlAttemptRepository again((*database)->handle());
    const auto found = again.byTooth("36", 10);
    QVERIFY(found.has_value());
    QCOMPARE(found->size(), std::size_t{1});
    QVERIFY(found->front() == record);
}

void TestAttemptRepository::givesEachAttemptANewId()
{
    AttemptRecord record = attempt("36", 50, "2026-11-20T10:15:00Z");
    record.id = 77;  // ignored
    const std::int64_t first = add(record);
    const std::int64_t second = add(record);
    QVERIFY(first > 0 && first != 77);
    QVERIFY(second > first);
}

void TestAttemptRepository::listsALessonsOwn()
{
    AttemptRecord lesson = attempt("36", 50, "2026-11-18T10:15:00Z");
    lesson.lessonId = "class1-36";
    const auto first = add(lesson);
    static_cast<void>(add(attempt("36", 90, "2026-11-19T10:15:00Z")));
    lesson.finishedUtc = "2026-11-20T10:15:00Z";
    const auto second = add(lesson);
    QCOMPARE(ids(m_attempts->byLesson("class1-36", 10)), (std::vector<std::int64_t>{second, first}));
    QCOMPARE(ids(m_attempts->byLesson("class1-36", 1)), (std::vector<std::int64_t>{second}));
    QVERIFY(m_attempts->byLesson("class1-37", 10)->empty());
}

void TestAttemptRepository::listsTheNewestFirst()
{
    const auto old = add(attempt("36", 50, "2026-11-18T10:15:00Z"));
    const auto newest = add(attempt("36", 40, "2026-11-20T10:15:00Z"));
    const auto middle = add(attempt("24", 60, "2026-11-19T10:15:00Z"));
    const auto tied = add(attempt("36", 30, "2026-11-20T10:15:00Z"));
    QCOMPARE(ids(m_attempts->byTooth("36", 10)), (std::vector<std::int64_t>{tied, newest, old}));
    QCOMPARE(ids(m_attempts->byTooth("36", 2)), (std::vector<std::int64_t>{tied, newest}));
    QCOMPARE(ids(m_attempts->recent(10)), (std::vector<std::int64_t>{tied, newest, middle, old}));
    QCOMPARE(ids(m_attempts->recent(0)), std::vector<std::int64_t>{});
    QCOMPARE(ids(m_attempts->recent(-5)), std::vector<std::int64_t>{});
}

void TestAttemptRepository::bestIsTheFirstToReachTheHighestScore()
{
    add(attempt("36", 70, "2026-11-18T10:15:00Z"));
    const auto first = add(attempt("36", 90, "2026-11-19T10:15:00Z"));
    add(attempt("36", 90, "2026-11-20T10:15:00Z"));
    add(attempt("24", 100, "2026-11-20T10:15:00Z"));
    const auto best = m_attempts->best("36");
    QVERIFY(best.has_value() && best->has_value());
    QCOMPARE((*best)->id, first);
}

void TestAttemptRepository::answersNothingForAnUnknownTooth()
{
    QVERIFY(m_attempts->byTooth("11", 10)->empty());
    QVERIFY(!m_attempts->best("11")->has_value());
}

void TestAttemptRepository::bindsValuesInsteadOfPastingThem()
{
    const char* nasty = "36'; DROP TABLE attempts; --";
    QVERIFY(add(attempt(nasty, 50, "2026-11-20T10:15:00Z")) > 0);
    QCOMPARE(m_attempts->byTooth(nasty, 10)->size(), std::size_t{1});
    QVERIFY(m_attempts->byTooth("' OR 1 = 1 --", 10)->empty());
}

void TestAttemptRepository::refusesWhatTheSchemaForbids_data()
{
    QTest::addColumn<int>("score");
    QTest::addColumn<qint64>("durationMs");
    QTest::addColumn<QByteArray>("finished");
    QTest::addColumn<QByteArray>("tooth");
    QTest::addColumn<QByteArray>("hash");
    const QByteArray time = "2026-11-20T10:15:00Z";
    const QByteArray hash = "0123456789abcdef";
    QTest::newRow("score over 100") << 101 << qint64{1} << time << QByteArray("36") << hash;
    QTest::newRow("score under 0") << -1 << qint64{1} << time << QByteArray("36") << hash;
    QTest::newRow("negative duration") << 50 << qint64{-1} << time << QByteArray("36") << hash;
    QTest::newRow("local time") << 50 << qint64{1} << QByteArray("2026-11-20 10:15:00") << QByteArray("36") << hash;
    QTest::newRow("no tooth") << 50 << qint64{1} << time << QByteArray("") << hash;
    QTest::newRow("short hash") << 50 << qint64{1} << time << QByteArray("36") << QByteArray("abc");
}

void TestAttemptRepository::refusesWhatTheSchemaForbids()
{
    QFETCH(int, score);
    QFETCH(qint64, durationMs);
    QFETCH(QByteArray, finished);
    QFETCH(QByteArray, tooth);
    QFETCH(QByteArray, hash);
    AttemptRecord record = attempt(tooth.constData(), score, finished.constData());
    record.durationMs = durationMs;
    record.stateHash = hash.toStdString();
    const auto refused = m_attempts->add(record);
    QVERIFY(!refused.has_value());
    QVERIFY2(refused.error().detail.find("a value is not allowed") != std::string::npos,
             refused.error().detail.c_str());
    QVERIFY(m_attempts->recent(10)->empty());
}

void TestAttemptRepository::saysThatTheDiskIsFullAndGoesOnAfterwards()
{
    QSqlQuery query(m_database->handle());
    QVERIFY(query.exec("PRAGMA page_count") && query.next());
    const int pages = query.value(0).toInt();
    QVERIFY(query.exec(QStringLiteral("PRAGMA max_page_count = %1").arg(pages)));
    query.clear();
    AttemptRecord large = attempt("36", 50, "2026-11-20T10:15:00Z");
    large.scoreSheetJson.assign(100'000, 'x');
    const auto refused = m_attempts->add(large);
    QVERIFY(!refused.has_value());
    QVERIFY2(refused.error().detail.find("the disk is full") != std::string::npos, refused.error().detail.c_str());
    QVERIFY(m_attempts->recent(10)->empty());

    QVERIFY(query.exec("PRAGMA max_page_count = 100000"));
    query.clear();
    QVERIFY(add(large) > 0);
}

void TestAttemptRepository::saysThatAnotherProgramWrites()
{
    auto other = sql::Database::open(m_path, 10ms);
    QVERIFY(other.has_value());
    QSqlQuery hold((*other)->handle());
    QVERIFY(hold.exec("BEGIN IMMEDIATE"));
    const auto refused = m_attempts->add(attempt("36", 50, "2026-11-20T10:15:00Z"));
    QVERIFY(!refused.has_value());
    QVERIFY2(refused.error().detail.find("another program is writing") != std::string::npos,
             refused.error().detail.c_str());
    QVERIFY(m_attempts->recent(10).has_value());  // readers are not kept waiting
    QVERIFY(hold.exec("ROLLBACK"));
    QVERIFY(add(attempt("36", 50, "2026-11-20T10:15:00Z")) > 0);
}

void TestAttemptRepository::saysThatTheFileIsReadOnly()
{
    QSqlQuery query(m_database->handle());
    QVERIFY(query.exec("PRAGMA query_only = ON"));
    const auto refused = m_attempts->add(attempt("36", 50, "2026-11-20T10:15:00Z"));
    QVERIFY(!refused.has_value());
    QVERIFY2(refused.error().detail.find("read-only") != std::string::npos, refused.error().detail.c_str());
}

QTEST_GUILESS_MAIN(TestAttemptRepository)
#include "tst_attempt_repository.moc"
