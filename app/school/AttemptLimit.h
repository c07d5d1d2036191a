// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include <QObject>

#include "app/school/SchoolSession.h"
#include "app/threads/LatestRequest.h"

namespace app {

/// Asks the database whether the student has an attempt left at a lesson that their class was assigned. Other users,
/// and students whose database does not answer within kPatienceMs, may always begin. Ui thread.
class AttemptLimit final : public QObject
{
    Q_OBJECT

public:
    static constexpr int kPatienceMs = 6000;  ///< a busy computer answers late

    /// Both outlive this.
    AttemptLimit(const SchoolSession& school, const LatestRequest& loads) : m_school(school), m_loads(loads) {}

    /// Calls `decide` once, with whether an attempt may begin.
    void ask(const std::string& lessonId, const std::function<void(bool)>& decide);
    /// Calls `go` if an attempt may begin. Otherwise calls `refuse` and emits usedUp(). Calls neither if something else
    /// was requested meanwhile.
    void whenAllowed(
        const std::string& lessonId, const std::function<void()>& go, const std::function<void()>& refuse = [] {});

signals:
    void usedUp();

private:
    const SchoolSession& m_school;
    const LatestRequest& m_loads;
};

}  // namespace app
