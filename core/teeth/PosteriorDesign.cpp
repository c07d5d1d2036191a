// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/teeth/PosteriorDesign.h"

#include <cassert>
#include <vector>

namespace core::teeth {
namespace {

// Fields of a lobe: x, y, z, turn, slopes mesial distal buccal lingual, power, groove share, group, cusp. The tallest
// cusp has z = 0.

PosteriorDesign upperFirstPremolar()
{
    PosteriorDesign d;
    // A hexagon: corners at the tips of both cusps and at the ends of the mesial and the distal side.
    d.outline = {3.16, 3.95, 3.24, 3.30, 4.85, 3.47, 3.37, 3.98, 3.06, 3.40, 3.34, 3.48, 4.73, 3.23, 3.51, 3.40};
    d.contourZ = {-3.30, -5.32, -2.90, -4.77};
    d.domeRise = {3.21, 7.12, 1.94, 5.17};
    d.domePower = {4.25, 1.79, 3.70, 2.84};
    d.shoulderMm = 0.56;
    d.blendMm = 0.38;
    d.lobes = {
        {-0.38, 2.73, 0.00, 5.6, 0.63, 0.47, 0.50, 0.95, 1.15, 1.0, 1, Cusp::B},
        {-0.28, -2.85, -1.05, 27.2, 0.44, 0.42, 0.72, 0.50, 1.68, 1.0, 2, Cusp::L},
        {-2.80, 1.10, -1.55, -0.3, 0.70, 0.89, 0.25, 0.45, 2.00, 1.0, 3},
        {-2.60, -1.00, -1.58, -4.5, 0.70, 0.86, 0.45, 0.30, 2.00, 1.0, 4},
        {2.52, 0.12, -1.81, -14.0, 0.85, 0.71, 0.04, 0.17, 2.00, 0.6, 5},
    };
    // On both sides of the buccal ridge, and where the mesial marginal groove crosses the ridge.
    d.sideGrooves = {{62.0, 0.22, 11.0}, {118.0, 0.22, 11.0}, {180.0, 0.3, 8.0}};
    d.roots = {{{0.4, 2.1, 1.0, 1.7, 1.7, 0.0, 0.2}, {0.4, -2.0, 0.97, 1.6, 1.6, 0.0, -0.2}}, {0.0, 180.0}, 6.5, 0.0};
    return d;
}

PosteriorDesign upperSecondPremolar()
{
    PosteriorDesign d = upperFirstPremolar();
    d.sideGrooves.pop_back();
    d.outline = {3.40, 3.55, 3.95, 4.25, 4.50, 4.30, 3.95, 3.55, 3.40, 3.50, 3.90, 4.30, 4.50, 4.30, 3.90, 3.50};
    d.contourZ = {-3.1, -5.3, -3.0, -4.4};
    d.domeRise = {3.0, 7.0, 2.9, 5.2};
    d.domePower = {4.0, 2.1, 4.0, 2.5};
    d.shoulderMm = 0.6;
    d.fissureMm = 0.5;
    d.furrows = 0.10;
    d.lobes = {
        {-0.1, 2.55, 0.00, 0.0, 0.45, 0.45, 0.50, 0.70, 1.35, 1.0, 1, Cusp::B},
        {-0.3, -2.65, -0.20, 0.0, 0.42, 0.42, 0.60, 0.62, 1.45, 1.0, 2, Cusp::L},
        {-2.3, 0.0, -1.30, 0.0, 0.50, 0.55, 0.15, 0.15, 2.0, 0.6, 3},
        {2.2, 0.0, -1.35, 0.0, 0.55, 0.50, 0.15, 0.15, 2.0, 0.6, 4},
    };
    d.roots = {{{0.6, 0.0, 1.0, 1.9, 3.5, 0.1, 0.0}}, {}, 0.0, 0.35};
    return d;
}

/// @param carabelli  with a tubercle on the mesiolingual cusp; 60 % of teeth have some trace of it
PosteriorDesign upperFirstMolar(bool carabelli)
{
    PosteriorDesign d;
    d.outline = {4.85, 5.05, 5.40, 5.50, 5.55, 6.00, 6.35, 5.60, 4.95, 4.95, 5.20, 5.45, 5.50, 5.95, 6.45, 5.60};
    d.contourZ = {-2.9, -5.3, -2.7, -3.9};
    d.domeRise = {3.0, 6.6, 2.8, 4.9};
    d.domePower = {4.8, 2.2, 4.8, 2.8};
    d.cervixPower = 2.8;
    d.lobes = {
        {-2.5, 3.0, -0.20, 10.0, 0.45, 0.52, 0.50, 0.72, 1.30, 1.0, 1, Cusp::MB},
        {1.8, 2.9, -0.42, -12.0, 0.52, 0.45, 0.50, 0.70, 1.25, 1.0, 2, Cusp::DB},
        {-1.5, -2.8, 0.00, 5.0, 0.45, 0.50, 0.60, 0.50, 1.35, 1.0, 2, Cusp::ML},
        {2.9, -2.9, -1.05, 10.0, 0.55, 0.45, 0.60, 0.50, 1.40, 1.0, 3, Cusp::DL},
        {0.3, 0.2, -1.50, 61.0, 0.14, 0.14, 0.75, 0.80, 1.60, 1.0, 2},
        {-4.1, 0.7, -1.30, 0.0, 0.60, 0.80, 0.14, 0.14, 2.0, 0.5, 4},
        {4.0, 0.3, -1.45, 0.0, 0.80, 0.60, 0.16, 0.14, 2.0, 0.5, 5},
    };
    d.sideGrooves = {{97.0, 0.35, 7.0}, {290.0, 0.35, 7.0}};
    if (carabelli) {
        d.outline[10] += 0.1;
        d.outline[11] += 0.2;
        d.sideFurrows = {{240.0, 15.0, 0.80, 0.40}};
    }
    // The branches follow the partings: mesiobuccal, palatal, distobuccal.
    d.roots = {{{-3.0, 3.3, 1.0, 1.7, 2.2, -0.6, 0.4},
                {0.9, -4.1, 1.08, 2.3, 1.7, 0.2, -0.9},
                {3.0, 2.8, 0.97, 1.5, 1.9, 0.5, 0.3}},
               {90.0, 205.0, 335.0},
               3.8,
               0.0};
    return d;
}

/// @param distolingual  with a distolingual cusp; without it the outline is a heart
PosteriorDesign upperSecondMolar(bool distolingual)
{
    PosteriorDesign d = upperFirstMolar(false);
    d.contourZ = {-2.8, -4.7, -2.6, -3.7};
    d.domeRise = {2.9, 6.0, 2.7, 4.7};
    d.outline = {4.10, 4.35, 4.90, 5.40, 5.55, 5.95, 6.05, 5.15, 4.40, 4.40, 4.80, 5.30, 5.50, 5.40, 5.25, 4.55};
    d.lobes = {
        {-2.2, 3.0, -0.15, 10.0, 0.45, 0.52, 0.50, 0.66, 1.30, 1.0, 1, Cusp::MB},
        {1.6, 2.7, -0.5, -12.0, 0.52, 0.48, 0.50, 0.62, 1.30, 1.0, 2, Cusp::DB},
        {-1.2, -2.8, 0.0, 0.0, 0.44, 0.48, 0.60, 0.48, 1.40, 1.0, 2, Cusp::ML},
        {2.5, -2.6, -0.85, 10.0, 0.80, 0.55, 0.75, 0.55, 1.45, 1.0, 3, Cusp::DL},
        {0.2, 0.0, -1.70, 62.0, 0.14, 0.14, 0.60, 0.65, 1.60, 1.0, 2},
        {-3.7, 0.6, -1.30, 0.0, 0.60, 0.80, 0.14, 0.14, 2.0, 0.5, 4},
        {3.4, 0.2, -1.50, 0.0, 0.80, 0.60, 0.16, 0.14, 2.0, 0.5, 5},
    };
    if (!distolingual) {
        std::erase_if(d.lobes, [](const Lobe& lobe) { return lobe.group == 3; });
        d.outline[12] = 5.35;
        d.outline[13] = 5.0;
        d.outline[14] = 4.45;
        d.outline[15] = 4.1;
    }
    d.sideGrooves = {{97.0, 0.3, 9.0}, {300.0, 0.3, 9.0}};
    d.roots.branches = {{-1.6, 2.9, 1.0, 1.5, 2.2, -0.4, 0.3},
                        {0.9, -3.2, 1.08, 2.1, 1.7, 0.1, -0.6},
                        {2.0, 2.4, 0.97, 1.4, 1.8, 0.4, 0.2}};
    d.roots.trunkMm = 4.5;
    return d;
}

/// @param distolingual  with a small fourth cusp
PosteriorDesign upperThirdMolar(bool distolingual)
{
    PosteriorDesign d = upperSecondMolar(true);
    d.contourZ = {-2.7, -4.3, -2.5, -3.5};
    d.domeRise = {2.8, 5.6, 2.6, 4.5};
    d.outline = {3.85, 4.20, 4.85, 5.20, 5.25, 5.40, 5.20, 4.65, 4.30, 4.20, 4.40, 4.75, 4.90, 4.55, 4.05, 3.80};
    d.furrows = 0.14;
    d.fissureMm = 0.55;
    d.lobes = {
        {-1.9, 2.5, -0.12, 12.0, 0.45, 0.50, 0.50, 0.58, 1.40, 1.0, 1, Cusp::MB},
        {1.7, 2.2, -0.45, -14.0, 0.50, 0.48, 0.50, 0.58, 1.40, 1.0, 2, Cusp::DB},
        {-0.5, -2.4, 0.0, 0.0, 0.42, 0.45, 0.60, 0.48, 1.50, 1.0, 3, Cusp::ML},
        {-3.3, 0.3, -1.20, 5.0, 0.60, 0.75, 0.14, 0.14, 2.0, 0.5, 4},
        {2.9, -0.4, -1.40, -20.0, 0.75, 0.60, 0.14, 0.14, 2.0, 0.5, 5},
    };
    if (distolingual)
        d.lobes.push_back({2.2, -2.1, -1.0, 0.0, 0.70, 0.50, 0.70, 0.55, 1.50, 1.0, 6, Cusp::DL});
    d.sideGrooves = {{92.0, 0.25, 9.0}};
    d.roots.branches = {{0.3, 1.8, 1.0, 1.4, 2.0, 0.2, 0.2},
                        {1.2, -1.6, 1.0, 1.8, 1.6, 0.2, -0.2},
                        {2.0, 1.4, 0.97, 1.3, 1.7, 0.3, 0.1}};
    d.roots.trunkMm = 6.0;
    return d;
}

PosteriorDesign lowerFirstPremolar()
{
    PosteriorDesign d;
    d.outline = {3.50, 3.60, 3.75, 3.80, 3.80, 3.75, 3.70, 3.55, 3.45, 3.35, 3.35, 3.50, 3.75, 3.60, 3.45, 3.45};
    d.contourZ = {-3.3, -5.6, -3.2, -3.7};
    d.domeRise = {3.1, 7.2, 3.0, 4.3};
    d.domePower = {3.4, 2.0, 3.4, 2.8};
    d.cervixY = 0.35;
    d.lobes = {
        {-0.2, 0.85, 0.0, 0.0, 0.85, 0.80, 0.60, 0.93, 1.20, 0.8, 1, Cusp::B},
        {0.1, -2.45, -1.55, 0.0, 0.75, 0.65, 0.62, 0.50, 1.40, 0.8, 1, Cusp::L},
        {-2.4, -0.3, -1.65, 8.0, 0.60, 0.40, 0.20, 0.32, 2.0, 1.0, 3},
        {2.4, -0.3, -1.60, -8.0, 0.40, 0.60, 0.20, 0.28, 2.0, 1.0, 4},
    };
    d.sideGrooves = {{62.0, 0.2, 11.0}, {118.0, 0.2, 11.0}};  // on both sides of the buccal ridge
    d.roots = {{{0.6, 0.0, 1.0, 1.9, 2.9, 0.1, 0.0}}, {}, 0.0, 0.2};
    return d;
}

PosteriorDesign lowerSecondPremolar(bool threeCusps)
{
    PosteriorDesign d;
    d.outline = {3.50, 3.65, 3.95, 4.00, 3.95, 3.95, 3.90, 3.60, 3.45, 3.65, 4.05, 4.05, 3.95, 4.00, 4.05, 3.70};
    d.contourZ = {-3.1, -5.2, -3.0, -3.6};
    d.domeRise = {3.0, 6.6, 2.9, 3.7};
    d.domePower = {3.8, 2.1, 3.8, 3.2};
    d.cervixY = 0.35;
    d.lobes = {
        {-0.1, 1.75, 0.0, 0.0, 0.50, 0.50, 0.50, 0.72, 1.25, 1.0, 1, Cusp::B},
        {-2.5, 0.0, -1.45, 0.0, 0.60, 0.75, 0.18, 0.18, 2.0, 0.6, 4},
        {2.5, 0.1, -1.50, 0.0, 0.75, 0.60, 0.18, 0.18, 2.0, 0.6, 5},
    };
    if (threeCusps) {
        d.lobes.push_back({-1.2, -2.3, -0.65, 0.0, 0.55, 0.60, 0.62, 0.50, 1.35, 1.0, 2, Cusp::ML});
        d.lobes.push_back({1.6, -2.2, -1.05, 0.0, 0.65, 0.50, 0.60, 0.50, 1.35, 1.0, 3, Cusp::DL});
    } else {
        d.lobes.push_back({-0.3, -2.3, -0.75, 0.0, 0.45, 0.45, 0.62, 0.50, 1.4, 1.0, 2, Cusp::L});
    }
    d.sideGrooves = {{62.0, 0.16, 11.0}, {118.0, 0.16, 11.0}};  // on both sides of the buccal ridge
    d.roots = {{{0.8, 0.0, 1.0, 2.0, 3.1, 0.1, 0.0}}, {}, 0.0, 0.15};
    return d;
}

PosteriorDesign lowerFirstMolar()
{
    PosteriorDesign d;
    d.outline = {5.51, 5.75, 5.58, 5.68, 5.53, 5.71, 5.77, 5.94, 5.47, 5.57, 6.16, 5.08, 4.45, 5.34, 5.31, 5.58};
    d.contourZ = {-3.16, -5.95, -2.80, -3.64};
    d.domeRise = {3.50, 7.00, 3.30, 4.95};
    d.domePower = {4.74, 1.93, 4.83, 3.17};
    d.shoulderMm = 0.39;
    d.blendMm = 0.34;
    d.fissureMm = 0.6;
    d.cervixX = -0.35;
    d.cervixY = 0.4;
    d.cervixPower = 2.8;
    d.lobes = {
        {-2.35, 2.50, -0.10, -4.2, 0.27, 0.54, 0.53, 0.89, 1.34, 1.0, 1, Cusp::MB},
        {1.35, 2.42, -0.57, -5.4, 0.94, 0.64, 0.55, 0.70, 1.15, 1.0, 2, Cusp::DB},
        {3.77, 0.77, -0.80, -52.8, 0.61, 0.42, 0.54, 0.89, 1.64, 1.0, 3, Cusp::D},
        {-2.40, -3.40, 0.00, -16.7, 0.96, 0.61, 0.76, 0.57, 1.15, 1.0, 4, Cusp::ML},
        {1.40, -3.45, -0.35, -3.9, 0.53, 0.61, 0.81, 0.60, 1.15, 1.0, 5, Cusp::DL},
        {-5.01, 0.31, -1.84, -2.7, 0.59, 0.79, 0.06, 0.22, 1.99, 0.5, 6},
        {4.16, -0.82, -1.19, -3.2, 0.74, 0.60, 0.14, 0.22, 2.00, 0.5, 7},
    };
    d.sideGrooves = {{88.0, 0.45, 8.0}, {42.0, 0.35, 8.0}, {265.0, 0.3, 8.0}};
    d.roots = {{{-3.4, 0.3, 1.0, 1.8, 3.7, -0.7, 0.0}, {3.1, 0.2, 0.95, 1.7, 3.2, 0.6, 0.0}}, {90.0, 270.0}, 3.5, 0.0};
    return d;
}

PosteriorDesign lowerSecondMolar()
{
    PosteriorDesign d = lowerFirstMolar();
    d.cervixX = 0.0;
    d.contourZ = {-2.9, -5.0, -2.7, -3.6};
    d.domeRise = {2.9, 5.7, 2.7, 4.3};
    d.outline = {5.10, 5.45, 5.75, 5.40, 5.10, 5.45, 6.00, 5.75, 5.25, 5.45, 5.85, 5.10, 4.80, 5.05, 5.60, 5.35};
    d.lobes = {
        {-2.2, 2.5, -0.15, 0.0, 0.42, 0.52, 0.51, 0.74, 1.30, 1.0, 1, Cusp::MB},
        {2.1, 2.5, -0.55, 0.0, 0.55, 0.45, 0.51, 0.70, 1.25, 1.0, 2, Cusp::DB},
        {-2.1, -2.7, 0.00, 0.0, 0.50, 0.54, 0.75, 0.58, 1.20, 1.0, 3, Cusp::ML},
        {2.0, -2.7, -0.35, 0.0, 0.52, 0.50, 0.75, 0.58, 1.25, 1.0, 4, Cusp::DL},
        {-4.4, 0.1, -1.50, 0.0, 0.60, 0.80, 0.10, 0.14, 2.0, 0.5, 5},
        {4.3, 0.0, -1.40, 0.0, 0.75, 0.60, 0.12, 0.14, 2.0, 0.5, 6},
    };
    d.sideGrooves = {{85.0, 0.45, 8.0}, {270.0, 0.3, 8.0}};
    d.roots = {{{-1.2, 0.3, 1.0, 1.6, 3.4, -0.6, 0.0}, {2.8, 0.2, 0.97, 1.5, 3.0, 0.5, 0.0}}, {90.0, 270.0}, 4.0, 0.0};
    return d;
}

/// @param distal  with the fifth cusp
PosteriorDesign lowerThirdMolar(bool distal)
{
    PosteriorDesign d = lowerSecondMolar();
    d.contourZ = {-2.8, -4.8, -2.6, -3.5};
    d.outline = {4.60, 4.75, 4.95, 4.95, 4.90, 5.10, 5.40, 5.30, 5.00, 5.10, 5.30, 4.85, 4.60, 4.60, 4.70, 4.60};
    d.furrows = 0.15;
    d.fissureMm = 0.55;
    d.lobes = {
        {-2.1, 2.3, -0.12, 0.0, 0.45, 0.50, 0.50, 0.60, 1.40, 1.0, 1, Cusp::MB},
        {1.1, 2.4, -0.5, 0.0, 0.50, 0.50, 0.50, 0.58, 1.40, 1.0, 2, Cusp::DB},
        {3.2, 0.9, -0.75, -35.0, 0.50, 0.50, 0.50, 0.58, 1.50, 1.0, 3, Cusp::D},
        {-2.0, -2.4, 0.0, 0.0, 0.48, 0.52, 0.65, 0.55, 1.40, 1.0, 4, Cusp::ML},
        {1.8, -2.4, -0.32, 0.0, 0.52, 0.48, 0.65, 0.55, 1.40, 1.0, 5, Cusp::DL},
        {-4.1, 0.1, -1.30, 0.0, 0.60, 0.75, 0.12, 0.14, 2.0, 0.5, 6},
        {3.9, -1.0, -1.30, 0.0, 0.75, 0.60, 0.12, 0.14, 2.0, 0.5, 7},
    };
    if (!distal) {
        std::erase_if(d.lobes, [](const Lobe& lobe) { return lobe.group == 3; });
        d.lobes[1].x = 1.9;
    }
    // The roots of a third molar are usually fused.
    d.roots = {{{2.2, 0.2, 1.0, 2.9, 3.4, 0.4, 0.0}}, {}, 0.0, 0.25};
    return d;
}

}  // namespace

PosteriorDesign posteriorDesign(int fdi, Rng& rng, bool vary)
{
    // One draw decides about all variants. The mean tooth has the most common form.
    const double chance = rng.uniform();
    const auto happens = [&](double share) { return vary && chance < share; };
    switch (fdi) {
    case 24:
        return upperFirstPremolar();
    case 25:
        return upperSecondPremolar();
    case 26:
        return upperFirstMolar(!happens(0.4));
    case 27:
        return upperSecondMolar(!happens(0.3));
    case 28:
        return upperThirdMolar(happens(0.35));
    case 34:
        return lowerFirstPremolar();
    case 35:
        return lowerSecondPremolar(!happens(0.45));
    case 36:
        return lowerFirstMolar();
    case 37:
        return lowerSecondMolar();
    default:
        assert(fdi == 38);
        return lowerThirdMolar(!happens(0.45));
    }
}

}  // namespace core::teeth
