// SPDX-License-Identifier: GPL-3.0-or-later
#include <clocale>
#include <filesystem>
#include <string>

#include <QTemporaryDir>
#include <QTest>

#include "core/mesh/ObjWriter.h"
#include "tests/support/Checks.h"
#include "tests/support/Files.h"
#include "tests/support/Suite.h"

namespace {

/// Writes a tetrahedron and returns the file's text. The tests of writeWhole() cover replacing files and failures.
std::string written(const std::string& comment)
{
    const QTemporaryDir folder;
    const std::filesystem::path path(folder.filePath("t.obj").toStdString());
    const core::mesh::TriangleMesh mesh{
        {{0.0F, 0.0F, 0.0F}, {1.5F, 0.0F, 0.0F}, {0.0F, 2.25F, 0.0F}, {0.0F, 0.0F, -0.000001F}},
        {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
    return core::mesh::writeObj(path, mesh, comment) ? support::bytesOf(path) : "(not written)";
}

const std::string kBody = "v 0.000000 0.000000 0.000000\nv 1.500000 0.000000 0.000000\n"
                          "v 0.000000 2.250000 0.000000\nv 0.000000 0.000000 -0.000001\n"
                          "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";

}  // namespace

class TestObjWriter : public QObject
{
    Q_OBJECT
private slots:
    void writesVerticesFacesAndCommentLines()
    {
        QCOMPARE(written("tooth 36\nmade by Cusp"), "# tooth 36\n# made by Cusp\n" + kBody);
    }

    void aCommaLocaleChangesNothing()
    {
        const char* comma = nullptr;
        for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "de_DE.utf8"})
            comma = comma != nullptr ? comma : std::setlocale(LC_ALL, name);
        if (comma == nullptr)
            QSKIP("No locale with a decimal comma is installed.");
        const std::string text = written({});
        std::setlocale(LC_ALL, "C");
        QCOMPARE(text, kBody);
    }

    void refusesAFolderThatIsNotThere()
    {
        const auto status = core::mesh::writeObj("/no/such/folder/t.obj", {}, {});
        QVERIFY(support::isRefused(status, core::ErrorCode::FileUnwritable));
        QVERIFY(support::isRefused(status, "/no/such/folder/t.obj"));
    }
};

CUSP_TEST(TestObjWriter)
#include "tst_obj_writer.moc"
