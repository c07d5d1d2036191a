// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/teeth/Arch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include "core/teeth/Gums.h"
#include "core/teeth/LookMeshes.h"
#include "core/teeth/ToothTable.h"
#include "core/teeth/TriangleSamples.h"

namespace core::teeth {
namespace {

/// Lean of the long axis, crown towards lip or cheek, degrees, central incisor to third molar. It is 33 and 27 for the
/// central incisors, falls to about 0 at the second premolars, and then rises in the upper and falls in the lower jaw
/// (Tong and others 2012, 76 persons). The values in between are from textbooks, rounded.
constexpr std::array<double, 8> kUpperLeanDeg{28, 26, 16, 5, 0, 6, 8, 10};
constexpr std::array<double, 8> kLowerLeanDeg{24, 22, 12, 5, 0, -8, -14, -18};

/// The hinge of the jaw joints, behind and above the incisal edges, mm. Bonwill's triangle has sides of 100 mm, and the
/// joints are some 35 mm above the occlusal plane.
constexpr double kHingeBackMm = 85.0;
constexpr double kHingeUpMm = 35.0;
/// The upper incisal edges bite in front of and over the lower ones, mm (textbook means).
constexpr double kOverjetMm = 2.5;
constexpr double kOverbiteMm = 2.0;

/// Distance at which teeth count as touching, mm.
constexpr double kTouchMm = 0.12;
constexpr double kContactCellMm = 0.08;
/// Height of the papilla's tip: this far below the contact, but at most the second value above the margin; mm.
constexpr double kBelowContactMm = 0.2;
constexpr double kHighestPapillaMm = 3.6;

std::size_t indexOf(int fdi)
{
    return static_cast<std::size_t>(fdi < 30 ? fdi - 21 : fdi - 31 + 8);
}

int fdiOf(std::size_t index)
{
    return static_cast<int>(index < 8 ? 21 + index : 31 + index - 8);
}

const glm::dmat4& mirror()
{
    static const glm::dmat4 matrix = glm::scale(glm::dmat4(1.0), glm::dvec3(-1.0, 1.0, 1.0));
    return matrix;
}

/// Sets the neck of a tooth: the CEJ at its outermost and at its innermost place. The end of the tooth is the distal
/// end of the CEJ. Returns the height of that end.
double findNeck(const CoarseTooth& tooth, const glm::dmat4& jawFromTooth, const ArchCurve& curve, GumTooth& gum)
{
    double outermost = -1.0e9;
    double innermost = 1.0e9;
    double distalNeckMm = 0.0;
    gum.toMm = -1.0e9;
    for (const std::uint32_t k : tooth.cervix) {
        const glm::dvec3 p(jawFromTooth * glm::dvec4(tooth.mesh.vertices[k], 1.0));
        const ArchPlace place = curve.placeOf(glm::dvec2(p));
        if (place.outwardMm > outermost) {
            outermost = place.outwardMm;
            gum.facialNeckMm = p.z;
        }
        if (place.outwardMm < innermost) {
            innermost = place.outwardMm;
            gum.lingualNeckMm = p.z;
        }
        if (place.alongMm > gum.toMm) {
            gum.toMm = place.alongMm;
            distalNeckMm = p.z;
        }
    }
    return distalNeckMm;
}

/// Returns the point of the crown on the arch curve: incisal edge, tip of the canine or of the buccal cusp.
glm::dvec3 archPoint(const CoarseTooth& tooth, int fdi)
{
    const double buccal = buccalSign(fdi);
    glm::dvec3 highest(0.0, 0.0, -1.0e9);
    for (std::size_t k = 0; k < tooth.crownVertices; ++k) {
        const glm::dvec3 p(tooth.mesh.vertices[k]);
        if (p.z > highest.z && (fdi % 10 <= 3 || p.y * buccal > 0.5))
            highest = p;
    }
    return {0.0, highest.y, highest.z};
}

glm::dmat4 standAt(const ArchCurve& curve, int fdi, const glm::dvec3& point, double alongMm)
{
    const std::size_t position = static_cast<std::size_t>(fdi % 10) - 1;
    const double lean = glm::radians((jawOf(fdi) == Jaw::Upper ? kUpperLeanDeg : kLowerLeanDeg).at(position));
    const glm::dvec3 along(curve.tangent(alongMm), 0.0);
    const glm::dvec3 outward(curve.outward(alongMm), 0.0);
    const glm::dvec3 up(0.0, 0.0, 1.0);
    const glm::dvec3 axis = std::cos(lean) * up + std::sin(lean) * outward;
    const glm::dvec3 facing = buccalSign(fdi) * (std::cos(lean) * outward - std::sin(lean) * up);
    glm::dmat4 stand(glm::dvec4(along, 0.0), glm::dvec4(facing, 0.0), glm::dvec4(axis, 0.0),
                     glm::dvec4(0.0, 0.0, 0.0, 1.0));
    const glm::dvec3 at = glm::dvec3(curve.point(alongMm), 0.0) - glm::dvec3(stand * glm::dvec4(point, 0.0));
    stand[3] = glm::dvec4(at, 1.0);
    return stand;
}

/// Returns the side of a crown along the arch: its extent over (across the arch, z).
SampleMap sideOf(const CoarseTooth& tooth, const glm::dmat4& jawFromTooth, glm::dvec2 along, bool farSide)
{
    const glm::dvec2 across{along.y, -along.x};
    std::vector<glm::dvec3> points;
    points.reserve(tooth.crownVertices);
    for (std::size_t k = 0; k < tooth.crownVertices; ++k) {
        const glm::dvec3 p(jawFromTooth * glm::dvec4(tooth.mesh.vertices[k], 1.0));
        points.emplace_back(glm::dot(glm::dvec2(p), across), p.z, glm::dot(glm::dvec2(p), along));
    }
    // All maps have the same frame, because no jaw is wider than this across the arch.
    SampleMap map({-60.0, -12.0}, {60.0, 1.0}, kContactCellMm, farSide ? -1.0e9 : 1.0e9);
    for (const auto& t : tooth.mesh.triangles) {
        if (std::max({t[0], t[1], t[2]}) >= tooth.crownVertices)
            continue;
        sampleTriangle(map, points[t[0]], points[t[1]], points[t[2]], [farSide](double& most, double reach) {
            most = farSide ? std::max(most, reach) : std::min(most, reach);
        });
    }
    return map;
}

/// Returns the smallest distance along the arch, and its place.
ArchContact contactOf(const SampleMap& far, const SampleMap& near, glm::dvec2 along)
{
    ArchContact contact;
    contact.gapMm = 1.0e9;
    for (std::size_t k = 0; k < far.values.size(); ++k)
        if (far.values[k] > -1.0e8 && near.values[k] < 1.0e8)
            contact.gapMm = std::min(contact.gapMm, near.values[k] - far.values[k]);
    glm::dvec3 sum(0.0);
    int cells = 0;
    contact.lowestMm = 0.0;
    for (int row = 0; row < far.rows; ++row) {
        for (int column = 0; column < far.columns; ++column) {
            const double from = far.at(column, row);
            const double to = near.at(column, row);
            if (from < -1.0e8 || to > 1.0e8 || to - from > contact.gapMm + kTouchMm)
                continue;
            const glm::dvec2 p = far.nodeMm(column, row);
            const glm::dvec2 across{along.y, -along.x};
            sum += glm::dvec3(p.x * across + 0.5 * (from + to) * along, p.y);
            contact.lowestMm = std::min(contact.lowestMm, p.y);
            ++cells;
        }
    }
    contact.middleMm = sum / static_cast<double>(std::max(cells, 1));
    return contact;
}

/// Length of roots below the CEJ, mm. They are cut off deeper under the gum, where they are not visible.
constexpr double kRootStumpMm = 2.5;

/// Depths below the neck at which the gum beside a single tooth begins to fade, and at which it has vanished. The same
/// for the root of a neighbour.
constexpr double kFadeFromMm = 0.8;
constexpr double kFadeToMm = 3.8;
constexpr double kRootFadeFromMm = -0.2;
constexpr double kRootFadeToMm = 0.9;
/// The same at the place where the gum would continue to the next tooth.
constexpr double kEndFadeFromMm = 0.8;
constexpr double kEndFadeToMm = 5.0;

void cutRoot(LookMesh& mesh, const CoarseTooth& tooth)
{
    float neck = 0.0F;
    for (const std::uint32_t k : tooth.cervix)
        neck = std::min(neck, tooth.mesh.vertices[k].z);
    const float end = neck - static_cast<float>(kRootStumpMm);
    std::vector<std::uint32_t> left;
    for (std::size_t k = 0; k < mesh.indices.size(); k += 3)
        if (std::any_of(mesh.indices.data() + k, mesh.indices.data() + k + 3,
                        [&](std::uint32_t v) { return mesh.vertices[v].positionMm.z > end; }))
            left.insert(left.end(), mesh.indices.data() + k, mesh.indices.data() + k + 3);
    mesh.indices = std::move(left);
    // Unused vertices are removed, because they would be uploaded to the graphics card.
    std::vector<std::uint32_t> moved(mesh.vertices.size(), 0xFFFFFFFFU);
    std::vector<LookVertex> vertices;
    for (std::uint32_t& k : mesh.indices) {
        if (moved[k] == 0xFFFFFFFFU) {
            moved[k] = static_cast<std::uint32_t>(vertices.size());
            vertices.push_back(mesh.vertices[k]);
        }
        k = moved[k];
    }
    mesh.vertices = std::move(vertices);
}

LookMesh lookMesh(const CoarseTooth& tooth)
{
    LookMesh mesh;
    for (std::size_t k = 0; k < tooth.mesh.vertices.size(); ++k)
        mesh.vertices.push_back({tooth.mesh.vertices[k], glm::vec3(0.0F), 1.0F,
                                 static_cast<float>(k < tooth.crownVertices ? Tissue::Enamel : Tissue::Root)});
    for (const auto& t : tooth.mesh.triangles)
        mesh.indices.insert(mesh.indices.end(), t.begin(), t.end());
    smoothNormals(mesh);
    return mesh;
}

}  // namespace

int leftFellow(int fdi)
{
    const int position = fdi % 10;
    if (fdi < 11 || fdi > 48 || position < 1 || position > 8)
        return 0;
    return (fdi / 10 <= 2 ? 20 : 30) + position;
}

glm::dmat4 mouthFromJaw(Jaw jaw, double openRad)
{
    if (jaw == Jaw::Upper)
        return glm::scale(glm::dmat4(1.0), glm::dvec3(1.0, 1.0, -1.0));
    const glm::dvec3 hinge(0.0, kHingeBackMm, kHingeUpMm);
    // Rotates about +x, which turns the front (-y) downwards.
    glm::dmat4 open = glm::translate(glm::dmat4(1.0), hinge);
    open = glm::rotate(open, openRad, glm::dvec3(1.0, 0.0, 0.0));
    open = glm::translate(open, -hinge);
    return glm::translate(open, glm::dvec3(0.0, kOverjetMm, kOverbiteMm));
}

Arch::Arch()
{
    for (std::size_t k = 0; k < 16; ++k)
        m_teeth.push_back(generateCoarseTooth(fdiOf(k)).value());
    for (const Jaw jaw : {Jaw::Upper, Jaw::Lower}) {
        place(jaw);
        dress(jaw);
    }
}

glm::dmat4 Arch::jawFromTooth(int fdi) const
{
    return m_jawFromTooth.at(indexOf(fdi));
}

const CoarseTooth& Arch::tooth(int fdi) const
{
    return m_teeth.at(indexOf(fdi));
}

/// Places the teeth from the midline backwards, each in contact with the one before.
void Arch::place(Jaw jaw)
{
    const ArchCurve curve(jaw);
    double alongMm = 0.0;
    for (int position = 1; position <= 8; ++position) {
        const int fdi = (jaw == Jaw::Upper ? 20 : 30) + position;
        const CoarseTooth& one = tooth(fdi);
        const glm::dvec3 point = archPoint(one, fdi);
        const double halfMm = 0.5 * findToothSizes(fdi)->crownWidthMm;
        glm::dmat4& stand = m_jawFromTooth.at(indexOf(fdi));
        ArchContact contact;
        if (position == 1) {
            // The tooth on the other side is its mirror image, so both touch the plane between them.
            alongMm = halfMm;
            for (int pass = 0; pass < 12; ++pass) {
                stand = standAt(curve, fdi, point, alongMm);
                double nearest = 1.0e9;
                for (std::size_t k = 0; k < one.crownVertices; ++k)
                    nearest = std::min(nearest, (stand * glm::dvec4(one.mesh.vertices[k], 1.0)).x);
                contact.gapMm = 2.0 * nearest;
                alongMm -= pass < 11 ? nearest : 0.0;
            }
            const glm::dvec2 along(1.0, 0.0);
            const SampleMap near = sideOf(one, stand, along, false);
            SampleMap far = near;
            for (double& x : far.values)
                x = x < 1.0e8 ? -x : -1.0e9;
            const double gap = contact.gapMm;
            contact = contactOf(far, near, along);
            contact.gapMm = gap;
            contact.mesialFdi = fdi < 30 ? 11 : 41;
        } else {
            const CoarseTooth& before = tooth(fdi - 1);
            const double halfBefore = 0.5 * findToothSizes(fdi - 1)->crownWidthMm;
            const glm::dvec2 along = curve.tangent(alongMm + halfBefore);
            const SampleMap far = sideOf(before, jawFromTooth(fdi - 1), along, true);
            alongMm += halfBefore + halfMm;
            for (int pass = 0; pass < 12; ++pass) {
                stand = standAt(curve, fdi, point, alongMm);
                contact = contactOf(far, sideOf(one, stand, along, false), along);
                if (std::abs(contact.gapMm) < 0.002 || pass == 11)
                    break;
                alongMm -= contact.gapMm;
            }
            contact.mesialFdi = fdi - 1;
        }
        contact.distalFdi = fdi;
        m_contacts.push_back(contact);
    }
}

/// Builds the display meshes of teeth and gums, and computes the light between them.
void Arch::dress(Jaw jaw)
{
    const ArchCurve curve(jaw);
    std::vector<std::shared_ptr<LookMesh>> meshes;
    std::vector<GumTooth> teeth;
    double fromMm = 0.0;
    double firstPapillaMm = 0.0;
    const auto touching = [&](int mesial, int behind) -> const ArchContact& {
        return *std::find_if(m_contacts.begin(), m_contacts.end(),
                             [&](const ArchContact& c) { return c.mesialFdi == mesial && c.distalFdi == behind; });
    };
    for (int position = 1; position <= 8; ++position) {
        const int fdi = (jaw == Jaw::Upper ? 20 : 30) + position;
        const CoarseTooth& one = tooth(fdi);
        const glm::dmat4 stand = jawFromTooth(fdi);
        meshes.push_back(std::make_shared<LookMesh>(lookMesh(one)));
        softenGrooves(*meshes.back(), one.crownVertices);
        GumTooth gum;
        gum.mesh = meshes.back().get();
        gum.jawFromTooth = stand;
        const double distalNeckMm = findNeck(one, stand, curve, gum);
        const auto papilla = [&](double lowestMm) {
            return std::min(lowestMm - kBelowContactMm, gum.facialNeckMm + kHighestPapillaMm);
        };
        if (position == 1)
            firstPapillaMm = papilla(touching(jaw == Jaw::Upper ? 11 : 41, fdi).lowestMm);
        gum.fromMm = fromMm;
        if (position < 8) {
            const ArchContact& contact = touching(fdi, fdi + 1);
            gum.toMm = curve.placeOf(glm::dvec2(contact.middleMm)).alongMm;
            gum.papillaMm = papilla(contact.lowestMm);
        } else {
            for (std::size_t k = 0; k < one.crownVertices; ++k)
                gum.toMm = std::max(gum.toMm,
                                    curve.placeOf(glm::dvec2(stand * glm::dvec4(one.mesh.vertices[k], 1.0))).alongMm);
            gum.papillaMm = distalNeckMm + 1.2;
        }
        fromMm = gum.toMm;
        teeth.push_back(gum);
    }
    Gums gums = makeGums(jaw, curve, teeth, firstPapillaMm);
    for (std::size_t k = 0; k < meshes.size(); ++k)
        cutRoot(*meshes[k], tooth((jaw == Jaw::Upper ? 21 : 31) + static_cast<int>(k)));

    SampleMap skyline({0.0, -20.0}, {50.0, 90.0}, 0.35, kNothingMm);
    for (std::size_t k = 0; k < meshes.size(); ++k)
        addToSkyline(skyline, *meshes[k], teeth[k].jawFromTooth);
    for (const LookMesh& gum : gums.around)
        addToSkyline(skyline, gum, glm::dmat4(1.0));
    addToSkyline(skyline, gums.base, glm::dmat4(1.0));
    const int first = jaw == Jaw::Upper ? 21 : 31;
    for (std::size_t k = 0; k < meshes.size(); ++k) {
        findOpenness(*meshes[k], teeth[k].jawFromTooth, skyline);
        softenShade(*meshes[k]);
        findBall(*meshes[k]);
        m_pieces.push_back({first + static_cast<int>(k), true, jaw, meshes[k], teeth[k].jawFromTooth});
    }
    const auto keep = [&](LookMesh&& mesh, int fdi) {
        findOpenness(mesh, glm::dmat4(1.0), skyline);
        findBall(mesh);
        m_pieces.push_back({fdi, false, jaw, std::make_shared<LookMesh>(std::move(mesh)), glm::dmat4(1.0)});
    };
    for (std::size_t k = 0; k < gums.around.size(); ++k)
        keep(std::move(gums.around[k]), first + static_cast<int>(k));
    keep(std::move(gums.base), 0);
    keep(std::move(gums.shell), 0);
    m_skylines.push_back(std::move(skyline));
}

std::vector<ArchPiece> Arch::mouth(double openRad) const
{
    std::vector<ArchPiece> pieces;
    for (const bool right : {false, true}) {
        for (const Piece& piece : m_pieces) {
            const glm::dmat4 here = mouthFromJaw(piece.jaw, openRad) * (right ? mirror() : glm::dmat4(1.0));
            const int other = piece.jaw == Jaw::Upper ? -10 : 10;
            pieces.push_back({piece.fdi == 0 ? 0 : piece.fdi + (right ? other : 0), piece.tooth,
                              piece.jaw == Jaw::Upper, piece.mesh, here * piece.jawFromPiece});
        }
    }
    return pieces;
}

std::vector<ArchPiece> Arch::neighbours(int fdi) const
{
    std::vector<ArchPiece> pieces;
    if (fdi == 0 || leftFellow(fdi) != fdi)
        return pieces;
    const glm::dmat4 toothFromJaw = glm::inverse(jawFromTooth(fdi));
    const int across = fdi == 21 ? 11 : fdi == 31 ? 41 : 0;
    for (const Piece& piece : m_pieces) {
        const bool own = piece.fdi == fdi;
        const auto add = [&](int number, const glm::dmat4& jawFromHere, const ArchContact* end) {
            pieces.push_back({number, piece.tooth, piece.jaw == Jaw::Upper, fading(piece, piece.tooth ? nullptr : end),
                              toothFromJaw * jawFromHere * piece.jawFromPiece});
        };
        if (std::abs(piece.fdi - fdi) <= 1 && !(own && piece.tooth))
            add(piece.fdi, glm::dmat4(1.0), own ? nullptr : endOf(piece.fdi, piece.fdi > fdi));
        if (own && across != 0)
            add(across, mirror(), endOf(fdi, true));
    }
    return pieces;
}

/// Returns the contact of a tooth with the next or the previous one; null if there is no such tooth.
const ArchContact* Arch::endOf(int fdi, bool distal) const
{
    const auto found = std::find_if(m_contacts.begin(), m_contacts.end(), [&](const ArchContact& contact) {
        return (distal ? contact.mesialFdi : contact.distalFdi) == fdi;
    });
    return found == m_contacts.end() ? nullptr : &*found;
}

/// Returns the height of the neck of a tooth in the frame of its jaw: the mean of its CEJ.
double Arch::neckMm(int fdi) const
{
    const CoarseTooth& one = tooth(fdi);
    double sum = 0.0;
    for (const std::uint32_t k : one.cervix)
        sum += (jawFromTooth(fdi) * glm::dvec4(one.mesh.vertices[k], 1.0)).z;
    return sum / static_cast<double>(one.cervix.size());
}

/// Returns a copy of a tooth or its gum that fades below the neck and towards one end.
std::shared_ptr<const LookMesh> Arch::fading(const Piece& piece, const ArchContact* end) const
{
    auto faded = std::make_shared<LookMesh>();
    if (piece.tooth) {
        const CoarseTooth one = generateCoarseTooth(piece.fdi, MeshDetail::medium()).value();
        *faded = lookMesh(one);
        findOpenness(*faded, piece.jawFromPiece, m_skylines.at(piece.jaw == Jaw::Upper ? 0 : 1));
        shadeGrooves(*faded, one.crownVertices);
        cutRoot(*faded, one);
        findBall(*faded);
    } else {
        *faded = *piece.mesh;
    }
    const ArchCurve curve(piece.jaw);
    const double endMm = end != nullptr ? curve.placeOf(glm::dvec2(end->middleMm)).alongMm : 0.0;
    // Between two teeth, the height is blended from the heights of their necks.
    struct Neck
    {
        glm::dvec2 at{0.0};
        double heightMm = 0.0;
    };
    std::vector<Neck> necks;
    for (int position = 1; position <= 8; ++position)
        if (const int fdi = piece.fdi / 10 * 10 + position; fdi == piece.fdi || !piece.tooth)
            necks.push_back({glm::dvec2(jawFromTooth(fdi)[3]), neckMm(fdi)});
    for (LookVertex& v : faded->vertices) {
        const glm::dvec3 p(piece.jawFromPiece * glm::dvec4(v.positionMm, 1.0));
        double neck = 0.0;
        double weights = 0.0;
        for (const Neck& one : necks) {
            const glm::dvec2 away = glm::dvec2(p) - one.at;
            const double weight = 1.0 / (1.0 + glm::dot(away, away));
            neck += weight * one.heightMm;
            weights += weight;
        }
        const double below = neck / weights - p.z;
        double shown = 1.0;
        if (!piece.tooth)
            shown -= eased(kFadeFromMm, kFadeToMm, below);
        else if (v.tissue > 0.5F)
            shown -= eased(kRootFadeFromMm, kRootFadeToMm, below);
        if (end != nullptr)
            shown *= eased(kEndFadeFromMm, kEndFadeToMm, std::abs(curve.placeOf(glm::dvec2(p)).alongMm - endMm));
        v.shown = static_cast<float>(shown);
    }
    return faded;
}

std::size_t Arch::triangles() const
{
    std::size_t count = 0;
    for (const Piece& piece : m_pieces)
        count += piece.mesh->indices.size() / 3;
    return 2 * count;
}

}  // namespace core::teeth
