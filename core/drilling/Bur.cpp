// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drilling/Bur.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace core::drilling {
namespace {

/// Points a quarter circle is cut into. 32 chords of a 0.5 mm ball leave 0.15 um.
constexpr int kArcSteps = 32;

/// Unit quarter circle from (0, -1) to (1, 0) in equal steps of the half-angle tangent: rational points, so that the
/// outline needs no library transcendental and is the same with every compiler.
Bur::Point unitArc(int step)
{
    // Two octants, each with t = tan(angle / 2) running to tan(22.5 degrees).
    constexpr double kTanEighth = 0.41421356237309503;
    const int half = kArcSteps / 2;
    const bool second = step > half;
    const double t = kTanEighth * (second ? kArcSteps - step : step) / half;
    const double sine = 2.0 * t / (1.0 + t * t);
    const double cosine = (1.0 - t * t) / (1.0 + t * t);
    return second ? Bur::Point{cosine, -sine} : Bur::Point{sine, -cosine};
}

/// Ball of radius R whose equator is at height R, cut by the neck above.
Bur roundBur(std::string_view id, std::string_view name, double radius, double neck)
{
    Bur bur{id, name, radius, 2.0 * radius, neck, radius, {}};
    for (int k = 0; k <= kArcSteps; ++k) {
        const Bur::Point p = unitArc(k);
        bur.outline.push_back({radius * p.radiusMm, radius * (1.0 + p.heightMm)});
    }
    for (int k = kArcSteps - 1; k >= 0; --k) {
        const Bur::Point p = unitArc(k);
        const double r = radius * p.radiusMm;
        if (r < neck)
            break;
        bur.outline.push_back({r, radius * (1.0 - p.heightMm)});
    }
    bur.headLengthMm = bur.outline.back().heightMm;
    return bur;
}

/// Pear: widest near the tip and rounded there, sides closing towards the shank by `taper` (tangent of the angle a
/// side). The end is a flat disc joined to the side by a quarter circle of radius `corner`.
Bur pearBur(std::string_view id, std::string_view name, double radius, double length, double corner, double taper)
{
    Bur bur{id, name, radius, length, radius - taper * (length - corner), corner, {}};
    bur.outline.push_back({0.0, 0.0});
    for (int k = 0; k <= kArcSteps; ++k) {
        const Bur::Point p = unitArc(k);
        bur.outline.push_back({radius - corner + corner * p.radiusMm, corner * (1.0 + p.heightMm)});
    }
    bur.outline.push_back({bur.shankRadiusMm, length});
    return bur;
}

/// Straight fissure: a cylinder with a flat end, its edge broken by `corner`. With a sharp one the clearance would step
/// wherever a column comes under the rim, and the bur stick there (haptics.md 3.1 asks for a corner of a cell).
Bur fissureBur(std::string_view id, std::string_view name, double radius, double length, double neck, double corner)
{
    Bur bur{id, name, radius, length, neck, corner, {}};
    bur.outline.push_back({0.0, 0.0});
    for (int k = 0; k <= kArcSteps; ++k) {
        const Bur::Point p = unitArc(k);
        bur.outline.push_back({radius - corner + corner * p.radiusMm, corner * (1.0 + p.heightMm)});
    }
    bur.outline.push_back({radius, length});
    return bur;
}

double heightOn(const Bur::Point& a, const Bur::Point& b, double radiusMm)
{
    const double span = b.radiusMm - a.radiusMm;
    return span == 0.0 ? a.heightMm : a.heightMm + (b.heightMm - a.heightMm) * (radiusMm - a.radiusMm) / span;
}

const std::array<Bur, 4>& table()
{
    static const std::array<Bur, 4> burs{
        roundBur("2", "round, No. 2", 0.5, 0.25),
        // Tangents of 8 and 4 degrees a side: teeth.md section 6.
        pearBur("330", "pear, No. 330", 0.4, 1.6, 0.25, 0.14054),
        pearBur("245", "long pear, No. 245", 0.4, 3.0, 0.2, 0.06993),
        fissureBur("57", "straight fissure, No. 57", 0.5, 3.8, 0.4, 0.1),
    };
    return burs;
}

}  // namespace

double Bur::undersideMm(double radiusMm) const
{
    const double out = radiusMm - flatRadiusMm();
    if (!(out > 0.0))
        return 0.0;
    return cornerMm - std::sqrt(std::max(0.0, cornerMm * cornerMm - out * out));
}

double Bur::upperSideMm(double radiusMm) const
{
    if (radiusMm < shankRadiusMm)
        return kShankTopMm;
    for (std::size_t k = outline.size() - 1; k > 0; --k)
        if (outline[k - 1].radiusMm >= radiusMm && outline[k].radiusMm < outline[k - 1].radiusMm)
            return heightOn(outline[k - 1], outline[k], radiusMm);
    // A straight side: the head is as high there as it is long.
    return headLengthMm;
}

std::span<const Bur> burs()
{
    return table();
}

Result<std::size_t> findBur(std::string_view id)
{
    const auto all = burs();
    const auto found = std::find_if(all.begin(), all.end(), [&](const Bur& bur) { return bur.id == id; });
    if (found != all.end())
        return static_cast<std::size_t>(found - all.begin());
    std::string known;
    for (const Bur& bur : all)
        known += (known.empty() ? "" : ", ") + std::string(bur.id);
    return unexpected(ErrorCode::UnknownName, Words{"There is no bur '%1'; choose one of %2.",
                                                    {noted(std::string(id)), noted(std::move(known))}});
}

}  // namespace core::drilling
