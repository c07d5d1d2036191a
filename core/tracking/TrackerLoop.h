// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>

#include "core/rt/Loop.h"
#include "core/rt/TripleBuffer.h"
#include "core/tracking/HeadFilter.h"
#include "core/tracking/PictureSource.h"
#include "core/tracking/PictureWatch.h"
#include "core/tracking/TagTracker.h"
#include "core/tracking/TrackerReport.h"

namespace core::tracking {

/// Reads pictures, finds the tag on the head and publishes its place. Waits in tick() for its source, so it needs a
/// thread of its own (app/threads/LoopThread).
class TrackerLoop final : public rt::Loop
{
public:
    using Open = std::function<Result<std::unique_ptr<PictureSource>>()>;

    /// @param open      called in the loop's thread, and again if the source is lost
    /// @param settings  must be valid
    TrackerLoop(Open open, const TrackerSettings& settings);

    void begin() override;
    void tick(std::chrono::microseconds dt) override;
    bool waitForBeat(std::chrono::steady_clock::time_point due) override;
    void end() override { m_source.reset(); }

    /// Returns the newest place of the head. One thread, which never waits.
    [[nodiscard]] const Head& head() { return m_published.latest(); }
    /// Returns the newest report. Any thread.
    [[nodiscard]] TrackerReport report() const;
    /// Sets whether reports contain the picture. Any thread.
    void showPictures(bool shows) { m_showsPictures = shows; }

private:
    struct Sample
    {
        double timeS = 0.0;
        double findMs = 0.0;
        double poseMs = 0.0;
        double latencyMs = 0.0;
        bool isSeen = false;
        glm::dvec3 positionMm{0.0};
    };
    void lose(const Error& error);
    void paceVideo();
    void look();
    void note(const TagFrame& frame, double latencyMs);

    Open m_open;
    TagTracker m_tracker;
    HeadFilter m_filter;
    PictureWatch m_watch;
    std::unique_ptr<PictureSource> m_source;
    Picture m_picture;
    std::chrono::steady_clock::time_point m_tryAt;
    std::chrono::steady_clock::time_point m_startedAt;
    bool m_hasEnded = false;
    std::deque<Sample> m_lastSecond;
    rt::TripleBuffer<Head> m_published;
    std::atomic<bool> m_showsPictures{false};
    mutable std::mutex m_mutex;
    TrackerReport m_report;  ///< guarded by m_mutex
};

}  // namespace core::tracking
