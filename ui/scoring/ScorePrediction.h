// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace ui::scoring {

/// What a student expects before seeing the score.
struct ScorePrediction
{
    int tenths = 0;     ///< of a point
    std::string worst;  ///< id of the criterion that is expected to cost most; empty: none
};

}  // namespace ui::scoring
