// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include <QTest>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/trigonometric.hpp>

#include "core/mesh/MeshAnalysis.h"
#include "core/mesh/MeshReader.h"
#include "core/teeth/ToothGenerator.h"
#include "core/teeth/ToothTable.h"
#include "core/terrain/Rasteriser.h"
#include "core/terrain/Tooth.h"
#include "tests/support/Checks.h"
#include "tests/support/Scenes.h"
#include "tests/support/Suite.h"
#include "tests/support/Tables.h"
#include "tests/support/ToothMaps.h"
#include "tests/support/Trials.h"

namespace {

using core::mesh::TriangleMesh;
using core::teeth::ToothSizes;

constexpr float kNothing = core::terrain::kEmptyTop;

TriangleMesh tooth(int fdi, std::uint64_t seed)
{
    return core::teeth::generateTooth(fdi, seed).value();
}

std::array<glm::dvec3, 3> cornersOf(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& t)
{
    return {glm::dvec3(mesh.vertices[t[0]]), glm::dvec3(mesh.vertices[t[1]]), glm::dvec3(mesh.vertices[t[2]])};
}

/// The highest surface points on a square grid around the origin.
struct TopMap
{
    core::terrain::Grid grid;
    std::vector<float> height;

    [[nodiscard]] float at(int i, int j) const { return grid.contains(i, j) ? height[grid.index(i, j)] : kNothing; }

    /// Returns the height by bilinear interpolation; kNothing outside the rim or next to it.
    [[nodiscard]] double between(glm::dvec2 placeMm) const
    {
        const glm::dvec2 lattice = grid.latticeOf(placeMm);
        const int i = static_cast<int>(std::floor(lattice.x));
        const int j = static_cast<int>(std::floor(lattice.y));
        const double u = lattice.x - i;
        const double v = lattice.y - j;
        const double a = at(i, j);
        const double b = at(i + 1, j);
        const double d = at(i, j + 1);
        const double e = at(i + 1, j + 1);
        if (std::min({a, b, d, e}) <= kNothing)
            return kNothing;
        return (a * (1.0 - u) + b * u) * (1.0 - v) + (d * (1.0 - u) + e * u) * v;
    }

    /// Returns the map in which each node combines all nodes of a disc around it.
    template <class Combine>
    [[nodiscard]] TopMap morphed(double radiusMm, Combine&& combine) const
    {
        TopMap result = *this;
        const int reach = static_cast<int>(std::ceil(radiusMm / grid.cellMm));
        for (int j = 0; j < grid.side; ++j)
            for (int i = 0; i < grid.side; ++i)
                for (int r = -reach; r <= reach; ++r)
                    for (int c = -reach; c <= reach; ++c)
                        if ((r * r + c * c) * grid.cellMm * grid.cellMm <= radiusMm * radiusMm) {
                            float& best = result.height[grid.index(i, j)];
                            best = combine(best, at(i + c, j + r));
                        }
        return result;
    }

    /// Returns the map dilated and eroded: everything narrower than twice the radius is filled. Fissures are that
    /// narrow, fossae are not.
    [[nodiscard]] TopMap closed(double radiusMm) const
    {
        return morphed(radiusMm, [](float a, float b) { return std::max(a, b); })
            .morphed(radiusMm, [](float a, float b) { return std::min(a, b); });
    }
};

TopMap topMap(const TriangleMesh& mesh, double cellMm)
{
    core::terrain::Grid grid{static_cast<int>(14.0 / cellMm) | 1, cellMm, {}};
    grid.originMm = glm::dvec2(-0.5 * cellMm * (grid.side - 1));
    return {grid, core::terrain::rasterise(mesh, grid).top};
}

/// Returns the cusps with their heights. A cusp is higher than everything within 0.8 mm and has a prominence of at
/// least 0.15 mm.
std::vector<glm::dvec3> cusps(const TopMap& raw)
{
    TopMap map = raw.closed(0.35);
    const core::terrain::Grid& grid = map.grid;
    // Applies a box blur of 0.3 mm twice, which removes the facets of the mesh and keeps the cusps.
    const int reach = static_cast<int>(std::lround(0.15 / grid.cellMm));
    for (int pass = 0; pass < 2; ++pass) {
        const TopMap before = map;
        for (int j = 0; j < grid.side; ++j)
            for (int i = 0; i < grid.side; ++i) {
                double sum = 0.0;
                int count = 0;
                support::eachOf(grid, support::around(grid, i, j, reach), [&](std::size_t k) {
                    if (before.height[k] > kNothing) {
                        sum += static_cast<double>(before.height[k]);
                        ++count;
                    }
                });
                if (float& height = map.height[grid.index(i, j)]; height > kNothing)
                    height = static_cast<float>(sum / count);
            }
    }
    // Computes the prominence by flooding: cells from high to low join the peaks that they touch. Where two peaks meet,
    // the lower one ends, and counts if it was prominent enough.
    std::vector<std::size_t> order;
    for (std::size_t k = 0; k < map.height.size(); ++k)
        if (map.height[k] > kNothing)
            order.push_back(k);
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return map.height[a] > map.height[b]; });
    std::vector<std::size_t> owner(map.height.size(), map.height.size());
    const auto root = [&](std::size_t k) {
        while (owner[k] != k)
            k = owner[k] = owner[owner[k]];
        return k;
    };
    std::vector<glm::dvec3> peaks;
    const auto keep = [&](std::size_t k) { peaks.emplace_back(grid.nodeMm(k), static_cast<double>(map.height[k])); };
    for (const std::size_t k : order) {
        owner[k] = k;
        for (const int step : {-1, 1, -grid.side, grid.side}) {
            const auto next = static_cast<std::size_t>(static_cast<int>(k) + step);
            if (next >= owner.size() || owner[next] == owner.size())
                continue;
            std::size_t a = root(k);
            std::size_t b = root(next);
            if (a == b)
                continue;
            if (map.height[a] < map.height[b])
                std::swap(a, b);
            if (map.height[b] - map.height[k] > 0.15F)
                keep(b);
            owner[b] = a;
        }
    }
    if (!order.empty())
        keep(order.front());
    return peaks;
}

void addTeeth()
{
    QTest::addColumn<int>("fdi");
    for (int n = 0; const ToothSizes& sizes : core::teeth::toothSizes())
        if (support::isTried(n++))
            QTest::newRow(std::to_string(sizes.fdi).c_str()) << sizes.fdi;
}

void addPosteriorTeeth()
{
    support::rows<int>("fdi", {24, 25, 26, 27, 28, 34, 35, 36, 37, 38});
}

// --- scans ---------------------------------------------------------------------------------------------------------

struct ScanPoint
{
    glm::dvec3 place{0.0};
    glm::dvec3 normal{0.0};
};

/// Returns vertices and normals of a scan in mm (10.5 mm per unit), in the axes of the tooth frame.
std::vector<ScanPoint> readScan(const std::string& path, int fdi)
{
    const TriangleMesh mesh = core::mesh::readMesh(std::filesystem::path(path)).value().mesh;
    std::vector<ScanPoint> points;
    for (const glm::vec3& vertex : mesh.vertices) {
        const glm::dvec3 p = 10.5 * glm::dvec3(vertex);
        // The axes of the files are: +y up, +z anterior, +x to the patient's left. Lower teeth have their crown up,
        // upper ones down.
        points.push_back({fdi >= 30 ? glm::dvec3{-p.z, -p.x, p.y} : glm::dvec3{-p.z, p.x, -p.y}, glm::dvec3{0.0}});
    }
    for (const auto& t : mesh.triangles)
        for (const std::uint32_t at : t)
            points[at].normal +=
                glm::cross(points[t[1]].place - points[t[0]].place, points[t[2]].place - points[t[0]].place);
    for (ScanPoint& p : points)
        p.normal = glm::normalize(p.normal);
    return points;
}

/// Rotations about z, x and y (radians), then a shift.
using Pose = std::array<double, 6>;

glm::dvec3 turned(const Pose& q, glm::dvec3 p)
{
    p = {std::cos(q[0]) * p.x - std::sin(q[0]) * p.y, std::sin(q[0]) * p.x + std::cos(q[0]) * p.y, p.z};
    p = {p.x, std::cos(q[1]) * p.y - std::sin(q[1]) * p.z, std::sin(q[1]) * p.y + std::cos(q[1]) * p.z};
    return {std::cos(q[2]) * p.x + std::sin(q[2]) * p.z, p.y, -std::sin(q[2]) * p.x + std::cos(q[2]) * p.z};
}

/// Returns the root mean square of generated minus scanned height over the scan's points that face upwards (within 60
/// degrees) in the upper part of the crown. Points beyond the generated outline are left out, and their share is added.
double heightRms(const TopMap& map, const std::vector<ScanPoint>& points, const Pose& pose, double downToMm)
{
    double sum = 0.0;
    int count = 0;
    int missed = 0;
    for (const ScanPoint& p : points) {
        const glm::dvec3 place = turned(pose, p.place) + glm::dvec3{pose[3], pose[4], pose[5]};
        if (place.z < downToMm || turned(pose, p.normal).z < 0.5)
            continue;
        const double height = map.between(glm::dvec2(place));
        if (height <= static_cast<double>(kNothing)) {
            ++missed;
            continue;
        }
        sum += (height - place.z) * (height - place.z);
        ++count;
    }
    return std::sqrt(sum / std::max(count, 1)) + static_cast<double>(missed) / std::max(count + missed, 1);
}

}  // namespace

class TestToothGenerator : public QObject
{
    Q_OBJECT
private slots:
    void isClosedManifoldAndOutward_data() { addTeeth(); }
    void isClosedManifoldAndOutward()
    {
        QFETCH(int, fdi);
        for (const std::uint64_t seed : {0ULL, 1ULL, 2ULL, 77ULL, 0xFFFFFFFFFFFFFFFFULL}) {
            const TriangleMesh mesh = tooth(fdi, seed);
            QVERIFY(mesh.triangles.size() > 40000 && mesh.triangles.size() < 120000);
            for (const auto& t : mesh.triangles)
                QVERIFY(std::max({t[0], t[1], t[2]}) < mesh.vertices.size());
            for (const glm::vec3& v : mesh.vertices)
                QVERIFY(std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z));
            const core::mesh::MeshFacts facts = core::mesh::analyse(mesh);
            QVERIFY(facts.closed && facts.oriented);
            QCOMPARE(facts.collapsedFaces, 0U);
            QCOMPARE(facts.shells.size(), 1U);
            // Euler's formula for one shell without handles, with three edges to two faces. Roots that only part add no
            // handles.
            QCOMPARE(2 * mesh.vertices.size(), 4 + mesh.triangles.size());
            QVERIFY(facts.volume > 100.0);
        }
    }

    void theOcclusalSurfaceHasNoFolds_data() { addPosteriorTeeth(); }
    void theOcclusalSurfaceHasNoFolds()
    {
        QFETCH(int, fdi);
        for (const std::uint64_t seed : {0ULL, 3ULL, 4ULL, 5ULL, 6ULL}) {
            const ToothSizes sizes = *core::teeth::drawToothSizes(fdi, seed);
            const TriangleMesh mesh = tooth(fdi, seed);
            for (const auto& t : mesh.triangles) {
                const auto [a, b, c] = cornersOf(mesh, t);
                const glm::dvec2 inside{a.x / sizes.crownWidthMm, a.y / sizes.crownDepthMm};
                if (a.z > -0.5 * sizes.crownHeightMm && glm::dot(inside, inside) < 0.35 * 0.35)
                    QVERIFY(glm::cross(b - a, c - a).z > -1.0e-6);
            }
        }
    }

    void crownMeasuresAsTheTableSays_data() { addTeeth(); }
    void crownMeasuresAsTheTableSays()
    {
        QFETCH(int, fdi);
        for (const std::uint64_t seed : {0ULL, 5ULL}) {
            const ToothSizes sizes = *core::teeth::drawToothSizes(fdi, seed);
            const TriangleMesh mesh = tooth(fdi, seed);
            const double facial = core::teeth::buccalSign(fdi);
            glm::dvec3 low{1.0e9};
            glm::dvec3 high{-1.0e9};
            double facialTip = -1.0e9;
            for (const glm::vec3& vertex : mesh.vertices) {
                const glm::dvec3 v(vertex);
                if (v.z < -0.85 * sizes.crownHeightMm)
                    continue;
                low = glm::min(low, v);
                high = glm::max(high, v);
                if (v.y * facial > 0.0 || fdi % 10 <= 3)
                    facialTip = std::max(facialTip, v.z);
            }
            // The CEJ is where the root steps back under the enamel: at faces that point down.
            double ledge = 0.0;
            int faces = 0;
            for (const auto& t : mesh.triangles) {
                const auto [a, b, c] = cornersOf(mesh, t);
                const glm::dvec3 centre = (a + b + c) / 3.0;
                const glm::dvec3 normal = glm::normalize(glm::cross(b - a, c - a));
                if (centre.y * facial > 0.3 * sizes.cervixDepthMm && std::abs(centre.x) < 0.4 && normal.z < -0.85 &&
                    centre.z > -1.3 * sizes.crownHeightMm) {
                    ledge += centre.z;
                    ++faces;
                }
            }
            QVERIFY(faces > 0);
            QVERIFY(support::near((high.x - low.x) / sizes.crownWidthMm, 1.0, 0.05));
            QVERIFY(support::near((high.y - low.y) / sizes.crownDepthMm, 1.0, 0.05));
            QVERIFY(support::near((facialTip - ledge / faces) / sizes.crownHeightMm, 1.0, 0.05));
            // The surface is centred on the origin of the tooth frame.
            QVERIFY(support::near(high.z, 0.0, 1.0e-4));
            QVERIFY(support::near(low.x + high.x, 0.0, 0.02));
            QVERIFY(support::near(low.y + high.y, 0.0, 0.02));
        }
    }

    void hasItsCusps_data()
    {
        // The tallest cusp is buccal on premolars, on whichever side the cheek is, and lingual on 36 and 26.
        support::columns<int, int, QString>("fdi", "count", "tallest");
        for (const auto& [fdi, count, tallest] : {std::tuple(23, 1, ""),
                                                  {24, 2, "buccal"},
                                                  {25, 2, "buccal"},
                                                  {26, 4, "lingual"},
                                                  {27, 4, ""},
                                                  {28, 3, ""},
                                                  {33, 1, ""},
                                                  {34, 2, "buccal"},
                                                  {35, 3, "buccal"},
                                                  {36, 5, "lingual"},
                                                  {37, 4, ""},
                                                  {38, 5, ""}})
            QTest::addRow("%d", fdi) << fdi << count << tallest;
    }
    void hasItsCusps()
    {
        QFETCH(int, fdi);
        QFETCH(int, count);
        QFETCH(QString, tallest);
        const auto found = cusps(topMap(tooth(fdi, 0), 0.1));
        QCOMPARE(static_cast<int>(found.size()), count);
        const auto highest =
            std::max_element(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.z < b.z; });
        if (!tallest.isEmpty())
            QCOMPARE(highest->y * core::teeth::buccalSign(fdi) > 0.0, tallest == "buccal");
    }

    void fissuresAreNarrowAndDeep_data() { addPosteriorTeeth(); }
    void fissuresAreNarrowAndDeep()
    {
        QFETCH(int, fdi);
        const TopMap map = topMap(tooth(fdi, 0), 0.05);
        const TopMap filled = map.closed(0.25);
        double deepest = 0.0;
        int deep = 0;
        for (std::size_t k = 0; k < map.height.size(); ++k)
            if (map.height[k] > -5.0F) {
                const auto depth = static_cast<double>(filled.height[k] - map.height[k]);
                deepest = std::max(deepest, depth);
                deep += depth > 0.25 ? 1 : 0;
            }
        QVERIFY2(deepest > 0.4 && deepest < 1.3, qPrintable(QString::number(deepest)));
        QVERIFY2(deep * 0.0025 > 0.15, qPrintable(QString::number(deep)));
    }

    void sameSeedSameBytes()
    {
        for (const ToothSizes& sizes : core::teeth::toothSizes()) {
            const TriangleMesh a = tooth(sizes.fdi, 9);
            const TriangleMesh b = tooth(sizes.fdi, 9);
            QVERIFY(a.triangles == b.triangles);
            QCOMPARE(a.vertices.size(), b.vertices.size());
            QCOMPARE(std::memcmp(a.vertices.data(), b.vertices.data(), a.vertices.size() * sizeof(glm::vec3)), 0);
        }
    }

    void anotherSeedIsAnotherToothOfTheSameKind_data() { addTeeth(); }
    void anotherSeedIsAnotherToothOfTheSameKind()
    {
        QFETCH(int, fdi);
        const TopMap mean = topMap(tooth(fdi, 0), 0.2);
        for (const std::uint64_t seed : {1ULL, 2ULL, 3ULL}) {
            const TopMap other = topMap(tooth(fdi, seed), 0.2);
            double sum = 0.0;
            int count = 0;
            for (std::size_t k = 0; k < mean.height.size(); ++k)
                if (mean.height[k] > -3.0F && other.height[k] > -3.0F) {
                    sum += std::abs(static_cast<double>(mean.height[k] - other.height[k]));
                    ++count;
                }
            QVERIFY(sum / count > 0.02);
            QVERIFY(sum / count < 1.0);
        }
    }

    void drawnSizesStayInTheSpread()
    {
        using namespace core::teeth;
        const std::pair<double ToothSizes::*, double> spreads[]{{&ToothSizes::crownWidthMm, kCrownDiameterSdMm},
                                                                {&ToothSizes::crownDepthMm, kCrownDiameterSdMm},
                                                                {&ToothSizes::crownHeightMm, kCrownHeightSdMm},
                                                                {&ToothSizes::rootLengthMm, kRootLengthSdMm}};
        for (const ToothSizes& mean : toothSizes())
            for (std::uint64_t seed = 1; seed < 200; ++seed)
                for (const auto& [size, spread] : spreads)
                    QVERIFY(support::near((*drawToothSizes(mean.fdi, seed)).*size, mean.*size, 2.0 * spread));
    }

    void refusesWhatIsNotATooth()
    {
        for (const int fdi : {0, -36, 11, 18, 20, 29, 30, 39, 46, 48, 55, 3636}) {
            const auto mesh = core::teeth::generateTooth(fdi, 0);
            QVERIFY(support::isRefused(mesh, core::ErrorCode::UnknownName));
            QVERIFY(support::isRefused(mesh, std::to_string(fdi)));
            QVERIFY(!core::teeth::drawToothSizes(fdi, 4).has_value());
        }
    }

    void agreesWithTheScan_data()
    {
        support::columns<int, double, double, double, double>("fdi", "turnDeg", "pitchDeg", "rollDeg", "downToMm");
        // The approximate pose of the scan in its arch, from which the alignment starts.
        QTest::newRow("36") << 36 << 20.0 << 0.0 << 6.0 << -5.0;
        QTest::newRow("24") << 24 << -5.0 << 0.0 << 0.0 << -5.0;
        QTest::newRow("21") << 21 << -80.0 << 12.0 << -2.0 << -9.0;
    }
    void agreesWithTheScan()
    {
        QFETCH(int, fdi);
        QFETCH(double, turnDeg);
        QFETCH(double, pitchDeg);
        QFETCH(double, rollDeg);
        QFETCH(double, downToMm);
        const std::string path = support::sharedData("teeth/dundee_" + std::to_string(fdi) + ".obj");
        if (path.empty())
            QSKIP("The scans are not in shared/data/teeth (or $CUSP_SHARED_DATA): nothing to compare with.");
        const std::vector<ScanPoint> points = readScan(path, fdi);
        Pose pose{glm::radians(turnDeg), glm::radians(pitchDeg), glm::radians(rollDeg), 0.0, 0.0, 0.0};
        glm::dvec3 low{1.0e9};
        glm::dvec3 high{-1.0e9};
        for (const ScanPoint& p : points)
            high.z = std::max(high.z, turned(pose, p.place).z);
        for (const ScanPoint& p : points)
            if (const glm::dvec3 v = turned(pose, p.place); v.z > high.z + downToMm) {
                low = glm::min(low, v);
                high = glm::max(high, v);
            }
        pose[3] = -0.5 * (low.x + high.x);
        pose[4] = -0.5 * (low.y + high.y);
        pose[5] = -high.z;

        // Rigid alignment: changes each of the six parameters in turn, by ever smaller steps, as long as the rms
        // decreases.
        const TopMap map = topMap(tooth(fdi, 0), 0.1);
        double best = heightRms(map, points, pose, downToMm);
        // Rotations are about the origin of the file, so each is combined with the shift that keeps the crown in place.
        for (double step = 0.4; step > 0.004; step *= 0.6)
            for (bool better = true; better;) {
                better = false;
                for (std::size_t k = 0; k < 6; ++k)
                    for (const double way : {step, -step}) {
                        Pose trial = pose;
                        const glm::dvec3 crown = -glm::dvec3{pose[3], pose[4], pose[5]};
                        trial[k] += k < 3 ? way / 5.0 : way;
                        if (k < 3) {
                            // The centre of the crown in the axes of the file: undoes the old rotation by its
                            // transpose.
                            const glm::dmat3 old(turned(pose, {1, 0, 0}), turned(pose, {0, 1, 0}),
                                                 turned(pose, {0, 0, 1}));
                            const glm::dvec3 moved = turned(trial, glm::transpose(old) * crown);
                            trial[3] = -moved.x;
                            trial[4] = -moved.y;
                            trial[5] = -moved.z;
                        }
                        if (const double rms = heightRms(map, points, trial, downToMm); rms < best - 1.0e-5) {
                            best = rms;
                            pose = trial;
                            better = true;
                        }
                    }
            }
        QVERIFY2(best < 0.5, qPrintable(QString::number(best)));
    }
};

CUSP_TEST(TestToothGenerator)
#include "tst_tooth_generator.moc"
