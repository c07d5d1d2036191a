// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include <QTest>

#include "core/terrain/Tooth.h"
#include "tests/support/Suite.h"
#include "tests/support/SyntheticTooth.h"
#include "ui/render/Flanks.h"
#include "ui/render/Junction.h"

using core::terrain::Grid;
using ui::render::Flanks;

namespace {

const Grid kFlankGrid{150, 0.07, {-5.2, -5.17}};

struct Maps
{
    std::vector<float> tops = std::vector<float>(kFlankGrid.count(), core::terrain::kEmptyTop);
    std::vector<float> bottoms = std::vector<float>(kFlankGrid.count(), core::terrain::kEmptyBottom);
};

/// Returns a body of revolution: heights by the distance from its axis.
template <class Top, class Bottom>
Maps turned(double radiusMm, Top&& top, Bottom&& bottom)
{
    Maps maps;
    support::eachNode(kFlankGrid, [&](std::size_t k, glm::dvec2 place) {
        const double away = glm::length(place);
        if (away >= radiusMm)
            return;
        maps.tops[k] = static_cast<float>(top(away));
        maps.bottoms[k] = static_cast<float>(bottom(away));
    });
    return maps;
}

}  // namespace

class TestFlanks : public QObject
{
    Q_OBJECT

private slots:
    /// Compares the normals computed from heights at nodes with those of the ball at the same height.
    void normalsAreThoseOfABall()
    {
        constexpr double kRadiusMm = 4.5;
        constexpr double kContourMm = -3.0;
        const auto rise = [](double away) { return std::sqrt(kRadiusMm * kRadiusMm - away * away); };
        const Maps ball = turned(
            kRadiusMm, [&](double away) { return kContourMm + rise(away); },
            [&](double away) { return kContourMm - rise(away); });
        const Flanks flanks(kFlankGrid, ball.tops, ball.bottoms, ball.tops, ball.bottoms);
        int taken = 0;
        double worst = 0.0;
        support::eachNode(kFlankGrid, [&](std::size_t k, glm::dvec2 place) {
            if (ball.tops[k] <= ball.bottoms[k])
                return;
            for (const Flanks::Side side : {Flanks::Side::Upper, Flanks::Side::Lower}) {
                const float height = side == Flanks::Side::Upper ? ball.tops[k] : ball.bottoms[k];
                glm::vec3 normal(0.0F);
                if (flanks.normalAt(k, side, height, normal) <= 0.0F)
                    continue;
                ++taken;
                const glm::dvec3 expected(place / kRadiusMm, (static_cast<double>(height) - kContourMm) / kRadiusMm);
                worst = std::max(worst, std::acos(std::min(1.0, glm::dot(glm::dvec3(normal), expected))));
            }
        });
        QVERIFY(taken > 4000);
        QVERIFY2(worst < 0.05, qPrintable(QString::number(worst)));
    }

    /// A crown on a neck that falls by 0.5 mm per cell. The drawn underside must cross the junction at the height of
    /// the line, although neighbouring columns are at least half a millimetre apart.
    void enamelEndsAtOneHeight()
    {
        constexpr double kNeckMm = 3.0;
        constexpr double kLineMm = -6.0;
        constexpr double kSteep = 7.0;
        const auto bottom = [](double away) { return kLineMm + kSteep * (away - kNeckMm); };
        const Maps tooth = turned(
            3.6, [](double) { return 0.0; }, bottom);
        std::vector<float> junction(kFlankGrid.count(), 0.0F);
        for (std::size_t k = 0; k < junction.size(); ++k)
            junction[k] = tooth.bottoms[k] < static_cast<float>(kLineMm) ? -5.0F : tooth.bottoms[k] - 1.0F;
        const std::vector<float> drawn = ui::render::drawnJunction(kFlankGrid, tooth.tops, tooth.bottoms, junction);
        int crossings = 0;
        double sum = 0.0;
        for (int j = 0; j < kFlankGrid.side; ++j) {
            for (int i = 0; i + 1 < kFlankGrid.side; ++i) {
                const std::size_t a = kFlankGrid.index(i, j);
                const std::size_t b = kFlankGrid.index(i + 1, j);
                if (tooth.tops[a] <= tooth.bottoms[a] || tooth.tops[b] <= tooth.bottoms[b])
                    continue;
                const float over = tooth.bottoms[a] - drawn[a];
                const float next = tooth.bottoms[b] - drawn[b];
                if (over * next >= 0.0F)
                    continue;
                const float at = tooth.bottoms[a] + (tooth.bottoms[b] - tooth.bottoms[a]) * over / (over - next);
                ++crossings;
                sum += (static_cast<double>(at) - kLineMm) * (static_cast<double>(at) - kLineMm);
            }
        }
        QVERIFY(crossings > 100);
        const double rms = std::sqrt(sum / crossings);
        QVERIFY2(rms < 0.05, qPrintable(QString::number(rms)));
    }

    void toothOfEnamelAloneShowsNone()
    {
        const Maps tooth = turned(
            4.0, [](double) { return 0.0; }, [](double) { return -5.0; });
        const std::vector<float> drawn =
            ui::render::drawnJunction(kFlankGrid, tooth.tops, tooth.bottoms, tooth.bottoms);
        for (std::size_t k = 0; k < drawn.size(); ++k)
            if (tooth.tops[k] > tooth.bottoms[k])
                QVERIFY(drawn[k] < tooth.bottoms[k] - 0.1F);
    }
};

CUSP_TEST(TestFlanks)
#include "tst_flanks.moc"
