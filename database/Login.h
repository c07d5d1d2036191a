// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <cstdint>
#include <string>

#include "database/Permissions.h"

namespace database {

/// Numbers of the database, each of its own kind, so that two cannot be swapped.
struct PersonId
{
    std::int64_t value = 0;
    auto operator<=>(const PersonId&) const = default;
};
struct ClassId
{
    std::int64_t value = 0;
    auto operator<=>(const ClassId&) const = default;
};
struct AttemptId
{
    std::int64_t value = 0;
    auto operator<=>(const AttemptId&) const = default;
};

namespace sql {
class Logins;
}

/// Who asks: a guest, or the person that sql::Logins has let in. It is a claim about who, not about what he may: every
/// operation looks up the person's present role, so that who is disabled is stopped at once.
class Login
{
public:
    /// A guest.
    Login() = default;

    [[nodiscard]] bool isGuest() const { return m_person.value == 0; }
    [[nodiscard]] PersonId person() const { return m_person; }
    /// What audit and files call the person; empty for a guest.
    [[nodiscard]] const std::string& uid() const { return m_uid; }
    [[nodiscard]] const std::string& username() const { return m_username; }
    /// "Ada Lovelace"; the login name of who has no other.
    [[nodiscard]] const std::string& fullName() const { return m_fullName; }
    /// When the session began; for the window, which shows that role's pages.
    [[nodiscard]] Role role() const { return m_role; }
    bool operator==(const Login&) const = default;

private:
    friend class sql::Logins;
    PersonId m_person;
    std::string m_uid;
    std::string m_username;
    std::string m_fullName;
    Role m_role = Role::Guest;
};

}  // namespace database
