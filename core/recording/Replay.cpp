// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recording/Replay.h"

#include "core/recording/Format.h"
#include "core/servo/ServoParameters.h"

namespace core::recording {

Result<Replayer> Replayer::make(const Recording& recording)
{
    auto servo = servo::makeServoTick(recording.settings());
    if (!servo)
        return tl::unexpected(servo.error());
    return Replayer(recording, std::move(*servo));
}

Replayer::Replayer(const Recording& recording, std::unique_ptr<servo::ServoTick> servo)
    : m_settings(recording.settings()), m_anatomy(recording.anatomy()),
      m_tooth(std::make_unique<contact::LiveTooth>(terrain::Tooth(m_anatomy))), m_servo(std::move(servo)),
      m_newest(m_anatomy->grid, m_anatomy->top)
{
    recording.forEach([this](const ServoEvent& event) {
        if (event.kind == ServoEvent::Kind::Restore)
            m_moments.emplace(event.value, history::TiledHeights{});
    });
    if (const auto start = m_moments.find(0); start != m_moments.end())
        start->second = m_newest;
    m_servo->swapTooth(m_tooth.get(), true);
}

const history::TiledHeights& Replayer::heights()
{
    m_newest.update(m_tooth->tooth().top);
    return m_newest;
}

bool Replayer::play(const ServoEvent& event)
{
    const auto swap = [this](std::vector<float> top, bool anew) {
        auto restored = std::make_unique<contact::LiveTooth>(terrain::restored(m_anatomy, std::move(top)));
        m_servo->swapTooth(restored.get(), anew, m_tick);
        m_tooth = std::move(restored);
    };
    switch (event.kind) {
    case ServoEvent::Kind::Tick:
    case ServoEvent::Kind::NoDevice:
        m_servo->step(event.kind == ServoEvent::Kind::Tick ? &event.deviceMm : nullptr,
                      std::chrono::microseconds(event.dtUs));
        if (const auto moment = m_moments.find(++m_tick); moment != m_moments.end())
            moment->second = heights();
        return true;
    case ServoEvent::Kind::Drill:
        m_servo->setDrill(event.value != 0);
        break;
    case ServoEvent::Kind::Bur:
        m_servo->setBur(static_cast<std::size_t>(event.value));
        break;
    case ServoEvent::Kind::Handpiece:
        m_servo->setHandpiece(static_cast<std::size_t>(event.value));
        break;
    case ServoEvent::Kind::Number:
        if (const auto number = servo::unpackParameter(event.value))
            m_servo->setNumber(*number);
        break;
    case ServoEvent::Kind::Home:
        m_servo->bringHome();
        break;
    case ServoEvent::Kind::Speed:
        m_servo->setSpeed(event.value);
        break;
    case ServoEvent::Kind::Spring:
        m_servo->setSpring(event.value);
        break;
    case ServoEvent::Kind::Restore:
        // Reading a recording has checked that each moment to return to comes before the event.
        swap(m_moments.at(event.value).flat(), false);
        break;
    case ServoEvent::Kind::Resume:
        if (auto servo = servo::makeServoTick(m_settings))  // uses the settings of the start of the attempt
            m_servo = std::move(*servo);
        swap(m_tooth->tooth().top, true);
        break;
    case ServoEvent::Kind::Aids:
    case ServoEvent::Kind::Note:
    case ServoEvent::Kind::Begin:
        break;
    }
    return false;
}

Result<ReplayOutcome> replay(const Recording& recording,
                             const std::function<void(const ServoEvent&, const Replayer&)>& afterEvent)
{
    auto made = Replayer::make(recording);
    if (!made)
        return tl::unexpected(made.error());
    Replayer& servo = *made;
    bool agrees = !recording.witness();
    const auto compareWithWitness = [&] {
        if (recording.witness() && recording.witness()->tick == servo.tick())
            agrees = recording.witness()->stateHash == terrain::stateHash(servo.tooth().tooth());
    };
    compareWithWitness();
    recording.forEach([&](const ServoEvent& event) {
        if (servo.play(event))
            compareWithWitness();
        if (afterEvent)
            afterEvent(event, servo);
    });
    const terrain::Tooth& tooth = servo.tooth().tooth();
    return ReplayOutcome{tooth, servo.state(), terrain::stateHash(tooth), agrees};
}

}  // namespace core::recording
