// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <QTest>

#include "core/terrain/Tooth.h"
#include "tests/support/Suite.h"
#include "tests/support/SyntheticTooth.h"
#include "tests/support/Tables.h"
#include "ui/render/SteepGround.h"

using core::terrain::Grid;
using core::terrain::kEmptyTop;
using ui::render::SteepGround;

namespace {

const Grid kGrid{96, 0.07, {-3.325, -3.325}};

struct Drawn
{
    explicit Drawn(std::vector<float> heights) : tops(std::move(heights))
    {
        steep.draw(tops, wholeOf(kGrid), drawn, shifts);
    }
    [[nodiscard]] glm::vec2 place(int i, int j) const
    {
        return glm::vec2(kGrid.nodeMm(i, j)) + shifts[kGrid.index(i, j)];
    }
    [[nodiscard]] float height(int i, int j) const { return drawn[kGrid.index(i, j)]; }

    SteepGround steep{kGrid};
    std::vector<float> tops;
    std::vector<float> drawn = std::vector<float>(kGrid.count());
    std::vector<glm::vec2> shifts = std::vector<glm::vec2>(kGrid.count());
};

template <class Height>
std::vector<float> field(Height&& height)
{
    std::vector<float> tops(kGrid.count());
    support::eachNode(kGrid, [&](std::size_t k, glm::dvec2 place) { tops[k] = height(glm::vec2(place)); });
    return tops;
}

glm::vec2 acrossWall(double degrees)
{
    const auto angle = static_cast<float>(glm::radians(degrees));
    return {std::cos(angle), std::sin(angle)};
}

/// Returns ground at 0 mm that falls to -1 mm behind a line through the middle: a wall that is not along a row of
/// nodes.
std::vector<float> wall(double degrees)
{
    const glm::vec2 across = acrossWall(degrees);
    return field([&](glm::vec2 at) { return glm::dot(at, across) > 0.013F ? -1.0F : 0.0F; });
}

}  // namespace

class TestSteepGround : public QObject
{
    Q_OBJECT

private slots:
    void aWallAtAnyAngleIsStraight_data()
    {
        support::columns<double, float>("degrees", "wobbleCells");
        QTest::newRow("7 degrees: a step every eight nodes") << 7.0 << 0.6F;
        for (const double degrees : {0.0, 18.0, 26.6, 33.0, 45.0, 71.0})
            QTest::addRow("%g degrees", degrees) << degrees << 0.33F;
    }

    /// The line at which the drawn wall is half-way down deviates by less than a third of a cell from a straight one,
    /// where the height map deviates by a cell. Only steps longer than the width of the blur are not evened out
    /// completely. The wall stays steep: from a tenth to nine tenths of its height takes little more than two cells.
    void aWallAtAnyAngleIsStraight()
    {
        QFETCH(double, degrees);
        QFETCH(float, wobbleCells);
        const Drawn drawn(wall(degrees));
        const glm::vec2 across = acrossWall(degrees);
        const auto cell = static_cast<float>(kGrid.cellMm);
        float least = 1.0e9F;
        float most = -1.0e9F;
        float foot = -1.0e9F;
        float lip = 1.0e9F;
        for (int j = 8; j < kGrid.side - 8; ++j) {
            for (int i = 8; i < kGrid.side - 8; ++i) {
                const float here = drawn.height(i, j);
                const float along = glm::dot(drawn.place(i, j), across) / cell;
                if (here < -0.1F && here > -0.9F) {
                    foot = std::max(foot, along);
                    lip = std::min(lip, along);
                }
                for (const auto& [di, dj] : {std::array{1, 0}, {0, 1}}) {
                    const float next = drawn.height(i + di, j + dj);
                    if ((here > -0.5F) == (next > -0.5F))
                        continue;
                    const float share = (-0.5F - here) / (next - here);
                    const float at = along + share * (glm::dot(drawn.place(i + di, j + dj), across) / cell - along);
                    least = std::min(least, at);
                    most = std::max(most, at);
                }
            }
        }
        QVERIFY2(most - least < wobbleCells, qPrintable(QString::number(most - least)));
        QVERIFY2(foot - lip < 2.2F, qPrintable(QString::number(foot - lip)));
    }

    void gentleGroundStaysAsItIs()
    {
        // A fossa of 3 mm radius, with slopes of up to 27 degrees within 1.4 mm of its middle.
        const Drawn drawn(
            field([](glm::vec2 at) { return 3.0F - std::sqrt(std::max(0.0F, 9.0F - glm::dot(at, at))); }));
        support::eachNode(kGrid, [&](std::size_t k, glm::dvec2 place) {
            if (glm::length(place) > 1.4)
                return;
            QCOMPARE(drawn.drawn[k], drawn.tops[k]);
            QCOMPARE(drawn.shifts[k], glm::vec2(0.0F));
        });
    }

    void noTriangleTurnsOver()
    {
        // A pit, a slit one node wide and walls at odd angles.
        std::vector<float> tops = wall(18.0);
        const std::vector<float> other = wall(71.0);
        for (std::size_t k = 0; k < tops.size(); ++k)
            tops[k] += other[k];
        for (int i = 20; i < 70; ++i)
            tops[kGrid.index(i, 30 + i / 5)] -= 0.8F;
        const Drawn drawn(tops);
        for (int j = 0; j + 1 < kGrid.side; ++j) {
            for (int i = 0; i + 1 < kGrid.side; ++i) {
                const glm::vec2 a = drawn.place(i, j);
                const glm::vec2 b = drawn.place(i + 1, j);
                const glm::vec2 c = drawn.place(i + 1, j + 1);
                const glm::vec2 d = drawn.place(i, j + 1);
                const auto twice = [](glm::vec2 u, glm::vec2 v) { return u.x * v.y - u.y * v.x; };
                QVERIFY(twice(b - a, c - a) + twice(c - a, d - a) > 0.0F);
            }
        }
    }

    void nothingIsBlurredBesideNothing()
    {
        std::vector<float> tops = wall(33.0);
        for (int j = 0; j < kGrid.side; ++j)
            for (int i = 0; i < kGrid.side / 2; ++i)
                tops[kGrid.index(i, j)] = kEmptyTop;
        const Drawn drawn(tops);
        for (int j = 0; j < kGrid.side; ++j) {
            const int i = kGrid.side / 2;
            QCOMPARE(drawn.height(i, j), tops[kGrid.index(i, j)]);
            QCOMPARE(drawn.shifts[kGrid.index(i, j)], glm::vec2(0.0F));
        }
    }

    void aPartBroughtUpToDateEqualsTheWhole()
    {
        Drawn part(wall(26.6));
        const core::terrain::NodeRect cut{40, 44, 52, 55};
        for (int j = cut.beginJ; j < cut.endJ; ++j)
            for (int i = cut.beginI; i < cut.endI; ++i)
                part.tops[kGrid.index(i, j)] -= 0.7F;
        const Drawn whole(part.tops);
        part.steep.draw(part.tops, grown(cut, SteepGround::kReach, kGrid), part.drawn, part.shifts);
        QVERIFY(part.drawn == whole.drawn);
        QVERIFY(part.shifts == whole.shifts);
    }
};

CUSP_TEST(TestSteepGround)
#include "tst_steep_ground.moc"
