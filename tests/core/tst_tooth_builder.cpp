// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numeric>

#include <QTemporaryDir>
#include <QTest>

#include <glm/geometric.hpp>

#include "core/teeth/ToothBuilder.h"
#include "core/teeth/ToothGenerator.h"
#include "tests/support/Checks.h"
#include "tests/support/Files.h"
#include "tests/support/Solids.h"
#include "tests/support/Tables.h"
#include "tests/support/ToothMaps.h"
#include "tests/support/Trials.h"

using namespace core::teeth;
using core::ErrorCode;
using core::mesh::TriangleMesh;

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
        QVERIFY(std::abs(layers / report.modelVolumeMm3 - 1.0) < 1e-6);
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
            for (int j = 0; j < side; ++j)
                for (int i = 0; i < side; ++i) {
                    const std::size_t k = anatomy.grid.index(i, j);
                    if (!(anatomy.top[k] > anatomy.bottom[k]))
                        continue;
                    const double volume =
                        core::terrain::lengthsBetween(anatomy.layers[k], anatomy.bottom[k], anatomy.top[k])[0] *
                        static_cast<double>(anatomy.areaMm2[k]);
                    lesion.volumeMm3 += volume;
                    lesion.centreMm += volume * anatomy.grid.nodeMm(i, j);
                }
            lesion.centreMm /= lesion.volumeMm3;
            return lesion;
        };
        const Lesion expected = lesionOn(150);
        const bool isScan = source.endsWith(QStringLiteral(".obj"));
        for (const int side : {64, 80, 100, 200, 256, 300, 600}) {
            if (!support::isNightly() && side != 64 && side != 200)
                continue;
            const Lesion lesion = lesionOn(side);
            const QString found = QStringLiteral("at %1: %2 mm3 instead of %3, centre off by %4 %5")
                                      .arg(side)
                                      .arg(lesion.volumeMm3)
                                      .arg(expected.volumeMm3)
                                      .arg(lesion.centreMm.x - expected.centreMm.x)
                                      .arg(lesion.centreMm.y - expected.centreMm.y);
            QVERIFY2(glm::distance(lesion.centreMm, expected.centreMm) < 0.1, qPrintable(found));
            // What the pulp spares of a lesion over it still follows the grid: horns on a scan do.
            const double tolerance = isScan ? 0.2 : side == 64 ? 0.05 : 0.03;
            QVERIFY2(std::abs(lesion.volumeMm3 / expected.volumeMm3 - 1.0) < tolerance, qPrintable(found));
        }
    }

    void scanAgreesWithAnIndependentRasteriser_data()
    {
        support::columns<int, QString>("fdi", "up");
        QTest::newRow("36") << 36 << QStringLiteral("+y");
        QTest::newRow("24") << 24 << QStringLiteral("-y");
        QTest::newRow("21") << 21 << QStringLiteral("-y");
    }

    void scanAgreesWithAnIndependentRasteriser()
    {
        QFETCH(int, fdi);
        QFETCH(QString, up);
        const std::string path = support::sharedData("teeth/dundee_" + std::to_string(fdi) + ".obj");
        if (path.empty())
            QSKIP("shared/data is absent");
        BuildOptions options;
        options.fdi = fdi;
        options.placement.unit = core::mesh::LengthUnit{"10.5", 10.5};
        const auto tooth = buildTooth({std::filesystem::path(path)}, options);
        QVERIFY(tooth);
        QCOMPARE(QString::fromStdString(std::string(core::mesh::nameOf(tooth->report.placement.up))), up);
        // The other one chooses grid and axes itself, so volumes are compared: at full cells, hence the coarse
        // tolerance.
        const auto other = support::scanMaps(fdi, 400);
        QVERIFY(other);
        double volume = 0.0;
        for (std::size_t k = 0; k < other->top.size(); ++k)
            if (other->top[k] > other->bottom[k])
                volume +=
                    static_cast<double>(other->top[k] - other->bottom[k]) * other->grid.cellMm * other->grid.cellMm;
        qInfo("%d: model %.3f, other %.3f, mesh %.3f mm3", fdi, tooth->report.modelVolumeMm3, volume,
              tooth->report.meshVolumeMm3);
        QVERIFY(std::abs(tooth->report.modelVolumeMm3 / volume - 1.0) < 0.003);
        QVERIFY(*tooth->report.undercutMm3 > 0.0);
        QVERIFY(*tooth->report.undercutMm3 < 0.05 * tooth->report.meshVolumeMm3);
    }

    void openScanIsClosedBelow()
    {
        TriangleMesh mesh = support::sphereCap(6.0F, 4.0F, 90, 30);
        std::erase_if(mesh.triangles, [&](const auto& t) {
            return mesh.vertices[t[0]].z == 0.0F && mesh.vertices[t[1]].z == 0.0F && mesh.vertices[t[2]].z == 0.0F;
        });
        const auto tooth = buildFileFrame(mesh);
        QVERIFY(tooth);
        QVERIFY(!tooth->report.closed && !tooth->report.undercutMm3);
        const double exact = 3.14159265358979 * 16.0 * (6.0 - 4.0 / 3.0);
        QVERIFY(std::abs(tooth->report.modelVolumeMm3 / exact - 1.0) < 0.005);
        const QString warnings = QString::fromStdString(
            std::accumulate(tooth->report.warnings.begin(), tooth->report.warnings.end(), std::string()));
        QVERIFY2(warnings.contains(QStringLiteral("open below and was closed with a flat bottom, 100 mm2")),
                 qPrintable(warnings));
    }

    void openScanHoldsAsMuchAsTheClampedOne_data()
    {
        support::rows<float>("cutMm", {-6.0F, -7.0F, -9.0F, -10.0F, -12.0F, -15.0F});
    }

    void openScanHoldsAsMuchAsTheClampedOne()
    {
        QFETCH(float, cutMm);
        const TriangleMesh whole = generateTooth(36, 0).value();
        TriangleMesh clamped = whole;
        for (glm::vec3& vertex : clamped.vertices)
            vertex.z = std::max(vertex.z, cutMm);
        TriangleMesh open = whole;
        std::erase_if(open.triangles, [&](const auto& t) {
            return std::any_of(t.begin(), t.end(), [&](std::uint32_t v) { return whole.vertices[v].z < cutMm; });
        });
        const auto expected = buildFileFrame(clamped);
        const auto tooth = buildFileFrame(open);
        QVERIFY(expected && tooth && !tooth->report.closed);
        QVERIFY2(std::abs(tooth->report.modelVolumeMm3 / expected->report.modelVolumeMm3 - 1.0) < 0.01,
                 qPrintable(QStringLiteral("%1, clamped %2 mm3")
                                .arg(tooth->report.modelVolumeMm3)
                                .arg(expected->report.modelVolumeMm3)));
        for (const std::size_t material : {1U, 3U})
            QVERIFY2(std::abs(tooth->report.layersMm3[material] - expected->report.layersMm3[material]) <
                         0.02 * expected->report.layersMm3[material] + 1.5,
                     qPrintable(QStringLiteral("material %1: %2, clamped %3 mm3")
                                    .arg(material)
                                    .arg(tooth->report.layersMm3[material])
                                    .arg(expected->report.layersMm3[material])));
    }

    void scanWithoutItsPulpIsToldApart_data()
    {
        support::columns<float, bool>("cutMm", "hasPulp");
        QTest::newRow("above the chamber") << -4.0F << false;
        QTest::newRow("through the chamber") << -7.0F << true;
        QTest::newRow("whole") << -100.0F << true;
    }

    void scanWithoutItsPulpIsToldApart()
    {
        QFETCH(float, cutMm);
        QFETCH(bool, hasPulp);
        TriangleMesh mesh = generateTooth(36, 0).value();
        for (glm::vec3& vertex : mesh.vertices)
            vertex.z = std::max(vertex.z, cutMm);
        const auto tooth = buildFileFrame(mesh);
        QVERIFY(tooth);
        QCOMPARE(tooth->report.layersMm3[3] > 1.0, hasPulp);
        const bool told = std::count(tooth->report.warnings.begin(), tooth->report.warnings.end(),
                                     "this scan ends above the pulp: opening it cannot be judged") == 1;
        QCOMPARE(told, !hasPulp);
    }

    void scanOpenAboveIsRefused()
    {
        TriangleMesh mesh = support::box(8.0F, 8.0F, 8.0F);
        mesh.triangles.erase(mesh.triangles.begin() + 2, mesh.triangles.begin() + 4);  // the lid
        QVERIFY(support::isRefused(buildFileFrame(mesh), ErrorCode::BadStructure));
        // Left to guess, the opening is below.
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
        QVERIFY(std::abs(tooth->report.modelVolumeMm3 / whole - 1.0) < 1e-4);
    }

    void undercutOfSeveralShells_data()
    {
        QTest::addColumn<TriangleMesh>("mesh");
        QTest::addColumn<double>("undercut");  // negative: unknown
        const TriangleMesh box = support::box(10.0F, 10.0F, 10.0F);
        const auto at = [](const TriangleMesh& mesh, float x, float y, float z) {
            return support::moved(mesh, {x, y, z});
        };
        const TriangleMesh small = support::box(6.0F, 6.0F, 6.0F);
        QTest::newRow("a hollow") << support::joined(box, at(support::insideOut(small), 2, 2, 2)) << 216.0;
        QTest::newRow("solid in solid") << support::joined(box, at(small, 2, 2, 2)) << 0.0;
        QTest::newRow("one above the other")
            << support::joined(support::box(10.0F, 10.0F, 4.0F), at(support::box(10.0F, 10.0F, 4.0F), 0, 0, 6))
            << 200.0;
        QTest::newRow("beside each other") << support::joined(small, at(small, 7, 0, 0)) << 0.0;
        QTest::newRow("one sunk into the other") << support::joined(box, at(small, 2, 2, 7)) << -1.0;
        QTest::newRow("solid in solid beside a hollow")
            << support::joined(support::joined(box, at(support::box(2.0F, 2.0F, 2.0F), 1, 1, 1)),
                               at(support::insideOut(support::box(2.0F, 2.0F, 2.0F)), 6, 6, 6))
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
            QVERIFY2(std::abs(*tooth->report.undercutMm3 - undercut) < 0.005 * tooth->report.modelVolumeMm3,
                     qPrintable(QString::number(*tooth->report.undercutMm3)));
        const bool warned =
            std::any_of(tooth->report.warnings.begin(), tooth->report.warnings.end(),
                        [](const std::string& w) { return w.find("may overlap") != std::string::npos; });
        QCOMPARE(warned, undercut < 0.0);
    }

    void usableMeshesWarn_data()
    {
        support::columns<TriangleMesh, QString>("mesh", "says");
        const TriangleMesh box = support::box(8.0F, 8.0F, 8.0F);
        QTest::newRow("inside out") << support::insideOut(box) << QStringLiteral("inside out");
        const TriangleMesh one =
            support::joined(box, support::moved(support::box(1.0F, 1.0F, 1.0F), {3.0F, 3.0F, 3.0F}));
        QTest::newRow("a second shell inside")
            << one << QStringLiteral("2 separate shells, one of them inside another;");
        QTest::newRow("two shells inside")
            << support::joined(one, support::moved(support::box(1.0F, 1.0F, 1.0F), {5.0F, 5.0F, 5.0F}))
            << QStringLiteral("3 separate shells, 2 of them inside another;");
        const auto slabs = [](int count) {
            const float pitch = 8.0F / static_cast<float>(count);
            TriangleMesh all;
            for (int k = 0; k < count; ++k)
                all = support::joined(all, support::moved(support::box(8.0F, 8.0F, 0.995F * pitch),
                                                          {0.0F, 0.0F, pitch * static_cast<float>(k)}));
            return all;
        };
        QTest::newRow("a shell over another") << slabs(2) << QStringLiteral("2 separate shells, none of them inside");
        QTest::newRow("more shells than are told apart")
            << slabs(33) << QStringLiteral("33 separate shells; the model");
        TriangleMesh mesh = box;
        mesh.vertices.emplace_back(4.0F, 4.0F, 6.0F);
        mesh.triangles.push_back({4, 5, 8});
        QTest::newRow("non-manifold") << mesh << QStringLiteral("not a manifold");
        mesh = box;
        std::swap(mesh.triangles[3][0], mesh.triangles[3][1]);
        QTest::newRow("faces disagree") << mesh << QStringLiteral("disagree");
        mesh = box;
        mesh.triangles.push_back({1, 1, 2});
        QTest::newRow("zero area") << mesh << QStringLiteral("zero area");
        mesh = support::joined(box, box);
        QTest::newRow("everything twice") << mesh << QStringLiteral("twice");
    }

    void usableMeshesWarn()
    {
        QFETCH(TriangleMesh, mesh);
        QFETCH(QString, says);
        const auto tooth = buildFileFrame(mesh);
        QVERIFY(support::succeeds(tooth));
        const QString warnings = QString::fromStdString(
            std::accumulate(tooth->report.warnings.begin(), tooth->report.warnings.end(), std::string()));
        QVERIFY2(warnings.contains(says), qPrintable(warnings));
        QVERIFY(std::abs(tooth->report.modelVolumeMm3 / 512.0 - 1.0) < 0.005);
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
        const auto tooth = buildFileFrame(mesh);
        QVERIFY(!tooth);
        qInfo("%s", tooth.error().detail.c_str());
        QVERIFY(tooth.error().detail.find("mesh.stl") != std::string::npos);
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
        QCOMPARE(buildTooth({36}, options).error().code, ErrorCode::OutOfRange);
        options.gridSide = 1024;
        QVERIFY(buildTooth({36}, options));
        options.cariesExtent = std::nan("");
        QCOMPARE(buildTooth({36}, options).error().code, ErrorCode::OutOfRange);
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

QTEST_APPLESS_MAIN(TestToothBuilder)
#include "tst_tooth_builder.moc"
