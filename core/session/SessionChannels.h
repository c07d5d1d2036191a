// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <type_traits>
#include <variant>

#include "core/audio/SoundState.h"
#include "core/history/MomentId.h"
#include "core/rt/SpscQueue.h"
#include "core/rt/TripleBuffer.h"
#include "core/servo/ServoState.h"
#include "core/terrain/Tooth.h"

namespace core::servo {
class ServoTick;
}

/// The commands of the ui to the session (about 100 Hz), the state of the session, and the channels between the ui and
/// the loops.
namespace core::session {

/// What the ui asks of the session. Ui writes, session reads and passes on what concerns the servo.
struct Undo
{};
struct Redo
{};
/// Back to the uncut tooth; a step like a stroke, which can be undone.
struct Reload
{};
/// To any moment of the history.
struct GoTo
{
    history::MomentId id{};
};
/// A new tooth; ownership of `tooth`, `lesson` and `servo` goes to the session with the command.
struct ReplaceTooth
{
    terrain::Tooth* tooth = nullptr;
    std::uint64_t generation = 0;         ///< the number that states and patches of this tooth will carry
    const std::string* lesson = nullptr;  ///< what the attempt is made for (recording::checkLesson); null: nothing
    /// What computes the attempt, new; null: as the one before, or as the session was set up.
    servo::ServoTick* servo = nullptr;
};
struct ResumableAttempt;
/// An attempt that the program did not live to see finished, taken up again; ownership goes to the session.
struct ResumeAttempt
{
    ResumableAttempt* attempt = nullptr;
    std::uint64_t generation = 0;  ///< as of ReplaceTooth
};
/// The aids that are in use from now on: goes on the recording.
struct SetAids
{
    std::uint8_t aids = 0;
};
/// Puts a number on the recording at this moment; what it means is between those who write and read it.
struct AddNote
{
    std::uint64_t code = 0;
};
using SessionCommand =
    std::variant<Undo, Redo, Reload, ReplaceTooth, servo::SetBur, servo::SetDrill, servo::SetHandpiece,
                 servo::SetFixture, servo::BringHome, GoTo, ResumeAttempt, SetAids, AddNote, servo::SetParameter>;
static_assert(std::is_trivially_copyable_v<SessionCommand>);

/// Newest state of the session. Session thread writes, ui reads.
struct SessionState
{
    std::uint64_t toothGeneration = 0;
    int undoSteps = 0;  ///< strokes that can be taken back
    int redoSteps = 0;
    std::uint64_t historyVersion = 0;   ///< another one whenever SessionLoop::historySoFar() would be another
    int strokes = 0;                    ///< made since the tooth was opened
    terrain::PerMaterial wholeMm3{};    ///< volumes of the uncut tooth
    terrain::PerMaterial removedMm3{};  ///< against the uncut tooth, after undo and all
    double overcutMm3 = 0.0;  ///< of these, what the grade counts: enamel and dentin beside or below the decay
    bool perforated = false;  ///< there is a hole through the tooth, after undo and all
    double recordedS = 0.0;
};

/// The channels between ui and the loops, owned by the application, handed by reference.
struct UiChannels
{
    rt::TripleBuffer<servo::ServoState> servo;      ///< servo -> ui
    rt::TripleBuffer<SessionState> session;         ///< session -> ui
    rt::SpscQueue<servo::TilePatch, 512> patches;   ///< session -> ui
    rt::SpscQueue<SessionCommand, 64> commands;     ///< ui -> session
    rt::TripleBuffer<servo::PointerInput> pointer;  ///< ui -> pointer device
    rt::TripleBuffer<audio::SoundState> sound;      ///< servo, or a replay -> sound
};

}  // namespace core::session
