// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "core/history/UndoTree.h"
#include "core/recording/Recording.h"

namespace core::session {

/// An attempt as it was left, with all that a session needs to go on with it.
struct ResumableAttempt
{
    recording::Recording recording;  ///< with what the tooth was after its last tick as witness
    history::TiledHeights uncut;
    history::UndoTree history;  ///< its present moment is what the tooth came to
    int strokes = 0;
    std::unique_ptr<servo::ServoTick> servo;     ///< with the recording's settings, new: what goes on computing it
    std::optional<std::uint8_t> bur = {};        ///< in hand last; nothing: that which an attempt begins with
    std::optional<std::uint8_t> handpiece = {};  ///< the same, of those at hand (SetHandpiece)
    double restedS = 0.0;                        ///< of the recording, in which the student was elsewhere
};

/// Replays a recording to its end and finds its moments again. Strokes and undo steps are told from what the recording
/// holds, so that after a jump (GoTo) or a reload a moment may stand on another branch than it did; none is missing.
/// Any thread; takes as long as a replay. Only the settings can be wrong.
[[nodiscard]] Result<std::unique_ptr<ResumableAttempt>> rebuild(recording::Recording recording);

}  // namespace core::session
