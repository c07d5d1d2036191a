// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include <QTemporaryDir>
#include <QTest>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "core/base/Rng.h"
#include "core/mesh/MeshReader.h"
#include "tests/fuzz/Exercises.h"
#include "tests/support/Checks.h"
#include "tests/support/Files.h"
#include "tests/support/Solids.h"
#include "tests/support/Suite.h"
#include "tests/support/Tables.h"

using core::ErrorCode;
using core::mesh::MeshFile;
using core::mesh::MeshFormat;
using core::mesh::readMesh;
using core::mesh::TriangleMesh;

namespace {

/// Returns the corner positions, triangle by triangle. They do not depend on how vertices are shared.
std::vector<glm::vec3> corners(const TriangleMesh& mesh)
{
    std::vector<glm::vec3> list;
    for (const auto& t : mesh.triangles)
        for (const std::uint32_t v : t)
            list.push_back(mesh.vertices[v]);
    return list;
}

std::string binaryStlHeader(std::uint32_t count)
{
    std::string bytes(80, '\0');
    for (int k = 0; k < 4; ++k)
        bytes.push_back(static_cast<char>(count >> (8 * k)));
    return bytes;
}

/// Returns one triangle as a binary STL record with the given first coordinate.
std::string stlRecord(float x)
{
    TriangleMesh mesh;
    mesh.vertices = {{x, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}};
    return support::asBinaryStl(mesh).substr(84);
}

/// Returns the mesh in each format whose bytes may follow a byte order mark. A binary STL begins with a header of fixed
/// length.
std::vector<std::pair<MeshFormat, std::string>> filesOf(const TriangleMesh& mesh)
{
    return {{MeshFormat::Obj, support::asObj(mesh)},
            {MeshFormat::Stl, support::asAsciiStl(mesh)},
            {MeshFormat::Ply, support::asAsciiPly(mesh)},
            {MeshFormat::Ply, support::asBinaryPly(mesh, false)},
            {MeshFormat::Ply, support::asBinaryPly(mesh, true)}};
}

using Outline = std::vector<glm::dvec2>;

glm::dvec2 polar(double radius, double turns)
{
    return radius * glm::dvec2(std::cos(2.0 * std::numbers::pi * turns), std::sin(2.0 * std::numbers::pi * turns));
}

/// Returns one polygon as an OBJ file whose single face is in the x-y, y-z or z-x plane.
std::string asObj(const Outline& outline, int axis = 2)
{
    std::string text;
    std::string face = "f";
    for (std::size_t k = 0; k < outline.size(); ++k) {
        double p[3] = {};
        p[(axis + 1) % 3] = outline[k].x;
        p[(axis + 2) % 3] = outline[k].y;
        text += QStringLiteral("v %1 %2 %3\n").arg(p[0]).arg(p[1]).arg(p[2]).toStdString();
        face.append(" ").append(std::to_string(k + 1));
    }
    return text + face + "\n";
}

bool isInside(const Outline& outline, const glm::dvec2& p)
{
    bool odd = false;
    for (std::size_t a = 0, b = outline.size() - 1; a < outline.size(); b = a++)
        if ((outline[a].y > p.y) != (outline[b].y > p.y) &&
            p.x < (outline[b].x - outline[a].x) * (p.y - outline[a].y) / (outline[b].y - outline[a].y) + outline[a].x)
            odd = !odd;
    return odd;
}

/// Returns a ring with a gap: two arms that wind around each other the given number of times.
Outline spiral(int turns)
{
    Outline outline;
    const int corners = 40 * turns;
    for (int k = 0; k <= corners; ++k)
        outline.push_back(polar(1.0 + k / 40.0, k / 40.0));
    for (int k = corners; k >= 0; --k)
        outline.push_back(polar(1.5 + k / 40.0, k / 40.0));
    return outline;
}

}  // namespace

class TestMeshReader : public QObject
{
    Q_OBJECT

private slots:
    void everyFormatGivesTheSameTriangles()
    {
        const TriangleMesh mesh = support::sphereCap(3.3F, 2.1F, 17, 5);
        auto files = filesOf(mesh);
        for (std::size_t k = files.size(); k-- > 0;)
            files.emplace_back(files[k].first, "\xEF\xBB\xBF" + files[k].second);
        files.emplace_back(MeshFormat::Stl, support::asBinaryStl(mesh));
        for (const auto& [format, bytes] : files) {
            const auto file = readMesh(bytes, format, "cap");
            QVERIFY(support::succeeds(file));
            QVERIFY(corners(file->mesh) == corners(mesh));
            QVERIFY(file->warnings.empty());
            QCOMPARE(file->format, format);
        }
    }

    void objSpellings_data()
    {
        support::columns<QByteArray, int>("text", "triangles");
        const QByteArray square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
        QTest::newRow("triangle") << square + "f 1 2 3\n" << 1;
        QTest::newRow("quad") << square + "f 1 2 3 4\n" << 2;
        QTest::newRow("polygon") << square + "v -1 0.5 0\nf 1 2 3 4 5\n" << 3;
        QTest::newRow("v/vt") << square + "vt 0 0\nf 1/1 2/1 3/1\n" << 1;
        QTest::newRow("v//vn") << square + "vn 0 0 1\nf 1//1 2//1 3//1\n" << 1;
        QTest::newRow("v/vt/vn") << square + "vt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1 4/1/1\n" << 2;
        QTest::newRow("vt that is not there") << square + "f 1/9 2/9 3/9\n" << 1;
        QTest::newRow("negative") << square + "f -4 -3 -2 -1\n" << 2;
        QTest::newRow("negative with vt") << square + "vt 0 0\nf -4/-1 -3/-1 -2/-1\n" << 1;
        QTest::newRow("face before its vertices") << "f 1 2 3\n" + square << 1;
        QTest::newRow("comments, groups, materials") << "# made\nmtllib gone.mtl\no a\ng b c\nusemtl red\ns off\n" +
                                                            square + "#MRGB ffffffff\nf 1 2 3 # the face\n"
                                                     << 1;
        QTest::newRow("continued lines") << square + "f 1 2 \\\n3 \\\n4\n" << 2;
        QTest::newRow("continued at the end of the file") << square + "f 1 2 3\\" << 1;
        QTest::newRow("a comment that ends in a backslash") << square + "# C:\\scans\\\nf 1 2 3\nf 1 3 4\n" << 2;
        QTest::newRow("a group that ends in a backslash") << square + "g upper\\\nf 1 2 3\nf 1 3 4\n" << 2;
        QTest::newRow("a comment behind a face that ends in a backslash") << square + "f 1 2 3 # a\\\nf 1 3 4\n" << 2;
        QTest::newRow("CR LF") << QByteArray(square + "f 1 2 3\n").replace("\n", "\r\n") << 1;
        QTest::newRow("CR alone") << QByteArray(square + "f 1 2 3\n").replace("\n", "\r") << 1;
        QTest::newRow("CR and one LF") << QByteArray(square + "f 1 2 3\nf 1 3 4\n").replace("\n", "\r") + "\n" << 2;
        QTest::newRow("tabs and blanks") << QByteArray("\tv  0\t0 0\n v 1 0 0\nv 1 1 0  \nf\t1  2\t3\n") << 1;
        QTest::newRow("w and colours") << QByteArray("v 0 0 0 1\nv 1 0 0 0.5 0.5 0.5\nv 1 1 0 1 0 0 1\nf 1 2 3\n") << 1;
        QTest::newRow("exponents, signs") << QByteArray("v +0 0 1e-400\nv 1.0E0 -0.0 0\nv 1. .5 0\nf 1 2 3\n") << 1;
        QTest::newRow("no last line end") << square + "f 1 2 3" << 1;
        QTest::newRow("lines, points, curves") << square + "p 1\nl 1 2\ncurv 0 1 1 2\nf 1 2 3\n" << 1;
    }

    void objSpellings()
    {
        QFETCH(QByteArray, text);
        QFETCH(int, triangles);
        const auto file = readMesh(text.toStdString(), MeshFormat::Obj, "test.obj");
        QVERIFY(support::succeeds(file));
        QCOMPARE(file->mesh.triangles.size(), static_cast<std::size_t>(triangles));
        const auto list = corners(file->mesh);
        QVERIFY(list[0] == glm::vec3(0, 0, 0));
        QVERIFY(list[1] == glm::vec3(1, 0, 0));
    }

    void plyWithOtherElementsAndPolygons()
    {
        const std::string text =
            "ply\r\nformat ascii 1.0\r\nobj_info none\r\nelement camera 1\r\nproperty float fov\r\n"
            "property list uchar float k\r\nelement nothing 4000000000\r\nelement vertex 5\r\n"
            "property uchar red\r\nproperty double z\r\nproperty double y\r\nproperty double x\r\n"
            "element face 2\r\nproperty list uint8 uint32 vertex_index\r\nproperty uchar flags\r\n"
            "end_header\r\n90 2 0.1 0.2\r\n"
            "1 0 0 0\r\n1 0 0 1\r\n1 0 1 1\r\n1 0 1 0\r\n1 0 0.5 -1\r\n"
            "5 0 1 2 3 4 7\r\n3 0 1 2 7\r\n";
        const auto file = readMesh(text, MeshFormat::Ply, "test.ply");
        QVERIFY(support::succeeds(file));
        QCOMPARE(file->mesh.triangles.size(), std::size_t(4));
        QVERIFY(file->mesh.vertices[1] == glm::vec3(1, 0, 0));
    }

    /// The header's first line shows how lines end: the byte after the last CR may look like an LF.
    void plyWithReturnsAlone()
    {
        const TriangleMesh mesh = support::sphereCap(3.3F, 2.1F, 17, 5);
        std::string text = support::asAsciiPly(mesh);
        std::replace(text.begin(), text.end(), '\n', '\r');
        std::string binary = support::asBinaryPly(mesh, false);
        const std::size_t headerEnd = binary.find("end_header\n") + 11;
        std::replace(binary.begin(), binary.begin() + static_cast<std::ptrdiff_t>(headerEnd), '\n', '\r');
        binary[headerEnd] = '\n';  // the lowest byte of the first coordinate
        for (const std::string& bytes : {text, binary}) {
            const auto file = readMesh(bytes, MeshFormat::Ply, "cr.ply");
            QVERIFY(support::succeeds(file));
            QCOMPARE(file->mesh.triangles.size(), mesh.triangles.size());
        }
    }

    /// Every second triangle of a strip is turned round, -1 begins another strip, and thin triangles only turn.
    void plyWithStrips()
    {
        const std::string text = "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n"
                                 "property float z\nproperty float quality\nelement tristrips 1\n"
                                 "property list int int vertex_indices\nend_header\n"
                                 "0 0 0 1.#QNAN\n1 0 0 nan\n0 1 0 0\n1 1 0 0\n2 0 0 -1.#IND\n"
                                 "11 0 1 2 3 -1 1 4 4 3 -1 0 1\n";
        const auto file = readMesh(text, MeshFormat::Ply, "strips.ply");
        QVERIFY(support::succeeds(file));
        const std::vector<std::array<std::uint32_t, 3>> expected{{0, 1, 2}, {2, 1, 3}};
        QVERIFY(file->mesh.triangles == expected);
    }

    void stlSpellings_data()
    {
        support::columns<QByteArray>("text");
        const QByteArray usual = QByteArray::fromStdString(support::asAsciiStl(support::box(1, 1, 1)));
        QTest::newRow("usual") << usual;
        QTest::newRow("end solid, end facet")
            << QByteArray(usual).replace("endsolid", "end solid").replace("endfacet", "end facet");
        QTest::newRow("a blank line and a comment first") << "\n# made by hand\n" + usual;
        QTest::newRow("CR alone") << QByteArray(usual).replace("\n", "\r");
        QTest::newRow("CR and one LF") << QByteArray(usual).replace("\n", "\r") + "\n";
        QTest::newRow("a facet on one line") << QByteArray(usual).replace("\n", " ").replace("endfacet", "endfacet\n");
        QTest::newRow("all on one line") << QByteArray(usual).replace("\n", " ");
        QTest::newRow("two solids") << usual.chopped(0) + "solid empty\nendsolid empty\n";
        QTest::newRow("upper case") << usual.toUpper();
        QTest::newRow("NUL in the name") << "solid a" + QByteArray(3, '\0') + '\n' + usual.mid(usual.indexOf('\n') + 1);
    }

    void stlSpellings()
    {
        QFETCH(QByteArray, text);
        const auto file = readMesh(text.toStdString(), MeshFormat::Stl, "test.stl");
        QVERIFY(support::succeeds(file));
        QVERIFY(corners(file->mesh) == corners(support::box(1, 1, 1)));
        QVERIFY(file->warnings.empty());
    }

    /// Coordinates far from the origin are moved before they are rounded: exact to 1 um up to 1e7 mm.
    void farFromTheOriginNothingIsRounded()
    {
        const TriangleMesh mesh = support::sphereCap(6.0F, 5.0F, 40, 12);
        for (const double away : {0.0, 300.0, 1.0e4, 1.0e6, 1.0e7}) {
            std::string obj;
            std::string ply = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(mesh.vertices.size()) +
                              "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
                              std::to_string(mesh.triangles.size()) +
                              "\nproperty list uchar int vertex_indices\nend_header\n";
            for (const glm::vec3& v : mesh.vertices) {
                const std::string line = QStringLiteral("%1 %2 %3\n")
                                             .arg(static_cast<double>(v.x) + away, 0, 'f', 9)
                                             .arg(static_cast<double>(v.y) - away, 0, 'f', 9)
                                             .arg(static_cast<double>(v.z) + away, 0, 'f', 9)
                                             .toStdString();
                obj += "v " + line;
                ply += line;
            }
            for (const auto& t : mesh.triangles) {
                obj += "f " + std::to_string(t[0] + 1) + ' ' + std::to_string(t[1] + 1) + ' ' +
                       std::to_string(t[2] + 1) + '\n';
                ply += "3 " + std::to_string(t[0]) + ' ' + std::to_string(t[1]) + ' ' + std::to_string(t[2]) + '\n';
            }
            for (const auto& [format, bytes] : {std::pair(MeshFormat::Obj, obj), {MeshFormat::Ply, ply}}) {
                const auto file = readMesh(bytes, format, "far");
                QVERIFY(support::succeeds(file));
                for (std::size_t k = 0; k < mesh.vertices.size(); ++k) {
                    const glm::dvec3 read = file->originInFile + glm::dvec3(file->mesh.vertices[k]);
                    const glm::dvec3 meant = glm::dvec3(mesh.vertices[k]) + glm::dvec3(away, -away, away);
                    QVERIFY(glm::distance(read, meant) < (away > 1000.0 ? 1e-6 : 1e-4));
                }
            }
        }
    }

    void polygonsAreCoveredOnce_data()
    {
        QTest::addColumn<Outline>("outline");
        QTest::newRow("dart") << Outline{{0, 0}, {4, 1}, {0, 2}, {1, 1}};
        QTest::newRow("L") << Outline{{3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}, {0, 0}};
        QTest::newRow("corners on straight lines")
            << Outline{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 2}, {2, 2}, {1, 2}, {0, 2}};
        QTest::newRow("notch with corners on straight lines")
            << Outline{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
        QTest::newRow("a bridge to a hole")
            << Outline{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}};
        Outline comb;
        for (int k = 0; k < 40; ++k)
            comb.insert(comb.end(), {{k + 0.0, 5.0}, {k + 0.2, 1.0}, {k + 0.5, 1.0}, {k + 0.6, 5.0}});
        comb.insert(comb.end(), {{39.6, 0.0}, {0.0, 0.0}});
        QTest::newRow("comb") << comb;
        QTest::newRow("spiral") << spiral(5);
        Outline round;
        for (int k = 0; k < 300; ++k)
            round.push_back(polar(1.0, k / 300.0) * glm::dvec2(5.0, 4.0));
        QTest::newRow("round") << round;
    }

    /// Triangulates concave polygons, which a simple fan would cover twice or leave. Compares with the even-odd rule at
    /// random points.
    void polygonsAreCoveredOnce()
    {
        QFETCH(Outline, outline);
        for (const bool backwards : {false, true}) {
            if (backwards)
                std::reverse(outline.begin(), outline.end());
            for (int axis = 0; axis < 3; ++axis) {
                const auto file = readMesh(asObj(outline, axis), MeshFormat::Obj, "polygon.obj");
                QVERIFY(support::succeeds(file));
                QVERIFY2(file->warnings.empty(), file->warnings.empty() ? "" : file->warnings[0].c_str());
                QCOMPARE(file->mesh.triangles.size(), outline.size() - 2);
                glm::dvec2 low = outline[0];
                glm::dvec2 high = outline[0];
                for (const glm::dvec2& p : outline) {
                    low = glm::min(low, p);
                    high = glm::max(high, p);
                }
                core::Rng rng(1);
                for (int sample = 0; sample < 1000; ++sample) {
                    const glm::dvec2 p(rng.uniform(low.x, high.x), rng.uniform(low.y, high.y));
                    int covers = 0;
                    for (const auto& t : file->mesh.triangles) {
                        Outline corners;
                        for (const std::uint32_t v : t)
                            corners.emplace_back(file->mesh.vertices[v][(axis + 1) % 3],
                                                 file->mesh.vertices[v][(axis + 2) % 3]);
                        covers += isInside(corners, p) ? 1 : 0;
                    }
                    QCOMPARE(covers, isInside(outline, p) ? 1 : 0);
                }
            }
        }
    }

    void polygonsOfManyCorners()
    {
        // A wavy outline: half of its corners are notches in one file, and none in the other.
        const auto wavy = [](int count, double wave) {
            Outline outline;
            for (int k = 0; k < count; ++k)
                outline.push_back(polar(100.0 * (k % 2 == 0 ? 1.0 : 1.0 - wave), 1.0 * k / count));
            return outline;
        };
        for (const auto& [count, wave] : {std::pair(2000, 0.0), {2000, 0.01}, {20'000, 0.001}}) {
            const auto file = readMesh(asObj(wavy(count, wave)), MeshFormat::Obj, "base.obj");
            QVERIFY(support::succeeds(file));
            QCOMPARE(file->mesh.triangles.size(), static_cast<std::size_t>(count - 2));
            double boxes = 0.0;  // total area of bounding boxes; in a fan, half the outline for every corner
            for (const auto& t : file->mesh.triangles) {
                const glm::vec2 a(file->mesh.vertices[t[0]]);
                const glm::vec2 b(file->mesh.vertices[t[1]]);
                const glm::vec2 c(file->mesh.vertices[t[2]]);
                const glm::vec2 size = glm::max(a, glm::max(b, c)) - glm::min(a, glm::min(b, c));
                boxes += static_cast<double>(size.x) * static_cast<double>(size.y);
            }
            QVERIFY2(boxes < 50.0 * 200.0 * 200.0, qPrintable(QString::number(boxes)));
        }
        const auto refused = readMesh(asObj(wavy(200'000, 0.0002)), MeshFormat::Obj, "base.obj");
        QVERIFY(support::isRefused(refused, "200000 corners"));
        QVERIFY(support::isRefused(refused, "triangles only"));
    }

    void polygonsThatCrossThemselvesWarn()
    {
        Outline star;
        for (int k = 0; k < 5; ++k)
            star.push_back(polar(1.0, 0.4 * k));
        const Outline bowTie{{0, 0}, {2, 2}, {2, 0}, {0, 2}};
        const Outline eight{{0, 0}, {6, 6}, {6, 0}, {0, 5}};
        const Outline line{{0, 0}, {1, 0}, {2, 0}, {3, 0}};
        for (const Outline& outline : {star, bowTie, eight, line}) {
            const auto file = readMesh(asObj(outline), MeshFormat::Obj, "polygon.obj");
            QVERIFY(file);
            QCOMPARE(file->mesh.triangles.size(), outline.size() - 2);
            QCOMPARE(file->warnings.size(), std::size_t(1));
            QVERIFY2(file->warnings[0].starts_with("1 face crosses itself"), file->warnings[0].c_str());
        }
    }

    void oddButUsableFilesWarn()
    {
        const std::string box = support::asBinaryStl(support::box(1, 1, 1));
        const auto thin = readMesh("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\nf 1 2 3\n", MeshFormat::Obj, "test.obj");
        QVERIFY(thin);
        QCOMPARE(thin->warnings.size(), std::size_t(1));
        // The size wins over the count where whole records fit it.
        for (const auto& [bytes, triangles, says] :
             {std::tuple("solid" + box.substr(5), 12U, ""),
              {box + "trailing\x01", 12U, "9 bytes after the last triangle passed over"},
              {binaryStlHeader(3) + box.substr(84, 200), 4U,
               "the header states 3 triangles, but 4 are there; all of them were read"},
              {binaryStlHeader(0) + box.substr(84), 12U,
               "the header states 0 triangles, but 12 are there; all of them were read"},
              {binaryStlHeader(0xFFFFFFFFU) + box.substr(84), 12U,
               "the header states 4294967295 triangles, but 12 are there; all of them were read"},
              {std::string(84, ' ') + box.substr(84), 12U,
               "the header states 538976288 triangles, but 12 are there; all of them were read"}}) {
            const auto file = readMesh(bytes, MeshFormat::Stl, "t.stl");
            QVERIFY(file);
            QCOMPARE(file->mesh.triangles.size(), std::size_t{triangles});
            QVERIFY(file->warnings == (*says == '\0' ? std::vector<std::string>{} : std::vector<std::string>{says}));
        }
    }

    void badBytes_data()
    {
        support::columns<MeshFormat, QByteArray, ErrorCode, QString>("format", "bytes", "code", "says");
        // The first letter of each name selects the format.
        const auto add = [](const char* name, const std::string& bytes, ErrorCode code, const char* says) {
            const MeshFormat format = *name == 'o' ? MeshFormat::Obj : *name == 's' ? MeshFormat::Stl : MeshFormat::Ply;
            QTest::newRow(name) << format << QByteArray::fromStdString(bytes) << code << QString::fromLatin1(says);
        };
        const std::string three = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
        add("obj: prose", "Dear Sir,\nthis is a letter.\n", ErrorCode::WrongKind, "does not look like");
        add("obj: points only", three, ErrorCode::NoTriangles, "no face");
        add("obj: two numbers", "v 1 2\n", ErrorCode::BadStructure, "line 1");
        add("obj: nan", "v 0 0 0\nv 1 nan 0\n", ErrorCode::BadNumber, "line 2");
        add("obj: inf", "v inf 0 0\n", ErrorCode::BadNumber, "\"inf\"");
        add("obj: beyond float", "v 1e39 0 0\n", ErrorCode::BadNumber, "1e39");
        add("obj: beyond double", "v 1e999 0 0\n", ErrorCode::BadNumber, "1e999");
        add("obj: not a number", "v 0 0 zero\n", ErrorCode::BadNumber, "\"zero\"");
        add("obj: index 0", three + "f 0 1 2\n", ErrorCode::BadStructure, "line 4");
        add("obj: index too high", three + "f 1 2 3\nf 1 2 4\n", ErrorCode::BadStructure, "line 5");
        add("obj: index too low", three + "f -1 -2 -4\n", ErrorCode::BadStructure, "\"-4\"");
        add("obj: index of 20 digits", three + "f 1 2 99999999999999999999\n", ErrorCode::BadStructure,
            "names no vertex");
        add("obj: index is a word", three + "f 1 2 x\n", ErrorCode::BadStructure, "\"x\"");

        const std::string record = stlRecord(0.0F);
        const float infinite = std::numeric_limits<float>::infinity();
        add("stl: prose", "Dear Sir,\nthis is a letter.\n", ErrorCode::WrongKind, "not an STL");
        add("stl: binary, no header", std::string(40, '\0'), ErrorCode::FileTruncated, "40 bytes");
        add("stl: binary, cut short", binaryStlHeader(3) + record + record.substr(0, 20), ErrorCode::FileTruncated,
            "states 3 triangles, of which only 1");
        add("stl: count of 4 billion", binaryStlHeader(0xFFFFFFFFU) + record.substr(1), ErrorCode::FileTruncated,
            "states 4294967295 triangles");
        add("stl: binary, cut at a record", binaryStlHeader(3) + record, ErrorCode::FileTruncated, "only 1 can be");
        add("stl: no triangles", binaryStlHeader(0), ErrorCode::NoTriangles, "0 triangles");
        add("stl: NaN", binaryStlHeader(2) + record + stlRecord(std::nanf("")), ErrorCode::BadNumber, "triangle 2");
        add("stl: infinity", binaryStlHeader(1) + stlRecord(infinite), ErrorCode::BadNumber, "triangle 1");
        add("stl: solid and binary, cut short", "solid" + binaryStlHeader(9).substr(5) + record,
            ErrorCode::FileTruncated, "states 9");
        add("stl: ascii, cut in a facet", support::asAsciiStl(support::box(1, 1, 1)).substr(0, 300),
            ErrorCode::FileTruncated, "cut short");
        add("stl: ascii, two corners",
            "solid\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\nendfacet\nendsolid\n",
            ErrorCode::BadStructure, "line 7");
        add("stl: ascii, four corners",
            "solid\nfacet\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\nendfacet\nendsolid\n",
            ErrorCode::BadStructure, "line 6");
        add("stl: ascii, nan", "solid\nfacet\nvertex 0 nan 0\n", ErrorCode::BadNumber, "line 3");
        add("stl: only the word", "solid as a rock\n", ErrorCode::WrongKind, "no whole facet");
        const std::string solid = support::asAsciiStl(support::box(1, 1, 1));
        add("stl: ascii, the second solid cut short", solid + solid.substr(0, solid.size() / 2),
            ErrorCode::FileTruncated, "without \"endsolid\"");
        // The names of solids: a comment, with a NUL behind it, or all on one line.
        for (const auto& [old, changed] :
             {std::pair("solid ", "solid #1 "), {"solid box\n", "solid box\0\0\n"}, {"\n", " "}}) {
            QByteArray named = QByteArray::fromStdString(solid);
            named.replace(old, QByteArray(changed, changed == std::string("solid box") ? 12 : -1));
            const std::string both = (named + named).toStdString();
            add("stl: ascii, named, the second solid cut short", both.substr(0, both.size() * 3 / 4),
                ErrorCode::FileTruncated, "cut short");
        }
        add("stl: decimal commas", "solid a\nfacet normal 0 0 1\nvertex 0,5 0 0\n", ErrorCode::BadNumber,
            "decimal comma");
        add("stl: UTF-16", "\xFF\xFEs", ErrorCode::WrongKind, "UTF-16");
        add("stl: gzip", "\x1F\x8B\x08", ErrorCode::WrongKind, "gzip");
        for (const char* archive : {"BZh9", "\xFD\x37zXZ", "\x28\xB5\x2F\xFD", "7z\xBC\xAF\x27\x1C", "Rar!\x1A\x07"})
            add("stl: an archive", std::string(archive) + '\0', ErrorCode::WrongKind, "archive");
        for (const char* other : {"%PDF-1.4", "\x89PNG\r\n", "\xFF\xD8\xFF\xE0", "glTF"})
            add("stl: something else", other, ErrorCode::WrongKind, "no mesh");
        for (const MeshFormat format : {MeshFormat::Obj, MeshFormat::Stl, MeshFormat::Ply}) {
            const char* name = format == MeshFormat::Obj   ? "obj: UTF-16"
                               : format == MeshFormat::Stl ? "stl: UTF-16"
                                                           : "ply: UTF-16";
            add(name, std::string("\0s\0o", 4), ErrorCode::WrongKind, "UTF-16");
            add(name, std::string("v\0 \0", 4), ErrorCode::WrongKind, "UTF-16");
        }
        add("stl: ZIP", "PK\x03\x04", ErrorCode::WrongKind, "ZIP");
        add("stl: a PLY", "ply\nformat ascii 1.0\n", ErrorCode::WrongKind, "ends in .ply");
        add("stl: an OBJ", "# made by hand\nv 0 0 0\nv 1 0 0\n", ErrorCode::WrongKind, "ends in .obj");
        add("ply: an OBJ", "v 0 0 0\n", ErrorCode::WrongKind, "ends in .obj");
        add("obj: an STL", solid, ErrorCode::WrongKind, "ends in .stl");
        add("obj: decimal commas", "v 0,5 0 0\n", ErrorCode::BadNumber, "decimal comma");

        add("obj: edges only", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\nf 2 3\n", ErrorCode::NoTriangles,
            "fewer than three corners");

        const std::string ply =
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
            "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
        const std::string points = "0 0 0\n1 0 0\n0 1 0\n";
        add("ply: prose", "Dear Sir,\nthis is a letter.\n", ErrorCode::WrongKind, "does not begin");
        add("ply: no end of header", "ply\nformat ascii 1.0\n", ErrorCode::WrongKind, "no end");
        add("ply: unknown encoding", "ply\nformat morse 1.0\nend_header\n", ErrorCode::WrongKind, "encoding");
        add("ply: unknown type", "ply\nformat ascii 1.0\nelement vertex 1\nproperty apple x\nend_header\n",
            ErrorCode::WrongKind, "line 4");
        add("ply: negative count", "ply\nformat ascii 1.0\nelement vertex -1\nend_header\n", ErrorCode::WrongKind,
            "line 3");
        add("ply: points only",
            "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float "
            "z\nend_header\n1 2 3\n",
            ErrorCode::NoTriangles, "1 point and");
        add("ply: edges only", ply + points + "2 0 1\n", ErrorCode::NoTriangles, "fewer than three corners");
        add("ply: no z",
            "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nend_header\n1 2\n",
            ErrorCode::BadStructure, "no x, y and z");
        add("ply: cut in the vertices", ply + "0 0 0\n1 0", ErrorCode::FileTruncated, "vertex");
        add("ply: cut in the faces", ply + points + "3 0 1", ErrorCode::FileTruncated, "face 1");
        add("ply: nan", ply + "0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n", ErrorCode::BadNumber, "vertex 2");
        add("ply: index too high", ply + points + "3 0 1 3\n", ErrorCode::BadStructure, "vertex 3");
        add("ply: negative index", ply + points + "3 0 1 -1\n", ErrorCode::BadStructure, "cannot be");
        add("ply: list of 4 billion", ply + points + "4000000000 0 1 2\n", ErrorCode::FileTruncated, "face 1");
        add("ply: decimal commas", ply + "0 0 0\n1,5 0 0\n0 1 0\n3 0 1 2\n", ErrorCode::BadNumber, "decimal comma");
        add("ply: a length that is a word", ply + points + "three 0 1 2\n", ErrorCode::BadStructure, "no number");
        add("ply: a list of another name",
            "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
            "element polygon 1\nproperty list uchar int corners\nend_header\n1 2 3\n3 0 0 0\n",
            ErrorCode::NoTriangles, "\"corners\" in \"polygon\"");
        add("ply: vertices of 4 billion",
            "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty float x\nend_header\nxxxx",
            ErrorCode::FileTruncated, "states 4000000000 of \"vertex\", more than the 4 bytes left");
        add("ply: faces cut in binary", support::asBinaryPly(support::box(1, 1, 1), true).substr(0, 320),
            ErrorCode::FileTruncated, "cut short");
    }

    void badBytes()
    {
        QFETCH(MeshFormat, format);
        QFETCH(QByteArray, bytes);
        QFETCH(ErrorCode, code);
        QFETCH(QString, says);
        const auto file = readMesh(bytes.toStdString(), format, "the file");
        QVERIFY(support::isRefused(file, code));
        QVERIFY(support::isRefused(file, says.toStdString()));
        QVERIFY2(file.error().detail.starts_with("the file"), file.error().detail.c_str());
    }

    void badFiles()
    {
        const QTemporaryDir folder;
        const auto path = [&](const char* name) {
            return std::filesystem::path(folder.filePath(QString::fromLatin1(name)).toStdString());
        };
        support::write(path("empty.obj"), {});
        support::write(path("mesh.xyz"), "0 0 0\n");
        support::write(path("huge.stl"), "solid");
        std::filesystem::resize_file(path("huge.stl"), core::mesh::kMaxFileBytes + 1);
        for (const auto& [file, code] : {std::pair(path("absent.stl"), ErrorCode::FileMissing),
                                         {path(""), ErrorCode::FileUnreadable},
                                         {"/dev/null", ErrorCode::FileUnreadable},
                                         {path("empty.obj"), ErrorCode::FileEmpty},
                                         {path("mesh.xyz"), ErrorCode::WrongKind},
                                         {path("huge.stl"), ErrorCode::FileTooLarge}})
            QVERIFY(support::isRefused(readMesh(file), code));
        // The extension decides the format, in upper or lower case.
        const TriangleMesh mesh = support::box(1, 2, 3);
        for (const auto& [name, bytes, isRead] : {std::tuple("a.OBJ", support::asObj(mesh), true),
                                                  {"a.Stl", support::asBinaryStl(mesh), true},
                                                  {"a.ply", support::asBinaryPly(mesh, false), true},
                                                  {"b.ply", support::asObj(mesh), false}}) {
            support::write(path(name), bytes);
            QVERIFY2(readMesh(path(name)).has_value() == isRead, name);
        }
    }

    void corpusOfTheFuzzerIsHarmless()
    {
        int seeds = 0;
        QVERIFY(support::forEachSeed("mesh", [&](const std::string& bytes) {
            fuzz::exerciseMesh(bytes);
            ++seeds;
        }));
        QVERIFY(seeds > 20);
    }
};

CUSP_TEST(TestMeshReader)
#include "tst_mesh_reader.moc"
