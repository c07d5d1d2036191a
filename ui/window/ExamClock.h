// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace ui::window {

/// Measures the working time of an attempt at a lesson or an exam, and decides when its time is over.
///
/// Working time is recorded time without the pauses. The caller decides when the attempt pauses: practice pauses while
/// another page is open, an exam does not. All times are in seconds.
class ExamClock
{
public:
    /// @param recordedS  returns the recorded time of the attempt
    explicit ExamClock(std::function<double()> recordedS);

    /// Begins an attempt at zero.
    /// @param limitS  the time limit of the lesson; 0: there is no limit
    void begin(double limitS);
    /// Continues an attempt that was interrupted, with its recorded time and its working time.
    void resume(double recordedS, double workedS);
    /// Stops for the rest of the attempt: the exam has ended, and its time can no longer run out.
    void stop() { m_isStopped = true; }
    /// Counts the time since the last call, which is working time if `isWorking`, otherwise a pause.
    /// @return true once per attempt, when its time is over
    [[nodiscard]] bool advance(bool isWorking);
    [[nodiscard]] double workedS() const;

private:
    std::function<double()> m_recordedS;
    double m_limitS = 0.0;
    double m_seenS = 0.0;    ///< recorded time at the last call of advance()
    double m_pausedS = 0.0;  ///< the pauses in m_seenS
    bool m_isOver = false;
    bool m_isStopped = false;
};

}  // namespace ui::window
