// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTest>

#include <glm/geometric.hpp>

#include "core/mesh/Holes.h"
#include "core/mesh/MeshAnalysis.h"
#include "core/mesh/MeshReader.h"
#include "core/mesh/Placement.h"
#include "core/mesh/Weld.h"
#include "tests/support/Checks.h"
#include "tests/support/Solids.h"
#include "tests/support/Suite.h"
#include "tests/support/Tables.h"
#include "tests/support/ToothMaps.h"
#include "tests/support/Trials.h"

using namespace core::mesh;
using support::kPi;

namespace {

MeshFacts factsOf(TriangleMesh& mesh)
{
    weldByPosition(mesh);
    return analyse(mesh);
}

bool close(double a, double b, double relative)
{
    return support::near(a, b, relative * std::max(std::abs(a), std::abs(b)));
}

/// Returns a very coarse tooth: a broad crown over one narrow root, mm, crown up, 18 long.
TriangleMesh plainTooth()
{
    TriangleMesh mesh = support::insideOut(support::cone(4.5F, -12.0F, 48));
    TriangleMesh crown = support::moved(support::sphereCap(6.0F, 6.0F, 48, 12), {0.0F, 0.0F, -0.1F});
    return support::joined(mesh, crown);
}

}  // namespace

class TestMeshAnalysis : public QObject
{
    Q_OBJECT

private slots:
    void closedSolids()
    {
        TriangleMesh mesh = support::box(2.0F, 3.0F, 4.0F);
        const MeshFacts box = factsOf(mesh);
        QVERIFY(box.closed && box.oriented);
        QCOMPARE(box.triangles, std::size_t(12));
        QCOMPARE(box.vertices, std::size_t(8));
        QCOMPARE(box.shells.size(), std::size_t(1));
        QVERIFY(close(box.volume, 24.0, 1e-12));
        QVERIFY(close(box.area, 52.0, 1e-12));
        QVERIFY(glm::length(box.areaVector) < 1e-12);
        QVERIFY(box.low == glm::dvec3(0.0) && box.high == glm::dvec3(2.0, 3.0, 4.0));
        mesh = support::moved(support::sphereCap(5.0F, 5.0F), {100.0F, -50.0F, 30.0F});
        QVERIFY(close(factsOf(mesh).volume, 2.0 / 3.0 * kPi * 125.0, 1e-4));
    }

    void weldingJoinsWhatStlTearsApart()
    {
        auto file = readMesh(support::asBinaryStl(support::box(1.0F, 1.0F, 1.0F)), MeshFormat::Stl, "box");
        QVERIFY(file);
        QCOMPARE(file->mesh.vertices.size(), std::size_t(36));
        file->mesh.vertices[0] = file->mesh.vertices[0] * -1.0F;  // -0 is 0
        const MeshFacts facts = factsOf(file->mesh);
        QCOMPARE(facts.vertices, std::size_t(8));
        QVERIFY(facts.closed);
    }

    void openMeshHasItsHole()
    {
        TriangleMesh mesh = support::withoutBase(support::box(2.0F, 3.0F, 4.0F));
        MeshFacts facts = factsOf(mesh);
        QVERIFY(!facts.closed && !facts.oriented);
        QCOMPARE(facts.boundaryEdges, std::size_t(4));
        QVERIFY(glm::length(facts.areaVector - glm::dvec3(0.0, 0.0, 6.0)) < 1e-9);  // away from the opening
        const auto holes = findHoles(mesh, facts);
        QCOMPARE(holes.size(), std::size_t(1));
        QVERIFY(glm::length(holes[0].areaVector - glm::dvec3(0.0, 0.0, -6.0)) < 1e-9);
        QVERIFY(glm::length(holes[0].centre - glm::dvec3(1.0, 1.5, 0.0)) < 1e-9);
        patch(mesh, holes[0]);
        facts = factsOf(mesh);
        QVERIFY(facts.oriented);
        QVERIFY(close(facts.volume, 24.0, 1e-9));
    }

    void shellsInsideOutAreTurned_data()
    {
        // For each shell, the index of the shell around it, or -1.
        support::columns<TriangleMesh, QList<int>, double, int, double>("mesh", "inside", "volume", "turned",
                                                                        "volumeAfter");
        const TriangleMesh box = support::box(2.0F, 3.0F, 4.0F);
        const TriangleMesh outer = support::box(10.0F, 10.0F, 10.0F);
        const TriangleMesh inner = support::moved(support::box(2.0F, 2.0F, 2.0F), {3.0F, 4.0F, 5.0F});
        const TriangleMesh beside = support::moved(inner, {20.0F, 0.0F, 0.0F});
        QTest::newRow("one") << support::insideOut(box) << QList{-1} << -24.0 << 1 << 24.0;
        QTest::newRow("a cavity looks inwards rightly")
            << support::joined(outer, support::insideOut(inner)) << QList{-1, 0} << 992.0 << 0 << 992.0;
        QTest::newRow("beside another") << support::joined(outer, support::insideOut(beside)) << QList{-1, -1} << 992.0
                                        << 1 << 1008.0;
        QTest::newRow("with what lies inside")
            << support::joined(inner, support::insideOut(outer)) << QList{1, -1} << -992.0 << 1 << 992.0;
    }

    void shellsInsideOutAreTurned()
    {
        QFETCH(TriangleMesh, mesh);
        QFETCH(QList<int>, inside);
        QFETCH(double, volume);
        QFETCH(int, turned);
        QFETCH(double, volumeAfter);
        MeshFacts facts = factsOf(mesh);
        QList<int> found;
        for (const Shell& shell : facts.shells)
            found << (shell.inside ? static_cast<int>(*shell.inside) : -1);
        QCOMPARE(found, inside);
        QVERIFY(facts.oriented);
        QVERIFY(close(facts.volume, volume, 1e-12));
        QCOMPARE(turnOutwards(mesh, facts), static_cast<std::size_t>(turned));
        QVERIFY(close(facts.volume, volumeAfter, 1e-12));
        QVERIFY(close(analyse(mesh).volume, volumeAfter, 1e-12));
        QCOMPARE(turnOutwards(mesh, facts), std::size_t(0));
    }

    void faultyFacesAreCounted()
    {
        TriangleMesh mesh = support::box(1.0F, 1.0F, 1.0F);
        mesh.vertices.emplace_back(0.5F, 0.0F, 0.0F);
        mesh.vertices.emplace_back(7.0F, 7.0F, 7.0F);  // belongs to no triangle
        mesh.triangles.push_back({0, 0, 1});           // collapsed
        mesh.triangles.push_back({0, 8, 1});           // degenerate: its corners are on a line
        mesh.triangles.push_back({4, 5, 6});           // a duplicate
        const MeshFacts facts = factsOf(mesh);
        QCOMPARE(facts.collapsedFaces, std::size_t(1));
        QCOMPARE(facts.zeroAreaFaces, std::size_t(2));
        QCOMPARE(facts.duplicateFaces, std::size_t(1));
        QVERIFY(!facts.closed);
        QVERIFY(facts.high == glm::dvec3(1.0));

        TriangleMesh none;
        none.vertices = {{0, 0, 0}, {1, 0, 0}};
        none.triangles = {{0, 0, 1}, {1, 1, 1}};
        const MeshFacts nothing = factsOf(none);
        QVERIFY(nothing.shells.empty() && !nothing.closed);
        QCOMPARE(nothing.area, 0.0);
    }

    void nonManifoldAndFlippedEdgesAreCounted()
    {
        TriangleMesh fin = support::box(1.0F, 1.0F, 1.0F);
        fin.vertices.emplace_back(0.5F, 0.5F, 2.0F);
        fin.triangles.push_back({4, 5, 8});
        const MeshFacts facts = factsOf(fin);
        QCOMPARE(facts.nonManifoldEdges, std::size_t(1));
        QCOMPARE(facts.boundaryEdges, std::size_t(2));

        TriangleMesh flipped = support::box(1.0F, 1.0F, 1.0F);
        std::swap(flipped.triangles[3][0], flipped.triangles[3][1]);
        const MeshFacts disagreeing = factsOf(flipped);
        QVERIFY(disagreeing.closed && !disagreeing.oriented);
        QCOMPARE(disagreeing.flippedEdges, std::size_t(3));
    }

    void agreesWithTheIndependentReader_data()
    {
        QTest::addColumn<QString>("file");
        for (int n = 0; const char* name : {"teeth/dundee_36.obj", "teeth/dundee_24.obj", "teeth/dundee_21.obj"})
            if (support::isTried(n++))
                QTest::newRow(name) << QString::fromLatin1(name);
    }

    void agreesWithTheIndependentReader()
    {
        QFETCH(QString, file);
        const std::string path = support::sharedData(file.toStdString());
        const std::string script = support::sharedData("../tools/meshinfo.py");
        if (path.empty() || script.empty())
            QSKIP("shared/data or shared/tools is absent");
        QProcess python;
        python.start(QStringLiteral("python3"),
                     {QString::fromStdString(script), QStringLiteral("--json"), QString::fromStdString(path)});
        if (!python.waitForFinished(120000))
            QSKIP("python3 is absent");
        const QJsonObject expected = QJsonDocument::fromJson(python.readAllStandardOutput()).array().at(0).toObject();

        auto mesh = readMesh(std::filesystem::path(path));
        QVERIFY(mesh);
        const MeshFacts facts = factsOf(mesh->mesh);
        const auto number = [&](const char* key) { return expected[QLatin1String(key)].toDouble(-1.0); };
        for (const auto& [key, count] : {std::pair("triangles", facts.triangles),
                                         {"vertices_used", facts.vertices},
                                         {"boundary_edges", facts.boundaryEdges},
                                         {"nonmanifold_edges", facts.nonManifoldEdges},
                                         {"flipped_edges", facts.flippedEdges},
                                         {"duplicate_triangles", facts.duplicateFaces},
                                         {"zero_area_triangles", facts.zeroAreaFaces},
                                         {"components", facts.shells.size()}})
            QVERIFY2(static_cast<double>(count) == number(key), key);
        QCOMPARE(facts.closed, expected[QStringLiteral("watertight")].toBool());
        QCOMPARE(facts.oriented, expected[QStringLiteral("oriented")].toBool());
        QVERIFY(close(facts.volume, number("volume"), 5e-7));
        QVERIFY(close(facts.area, number("area"), 5e-7));
        for (int k = 0; k < 3; ++k) {
            QVERIFY(close(facts.low[k], expected[QStringLiteral("bbox_min")].toArray().at(k).toDouble(), 1e-6));
            QVERIFY(close(facts.high[k], expected[QStringLiteral("bbox_max")].toArray().at(k).toDouble(), 1e-6));
        }
    }

    void unitIsGuessedFromTheSize()
    {
        for (const auto& [scale, unit, warns] : {std::tuple(1.0F, "mm", false),
                                                 {0.1F, "cm", true},
                                                 {0.001F, "m", true},
                                                 {1.0F / 25.4F, "in", true},
                                                 {37.0F, "0.0302", true}}) {
            TriangleMesh mesh = support::scaled(plainTooth(), scale);
            const MeshFacts facts = factsOf(mesh);
            const auto placement = findPlacement(mesh, facts, {});
            QVERIFY(placement);
            QCOMPARE(placement->unit.name, std::string(unit));
            QCOMPARE(!placement->warnings.empty(), warns);
            const double lengthMm = (facts.high.z - facts.low.z) * placement->unit.mmPerUnit;
            QVERIFY(lengthMm > 15.0 && lengthMm < 22.0);
        }
        // Whole teeth and crowns of usual sizes (mm), from the smallest incisor to a large molar.
        for (const glm::vec3& size :
             {glm::vec3(8.5F, 7.0F, 23.5F), glm::vec3(5.3F, 5.7F, 21.0F), glm::vec3(11.0F, 10.5F, 21.6F),
              glm::vec3(7.5F, 8.0F, 26.0F), glm::vec3(9.0F, 7.0F, 21.5F)}) {
            for (const auto& [mmPerUnit, unit] : {std::pair(10.0F, "cm"), {25.4F, "in"}}) {
                TriangleMesh whole = support::scaled(support::box(size.x, size.y, size.z), 1.0F / mmPerUnit);
                const auto placement = findPlacement(whole, factsOf(whole), {});
                QVERIFY(placement);
                QCOMPARE(placement->unit.name, std::string(unit));
            }
            TriangleMesh crown = support::scaled(support::box(size.x, size.y, 9.0F), 0.1F);
            const auto placement = findPlacement(crown, factsOf(crown), {});
            QVERIFY(placement);
            QCOMPARE(placement->unit.name, std::string("cm"));
            // Where both are possible, the warning names both.
            QVERIFY2(placement->warnings.front().find("as inches it would be") != std::string::npos,
                     placement->warnings.front().c_str());
        }
        TriangleMesh jaw = support::box(60.0F, 45.0F, 20.0F);
        const auto ofJaw = findPlacement(jaw, factsOf(jaw), {});
        QVERIFY(ofJaw && ofJaw->unit.name == "mm" && !ofJaw->warnings.empty());
        QVERIFY(ofJaw->unitDoubtful);
    }

    void crownIsFoundWhateverTheAxes()
    {
        for (const char* crown : {"+x", "-x", "+y", "-y", "+z", "-z"}) {
            TriangleMesh mesh = plainTooth();
            for (glm::vec3& v : mesh.vertices) {
                v = crown[1] == 'x' ? glm::vec3(v.z, v.x, v.y) : crown[1] == 'y' ? glm::vec3(v.y, v.z, v.x) : v;
                v = crown[0] == '+' ? v : -v;  // this mirrors the mesh too, which does not matter here
            }
            if (crown[0] == '-')
                mesh = support::insideOut(std::move(mesh));
            const auto placement = findPlacement(mesh, factsOf(mesh), {});
            QVERIFY(placement);
            QCOMPARE(placement->up.name, std::string(crown));
        }
    }

    void openingAndFlatBaseTellTheCrown()
    {
        TriangleMesh cap = support::sphereCap(6.0F, 5.0F, 60, 20);
        auto placement = findPlacement(cap, factsOf(cap), {});
        QVERIFY(placement && placement->up.name == "+z");
        QVERIFY(placement->upReason.find("flat") != std::string::npos);

        TriangleMesh bowl = support::withoutBase(cap);
        for (glm::vec3& v : bowl.vertices)
            v = {v.x, v.z, -v.y};
        placement = findPlacement(bowl, factsOf(bowl), {});
        QVERIFY(placement && placement->up.name == "+y");
        QVERIFY(placement->upReason.find("open") != std::string::npos);

        TriangleMesh box = support::box(10.0F, 10.0F, 10.0F);
        placement = findPlacement(box, factsOf(box), {});
        QVERIFY(placement && placement->up.name == "+z");
        QVERIFY(!placement->warnings.empty());  // the orientation is uncertain
        QVERIFY(placement->upDoubtful && !placement->unitDoubtful);
    }

    /// A tooth whose long axis lies between the axes of the file is turned upright, with a warning that gives the
    /// direction; so is an open scan.
    void toothThatLiesAskewIsTurnedUpright()
    {
        for (const glm::dvec3& crown : {glm::dvec3(1, 0, 1), {0, -1, 1}, {-1, 1, 1}, {1, 1, -0.2}}) {
            const glm::dvec3 up = glm::normalize(crown);
            const glm::dvec3 side = glm::normalize(glm::cross(up, glm::dvec3(0.3, 1.0, 0.2)));
            const glm::dmat3 turn(side, glm::cross(up, side), up);
            for (const bool isOpen : {false, true}) {
                TriangleMesh mesh =
                    isOpen ? support::withoutBase(support::sphereCap(6.0F, 5.0F, 60, 20)) : plainTooth();
                for (glm::vec3& v : mesh.vertices)
                    v = glm::vec3(turn * glm::dvec3(v));
                const auto placement = findPlacement(mesh, factsOf(mesh), {});
                QVERIFY2(placement && placement->isTurned && !placement->upDoubtful, placement->upReason.c_str());
                QVERIFY(glm::dot(placement->up.inFile, up) > 0.98);
                QCOMPARE(placement->warnings.size(), std::size_t(1));
                QVERIFY(placement->warnings.front().find(placement->up.name) != std::string::npos);
                // The direction in the warning, given with --up, gives the same place.
                PlacementOptions given;
                given.up = parseUp(placement->up.name).value();
                const auto same = findPlacement(mesh, factsOf(mesh), given);
                QVERIFY(same && same->warnings.empty());
                QVERIFY(glm::distance(same->originMm, placement->originMm) < 0.05);
            }
        }
    }

    void frameOfAnyDirectionIsRightHanded()
    {
        for (const char* direction : {"1,0,1", "-1,0.2,0.1", "0.5,-0.6,0.4", "1,1,1", "0,-1,-1"}) {
            TriangleMesh mesh = support::box(8.0F, 9.0F, 7.0F);
            const UpDirection up = *parseUp(direction);
            const auto placement = findPlacement(mesh, factsOf(mesh), {LengthUnit{}, up, false});
            QVERIFY(placement);
            const auto turned = [&](const glm::dvec3& way) {
                return toothFromFile(*placement, way) - toothFromFile(*placement, {0, 0, 0});
            };
            const glm::dvec3 x = turned({1, 0, 0});
            const glm::dvec3 y = turned({0, 1, 0});
            const glm::dvec3 z = turned({0, 0, 1});
            QVERIFY(std::abs(glm::dot(glm::cross(x, y), z) - 1.0) < 1e-12);
            QVERIFY(std::abs(glm::length(x) - 1.0) < 1e-12 && std::abs(glm::dot(x, y)) < 1e-12);
            QVERIFY(glm::distance(turned(up.inFile), glm::dvec3(0.0, 0.0, 1.0)) < 1e-12);
        }
    }

    void frameIsRightHandedAndPutsTheCrownAtTheOrigin()
    {
        for (const char* name : {"+x", "-x", "+y", "-y", "+z", "-z"}) {
            const UpDirection up = *parseUp(name);
            TriangleMesh mesh = support::moved(support::box(8.0F, 9.0F, 7.0F), {100.0F, -40.0F, 3.0F});
            MeshFacts facts = factsOf(mesh);
            const auto placement = findPlacement(mesh, facts, {LengthUnit{}, up, false});
            QVERIFY(placement);
            const auto directionFromFile = [&](const glm::dvec3& way) {
                return (toothFromFile(*placement, way) - toothFromFile(*placement, {0, 0, 0})) /
                       placement->unit.mmPerUnit;
            };
            const glm::dvec3 x = directionFromFile({1, 0, 0});
            const glm::dvec3 y = directionFromFile({0, 1, 0});
            const glm::dvec3 z = directionFromFile({0, 0, 1});
            QCOMPARE(glm::dot(glm::cross(x, y), z), 1.0);
            const int axis = name[1] - 'x';
            const double sign = name[0] == '+' ? 1.0 : -1.0;
            const glm::dvec3 crown = axis == 0 ? x : axis == 1 ? y : z;
            QVERIFY(crown * sign == glm::dvec3(0.0, 0.0, 1.0));
            QVERIFY(axis == 0 ? y == glm::dvec3(0.0, 1.0, 0.0) : x == glm::dvec3(1.0, 0.0, 0.0));
            moveToToothFrame(mesh, *placement);
            facts = factsOf(mesh);
            QVERIFY(close(facts.volume, 504.0, 1e-5));
            QVERIFY(std::abs(facts.high.z) < 1e-5);
            QVERIFY(std::abs(facts.high.x + facts.low.x) < 1e-4 && std::abs(facts.high.y + facts.low.y) < 1e-4);
        }
    }

    void frameOfTheFileIsKept()
    {
        TriangleMesh mesh = support::moved(support::box(8.0F, 9.0F, 7.0F), {100.0F, -40.0F, 3.0F});
        const TriangleMesh before = mesh;
        const auto placement = findPlacement(mesh, factsOf(mesh), {std::nullopt, std::nullopt, true});
        QVERIFY(placement);
        QCOMPARE(placement->unit.mmPerUnit, 1.0);
        moveToToothFrame(mesh, *placement);
        QVERIFY(mesh.vertices.size() == before.vertices.size());
        const MeshFacts facts = factsOf(mesh);
        QVERIFY(facts.low == glm::dvec3(100.0, -40.0, 3.0) && facts.high == glm::dvec3(108.0, -31.0, 10.0));
    }

    void refusesWhatCannotBeATooth()
    {
        TriangleMesh mesh = support::box(8.0F, 9.0F, 7.0F);
        MeshFacts facts = factsOf(mesh);
        for (const LengthUnit& unit : {LengthUnit{"m", 1000.0}, LengthUnit{"0.001", 0.001}})
            QVERIFY(support::isRefused(findPlacement(mesh, facts, {unit, {}, false}), core::ErrorCode::OutOfRange));
        mesh = support::moved(mesh, {5.0e4F, 0.0F, 0.0F});
        facts = factsOf(mesh);
        QVERIFY(support::isRefused(findPlacement(mesh, facts, {{}, {}, true}), core::ErrorCode::OutOfRange));
        QVERIFY(findPlacement(mesh, facts, {}));
    }

    void warnsOfASizeThatNoToothHas()
    {
        // A scan in cm that is declared as mm, one in mm declared as cm, and plausible sizes.
        for (const auto& [sizeUnits, mmPerUnit, says] :
             {std::tuple(2.1F, 1.0, "less than"), {8.5F, 10.0, "more than"}, {21.0F, 1.0, ""}, {2.1F, 10.0, ""}})
            for (const bool keepFrame : {false, true}) {
                if (keepFrame && mmPerUnit != 1.0)
                    continue;
                PlacementOptions options;
                options.keepFrame = keepFrame;
                if (!keepFrame) {
                    options.unit = LengthUnit{"given", mmPerUnit};
                    options.up = parseUp("+z").value();
                }
                TriangleMesh mesh = support::box(sizeUnits, 0.9F * sizeUnits, 0.8F * sizeUnits);
                const auto placement = findPlacement(mesh, factsOf(mesh), options);
                QVERIFY(placement);
                QCOMPARE(placement->warnings.size(), std::size_t(*says == '\0' ? 0 : 1));
                for (const std::string& warning : placement->warnings)
                    for (const char* words : {says, keepFrame ? "--frame file" : "--unit"})
                        QVERIFY2(warning.find(words) != std::string::npos, warning.c_str());
            }
    }

    void unitsAndAxesAreParsed()
    {
        QCOMPARE(parseUnit("cm")->mmPerUnit, 10.0);
        QCOMPARE(parseUnit("10.5")->mmPerUnit, 10.5);
        for (const char* bad : {"", "0", "-1", "nan", "inf", "mm ", "1,5", "ft"})
            QVERIFY(!parseUnit(bad));
        for (const char* inches : {"in", "IN", "inch", "inches"})
            QCOMPARE(parseUnit(inches)->mmPerUnit, 25.4);
        QVERIFY(parseUp("-y")->inFile == glm::dvec3(0.0, -1.0, 0.0));
        QVERIFY(parseUp("x")->inFile == glm::dvec3(1.0, 0.0, 0.0));
        QVERIFY(glm::distance(parseUp("1,0,-1")->inFile, glm::dvec3(1.0, 0.0, -1.0) / std::sqrt(2.0)) < 1e-12);
        for (const char* bad : {"", "+", "w", "+Y", "--z", "1,0", "1,0,0,0", "0,0,0", "1,nan,0", "1,,0", "1,0,0,"})
            QVERIFY2(!parseUp(bad), bad);
    }
};

CUSP_TEST(TestMeshAnalysis)
#include "tst_mesh_analysis.moc"
