// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grading/Process.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace core::grading {
namespace {

constexpr std::int64_t kStrokeGapUs = 150'000;  ///< the servo loop ends a stroke, an undo step, after the same gap
constexpr std::int64_t kLiftUs = 50'000;
constexpr std::int64_t kBlockUs = 50'000;
constexpr double kLeastWayMm = 0.1;  ///< two counts of the Falcon's encoders (docs/facts/haptics.md, section 5)

double seconds(std::int64_t micros)
{
    return 1.0e-6 * static_cast<double>(micros);
}

double lengthOf(const glm::dvec3& v)
{
    return std::sqrt(glm::dot(v, v));
}

}  // namespace

void ProcessMeter::Way::begin(const glm::dvec3& placeMm) noexcept
{
    m_fromMm = placeMm;
    m_begun = true;
}

double ProcessMeter::Way::goTo(const glm::dvec3& placeMm) noexcept
{
    if (!m_begun) {
        begin(placeMm);
        return 0.0;
    }
    const double way = lengthOf(placeMm - m_fromMm);
    if (way < kLeastWayMm)
        return 0.0;
    m_fromMm = placeMm;
    return way;
}

void ProcessMeter::take(const servo::ServoState& state, std::chrono::microseconds dt) noexcept
{
    const Micros step = std::max<Micros>(0, dt.count());
    m_total += step;
    const bool isSound = std::isfinite(lengthOf(state.deviceMm) + lengthOf(state.anchorMm) + lengthOf(state.forceN));
    if ((state.health & servo::kDeviceLost) != 0 || !isSound)
        return;
    takeStroke(state, step);
    takeContact(state, step);
    takeJerk(state, step);
}

void ProcessMeter::undone() noexcept
{
    ++m_undos;
    endStroke();
}

void ProcessMeter::interrupted() noexcept
{
    endStroke();
    m_way = {};
    forgetMotion();
}

void ProcessMeter::takeStroke(const servo::ServoState& state, Micros dt) noexcept
{
    const Micros idle = m_total - (state.cutting ? dt : 0) - m_lastCut;
    if (m_strokeBegan >= 0 && idle >= kStrokeGapUs)
        endStroke();

    m_pathMm += m_way.goTo(state.anchorMm);
    if (m_strokeBegan >= 0)
        m_sinceCutMm += m_strokeWay.goTo(state.anchorMm);
    if (!state.cutting)
        return;
    if (m_strokeBegan < 0) {
        m_strokeBegan = m_total - dt;
        ++m_strokes;
        if (m_firstCut < 0)
            m_firstCut = m_total;
        else
            m_longestPause = std::max(m_longestPause, m_strokeBegan - m_lastCut);
        m_strokeWay.begin(state.anchorMm);
        m_strokeMm = 0.0;
        m_sinceCutMm = 0.0;
    }
    m_lastCut = m_total;
    m_strokeMm += m_sinceCutMm;
    m_sinceCutMm = 0.0;
}

void ProcessMeter::endStroke() noexcept
{
    if (m_strokeBegan < 0)
        return;
    m_cutting += m_lastCut - m_strokeBegan;
    m_cuttingPathMm += m_strokeMm;
    m_strokeBegan = -1;
}

void ProcessMeter::takeContact(const servo::ServoState& state, Micros dt) noexcept
{
    if (!state.touching) {
        m_offFor += dt;
        if (m_hasCut && m_offFor >= kLiftUs) {
            ++m_liftOffs;
            m_hasCut = false;
        }
        if (state.drillOn)
            m_inAir += dt;
        return;
    }
    m_offFor = 0;
    m_hasCut = m_hasCut || state.cutting;
    if (!state.drillOn)
        m_burOff += dt;

    const double newtons = lengthOf(state.forceN);
    m_contact += dt;
    m_sumNS += newtons * seconds(dt);
    m_sumN2S += newtons * newtons * seconds(dt);
    m_largestN = std::max(m_largestN, newtons);
    if (newtons > m_forceLimitN)
        m_overLimit += dt;
    m_histogram[static_cast<std::size_t>(std::clamp(newtons / kBinN, 0.0, kBins - 1.0))] += dt;
}

/// Discards the samples from which the next jerk would be computed.
void ProcessMeter::forgetMotion() noexcept
{
    m_blockFor = 0;
    m_blockSum = glm::dvec3(0.0);
    m_blockCount = 0;
}

void ProcessMeter::takeJerk(const servo::ServoState& state, Micros dt) noexcept
{
    if (!state.drillOn) {
        forgetMotion();
        return;
    }
    m_blockSum += state.deviceMm * seconds(dt);
    m_blockFor += dt;
    if (m_blockFor < kBlockUs)
        return;
    std::copy_backward(m_blocks.begin(), m_blocks.end() - 1, m_blocks.end());
    m_blocks[0] = m_blockSum / seconds(m_blockFor);
    m_blockSum = glm::dvec3(0.0);
    m_blockFor = 0;
    if (++m_blockCount < static_cast<int>(m_blocks.size()))
        return;
    m_blockCount = static_cast<int>(m_blocks.size());
    const double blockS = seconds(kBlockUs);
    const glm::dvec3 jerk =
        (m_blocks[0] - 3.0 * m_blocks[1] + 3.0 * m_blocks[2] - m_blocks[3]) / (blockS * blockS * blockS);
    m_jerk2 += glm::dot(jerk, jerk);
    ++m_jerks;
}

Process::Force ProcessMeter::force() const noexcept
{
    Process::Force force;
    const double all = seconds(m_contact);
    force.meanN = m_sumNS / all;
    force.sdN = std::sqrt(std::max(0.0, m_sumN2S / all - force.meanN * force.meanN));
    force.largestN = m_largestN;
    const double wanted = 0.95 * static_cast<double>(m_contact);
    double below = 0.0;
    for (std::size_t bin = 0; bin < kBins; ++bin) {
        const auto here = static_cast<double>(m_histogram[bin]);
        if (below + here >= wanted) {
            const double share = here > 0.0 ? (wanted - below) / here : 0.0;
            force.p95N = std::min(m_largestN, kBinN * (static_cast<double>(bin) + share));
            break;
        }
        below += here;
    }
    // In the last bin only the largest force is known.
    if (force.p95N > kBinN * (kBins - 1.0))
        force.p95N = m_largestN;
    return force;
}

Process ProcessMeter::process() const noexcept
{
    Process result;
    result.totalS = seconds(m_total);
    if (m_firstCut >= 0)
        result.firstCutS = seconds(m_firstCut);
    const bool goesOn = m_strokeBegan >= 0;
    result.cuttingS = seconds(m_cutting + (goesOn ? m_lastCut - m_strokeBegan : 0));
    result.pathMm = m_pathMm;
    result.cuttingPathMm = m_cuttingPathMm + (goesOn ? m_strokeMm : 0.0);
    result.strokes = m_strokes;
    if (m_strokes > 0) {
        result.strokeMm = result.cuttingPathMm / m_strokes;
        result.strokeS = result.cuttingS / m_strokes;
    }
    result.liftOffs = m_liftOffs;
    result.longestPauseS = seconds(m_longestPause);
    if (m_contact > 0)
        result.force = force();
    result.overLimitS = seconds(m_overLimit);
    if (m_jerks > 0)
        result.jerkMmPerS3 = std::sqrt(m_jerk2 / static_cast<double>(m_jerks));
    result.drillInAirS = seconds(m_inAir);
    result.contactBurOffS = seconds(m_burOff);
    result.undos = m_undos;
    return result;
}

}  // namespace core::grading
