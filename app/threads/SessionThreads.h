// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <memory>

#include "app/threads/LoopThread.h"
#include "core/session/LiveAssessmentLoop.h"
#include "core/session/SessionChannels.h"
#include "core/session/SessionLoop.h"
#include "haptics/ServoLoop.h"

namespace app {

/// The threads of the student's attempt: servo, session and live assessment. Ui thread.
class SessionThreads
{
public:
    static constexpr std::chrono::microseconds kServoPeriod{1000};

    /// All of them outlive this.
    SessionThreads(haptics::ServoLoop& servo, core::session::SessionLoop& session,
                   core::session::LiveAssessmentLoop& assessment, core::session::UiChannels& channels);
    /// Stops them.
    ~SessionThreads();
    SessionThreads(const SessionThreads&) = delete;
    SessionThreads& operator=(const SessionThreads&) = delete;

    void start();
    /// Returns when all of them have stopped. The handpiece becomes silent.
    void stop();

private:
    haptics::ServoLoop& m_servo;
    core::session::SessionLoop& m_session;
    core::session::LiveAssessmentLoop& m_assessment;
    core::session::UiChannels& m_channels;
    std::unique_ptr<LoopThread> m_servoThread;
    std::unique_ptr<LoopThread> m_sessionThread;
    std::unique_ptr<LoopThread> m_assessmentThread;
};

}  // namespace app
