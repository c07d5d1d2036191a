// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/bur/Bur.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>

#include "core/bur/BurFile.h"
#include "core/bur/BurTable.h"

namespace core::bur {
namespace {

constexpr std::array<std::string_view, kBurShapes> kShapeWords{"round",
                                                               "inverted-cone",
                                                               "straight",
                                                               "straight-crosscut",
                                                               "domed-crosscut",
                                                               "tapered",
                                                               "tapered-crosscut",
                                                               "pear",
                                                               "long-pear",
                                                               "egg",
                                                               "flame",
                                                               "cylinder",
                                                               "round-end-taper",
                                                               "chamfer"};

double heightOn(const Bur::Point& a, const Bur::Point& b, double radiusMm)
{
    const double span = b.radiusMm - a.radiusMm;
    return span == 0.0 ? a.heightMm : a.heightMm + (b.heightMm - a.heightMm) * (radiusMm - a.radiusMm) / span;
}

/// Returns the built-in burs. An entry that cannot be read ends the program with a message that names its line.
std::vector<Bur> compiledIn()
{
    auto burs = parseBurs(kBurTable);
    if (!burs) {
        std::fprintf(stderr, "core/bur/burs.txt: %s\n", burs.error().detail.c_str());
        std::abort();
    }
    return std::move(*burs);
}

/// The built-in burs, followed by the user's own.
struct Table
{
    std::vector<Bur> burs = compiledIn();
    std::size_t own = burs.size();

    Table() { burs.reserve(own + 1); }
};

Table& table()
{
    static Table burs;
    return burs;
}

}  // namespace

std::string_view shapeWord(BurShape shape)
{
    return kShapeWords.at(static_cast<std::size_t>(shape));
}

bool Bur::isCrosscut() const
{
    return shape == BurShape::StraightCrosscut || shape == BurShape::DomedCrosscut ||
           shape == BurShape::TaperedCrosscut;
}

std::string Bur::isoSize() const
{
    constexpr long kFourDigits = 1000;  // the first digit is dropped
    return std::to_string(kFourDigits + std::lround(20.0 * headRadiusMm)).substr(1);
}

double Bur::bendMm() const
{
    return hasCone() ? cornerMm * (coneSlope / std::sqrt(1.0 + coneSlope * coneSlope)) : cornerMm;
}

double Bur::undersideMm(double radiusMm) const
{
    const double out = radiusMm - flatRadiusMm();
    if (!(out > 0.0))
        return 0.0;
    const double round = std::min(out, bendMm());
    return cornerMm - std::sqrt(cornerMm * cornerMm - round * round) + coneSlope * (out - round);
}

double Bur::upperSideMm(double radiusMm) const
{
    if (radiusMm < shankRadiusMm)
        return kShankTopMm;
    for (std::size_t k = outline.size() - 1; k > 0; --k)
        if (outline[k - 1].radiusMm >= radiusMm && outline[k].radiusMm < outline[k - 1].radiusMm)
            return heightOn(outline[k - 1], outline[k], radiusMm);
    // With straight sides, the height at this radius is the length of the head.
    return headLengthMm;
}

std::span<const Bur> burs()
{
    return table().burs;
}

std::string burIds()
{
    std::string ids;
    for (const Bur& bur : burs())
        ids += (ids.empty() ? "" : ", ") + bur.id;
    return ids;
}

Result<std::size_t> findBur(std::string_view id)
{
    const auto all = burs();
    const auto found = std::find_if(all.begin(), all.end(), [&](const Bur& bur) { return bur.id == id; });
    if (found != all.end())
        return static_cast<std::size_t>(found - all.begin());
    return unexpected(ErrorCode::UnknownName, LocalizableText{"There is no bur '%1'; choose one of %2.",
                                                              {noted(std::string(id)), noted(burIds())}});
}

bool isOwnBur(std::size_t index)
{
    return index >= table().own;
}

Result<std::size_t> addOwnBur(Bur bur)
{
    Table& all = table();
    if (all.burs.size() > all.own)
        return unexpected(ErrorCode::Busy, "There is a bur of your own already; the program takes one.");
    if (findBur(bur.id))
        return unexpected(ErrorCode::BadStructure, "There is a bur '" + bur.id + "' already; call yours otherwise.");
    all.burs.push_back(std::move(bur));
    return all.own;
}

}  // namespace core::bur
