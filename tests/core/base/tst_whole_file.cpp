// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>

#include <sys/stat.h>
#include <unistd.h>

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include "core/base/WholeFile.h"
#include "tests/support/Checks.h"
#include "tests/support/Files.h"
#include "tests/support/FullDisk.h"
#include "tests/support/Suite.h"

using core::isSameFile;
using core::writeWhole;

class TestWholeFile : public QObject
{
    Q_OBJECT

private slots:
    void replacesAnOlderFileAndLeavesNothingBeside()
    {
        support::write(at("a"), "old");
        QVERIFY(writeWhole(at("a"), "new", "It"));
        QCOMPARE(support::bytesOf(at("a")), std::string("new"));
        QCOMPARE(names(), QStringList{"a"});
    }

    void leavesFilesOfTheUserAlone()
    {
        support::write(at("a.part"), "mine");
        QVERIFY(QDir(m_folder.path()).mkdir("a.part1"));
        QVERIFY(writeWhole(at("a"), "newer", "It"));
        QCOMPARE(support::bytesOf(at("a")), std::string("newer"));
        QCOMPARE(support::bytesOf(at("a.part")), std::string("mine"));
        QCOMPARE(names(), (QStringList{"a", "a.part", "a.part1"}));
    }

    void aFullDiskLeavesTheOlderFile()
    {
        support::write(at("b"), "old");
        const QStringList before = names();
        {
            const support::FullDisk full(100);
            QVERIFY(
                support::isRefused(writeWhole(at("b"), std::string(200, 'x'), "It"), core::ErrorCode::FileUnwritable));
        }
        QCOMPARE(support::bytesOf(at("b")), std::string("old"));
        QCOMPARE(names(), before);
    }

    void aFolderThatMayNotBeWrittenToKeepsTheOlderFile()
    {
        if (geteuid() == 0)
            QSKIP("root may write into a read-only folder");
        using std::filesystem::perms;
        support::write(at("closed") / "file", "old");
        std::filesystem::permissions(at("closed"), perms::owner_read | perms::owner_exec);
        QVERIFY(!writeWhole(at("closed") / "file", "new", "It"));
        std::filesystem::permissions(at("closed"), perms::owner_all);
        QCOMPARE(support::bytesOf(at("closed") / "file"), std::string("old"));
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
        support::write(at("target"), "old");
        std::filesystem::create_symlink(at("target"), at("link"));
        QVERIFY(writeWhole(at("link"), "new", "It"));
        QCOMPARE(support::bytesOf(at("target")), std::string("new"));
        QVERIFY(std::filesystem::is_symlink(at("link")));
    }

    void knowsTheSameFileByOtherNames()
    {
        support::write(at("c"), "");
        std::filesystem::create_hard_link(at("c"), at("d"));
        QVERIFY(isSameFile(at("c"), at("d")));
        QVERIFY(isSameFile(at("c"), at("folder") / ".." / "c"));
        QVERIFY(!isSameFile(at("c"), at("b")));
        // Files that do not exist yet are compared by their paths.
        QVERIFY(isSameFile(at("new"), at("folder") / ".." / "new"));
        QVERIFY(!isSameFile(at("new"), at("newer")));
        QVERIFY(isSameFile("new", std::filesystem::current_path() / "new"));
    }

private:
    std::filesystem::path at(const char* name) const { return m_folder.filePath(name).toStdString(); }

    QStringList names() const
    {
        return QDir(m_folder.path()).entryList(QDir::AllEntries | QDir::System | QDir::NoDotAndDotDot);
    }

    QTemporaryDir m_folder;
};

CUSP_TEST(TestWholeFile)
#include "tst_whole_file.moc"
