// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "core/recording/Recording.h"

namespace core::recording {

struct ReplayOutcome
{
    terrain::Tooth tooth;       ///< as it stood after the last tick
    session::ServoState state;  ///< of the last tick
    std::uint64_t stateHash = 0;
    /// False if the recording says what the tooth was at some tick and this replay came to something else, or never
    /// to that tick.
    bool agreesWithWitness = true;
};

/// Runs a recording through the very ticks that made it.
/// @param afterTick  called after every tick, with the state and the live tooth; may be empty
[[nodiscard]] Result<ReplayOutcome>
replay(const Recording& recording,
       const std::function<void(const session::ServoState&, const contact::LiveTooth&)>& afterTick = {});

}  // namespace core::recording
