// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <type_traits>
#include <utility>

#include <QObject>
#include <QPointer>

#include "core/base/Result.h"
#include "database/Login.h"
#include "database/Repositories.h"

namespace app {

/// A function that takes `const database::Repositories&`.
template <class Work>
concept RepositoryWork = std::is_invocable_v<Work&, const database::Repositories&>;

/// Gives the ui thread asynchronous access to the database of a school. SchoolService implements it; tests use fake
/// repositories.
class SchoolAccess
{
public:
    SchoolAccess() = default;
    SchoolAccess(const SchoolAccess&) = delete;
    SchoolAccess& operator=(const SchoolAccess&) = delete;
    virtual ~SchoolAccess() = default;

    /// Runs `work` with the repositories on the thread of the database, in the order of the calls, and then passes its
    /// result to `done` on the ui thread. If there is no connection, the result is the error of the connection. If
    /// `owner` is deleted before that, `done` is not called.
    /// @param work  takes `const database::Repositories&` and returns a core::Result or core::Status
    template <RepositoryWork Work, class Done>
    void ask(QObject* owner, Work work, Done done)
    {
        run(jobOf<database::Repositories>(owner, std::move(work), std::move(done)));
    }

    /// Does the same as ask() for long work: runs it on another connection and another thread, so that other requests
    /// need not wait.
    template <RepositoryWork Work, class Done>
    void askBeside(QObject* owner, Work work, Done done)
    {
        runBeside(jobOf<database::Repositories>(owner, std::move(work), std::move(done)));
    }

    /// Counts the attempts of a user in the outbox of this computer that the database does not have yet.
    virtual void countWaiting(QObject* owner, const database::Login& who, const std::function<void(int)>& done) = 0;

    /// Checks whether this user could restore a backup now: they have permission, no other program has the database
    /// file open, and askBeside() runs no work on it.
    virtual void expectAlone(QObject* owner, const database::Login& who,
                             const std::function<void(const core::Status&)>& done) = 0;

    /// Returns the time after which a failed request is repeated, in milliseconds.
    [[nodiscard]] virtual int retryMs() const = 0;

protected:
    /// A request that stores its own result.
    template <class School>
    struct JobOn
    {
        QPointer<QObject> owner;
        /// Does the work and stores its result, or stores the error of the connection. Returns the error of the result.
        std::function<core::Status(const core::Result<const School*>& school)> work;
        /// Passes the result to the caller. Called once on the ui thread, if the owner still exists.
        std::function<void()> done;
    };
    using Job = JobOn<database::Repositories>;

    /// Makes a request whose work stores its result for `done`.
    /// @param work  takes `const School&` and returns a core::Result or core::Status
    template <class School, class Work, class Done>
    [[nodiscard]] static JobOn<School> jobOf(QObject* owner, Work work, Done done)
    {
        using Answer = decltype(work(std::declval<const School&>()));
        auto answer = std::make_shared<Answer>(tl::unexpected(core::Error{}));
        return {owner,
                [answer, work = std::move(work)](const core::Result<const School*>& school) mutable -> core::Status {
                    if (school)
                        *answer = work(**school);
                    else
                        *answer = tl::unexpected(school.error());
                    return *answer ? core::Status() : tl::unexpected(answer->error());
                },
                [answer, done = std::move(done)]() mutable { done(*answer); }};
    }

    virtual void run(Job job) = 0;
    virtual void runBeside(Job job) = 0;
};

}  // namespace app
