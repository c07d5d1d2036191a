// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "core/history/UndoTree.h"
#include "core/recording/Recording.h"

namespace core::session {

/// An unfinished attempt, with all that a session needs to continue it.
struct ResumableAttempt
{
    recording::Recording recording;  ///< its witness is the tooth after its last tick
    history::TiledHeights uncut;
    history::UndoTree history;  ///< its current moment is the tooth after the last tick
    int strokes = 0;
    std::unique_ptr<servo::ServoTick> servo;     ///< new, with the recording's settings: computes the rest of the
                                                 ///< attempt
    std::optional<std::uint8_t> bur = {};        ///< last in use; empty: the one with which an attempt begins
    std::optional<std::uint8_t> handpiece = {};  ///< the same, as an index into the attempt's handpieces (SetHandpiece)
    double restedS = 0.0;                        ///< time of the recording in which the student was away
};

/// Replays a recording to its end and rebuilds its undo history. Strokes and undo steps are derived from the recording,
/// so after a jump (GoTo) or a reload a moment may be on another branch than before; none is missing. Any thread; takes
/// as long as a replay. The only possible error is invalid settings.
[[nodiscard]] Result<std::unique_ptr<ResumableAttempt>> rebuild(recording::Recording recording);

}  // namespace core::session
