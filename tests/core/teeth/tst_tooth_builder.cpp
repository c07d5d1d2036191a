// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include <QTemporaryDir>
#include <QTest>

#include <glm/geometric.hpp>

#include "core/teeth/ToothBuilder.h"
#include "core/teeth/ToothGenerator.h"
#include "tests/support/Checks.h"
#include "tests/support/Files.h"
#include "tests/support/Solids.h"
#include "tests/support/Suite.h"
#include "tests/support/SyntheticTooth.h"
#include "tests/support/Tables.h"
#include "tests/support/ToothMaps.h"
#include "tests/support/Trials.h"

using namespace core::teeth;
using core::ErrorCode;
using core::mesh::TriangleMesh;

namespace {

/// Returns the warnings of a report in one text.
std::string warningsOf(const BuiltTooth& tooth)
{
    return std::accumulate(tooth.report.warnings.begin(), tooth.report.warnings.end(), std::string());
}

bool warns(const BuiltTooth& tooth, const QString& words)
{
    return QString::fromStdString(warningsOf(tooth)).contains(words);
}

/// Returns whether two numbers agree within this share of the expected one.
bool agrees(double actual, double expected, double share)
{
    return support::near(actual, expected, share * std::abs(expected));
}

TriangleMesh boxAt(float side, float x, float y, float z)
{
    return support::moved(support::box(side, side, side), {x, y, z});
}

}  // namespace

class TestToothBuilder : public QObject
{
    Q_OBJECT

private slots:
    void generatedTooth()
    {
        const auto tooth = buildTooth({36}, {});
        QVERIFY(tooth);
        const ToothReport& report = tooth->report;
        QVERIFY(report.closed && report.oriented);
        QCOMPARE(report.fdi, 36);
        QCOMPARE(tooth->anatomy->fdi, 36);
        QCOMPARE(tooth->anatomy->layers.size(), tooth->anatomy->grid.count());
        QVERIFY(report.undercutMm3 && *report.undercutMm3 >= 0.0);
        QVERIFY(*report.undercutMm3 < 0.05 * report.meshVolumeMm3);
        const double layers = std::accumulate(report.layersMm3.begin(), report.layersMm3.end(), 0.0);
        QVERIFY(agrees(layers, report.modelVolumeMm3, 1e-6));
        QVERIFY(report.sewnCells > 100 && report.layersMm3[0] > 0.0);
        BuildOptions sound;
        sound.caries.reset();
        QCOMPARE(buildTooth({36}, sound)->report.layersMm3[0], 0.0);
        QCOMPARE(buildTooth({99}, {}).error().code, ErrorCode::UnknownName);
    }

    void sameSeedSameTooth()
    {
        BuildOptions options;
        options.seed = 42;
        const auto one = buildTooth({24}, options);
        const auto two = buildTooth({24}, options);
        QVERIFY(one && two);
        QVERIFY(one->anatomy->top == two->anatomy->top && one->anatomy->layers == two->anatomy->layers);
        options.seed = 43;
        QVERIFY(one->anatomy->top != buildTooth({24}, options)->anatomy->top);
    }

    void lesionIsTheSameOnEveryGrid_data()
    {
        QTest::addColumn<QString>("source");
        for (const int quadrant : {20, 30})
            for (int place = 1; place <= 8; ++place)
                if (support::isTried(quadrant + place))
                    QTest::addRow("%d", quadrant + place) << QString::number(quadrant + place);
        const std::string scan = support::sharedData("teeth/dundee_36.obj");
        if (!scan.empty())
            QTest::newRow("a scan of 36") << QString::fromStdString(scan);
    }

    void lesionIsTheSameOnEveryGrid()
    {
        QFETCH(QString, source);
        struct Lesion
        {
            double volumeMm3 = 0.0;
            glm::dvec2 centreMm{};
        };
        const auto lesionOn = [&](int side) {
            BuildOptions options;
            options.gridSide = side;
            const auto tooth = buildTooth(parseSource(source.toStdString()), options);
            const core::terrain::ToothAnatomy& anatomy = *tooth->anatomy;
            Lesion lesion;
            support::eachNode(anatomy.grid, [&](std::size_t k, const glm::dvec2& at) {
                if (!(anatomy.top[k] > anatomy.bottom[k]))
                    return;
                const double volume =
                    core::terrain::lengthsBetween(anatomy.layers[k], anatomy.bottom[k], anatomy.top[k])[0] *
                    static_cast<double>(anatomy.areaMm2[k]);
                lesion.volumeMm3 += volume;
                lesion.centreMm += volume * at;
            });
            lesion.centreMm /= lesion.volumeMm3;
            return lesion;
        };
        const Lesion expected = lesionOn(150);
        const bool isScan = source.endsWith(QStringLiteral(".obj"));
        for (const int side : {64, 80, 100, 200, 256, 300, 600}) {
            if (!support::isNightly() && side != 64 && side != 200)
                continue;
            const Lesion lesion = lesionOn(side);
            QVERIFY(support::near(glm::distance(lesion.centreMm, expected.centreMm), 0.0, 0.1));
            // Where the pulp limits a lesion, its volume still depends on the grid, as with the pulp horns of a scan.
            QVERIFY(agrees(lesion.volumeMm3, expected.volumeMm3, isScan ? 0.2 : side == 64 ? 0.05 : 0.03));
        }
    }

    void scanAgreesWithAnIndependentRasteriser()
    {
        for (const auto& [fdi, up] : {std::pair(36, "+y"), {24, "-y"}, {21, "-y"}}) {
            const std::string path = support::sharedData("teeth/dundee_" + std::to_string(fdi) + ".obj");
            if (path.empty())
                QSKIP("shared/data is absent");
            BuildOptions options;
            options.fdi = fdi;
            options.placement.unit = core::mesh::LengthUnit{"10.5", 10.5};
            const auto tooth = buildTooth({std::filesystem::path(path)}, options);
            QVERIFY(tooth);
            QCOMPARE(tooth->report.placement.up.name, std::string(up));
            // The other implementation chooses grid and axes itself, so only volumes are compared. It counts full
            // cells, hence the coarse tolerance.
            const auto other = support::scanMaps(fdi, 400);
            QVERIFY(other);
            double volume = 0.0;
            for (std::size_t k = 0; k < other->top.size(); ++k)
                if (other->top[k] > other->bottom[k])
                    volume +=
                        static_cast<double>(other->top[k] - other->bottom[k]) * other->grid.cellMm * other->grid.cellMm;
            QVERIFY(agrees(tooth->report.modelVolumeMm3, volume, 0.003));
            QVERIFY(*tooth->report.undercutMm3 > 0.0);
            QVERIFY(*tooth->report.undercutMm3 < 0.05 * tooth->report.meshVolumeMm3);
        }
    }

    void openScanIsClosedBelow()
    {
        const auto tooth = buildFileFrame(support::withoutBase(support::sphereCap(6.0F, 4.0F, 90, 30)));
        QVERIFY(tooth);
        QVERIFY(!tooth->report.closed && !tooth->report.undercutMm3);
        QVERIFY(agrees(tooth->report.modelVolumeMm3, std::numbers::pi * 16.0 * (6.0 - 4.0 / 3.0), 0.005));
        QVERIFY2(warns(*tooth, "open below and was closed with a flat bottom, 100 mm2"), warningsOf(*tooth).c_str());
    }

    void openScanHoldsAsMuchAsTheClampedOne_data()
    {
        support::rows<float>("cutMm", {-6.0F, -7.0F, -9.0F, -10.0F, -12.0F, -15.0F});
    }

    void openScanHoldsAsMuchAsTheClampedOne()
    {
        QFETCH(float, cutMm);
        const TriangleMesh whole = generateTooth(36, 0).value();
        TriangleMesh open = whole;
        std::erase_if(open.triangles, [&](const auto& t) {
            return std::any_of(t.begin(), t.end(), [&](std::uint32_t v) { return whole.vertices[v].z < cutMm; });
        });
        const auto expected = buildFileFrame(support::clampedAt(whole, cutMm));
        const auto tooth = buildFileFrame(open);
        QVERIFY(expected && tooth && !tooth->report.closed);
        QVERIFY(agrees(tooth->report.modelVolumeMm3, expected->report.modelVolumeMm3, 0.01));
        for (const std::size_t material : {1U, 3U})
            QVERIFY(support::near(tooth->report.layersMm3[material], expected->report.layersMm3[material],
                                  0.02 * expected->report.layersMm3[material] + 1.5));
    }

    void scanWithoutItsPulpIsToldApart()
    {
        // The tooth ends above the pulp chamber, within it, or is whole.
        for (const auto& [cutMm, hasPulp] : {std::pair(-4.0F, false), {-8.0F, true}, {-100.0F, true}}) {
            const auto tooth = buildFileFrame(support::clampedAt(generateTooth(36, 0).value(), cutMm));
            QVERIFY(tooth);
            QCOMPARE(tooth->report.layersMm3[3] > 1.0, hasPulp);
            QCOMPARE(std::count(tooth->report.warnings.begin(), tooth->report.warnings.end(),
                                "this scan ends above the pulp: opening it cannot be judged"),
                     hasPulp ? 0 : 1);
        }
    }

    void scanOpenAboveIsRefused()
    {
        TriangleMesh mesh = support::box(8.0F, 8.0F, 8.0F);
        mesh.triangles.erase(mesh.triangles.begin() + 2, mesh.triangles.begin() + 4);  // the lid
        QVERIFY(support::isRefused(buildFileFrame(mesh), ErrorCode::BadStructure));
        // If the orientation is guessed, the opening is below.
        QVERIFY(buildTooth({write(mesh)}, {}));
    }

    void smallHolesArePatched()
    {
        TriangleMesh mesh = support::sphereCap(6.0F, 6.0F, 60, 30);
        const double whole = buildFileFrame(mesh)->report.modelVolumeMm3;
        for (std::size_t k = 100; k < mesh.triangles.size(); k += 500)
            mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(k));
        const auto tooth = buildFileFrame(mesh);
        QVERIFY(tooth);
        QVERIFY(!tooth->report.closed);
        QVERIFY(agrees(tooth->report.modelVolumeMm3, whole, 1e-4));
    }

    void undercutOfSeveralShells_data()
    {
        support::columns<TriangleMesh, double>("mesh", "undercut");  // negative: unknown
        const TriangleMesh box = boxAt(10.0F, 0, 0, 0);
        const TriangleMesh small = boxAt(6.0F, 2, 2, 2);
        const TriangleMesh flat = support::box(10.0F, 10.0F, 4.0F);
        QTest::newRow("a hollow") << support::joined(box, support::insideOut(small)) << 216.0;
        QTest::newRow("solid in solid") << support::joined(box, small) << 0.0;
        QTest::newRow("one above the other")
            << support::joined(flat, support::moved(flat, {0.0F, 0.0F, 6.0F})) << 200.0;
        QTest::newRow("beside each other") << support::joined(boxAt(6.0F, 0, 0, 0), boxAt(6.0F, 7, 0, 0)) << 0.0;
        QTest::newRow("one sunk into the other") << support::joined(box, boxAt(6.0F, 2, 2, 7)) << -1.0;
        QTest::newRow("solid in solid beside a hollow")
            << support::joined(support::joined(box, boxAt(2.0F, 1, 1, 1)), support::insideOut(boxAt(2.0F, 6, 6, 6)))
            << -1.0;
    }

    void undercutOfSeveralShells()
    {
        QFETCH(TriangleMesh, mesh);
        QFETCH(double, undercut);
        const auto tooth = buildFileFrame(mesh);
        QVERIFY(support::succeeds(tooth));
        QCOMPARE(tooth->report.undercutMm3.has_value(), undercut >= 0.0);
        if (undercut >= 0.0)
            QVERIFY(support::near(*tooth->report.undercutMm3, undercut, 0.005 * tooth->report.modelVolumeMm3));
        QCOMPARE(warns(*tooth, "may overlap"), undercut < 0.0);
    }

    void usableMeshesWarn_data()
    {
        support::columns<TriangleMesh, QString>("mesh", "says");
        const TriangleMesh box = boxAt(8.0F, 0, 0, 0);
        QTest::newRow("inside out") << support::insideOut(box) << "inside out";
        const TriangleMesh one = support::joined(box, boxAt(1.0F, 3, 3, 3));
        QTest::newRow("a second shell inside") << one << "2 separate shells, one of them inside another;";
        QTest::newRow("two shells inside")
            << support::joined(one, boxAt(1.0F, 5, 5, 5)) << "3 separate shells, 2 of them inside another;";
        const auto slabs = [](int count) {
            const float pitch = 8.0F / static_cast<float>(count);
            TriangleMesh all;
            for (int k = 0; k < count; ++k)
                all = support::joined(all, support::moved(support::box(8.0F, 8.0F, 0.995F * pitch),
                                                          {0.0F, 0.0F, pitch * static_cast<float>(k)}));
            return all;
        };
        QTest::newRow("a shell over another") << slabs(2) << "2 separate shells, none of them inside";
        QTest::newRow("more shells than are told apart") << slabs(33) << "33 separate shells; the model";
        const auto withFace = [&](std::array<std::uint32_t, 3> face) {
            TriangleMesh mesh = box;
            mesh.vertices.emplace_back(4.0F, 4.0F, 6.0F);
            mesh.triangles.push_back(face);
            return mesh;
        };
        QTest::newRow("non-manifold") << withFace({4, 5, 8}) << "not a manifold";
        QTest::newRow("zero area") << withFace({1, 1, 2}) << "zero area";
        TriangleMesh flipped = box;
        std::swap(flipped.triangles[3][0], flipped.triangles[3][1]);
        QTest::newRow("faces disagree") << flipped << "disagree";
        QTest::newRow("everything twice") << support::joined(box, box) << "twice";
    }

    void usableMeshesWarn()
    {
        QFETCH(TriangleMesh, mesh);
        QFETCH(QString, says);
        const auto tooth = buildFileFrame(mesh);
        QVERIFY(support::succeeds(tooth));
        QVERIFY2(warns(*tooth, says), warningsOf(*tooth).c_str());
        QVERIFY(agrees(tooth->report.modelVolumeMm3, 512.0, 0.005));
    }

    void uselessMeshesAreRefused_data()
    {
        QTest::addColumn<TriangleMesh>("mesh");
        TriangleMesh mesh;
        mesh.vertices = {{0, 0, 0}, {8, 0, 0}, {0, 8, 3}, {4, 0, 0}, {2, 0, 0}};
        mesh.triangles = {{0, 1, 2}};
        QTest::newRow("one triangle") << mesh;
        mesh.triangles = {{0, 3, 1}, {0, 4, 1}, {0, 4, 3}, {4, 3, 1}};
        QTest::newRow("zero area throughout") << mesh;
        mesh = support::box(8.0F, 8.0F, 8.0F);
        for (glm::vec3& v : mesh.vertices)
            v.z = 0.0F;
        QTest::newRow("flat") << mesh;
        mesh = support::box(0.01F, 0.01F, 8.0F);
        QTest::newRow("a needle") << mesh;
        mesh = {};
        for (std::uint32_t k = 0; k < 300; k += 3) {
            mesh.vertices.insert(mesh.vertices.end(), 3, glm::vec3(static_cast<float>(k) * 0.02F, 1.0F, 0.0F));
            mesh.vertices[k].y = 4.0F;
            mesh.vertices[k + 1].x += 1.0F;
            mesh.triangles.push_back({k, k + 1, k + 2});
        }
        QTest::newRow("scattered faces") << mesh;
        mesh = support::box(8.0F, 8.0F, 8.0F);
        for (int k = 0; k < 12; ++k)
            mesh = support::joined(mesh, mesh);
        QTest::newRow("a heap of faces") << mesh;
        QTest::newRow("a house") << support::box(8000.0F, 8000.0F, 8000.0F);
    }

    void uselessMeshesAreRefused()
    {
        QFETCH(TriangleMesh, mesh);
        QVERIFY(support::isRefused(buildFileFrame(mesh), "mesh.stl"));
    }

    void sourcesAreToldApart()
    {
        QCOMPARE(std::get<int>(parseSource("36").what), 36);
        QVERIFY(std::get<std::filesystem::path>(parseSource("36.obj").what) == "36.obj");
        QVERIFY(std::get<std::filesystem::path>(parseSource("./36").what) == "./36");
    }

    void optionsAreChecked()
    {
        BuildOptions options;
        options.gridSide = 63;
        QVERIFY(support::isRefused(buildTooth({36}, options), ErrorCode::OutOfRange));
        options.gridSide = 1024;
        QVERIFY(buildTooth({36}, options));
        options.cariesExtent = std::nan("");
        QVERIFY(support::isRefused(buildTooth({36}, options), ErrorCode::OutOfRange));
    }

private:
    std::filesystem::path write(const TriangleMesh& mesh)
    {
        const std::filesystem::path path(m_folder.filePath(QStringLiteral("mesh.stl")).toStdString());
        support::write(path, support::asBinaryStl(mesh));
        return path;
    }
    core::Result<BuiltTooth> buildFileFrame(const TriangleMesh& mesh)
    {
        BuildOptions options;
        options.placement.keepFrame = true;
        return buildTooth({write(mesh)}, options);
    }
    QTemporaryDir m_folder;
};

CUSP_TEST(TestToothBuilder)
#include "tst_tooth_builder.moc"
