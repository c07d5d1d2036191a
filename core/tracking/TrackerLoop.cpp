// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/TrackerLoop.h"

#include <algorithm>
#include <cmath>
#include <thread>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "core/base/Median.h"

namespace core::tracking {
namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr auto kTryAgain = 1s;
constexpr auto kNap = 50ms;  ///< short, so that the thread can be ended soon
constexpr double kWindowS = 1.0;
constexpr double kMovesMm = 1.0;  ///< larger than noise

double secondsOf(Clock::time_point time)
{
    return std::chrono::duration<double>(time.time_since_epoch()).count();
}

}  // namespace

TrackerLoop::TrackerLoop(Open open, const TrackerSettings& settings) : m_open(std::move(open)), m_tracker(settings) {}

void TrackerLoop::begin()
{
    m_tryAt = Clock::now();
    m_hasEnded = false;
}

bool TrackerLoop::waitForBeat(Clock::time_point /*due*/)
{
    if (m_hasEnded || (!m_source && Clock::now() < m_tryAt))
        std::this_thread::sleep_for(kNap);
    return true;
}

void TrackerLoop::tick(std::chrono::microseconds /*dt*/)
{
    if (m_hasEnded || (!m_source && Clock::now() < m_tryAt))
        return;
    if (!m_source) {
        auto opened = m_open();
        if (!opened) {
            lose(opened.error());
            return;
        }
        m_source = std::move(*opened);
        m_startedAt = Clock::now();
        m_watch = {};
        m_lastSecond.clear();
    }
    const auto got = m_source->next(m_picture);
    if (!got) {
        if (got.error().code == ErrorCode::WrongKind)  // a file that is no image is skipped
            return;
        if (m_source->isLive()) {
            lose(got.error());
            return;
        }
    }
    // A video that is cut off ends at this picture.
    if (!got || !*got) {
        m_hasEnded = true;
        const std::lock_guard lock(m_mutex);
        m_report.stage = TrackerStage::Ended;
        return;
    }
    if (!m_source->isLive())
        paceVideo();
    look();
}

void TrackerLoop::lose(const Error& error)
{
    m_source.reset();
    m_tryAt = Clock::now() + kTryAgain;
    const std::lock_guard lock(m_mutex);
    m_report = {};
    m_report.stage = TrackerStage::NoCamera;
    m_report.error = error;
}

/// Waits until the next picture of a video is due, and gives the picture that time.
void TrackerLoop::paceVideo()
{
    const auto due =
        m_startedAt + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(m_picture.timeS));
    std::this_thread::sleep_until(std::min(due, Clock::now() + Clock::duration(1s)));
    m_picture.timeS = secondsOf(Clock::now());
}

void TrackerLoop::look()
{
    auto frame = m_tracker.look(m_picture.view());
    if (!frame) {
        lose(frame.error());
        return;
    }
    const auto tag = frame->tags.empty() ? std::optional<PosedTag>() : frame->tags.front();
    m_published.publish(m_filter.take(tag, m_picture.timeS));
    const PictureTrouble trouble = m_watch.take(m_picture.view());
    note(*frame, 1000.0 * (secondsOf(Clock::now()) - m_picture.timeS));
    const std::lock_guard lock(m_mutex);
    m_report.trouble = trouble;
    if (m_showsPictures)
        m_report.picture = m_picture;
    else
        m_report.picture = {};
}

void TrackerLoop::note(const TagFrame& frame, double latencyMs)
{
    const Head& head = m_filter.head();
    m_lastSecond.push_back({m_picture.timeS, frame.findMs, frame.poseMs, latencyMs, head.isSeen, head.pose.positionMm});
    while (m_picture.timeS - m_lastSecond.front().timeS > kWindowS)
        m_lastSecond.pop_front();
    std::vector<double> find;
    std::vector<double> pose;
    std::vector<double> latency;
    glm::dvec3 mean(0.0);
    double seen = 0.0;
    for (const Sample& sample : m_lastSecond) {
        find.push_back(sample.findMs);
        pose.push_back(sample.poseMs);
        latency.push_back(sample.latencyMs);
        if (sample.isSeen) {
            mean += sample.positionMm;
            seen += 1.0;
        }
    }
    double spread = 0.0;
    for (const Sample& sample : m_lastSecond)
        if (sample.isSeen)
            spread += glm::dot(sample.positionMm - mean / seen, sample.positionMm - mean / seen);
    const double span = m_lastSecond.back().timeS - m_lastSecond.front().timeS;
    const std::lock_guard lock(m_mutex);
    m_report.stage = head.isSeen ? TrackerStage::Tracking : TrackerStage::NoTag;
    m_report.error = {};
    m_report.sameTags = frame.sameTags;
    m_report.hz = span > 0.0 ? static_cast<double>(m_lastSecond.size() - 1) / span : 0.0;
    m_report.findMs = median(std::move(find));
    m_report.poseMs = median(std::move(pose));
    m_report.latencyMs = m_source->isLive() ? median(std::move(latency)) : 0.0;
    m_report.seenShare = seen / static_cast<double>(m_lastSecond.size());
    const double jitterMm = seen > 0.0 ? std::sqrt(spread / seen) : 0.0;
    m_report.jitterMm = jitterMm < kMovesMm ? jitterMm : 0.0;
    if (!frame.tags.empty())
        m_report.tag = frame.tags.front();
}

TrackerReport TrackerLoop::report() const
{
    const std::lock_guard lock(m_mutex);
    return m_report;
}

}  // namespace core::tracking
