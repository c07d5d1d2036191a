// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/audio/Synthesizer.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace core::audio {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

// Levels of the parts at full volume; together they stay below the limiter most of the time.
constexpr float kWhineLevel = 0.22F;
constexpr float kBearingLevel = 0.04F;
constexpr float kCutLevel = 0.14F;
constexpr float kChatterLevel = 0.12F;
constexpr float kClickLevel = 0.35F;
constexpr float kSprayLevel = 0.06F;
constexpr float kSuctionLevel = 0.08F;

constexpr double kSpinUpS = 0.08;
constexpr double kSpinDownS = 0.15;
constexpr double kClickDecayS = 0.008;
constexpr double kClickAttackS = 0.0012;
constexpr double kWobbleS = 0.01;

/// Frequency of each line as a multiple of the fundamental: the shaft of a motor with a 1:5 gear, the bur and its
/// harmonics, and the meshing of a gear with twelve teeth.
constexpr std::array<double, 5> kLineRatios{0.2, 1.0, 2.0, 3.0, 12.0};
/// Level of each line for each drive. The bur is the loudest line of every drive.
constexpr std::array<std::array<float, 5>, kDriveCount> kLineLevels{
    {{0.0F, 1.0F, 0.3F, 0.12F, 0.0F}, {0.3F, 0.75F, 0.2F, 0.1F, 0.0F}, {0.0F, 0.9F, 0.5F, 0.3F, 0.45F}}};
constexpr std::array<float, kDriveCount> kBearingShares{1.0F, 0.5F, 0.4F};

/// Noise of cutting by material: caries, enamel, dentin, pulp.
struct CutNoise
{
    double centreHz;
    double sharpness;
    float level;
    float mm3PerS;  ///< volume that about 1 N removes; it sounds with `level`
    float clickHz;
};
constexpr std::array<CutNoise, terrain::kMaterialCount> kCutNoises{{{900.0, 0.9, 0.6F, 4.0F, 900.0F},
                                                                    {7'200.0, 2.5, 1.0F, 0.4F, 3'200.0F},
                                                                    {2'300.0, 1.2, 0.9F, 1.6F, 1'700.0F},
                                                                    {500.0, 0.8, 0.4F, 4.0F, 600.0F}}};
/// Level of the rubbing of a bur that turns on the tooth without removing anything.
constexpr float kRub = 0.12F;
constexpr float kLoudestCut = 1.6F;
constexpr double kChatterHz = 55.0;
constexpr float kFastContactMmPerS = 20.0F;
constexpr float kLeastClick = 0.15F;

constexpr double kFadeFrom = 0.40;  ///< from here to kFadeTo, in sample rates, lines fade out to avoid aliasing
constexpr double kFadeTo = 0.46;
constexpr double kHighestCentre = 0.4;

constexpr float kLimitFrom = 0.8F;
constexpr float kLimitRoom = 0.19F;

constexpr float kMostRpm = 1'000'000.0F;

float shareASample(double timeS, double rateHz)
{
    return static_cast<float>(1.0 - std::exp(-1.0 / (timeS * rateHz)));
}

/// Returns a value limited to a range. A value that is not finite becomes the lower limit.
float bounded(float value, float low, float high) noexcept
{
    return std::isfinite(value) ? std::clamp(value, low, high) : low;
}

float limited(float value) noexcept
{
    const float size = std::abs(value);
    if (size <= kLimitFrom)
        return value;
    return std::copysign(kLimitFrom + kLimitRoom * std::tanh((size - kLimitFrom) / kLimitRoom), value);
}

/// Returns the sine of a fraction of a turn, 0 to 1, with an error of at most 4e-6. The library's sine would take half
/// of the synthesiser's time.
float sineOfTurn(double turn) noexcept
{
    double away = 0.5 - turn;
    if (std::abs(away) > 0.25)
        away = std::copysign(0.5, away) - away;
    const double angle = kTurn * away;
    const double square = angle * angle;
    // The series of the sine, up to the ninth power.
    const double series =
        1.0 + square * (-1.0 / 6.0 + square * (1.0 / 120.0 + square * (-1.0 / 5'040.0 + square / 362'880.0)));
    return static_cast<float>(angle * series);
}

/// Advances a phase by less than a turn and returns its sine.
float turned(double& phase, double cyclesPerSample) noexcept
{
    phase += cyclesPerSample;
    if (phase >= 1.0)
        phase -= 1.0;
    return sineOfTurn(phase);
}

std::array<NoiseBand, terrain::kMaterialCount> cutBands(double rateHz) noexcept
{
    const auto band = [rateHz](std::size_t material) {
        return NoiseBand(kCutNoises[material].centreHz, kCutNoises[material].sharpness, rateHz);
    };
    return {band(0), band(1), band(2), band(3)};
}

double boundedRate(double rateHz) noexcept
{
    return std::isfinite(rateHz) ? std::clamp(rateHz, Synthesizer::kLeastRateHz, Synthesizer::kMostRateHz)
                                 : Synthesizer::kLeastRateHz;
}

}  // namespace

Drive driveOf(double freeRpm) noexcept
{
    constexpr double kFastestElectric = 220'000.0;
    constexpr double kFastestLowSpeed = 50'000.0;
    if (freeRpm > kFastestElectric)
        return Drive::Turbine;
    return freeRpm > kFastestLowSpeed ? Drive::Electric : Drive::LowSpeed;
}

// A state-variable filter with trapezoidal integrators: Zavalishin, The Art of VA Filter Design, 2012, chapter 4.
NoiseBand::NoiseBand(double centreHz, double sharpness, double rateHz) noexcept
{
    const double centre = std::min(centreHz, kHighestCentre * rateHz);
    const double g = std::tan(std::numbers::pi * centre / rateHz);
    const double damping = 1.0 / sharpness;
    m_g = static_cast<float>(g);
    m_a1 = static_cast<float>(1.0 / (1.0 + g * (g + damping)));
    // The effective value of filtered white noise follows from the energy of the impulse response and the level of the
    // noise.
    constexpr double kImpulseS = 0.05;
    double energy = 0.0;
    m_scale = 1.0F;
    for (auto left = static_cast<int>(kImpulseS * rateHz); left > 0; --left) {
        const auto response = static_cast<double>(next(energy == 0.0 ? 1.0F : 0.0F));
        energy += response * response;
    }
    constexpr double kNoiseVariance = 1.0 / 3.0;
    m_scale = static_cast<float>(1.0 / std::sqrt(energy * kNoiseVariance));
    m_first = 0.0F;
    m_second = 0.0F;
}

float NoiseBand::next(float white) noexcept
{
    const float v1 = m_a1 * (m_first + m_g * (white - m_second));
    const float v2 = m_second + m_g * v1;
    m_first = 2.0F * v1 - m_first;
    m_second = 2.0F * v2 - m_second;
    return m_scale * v1;
}

Synthesizer::Synthesizer(double rateHz) noexcept
    : m_rateHz(boundedRate(rateHz)), m_levelShare(shareASample(kLevelS, m_rateHz)),
      m_pitchShare(shareASample(kPitchS, m_rateHz)), m_spinUpShare(shareASample(kSpinUpS, m_rateHz)),
      m_spinDownShare(shareASample(kSpinDownS, m_rateHz)), m_clickDecay(1.0F - shareASample(kClickDecayS, m_rateHz)),
      m_clickShare(shareASample(kClickAttackS, m_rateHz)), m_wobbleShare(shareASample(kWobbleS, m_rateHz)),
      m_bearingBand(4'000.0, 1.2, m_rateHz), m_chatterBand(220.0, 1.5, m_rateHz), m_sprayBand(6'000.0, 0.5, m_rateHz),
      m_suctionBand(700.0, 0.5, m_rateHz), m_cutBands(cutBands(m_rateHz))
{
    setVolumes({});
    m_master.now = m_master.target;
    for (Smoothed& volume : m_volumes)
        volume.now = volume.target;
    m_clickHz.now = kCutNoises[1].clickHz;
    m_clickHz.target = m_clickHz.now;
}

void Synthesizer::setVolumes(const Volumes& volumes) noexcept
{
    m_master.target = volumes.isMuted ? 0.0F : bounded(volumes.master, 0.0F, 1.0F);
    for (std::size_t part = 0; part < kPartCount; ++part)
        m_volumes[part].target = bounded(volumes.parts[part], 0.0F, 1.0F);
}

/// Sets the targets of all smoothed values.
void Synthesizer::aim(const SoundState& state) noexcept
{
    const float freeRpm = bounded(state.freeRpm, 1.0F, kMostRpm);
    m_spin.target = state.turns ? 1.0F : 0.0F;
    if (state.turns) {
        // A handpiece that is switched off runs down from its last speed, see handpiece().
        m_rpm.target = bounded(state.burRpm, 0.0F, freeRpm);
        if (m_spin.now == 0.0F)
            m_rpm.now = m_rpm.target;
        m_whine.target = m_rpm.target / freeRpm;
    }
    const auto drive = std::min(static_cast<std::size_t>(state.drive), kDriveCount - 1);
    for (std::size_t line = 0; line < kLines; ++line)
        m_lines[line].target = kWhineLevel * kLineLevels[drive][line];
    m_bearings.target = kBearingLevel * kBearingShares[drive];
    aimParts(state);
    if (m_hasContacts && state.isTouching && state.contacts != m_contacts) {
        const float speed = bounded(state.contactMmPerS, 0.0F, kFastContactMmPerS) / kFastContactMmPerS;
        m_click.target = std::min(1.0F, m_click.target + kLeastClick + (1.0F - kLeastClick) * speed);
    }
    m_contacts = state.contacts;
    m_hasContacts = true;
}

void Synthesizer::aimParts(const SoundState& state) noexcept
{
    const auto material = std::min(static_cast<std::size_t>(state.material), m_cuts.size() - 1);
    const CutNoise& noise = kCutNoises[material];
    float cut = 0.0F;
    if (state.turns && state.isTouching)
        cut = kRub + (1.0F - kRub) * std::sqrt(bounded(state.cutMm3PerS / noise.mm3PerS, 0.0F, kLoudestCut));
    for (std::size_t one = 0; one < m_cuts.size(); ++one)
        m_cuts[one].target = one == material ? kCutLevel * noise.level * cut : 0.0F;
    m_chatter.target = state.turns && state.isTouching ? bounded(state.chatter, 0.0F, 1.0F) : 0.0F;
    m_spray.target = state.spray ? kSprayLevel : 0.0F;
    m_suction.target = state.suction ? kSuctionLevel : 0.0F;
    m_clickHz.target = noise.clickHz;
}

float Synthesizer::white() noexcept
{
    // Marsaglia, Xorshift RNGs, 2003.
    m_random ^= m_random << 13U;
    m_random ^= m_random >> 17U;
    m_random ^= m_random << 5U;
    return static_cast<float>(static_cast<std::int32_t>(m_random)) * 0x1.0p-31F;
}

float Synthesizer::handpiece() noexcept
{
    const float spin = m_spin.next(m_spin.target > m_spin.now ? m_spinUpShare : m_spinDownShare);
    const float rpm = m_rpm.next(m_pitchShare);
    const float level = spin * m_whine.next(m_pitchShare);
    m_wobble += m_wobbleShare * (white() - m_wobble);
    const float steady = 1.0F + m_wobble;
    const double cycles = fundamentalHz(static_cast<double>(spin * rpm)) / m_rateHz;
    float sum = 0.0F;
    for (std::size_t line = 0; line < kLines; ++line) {
        const double frequency = cycles * kLineRatios[line];
        const double heard = std::clamp((kFadeTo - frequency) / (kFadeTo - kFadeFrom), 0.0, 1.0);
        const float strength = m_lines[line].next(m_levelShare) * static_cast<float>(heard);
        if (strength > 0.0F && level > 0.0F)
            sum += strength * turned(m_phases[line], frequency);
    }
    return level * (steady * sum + m_bearings.next(m_levelShare) * m_bearingBand.next(white()));
}

float Synthesizer::cutting() noexcept
{
    const float noise = white();
    float sum = 0.0F;
    for (std::size_t material = 0; material < m_cuts.size(); ++material)
        sum += m_cuts[material].next(m_levelShare) * m_cutBands[material].next(noise);
    const float chatter = m_chatter.next(m_levelShare);
    const float beat = 0.5F + 0.5F * turned(m_chatterPhase, kChatterHz / m_rateHz);
    return sum * (1.0F - 0.7F * chatter * beat) + kChatterLevel * chatter * (1.0F - beat) * m_chatterBand.next(white());
}

float Synthesizer::contact() noexcept
{
    m_click.target = m_click.target > 1.0e-4F ? m_click.target * m_clickDecay : 0.0F;
    const float level = m_click.next(m_clickShare);
    const auto hz = static_cast<double>(m_clickHz.next(m_levelShare));
    return kClickLevel * level * turned(m_clickPhase, hz / m_rateHz);
}

float Synthesizer::sample() noexcept
{
    const auto volume = [this](Part part) { return m_volumes[static_cast<std::size_t>(part)].next(m_levelShare); };
    float sum = volume(Part::Handpiece) * handpiece();
    sum += volume(Part::Cutting) * cutting();
    sum += volume(Part::Contact) * contact();
    const float noise = white();
    sum += volume(Part::Spray) * m_spray.next(m_levelShare) * m_sprayBand.next(noise);
    sum += volume(Part::Suction) * m_suction.next(m_levelShare) * m_suctionBand.next(noise);
    return limited(m_master.next(m_levelShare) * sum);
}

bool Synthesizer::isSilent() const noexcept
{
    if (m_master.isZero())
        return true;
    return m_spin.isZero() && m_click.isZero() && m_spray.isZero() && m_suction.isZero() && m_chatter.isZero() &&
           std::all_of(m_cuts.begin(), m_cuts.end(), [](const Smoothed& cut) { return cut.isZero(); });
}

void Synthesizer::render(const SoundState& state, std::span<float> samples, int channels) noexcept
{
    if (channels < 1)
        return;
    aim(state);
    const auto width = static_cast<std::size_t>(channels);
    const std::size_t frames = samples.size() / width;
    if (isSilent()) {
        // At silence, the values jump to their targets, because smoothing would not be heard.
        m_click.target = 0.0F;
        m_click.now = 0.0F;
        std::fill_n(samples.begin(), frames * width, 0.0F);
        return;
    }
    for (std::size_t frame = 0; frame < frames; ++frame)
        std::fill_n(samples.begin() + static_cast<std::ptrdiff_t>(frame * width), width, sample());
}

}  // namespace core::audio
