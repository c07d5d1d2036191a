// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <vector>

#include "bench/Suites.h"
#include "core/audio/Synthesizer.h"
#include "core/base/Rng.h"
#include "core/rt/TripleBuffer.h"
#include "core/settings/Handpiece.h"
#include "haptics/simulated/Simulation.h"
#include "lab/Spectrum.h"
#include "ui/sound/AudioPort.h"
#include "ui/sound/BlockSource.h"

namespace bench {
namespace {

using namespace core::audio;
using core::terrain::Material;

constexpr int kRateHz = 48'000;
constexpr std::size_t kSecond = kRateHz;
constexpr int kSoundSteps = 4;

SoundState cutting(Material material, float mm3PerS)
{
    SoundState state;
    state.turns = true;
    state.burRpm = 0.85F * state.freeRpm;
    state.isTouching = true;
    state.material = material;
    state.cutMm3PerS = mm3PerS;
    state.spray = true;
    state.suction = true;
    return state;
}

/// Returns a second of sound after a second with the same state.
std::vector<float> settled(const SoundState& state, const Volumes& volumes)
{
    Synthesizer synthesizer(kRateHz);
    synthesizer.setVolumes(volumes);
    std::vector<float> samples(kSecond);
    synthesizer.render(state, samples);
    synthesizer.render(state, samples);
    return samples;
}

Volumes only(Part part)
{
    Volumes volumes;
    volumes.parts.fill(0.0F);
    volumes.parts.at(static_cast<std::size_t>(part)) = 1.0F;
    return volumes;
}

/// Returns the thread CPU time of the whole sound over its duration, per cent.
double coreSharePercent()
{
    constexpr std::size_t kSeconds = 20;
    constexpr std::size_t kBlock = 240;
    Synthesizer synthesizer(kRateHz);
    SoundState state = cutting(Material::Enamel, 0.4F);
    state.chatter = 0.5F;
    std::vector<float> samples(kBlock);
    const double before = haptics::threadCpuUs();
    for (std::size_t block = 0; block < kSeconds * kSecond / kBlock; ++block) {
        state.contacts += block % 20 == 0 ? 1 : 0;
        synthesizer.render(state, samples, 1);
    }
    constexpr double kUsToPercent = 1.0e-4;
    return (haptics::threadCpuUs() - before) * kUsToPercent / static_cast<double>(kSeconds);
}

/// Returns the longest time from the tick of the servo in which a load begins to the first sample that differs by 1 %
/// of full scale, milliseconds. The simulated output keeps its buffer full and requests 5 ms at a time, like PulseAudio
/// with this buffer. A request is noticed up to AudioPort::kFillMs late. The delay behind the system's buffer is not
/// known here.
double latencyMs()
{
    constexpr int kFetchMs = 5 + ui::sound::AudioPort::kFillMs;
    constexpr std::size_t kFetch = static_cast<std::size_t>(kRateHz / 1'000 * kFetchMs);
    constexpr float kHeard = 0.01F;
    double longest = 0.0;
    for (int phase = 0; phase < kFetchMs; ++phase) {
        core::rt::TripleBuffer<SoundState> channel;
        ui::sound::BlockSource source(channel);
        source.begin({kRateHz, 1, true});
        source.setHeard(true);
        SoundState state = cutting(Material::Enamel, 0.0F);
        state.isTouching = false;
        state.burRpm = state.freeRpm;
        channel.publish(state);
        constexpr int kRunUp = 100;
        std::vector<float> fetched(kFetch);
        const auto fetch = [&fetched, &source] {
            source.read(reinterpret_cast<char*>(fetched.data()),  // NOLINT(cppcoreguidelines-pro-type-reinterpret-cast)
                        static_cast<qint64>(fetched.size() * sizeof(float)));
        };
        for (int k = 0; k < kRunUp; ++k)
            fetch();
        // The same sound without the load.
        core::rt::TripleBuffer<SoundState> other;
        ui::sound::BlockSource unloaded(other);
        unloaded.begin({kRateHz, 1, true});
        unloaded.setHeard(true);
        other.publish(state);
        std::vector<float> expected(kFetch);
        const auto expect = [&expected, &unloaded] {
            unloaded.read(
                reinterpret_cast<char*>(expected.data()),  // NOLINT(cppcoreguidelines-pro-type-reinterpret-cast)
                static_cast<qint64>(expected.size() * sizeof(float)));
        };
        for (int k = 0; k < kRunUp; ++k)
            expect();
        channel.publish(cutting(Material::Enamel, 0.4F));
        // The samples of the next fetch come after the full buffer.
        const double waitedMs = kFetchMs - phase;
        fetch();
        expect();
        std::size_t first = 0;
        while (first < kFetch && std::abs(fetched[first] - expected[first]) < kHeard)
            ++first;
        constexpr double kMsInS = 1'000.0;
        constexpr double kTickMs = 1.0;
        longest = std::max(longest, kTickMs + waitedMs + ui::sound::AudioPort::kBufferMs +
                                        kMsInS * static_cast<double>(first) / kRateHz);
    }
    return longest;
}

/// Returns the largest difference of the fundamental from the speed of the bur, per cent.
double fundamentalErrorPercent()
{
    constexpr double kPercent = 100.0;
    double worst = 0.0;
    for (const core::settings::Handpiece& handpiece : core::settings::handpieces())
        for (const float share : {1.0F, 0.8F, 0.5F}) {
            SoundState state;
            state.drive = driveOf(handpiece.freeRpm);
            state.turns = true;
            state.freeRpm = static_cast<float>(handpiece.freeRpm);
            state.burRpm = share * state.freeRpm;
            const lab::Spectrum spectrum(settled(state, only(Part::Handpiece)), kRateHz);
            const double wantedHz = fundamentalHz(static_cast<double>(state.burRpm));
            const double heardHz = spectrum.strongestHz(50.0, 0.45 * kRateHz);
            worst = std::max(worst, kPercent * std::abs(heardHz - wantedHz) / wantedHz);
        }
    return worst;
}

/// Returns the largest difference between two successive samples while all inputs change at random.
double largestJump()
{
    constexpr int kChanges = 2'000;
    core::Rng rng(1);
    Synthesizer synthesizer(kRateHz);
    float last = 0.0F;
    float largest = 0.0F;
    for (int change = 0; change < kChanges; ++change) {
        SoundState state = cutting(static_cast<Material>(rng.next() % core::terrain::kMaterialCount),
                                   static_cast<float>(rng.uniform(0.0, 5.0)));
        state.drive = static_cast<Drive>(rng.next() % kDriveCount);
        state.turns = rng.uniform() < 0.8;
        state.isTouching = rng.uniform() < 0.5;
        state.burRpm = static_cast<float>(rng.uniform()) * state.freeRpm;
        state.chatter = static_cast<float>(rng.uniform());
        state.contacts = static_cast<std::uint32_t>(change);
        state.contactMmPerS = static_cast<float>(rng.uniform(0.0, 30.0));
        std::vector<float> samples(1 + rng.next() % 2'000);
        synthesizer.render(state, samples);
        for (const float sample : samples) {
            largest = std::max(largest, std::abs(sample - last));
            last = sample;
        }
    }
    return static_cast<double>(largest);
}

}  // namespace

core::Result<Figures> soundSuite(const Context& context)
{
    Figures figures;
    const auto step = [&](const char* what, int done) {
        if (context.progress)
            context.progress(QString::fromLatin1(what), done, kSoundSteps);
    };
    step("time", 0);
    figures.push_back({QStringLiteral("sound_core_percent"), QStringLiteral("the synthesiser at 48 kHz, of one core"),
                       coreSharePercent(), QStringLiteral("%"), QStringLiteral("under 5")});
    step("latency", 1);
    figures.push_back({QStringLiteral("sound_latency_ms"),
                       QStringLiteral("from a load to the changed sample, with the buffer of 16 ms, at most"),
                       latencyMs(), QStringLiteral("ms"), QStringLiteral("under 30")});
    step("spectra", 2);
    figures.push_back({QStringLiteral("sound_fundamental_error_percent"),
                       QStringLiteral("fundamental beside the speed of the bur, at most"), fundamentalErrorPercent(),
                       QStringLiteral("%"), QStringLiteral("under 1")});
    const lab::Spectrum enamel(settled(cutting(Material::Enamel, 0.4F), only(Part::Cutting)), kRateHz);
    const lab::Spectrum dentin(settled(cutting(Material::Dentin, 1.6F), only(Part::Cutting)), kRateHz);
    constexpr double kLowHz = 100.0;
    constexpr double kHighHz = 0.45 * kRateHz;
    figures.push_back({QStringLiteral("sound_brightness_ratio"),
                       QStringLiteral("mean frequency of cutting, enamel over dentin"),
                       enamel.centroidHz(kLowHz, kHighHz) / dentin.centroidHz(kLowHz, kHighHz), QString(),
                       QStringLiteral("over 1.8")});
    const auto highOverLow = [](const lab::Spectrum& spectrum) {
        return spectrum.power(5'000.0, kHighHz) / spectrum.power(kLowHz, 3'500.0);
    };
    figures.push_back({QStringLiteral("sound_margin_db"),
                       QStringLiteral("power above 5 kHz over that below 3.5 kHz, enamel against dentin"),
                       10.0 * std::log10(highOverLow(enamel) / highOverLow(dentin)), QStringLiteral("dB"),
                       QStringLiteral("over 10")});
    step("changes", 3);
    figures.push_back({QStringLiteral("sound_largest_jump"),
                       QStringLiteral("between two samples, full scale 1, under random changes"), largestJump(),
                       QString(), QStringLiteral("under 0.5")});
    return figures;
}

}  // namespace bench
