// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include <cmath>

#include "core/base/Rng.h"
#include "core/preparation/BlockPreparation.h"
#include "core/preparation/CapturedPreparation.h"
#include "core/preparation/ToothPreparation.h"
#include "core/teeth/ToothBuilder.h"
#include "tests/support/Checks.h"
#include "tests/support/Suite.h"
#include "tests/support/SyntheticTooth.h"

using namespace core;
using namespace core::preparation;
using grading::Part;

namespace {

Block practiceBlock(teeth::BlockShape shape = teeth::BlockShape::Line)
{
    teeth::BlockDesign design;
    design.shape = shape;
    return *makeBlock(design);
}

/// Returns the tooth cut to the ideal, but deeper by this much.
terrain::Tooth attemptAt(const Block& practiceBlock, float tooDeepMm)
{
    terrain::Tooth tooth(practiceBlock.anatomy);
    for (std::size_t k = 0; k < tooth.top.size(); ++k)
        if (practiceBlock.ideal.parts[k] != Part::Keep)
            tooth.top[k] = (*practiceBlock.ideal.top)[k] - tooDeepMm;
    return tooth;
}

Result<grading::Preparation> average(const std::vector<terrain::Tooth>& attempts)
{
    std::vector<const terrain::Tooth*> pointers;
    for (const terrain::Tooth& attempt : attempts)
        pointers.push_back(&attempt);
    return averagePreparation(pointers);
}

}  // namespace

class TestCapturedPreparation : public QObject
{
    Q_OBJECT

private slots:
    void oneAttemptIsItself()
    {
        const Block cross = practiceBlock(teeth::BlockShape::Cross);
        const auto ideal = average({attemptAt(cross, 0.0F)});
        QVERIFY(ideal);
        QVERIFY(*ideal->top == *cross.ideal.top);
        for (std::size_t k = 0; k < ideal->parts.size(); ++k)
            QCOMPARE(ideal->parts[k] == Part::Keep, cross.ideal.parts[k] == Part::Keep);
    }

    void heightsAreTheMean()
    {
        const Block line = practiceBlock();
        const auto ideal = average({attemptAt(line, 0.0F), attemptAt(line, 0.1F), attemptAt(line, 0.35F)});
        QVERIFY(ideal);
        for (std::size_t k = 0; k < ideal->parts.size(); ++k)
            if (line.ideal.parts[k] != Part::Keep)
                QVERIFY(std::abs((*ideal->top)[k] - ((*line.ideal.top)[k] - 0.15F)) < 1e-5F);
            else
                QVERIFY((*ideal->top)[k] == line.anatomy->top[k]);
    }

    void mostOfTheAttemptsDecide()
    {
        const Block line = practiceBlock();
        terrain::Tooth slipped = attemptAt(line, 0.0F);
        const terrain::Grid& grid = line.anatomy->grid;
        const std::size_t aside = grid.index(grid.side / 2, grid.side / 4);
        slipped.top[aside] = -0.7F;
        // One of three attempts slipped there, and all of them brushed another place.
        std::vector<terrain::Tooth> attempts{slipped, attemptAt(line, 0.0F), attemptAt(line, 0.0F)};
        const std::size_t brushed = grid.index(grid.side / 2, 3 * grid.side / 4);
        for (terrain::Tooth& attempt : attempts)
            attempt.top[brushed] = -0.01F;
        const auto ideal = average(attempts);
        QVERIFY(ideal);
        QVERIFY(ideal->parts[aside] == Part::Keep && (*ideal->top)[aside] == 0.0F);
        QVERIFY(ideal->parts[brushed] == Part::Keep && (*ideal->top)[brushed] == 0.0F);
        // Two of three are a majority, one of two is not.
        attempts[1].top[aside] = -0.9F;
        QVERIFY(std::abs((*average(attempts)->top)[aside] + 0.8F) < 1e-6F);
        attempts.pop_back();
        attempts[1].top[aside] = 0.0F;
        QVERIFY(average(attempts)->parts[aside] == Part::Keep);
        // Most attempts went through the tooth.
        for (terrain::Tooth& attempt : attempts)
            attempt.top[aside] = terrain::kEmptyTop, attempt.bottom[aside] = terrain::kEmptyBottom;
        QVERIFY((*average(attempts)->top)[aside] == terrain::kEmptyTop);
    }

    void ofTwoTheMeanOutlineDecides()
    {
        // Round cuts, one wider and offset to the side: the average is between them.
        const Block plain = practiceBlock();
        const terrain::Grid& grid = plain.anatomy->grid;
        const glm::dvec2 middle = grid.middleMm();
        const auto round = [&](double radiusMm, double asideMm) {
            return support::lowered(plain.anatomy, [=](glm::dvec2 at) {
                return glm::distance(at, middle + glm::dvec2(asideMm, 0.0)) < radiusMm ? -1.0 : 100.0;
            });
        };
        const auto ideal = average({round(1.4, 0.0), round(2.0, 0.3)});
        QVERIFY(ideal);
        std::size_t others = 0;
        support::eachNode(grid, [&](std::size_t k, const glm::dvec2& at) {
            const double fromEdgeMm = glm::distance(at, middle + glm::dvec2(0.15, 0.0)) - 1.7;
            const bool isIn = ideal->parts[k] != Part::Keep;
            others += isIn == (fromEdgeMm < 0.0) ? 0 : 1;
            QVERIFY(isIn == (fromEdgeMm < 0.0) || std::abs(fromEdgeMm) < 1.5 * grid.cellMm);
        });
        QVERIFY2(others < 30, qPrintable(QString::number(others)));
        // A cut that only one of two attempts has, far from the other's cut, counts as a slip.
        terrain::Tooth slipped = round(1.7, 0.0);
        const std::size_t aside = grid.index(grid.side / 2, grid.side / 8);
        slipped.top[aside] = -1.0F;
        QVERIFY(average({slipped, round(1.7, 0.0)})->parts[aside] == Part::Keep);
    }

    void floorIsToldFromWall()
    {
        // A trench whose sides rise at 60 degrees and whose floor slopes at 10.
        const Block line = practiceBlock();
        const double steep = std::tan(60.0 * 3.14159265358979 / 180.0);
        const double gentle = std::tan(10.0 * 3.14159265358979 / 180.0);
        const auto floorAt = [&](glm::dvec2 at) { return -2.0 + gentle * at.x; };
        const auto wallAt = [&](glm::dvec2 at) { return floorAt(at) + (std::abs(at.y) - 1.0) * steep; };
        const terrain::Tooth attempt = support::lowered(line.anatomy, [&](glm::dvec2 at) {
            return std::abs(at.x) < 4.0 ? std::min(0.0, std::max(floorAt(at), wallAt(at))) : 0.0;
        });
        const auto ideal = average({attempt});
        QVERIFY(ideal);
        support::eachNode(line.anatomy->grid, [&](std::size_t k, const glm::dvec2& at) {
            if (std::abs(at.x) > 3.7 || !attempt.isSolid(k))
                return;
            if (std::abs(at.y) < 0.9)
                QVERIFY(ideal->parts[k] == Part::Floor);
            if (wallAt(at) > floorAt(at) + 0.4 && wallAt(at) < -0.1)
                QVERIFY(ideal->parts[k] == Part::Wall);
        });
    }

    void aToothPreparedByRuleIsFoundAgain()
    {
        const auto built = teeth::buildTooth({36}, {});
        QVERIFY(built);
        const auto rule = makePreparation(Kind::ClassOne, *usualDesign(Kind::ClassOne, 36), *built->anatomy);
        QVERIFY(rule);
        // Seven attempts, each with its own constant error of up to 0.05 mm in either direction.
        constexpr std::uint64_t kSeed = 5;
        Rng rng(kSeed);
        std::vector<terrain::Tooth> attempts;
        for (int n = 0; n < 7; ++n) {
            terrain::Tooth attempt(built->anatomy);
            for (std::size_t k = 0; k < attempt.top.size(); ++k)
                if (rule->parts[k] != Part::Keep)
                    attempt.top[k] =
                        std::min(attempt.top[k], (*rule->top)[k] + static_cast<float>(rng.uniform(-0.05, 0.05)));
            attempts.push_back(std::move(attempt));
        }
        const auto ideal = average(attempts);
        QVERIFY(ideal);
        double floor = 0.0;
        double same = 0.0;
        for (std::size_t k = 0; k < ideal->parts.size(); ++k) {
            if (rule->parts[k] != Part::Floor)
                continue;
            floor += 1.0;
            same += ideal->parts[k] == Part::Floor ? 1.0 : 0.0;
            QVERIFY(std::abs((*ideal->top)[k] - (*rule->top)[k]) < 0.05F);
        }
        QVERIFY(same > 0.95 * floor);
    }

    void attemptsThatDoNotGoTogetherAreRefused()
    {
        const Block line = practiceBlock();
        const Block cross = practiceBlock(teeth::BlockShape::Layers);
        QVERIFY(support::isRefused(average({}), "none"));
        QVERIFY(support::isRefused(average({attemptAt(line, 0.0F), terrain::Tooth(cross.anatomy)}), "block:layers"));
        QVERIFY(support::isRefused(average({terrain::Tooth(line.anatomy)}), "no place"));
        // A tooth that is built again counts as the same tooth.
        QVERIFY(average({attemptAt(line, 0.0F), attemptAt(practiceBlock(), 0.2F)}));
    }
};

CUSP_TEST(TestCapturedPreparation)
#include "tst_captured_preparation.moc"
