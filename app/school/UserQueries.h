// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <utility>

#include <QObject>

#include "app/school/SchoolAccess.h"
#include "core/base/Result.h"
#include "database/Login.h"
#include "database/Repositories.h"

namespace app {

/// Sends requests to the database in the name of the user who is logged in. Discards a result that arrives after
/// another user has logged in. Ui thread.
class UserQueries
{
public:
    /// @param school  must outlive this object
    /// @param who     returns the current login
    UserQueries(SchoolAccess& school, std::function<database::Login()> who) : m_school(school), m_who(std::move(who)) {}

    [[nodiscard]] database::Login who() const { return m_who(); }
    [[nodiscard]] SchoolAccess& school() const { return m_school; }

    /// Calls SchoolAccess::ask(), and calls `done` only if the same user is still logged in.
    /// @param work  takes `const database::Repositories&` and the user's `const database::Login&`
    template <class Work, class Done>
    void ask(QObject* owner, Work work, Done done) const
    {
        m_school.ask(
            owner,
            [who = m_who(), work = std::move(work)](const database::Repositories& school) { return work(school, who); },
            [isWho = m_who, who = m_who(), done = std::move(done)](auto& answer) mutable {
                if (isWho() == who)
                    done(answer);
            });
    }

    /// Returns whether an instructor was refused because the student or the class is not theirs any more.
    [[nodiscard]] bool hasLostAccess(const core::Error& error) const
    {
        return error.code == core::ErrorCode::NotAllowed && m_who().role() == database::Role::Instructor;
    }

private:
    SchoolAccess& m_school;
    std::function<database::Login()> m_who;
};

}  // namespace app
