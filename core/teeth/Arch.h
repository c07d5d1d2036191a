// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "core/teeth/ArchCurve.h"
#include "core/teeth/ToothGenerator.h"
#include "core/teeth/TriangleSamples.h"

/// The whole mouth as a model for viewing: all 32 teeth in their arches, the gums, palate and tongue.
///
/// Mouth frame: mm, +x towards the patient's left, +y backwards, +z up (the axes of DICOM), origin between the incisal
/// edges of the upper central incisors, occlusal planes horizontal while the mouth is closed. Each jaw is worked out in
/// its jaw frame: the same x and y, z from the occlusal plane (0 at incisal edges and buccal cusps) towards the
/// opposing jaw; for the upper jaw that is left-handed. The right half is the mirror image of the left one.
namespace core::teeth {

enum class Tissue : std::uint8_t { Enamel, Root, Gum, Mucosa };

struct LookVertex
{
    glm::vec3 positionMm;
    glm::vec3 normal;
    float open;          ///< share of the light of a uniform sky that neighbours and gum let through, 0 to 1
    float tissue;        ///< a Tissue
    float shown = 1.0F;  ///< 0: faded out completely
};

/// Smooth triangles, counter-clockwise seen from outside.
struct LookMesh
{
    std::vector<LookVertex> vertices;
    std::vector<std::uint32_t> indices;
    glm::vec3 middleMm{0.0F};  ///< of a bounding sphere
    float radiusMm = 0.0F;
};

/// A mesh with its place. A tooth's mesh is in its tooth frame, that of a gum in its jaw frame.
struct ArchPiece
{
    int fdi = 0;        ///< the tooth, or the tooth of the gum; 0: palate, tongue
    bool tooth = true;  ///< otherwise soft tissue
    bool upper = true;  ///< the jaw
    std::shared_ptr<const LookMesh> mesh;
    glm::dmat4 place{1.0};  ///< scene from piece; mirrors (negative determinant) if the mesh is that of the other side
};

/// The contact of two neighbours of the left side, in the jaw frame.
struct ArchContact
{
    int mesialFdi = 0;
    int distalFdi = 0;
    glm::dvec3 middleMm{0.0};
    double lowestMm = 0.0;  ///< z at which they separate towards the gum
    double gapMm = 0.0;     ///< distance between them along the arch; negative: they overlap
};

class Arch
{
public:
    /// Builds the whole mouth, some hundred milliseconds; any thread but the ui thread. The same every time.
    Arch();

    /// Returns rotation and shift from a tooth's frame into its jaw's, for the left side: 21 to 28, 31 to 38.
    [[nodiscard]] glm::dmat4 jawFromTooth(int fdi) const;
    [[nodiscard]] const CoarseTooth& tooth(int fdi) const;
    [[nodiscard]] const std::vector<ArchContact>& contacts() const { return m_contacts; }

    /// Returns all pieces in the mouth frame, with the lower jaw rotated about the axis of the jaw joints.
    [[nodiscard]] std::vector<ArchPiece> mouth(double openRad) const;

    /// Returns the teeth beside a tooth of the left side and the gum around the three, in the frame of that tooth. The
    /// gum fades below the necks and towards the next teeth, and so do the roots. The neighbour of a central incisor is
    /// that of the right side; a third molar has no distal neighbour. Empty for a number that is not one of the
    /// sixteen. The teeth are built again in a finer mesh than that of mouth(), which takes some tens of milliseconds.
    [[nodiscard]] std::vector<ArchPiece> neighbours(int fdi) const;

    /// Returns the number of triangles of the whole mouth.
    [[nodiscard]] std::size_t triangles() const;

private:
    struct Piece
    {
        int fdi = 0;
        bool tooth = true;
        Jaw jaw = Jaw::Upper;
        std::shared_ptr<const LookMesh> mesh;
        glm::dmat4 jawFromPiece{1.0};
    };
    [[nodiscard]] const ArchContact* endOf(int fdi, bool distal) const;
    [[nodiscard]] double neckMm(int fdi) const;
    [[nodiscard]] std::shared_ptr<const LookMesh> fading(const Piece& piece, const ArchContact* end) const;
    void place(Jaw jaw);
    void dress(Jaw jaw);

    std::vector<CoarseTooth> m_teeth;  ///< 21 to 28, 31 to 38
    std::array<glm::dmat4, 16> m_jawFromTooth;
    std::vector<ArchContact> m_contacts;
    std::vector<Piece> m_pieces;        ///< of the left half
    std::vector<SampleMap> m_skylines;  ///< of the upper and the lower jaw: heights that hide the sky
};

/// Returns the tooth of the left side with the same mirrored shape: 36 for 46 and for 36. 0 for no tooth.
[[nodiscard]] int leftFellow(int fdi);
[[nodiscard]] inline bool isRight(int fdi)
{
    return fdi / 10 == 1 || fdi / 10 == 4;
}
[[nodiscard]] inline Jaw jawOf(int fdi)
{
    return fdi < 30 ? Jaw::Upper : Jaw::Lower;
}

/// Returns mouth from jaw, with the mouth opened by an angle.
[[nodiscard]] glm::dmat4 mouthFromJaw(Jaw jaw, double openRad);

}  // namespace core::teeth
