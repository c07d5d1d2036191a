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
/// A new tooth.
struct ReplaceTooth
{
    std::unique_ptr<terrain::Tooth> tooth;
    std::uint64_t generation = 0;  ///< the number that states and patches of this tooth will carry
    std::string lesson = {};       ///< for which the attempt is made (recording::checkLesson); empty: none
    /// Computes the attempt; new. Null: the servo loop keeps the one it has.
    std::unique_ptr<servo::ServoTick> servo = {};
};
/// Continues an attempt that was not finished when the program ended.
struct ResumeAttempt
{
    std::unique_ptr<ResumableAttempt> attempt;
    std::uint64_t generation = 0;  ///< as of ReplaceTooth
};
/// Holds the hand within an outline until this command comes again.
struct SetFixture
{
    std::unique_ptr<const guidance::Fixture> fixture;  ///< null: none
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
/// A command owns what it carries: one that is refused or never carried out frees it.
using SessionCommand =
    std::variant<Undo, Redo, Reload, ReplaceTooth, servo::SetBur, servo::SetDrill, servo::SetHandpiece, SetFixture,
                 servo::BringHome, GoTo, ResumeAttempt, SetAids, AddNote, servo::SetParameter>;

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
    rt::TripleBuffer<servo::ServoState> servo;                         ///< servo -> ui
    rt::TripleBuffer<SessionState> session;                            ///< session -> ui
    rt::SpscQueue<servo::TilePatch, 512> patches;                      ///< session -> ui
    rt::SpscQueue<SessionCommand, 64, rt::Elements::MayOwn> commands;  ///< ui -> session
    rt::TripleBuffer<servo::PointerInput> pointer;                     ///< ui -> pointer device
    rt::TripleBuffer<audio::SoundState> sound;                         ///< servo, or a replay -> sound
};

}  // namespace core::session
