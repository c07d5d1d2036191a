// SPDX-License-Identifier: GPL-3.0-or-later
// A version of a lesson as the school stores it: complete, named by its hash, and recognised if it was changed.
#include <QDir>
#include <QFile>
#include <QStandardPaths>
#include <QTest>

#include "lessons/Assignment.h"
#include "lessons/LessonCatalog.h"
#include "lessons/LessonPack.h"
#include "lessons/LessonVersion.h"
#include "tests/lessons/LessonFolder.h"
#include "tests/support/Checks.h"
#include "tests/support/Solids.h"
#include "tests/support/Suite.h"

using namespace lessons;
using core::ErrorCode;

class TestLessonVersion : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QStandardPaths::setTestModeEnabled(true); }
    void init()
    {
        m_folder.emplace();
        QDir(QStandardPaths::writableLocation(QStandardPaths::CacheLocation)).removeRecursively();
    }

    /// A newer Cusp may ship other files: a version does not depend on them.
    void everyShippedLessonComesBackAsItWas()
    {
        for (const CatalogEntry& entry : readCatalog({})) {
            const Lesson& lesson = *entry.read.lesson;
            const auto pack = packVersion(lesson);
            QVERIFY2(pack, lesson.id.c_str());
            QVERIFY((versionIn(*pack).value() == LessonVersion{lesson.id, lesson.version, lesson.hash}));
            QVERIFY(support::succeeds(cacheVersion(lesson.hash, *pack)));
            const auto back = cachedVersion(lesson.hash);
            QVERIFY2(back, lesson.id.c_str());
            QCOMPARE(back->json, lesson.json);
            QVERIFY2(back->rubric == lesson.rubric, lesson.id.c_str());
        }
    }

    void aScanGoesAlong()
    {
        const Lesson lesson = scanned();
        const QByteArray pack = packVersion(lesson).value();
        QVERIFY(support::succeeds(cacheVersion(lesson.hash, pack)));
        QVERIFY(QFile::remove(m_folder->at("scans/tooth.stl")));
        const auto back = cachedVersion(lesson.hash);
        QVERIFY(support::succeeds(back));
        QVERIFY(support::succeeds(assign(*back)));
        QVERIFY(back->hash == lesson.hash);
    }

    void aChangedScanIsNotPacked()
    {
        const Lesson lesson = scanned();
        QVERIFY(QFile(m_folder->at("scans/tooth.stl")).resize(200));
        QCOMPARE(packVersion(lesson).error().code, ErrorCode::BadStructure);
    }

    void aChangedPackIsRecognised()
    {
        const Lesson lesson = scanned();
        const QByteArray pack = packVersion(lesson).value();
        auto files = unpackLessons(pack).value();
        QCOMPARE(files.size(), std::size_t{2});
        // Another lesson under the same hash.
        auto easier = files;
        easier.front().content.replace("\"minutes\":5", "\"minutes\":90");
        QCOMPARE(cacheVersion(lesson.hash, packFiles(easier).value()).error().code, ErrorCode::OutOfRange);
        // Another scan in the same lesson.
        auto another = files;
        another.back().content += "x";
        QCOMPARE(versionIn(packFiles(another).value()).error().code, ErrorCode::BadStructure);
        QCOMPARE(versionIn(packFiles({files.front()}).value()).error().code, ErrorCode::BadStructure);
        QCOMPARE(versionIn(packFiles({files.back()}).value()).error().code, ErrorCode::BadStructure);
        QVERIFY(!versionIn("no pack"));
        QVERIFY(!versionIn({}));
    }

    /// The cache is in the student's account. What they change there is not used.
    void aChangedCacheIsNotUsed()
    {
        const Lesson lesson = scanned();
        QCOMPARE(cachedVersion(lesson.hash).error().code, ErrorCode::FileMissing);
        QVERIFY(cacheVersion(lesson.hash, packVersion(lesson).value()));
        QVERIFY(cachedVersion(lesson.hash));
        const Lesson other = *readLesson(":/lessons/block-1-line.lesson.json").lesson;
        QVERIFY(cacheVersion(other.hash, packVersion(other).value()));
        const QDir versions(QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + "/versions");
        const auto fileOf = [&](const Lesson& one) {
            return versions.filePath(QString::fromStdString(one.hash) + ".cusplessons");
        };
        QVERIFY(QFile::remove(fileOf(lesson)) && QFile::copy(fileOf(other), fileOf(lesson)));
        QCOMPARE(cachedVersion(lesson.hash).error().code, ErrorCode::BadStructure);
    }

    void theCatalogOffersTheAssignedVersion()
    {
        const Lesson assigned = own(5);
        QVERIFY(cacheVersion(assigned.hash, packVersion(assigned).value()));
        const Lesson tampered = own(90);
        QVERIFY(tampered.hash != assigned.hash);
        auto entries = readCatalog(m_folder->path());
        QVERIFY(useVersions(entries, {{assigned.id, assigned.hash}}).empty());
        QVERIFY(*lessonIn(entries, assigned.id) == assigned);
        // Without the version of the school, the file is not offered in its place.
        entries = readCatalog(m_folder->path());
        const std::string unknown(64, 'f');
        QVERIFY((useVersions(entries, {{assigned.id, unknown}}) == std::vector{unknown}));
        QVERIFY(lessonIn(entries, assigned.id) == nullptr);
        // A lesson that is on no computer but in the database is offered, too.
        entries = readCatalog({});
        QVERIFY(useVersions(entries, {{assigned.id, assigned.hash}}).empty());
        QVERIFY(*lessonIn(entries, assigned.id) == assigned);
        // Lessons that were assigned before versions were stored are offered as they are.
        entries = readCatalog(m_folder->path());
        QVERIFY(useVersions(entries, {{assigned.id, ""}}).empty());
        QVERIFY(*lessonIn(entries, assigned.id) == tampered);
    }

private:
    static const Lesson* lessonIn(const std::vector<CatalogEntry>& entries, const std::string& id)
    {
        for (const CatalogEntry& entry : entries)
            if (entry.read.lesson && entry.read.lesson->id == id)
                return &*entry.read.lesson;
        return nullptr;
    }
    [[nodiscard]] Lesson own(int minutes) const
    {
        return *m_folder
                    ->read("own.lesson.json", QJsonObject{{"format", 1},
                                                          {"based_on", "block-1-line.lesson.json"},
                                                          {"id", "own-line"},
                                                          {"minutes", minutes}})
                    .lesson;
    }
    /// Returns a lesson on a scan, which is in a folder below the lesson's.
    [[nodiscard]] Lesson scanned() const
    {
        QDir(m_folder->path()).mkpath("scans");
        m_folder->write("scans/tooth.stl",
                        QByteArray::fromStdString(support::asBinaryStl(support::sphereCap(5.0F, 5.0F, 90, 30))));
        const ReadLesson read = m_folder->read(
            "own.lesson.json",
            QJsonObject{
                {"format", 1},
                {"based_on", "0-orientation-2-hold.lesson.json"},
                {"id", "own-scan"},
                {"minutes", 5},
                {"tooth",
                 QJsonObject{{"fdi", QJsonValue()}, {"scan", "scans/tooth.stl"}, {"unit", "mm"}, {"up", "+z"}}}});
        if (!read.lesson)
            qWarning("%s", qPrintable(support::sentencesOf(read)));
        return *read.lesson;
    }

    std::optional<support::LessonFolder> m_folder;
};

CUSP_TEST(TestLessonVersion)
#include "tst_lesson_version.moc"
