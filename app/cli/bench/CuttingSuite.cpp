// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/bench/Suites.h"
#include "app/cli/bench/Sweeps.h"

namespace app::cli::bench {

core::Result<Figures> cuttingSuite(const Context& context)
{
    Figures figures;
    addSweeps(figures, context, kSweepSteps);
    return figures;
}

}  // namespace app::cli::bench
