// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace ui::scoring {

/// The score that a student expects before it is shown.
struct ScorePrediction
{
    int tenths = 0;     ///< tenths of a point
    std::string worst;  ///< id of the criterion expected to cost most; empty: none
};

}  // namespace ui::scoring
