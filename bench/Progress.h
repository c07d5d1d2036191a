// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QString>

namespace bench {

/// Tells on stderr what is being measured, how far it is and about how long it will take: at most a line a second.
class Progress
{
public:
    /// @param seconds  that all suites to be run usually take
    explicit Progress(double seconds) : m_seconds(seconds) { m_clock.start(); }

    /// @param seconds  that the suite usually takes
    void begin(const QString& suite, double seconds);
    /// @param done  steps of the suite that are behind, of so many
    void step(const QString& what, int done, int of);
    void end();

private:
    QElapsedTimer m_clock;
    double m_seconds;
    double m_behind = 0.0;  ///< of m_seconds, in whole suites
    QString m_suite;
    double m_suiteSeconds = 0.0;
    double m_toldAt = 0.0;
};

}  // namespace bench
