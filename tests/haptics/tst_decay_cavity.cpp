// SPDX-License-Identifier: GPL-3.0-or-later
// The cavity that a simulated hand cuts to remove decay: it removes all of it, with little sound tissue and no harm.
#include <QTest>

#include <algorithm>
#include <cmath>

#include "core/bur/Bur.h"
#include "haptics/simulated/DecayCavity.h"
#include "tests/support/Suite.h"
#include "tests/support/SyntheticTooth.h"

using core::bur::Bur;
using core::terrain::ToothAnatomy;

namespace {

const Bur& pear()
{
    return core::bur::burs()[core::bur::findBur("330").value()];
}

/// Adds decay between two heights, within a radius of a place.
void decay(ToothAnatomy& anatomy, double x, double y, double radiusMm, float roof, float floor)
{
    support::eachNode(anatomy.grid, [&](std::size_t k, const glm::dvec2& at) {
        if (std::hypot(at.x - x, at.y - y) <= radiusMm) {
            anatomy.layers[k].cariesRoof = roof;
            anatomy.layers[k].cariesFloor = floor;
        }
    });
}

/// Returns the number of columns that still have decay below this top map.
int decayedColumns(const ToothAnatomy& anatomy, const std::vector<float>& top)
{
    int count = 0;
    for (std::size_t k = 0; k < top.size(); ++k)
        count += anatomy.layers[k].cariesRoof > anatomy.layers[k].cariesFloor && top[k] > anatomy.layers[k].cariesFloor;
    return count;
}

}  // namespace

class TestDecayCavity : public QObject
{
    Q_OBJECT

private slots:
    void nothingIsCutWhereNothingIsDecayed()
    {
        const auto anatomy = support::slab(-1.0F);
        QCOMPARE(haptics::decayCavity(*anatomy, pear()), anatomy->top);
    }

    void allDecayGoesAndLittleElse()
    {
        const auto anatomy = support::slab(-1.0F);
        decay(*anatomy, 0.3, -0.2, 1.2, -0.5F, -1.5F);
        const std::vector<float> top = haptics::decayCavity(*anatomy, pear());
        QCOMPARE(decayedColumns(*anatomy, top), 0);
        double beside = 0.0;
        support::eachNode(anatomy->grid, [&](std::size_t k, const glm::dvec2& at) {
            QVERIFY2(top[k] > -1.6F, "no deeper than the decay");
            if (top[k] < anatomy->top[k])
                beside = std::max(beside, std::hypot(at.x - 0.3, at.y + 0.2) - 1.2);
        });
        // The cavity is wider than the decay by at most the radius of the bur's end.
        QVERIFY2(beside < pear().headRadiusMm, qPrintable(QString::number(beside)));
    }

    void pulpIsNotOpenedForDecayBesideIt()
    {
        const auto anatomy = support::slab(-1.0F);
        decay(*anatomy, 0.0, 0.0, 0.6, -0.5F, -3.0F);
        support::eachNode(anatomy->grid, [&](std::size_t k, const glm::dvec2& at) {
            if (at.x > 0.75) {
                anatomy->layers[k].pulpRoof = -2.0F;
                anatomy->layers[k].pulpFloor = -5.0F;
            }
        });
        const std::vector<float> top = haptics::decayCavity(*anatomy, pear());
        QCOMPARE(decayedColumns(*anatomy, top), 0);
        for (std::size_t k = 0; k < top.size(); ++k)
            if (core::terrain::hasPulp(*anatomy, k))
                QVERIFY(top[k] > anatomy->layers[k].pulpRoof);
    }

    /// Firm decay is left, and so is leathery decay over the pulp, as far as the head of a bur can follow.
    void firmDecayMayStay()
    {
        const auto anatomy = support::slab(-1.0F);
        decay(*anatomy, 0.0, 0.0, 1.4, -0.5F, -3.0F);
        anatomy->hasDecayZones = true;
        const std::vector<float> top = haptics::decayCavity(*anatomy, pear());
        support::eachNode(anatomy->grid, [&](std::size_t k, const glm::dvec2& at) {
            QVERIFY2(top[k] > -2.6F, "no deeper than to the firm decay");
            if (std::hypot(at.x, at.y) <= 1.4)
                QVERIFY2(top[k] < -2.5F, "down to it");
        });
    }

    /// Decay reaches the flank. Where there is no tooth behind it, it is not cut through to remove it.
    void theToothIsNotPiercedAtItsRim()
    {
        const auto anatomy = support::slab(-1.0F);
        support::eachNode(anatomy->grid, [&](std::size_t k, const glm::dvec2& at) {
            if (at.x > 1.0)
                anatomy->bottom[k] = -2.0F;
        });
        decay(*anatomy, 0.4, 0.0, 0.6, -0.2F, -2.5F);
        const std::vector<float> top = haptics::decayCavity(*anatomy, pear());
        QCOMPARE(decayedColumns(*anatomy, top), 0);
        for (std::size_t k = 0; k < top.size(); ++k)
            QVERIFY(top[k] > anatomy->bottom[k]);
    }
};

CUSP_TEST(TestDecayCavity)
#include "tst_decay_cavity.moc"
