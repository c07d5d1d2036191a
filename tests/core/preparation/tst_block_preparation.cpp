// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "core/base/Rng.h"
#include "core/preparation/AxisRegion.h"
#include "core/preparation/BlockPreparation.h"
#include "core/teeth/ToothBuilder.h"
#include "tests/support/Checks.h"
#include "tests/support/Suite.h"
#include "tests/support/SyntheticTooth.h"
#include "tests/support/Tables.h"

using namespace core;
using namespace core::preparation;
using grading::Part;
using support::kPi;
using teeth::BlockDesign;
using teeth::BlockShape;

namespace {

BlockDesign designOf(BlockShape shape)
{
    BlockDesign design;
    design.shape = shape;
    return design;
}

struct Sum
{
    double areaMm2 = 0.0;    ///< of the cut columns
    double volumeMm3 = 0.0;  ///< of the cut columns
};

Sum sumOf(const Block& block)
{
    Sum sum;
    for (std::size_t k = 0; k < block.ideal.parts.size(); ++k)
        if (block.ideal.parts[k] != Part::Keep) {
            const auto area = static_cast<double>(block.anatomy->areaMm2[k]);
            sum.areaMm2 += area;
            sum.volumeMm3 += area * static_cast<double>(block.anatomy->top[k] - (*block.ideal.top)[k]);
        }
    return sum;
}

/// Area and total edge length of a channel, from the dimensions of the shape.
struct Expected
{
    double areaMm2 = 0.0;
    double edgeMm = 0.0;
};

/// Computes the values from the dimensions of a design. Inner corners are round, outer corners sharp.
Expected expectedOf(const BlockDesign& d)
{
    const double w = d.widthMm;
    const double l = d.lengthMm;
    const double r = d.cornerRadiusMm;
    const double corner = (1.0 - kPi / 4.0) * r * r;  // area that rounding removes from a right angle
    const double shorter = 2.0 * r - kPi / 2.0 * r;   // and the edge length that it removes
    const double end = 0.5 * l - r;
    const double inside = 0.5 * w - r;
    switch (d.shape) {
    case BlockShape::Line:
        return {l * w - 4.0 * corner, 2.0 * (l + w) - 4.0 * shorter};
    case BlockShape::Circle:
        return {kPi * (l - w) * w, 2.0 * kPi * (l - w)};
    case BlockShape::Cross:
        return {2.0 * l * w - w * w - 8.0 * corner, 4.0 * l - 8.0 * shorter};
    case BlockShape::Square:
        return {l * l - (l - 2.0 * w) * (l - 2.0 * w) - 4.0 * corner, 4.0 * l + 4.0 * (l - 2.0 * w) - 4.0 * shorter};
    case BlockShape::Dovetail: {
        // The region of the axis dilated by r (Steiner's formula). At the four bends into the neck two strips overlap.
        const double slant = std::hypot(w, d.flareMm);
        const double bend = std::atan2(d.flareMm, w);
        const double area = 2.0 * inside * 2.0 * end + 2.0 * d.flareMm * w;
        const double edge = 2.0 * 2.0 * (inside + d.flareMm) + 4.0 * slant + 4.0 * (end - w);
        const double outward = 2.0 * kPi + 4.0 * bend;
        return {area + edge * r + 0.5 * outward * r * r - 4.0 * r * r * std::tan(0.5 * bend),
                edge + outward * r - 8.0 * r * std::tan(0.5 * bend)};
    }
    case BlockShape::Bar: {
        const double across = end + 2.0 * r;  // the bars go from -end/2 - r to end/2 + r
        return {l * w + 2.0 * w * (across - w) - 8.0 * corner, 2.0 * l + 4.0 * across - 2.0 * w - 8.0 * shorter};
    }
    case BlockShape::Tee:
        return {2.0 * l * w - w * w - 6.0 * corner, 4.0 * l - 6.0 * shorter};
    default:
        return {};
    }
}

}  // namespace

class TestBlockPreparation : public QObject
{
    Q_OBJECT

private slots:
    void namesAreKnown()
    {
        for (int k = 0; k <= static_cast<int>(BlockShape::Junction); ++k) {
            const auto shape = static_cast<BlockShape>(k);
            const std::string name = teeth::blockName(shape);
            const teeth::ToothSource source = teeth::parseSource(name);
            QVERIFY(std::holds_alternative<BlockDesign>(source.what));
            const auto built = teeth::buildTooth(source, {});
            QVERIFY(built);
            QCOMPARE(built->anatomy->name, name);
            QCOMPARE(built->anatomy->fdi, 0);
            QVERIFY(!teeth::isGenerated(*built->anatomy));
            QVERIFY(built->report.closed && built->report.warnings.empty());
        }
        const auto odd = teeth::buildTooth(teeth::parseSource("block:spiral"), {});
        QVERIFY(support::isRefused(odd, ErrorCode::UnknownName));
        QVERIFY(support::isRefused(odd, "block:cross"));
        // A shape that does not match its block must be refused.
        const auto tooth = teeth::buildTooth({36}, {});
        QVERIFY(!blockPreparation({}, *tooth->anatomy));
    }

    void blockIsASlabOfTwoLayers()
    {
        for (const int side : {64, 150, 1024}) {
            const auto block = makeBlock({}, side);
            QVERIFY(block);
            const terrain::PerMaterial volumes = terrain::volumes(terrain::Tooth(block->anatomy));
            QVERIFY(std::abs(volumes[1] - 14.0 * 14.0 * 1.0) < 1e-3);
            QVERIFY(std::abs(volumes[2] - 14.0 * 14.0 * 7.0) < 1e-3);
            QCOMPARE(volumes[0], 0.0);
            QCOMPARE(volumes[3], 0.0);
            for (std::size_t k = 0; k < block->anatomy->top.size(); ++k)
                if (block->anatomy->top[k] > block->anatomy->bottom[k])
                    QVERIFY(block->anatomy->top[k] == 0.0F && block->anatomy->bottom[k] == -8.0F);
        }
    }

    void shapeHoldsWhatItsFiguresSay_data()
    {
        support::columns<int, int>("shape", "side");
        for (int k = 0; k <= static_cast<int>(BlockShape::Tee); ++k)
            if (static_cast<BlockShape>(k) != BlockShape::Staircase)
                for (const int side : {150, 400, 1024}) {
                    const QString name = QString::fromStdString(teeth::blockName(static_cast<BlockShape>(k)));
                    QTest::addRow("%s at %d", qPrintable(name), side) << k << side;
                }
    }

    /// A column is cut or not, so an edge along the lattice may be off by half a cell.
    void shapeHoldsWhatItsFiguresSay()
    {
        QFETCH(int, shape);
        QFETCH(int, side);
        const BlockDesign design = designOf(static_cast<BlockShape>(shape));
        const auto block = makeBlock(design, side);
        QVERIFY(block);
        const Sum sum = sumOf(*block);
        const Expected expected = expectedOf(design);
        const double slackMm2 = 0.5 * block->anatomy->grid.cellMm * expected.edgeMm;
        QVERIFY(support::near(sum.areaMm2, expected.areaMm2, slackMm2));
        // The rounded edge between floor and wall leaves (1 - pi/4) c^2 per mm, slightly less where the wall bends.
        const double c = design.lineAngleMm;
        const double volume = expected.areaMm2 * design.depthMm - expected.edgeMm * (1.0 - kPi / 4.0) * c * c;
        const double slackMm3 = slackMm2 * design.depthMm + 0.02 * c * c * expected.edgeMm;
        QVERIFY(support::near(sum.volumeMm3, volume, slackMm3));
    }

    void staircaseHasItsSteps()
    {
        BlockDesign design = designOf(BlockShape::Staircase);
        design.depthMm = 2.0;
        const auto block = makeBlock(design, 300);
        QVERIFY(block);
        for (int step = 0; step < 4; ++step)
            // Checks the middle of each step, and just after the riser that leads down to it.
            for (const double share : {0.5, 0.15}) {
                const double x = -4.5 + (step + share) * 9.0 / 4.0;
                const std::size_t k = support::nodeAt(block->anatomy->grid, {x, 0.0});
                QVERIFY(support::near(static_cast<double>((*block->ideal.top)[k]), -0.5 * (step + 1), 1e-6));
                QVERIFY(block->ideal.parts[k] == Part::Floor);
            }
    }

    void eachPitIsAsDeepAsItSays()
    {
        BlockDesign design = designOf(BlockShape::Plunges);
        design.depthMm = 2.0;
        design.widthMm = 1.4;
        const auto block = makeBlock(design, 300);
        QVERIFY(block);
        const std::vector<teeth::Pit> pits = teeth::pitsOf(design);
        QCOMPARE(pits.size(), std::size_t{4});
        double volumeMm3 = 0.0;
        const double c = design.lineAngleMm;
        for (std::size_t n = 0; n < pits.size(); ++n) {
            QVERIFY(support::near(pits[n].depthMm, 0.5 * static_cast<double>(n + 1), 1e-9));
            const std::size_t k = support::nodeAt(block->anatomy->grid, {pits[n].xMm, 0.0});
            QVERIFY(support::near(static_cast<double>((*block->ideal.top)[k]), -pits[n].depthMm, 1e-6));
            QVERIFY(block->ideal.parts[k] == Part::Floor);
            // The rounded edge leaves (1 - pi/4) c^2 along a circle slightly smaller than the pit.
            volumeMm3 += kPi * 0.7 * 0.7 * pits[n].depthMm - 2.0 * kPi * (0.7 - 0.22 * c) * (1.0 - kPi / 4.0) * c * c;
        }
        const double slack = 0.5 * block->anatomy->grid.cellMm * 2.0 * kPi * 0.7 * 5.0;
        QVERIFY(support::near(sumOf(*block).volumeMm3, volumeMm3, slack));
    }

    void floorOfAJunctionIsTheJunction()
    {
        BlockDesign design = designOf(BlockShape::Junction);
        design.enamelMm = 0.8;
        design.depthMm = 1.8;
        design.lengthMm = 5.0;
        design.widthMm = 4.0;
        std::vector<float> before;
        for (const std::uint64_t seed : {0U, 1U, 2U, 77U}) {
            const auto block = makeBlock(design, 200, seed);
            QVERIFY(block);
            const terrain::ToothAnatomy& anatomy = *block->anatomy;
            double thinnestMm = 9.0;
            double thickestMm = 0.0;
            double floorMm2 = 0.0;
            std::vector<float> floors;
            for (std::size_t k = 0; k < block->ideal.parts.size(); ++k) {
                if (block->ideal.parts[k] != Part::Floor)
                    continue;
                const float floor = (*block->ideal.top)[k];
                QCOMPARE(floor, anatomy.layers[k].dej);
                QVERIFY(terrain::materialAt(anatomy.layers[k], floor + 0.01F) == terrain::Material::Enamel);
                QVERIFY(terrain::materialAt(anatomy.layers[k], floor - 0.01F) == terrain::Material::Dentin);
                thinnestMm = std::min(thinnestMm, -static_cast<double>(floor));
                thickestMm = std::max(thickestMm, -static_cast<double>(floor));
                floorMm2 += static_cast<double>(anatomy.areaMm2[k]);
                floors.push_back(floor);
            }
            // The outermost edge of the window is a wall.
            QVERIFY(thinnestMm >= 0.8 - 1e-6 && thinnestMm < 0.95);
            QVERIFY(thickestMm <= 1.8 + 1e-6 && thickestMm > 1.65);
            QVERIFY(floorMm2 > 0.8 * 5.0 * 4.0);
            QVERIFY(floors != before);
            before = floors;
        }
    }

    void floorAndWallsAreTold()
    {
        const auto block = makeBlock(designOf(BlockShape::Cross), 300);
        QVERIFY(block);
        for (std::size_t k = 0; k < block->ideal.parts.size(); ++k) {
            const float ideal = (*block->ideal.top)[k];
            switch (block->ideal.parts[k]) {
            case Part::Keep:
                QCOMPARE(ideal, block->anatomy->top[k]);
                break;
            case Part::Floor:
                QCOMPARE(ideal, -1.5F);
                break;
            case Part::Wall:
                QVERIFY(ideal > -1.5F && ideal <= -1.3F);
            }
        }
        const auto line = makeBlock(designOf(BlockShape::Line));
        QVERIFY(line && line->ideal.isthmus && line->ideal.isthmus->across == glm::dvec2(0.0, 1.0));
        QVERIFY(!makeBlock(designOf(BlockShape::Circle))->ideal.isthmus);
    }

    void everyColumnIsInReachOfTheBur_data()
    {
        QTest::addColumn<int>("shape");
        for (int k = 0; k <= static_cast<int>(BlockShape::Junction); ++k)
            if (static_cast<BlockShape>(k) != BlockShape::Layers)
                QTest::newRow(teeth::blockName(static_cast<BlockShape>(k)).c_str()) << k;
    }

    /// Every cut column is in a disc of the bur's radius within the shape. Discs are tried at nodes only, so the right
    /// one may be missed by up to a cell.
    void everyColumnIsInReachOfTheBur()
    {
        QFETCH(int, shape);
        const BlockDesign design = designOf(static_cast<BlockShape>(shape));
        const auto block = makeBlock(design, 400);
        QVERIFY(block);
        const terrain::Grid& grid = block->anatomy->grid;
        const int reach = static_cast<int>(design.cornerRadiusMm / grid.cellMm) + 1;
        const auto isWithin = [&](int di, int dj, double cells) {
            return std::hypot(di, dj) * grid.cellMm <= design.cornerRadiusMm + cells * grid.cellMm;
        };
        std::vector<std::uint8_t> reached(grid.count(), 0);
        for (int j = reach; j < grid.side - reach; ++j)
            for (int i = reach; i < grid.side - reach; ++i) {
                bool fits = true;
                for (int dj = -reach; fits && dj <= reach; ++dj)
                    for (int di = -reach; fits && di <= reach; ++di)
                        fits = !isWithin(di, dj, -0.75) || block->ideal.parts[grid.index(i + di, j + dj)] != Part::Keep;
                for (int dj = -reach; fits && dj <= reach; ++dj)
                    for (int di = -reach; di <= reach; ++di)
                        if (isWithin(di, dj, 0.75))
                            reached[grid.index(i + di, j + dj)] = 1;
            }
        for (std::size_t k = 0; k < reached.size(); ++k)
            QVERIFY(block->ideal.parts[k] == Part::Keep || reached[k] != 0);
    }

    void shapeIsTheSameOnEveryGrid()
    {
        for (int shape = 0; shape <= static_cast<int>(BlockShape::Junction); ++shape) {
            if (static_cast<BlockShape>(shape) == BlockShape::Layers)
                continue;
            const BlockDesign design = designOf(static_cast<BlockShape>(shape));
            const Sum fine = sumOf(*makeBlock(design, 1024));
            const Sum coarse = sumOf(*makeBlock(design, 150));
            QVERIFY(std::abs(coarse.areaMm2 / fine.areaMm2 - 1.0) < 0.05);
        }
    }

    void padsAreOfThreeMaterials()
    {
        std::set<std::array<terrain::Material, 3>> orders;
        for (std::uint64_t seed = 0; seed < 40; ++seed)
            orders.insert(teeth::padMaterials(seed));
        QCOMPARE(orders.size(), std::size_t{6});
        for (std::uint64_t seed = 0; seed < 4; ++seed) {
            const auto block = makeBlock(designOf(BlockShape::Layers), 150, seed);
            QVERIFY(block);
            const terrain::ToothAnatomy& anatomy = *block->anatomy;
            for (std::size_t pad = 0; pad < 3; ++pad) {
                const std::size_t k = support::nodeAt(anatomy.grid, {teeth::kPadX.at(pad), 0.0});
                QCOMPARE(anatomy.top[k], 0.0F);
                for (const float z : {0.0F, -1.0F, -2.5F})
                    QVERIFY(terrain::materialAt(anatomy.layers[k], z) == teeth::padMaterials(seed).at(pad));
            }
            QCOMPARE(sumOf(*block).volumeMm3, 0.0);
        }
    }

    void distancesAgreeWithBruteForce()
    {
        constexpr std::uint64_t kSeed = 11;
        Rng rng(kSeed);
        AxisRegion region;
        const std::vector<glm::dvec2> corners{{-1.0, -0.5}, {1.5, -1.0}, {1.0, 0.7}, {-0.8, 0.6}};
        region.addPolygon(corners);
        region.addRing({0.5, 0.5}, 2.0, 0.1);
        region.addPolygon({{-3.0, 0.0}, {-2.0, 2.0}});
        const auto isIn = [&](glm::dvec2 p) {
            bool in = true;
            for (std::size_t k = 0; k < 4; ++k) {
                const glm::dvec2 along = corners[(k + 1) % 4] - corners[k];
                in = in && along.x * (p.y - corners[k].y) - along.y * (p.x - corners[k].x) >= 0.0;
            }
            return in || std::abs(std::hypot(p.x - 0.5, p.y - 0.5) - 2.0) <= 0.1;
        };
        for (int k = 0; k < 60; ++k) {
            const glm::dvec2 p{rng.uniform(-4.0, 4.0), rng.uniform(-4.0, 4.0)};
            double nearest = std::numeric_limits<double>::max();
            for (int a = 0; a <= 400; ++a)
                for (int b = 0; b <= 400; ++b) {
                    const glm::dvec2 q{-4.0 + 0.02 * a, -4.0 + 0.02 * b};
                    if (isIn(q))
                        nearest = std::min(nearest, std::hypot(p.x - q.x, p.y - q.y));
                }
            for (int a = 0; a <= 1000; ++a)
                nearest = std::min(nearest, std::hypot(p.x + 3.0 - 0.001 * a, p.y - 0.002 * a));
            // The nearest point may be between the sampled points, at most a diagonal of the sampling further.
            QVERIFY(std::abs(region.distance(p) - nearest) < 0.02 * std::numbers::sqrt2);
        }
    }

    void impossibleDesignsAreRefused()
    {
        const auto isRefused = [](const char* names, BlockShape shape, double BlockDesign::*value, double figure) {
            BlockDesign design = designOf(shape);
            design.*value = figure;
            return support::isRefused(makeBlock(design), names);
        };
        QVERIFY(isRefused("side_mm", BlockShape::Line, &BlockDesign::sideMm, 2.0));
        QVERIFY(isRefused("enamel_mm", BlockShape::Line, &BlockDesign::enamelMm, 9.0));
        QVERIFY(isRefused("depth_mm", BlockShape::Line, &BlockDesign::depthMm, std::nan("")));
        QVERIFY(isRefused("length_mm", BlockShape::Line, &BlockDesign::lengthMm, 13.5));
        QVERIFY(isRefused("flare_mm", BlockShape::Dovetail, &BlockDesign::flareMm, -1.0));
        QVERIFY(isRefused("steps", BlockShape::Staircase, &BlockDesign::steps, 2.5));
        QVERIFY(isRefused("corner_radius_mm", BlockShape::Cross, &BlockDesign::cornerRadiusMm, 0.8));
        QVERIFY(isRefused("line_angle_mm", BlockShape::Cross, &BlockDesign::lineAngleMm, 0.5));
        QVERIFY(isRefused("width_mm", BlockShape::Circle, &BlockDesign::widthMm, 4.9));
        QVERIFY(isRefused("steps", BlockShape::Plunges, &BlockDesign::widthMm, 2.2));
        QVERIFY(isRefused("enamel_mm", BlockShape::Junction, &BlockDesign::depthMm, 0.7));
        QVERIFY(isRefused("height_mm", BlockShape::Layers, &BlockDesign::heightMm, 2.5));
    }
};

CUSP_TEST(TestBlockPreparation)
#include "tst_block_preparation.moc"
