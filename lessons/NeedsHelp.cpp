// SPDX-License-Identifier: GPL-3.0-or-later
#include "lessons/NeedsHelp.h"

#include <algorithm>

namespace lessons {

bool needsHelp(std::span<const AttemptOutcome> newestFirst)
{
    if (newestFirst.size() < kNeedsHelpAfter)
        return false;
    const auto last = newestFirst.first(kNeedsHelpAfter);
    if (std::any_of(last.begin(), last.end(), [](const AttemptOutcome& one) { return one.passed; }))
        return false;
    int best = last.back().tenths;
    for (std::size_t k = kNeedsHelpAfter - 1; k-- > 0;) {
        if (last[k].tenths >= best + kBetterTenths)
            return false;
        best = std::max(best, last[k].tenths);
    }
    return true;
}

}  // namespace lessons
