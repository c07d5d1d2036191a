// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <set>

#include <QObject>
#include <QTimer>

#include "app/school/SchoolAccess.h"
#include "app/school/SchoolSession.h"
#include "database/AttemptRecord.h"

namespace app {

/// Checks the attempts of students in the background while a teacher or an admin is logged in: marks the recording of
/// each again and compares the result with the score that the student's computer reported (database/AttemptCheck.h).
/// After each check it pauses for as long as the check took. Ui thread.
class AttemptChecker final : public QObject
{
    Q_OBJECT

public:
    /// @param school    must outlive this object, and so must its service
    /// @param interval  between searches for attempts to check
    AttemptChecker(const SchoolSession& school, std::chrono::milliseconds interval);

signals:
    /// Emitted when an attempt does not match its recording.
    void doubted();

private:
    void search();
    void mark(const struct AttemptToCheck& next);
    void note(database::AttemptId id, database::Doubt found);

    const SchoolSession& m_school;
    QTimer m_timer;
    bool m_isBusy = false;
    /// Attempts whose recordings the school cannot read now, or whose results it cannot note. They are left alone until
    /// the next start.
    std::set<std::int64_t> m_postponed;
};

}  // namespace app
