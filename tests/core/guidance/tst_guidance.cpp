// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/guidance/Fixture.h"
#include "core/guidance/Landmarks.h"
#include "core/guidance/Margin.h"
#include "core/preparation/ToothPreparation.h"
#include "tests/support/Checks.h"
#include "tests/support/Scenes.h"
#include "tests/support/Suite.h"
#include "tests/support/SyntheticTooth.h"

using namespace core;
using guidance::Fixture;
using guidance::marginMm;
using support::near;

namespace {

constexpr double kHalfWidthMm = 1.0;
constexpr double kDepthMm = 1.5;

/// A slab with its top at 0, and an ideal trench along y.
struct Trench
{
    std::shared_ptr<const terrain::ToothAnatomy> anatomy = support::makeBlock({});
    std::vector<float> ideal;

    explicit Trench(double halfWidthMm = kHalfWidthMm)
        : ideal(support::loweredTop(*anatomy,
                                    [=](glm::dvec2 at) { return std::abs(at.x) < halfWidthMm ? -kDepthMm : 0.0; }))
    {}
};

const core::bur::Bur& burOf(const char* id)
{
    return core::bur::burs()[core::bur::findBur(id).value()];
}

}  // namespace

class TestGuidance : public QObject
{
    Q_OBJECT
private slots:
    void landmarksLieWhereTheSurfaceHasThem()
    {
        using guidance::Landmark;
        using preparation::Kind;
        for (const auto& [kind, fdi] : {std::pair(Kind::ClassOne, 36),
                                        {Kind::ClassOne, 26},
                                        {Kind::ClassOne, 37},
                                        {Kind::ClassTwoMesial, 36},
                                        {Kind::ClassTwoMesial, 26},
                                        {Kind::ClassTwoDistal, 35}}) {
            const auto tooth = support::soundTooth(fdi, 150, 0);
            const auto design = preparation::fittedDesign(kind, *tooth).value();
            const grading::IdealTop ideal = preparation::makePreparation(kind, design, *tooth).value().top;
            const auto heightMm = [&](glm::dvec2 at) {
                const glm::dvec2 node = tooth->grid.latticeOf(at) + 0.5;
                return tooth->top[tooth->grid.index(static_cast<int>(node.x), static_cast<int>(node.y))];
            };
            const auto find = [&](Landmark landmark) { return guidance::findLandmark(landmark, *tooth, *ideal); };
            const auto pit = find(Landmark::CentralPit);
            QCOMPARE(pit.size(), 1U);
            const auto kept = find(Landmark::RidgesToKeep);
            const auto cut = find(Landmark::RidgesToCut);
            QCOMPARE(kept.size(), kind == Kind::ClassOne ? 2U : 1U);
            QCOMPARE(cut.size(), kind == Kind::ClassOne ? 0U : 1U);
            for (const auto& [landmark, placeMm] : kept) {
                QVERIFY(heightMm(placeMm) > heightMm(pit.front().placeMm) + 0.5F);
                QVERIFY((placeMm.x < pit.front().placeMm.x) == (landmark == Landmark::MesialRidge));
            }
            if (fdi != 36)
                continue;
            // The fissures cross near the middle of the crown.
            glm::dvec2 deepest{0.0};
            for (double y = -1.5; y <= 1.5; y += 0.05)
                for (double x = -1.5; x <= 1.5; x += 0.05)
                    if (heightMm({x, y}) < heightMm(deepest))
                        deepest = {x, y};
            QVERIFY(glm::distance(pit.front().placeMm, deepest) < 1.0);
        }
        QVERIFY(guidance::findLandmark(Landmark::CentralPit, *Trench().anatomy, Trench().ideal).empty());
    }

    void marginIsTheDistanceToWhatIsKept()
    {
        const Trench trench;
        const double cell = trench.anatomy->grid.cellMm;
        const core::bur::Bur& straight = burOf("57");
        const double radius = straight.headRadiusMm;
        const auto margin = [&](double x, double z) {
            return marginMm(*trench.anatomy, trench.ideal, straight, {x, 0.0, z});
        };
        // Above the floor, the margin is the distance down to it.
        QVERIFY(std::abs(margin(0.0, -kDepthMm + 0.3).value() - std::min(0.3, kHalfWidthMm - radius)) < 1.0e-6);
        QVERIFY(std::abs(margin(0.0, -kDepthMm - 0.2).value() + 0.2) < 1.0e-6);
        // In the middle of the depth the wall is nearest, whose position is known to half a cell.
        for (const double toWall : {0.1, 0.3}) {
            const double x = kHalfWidthMm - radius - toWall;
            QVERIFY(near(margin(x, -0.7).value(), toWall, 0.5 * cell + 1.0e-6));
        }
        // A bur in the wall reports how far it reaches into the wall, not its depth.
        QVERIFY(near(margin(kHalfWidthMm - radius + 0.2, -0.7).value(), -0.2, cell));
        // In the air there is no margin.
        QVERIFY(!margin(0.0, guidance::kToldMm + 0.5).has_value());
        QVERIFY(!marginMm(*trench.anatomy, trench.ideal, straight, {1.0e9, std::nan(""), 0.0}).has_value());
    }

    void progressAddsUp()
    {
        const Trench trench;
        std::vector<float> top = trench.anatomy->top;
        const guidance::Progress whole = guidance::progressOf(*trench.anatomy, trench.ideal, top);
        QVERIFY(whole.askedMm3 > 1.0);
        QCOMPARE(whole.leftMm3, whole.askedMm3);
        QCOMPARE(whole.beyondMm3, 0.0);
        // Cuts all of the ideal, and 0.1 mm below it.
        double area = 0.0;
        for (std::size_t k = 0; k < top.size(); ++k)
            if (trench.ideal[k] < top[k]) {
                top[k] = trench.ideal[k] - 0.1F;
                area += static_cast<double>(trench.anatomy->areaMm2[k]);
            }
        const guidance::Progress done = guidance::progressOf(*trench.anatomy, trench.ideal, top);
        QCOMPARE(done.leftMm3, 0.0);
        QVERIFY(std::abs(done.beyondMm3 - 0.1 * area) < 1.0e-5 * area);
    }

    void fixtureHoldsSideways()
    {
        const Trench trench;
        const Fixture fixture(*trench.anatomy, trench.ideal);
        const std::size_t bur = core::bur::findBur("330").value();
        const double room = kHalfWidthMm - core::bur::burs()[bur].headRadiusMm;
        const auto at = [&](double x, double z) { return fixture.forceN({x, 0.0, z}, bur); };
        for (const double x : {-room + 0.05, 0.0, room - 0.05})
            QCOMPARE(at(x, -1.0), glm::dvec3(0.0));
        // Half a millimetre outside, the force is half a newton inwards. The outline is known to a cell.
        for (const double side : {-1.0, 1.0}) {
            const glm::dvec3 force = at(side * (room + 0.5), -1.0);
            QVERIFY(support::between(-side * force.x / Fixture::kNPerMm, 0.25, 0.75));
            QVERIFY(std::abs(force.y) < 1.0e-6 && force.z == 0.0);
        }
        // The force has an upper limit and ends at some distance. Above the tooth the hand is free.
        for (double x = 0.0; x < 4.0; x += 0.01)
            QVERIFY(glm::length(at(x, -1.0)) <= Fixture::kMostN + 1.0e-9);
        QCOMPARE(at(room + Fixture::kHoldsMm + 1.3, -1.0), glm::dvec3(0.0));
        QCOMPARE(at(room + 0.5, 0.6), glm::dvec3(0.0));
        QCOMPARE(fixture.forceN({std::nan(""), 0.0, 0.0}, bur), glm::dvec3(0.0));
        QCOMPARE(fixture.forceN({1.0e12, 0.0, 0.0}, bur), glm::dvec3(0.0));
        QCOMPARE(fixture.forceN({0.0, 0.0, 0.0}, 99), glm::dvec3(0.0));
    }

    /// A closed path at one height gains no energy from a fixture.
    void fixtureComesFromAPotential()
    {
        const Trench trench;
        const Fixture fixture(*trench.anatomy, trench.ideal);
        double most = 0.0;
        for (const glm::dvec2 middle : {glm::dvec2(0.8, 0.0), glm::dvec2(1.2, 0.7), glm::dvec2(-1.5, -0.3)}) {
            double joule = 0.0;
            double spent = 0.0;
            constexpr int kSteps = 20'000;
            for (int n = 0; n < kSteps; ++n) {
                const double turn = 6.283185307179586 / kSteps;
                const auto on = [&](int k) {
                    return glm::dvec3(middle.x + 0.7 * std::cos(turn * k), middle.y + 0.7 * std::sin(turn * k), -1.0);
                };
                const double work = glm::dot(fixture.forceN(on(n), 1), on(n + 1) - on(n));
                joule += work;
                spent += std::abs(work);
            }
            QVERIFY(spent > 0.1);
            most = std::max(most, std::abs(joule) / spent);
        }
        QVERIFY2(most < 0.02, qPrintable(QString::number(most)));
    }

    void fixtureLeavesABurAloneThatDoesNotFit()
    {
        const Trench narrow(0.34);
        const Fixture fixture(*narrow.anatomy, narrow.ideal);
        const std::size_t straight = core::bur::findBur("57").value();
        const std::size_t pear = core::bur::findBur("330").value();
        for (double x = -2.0; x < 2.0; x += 0.1)
            QCOMPARE(fixture.forceN({x, 0.0, -1.0}, straight), glm::dvec3(0.0));
        QVERIFY(glm::length(fixture.forceN({1.0, 0.0, -1.0}, pear)) > 0.3);
    }
};

CUSP_TEST(TestGuidance)
#include "tst_guidance.moc"
