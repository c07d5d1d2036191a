// SPDX-License-Identifier: GPL-3.0-or-later
#include <csignal>
#include <memory>

#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>
#include <sys/resource.h>

#include "ui/shell/PutBy.h"

using ui::shell::PutBy;

namespace {

const QString kSchool = QStringLiteral("school.sqlite");

QJsonArray typed(const QString& words)
{
    return {QJsonObject{{"comment", words}}};
}

}  // namespace

class TestPutBy : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void nothingIsWrittenBeforeThereIsSomething();
    void whatWasKeptIsFoundByTheNext();
    void eachWindowHasItsOwn();
    void oneThatTakesOverLeavesOneFile();
    void whatIsNoSuchFileStaysAsItIs_data();
    void whatIsNoSuchFileStaysAsItIs();
    void aLockThatNobodyHoldsHoldsNothing();
    void whatLiesThereIsNotWrittenAgain();
    void whatCannotBeWrittenIsSaid();
    void anotherSchoolsWaitsForIt();
    void whatNamesNoSchoolIsTakenOnce();

private:
    [[nodiscard]] QString folder() const { return m_folder->filePath("put-by"); }
    [[nodiscard]] QStringList files() const { return QDir(folder()).entryList(QDir::Files); }

    std::unique_ptr<QTemporaryDir> m_folder;
};

void TestPutBy::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
}

void TestPutBy::nothingIsWrittenBeforeThereIsSomething()
{
    PutBy window(folder(), kSchool);
    QVERIFY(window.found().isEmpty() && window.keep({}));
    QVERIFY(!QDir(folder()).exists());
}

void TestPutBy::whatWasKeptIsFoundByTheNext()
{
    {
        PutBy window(folder(), kSchool);
        QVERIFY(window.keep(typed("first")) && window.keep(typed("second")));
    }
    QCOMPARE(files(), QStringList{"1.json"});
    QCOMPARE(QFile::permissions(folder() + "/1.json") & (QFile::ReadGroup | QFile::ReadOther), QFile::Permissions());
    {
        PutBy window(folder(), kSchool);
        QCOMPARE(window.found(), typed("second"));
    }
    PutBy window(folder(), kSchool);
    QCOMPARE(window.found(), typed("second"));  // who found it has not decided on it
    QVERIFY(window.keep({}));
    QVERIFY(files().isEmpty());
}

void TestPutBy::eachWindowHasItsOwn()
{
    PutBy first(folder(), kSchool);
    QVERIFY(first.keep(typed("first")));
    PutBy second(folder(), kSchool);
    QVERIFY(second.found().isEmpty());  // it may be sent there yet
    QVERIFY(second.keep(typed("second")) && second.keep({}));
    QVERIFY(QFile::exists(folder() + "/1.json"));
}

void TestPutBy::oneThatTakesOverLeavesOneFile()
{
    {
        PutBy first(folder(), kSchool);
        QVERIFY(first.keep(typed("first")));
        PutBy second(folder(), kSchool);
        QVERIFY(second.keep(typed("second")));
    }
    const QJsonArray both{typed("first")[0], typed("second")[0]};
    {
        PutBy next(folder(), kSchool);
        QCOMPARE(next.found(), both);
        QVERIFY(next.keep(both));
    }
    QCOMPARE(files(), QStringList{"1.json"});
    // A window that was killed between writing one and removing the other.
    QVERIFY(QFile::copy(folder() + "/1.json", folder() + "/7.json"));
    PutBy next(folder(), kSchool);
    QCOMPARE(next.found(), both);
}

void TestPutBy::whatIsNoSuchFileStaysAsItIs_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("empty") << QByteArray();
    QTest::newRow("noise") << QByteArray(1000, '\xfe');
    QTest::newRow("deep") << QByteArray(100'000, '[');
    QTest::newRow("another kind") << QByteArray("{\"typed\": 7}");
    QTest::newRow("cut off") << QByteArray("{\"typed\": [{\"comment\": \"Ha");
}

void TestPutBy::whatIsNoSuchFileStaysAsItIs()
{
    QFETCH(QByteArray, bytes);
    QVERIFY(QDir().mkpath(folder()));
    QFile file(folder() + "/1.json");
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
    file.close();
    {
        PutBy window(folder(), kSchool);
        QVERIFY(window.found().isEmpty());
        QVERIFY(window.keep(typed("mine")));
    }
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.readAll(), bytes);
    QCOMPARE(PutBy(folder(), kSchool).found(), typed("mine"));
}

/// However it ended, and on whatever computer that was.
void TestPutBy::aLockThatNobodyHoldsHoldsNothing()
{
    QVERIFY(PutBy(folder(), kSchool).keep(typed("mine")));
    for (const QByteArray& left : {QByteArray(), QByteArray("7\ncusp\nelsewhere\n")}) {
        QFile lock(folder() + "/1.json.lock");
        QVERIFY(lock.open(QIODevice::WriteOnly) && lock.write(left) == left.size());
        lock.close();
        QCOMPARE(PutBy(folder(), kSchool).found(), typed("mine"));
        QVERIFY(!lock.exists());
    }
}

/// On a full disk a window that has nothing new to write can be closed.
void TestPutBy::whatLiesThereIsNotWrittenAgain()
{
    QVERIFY(PutBy(folder(), kSchool).keep(typed("mine")));
    PutBy window(folder(), kSchool);
    rlimit before{};
    QCOMPARE(getrlimit(RLIMIT_FSIZE, &before), 0);
    signal(SIGXFSZ, SIG_IGN);
    const rlimit full{0, before.rlim_max};
    QCOMPARE(setrlimit(RLIMIT_FSIZE, &full), 0);
    const bool isSame = window.keep(typed("mine"));
    const bool isMore = window.keep(typed("more"));
    QCOMPARE(setrlimit(RLIMIT_FSIZE, &before), 0);
    QVERIFY(isSame && !isMore);
    QVERIFY(window.keep(typed("more")));
}

void TestPutBy::whatCannotBeWrittenIsSaid()
{
    QFile inTheWay(folder());  // not even root can write here
    QVERIFY(inTheWay.open(QIODevice::WriteOnly));
    PutBy window(folder(), kSchool);
    QVERIFY(window.keep({}) && !window.keep(typed("mine")));
    QVERIFY(inTheWay.remove());
    QVERIFY(window.keep(typed("mine")));
    // What was kept before stays where the next cannot be.
    QVERIFY(QFile::remove(folder() + "/1.json") && QDir(folder()).mkdir("1.json"));
    QVERIFY(!window.keep(typed("more")));
}

/// Also while a window of this one is open.
void TestPutBy::anotherSchoolsWaitsForIt()
{
    QVERIFY(PutBy(folder(), kSchool).keep(typed("mine")));
    PutBy copy(folder(), "copy.sqlite");
    QVERIFY(copy.found().isEmpty());
    QVERIFY(copy.keep(typed("another's")) && copy.keep({}));
    PutBy window(folder(), kSchool);
    QCOMPARE(window.found(), typed("mine"));
    QVERIFY(copy.keep(typed("another's")));
    QCOMPARE(PutBy(folder(), kSchool).found(), QJsonArray());  // a window holds it
    QVERIFY(window.keep({}));
    QCOMPARE(PutBy(folder(), kSchool).found(), QJsonArray());
}

/// An earlier program has left it.
void TestPutBy::whatNamesNoSchoolIsTakenOnce()
{
    QVERIFY(QDir().mkpath(folder()));
    QFile earlier(QDir(folder()).filePath("1.json"));
    QVERIFY(earlier.open(QIODevice::WriteOnly));
    earlier.write(QJsonDocument(QJsonObject{{"typed", typed("mine")}}).toJson());
    earlier.close();
    {
        PutBy window(folder(), kSchool);
        QCOMPARE(window.found(), typed("mine"));
        QVERIFY(window.keep(window.found()));
    }
    QVERIFY(PutBy(folder(), "copy.sqlite").found().isEmpty());
    QCOMPARE(PutBy(folder(), kSchool).found(), typed("mine"));
}

QTEST_GUILESS_MAIN(TestPutBy)
#include "tst_put_by.moc"
