// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/Contestant.h"

#include <array>

#include "haptics/ServoLoop.h"

namespace lab {
namespace {

using namespace core::servo;

/// A ServoLoop whose queues have no reader.
class OurLoop final : public Contestant
{
public:
    OurLoop(std::unique_ptr<ServoTick> tick, haptics::HapticDevice& device,
            std::unique_ptr<core::contact::LiveTooth> tooth, bool drill, std::chrono::microseconds period)
        : m_period(period), m_loop(device, std::move(tick), *m_links, m_states, period)
    {
        hand(std::move(tooth), true);
        static_cast<void>(m_links->commands.tryPush(SetDrill{drill}));
    }
    void tick() noexcept override
    {
        m_loop.tick(m_period);
        for (ServoEvent event; m_links->events.tryPop(event);) {
            // a trial is not recorded
        }
        for (TilePatch patch; m_links->patches.tryPop(patch);) {
            // and no view shows it
        }
        for (core::contact::LiveTooth* old = nullptr; m_links->retired.tryPop(old);)
            delete old;
    }
    void swapTooth(std::unique_ptr<core::contact::LiveTooth> tooth) override { hand(std::move(tooth), false); }
    void bringHome() override { static_cast<void>(m_links->commands.tryPush(BringHome{})); }
    [[nodiscard]] const ServoState& state() const override { return m_loop.state(); }
    [[nodiscard]] const core::contact::LiveTooth& tooth() const override { return *m_loop.tooth(); }

private:
    void hand(std::unique_ptr<core::contact::LiveTooth> tooth, bool anew)
    {
        ++m_serial;
        if (m_links->commands.tryPush(SwapTooth{tooth.get(), 1, m_serial, anew, 0}))
            static_cast<void>(tooth.release());
    }

    std::chrono::microseconds m_period;
    std::unique_ptr<ServoChannels> m_links = std::make_unique<ServoChannels>();
    core::rt::TripleBuffer<ServoState> m_states;
    std::uint64_t m_serial = 0;
    haptics::ServoLoop m_loop;
};

class CedsLoop final : public Contestant
{
public:
    CedsLoop(const CedsFigures& figures, const core::settings::HardnessPreset& hardness, haptics::HapticDevice& device,
             std::unique_ptr<core::contact::LiveTooth> tooth, bool drill, std::chrono::microseconds period)
        : m_ceds(figures, hardness), m_device(device), m_period(period)
    {
        CedsLoop::swapTooth(std::move(tooth));
        m_ceds.setDrill(drill);
    }
    void tick() noexcept override
    {
        const haptics::DeviceSample sample = m_device.exchange(m_ceds.state().forceN);
        m_ceds.step(sample.present ? &sample.tipInToothMm : nullptr, m_period);
    }
    void swapTooth(std::unique_ptr<core::contact::LiveTooth> tooth) override
    {
        m_ceds.swapTooth(tooth.get());
        m_tooth = std::move(tooth);
    }
    [[nodiscard]] const ServoState& state() const override { return m_ceds.state(); }
    [[nodiscard]] const core::contact::LiveTooth& tooth() const override { return *m_tooth; }

private:
    Ceds2011 m_ceds;
    haptics::HapticDevice& m_device;
    std::chrono::microseconds m_period;
    std::unique_ptr<core::contact::LiveTooth> m_tooth;
};

}  // namespace

std::span<const std::string_view> contestants()
{
    static constexpr std::array<std::string_view, 5> kNames{"continuous", "lattice", "lattice16", "penalty", kCeds2011};
    return kNames;
}

core::Status checkContestant(const core::servo::ServoSettings& settings)
{
    ServoSettings known = settings;
    if (known.method == kCeds2011)
        known.method = "lattice";
    if (const auto made = makeServoTick(known); !made)
        return tl::unexpected(made.error());
    return {};
}

core::Result<std::unique_ptr<Contestant>> makeContestant(const core::servo::ServoSettings& settings,
                                                         const CedsFigures& ceds, haptics::HapticDevice& device,
                                                         std::unique_ptr<core::contact::LiveTooth> tooth, bool drill,
                                                         std::chrono::microseconds period)
{
    if (const core::Status sound = checkContestant(settings); !sound)
        return tl::unexpected(sound.error());
    if (settings.method == kCeds2011) {
        CedsFigures figures = ceds;
        figures.stiffnessNPerMm = settings.force.stiffnessNPerMm;
        figures.clampN = settings.force.clampN;
        return std::make_unique<CedsLoop>(figures, settings.hardness, device, std::move(tooth), drill, period);
    }
    return std::make_unique<OurLoop>(*makeServoTick(settings), device, std::move(tooth), drill, period);
}

}  // namespace lab
