// SPDX-License-Identifier: GPL-3.0-or-later
#include "lessons/ClassStanding.h"

#include <algorithm>

namespace lessons {

ClassStanding classStanding(int tenths, std::span<const int> bestOfEach)
{
    ClassStanding standing;
    standing.people = static_cast<int>(bestOfEach.size());
    if (standing.people < kFewestPeople)
        return standing;
    const auto below = std::count_if(bestOfEach.begin(), bestOfEach.end(), [&](int best) { return best < tenths; });
    standing.percentBelow = 100.0 * static_cast<double>(below) / standing.people;
    return standing;
}

}  // namespace lessons
