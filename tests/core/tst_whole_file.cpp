// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>

#include <sys/stat.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "core/base/WholeFile.h"
#include "tests/support/Checks.h"
#include "tests/support/FullDisk.h"

using core::isSameFile;
using core::writeWhole;

class TestWholeFile : public QObject
{
    Q_OBJECT

private slots:
    void replacesAnOlderFileAndLeavesNothingBeside()
    {
        put("a", "old");
        QVERIFY(writeWhole(at("a"), "new", "It"));
        QCOMPARE(contents("a"), QByteArray("new"));
        QCOMPARE(names(), QStringList{"a"});
    }

    void leavesFilesOfTheUserAlone()
    {
        put("a.part", "mine");
        QVERIFY(QDir(m_folder.path()).mkdir("a.part1"));
        QVERIFY(writeWhole(at("a"), "newer", "It"));
        QCOMPARE(contents("a"), QByteArray("newer"));
        QCOMPARE(contents("a.part"), QByteArray("mine"));
        QCOMPARE(names(), (QStringList{"a", "a.part", "a.part1"}));
    }

    void aFullDiskLeavesTheOlderFile()
    {
        put("b", "old");
        const QStringList before = names();
        {
            const support::FullDisk full(100);
            QVERIFY(
                support::isRefused(writeWhole(at("b"), std::string(200, 'x'), "It"), core::ErrorCode::FileUnwritable));
        }
        QCOMPARE(contents("b"), QByteArray("old"));
        QCOMPARE(names(), before);
    }

    void replacesNothingButFiles()
    {
        QVERIFY(QDir(m_folder.path()).mkdir("folder"));
        QCOMPARE(mkfifo(at("pipe").c_str(), 0600), 0);
        const QStringList before = names();
        for (const auto& path : {at("folder"), at("pipe"), at("none") / "file", std::filesystem::path("/dev/null"),
                                 std::filesystem::path()}) {
            const auto status = writeWhole(path, "bytes", "It");
            QVERIFY2(!status, path.c_str());
            QVERIFY(status.error().detail.starts_with("It could not be written to '" + path.string() + "': "));
        }
        QCOMPARE(names(), before);
        QVERIFY(std::filesystem::is_character_file("/dev/null"));
    }

    void writesThroughALink()
    {
        put("target", "old");
        QVERIFY(QFile::link(m_folder.filePath("target"), m_folder.filePath("link")));
        QVERIFY(writeWhole(at("link"), "new", "It"));
        QCOMPARE(contents("target"), QByteArray("new"));
        QVERIFY(std::filesystem::is_symlink(at("link")));
    }

    void knowsTheSameFileByOtherNames()
    {
        put("c", "");
        std::filesystem::create_hard_link(at("c"), at("d"));
        QVERIFY(isSameFile(at("c"), at("d")));
        QVERIFY(isSameFile(at("c"), at("folder") / ".." / "c"));
        QVERIFY(!isSameFile(at("c"), at("b")));
        // Not there yet.
        QVERIFY(isSameFile(at("new"), at("folder") / ".." / "new"));
        QVERIFY(!isSameFile(at("new"), at("newer")));
        QVERIFY(isSameFile("new", std::filesystem::current_path() / "new"));
    }

private:
    std::filesystem::path at(const char* name) const { return m_folder.filePath(name).toStdString(); }

    void put(const char* name, const QByteArray& bytes)
    {
        QFile file(m_folder.filePath(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        QCOMPARE(file.write(bytes), bytes.size());
    }

    QByteArray contents(const char* name) const
    {
        QFile file(m_folder.filePath(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("(cannot be read)");
    }

    QStringList names() const
    {
        return QDir(m_folder.path()).entryList(QDir::AllEntries | QDir::System | QDir::NoDotAndDotDot);
    }

    QTemporaryDir m_folder;
};

QTEST_APPLESS_MAIN(TestWholeFile)
#include "tst_whole_file.moc"
