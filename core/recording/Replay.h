// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>

#include "core/history/TiledHeights.h"
#include "core/recording/Recording.h"
#include "core/servo/ServoState.h"

namespace core::recording {

/// Replays the events of a recording one by one. One thread.
class Replayer
{
public:
    /// Creates a replayer. The only possible error is invalid settings.
    [[nodiscard]] static Result<Replayer> make(const Recording& recording);

    /// Plays the next event. Call with all events of the recording, in order. Returns true after a step of the servo.
    bool play(const servo::ServoEvent& event);

    /// Returns whether a Restore of this tick can be played. Those in the recording at creation can.
    [[nodiscard]] bool knows(std::uint64_t tick) const { return m_moments.contains(tick); }
    /// Adds the top map after a tick for a later Restore that was not in the recording at creation.
    void learn(std::uint64_t tick, history::TiledHeights top) { m_moments[tick] = std::move(top); }

    /// Returns the number of servo steps so far.
    [[nodiscard]] std::uint64_t tick() const { return m_tick; }
    /// Returns the state after the last step.
    [[nodiscard]] const servo::ServoState& state() const { return m_servo->state(); }
    /// Returns the columns that the last step lowered.
    [[nodiscard]] const cutting::CutRect& changed() const { return m_servo->changed(); }
    [[nodiscard]] const contact::LiveTooth& tooth() const { return *m_tooth; }
    /// Returns the current top of the tooth. Tiles that have not changed since the last call are shared with it.
    [[nodiscard]] const history::TiledHeights& heights();

private:
    Replayer(const Recording& recording, std::unique_ptr<servo::ServoTick> servo);

    servo::ServoSettings m_settings;
    std::shared_ptr<const terrain::ToothAnatomy> m_anatomy;
    std::unique_ptr<contact::LiveTooth> m_tooth;
    std::unique_ptr<servo::ServoTick> m_servo;
    std::uint64_t m_tick = 0;
    history::TiledHeights m_newest;
    std::map<std::uint64_t, history::TiledHeights> m_moments;  ///< by tick: those that a Restore needs
};

struct ReplayOutcome
{
    terrain::Tooth tooth;     ///< after the last tick
    servo::ServoState state;  ///< of the last tick
    std::uint64_t stateHash = 0;
    /// False if the recording has a witness and this replay came to another state at its tick, or never reached that
    /// tick.
    bool agreesWithWitness = true;
};

/// Replays a recording with the same ticks that made it.
/// @param afterEvent  called after every event with the state of the servo; may be empty
[[nodiscard]] Result<ReplayOutcome>
replay(const Recording& recording,
       const std::function<void(const servo::ServoEvent&, const Replayer&)>& afterEvent = {});

/// Returns whether an event is a step of the servo.
[[nodiscard]] inline bool isStep(const servo::ServoEvent& event)
{
    return event.kind == servo::ServoEvent::Kind::Tick || event.kind == servo::ServoEvent::Kind::NoDevice;
}

}  // namespace core::recording
