// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/teeth/PosteriorForm.h"

#include <cmath>
#include <numbers>

namespace core::teeth {

glm::dvec2 PosteriorForm::toDesign(glm::dvec2 toothMm) const
{
    return glm::dvec2{toothMm.x, toothMm.y * ySign} / glm::dvec2(scale) + glm::dvec2(originMm);
}

glm::dvec2 PosteriorForm::toTooth(glm::dvec2 designMm) const
{
    const glm::dvec2 moved = (designMm - glm::dvec2(originMm)) * glm::dvec2(scale);
    return {moved.x, moved.y * ySign};
}

double PosteriorForm::mouthMm(glm::dvec2 toothMm) const
{
    const PosteriorCrown::Top top = crown.top(toDesign(toothMm));
    return (top.z + top.carved - originMm.z) * scale.z;
}

double PosteriorForm::lobeMm(std::size_t lobe, glm::dvec2 toothMm) const
{
    return (crown.field().lobeHeight(lobe, toDesign(toothMm)) - originMm.z) * scale.z;
}

std::vector<glm::dvec2> PosteriorForm::outline(int points) const
{
    std::vector<glm::dvec2> line;
    for (int k = 0; k < points; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / points;
        const double radius = crown.outlineMm(angle);
        line.push_back(toTooth({radius * std::cos(angle), radius * std::sin(angle)}));
    }
    return line;
}

}  // namespace core::teeth
