// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>

#include "core/history/TiledHeights.h"
#include "core/recording/Recording.h"
#include "core/servo/ServoState.h"

namespace core::recording {

/// The servo of a recording, led through its events one by one. Any one thread.
class Replayer
{
public:
    /// Only the settings can be wrong.
    [[nodiscard]] static Result<Replayer> make(const Recording& recording);

    /// What happens next: give it all events of the recording, in order. True after a step of the servo.
    bool play(const servo::ServoEvent& event);

    /// Whether a Restore of this tick can be played. Those that were on the recording when this was made can.
    [[nodiscard]] bool knows(std::uint64_t tick) const { return m_moments.contains(tick); }
    /// What the top was after a tick that will be gone back to, where the recording had not come so far.
    void learn(std::uint64_t tick, history::TiledHeights top) { m_moments[tick] = std::move(top); }

    /// Steps of the servo so far.
    [[nodiscard]] std::uint64_t tick() const { return m_tick; }
    /// As of the last step.
    [[nodiscard]] const servo::ServoState& state() const { return m_servo->state(); }
    /// Columns that the last step lowered.
    [[nodiscard]] const cutting::CutRect& changed() const { return m_servo->changed(); }
    [[nodiscard]] const contact::LiveTooth& tooth() const { return *m_tooth; }
    /// The tooth's top as it is now. Tiles that have not changed since the last call are the same.
    [[nodiscard]] const history::TiledHeights& heights();

private:
    Replayer(const Recording& recording, std::unique_ptr<servo::ServoTick> servo);

    servo::ServoSettings m_settings;
    std::shared_ptr<const terrain::ToothAnatomy> m_anatomy;
    std::unique_ptr<contact::LiveTooth> m_tooth;
    std::unique_ptr<servo::ServoTick> m_servo;
    std::uint64_t m_tick = 0;
    history::TiledHeights m_newest;
    std::map<std::uint64_t, history::TiledHeights> m_moments;  ///< by tick: those that will be gone back to
};

struct ReplayOutcome
{
    terrain::Tooth tooth;     ///< as it stood after the last tick
    servo::ServoState state;  ///< of the last tick
    std::uint64_t stateHash = 0;
    /// False if the recording says what the tooth was at some tick and this replay came to something else, or never
    /// to that tick.
    bool agreesWithWitness = true;
};

/// Runs a recording through the very ticks that made it.
/// @param afterEvent  called after every event, with the servo as it is then; may be empty
[[nodiscard]] Result<ReplayOutcome>
replay(const Recording& recording,
       const std::function<void(const servo::ServoEvent&, const Replayer&)>& afterEvent = {});

/// Whether an event is a step of the servo.
[[nodiscard]] inline bool isStep(const servo::ServoEvent& event)
{
    return event.kind == servo::ServoEvent::Kind::Tick || event.kind == servo::ServoEvent::Kind::NoDevice;
}

}  // namespace core::recording
