// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/threads/SessionThreads.h"

namespace app {
namespace {

constexpr std::chrono::microseconds kSessionPeriod{10'000};

}  // namespace

SessionThreads::SessionThreads(haptics::ServoLoop& servo, core::session::SessionLoop& session,
                               core::session::LiveAssessmentLoop& assessment, core::session::UiChannels& channels)
    : m_servo(servo), m_session(session), m_assessment(assessment), m_channels(channels)
{}

SessionThreads::~SessionThreads()
{
    stop();
}

void SessionThreads::start()
{
    if (m_servoThread)
        return;
    m_servoThread = std::make_unique<LoopThread>(m_servo, kServoPeriod, LoopThread::Urgency::RealTime);
    m_sessionThread = std::make_unique<LoopThread>(m_session, kSessionPeriod, LoopThread::Urgency::Normal);
    m_servoThread->start(QThread::TimeCriticalPriority);
    m_sessionThread->start();
    m_assessmentThread = std::make_unique<LoopThread>(m_assessment, core::session::LiveAssessmentLoop::kPeriod,
                                                      LoopThread::Urgency::Normal);
    m_assessmentThread->start();
}

void SessionThreads::stop()
{
    m_assessmentThread.reset();
    m_servoThread.reset();
    m_sessionThread.reset();
    m_channels.sound.publish({});
}

}  // namespace app
