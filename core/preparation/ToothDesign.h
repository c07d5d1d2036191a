// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/NumberField.h"
#include "core/base/Result.h"

namespace core::preparation {

/// The preparations of a tooth that are constructed by rule.
enum class Kind : std::uint8_t {
    ClassOne,
    ClassOneBuccal,  ///< with an extension along the mesiobuccal groove through the buccal surface
    ClassTwoMesial,  ///< as far as a height field can represent it, see notModelled()
    ClassTwoDistal,
    SlotMesial,  ///< only the box of a Class II
    SlotDistal,
    Access,            ///< opening of the pulp chamber
    OcclusalReduction  ///< the occlusal surface is lowered for a crown
};

/// Returns "class1", "class1-buccal", "class2-mesial", "class2-distal", "slot-mesial", "slot-distal", "access" or
/// "occlusal-reduction".
[[nodiscard]] std::string_view kindId(Kind kind);
/// Returns the kind with this id. UnknownName lists the known ids.
[[nodiscard]] Result<Kind> findKind(std::string_view id);

/// The numbers of a preparation. Those of a Class I are the ideals of docs/teeth.md (Sturdevant and the courses named
/// there); boxes, and all numbers without a source there, are estimates that a teacher may change.
struct ToothDesign
{
    double isthmusMm = 1.0;        ///< width across the central groove
    double depthMm = 1.5;          ///< of the floor below the central groove, average along it
    double dovetailMm = 0.35;      ///< extra width of the ends over the isthmus, on each side
    double grooveMm = 0.4;         ///< length of the outline from the isthmus into a buccal or lingual groove
    double ridgeMm = 1.6;          ///< least width of the remaining marginal ridge, from outline to proximal surface
    double obliqueMm = 0.4;        ///< the same on each side of an oblique (26, 27) or transverse (34) ridge
    double divergeDeg = 7.0;       ///< outward lean of the mesial and distal walls from upright
    double burRadiusMm = 0.4;      ///< smallest radius of an inner corner: No. 330 and 245
    double lineAngleMm = 0.2;      ///< radius between floor and wall: the end of a No. 245
    double followsJunction = 0.0;  ///< 1: the floor follows the enamel-dentin junction; 0: it is flat
    double intoDentinMm = 0.3;     ///< depth of such a floor below the junction
    double boxFloorMm = 1.5;       ///< gingival floor below the pulpal floor; for a slot, below the marginal ridge
    double boxAxialMm = 1.8;       ///< depth of the axial wall from the greatest bulge of the surface that the box
                                   ///< opens
    double boxWidthMm = 3.0;       ///< of the box, between the walls on both sides of its opening
    double accessLeanDeg = 4.0;    ///< access: outward lean of the walls from upright
    double accessMarginMm = 0.1;   ///< access: distance of the floor's outline outside the chamber's
    double reductionMm = 1.5;      ///< reduction: lowering of the occlusal surface
    double functionalMm = 2.0;     ///< reduction: the same over the functional cusps
    bool operator==(const ToothDesign&) const = default;
};

/// Returns the numbers that a kind uses.
[[nodiscard]] std::vector<NumberField<ToothDesign>> fieldsOf(Kind kind);

/// Returns whether a kind is only a box.
[[nodiscard]] bool isSlot(Kind kind);

/// Returns whether a kind has an occlusal part with a pulpal floor.
[[nodiscard]] bool hasOcclusalPart(Kind kind);

/// Returns the usual numbers for this kind on this tooth. UnknownName if the kind is not available for the tooth: Class
/// I, Class II, slots and the occlusal reduction for 24, 25, 26, 27, 34, 35, 36, 37; with a buccal extension for 36 and
/// 37; access for 21 and 36.
[[nodiscard]] Result<ToothDesign> usualDesign(Kind kind, int fdi);

/// Checks that each number is in its range and that they are consistent.
[[nodiscard]] Status validate(Kind kind, const ToothDesign& design);

/// Returns one English sentence: what a height map cannot show of this preparation.
[[nodiscard]] std::string_view notModelled(Kind kind);

}  // namespace core::preparation
