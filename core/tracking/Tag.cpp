// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/Tag.h"

#include <glm/geometric.hpp>

namespace core::tracking {

double SeenTag::edgePx() const
{
    double sum = 0.0;
    for (std::size_t n = 0; n < cornersPx.size(); ++n)
        sum += glm::distance(cornersPx[n], cornersPx[(n + 1) % cornersPx.size()]);
    return sum / static_cast<double>(cornersPx.size());
}

glm::dvec2 SeenTag::centrePx() const
{
    return 0.25 * (cornersPx[0] + cornersPx[1] + cornersPx[2] + cornersPx[3]);
}

}  // namespace core::tracking
