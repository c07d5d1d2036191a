// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/NumberField.h"
#include "core/base/Result.h"

namespace core::preparation {

/// The preparations of a tooth that are made by rule.
enum class Kind : std::uint8_t {
    ClassOne,
    ClassOneBuccal,  ///< with an extension along the mesiobuccal groove through the buccal surface
    ClassTwoMesial,  ///< as far as a height field goes, see notModelled()
    ClassTwoDistal,
    SlotMesial,  ///< the box of a Class II alone
    SlotDistal,
    Access,            ///< opening of the pulp chamber
    OcclusalReduction  ///< the occlusal surface is lowered for a crown
};

/// "class1", "class1-buccal", "class2-mesial", "class2-distal", "slot-mesial", "slot-distal", "access",
/// "occlusal-reduction".
[[nodiscard]] std::string_view kindId(Kind kind);
/// UnknownName lists those there are.
[[nodiscard]] Result<Kind> findKind(std::string_view id);

/// The figures of a preparation. Those of a Class I are the ideals of docs/teeth.md (Sturdevant and the courses
/// named there); boxes, and everything that has no source there, are estimates that a teacher may set.
struct ToothDesign
{
    double isthmusMm = 1.0;        ///< width across the central groove
    double depthMm = 1.5;          ///< of the floor below the mouth of the central groove, on average along it
    double dovetailMm = 0.35;      ///< the ends are so much wider than the isthmus, on each side
    double grooveMm = 0.4;         ///< the outline runs so far from the isthmus into a buccal or lingual groove
    double ridgeMm = 1.6;          ///< of marginal ridge that is left at least, from outline to proximal surface
    double obliqueMm = 0.4;        ///< the same on each side of an oblique (26, 27) or transverse (34) ridge
    double divergeDeg = 7.0;       ///< the mesial and distal wall lean outwards from upright
    double burRadiusMm = 0.4;      ///< no inner corner is tighter: No. 330 and 245
    double lineAngleMm = 0.2;      ///< radius between floor and wall: the end of a No. 245
    double followsJunction = 0.0;  ///< 1: the floor runs along the enamel-dentin junction; 0: it is flat
    double intoDentinMm = 0.3;     ///< then so deep below it
    double boxFloorMm = 1.5;       ///< gingival floor below the pulpal floor; of a slot, below the marginal ridge
    double boxAxialMm = 1.8;       ///< axial wall behind the greatest bulge of the surface that the box opens
    double boxWidthMm = 3.0;       ///< of the box, between the walls on both sides of its opening
    double accessLeanDeg = 4.0;    ///< access: the walls lean outwards from upright
    double accessMarginMm = 0.1;   ///< access: the floor's outline stands so far outside the chamber's
    double reductionMm = 1.5;      ///< reduction: the occlusal surface is lowered by so much,
    double functionalMm = 2.0;     ///< and over the functional cusps by so much
    bool operator==(const ToothDesign&) const = default;
};

/// The numbers that count for a kind.
[[nodiscard]] std::vector<NumberField<ToothDesign>> fieldsOf(Kind kind);

/// Whether a kind is a box alone.
[[nodiscard]] bool isSlot(Kind kind);

/// Whether a kind has a part in the occlusal surface with a pulpal floor.
[[nodiscard]] bool hasOcclusalPart(Kind kind);

/// What is usual for this kind on this tooth. UnknownName where the kind is not made for the tooth: Class I, Class II,
/// slots and the occlusal reduction for 24, 25, 26, 27, 34, 35, 36, 37; with an extension to the buccal for 36 and 37;
/// access for 21 and 36.
[[nodiscard]] Result<ToothDesign> usualDesign(Kind kind, int fdi);

/// Whether each number lies in its range and they go together.
[[nodiscard]] Status validate(Kind kind, const ToothDesign& design);

/// One English sentence: what a height map cannot show of this preparation.
[[nodiscard]] std::string_view notModelled(Kind kind);

}  // namespace core::preparation
