// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/ExamClock.h"

#include <algorithm>
#include <utility>

namespace ui::window {

ExamClock::ExamClock(std::function<double()> recordedS) : m_recordedS(std::move(recordedS)) {}

void ExamClock::begin(double limitS)
{
    m_limitS = limitS;
    m_seenS = 0.0;
    m_pausedS = 0.0;
    m_isOver = false;
    m_isStopped = false;
}

void ExamClock::resume(double recordedS, double workedS)
{
    m_seenS = recordedS;
    m_pausedS = recordedS - workedS;
}

bool ExamClock::advance(bool isWorking)
{
    const double nowS = m_recordedS();
    if (!isWorking)
        m_pausedS += nowS - m_seenS;
    m_seenS = nowS;
    const bool isOver = m_limitS > 0.0 && workedS() > m_limitS;
    return isWorking && isOver && !m_isStopped && !std::exchange(m_isOver, true);
}

double ExamClock::workedS() const
{
    return std::max(0.0, m_seenS - m_pausedS);
}

}  // namespace ui::window
