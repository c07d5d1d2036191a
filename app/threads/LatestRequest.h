// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace app {

/// Numbers the requests for a tooth, a lesson or a recording: the answer to a request is dropped if a later one was
/// made meanwhile. Ui thread.
class LatestRequest
{
public:
    /// Starts a request, and returns its number. Answers to earlier ones are dropped from now on.
    int begin() { return ++m_latest; }
    [[nodiscard]] int latest() const { return m_latest; }
    [[nodiscard]] bool isLatest(int request) const { return request == m_latest; }

private:
    int m_latest = 0;
};

}  // namespace app
