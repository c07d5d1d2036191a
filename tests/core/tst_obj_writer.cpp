// SPDX-License-Identifier: GPL-3.0-or-later
#include <clocale>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <QTemporaryDir>
#include <QTest>

#include "core/mesh/ObjWriter.h"

namespace {

using core::mesh::TriangleMesh;

TriangleMesh tetrahedron()
{
    return {{{0.0F, 0.0F, 0.0F}, {1.5F, 0.0F, 0.0F}, {0.0F, 2.25F, 0.0F}, {0.0F, 0.0F, -0.000001F}},
            {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
}

std::string contents(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

}  // namespace

class TestObjWriter : public QObject
{
    Q_OBJECT
private slots:
    void writesVerticesFacesAndCommentLines()
    {
        const QTemporaryDir dir;
        const auto path = std::filesystem::path(dir.path().toStdString()) / "t.obj";
        QVERIFY(core::mesh::writeObj(path, tetrahedron(), "tooth 36\nmade by Cusp").has_value());
        QCOMPARE(contents(path), std::string("# tooth 36\n# made by Cusp\n"
                                             "v 0.000000 0.000000 0.000000\nv 1.500000 0.000000 0.000000\n"
                                             "v 0.000000 2.250000 0.000000\nv 0.000000 0.000000 -0.000001\n"
                                             "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n"));
    }

    void aCommaLocaleChangesNothing()
    {
        const char* comma = nullptr;
        for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "de_DE.utf8"})
            comma = comma != nullptr ? comma : std::setlocale(LC_ALL, name);
        if (comma == nullptr)
            QSKIP("No locale with a decimal comma is installed.");
        const QTemporaryDir dir;
        const auto path = std::filesystem::path(dir.path().toStdString()) / "t.obj";
        const bool written = core::mesh::writeObj(path, tetrahedron(), "").has_value();
        std::setlocale(LC_ALL, "C");
        QVERIFY(written);
        QVERIFY(contents(path).find(',') == std::string::npos);
        QVERIFY(contents(path).starts_with("v 0.000000 "));
    }

    void replacesAnOlderFileAndLeavesNothingBeside()
    {
        const QTemporaryDir dir;
        const std::filesystem::path folder(dir.path().toStdString());
        std::ofstream(folder / "t.obj") << "old";
        QVERIFY(core::mesh::writeObj(folder / "t.obj", tetrahedron(), "").has_value());
        QVERIFY(contents(folder / "t.obj").starts_with("v "));
        QCOMPARE(std::distance(std::filesystem::directory_iterator(folder), {}), std::ptrdiff_t(1));
    }

    void refusesAFolderThatIsNotThere()
    {
        const auto status = core::mesh::writeObj("/no/such/folder/t.obj", tetrahedron(), "");
        QVERIFY(!status.has_value());
        QCOMPARE(status.error().code, core::ErrorCode::FileUnwritable);
        QVERIFY(status.error().detail.find("/no/such/folder/t.obj") != std::string::npos);
    }

    void refusesAFolderInPlaceOfTheFile()
    {
        const QTemporaryDir dir;
        const std::filesystem::path folder(dir.path().toStdString());
        std::filesystem::create_directories(folder / "t.obj" / "full");
        QVERIFY(!core::mesh::writeObj(folder / "t.obj", tetrahedron(), "").has_value());
        QCOMPARE(std::distance(std::filesystem::directory_iterator(folder), {}), std::ptrdiff_t(1));
    }
};

QTEST_GUILESS_MAIN(TestObjWriter)
#include "tst_obj_writer.moc"
