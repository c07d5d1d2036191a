// SPDX-License-Identifier: GPL-3.0-or-later
#include "lessons/ScoreSheet.h"

#include <algorithm>
#include <cmath>

namespace lessons {

int pointsLostBy(const Criterion& criterion)
{
    if (!std::isfinite(criterion.measured))
        return criterion.maxPoints;
    const double over = criterion.measured - criterion.free;
    if (!(over > 0.0))
        return 0;
    if (criterion.rule == PointRule::Once)
        return criterion.maxPoints;
    const double points = criterion.pointsPerUnit * over;
    return points >= criterion.maxPoints ? criterion.maxPoints : static_cast<int>(std::lround(points));
}

void addUp(ScoreSheet& sheet)
{
    for (Criterion& criterion : sheet.criteria)
        criterion.pointsLost = pointsLostBy(criterion);
    sheet.total = std::max(0, 100 - sheet.pointsLost());
}

}  // namespace lessons
