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

/// Work that is done with a school's repositories.
template <class Work>
concept RepositoryWork = std::is_invocable_v<Work&, const database::Repositories&>;

/// Access to the data of a school from the ui thread. SchoolService implements it; tests use fake repositories.
class SchoolAccess
{
public:
    SchoolAccess() = default;
    SchoolAccess(const SchoolAccess&) = delete;
    SchoolAccess& operator=(const SchoolAccess&) = delete;
    virtual ~SchoolAccess() = default;

    /// Runs `work` with the repositories on the school's thread, in the order of the calls, and then passes its result
    /// to `done` on the ui thread. If there is no connection, the error of the connection is the result. If `owner` is
    /// deleted meanwhile, `done` is not called.
    /// @param work  takes `const database::Repositories&` and returns a core::Result or core::Status
    template <RepositoryWork Work, class Done>
    void ask(QObject* owner, Work work, Done done)
    {
        run(jobOf<database::Repositories>(owner, std::move(work), std::move(done)));
    }

    /// As ask(), for long work: runs on a connection and a thread of its own, so that other requests need not wait.
    template <RepositoryWork Work, class Done>
    void askBeside(QObject* owner, Work work, Done done)
    {
        runBeside(jobOf<database::Repositories>(owner, std::move(work), std::move(done)));
    }

    /// Counts the attempts of the login's person that wait on this station for the database.
    virtual void countWaiting(QObject* owner, const database::Login& who, const std::function<void(int)>& done) = 0;

    /// Whether this user could restore a backup now: nobody else has the file open, and no long work runs on it here.
    virtual void expectAlone(QObject* owner, const database::Login& who,
                             const std::function<void(const core::Status&)>& done) = 0;

    /// The time after which a failed request is repeated, in milliseconds.
    [[nodiscard]] virtual int retryMs() const = 0;

protected:
    /// A request, which holds its own result.
    template <class School>
    struct JobOn
    {
        QPointer<QObject> owner;
        /// Does the work and stores its result, or stores the error of the connection. Returns the error of the result.
        std::function<core::Status(const core::Result<const School*>& school)> work;
        /// Passes the result on. Ui thread, once, while the owner exists.
        std::function<void()> done;
    };
    using Job = JobOn<database::Repositories>;

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
