// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/audio/SoundState.h"

namespace core::audio {

/// Returns the frequency in Hz of the strongest tone of a handpiece whose bur turns `burRpm` times per minute: one
/// period per turn (docs/method.md, section "What is heard").
[[nodiscard]] constexpr double fundamentalHz(double burRpm) noexcept
{
    return burRpm / 60.0;
}

/// A value that follows its target over some milliseconds, so that a change makes no click.
class Smoothed
{
public:
    /// @param share  of the remaining difference that is removed with every sample
    float next(float share) noexcept
    {
        const float difference = target - now;
        // Reaches the target exactly, so that there are no denormal numbers and silence is zero.
        now = difference * difference < kEnough * kEnough ? target : now + share * difference;
        return now;
    }
    [[nodiscard]] bool isZero() const noexcept { return now == 0.0F && target == 0.0F; }

    float now = 0.0F;
    float target = 0.0F;

private:
    static constexpr float kEnough = 1.0e-6F;
};

/// White noise through a band-pass filter, with an effective value of 1 at any sample rate.
class NoiseBand
{
public:
    /// A centre above 0.4 times the sample rate is clamped to that.
    /// @param sharpness  centre over width
    NoiseBand(double centreHz, double sharpness, double rateHz) noexcept;
    /// @param white  uniform from -1 to 1
    float next(float white) noexcept;

private:
    float m_a1 = 0.0F;
    float m_g = 0.0F;
    float m_scale = 0.0F;
    float m_first = 0.0F;
    float m_second = 0.0F;
};

/// Generates the sound of a handpiece at work, sample by sample: the tones of the drive, the noise of its bearings, the
/// noise of cutting, which depends on the material, the contact, chatter, spray and suction.
///
/// The level, pitch and material are smoothed for every sample, so that no change of a parameter clicks. Values that
/// are not finite count as zero. A limiter keeps the output within -1 and 1. The same states give the same samples.
///
/// One thread. render() allocates nothing, locks nothing and throws nothing.
class Synthesizer
{
public:
    static constexpr double kLeastRateHz = 8'000.0;
    static constexpr double kMostRateHz = 192'000.0;
    /// Time constant in seconds with which levels follow.
    static constexpr double kLevelS = 0.004;
    /// Time constant in seconds with which the pitch follows the speed of the bur.
    static constexpr double kPitchS = 0.006;

    /// @param rateHz  samples per second; clamped to its limits
    explicit Synthesizer(double rateHz) noexcept;

    /// Sets volumes for the next samples.
    void setVolumes(const Volumes& volumes) noexcept;
    /// Fills whole frames of `channels` equal samples; samples of an incomplete frame are unchanged.
    void render(const SoundState& state, std::span<float> samples, int channels = 1) noexcept;

    [[nodiscard]] double rateHz() const noexcept { return m_rateHz; }

private:
    static constexpr std::size_t kLines = 5;

    void aim(const SoundState& state) noexcept;
    void aimParts(const SoundState& state) noexcept;
    float sample() noexcept;
    float handpiece() noexcept;
    float cutting() noexcept;
    float contact() noexcept;
    float white() noexcept;
    [[nodiscard]] bool isSilent() const noexcept;

    double m_rateHz;
    float m_levelShare;
    float m_pitchShare;
    float m_spinUpShare;
    float m_spinDownShare;
    float m_clickDecay;
    float m_clickShare;
    float m_wobbleShare;

    Smoothed m_master;
    std::array<Smoothed, kPartCount> m_volumes{};
    Smoothed m_spin;  ///< 0 at rest, 1 when the handpiece has run up
    Smoothed m_rpm;
    Smoothed m_whine;
    Smoothed m_bearings;
    std::array<Smoothed, kLines> m_lines{};
    std::array<Smoothed, terrain::kMaterialCount> m_cuts{};
    Smoothed m_chatter;
    Smoothed m_spray;
    Smoothed m_suction;
    Smoothed m_clickHz;
    Smoothed m_click;

    std::array<double, kLines> m_phases{};
    double m_chatterPhase = 0.0;
    double m_clickPhase = 0.0;
    float m_wobble = 0.0F;
    std::uint32_t m_contacts = 0;
    bool m_hasContacts = false;
    std::uint32_t m_random = 0x9E3779B9U;

    NoiseBand m_bearingBand;
    NoiseBand m_chatterBand;
    NoiseBand m_sprayBand;
    NoiseBand m_suctionBand;
    std::array<NoiseBand, terrain::kMaterialCount> m_cutBands;
};

}  // namespace core::audio
