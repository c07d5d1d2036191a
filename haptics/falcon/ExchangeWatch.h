// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <chrono>
#include <cstdint>

#include "core/session/DeviceReport.h"

namespace haptics::falcon {

/// Counts and times the exchanges with a device. The figures for the last second are those of the last complete second.
/// Never allocates.
class ExchangeWatch
{
public:
    using Time = std::chrono::steady_clock::time_point;

    void addRequest() noexcept { ++m_figures.requests; }
    void addAnswer(Time sent, Time received) noexcept;
    void addLost() noexcept { ++m_figures.lost; }
    void addRejected() noexcept { ++m_figures.rejected; }

    /// Closes the present second if it has passed. Call it often.
    void update(Time now) noexcept;
    [[nodiscard]] const core::session::ExchangeFigures& figures() const noexcept { return m_figures; }

private:
    static constexpr std::size_t kTripBins = 500;
    static constexpr double kTripBinUs = 10.0;

    [[nodiscard]] double tripUs(double share) const noexcept;

    core::session::ExchangeFigures m_figures;
    std::array<std::uint32_t, core::session::ExchangeFigures::kBins> m_intervals{};
    std::array<std::uint32_t, kTripBins> m_trips{};  ///< round trips, in steps of kTripBinUs
    std::uint32_t m_answers = 0;                     ///< in this second
    Time m_lastAnswer{};
    Time m_begun{};
};

}  // namespace haptics::falcon
