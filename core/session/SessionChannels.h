// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <variant>

#include "core/audio/SoundState.h"
#include "core/guidance/Fixture.h"
#include "core/history/MomentId.h"
#include "core/rt/SpscQueue.h"
#include "core/rt/TripleBuffer.h"
#include "core/servo/ServoState.h"
#include "core/servo/ServoTick.h"
#include "core/session/ResumableAttempt.h"
#include "core/terrain/Tooth.h"

/// The commands of the ui to the session (about 100 Hz), the state of the session, and the channels between the ui and
/// the loops.
namespace core::session {

/// Commands of the ui. The ui writes them; the session reads them and forwards those for the servo.
struct Undo
{};
struct Redo
{};
/// Restores the uncut tooth, as a step that can be undone.
struct Reload
{};
/// Goes to any moment of the history.
struct GoTo
{
    history::MomentId id{};
};
/// Replaces the tooth.
struct ReplaceTooth
{
    std::unique_ptr<terrain::Tooth> tooth;
    std::uint64_t generation = 0;  ///< number that states and patches of this tooth carry
    std::string lesson = {};       ///< for which the attempt is made (recording::checkLesson); empty: none
    /// A new servo that computes the attempt. Null: the servo loop keeps its servo.
    std::unique_ptr<servo::ServoTick> servo = {};
};
/// Continues an attempt that was unfinished when the program ended.
struct ResumeAttempt
{
    std::unique_ptr<ResumableAttempt> attempt;
    std::uint64_t generation = 0;  ///< as in ReplaceTooth
};
/// Keeps the hand within an outline until the next such command.
struct SetFixture
{
    std::unique_ptr<const guidance::Fixture> fixture;  ///< null: none
};
/// Sets the aids in use from now on. Recorded.
struct SetAids
{
    std::uint8_t aids = 0;
};
/// Records a number at this moment. Its meaning is defined by those who write and read it.
struct AddNote
{
    std::uint64_t code = 0;
};
/// A command owns its contents. A command that is refused or never executed frees them.
using SessionCommand =
    std::variant<Undo, Redo, Reload, ReplaceTooth, servo::SetBur, servo::SetDrill, servo::SetHandpiece, SetFixture,
                 servo::BringHome, GoTo, ResumeAttempt, SetAids, AddNote, servo::SetParameter>;

/// The newest state of the session. The session thread writes it, the ui reads it.
struct SessionState
{
    std::uint64_t toothGeneration = 0;
    int undoSteps = 0;  ///< strokes that can be undone
    int redoSteps = 0;
    std::uint64_t historyVersion = 0;   ///< changes whenever the result of SessionLoop::historySoFar() changes
    int strokes = 0;                    ///< made since the tooth was opened
    terrain::PerMaterial wholeMm3{};    ///< volumes of the uncut tooth
    terrain::PerMaterial removedMm3{};  ///< compared with the uncut tooth, after undo
    double overcutMm3 = 0.0;            ///< enamel and dentin removed beside or below the decay, which costs points
    double pulpExposedMm2 = 0.0;        ///< area of opened pulp, seen from above, after undo
    bool perforated = false;            ///< there is a hole through the tooth, after undo
    double recordedS = 0.0;
    bool isFull = false;  ///< the attempt is as long as a recording may be, so it must end
};

/// The channels between the ui and the loops. The application owns them and passes references.
struct UiChannels
{
    rt::TripleBuffer<servo::ServoState> servo;                         ///< servo -> ui
    rt::TripleBuffer<SessionState> session;                            ///< session -> ui
    rt::SpscQueue<servo::TilePatch, 512> patches;                      ///< session -> ui
    rt::SpscQueue<SessionCommand, 64, rt::Elements::MayOwn> commands;  ///< ui -> session
    rt::TripleBuffer<servo::PointerInput> pointer;                     ///< ui -> pointer device
    rt::TripleBuffer<audio::SoundState> sound;                         ///< servo, or a replay -> sound
};

}  // namespace core::session
