// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/school/AttemptChecker.h"

#include <optional>

#include <QElapsedTimer>

#include "app/school/AttemptToCheck.h"
#include "app/school/SchoolService.h"
#include "app/threads/Background.h"
#include "database/Repositories.h"

namespace app {

using database::AttemptId;
using database::Doubt;
using database::Repositories;

AttemptChecker::AttemptChecker(const SchoolSession& school, std::chrono::milliseconds interval) : m_school(school)
{
    m_timer.setInterval(interval);
    connect(&m_timer, &QTimer::timeout, this, &AttemptChecker::search);
    m_timer.start();
}

void AttemptChecker::search()
{
    const database::Role role = m_school.user.role();
    if (m_isBusy || m_school.service == nullptr ||
        (role != database::Role::Instructor && role != database::Role::Admin))
        return;
    m_isBusy = true;
    m_school.service->ask(
        this,
        [who = m_school.user, postponed = m_postponed](const Repositories& school) {
            return nextToCheck(school, who, postponed);
        },
        [this](const core::Result<std::optional<AttemptToCheck>>& found) {
            m_isBusy = found && *found;
            if (m_isBusy)
                mark(**found);
        });
}

void AttemptChecker::mark(const AttemptToCheck& next)
{
    const AttemptId id{next.attempt.id};
    if (!next.recording) {
        m_postponed.insert(id.value);
        m_isBusy = false;
        return;
    }
    QElapsedTimer took;
    took.start();
    inBackground(
        this, [next] { return check(next); },
        [this, id, took](Doubt found) {
            QTimer::singleShot(took.elapsed(), this, [this, id, found] { note(id, found); });
        });
}

void AttemptChecker::note(AttemptId id, Doubt found)
{
    if (m_school.service == nullptr) {
        m_isBusy = false;
        return;
    }
    m_school.service->ask(
        this,
        [who = m_school.user, id, found](const Repositories& school) {
            return school.attempts.noteCheck(who, id, found);
        },
        [this, id, found](const core::Status& noted) {
            m_isBusy = false;
            if (!noted) {
                m_postponed.insert(id.value);
                return;
            }
            if (found != Doubt::None)
                emit doubted();
            search();
        });
}

}  // namespace app
