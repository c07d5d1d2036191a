// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>

namespace app {

/// Holds the hash of the password with which the user logged in, so that they can unlock the window while the database
/// cannot be reached. Each wrong password after kFreeTries makes the user wait before the next try: 2 s, 4 s, up to
/// 1024 s. The tries are counted in memory, apart from those that the database counts. Ui thread.
class OfflineUnlock
{
public:
    using TimePoint = std::chrono::steady_clock::time_point;
    static constexpr int kFreeTries = 3;
    static constexpr int kMostDoublings = 10;

    /// @param now  the clock, which tests replace
    explicit OfflineUnlock(std::function<TimePoint()> now = std::chrono::steady_clock::now) : m_now(std::move(now)) {}

    /// Sets the hash of the user's password. If it is empty, the user cannot unlock without the database.
    void setHash(const std::string& hash) { m_hash = hash; }
    [[nodiscard]] const std::string& hash() const { return m_hash; }
    [[nodiscard]] bool isPossible() const { return !m_hash.empty(); }

    /// Returns the time until the next try is allowed, rounded up; zero if it is allowed now.
    [[nodiscard]] std::chrono::seconds wait() const;
    /// Counts a wrong password.
    void reject();
    /// Resets the number of wrong passwords, after the user has unlocked the window or another user has logged in.
    void resetTries();

private:
    std::function<TimePoint()> m_now;
    std::string m_hash;
    int m_wrong = 0;
    TimePoint m_next;
};

}  // namespace app
