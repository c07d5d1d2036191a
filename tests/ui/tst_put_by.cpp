// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include <QDir>
#include <QFile>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include "ui/shell/PutBy.h"

using ui::shell::PutBy;

namespace {

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
    void whatCannotBeWrittenIsSaid();

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
    PutBy window(folder());
    QVERIFY(window.found().isEmpty() && window.keep({}));
    QVERIFY(!QDir(folder()).exists());
}

void TestPutBy::whatWasKeptIsFoundByTheNext()
{
    {
        PutBy window(folder());
        QVERIFY(window.keep(typed("first")) && window.keep(typed("second")));
    }
    QCOMPARE(files(), QStringList{"1.json"});
    QCOMPARE(QFile::permissions(folder() + "/1.json") & (QFile::ReadGroup | QFile::ReadOther), QFile::Permissions());
    {
        PutBy window(folder());
        QCOMPARE(window.found(), typed("second"));
    }
    PutBy window(folder());
    QCOMPARE(window.found(), typed("second"));  // who found it has not decided on it
    QVERIFY(window.keep({}));
    QVERIFY(files().isEmpty());
}

void TestPutBy::eachWindowHasItsOwn()
{
    PutBy first(folder());
    QVERIFY(first.keep(typed("first")));
    PutBy second(folder());
    QVERIFY(second.found().isEmpty());  // it may be sent there yet
    QVERIFY(second.keep(typed("second")) && second.keep({}));
    QVERIFY(QFile::exists(folder() + "/1.json"));
}

void TestPutBy::oneThatTakesOverLeavesOneFile()
{
    {
        PutBy first(folder());
        QVERIFY(first.keep(typed("first")));
        PutBy second(folder());
        QVERIFY(second.keep(typed("second")));
    }
    const QJsonArray both{typed("first")[0], typed("second")[0]};
    {
        PutBy next(folder());
        QCOMPARE(next.found(), both);
        QVERIFY(next.keep(both));
    }
    QCOMPARE(files(), QStringList{"1.json"});
    // A window that was killed between writing one and removing the other.
    QVERIFY(QFile::copy(folder() + "/1.json", folder() + "/7.json"));
    PutBy next(folder());
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
        PutBy window(folder());
        QVERIFY(window.found().isEmpty());
        QVERIFY(window.keep(typed("mine")));
    }
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.readAll(), bytes);
    QCOMPARE(PutBy(folder()).found(), typed("mine"));
}

void TestPutBy::whatCannotBeWrittenIsSaid()
{
    QFile inTheWay(folder());  // not even root can write here
    QVERIFY(inTheWay.open(QIODevice::WriteOnly));
    PutBy window(folder());
    QVERIFY(window.keep({}) && !window.keep(typed("mine")));
    QVERIFY(inTheWay.remove());
    QVERIFY(window.keep(typed("mine")));
    // What was kept before stays where the next cannot be.
    QVERIFY(QFile::remove(folder() + "/1.json") && QDir(folder()).mkdir("1.json"));
    QVERIFY(!window.keep(typed("more")));
}

QTEST_GUILESS_MAIN(TestPutBy)
#include "tst_put_by.moc"
