// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>

namespace app {

/// Decides whether a user who locked the window may unlock it while the database cannot be reached: by the hash of the
/// password that they logged in with. After three wrong passwords the wait before the next one doubles each time, as in
/// the database. Ui thread.
class OfflineUnlock
{
public:
    using TimePoint = std::chrono::steady_clock::time_point;
    static constexpr int kFreeTries = 3;
    static constexpr int kMostDoublings = 10;

    /// @param now  for tests
    explicit OfflineUnlock(std::function<TimePoint()> now = std::chrono::steady_clock::now) : m_now(std::move(now)) {}

    /// Sets the hash of the user's password; empty: they cannot unlock without the database.
    void setHash(const std::string& hash) { m_hash = hash; }
    [[nodiscard]] const std::string& hash() const { return m_hash; }
    [[nodiscard]] bool isPossible() const { return !m_hash.empty(); }

    /// Returns how long the next try has to wait, rounded up; zero if it may be made now.
    [[nodiscard]] std::chrono::seconds wait() const;
    /// Counts a wrong password.
    void reject();
    /// Forgets wrong passwords: the user is in, or another one is.
    void resetTries();

private:
    std::function<TimePoint()> m_now;
    std::string m_hash;
    int m_wrong = 0;
    TimePoint m_next;
};

}  // namespace app
