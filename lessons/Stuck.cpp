// SPDX-License-Identifier: GPL-3.0-or-later
#include "lessons/Stuck.h"

#include <algorithm>

namespace lessons {

bool isStuck(std::span<const Try> newestFirst)
{
    if (newestFirst.size() < kStuckAfter)
        return false;
    const auto last = newestFirst.first(kStuckAfter);
    if (std::any_of(last.begin(), last.end(), [](const Try& one) { return one.passed; }))
        return false;
    int best = last.back().tenths;
    for (std::size_t k = kStuckAfter - 1; k-- > 0;) {
        if (last[k].tenths >= best + kBetterTenths)
            return false;
        best = std::max(best, last[k].tenths);
    }
    return true;
}

}  // namespace lessons
