// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/teeth/AnteriorDesign.h"

#include <cassert>

namespace core::teeth {
namespace {

RootDesign singleRoot(double halfX, double halfY, double apexX, double apexY, double hollowMm)
{
    return {{{apexX, apexY, 1.0, halfX, halfY, 0.0, 0.0}}, {}, 0.0, hollowMm};
}

AnteriorDesign upperCentral()
{
    AnteriorDesign d;
    d.mesialX = {-3.85, -4.40, -4.42, -4.35, -4.18, -3.95, -3.68, -3.45, -3.50};
    d.distalX = {3.20, 4.10, 4.30, 4.20, 4.12, 3.95, 3.70, 3.48, 3.50};
    d.labialY = {1.67, 2.33, 2.82, 3.17, 3.50, 3.71, 3.78, 3.61, 3.08};
    d.lingualY = {0.85, 0.50, -0.30, -0.90, -1.50, -2.65, -3.30, -3.45, -3.03};
    d.labialPower = {3.4, 2.9, 2.4};
    d.lingualPower = {4.0, 2.4, 2.0};
    d.lingualTaper = 0.22;
    d.edgeZ = {-0.40, -0.22, -0.10, 0.00, -0.05, -0.03, -0.15, -0.30, -0.80};
    d.fossaMm = 0.95;
    d.fossaHalf = 0.8;
    d.fossaTo = 0.73;
    d.cingulumX = 0.45;
    d.roots = singleRoot(3.3, 3.0, 0.4, 0.0, 0.0);
    d.lingualRidgeMm = 0.15;
    return d;
}

AnteriorDesign upperLateral()
{
    AnteriorDesign d = upperCentral();
    d.mesialX = {-2.55, -3.20, -3.35, -3.30, -3.15, -3.00, -2.80, -2.55, -2.50};
    d.distalX = {1.90, 2.85, 3.30, 3.35, 3.25, 3.08, 2.85, 2.58, 2.50};
    d.labialY = {1.30, 1.95, 2.38, 2.70, 2.95, 3.12, 3.18, 3.05, 2.55};
    d.lingualY = {0.55, 0.25, -0.35, -0.85, -1.35, -2.20, -2.85, -3.00, -2.55};
    d.labialPower = {3.0, 2.5, 2.1};
    d.lingualPower = {3.4, 2.3, 2.0};
    d.lingualTaper = 0.18;
    d.edgeZ = {-0.65, -0.35, -0.12, 0.00, -0.03, -0.15, -0.40, -0.75, -1.60};
    d.fossaMm = 0.95;
    d.fossaTo = 0.74;
    d.pitMm = 0.35;
    d.cingulumX = 0.2;
    d.roots = singleRoot(2.4, 2.6, 1.0, -0.2, 0.1);
    d.lingualRidgeMm = 0.0;
    return d;
}

AnteriorDesign upperCanine()
{
    AnteriorDesign d;
    d.mesialX = {-2.00, -2.95, -3.62, -3.78, -3.70, -3.50, -3.20, -2.85, -2.75};
    d.distalX = {2.00, 3.00, 3.75, 4.10, 4.05, 3.70, 3.30, 2.90, 2.75};
    d.labialY = {1.00, 2.05, 2.85, 3.40, 3.75, 4.00, 4.12, 4.00, 3.55};
    d.lingualY = {0.35, -0.35, -0.85, -1.40, -2.10, -3.20, -3.95, -4.15, -3.55};
    d.labialPower = {2.0, 2.0, 2.0};
    d.lingualPower = {2.2, 2.1, 2.0};
    d.lingualTaper = 0.18;
    d.edgeZ = {-1.35, -1.00, -0.66, -0.26, 0.06, -0.30, -0.75, -1.18, -1.65};
    d.fossaMm = 0.75;
    d.fossaHalf = 0.85;
    d.fossaTo = 0.72;
    d.lingualRidgeMm = 0.6;
    d.labialRidgeMm = 0.28;
    d.labialGrooveMm = 0.1;
    d.roots = singleRoot(2.7, 3.6, 0.8, 0.0, 0.25);
    return d;
}

AnteriorDesign lowerCentral()
{
    AnteriorDesign d;
    d.mesialX = {-2.35, -2.53, -2.52, -2.42, -2.28, -2.12, -1.95, -1.80, -1.75};
    d.distalX = {2.33, 2.53, 2.52, 2.42, 2.28, 2.12, 1.95, 1.80, 1.75};
    d.labialY = {0.55, 0.95, 1.35, 1.75, 2.15, 2.55, 2.90, 3.05, 2.65};
    d.lingualY = {-0.35, -0.58, -0.90, -1.25, -1.68, -2.25, -2.85, -3.10, -2.65};
    d.labialPower = {3.6, 2.6, 2.0};
    d.lingualPower = {4.0, 2.4, 2.0};
    d.lingualTaper = 0.14;
    d.edgeZ = {-0.20, -0.07, -0.02, 0.00, 0.00, 0.00, -0.02, -0.07, -0.20};
    d.fossaMm = 0.32;
    d.fossaHalf = 0.8;
    d.labialGrooveMm = 0.02;
    d.roots = singleRoot(1.7, 2.7, 0.3, 0.0, 0.3);
    return d;
}

AnteriorDesign lowerLateral()
{
    AnteriorDesign d = lowerCentral();
    d.mesialX = {-2.60, -2.75, -2.74, -2.64, -2.50, -2.36, -2.20, -2.05, -2.00};
    d.distalX = {2.35, 2.75, 2.86, 2.76, 2.56, 2.38, 2.20, 2.05, 2.00};
    d.edgeZ = {-0.15, -0.03, 0.00, 0.00, -0.03, -0.10, -0.22, -0.40, -0.75};
    d.cingulumX = 0.25;
    d.roots = singleRoot(1.9, 2.9, 0.5, 0.0, 0.35);
    return d;
}

AnteriorDesign lowerCanine()
{
    AnteriorDesign d = upperCanine();
    d.mesialX = {-1.90, -2.80, -3.32, -3.42, -3.38, -3.25, -3.05, -2.85, -2.75};
    d.distalX = {1.90, 2.90, 3.60, 3.85, 3.82, 3.55, 3.20, 2.88, 2.75};
    d.labialY = {0.55, 1.35, 2.05, 2.60, 3.05, 3.45, 3.75, 3.85, 3.50};
    d.lingualY = {-0.15, -0.70, -1.10, -1.50, -2.00, -2.80, -3.60, -3.90, -3.50};
    d.edgeZ = {-0.85, -0.60, -0.38, -0.14, 0.05, -0.24, -0.60, -1.05, -1.55};
    d.fossaMm = 0.4;
    d.lingualRidgeMm = 0.28;
    d.labialRidgeMm = 0.16;
    d.labialGrooveMm = 0.05;
    d.roots = singleRoot(2.7, 3.5, 0.5, 0.0, 0.3);
    return d;
}

}  // namespace

AnteriorDesign anteriorDesign(int fdi)
{
    switch (fdi) {
    case 21:
        return upperCentral();
    case 22:
        return upperLateral();
    case 23:
        return upperCanine();
    case 31:
        return lowerCentral();
    case 32:
        return lowerLateral();
    default:
        assert(fdi == 33);
        return lowerCanine();
    }
}

}  // namespace core::teeth
