// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/falcon/ExchangeWatch.h"

#include <algorithm>

namespace haptics::falcon {
namespace {

constexpr std::chrono::seconds kSecond{1};

double usOf(std::chrono::steady_clock::duration time)
{
    return std::chrono::duration<double, std::micro>(time).count();
}

template <std::size_t Bins>
void count(std::array<std::uint32_t, Bins>& bins, double us, double binUs)
{
    ++bins[std::min(static_cast<std::size_t>(std::max(0.0, us) / binUs), Bins - 1)];
}

}  // namespace

void ExchangeWatch::addAnswer(Time sent, Time received) noexcept
{
    ++m_figures.answers;
    ++m_answers;
    count(m_trips, usOf(received - sent), kTripBinUs);
    if (m_lastAnswer != Time{})
        count(m_intervals, usOf(received - m_lastAnswer), core::session::ExchangeFigures::kBinUs);
    m_lastAnswer = received;
}

void ExchangeWatch::update(Time now) noexcept
{
    if (m_begun == Time{})
        m_begun = now;
    if (now - m_begun < kSecond)
        return;
    m_figures.rateHz = m_answers / std::chrono::duration<double>(now - m_begun).count();
    m_figures.roundTripUs = tripUs(0.5);
    m_figures.slowTripUs = tripUs(0.99);
    m_figures.intervals = m_intervals;
    m_intervals = {};
    m_trips = {};
    m_answers = 0;
    m_begun = now;
}

/// Returns the middle of the histogram bin below which this share of the round trips is; 0 if there are none.
double ExchangeWatch::tripUs(double share) const noexcept
{
    double left = share * m_answers;
    for (std::size_t bin = 0; bin < kTripBins; ++bin) {
        left -= m_trips[bin];
        if (m_answers > 0 && left <= 0.0)
            return (static_cast<double>(bin) + 0.5) * kTripBinUs;
    }
    return 0.0;
}

}  // namespace haptics::falcon
