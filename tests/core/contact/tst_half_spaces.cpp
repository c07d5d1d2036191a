// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include "core/base/Rng.h"
#include "core/contact/HalfSpaces.h"
#include "tests/support/Suite.h"

using core::contact::HalfSpaces;

class TestHalfSpaces : public QObject
{
    Q_OBJECT
private slots:
    void whatIsWithinStaysWhereItIs()
    {
        glm::dvec3 found{0.0};
        QVERIFY(HalfSpaces().nearest({1.0, 2.0, 3.0}, found));  // without half-spaces there is no limit
        QCOMPARE(found, glm::dvec3(1.0, 2.0, 3.0));
        HalfSpaces spaces;
        spaces.add({{0.0, 0.0, 1.0}, -1.0});
        QVERIFY(spaces.nearest({1.0, 2.0, 0.0}, found));
        QCOMPARE(found, glm::dvec3(1.0, 2.0, 0.0));
    }

    void cornerOfThreeWalls()
    {
        HalfSpaces spaces;
        spaces.add({{0.0, 0.0, 1.0}, 0.0});
        spaces.add({{-1.0, 0.0, 0.0}, 0.5});
        spaces.add({{0.0, -1.0, 0.0}, 0.25});
        glm::dvec3 found{0.0};
        QVERIFY(spaces.nearest({1.0, 1.0, -1.0}, found));
        QVERIFY(glm::length(found - glm::dvec3(-0.5, -0.25, 0.0)) < 1.0e-12);
    }

    /// Compares with Dykstra's alternating projections, a slow and independent method.
    void agreesWithASlowProjection()
    {
        core::Rng rng(5);
        for (int round = 0; round < 2000; ++round) {
            const int count = 1 + rng.below(static_cast<int>(HalfSpaces::kMost));
            HalfSpaces spaces;
            std::vector<std::pair<glm::dvec3, double>> planes;
            for (int k = 0; k < count; ++k) {
                // All half-spaces contain the origin, as the planes that a free bur has met do.
                const glm::dvec3 normal =
                    glm::normalize(glm::dvec3(rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0), rng.uniform(0.1, 1.0)));
                planes.emplace_back(normal, rng.uniform(-0.3, 0.0));
                spaces.add({normal, planes.back().second});
            }
            const glm::dvec3 to(rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 0.2));
            glm::dvec3 slow = to;
            std::vector<glm::dvec3> kept(planes.size(), glm::dvec3(0.0));
            for (int turn = 0; turn < 20'000; ++turn) {
                const std::size_t k = static_cast<std::size_t>(turn) % planes.size();
                const glm::dvec3 from = slow + kept[k];
                const double lack = planes[k].second - glm::dot(planes[k].first, from);
                slow = lack > 0.0 ? from + planes[k].first * lack : from;
                kept[k] = from - slow;
            }
            glm::dvec3 found{0.0};
            QVERIFY(spaces.nearest(to, found));
            for (const auto& [normal, offset] : planes)
                QVERIFY(glm::dot(normal, found) >= offset - 1.0e-8);
            QVERIFY2(glm::length(found - to) < glm::length(slow - to) + 1.0e-4, qPrintable(QString::number(round)));
        }
    }

    void whatCannotBeIsSaid()
    {
        HalfSpaces spaces;
        spaces.add({{0.0, 0.0, 1.0}, 1.0});
        spaces.add({{0.0, 0.0, -1.0}, 1.0});
        glm::dvec3 found{0.0};
        QVERIFY(!spaces.nearest({0.0, 0.0, 0.0}, found));
        spaces.clear();
        QVERIFY(spaces.nearest({0.0, 0.0, 0.0}, found));
    }
};

CUSP_TEST(TestHalfSpaces)
#include "tst_half_spaces.moc"
