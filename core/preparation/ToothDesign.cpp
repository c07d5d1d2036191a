// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/preparation/ToothDesign.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>

namespace core::preparation {
namespace {

constexpr std::array<std::string_view, 8> kKinds{"class1",      "class1-buccal", "class2-mesial", "class2-distal",
                                                 "slot-mesial", "slot-distal",   "access",        "occlusal-reduction"};
constexpr std::array<int, 8> kPosterior{24, 25, 26, 27, 34, 35, 36, 37};
constexpr std::array<int, 2> kBuccal{36, 37};
constexpr std::array<int, 2> kAccess{21, 36};

enum class Use : std::uint8_t { Occlusal, Box, Access, Reduction, Cavity };

struct Entry
{
    Use use;
    NumberField<ToothDesign> field;
};

constexpr std::array<Entry, 18> kEntries{{
    {Use::Occlusal, {"isthmus_mm", "width of the isthmus", "mm", &ToothDesign::isthmusMm, 0.6, 4.0}},
    {Use::Occlusal, {"depth_mm", "depth of the pulpal floor", "mm", &ToothDesign::depthMm, 0.5, 3.5}},
    {Use::Occlusal, {"dovetail_mm", "width of the dovetail", "mm", &ToothDesign::dovetailMm, 0.0, 1.5}},
    {Use::Occlusal, {"groove_mm", "extension into the grooves", "mm", &ToothDesign::grooveMm, 0.0, 2.5}},
    {Use::Occlusal, {"ridge_mm", "marginal ridge that is left", "mm", &ToothDesign::ridgeMm, 0.5, 3.0}},
    {Use::Occlusal,
     {"oblique_mm", "ridge across the tooth that is left on each side", "mm", &ToothDesign::obliqueMm, 0.0, 2.0}},
    {Use::Occlusal, {"diverge_deg", "divergence of the end walls", "degrees", &ToothDesign::divergeDeg, 0.0, 20.0}},
    {Use::Cavity, {"bur_radius_mm", "radius of the bur", "mm", &ToothDesign::burRadiusMm, 0.25, 1.2}},
    {Use::Cavity, {"line_angle_mm", "radius between floor and wall", "mm", &ToothDesign::lineAngleMm, 0.0, 1.2}},
    {Use::Occlusal,
     {"follows_junction", "floor along the junction", "", &ToothDesign::followsJunction, 0.0, 1.0, true}},
    {Use::Occlusal, {"into_dentin_mm", "depth of the floor in dentin", "mm", &ToothDesign::intoDentinMm, 0.0, 2.0}},
    {Use::Box, {"box_floor_mm", "depth of the gingival floor", "mm", &ToothDesign::boxFloorMm, 0.0, 5.0}},
    {Use::Box, {"box_axial_mm", "depth of the axial wall", "mm", &ToothDesign::boxAxialMm, 0.5, 3.0}},
    {Use::Box, {"box_width_mm", "width of the box", "mm", &ToothDesign::boxWidthMm, 1.0, 7.0}},
    {Use::Access, {"access_lean_deg", "lean of the access walls", "degrees", &ToothDesign::accessLeanDeg, 0.0, 20.0}},
    {Use::Access, {"access_margin_mm", "margin around the chamber", "mm", &ToothDesign::accessMarginMm, 0.0, 1.0}},
    {Use::Reduction, {"reduction_mm", "occlusal reduction", "mm", &ToothDesign::reductionMm, 0.5, 3.0}},
    {Use::Reduction,
     {"functional_mm", "reduction of the functional cusps", "mm", &ToothDesign::functionalMm, 0.5, 3.0}},
}};

bool isUsed(Kind kind, Use use)
{
    switch (use) {
    case Use::Occlusal:
        return hasOcclusalPart(kind);
    case Use::Box:
        return kind != Kind::ClassOne && kind != Kind::Access && kind != Kind::OcclusalReduction;
    case Use::Access:
        return kind == Kind::Access;
    case Use::Reduction:
        return kind == Kind::OcclusalReduction;
    default:  // Cavity
        return kind != Kind::OcclusalReduction;
    }
}

std::span<const int> teethFor(Kind kind)
{
    switch (kind) {
    case Kind::Access:
        return kAccess;
    case Kind::ClassOneBuccal:
        return kBuccal;
    default:
        return kPosterior;
    }
}

/// Sets the sizes of a box that differ from those of the Class II on this tooth.
void shapeBox(Kind kind, int fdi, ToothDesign& design)
{
    const bool isMolar = fdi % 10 >= 6;
    if (isSlot(kind)) {
        design.boxFloorMm = 3.0;
        design.boxWidthMm = isMolar ? 3.0 : 2.5;
        design.boxAxialMm = 1.5;
    } else if (kind == Kind::ClassOneBuccal) {
        design.boxWidthMm = 1.5;
        design.boxAxialMm = 1.3;
    }
}

}  // namespace

bool isSlot(Kind kind)
{
    return kind == Kind::SlotMesial || kind == Kind::SlotDistal;
}

bool hasOcclusalPart(Kind kind)
{
    return kind != Kind::Access && kind != Kind::OcclusalReduction && !isSlot(kind);
}

std::string_view kindId(Kind kind)
{
    return kKinds.at(static_cast<std::size_t>(kind));
}

Result<Kind> findKind(std::string_view id)
{
    const auto found = std::find(kKinds.begin(), kKinds.end(), id);
    if (found != kKinds.end())
        return static_cast<Kind>(found - kKinds.begin());
    std::string known;
    for (const std::string_view kind : kKinds)
        known.append(known.empty() ? "" : ", ").append(kind);
    return unexpected(ErrorCode::UnknownName, LocalizableText{"there is no preparation '%1'; choose one of %2",
                                                              {noted(std::string(id)), noted(std::move(known))}});
}

std::vector<NumberField<ToothDesign>> fieldsOf(Kind kind)
{
    std::vector<NumberField<ToothDesign>> fields;
    for (const Entry& entry : kEntries)
        if (isUsed(kind, entry.use))
            fields.push_back(entry.field);
    return fields;
}

Result<ToothDesign> usualDesign(Kind kind, int fdi)
{
    const std::span<const int> teeth = teethFor(kind);
    if (std::find(teeth.begin(), teeth.end(), fdi) == teeth.end()) {
        std::string known;
        for (const int tooth : teeth)
            known.append(known.empty() ? "" : ", ").append(std::to_string(tooth));
        return unexpected(
            ErrorCode::UnknownName,
            LocalizableText{"the preparation '%1' is not made for tooth %2; it is for %3",
                            {noted(std::string(kindId(kind))), noted(std::to_string(fdi)), noted(std::move(known))}});
    }
    ToothDesign design;
    if (fdi % 10 >= 6) {
        design.isthmusMm = 1.25;
        design.grooveMm = 0.6;
        design.ridgeMm = 2.0;
        design.boxWidthMm = 4.0;
    } else {
        design.boxAxialMm = 1.5;
    }
    shapeBox(kind, fdi, design);
    return design;
}

Status validate(Kind kind, const ToothDesign& design)
{
    const std::vector<NumberField<ToothDesign>> fields = fieldsOf(kind);
    if (Status numbers = validateNumbers(std::span<const NumberField<ToothDesign>>(fields), design); !numbers)
        return numbers;
    if (design.lineAngleMm > design.burRadiusMm)
        return unexpected(
            ErrorCode::OutOfRange,
            LocalizableText{"the radius between floor and wall (line_angle_mm) is more than the radius of the "
                            "bur (bur_radius_mm): no bur leaves that"});
    if (hasOcclusalPart(kind) && design.isthmusMm < 2.0 * design.burRadiusMm)
        return unexpected(ErrorCode::OutOfRange,
                          LocalizableText{"the width of the isthmus (isthmus_mm) is less than the bur is wide (twice "
                                          "bur_radius_mm)"});
    return {};
}

std::string_view notModelled(Kind kind)
{
    switch (kind) {
    case Kind::ClassOne:
        return "Buccal and lingual walls that converge towards the outside are upright here: a height map has no "
               "undercuts.";
    case Kind::ClassOneBuccal:
        return "Walls that converge towards the outside are upright here, and the bur comes from above where a hand "
               "would come from the buccal side: a height map has no undercuts.";
    case Kind::ClassTwoMesial:
    case Kind::ClassTwoDistal:
    case Kind::SlotMesial:
    case Kind::SlotDistal:
        return "Walls that converge, a box wider at the gingiva than above, retention grooves and a gingival bevel are "
               "not there, and the neighbour is none that could be touched: a height map has no undercuts.";
    case Kind::OcclusalReduction:
        return "Axial walls, the finish line, the neighbours and the opposing teeth are not there: the depth is judged "
               "along the bur, not as the clearance from the opposing tooth.";
    default:
        return "All is cut straight down from above: the access of a front tooth, which leans in from its lingual "
               "side, frees only so much of the chamber as lies behind the edge, and canals are not entered.";
    }
}

}  // namespace core::preparation
