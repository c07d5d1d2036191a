// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recording/Replay.h"

#include <map>

#include "core/history/TiledHeights.h"

namespace core::recording {

using session::ServoEvent;

Result<ReplayOutcome>
replay(const Recording& recording,
       const std::function<void(const session::ServoState&, const contact::LiveTooth&)>& afterTick)
{
    auto servo = session::makeServoTick(recording.settings());
    if (!servo)
        return tl::unexpected(servo.error());

    // First pass: which moments will be gone back to.
    std::map<std::uint64_t, history::TiledHeights> moments;
    recording.forEach([&](const ServoEvent& event) {
        if (event.kind == ServoEvent::Kind::Restore)
            moments.emplace(event.value, history::TiledHeights{});
    });
    const std::shared_ptr<const terrain::ToothAnatomy>& anatomy = recording.anatomy();
    history::TiledHeights newest(anatomy->grid, anatomy->top);
    if (const auto start = moments.find(0); start != moments.end())
        start->second = newest;

    auto live = std::make_unique<contact::LiveTooth>(terrain::Tooth(anatomy));
    (*servo)->swapTooth(live.get(), true);
    std::uint64_t tick = 0;
    bool agrees = !recording.witness();
    const auto compareWithWitness = [&] {
        if (recording.witness() && recording.witness()->tick == tick)
            agrees = recording.witness()->stateHash == terrain::stateHash(live->tooth());
    };
    compareWithWitness();
    recording.forEach([&](const ServoEvent& event) {
        switch (event.kind) {
        case ServoEvent::Kind::Tick:
        case ServoEvent::Kind::NoDevice:
            (*servo)->step(event.kind == ServoEvent::Kind::Tick ? &event.deviceMm : nullptr,
                           std::chrono::microseconds(event.dtUs));
            ++tick;
            if (const auto moment = moments.find(tick); moment != moments.end()) {
                newest.update(live->tooth().top);
                moment->second = newest;
            }
            compareWithWitness();
            if (afterTick)
                afterTick((*servo)->state(), *live);
            break;
        case ServoEvent::Kind::Drill:
            (*servo)->setDrill(event.value != 0);
            break;
        case ServoEvent::Kind::Bur:
            (*servo)->setBur(static_cast<std::size_t>(event.value));
            break;
        case ServoEvent::Kind::Home:
            (*servo)->bringHome();
            break;
        case ServoEvent::Kind::Spring:
            (*servo)->setSpring(event.value);
            break;
        case ServoEvent::Kind::Restore: {
            auto restored =
                std::make_unique<contact::LiveTooth>(terrain::restored(anatomy, moments.at(event.value).flat()));
            (*servo)->swapTooth(restored.get(), false);
            live = std::move(restored);
            break;
        }
        case ServoEvent::Kind::Begin:
            break;
        }
    });
    ReplayOutcome outcome{live->tooth(), (*servo)->state(), terrain::stateHash(live->tooth()), agrees};
    return outcome;
}

}  // namespace core::recording
