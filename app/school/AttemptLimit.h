// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include <QObject>

#include "app/school/SchoolSession.h"
#include "app/threads/LatestRequest.h"

namespace app {

/// Asks the database whether the student has an attempt left at a lesson that was assigned to their class. Users who
/// are not students may always begin, and so may students if the database fails or does not answer within kPatienceMs.
/// Ui thread.
class AttemptLimit final : public QObject
{
    Q_OBJECT

public:
    static constexpr int kPatienceMs = 6000;  ///< long enough for the answer of a busy computer

    /// Both arguments must outlive this object.
    AttemptLimit(const SchoolSession& school, const LatestRequest& loads) : m_school(school), m_loads(loads) {}

    /// Calls `decide` once, with true if an attempt may begin.
    void ask(const std::string& lessonId, const std::function<void(bool)>& decide);
    /// Calls `go` if an attempt may begin. Otherwise calls `refuse` and emits usedUp(). Does nothing if `loads` has a
    /// newer request when the answer arrives.
    void whenAllowed(
        const std::string& lessonId, const std::function<void()>& go, const std::function<void()>& refuse = [] {});

signals:
    /// Emitted when whenAllowed() was called for a lesson at which the student has no attempt left.
    void usedUp();

private:
    const SchoolSession& m_school;
    const LatestRequest& m_loads;
};

}  // namespace app
