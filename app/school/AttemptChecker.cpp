// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/school/AttemptChecker.h"

#include <algorithm>
#include <optional>

#include <QElapsedTimer>

#include "app/school/SchoolService.h"
#include "app/threads/Background.h"
#include "database/AttemptCheck.h"
#include "database/Repositories.h"
#include "lessons/LessonVersion.h"

namespace app {
namespace {

using database::AttemptId;
using database::Doubt;
using database::Repositories;

constexpr int kSearched = 200;  ///< more than the attempts whose recordings a school has lost

}  // namespace

/// An attempt to check, as the database stores it.
struct AttemptChecker::Waiting
{
    database::AttemptRecord attempt;
    std::optional<QByteArray> recording;  ///< empty: the database names one that it cannot read
    QByteArray pack;                      ///< of its lesson's version; empty: in the cache, or not assigned
    std::vector<database::ExamStart> starts;
};

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
        [who = m_school.user,
         postponed = m_postponed](const Repositories& school) -> core::Result<std::optional<Waiting>> {
            const auto ids = school.attempts.toCheck(who, kSearched);
            if (!ids)
                return tl::unexpected(ids.error());
            const auto next =
                std::find_if(ids->begin(), ids->end(), [&](AttemptId id) { return !postponed.contains(id.value); });
            if (next == ids->end())
                return std::optional<Waiting>();
            auto attempt = school.attempts.open(who, *next);
            if (!attempt)
                return tl::unexpected(attempt.error());
            Waiting waiting{std::move(*attempt), QByteArray(), {}, {}};
            if (!waiting.attempt.recordingHash.empty()) {
                auto recording = school.attempts.recording(who, *next);
                waiting.recording = recording ? std::optional(std::move(*recording)) : std::nullopt;
            }
            if (!lessons::isVersionCached(waiting.attempt.lessonHash))
                waiting.pack = school.lessons.version(who, waiting.attempt.lessonHash).value_or(QByteArray());
            auto starts = school.attempts.examStarts(who, waiting.attempt.person, waiting.attempt.lessonId);
            if (!starts)
                return tl::unexpected(starts.error());
            waiting.starts = std::move(*starts);
            return std::optional(std::move(waiting));
        },
        [this](const core::Result<std::optional<Waiting>>& found) {
            m_isBusy = found && *found;
            if (m_isBusy)
                check(**found);
        });
}

void AttemptChecker::check(const Waiting& waiting)
{
    const AttemptId id{waiting.attempt.id};
    if (!waiting.recording) {
        m_postponed.insert(id.value);
        m_isBusy = false;
        return;
    }
    QElapsedTimer took;
    took.start();
    inBackground(
        this,
        [waiting] {
            const std::string& hash = waiting.attempt.lessonHash;
            if (!waiting.pack.isEmpty())
                static_cast<void>(lessons::cacheVersion(hash, waiting.pack));
            const auto assigned = lessons::cachedVersion(hash);
            return database::checkAttempt(waiting.attempt, *waiting.recording,
                                          assigned ? std::optional(*assigned) : std::nullopt, waiting.starts);
        },
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
