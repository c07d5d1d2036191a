// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include <QTest>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "core/teeth/Arch.h"
#include "core/teeth/ToothTable.h"
#include "tests/support/Checks.h"
#include "tests/support/Suite.h"
#include "tests/support/Tables.h"

using namespace core::teeth;
using support::between;

namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

/// The triangles of a crown in the jaw frame.
struct Crown
{
    std::vector<glm::dvec3> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;

    explicit Crown(const Arch& arch, int fdi) : triangles(arch.tooth(fdi).mesh.triangles)
    {
        for (const glm::vec3& p : arch.tooth(fdi).mesh.vertices)
            points.emplace_back(arch.jawFromTooth(fdi) * glm::dvec4(p, 1.0));
    }
};

/// Returns the distance from a point to a triangle (Ericson, Real-Time Collision Detection, section 5.1.5).
double distanceTo(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
    const glm::dvec3 ab = b - a;
    const glm::dvec3 ac = c - a;
    const double d1 = glm::dot(ab, p - a);
    const double d2 = glm::dot(ac, p - a);
    if (d1 <= 0 && d2 <= 0)
        return glm::distance(p, a);
    const double d3 = glm::dot(ab, p - b);
    const double d4 = glm::dot(ac, p - b);
    if (d3 >= 0 && d4 <= d3)
        return glm::distance(p, b);
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0)
        return glm::distance(p, a + d1 / (d1 - d3) * ab);
    const double d5 = glm::dot(ab, p - c);
    const double d6 = glm::dot(ac, p - c);
    if (d6 >= 0 && d5 <= d6)
        return glm::distance(p, c);
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0)
        return glm::distance(p, a + d2 / (d2 - d6) * ac);
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
        return glm::distance(p, b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b));
    const double sum = va + vb + vc;
    return glm::distance(p, a + vb / sum * ab + vc / sum * ac);
}

/// Returns the signed distance from a point to a closed mesh, negative inside. The solid angle decides what is inside.
double signedDistance(const Crown& crown, const glm::dvec3& p)
{
    double nearest = kFar;
    double angle = 0.0;
    for (const auto& t : crown.triangles) {
        const glm::dvec3 a = crown.points[t[0]];
        const glm::dvec3 b = crown.points[t[1]];
        const glm::dvec3 c = crown.points[t[2]];
        nearest = std::min(nearest, distanceTo(p, a, b, c));
        const glm::dvec3 u = a - p;
        const glm::dvec3 v = b - p;
        const glm::dvec3 w = c - p;
        const double lu = glm::length(u);
        const double lv = glm::length(v);
        const double lw = glm::length(w);
        angle += 2.0 * std::atan2(glm::dot(u, glm::cross(v, w)),
                                  lu * lv * lw + glm::dot(u, v) * lw + glm::dot(v, w) * lu + glm::dot(w, u) * lv);
    }
    return std::abs(angle) > 6.0 ? -nearest : nearest;
}

/// Returns the tip that is on the arch curve: the highest point of the buccal (labial) half, in the jaw frame.
glm::dvec3 facialTip(const Arch& arch, int fdi)
{
    const CoarseTooth& tooth = arch.tooth(fdi);
    glm::dvec3 tip(0.0, 0.0, -kFar);
    for (std::size_t k = 0; k < tooth.crownVertices; ++k) {
        const glm::vec3 p = tooth.mesh.vertices[k];
        // For a molar, the mesial one of the buccal cusps.
        if ((fdi % 10 < 4 || static_cast<double>(p.y) * buccalSign(fdi) > 0.5) && (fdi % 10 < 6 || p.x < 0.0F)) {
            const glm::dvec3 here(arch.jawFromTooth(fdi) * glm::dvec4(p, 1.0));
            if (here.z > tip.z)
                tip = here;
        }
    }
    return tip;
}

}  // namespace

class TestArch : public QObject
{
    Q_OBJECT

private slots:
    void neighboursTouchAndDoNotOverlap_data()
    {
        support::columns<int, int>("mesial", "distal");
        for (const int quadrant : {20, 30})
            for (int position = 1; position < 8; ++position)
                QTest::addRow("%d %d", quadrant + position, quadrant + position + 1)
                    << quadrant + position << quadrant + position + 1;
    }

    void neighboursTouchAndDoNotOverlap()
    {
        QFETCH(int, mesial);
        QFETCH(int, distal);
        // Measures by another method than the placement: by distances in space, not along the arch.
        const Crown a(m_arch, mesial);
        const Crown b(m_arch, distal);
        const auto contact =
            std::find_if(m_arch.contacts().begin(), m_arch.contacts().end(),
                         [&](const ArchContact& c) { return c.mesialFdi == mesial && c.distalFdi == distal; });
        QVERIFY(contact != m_arch.contacts().end());
        double least = kFar;
        for (const auto* pair : {&a, &b}) {
            const Crown& other = pair == &a ? b : a;
            for (const glm::dvec3& p : pair->points)
                if (glm::distance(p, contact->middleMm) < 2.5)
                    least = std::min(least, signedDistance(other, p));
        }
        QVERIFY(between(least, -0.1, 0.1));
        // The contact is above the gum, in the upper two thirds of the crown.
        QVERIFY(between(contact->middleMm.z, -6.0, -0.5));
    }

    void teethFollowTheArchInOrder()
    {
        for (const Jaw jaw : {Jaw::Upper, Jaw::Lower}) {
            const ArchCurve curve(jaw);
            double before = 0.0;
            double reachMm = 0.0;
            for (int position = 1; position <= 8; ++position) {
                const int fdi = (jaw == Jaw::Upper ? 20 : 30) + position;
                const glm::dvec3 middle(m_arch.jawFromTooth(fdi)[3]);
                QVERIFY(middle.x > 0.0);
                const double along = curve.placeOf(glm::dvec2(middle)).alongMm;
                const double halfMm = 0.5 * findToothSizes(fdi)->crownWidthMm;
                QVERIFY2(along > before + 0.85 * (reachMm + halfMm), qPrintable(QString::number(fdi)));
                before = along;
                reachMm = halfMm;
            }
        }
        // The left central incisor touches the midsagittal plane, and no part of it is beyond.
        for (const int fdi : {21, 31}) {
            double nearest = kFar;
            for (const glm::dvec3& p : Crown(m_arch, fdi).points)
                nearest = std::min(nearest, p.x);
            QVERIFY(between(nearest, -0.02, 0.02));
        }
    }

    void widthsAreThoseOfAdults()
    {
        // The standard deviation between people is about 2 mm. The mean arch must be closer than one of them.
        for (const Jaw jaw : {Jaw::Upper, Jaw::Lower}) {
            const int first = jaw == Jaw::Upper ? 20 : 30;
            const double canines = 2.0 * facialTip(m_arch, first + 3).x;
            const double molars = 2.0 * facialTip(m_arch, first + 6).x;
            QVERIFY(between(canines - ArchCurve::intercanineMm(jaw), -2.0, 2.0));
            QVERIFY(between(molars - ArchCurve::intermolarMm(jaw), -2.0, 2.0));
        }
    }

    void distalSidesFollowTheArch()
    {
        for (const ToothSizes& sizes : toothSizes()) {
            const glm::dmat4 stand = m_arch.jawFromTooth(sizes.fdi);
            const glm::dvec3 distal(stand[0]);
            const glm::dvec3 occlusal(stand[2]);
            const glm::dvec3 buccal = buccalSign(sizes.fdi) * glm::dvec3(stand[1]);
            const ArchCurve curve(jawOf(sizes.fdi));
            const ArchPlace place = curve.placeOf(glm::dvec2(stand[3]));
            QVERIFY(glm::dot(glm::dvec2(distal), curve.tangent(place.alongMm)) > 0.97);
            QVERIFY(glm::dot(glm::dvec2(buccal), curve.outward(place.alongMm)) > 0.8);
            QVERIFY(occlusal.z > 0.85);
            // The upper jaw frame is left-handed, see Arch.h. A tooth in it is never deformed.
            const double volume = glm::determinant(glm::dmat3(stand));
            QVERIFY(std::abs(volume - (sizes.fdi < 30 ? -1.0 : 1.0)) < 1.0e-9);
        }
    }

    void rightIsTheMirrorImageOfLeft()
    {
        const std::vector<ArchPiece> mouth = m_arch.mouth(0.4);
        std::map<int, const ArchPiece*> teeth;
        for (const ArchPiece& piece : mouth)
            if (piece.tooth)
                teeth[piece.fdi] = &piece;
        QCOMPARE(teeth.size(), std::size_t{32});
        std::set<const LookMesh*> meshes;
        for (const auto& [fdi, piece] : teeth) {
            meshes.insert(piece->mesh.get());
            const ArchPiece& left = *teeth.at(leftFellow(fdi));
            QCOMPARE(left.mesh.get(), piece->mesh.get());
            if (!isRight(fdi))
                continue;
            for (const LookVertex& v : left.mesh->vertices) {
                const glm::dvec4 there = left.place * glm::dvec4(v.positionMm, 1.0);
                const glm::dvec4 here = piece->place * glm::dvec4(v.positionMm, 1.0);
                QVERIFY(here.x <= 0.02);
                QVERIFY(glm::distance(glm::dvec3(here), glm::dvec3(-there.x, there.y, there.z)) < 1.0e-9);
            }
        }
        QCOMPARE(meshes.size(), std::size_t{16});
    }

    void jawsFaceEachOther()
    {
        for (const double openRad : {0.0, 0.3}) {
            std::map<int, glm::dvec3> tips;
            for (const ArchPiece& piece : m_arch.mouth(openRad))
                if (piece.tooth)
                    tips[piece.fdi] = glm::dvec3(piece.place * glm::dvec4(0.0, 0.0, 0.0, 1.0));
            for (int position = 1; position <= 8; ++position)
                QVERIFY(tips[20 + position].z > tips[30 + position].z + (openRad > 0.0 ? 3.0 : -3.0));
            const double opening = glm::distance(tips[21], tips[31]);
            QVERIFY(openRad > 0.0 ? opening > 20.0 && opening < 40.0 : opening < 6.0);
            // The hinge is at the back, so molars open less than incisors.
            if (openRad > 0.0)
                QVERIFY(glm::distance(tips[27], tips[37]) < opening);
        }
    }

    void meshesAreCoarseAndSound()
    {
        std::size_t most = 0;
        for (const ArchPiece& piece : m_arch.mouth(0.0)) {
            if (piece.tooth)
                most = std::max(most, piece.mesh->indices.size() / 3);
            for (const std::uint32_t k : piece.mesh->indices)
                QVERIFY(k < piece.mesh->vertices.size());
            for (const LookVertex& v : piece.mesh->vertices) {
                QVERIFY(std::abs(glm::length(v.normal) - 1.0F) < 1.0e-3F);
                QVERIFY(v.open >= 0.0F && v.open <= 1.0F);
                QVERIFY(glm::distance(v.positionMm, piece.mesh->middleMm) <= piece.mesh->radiusMm + 1.0e-3F);
            }
        }
        QVERIFY(most <= 4000);
        QVERIFY(m_arch.triangles() <= 200000);
    }

    void crownsStandOutOfTheGum_data()
    {
        QTest::addColumn<int>("fdi");
        for (const ToothSizes& sizes : toothSizes())
            QTest::addRow("%d", sizes.fdi) << sizes.fdi;
    }

    /// Casts rays from outside to the middle of the facial and the lingual side: they must meet the crown above the
    /// margin and the gum below it.
    void crownsStandOutOfTheGum()
    {
        QFETCH(int, fdi);
        const double crownMm = findToothSizes(fdi)->crownHeightMm;
        const auto firstMet = [&](const glm::dvec3& from, const glm::dvec3& way) {
            // In the tooth's own frame, which also contains its neighbours and the gum.
            double gum = kFar;
            double crown = kFar;
            const auto meet = [&](const std::vector<glm::dvec3>& points, const auto& corners, double& nearest) {
                for (std::size_t k = 0; k < corners.size(); k += 3) {
                    const glm::dvec3 a = points[corners[k]];
                    const glm::dvec3 ab = points[corners[k + 1]] - a;
                    const glm::dvec3 ac = points[corners[k + 2]] - a;
                    const glm::dvec3 p = glm::cross(way, ac);
                    const double d = glm::dot(ab, p);
                    if (std::abs(d) < 1e-12)
                        continue;
                    const glm::dvec3 s = from - a;
                    const glm::dvec3 q = glm::cross(s, ab);
                    const double u = glm::dot(s, p) / d;
                    const double v = glm::dot(way, q) / d;
                    const double t = glm::dot(ac, q) / d;
                    if (u >= 0 && v >= 0 && u + v <= 1 && t > 0)
                        nearest = std::min(nearest, t);
                }
            };
            std::vector<glm::dvec3> points(m_arch.tooth(fdi).mesh.vertices.begin(),
                                           m_arch.tooth(fdi).mesh.vertices.end());
            std::vector<std::uint32_t> corners;
            for (const auto& triangle : m_arch.tooth(fdi).mesh.triangles)
                corners.insert(corners.end(), triangle.begin(), triangle.end());
            meet(points, corners, crown);
            for (const ArchPiece& piece : m_arch.neighbours(fdi)) {
                if (piece.tooth)
                    continue;
                points.clear();
                for (const LookVertex& v : piece.mesh->vertices)
                    points.emplace_back(piece.place * glm::dvec4(v.positionMm, 1.0));
                meet(points, piece.mesh->indices, gum);
            }
            return std::pair(crown, gum);
        };
        for (const double side : {1.0, -1.0}) {
            const glm::dvec3 way(0.0, -side, 0.0);
            // Half-way up the crown there is no gum; two millimetres below the CEJ there is only gum.
            const auto high = firstMet({0.0, 20.0 * side, -0.45 * crownMm}, way);
            QVERIFY2(high.first < high.second, qPrintable(QString("side %1").arg(side)));
            const auto low = firstMet({0.0, 20.0 * side, -crownMm - 2.0}, way);
            QVERIFY2(low.second < low.first, qPrintable(QString("side %1").arg(side)));
        }
    }

    void neighboursStandBesideTheTooth()
    {
        for (const ToothSizes& sizes : toothSizes()) {
            std::set<int> teeth;
            int gums = 0;
            for (const ArchPiece& piece : m_arch.neighbours(sizes.fdi)) {
                gums += piece.tooth ? 0 : 1;
                if (!piece.tooth)
                    continue;
                teeth.insert(piece.fdi);
                // The distance is half the width of both crowns, on the correct side; +x is distal.
                const glm::dvec3 at(piece.place[3]);
                const double apart = 0.5 * (sizes.crownWidthMm + findToothSizes(leftFellow(piece.fdi))->crownWidthMm);
                const bool distal = piece.fdi == sizes.fdi + 1;
                QVERIFY2(std::abs(at.x) > 0.8 * apart && std::abs(at.x) < 1.1 * apart,
                         qPrintable(QString("%1 beside %2 at %3").arg(piece.fdi).arg(sizes.fdi).arg(at.x)));
                QCOMPARE(at.x > 0.0, distal);
                QCOMPARE(glm::determinant(glm::dmat3(piece.place)) < 0.0, isRight(piece.fdi));
            }
            const int position = sizes.fdi % 10;
            std::set<int> wanted{position == 1 ? (sizes.fdi == 21 ? 11 : 41) : sizes.fdi - 1};
            if (position < 8)
                wanted.insert(sizes.fdi + 1);
            QCOMPARE(teeth, wanted);
            QCOMPARE(gums, position < 8 ? 3 : 2);
        }
        QVERIFY(m_arch.neighbours(0).empty());
        QVERIFY(m_arch.neighbours(46).empty());
    }

    void sameEveryTime()
    {
        const Arch again;
        const auto one = m_arch.mouth(0.2);
        const auto two = again.mouth(0.2);
        QCOMPARE(one.size(), two.size());
        for (std::size_t k = 0; k < one.size(); ++k) {
            QVERIFY(one[k].place == two[k].place);
            QCOMPARE(one[k].mesh->vertices.size(), two[k].mesh->vertices.size());
            for (std::size_t v = 0; v < one[k].mesh->vertices.size(); ++v)
                QVERIFY(one[k].mesh->vertices[v].positionMm == two[k].mesh->vertices[v].positionMm);
        }
    }

private:
    const Arch m_arch;
};

CUSP_TEST(TestArch)
#include "tst_arch.moc"
