// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <QTest>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/trigonometric.hpp>

#include "core/teeth/ToothGenerator.h"
#include "core/teeth/ToothTable.h"
#include "tests/support/Tables.h"
#include "tests/support/Trials.h"

namespace {

using core::mesh::TriangleMesh;
using core::teeth::ToothSizes;

constexpr float kNothing = -1.0e6F;

/// Highest surface point over a square grid centred on the origin.
struct TopMap
{
    int side = 0;
    double cellMm = 0.0;
    std::vector<float> height;

    [[nodiscard]] float at(int column, int row) const
    {
        if (column < 0 || row < 0 || column >= side || row >= side)
            return kNothing;
        return height[static_cast<std::size_t>(row * side + column)];
    }
    [[nodiscard]] double coordinateMm(int k) const { return (k - 0.5 * (side - 1)) * cellMm; }

    /// Bilinear height; kNothing outside or beside the rim.
    [[nodiscard]] double between(double xMm, double yMm) const
    {
        const double column = xMm / cellMm + 0.5 * (side - 1);
        const double row = yMm / cellMm + 0.5 * (side - 1);
        const int c = static_cast<int>(std::floor(column));
        const int r = static_cast<int>(std::floor(row));
        const double u = column - c;
        const double v = row - r;
        const double a = at(c, r);
        const double b = at(c + 1, r);
        const double d = at(c, r + 1);
        const double e = at(c + 1, r + 1);
        if (std::min({a, b, d, e}) <= kNothing)
            return kNothing;
        return (a * (1.0 - u) + b * u) * (1.0 - v) + (d * (1.0 - u) + e * u) * v;
    }
};

TopMap topMap(const TriangleMesh& mesh, double cellMm)
{
    TopMap map{static_cast<int>(14.0 / cellMm) | 1, cellMm, {}};
    map.height.assign(static_cast<std::size_t>(map.side * map.side), kNothing);
    const double middle = 0.5 * (map.side - 1);
    for (const auto& triangle : mesh.triangles) {
        std::array<glm::dvec3, 3> p;
        for (std::size_t k = 0; k < 3; ++k) {
            p[k] = glm::dvec3(mesh.vertices[triangle[k]]);
            p[k].x = p[k].x / cellMm + middle;
            p[k].y = p[k].y / cellMm + middle;
        }
        const double area = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[2].x - p[0].x) * (p[1].y - p[0].y);
        if (area <= 0.0)
            continue;
        const auto [lowX, highX] = std::minmax({p[0].x, p[1].x, p[2].x});
        const auto [lowY, highY] = std::minmax({p[0].y, p[1].y, p[2].y});
        for (int row = std::max(static_cast<int>(std::ceil(lowY)), 0);
             row <= std::min(static_cast<int>(highY), map.side - 1); ++row) {
            for (int column = std::max(static_cast<int>(std::ceil(lowX)), 0);
                 column <= std::min(static_cast<int>(highX), map.side - 1); ++column) {
                const double v = ((column - p[0].x) * (p[2].y - p[0].y) - (p[2].x - p[0].x) * (row - p[0].y)) / area;
                const double w = ((p[1].x - p[0].x) * (row - p[0].y) - (column - p[0].x) * (p[1].y - p[0].y)) / area;
                if (v < -1.0e-9 || w < -1.0e-9 || v + w > 1.0 + 1.0e-9)
                    continue;
                float& height = map.height[static_cast<std::size_t>(row * map.side + column)];
                height = std::max(height, static_cast<float>(p[0].z + v * (p[1].z - p[0].z) + w * (p[2].z - p[0].z)));
            }
        }
    }
    return map;
}

/// Grey dilation or erosion with a flat disc.
template <class Better>
TopMap morphed(const TopMap& map, double radiusMm, Better better)
{
    TopMap result = map;
    const int reach = static_cast<int>(std::ceil(radiusMm / map.cellMm));
    for (int row = 0; row < map.side; ++row)
        for (int column = 0; column < map.side; ++column) {
            float& best = result.height[static_cast<std::size_t>(row * map.side + column)];
            for (int r = -reach; r <= reach; ++r)
                for (int c = -reach; c <= reach; ++c)
                    if ((r * r + c * c) * map.cellMm * map.cellMm <= radiusMm * radiusMm)
                        best = better(best, map.at(column + c, row + r));
        }
    return result;
}

/// Widened and shrunk again: fills what is narrower than twice the radius, which fissures are and fossae are not.
TopMap closed(const TopMap& map, double radiusMm)
{
    const auto larger = [](float a, float b) { return std::max(a, b); };
    const auto smaller = [](float a, float b) { return std::min(a, b); };
    return morphed(morphed(map, radiusMm, larger), radiusMm, smaller);
}

struct Peak
{
    double xMm = 0.0;
    double yMm = 0.0;
    double heightMm = 0.0;
};

/// Cusps: places higher than all within 0.8 mm, that one must climb down by at least 0.15 mm from to get higher.
std::vector<Peak> cusps(const TopMap& raw)
{
    TopMap map = closed(raw, 0.35);
    // A box blur of 0.3 mm twice: cusps stay, the mesh's facets go.
    const int reach = static_cast<int>(std::lround(0.15 / map.cellMm));
    for (int pass = 0; pass < 2; ++pass) {
        const TopMap before = map;
        for (int row = 0; row < map.side; ++row)
            for (int column = 0; column < map.side; ++column) {
                double sum = 0.0;
                int count = 0;
                for (int r = -reach; r <= reach; ++r)
                    for (int c = -reach; c <= reach; ++c)
                        if (const float h = before.at(column + c, row + r); h > kNothing) {
                            sum += static_cast<double>(h);
                            ++count;
                        }
                float& height = map.height[static_cast<std::size_t>(row * map.side + column)];
                if (height > kNothing)
                    height = static_cast<float>(sum / count);
            }
    }
    // Prominence by flooding: cells from high to low join the peaks they touch; the lower peak of two dies where they
    // meet, and counts if it stood out enough.
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
    std::vector<Peak> peaks;
    const auto keep = [&](std::size_t k) {
        peaks.push_back({map.coordinateMm(static_cast<int>(k) % map.side),
                         map.coordinateMm(static_cast<int>(k) / map.side), static_cast<double>(map.height[k])});
    };
    for (const std::size_t k : order) {
        owner[k] = k;
        for (const int step : {-1, 1, -map.side, map.side}) {
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

double volumeMm3(const TriangleMesh& mesh)
{
    double six = 0.0;
    for (const auto& t : mesh.triangles)
        six += glm::dot(glm::dvec3(mesh.vertices[t[0]]),
                        glm::cross(glm::dvec3(mesh.vertices[t[1]]), glm::dvec3(mesh.vertices[t[2]])));
    return six / 6.0;
}

TriangleMesh tooth(int fdi, std::uint64_t seed)
{
    auto mesh = core::teeth::generateTooth(fdi, seed);
    return mesh ? std::move(*mesh) : TriangleMesh{};
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
    QTest::addColumn<int>("fdi");
    for (const int fdi : {24, 25, 26, 27, 28, 34, 35, 36, 37, 38})
        QTest::newRow(std::to_string(fdi).c_str()) << fdi;
}

// --- scans ---------------------------------------------------------------------------------------------------------

std::filesystem::path scanPath(int fdi)
{
    const char* set = std::getenv("CUSP_SHARED_DATA");
    const std::filesystem::path data =
        set != nullptr ? std::filesystem::path(set) : std::filesystem::path(CUSP_SOURCE_DIR) / ".." / "shared" / "data";
    return data / "teeth" / ("dundee_" + std::to_string(fdi) + ".obj");
}

struct ScanPoint
{
    glm::dvec3 place{0.0};
    glm::dvec3 normal{0.0};
};

/// Vertices and normals of a scan in mm (10.5 mm per unit, SOURCES.md), axes turned to the tooth frame's.
std::vector<ScanPoint> readScan(int fdi)
{
    std::ifstream file(scanPath(fdi));
    std::vector<ScanPoint> points;
    std::string line;
    while (std::getline(file, line)) {
        std::istringstream words(line);
        std::string kind;
        words >> kind;
        if (kind == "v") {
            glm::dvec3 p{0.0};
            words >> p.x >> p.y >> p.z;
            p *= 10.5;
            // Files: +y up, +z anterior, +x the patient's left. Lower teeth stand crown up, upper ones crown down.
            points.push_back({fdi >= 30 ? glm::dvec3{-p.z, -p.x, p.y} : glm::dvec3{-p.z, p.x, -p.y}, glm::dvec3{0.0}});
        } else if (kind == "f") {
            std::vector<std::size_t> corner;
            for (std::string word; words >> word;)
                corner.push_back(std::stoul(word) - 1);
            for (std::size_t k = 2; k < corner.size(); ++k) {
                const glm::dvec3 n = glm::cross(points[corner[k - 1]].place - points[corner[0]].place,
                                                points[corner[k]].place - points[corner[0]].place);
                for (const std::size_t at : {corner[0], corner[k - 1], corner[k]})
                    points[at].normal += n;
            }
        }
    }
    for (ScanPoint& p : points)
        p.normal = glm::normalize(p.normal);
    return points;
}

/// Turn about z, x, y (radians), then shift.
using Pose = std::array<double, 6>;

glm::dvec3 turned(const Pose& q, glm::dvec3 p)
{
    p = {std::cos(q[0]) * p.x - std::sin(q[0]) * p.y, std::sin(q[0]) * p.x + std::cos(q[0]) * p.y, p.z};
    p = {p.x, std::cos(q[1]) * p.y - std::sin(q[1]) * p.z, std::sin(q[1]) * p.y + std::cos(q[1]) * p.z};
    return {std::cos(q[2]) * p.x + std::sin(q[2]) * p.z, p.y, -std::sin(q[2]) * p.x + std::cos(q[2]) * p.z};
}

/// Root mean square of generated minus scanned height over the scan's points that face upwards (within 60 degrees) in
/// the upper part of the crown. Points beyond the generated outline are left out, and their share is told.
double heightRms(const TopMap& map, const std::vector<ScanPoint>& points, const Pose& pose, double downToMm,
                 double& outside)
{
    double sum = 0.0;
    int count = 0;
    int missed = 0;
    for (const ScanPoint& p : points) {
        const glm::dvec3 place = turned(pose, p.place) + glm::dvec3{pose[3], pose[4], pose[5]};
        if (place.z < downToMm || turned(pose, p.normal).z < 0.5)
            continue;
        const double height = map.between(place.x, place.y);
        if (height <= static_cast<double>(kNothing)) {
            ++missed;
            continue;
        }
        sum += (height - place.z) * (height - place.z);
        ++count;
    }
    outside = static_cast<double>(missed) / std::max(count + missed, 1);
    return std::sqrt(sum / std::max(count, 1)) + outside;
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
            std::vector<std::uint64_t> edges;
            edges.reserve(mesh.triangles.size() * 3);
            for (const auto& t : mesh.triangles)
                for (std::size_t k = 0; k < 3; ++k) {
                    QVERIFY(t[k] < mesh.vertices.size());
                    QVERIFY(t[k] != t[(k + 1) % 3]);
                    edges.push_back(std::uint64_t(t[k]) << 32U | t[(k + 1) % 3]);
                }
            std::sort(edges.begin(), edges.end());
            QVERIFY2(std::adjacent_find(edges.begin(), edges.end()) == edges.end(), "an edge is used twice");
            for (const std::uint64_t edge : edges)
                QVERIFY2(std::binary_search(edges.begin(), edges.end(), edge << 32U | edge >> 32U), "the mesh is open");
            for (const glm::vec3& v : mesh.vertices)
                QVERIFY(std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z));
            // Euler's formula for one shell without handles; roots that merely part add none.
            QCOMPARE(static_cast<long>(mesh.vertices.size()) - static_cast<long>(edges.size() / 2) +
                         static_cast<long>(mesh.triangles.size()),
                     2L);
            QVERIFY(volumeMm3(mesh) > 100.0);
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
                const glm::dvec3 a(mesh.vertices[t[0]]);
                const glm::dvec3 b(mesh.vertices[t[1]]);
                const glm::dvec3 c(mesh.vertices[t[2]]);
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
            // The CEJ is where the root steps back under the enamel: faces that look down.
            double ledge = 0.0;
            int faces = 0;
            for (const auto& t : mesh.triangles) {
                const glm::dvec3 a(mesh.vertices[t[0]]);
                const glm::dvec3 b(mesh.vertices[t[1]]);
                const glm::dvec3 c(mesh.vertices[t[2]]);
                const glm::dvec3 centre = (a + b + c) / 3.0;
                const glm::dvec3 normal = glm::normalize(glm::cross(b - a, c - a));
                if (centre.y * facial > 0.3 * sizes.cervixDepthMm && std::abs(centre.x) < 0.4 && normal.z < -0.85 &&
                    centre.z > -1.3 * sizes.crownHeightMm) {
                    ledge += centre.z;
                    ++faces;
                }
            }
            QVERIFY(faces > 0);
            const double width = high.x - low.x;
            const double depth = high.y - low.y;
            const double height = facialTip - ledge / faces;
            qInfo("%d seed %d: MD %.2f of %.2f, BL %.2f of %.2f, crown %.2f of %.2f", fdi, static_cast<int>(seed),
                  width, sizes.crownWidthMm, depth, sizes.crownDepthMm, height, sizes.crownHeightMm);
            QVERIFY(std::abs(width / sizes.crownWidthMm - 1.0) < 0.05);
            QVERIFY(std::abs(depth / sizes.crownDepthMm - 1.0) < 0.05);
            QVERIFY(std::abs(height / sizes.crownHeightMm - 1.0) < 0.05);
            // The origin of the tooth frame.
            QVERIFY(std::abs(high.z) < 1.0e-4);
            QVERIFY(std::abs(low.x + high.x) < 0.02);
            QVERIFY(std::abs(low.y + high.y) < 0.02);
        }
    }

    void hasItsCusps_data()
    {
        support::columns<int, int>("fdi", "count");
        for (const auto& [fdi, count] : {std::pair{23, 1},
                                         {24, 2},
                                         {25, 2},
                                         {26, 4},
                                         {27, 4},
                                         {28, 3},
                                         {33, 1},
                                         {34, 2},
                                         {35, 3},
                                         {36, 5},
                                         {37, 4},
                                         {38, 5}})
            QTest::newRow(std::to_string(fdi).c_str()) << fdi << count;
    }
    void hasItsCusps()
    {
        QFETCH(int, fdi);
        QFETCH(int, count);
        const auto found = cusps(topMap(tooth(fdi, 0), 0.1));
        for (const Peak& peak : found)
            qInfo("%d: cusp at %.1f %.1f, height %.2f", fdi, peak.xMm, peak.yMm, peak.heightMm);
        QCOMPARE(static_cast<int>(found.size()), count);
    }

    void theTallestCuspIsWhereTheBookSays()
    {
        // Buccal on premolars, whichever way the cheek lies; lingual on 36 and 26.
        for (const auto& [fdi, buccal] :
             {std::pair{24, true}, {25, true}, {34, true}, {35, true}, {26, false}, {36, false}}) {
            const auto found = cusps(topMap(tooth(fdi, 0), 0.1));
            const auto tallest = std::max_element(found.begin(), found.end(),
                                                  [](const Peak& a, const Peak& b) { return a.heightMm < b.heightMm; });
            QCOMPARE(tallest->yMm * core::teeth::buccalSign(fdi) > 0.0, buccal);
        }
    }

    void fissuresAreNarrowAndDeep_data() { addPosteriorTeeth(); }
    void fissuresAreNarrowAndDeep()
    {
        QFETCH(int, fdi);
        const TopMap map = topMap(tooth(fdi, 0), 0.05);
        const TopMap filled = closed(map, 0.25);
        double deepest = 0.0;
        int deep = 0;
        for (std::size_t k = 0; k < map.height.size(); ++k)
            if (map.height[k] > kNothing && map.height[k] > -5.0F) {
                const auto depth = static_cast<double>(filled.height[k] - map.height[k]);
                deepest = std::max(deepest, depth);
                deep += depth > 0.25 ? 1 : 0;
            }
        qInfo("%d: deepest fissure %.2f mm, %.1f mm2 deeper than 0.25", fdi, deepest, deep * 0.0025);
        QVERIFY(deepest > 0.4 && deepest < 1.3);
        QVERIFY(deep * 0.0025 > 0.15);
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
        for (const ToothSizes& mean : core::teeth::toothSizes())
            for (std::uint64_t seed = 1; seed < 200; ++seed) {
                const ToothSizes drawn = *core::teeth::drawToothSizes(mean.fdi, seed);
                QVERIFY(std::abs(drawn.crownWidthMm - mean.crownWidthMm) <= 2.0 * core::teeth::kCrownDiameterSdMm);
                QVERIFY(std::abs(drawn.crownDepthMm - mean.crownDepthMm) <= 2.0 * core::teeth::kCrownDiameterSdMm);
                QVERIFY(std::abs(drawn.crownHeightMm - mean.crownHeightMm) <= 2.0 * core::teeth::kCrownHeightSdMm);
                QVERIFY(std::abs(drawn.rootLengthMm - mean.rootLengthMm) <= 2.0 * core::teeth::kRootLengthSdMm);
            }
    }

    void refusesWhatIsNotATooth()
    {
        for (const int fdi : {0, -36, 11, 18, 20, 29, 30, 39, 46, 48, 55, 3636}) {
            const auto mesh = core::teeth::generateTooth(fdi, 0);
            QVERIFY(!mesh.has_value());
            QCOMPARE(mesh.error().code, core::ErrorCode::UnknownName);
            QVERIFY(mesh.error().detail.find(std::to_string(fdi)) != std::string::npos);
            QVERIFY(!core::teeth::drawToothSizes(fdi, 4).has_value());
        }
    }

    void agreesWithTheScan_data()
    {
        support::columns<int, double, double, double, double>("fdi", "turnDeg", "pitchDeg", "rollDeg", "downToMm");
        // How the scan stands in its arch, roughly: the alignment goes on from there.
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
        if (!std::filesystem::exists(scanPath(fdi)))
            QSKIP("The scans are not in shared/data/teeth (or $CUSP_SHARED_DATA): nothing to compare with.");
        std::vector<ScanPoint> points = readScan(fdi);
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

        // Rigid alignment: each of the six in turn, by ever smaller steps, while the rms falls.
        const TopMap map = topMap(tooth(fdi, 0), 0.1);
        double outside = 0.0;
        double best = heightRms(map, points, pose, downToMm, outside);
        // Turns are about the file's origin, so each is joined by the shift that keeps the crown in place.
        for (double step = 0.4; step > 0.004; step *= 0.6)
            for (bool better = true; better;) {
                better = false;
                for (std::size_t k = 0; k < 6; ++k)
                    for (const double way : {step, -step}) {
                        Pose trial = pose;
                        const glm::dvec3 crown = -glm::dvec3{pose[3], pose[4], pose[5]};
                        trial[k] += k < 3 ? way / 5.0 : way;
                        if (k < 3) {
                            // The crown's centre in file axes: undo the old turn by its transpose.
                            const glm::dmat3 old(turned(pose, {1, 0, 0}), turned(pose, {0, 1, 0}),
                                                 turned(pose, {0, 0, 1}));
                            const glm::dvec3 moved = turned(trial, glm::transpose(old) * crown);
                            trial[3] = -moved.x;
                            trial[4] = -moved.y;
                            trial[5] = -moved.z;
                        }
                        if (const double rms = heightRms(map, points, trial, downToMm, outside); rms < best - 1.0e-5) {
                            best = rms;
                            pose = trial;
                            better = true;
                        }
                    }
            }
        best = heightRms(map, points, pose, downToMm, outside);
        qInfo("%d: rms of the occlusal height %.3f mm after rigid alignment, %.1f %% of the scan outside our outline",
              fdi, best - outside, 100.0 * outside);
        QVERIFY(best < 0.5);
    }
};

QTEST_GUILESS_MAIN(TestToothGenerator)
#include "tst_tooth_generator.moc"
