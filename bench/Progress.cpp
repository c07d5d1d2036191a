// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/Progress.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "cli/parts/Arguments.h"

namespace bench {
namespace {

QString minutes(double seconds)
{
    const long whole = std::lround(seconds);
    return QStringLiteral("%1:%2").arg(whole / 60).arg(whole % 60, 2, 10, QLatin1Char('0'));
}

}  // namespace

void Progress::begin(const QString& suite, double seconds)
{
    m_suite = suite;
    m_suiteSeconds = seconds;
    m_toldAt = -1.0e9;
}

void Progress::step(const QString& what, int done, int of)
{
    constexpr double kBetweenS = 1.0;
    constexpr double kTrustS = 5.0;  // a shorter time says little about the speed of this machine
    const double gone = 0.001 * static_cast<double>(m_clock.elapsed());
    if (gone - m_toldAt < kBetweenS)
        return;
    m_toldAt = gone;
    const double behind = m_behind + m_suiteSeconds * done / of;
    const double left = (m_seconds - behind) * (gone + kTrustS) / (behind + kTrustS);
    cli::printText(QStringLiteral("%1: %2 (%3 of %4; %5 gone, about %6 left)\n")
                       .arg(m_suite, what)
                       .arg(done + 1)
                       .arg(of)
                       .arg(minutes(gone), minutes(std::max(0.0, left))),
                   stderr);
}

void Progress::end()
{
    m_behind += m_suiteSeconds;
}

}  // namespace bench
