// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QString>

namespace bench {

/// Shows on stderr what is being measured, the progress and the estimated time: at most one line per second.
class Progress
{
public:
    /// @param seconds  usual time of all suites
    explicit Progress(double seconds) : m_seconds(seconds) { m_clock.start(); }

    /// @param seconds  usual time of the suite
    void begin(const QString& suite, double seconds);
    /// @param done, of  steps done, and their number
    void step(const QString& what, int done, int of);
    void end();

private:
    QElapsedTimer m_clock;
    double m_seconds;
    double m_behind = 0.0;  ///< part of m_seconds in finished suites
    QString m_suite;
    double m_suiteSeconds = 0.0;
    double m_toldAt = 0.0;
};

}  // namespace bench
