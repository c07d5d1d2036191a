// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <glm/vec3.hpp>

#include "core/servo/ServoState.h"

namespace core::grading {

/// The process of an attempt (docs/facts/teaching.md, section 3). Times in seconds, as sums of the ticks' steps and not
/// from a clock.
struct Process
{
    double totalS = 0.0;
    std::optional<double> firstCutS;  ///< from the start until material was first removed; empty: never
    double cuttingS = 0.0;            ///< in strokes

    /// Travel of the bur's tip, mm. Travel shorter than 0.1 mm does not count until it is that long: noise in the last
    /// count of an encoder at rest is no travel.
    double pathMm = 0.0;
    double cuttingPathMm = 0.0;  ///< part of pathMm in strokes

    /// Number of strokes. A stroke begins when material is removed and ends with the last removal before a pause of 150
    /// ms, like an undo step.
    int strokes = 0;
    std::optional<double> strokeMm;  ///< mean travel of the tip in a stroke
    std::optional<double> strokeS;   ///< mean duration of a stroke
    /// Number of times that a bur which has cut left the tooth for 50 ms or longer (Ioannou 2010: experts lift off
    /// less).
    int liftOffs = 0;
    double longestPauseS = 0.0;  ///< longest time without cutting between two strokes

    /// Force on the hand while the bur touches the tooth, N, over time. Empty without contact. The percentile is from a
    /// histogram of 0.02 N bins (crown preparations take 0.1 to 4.9 N: docs/facts/haptics.md, section 8.5).
    struct Force
    {
        double meanN = 0.0;
        double sdN = 0.0;
        double p95N = 0.0;
        double largestN = 0.0;
        bool operator==(const Force&) const = default;
    };
    std::optional<Force> force;
    double overLimitS = 0.0;  ///< time in contact above the force limit

    /// Root mean square jerk of the hand while the drill is on, mm/s3: third difference of its places, each the mean of
    /// 50 ms (passes movement up to about 5 Hz, suppresses encoder counts). Jerk as the measure of smoothness: Hogan
    /// and Sternad 2009. Empty with less than 0.2 s of it.
    std::optional<double> jerkMmPerS3;

    double drillInAirS = 0.0;     ///< drill on, no contact
    double contactBurOffS = 0.0;  ///< contact, drill off
    int undos = 0;
    bool operator==(const Process&) const = default;
};

/// Computes a Process tick by tick, live or in a replay: the same ticks give the same bits. No allocation; about 10 kB.
class ProcessMeter
{
public:
    /// @param forceLimitN  limit for Process::overLimitS
    explicit ProcessMeter(double forceLimitN) noexcept : m_forceLimitN(forceLimitN) {}

    /// Processes the state after a tick of `dt`. Ticks without a device count as time only.
    void take(const servo::ServoState& state, std::chrono::microseconds dt) noexcept;
    /// Processes a return of the tooth to an earlier state.
    void undone() noexcept;
    /// Must be called after skipped ticks: the movement of the hand in between does not count.
    void interrupted() noexcept;

    /// Returns the process after the last tick; an unfinished stroke counts as far as it has come.
    [[nodiscard]] Process process() const noexcept;

private:
    using Micros = std::int64_t;

    /// The travel of a point, without noise of an encoder count.
    class Way
    {
    public:
        void begin(const glm::dvec3& placeMm) noexcept;
        /// Returns the travel since the last call that returned more than 0.
        double goTo(const glm::dvec3& placeMm) noexcept;

    private:
        glm::dvec3 m_fromMm{0.0};
        bool m_begun = false;
    };
    void takeStroke(const servo::ServoState& state, Micros dt) noexcept;
    void takeContact(const servo::ServoState& state, Micros dt) noexcept;
    void takeJerk(const servo::ServoState& state, Micros dt) noexcept;
    void forgetMotion() noexcept;
    void endStroke() noexcept;
    [[nodiscard]] Process::Force force() const noexcept;

    static constexpr std::size_t kBins = 1000;
    static constexpr double kBinN = 0.02;

    double m_forceLimitN;
    Micros m_total = 0;
    Micros m_cutting = 0;  ///< of finished strokes
    Micros m_firstCut = -1;
    Micros m_lastCut = -1;      ///< end of the last tick that cut
    Micros m_strokeBegan = -1;  ///< of the current stroke; -1: none
    Micros m_longestPause = 0;
    int m_strokes = 0;

    Way m_way;
    double m_pathMm = 0.0;
    Way m_strokeWay;
    double m_strokeMm = 0.0;    ///< of the current stroke, up to its last cut
    double m_sinceCutMm = 0.0;  ///< after its last cut
    double m_cuttingPathMm = 0.0;

    Micros m_offFor = 0;    ///< without contact
    bool m_hasCut = false;  ///< in this contact
    int m_liftOffs = 0;

    Micros m_contact = 0;
    double m_sumNS = 0.0;
    double m_sumN2S = 0.0;
    double m_largestN = 0.0;
    Micros m_overLimit = 0;
    std::array<Micros, kBins> m_histogram{};  ///< the last bin includes all larger forces

    glm::dvec3 m_blockSum{0.0};
    Micros m_blockFor = 0;
    std::array<glm::dvec3, 4> m_blocks{};  ///< newest first
    int m_blockCount = 0;
    double m_jerk2 = 0.0;
    std::uint64_t m_jerks = 0;

    Micros m_inAir = 0;
    Micros m_burOff = 0;
    int m_undos = 0;
};

}  // namespace core::grading
