// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "database/Permissions.h"

namespace database {

/// Ids in the database. Each kind has its own type, so that they cannot be confused.
struct PersonId
{
    std::int64_t value = 0;
    bool operator==(const PersonId&) const = default;
    bool operator<(const PersonId& other) const { return value < other.value; }
};
struct ClassId
{
    std::int64_t value = 0;
    bool operator==(const ClassId&) const = default;
    bool operator<(const ClassId& other) const { return value < other.value; }
};
struct AttemptId
{
    std::int64_t value = 0;
    bool operator==(const AttemptId&) const = default;
    bool operator<(const AttemptId& other) const { return value < other.value; }
};

namespace sql {
class Logins;
}

/// The user who makes a request: a guest, or the person that sql::Logins has authenticated. It identifies the person
/// only: every operation looks up the person's current role, so that a disabled person is stopped at once.
class Login
{
public:
    /// Creates the login of a guest.
    Login() = default;

    [[nodiscard]] bool isGuest() const { return m_person.value == 0; }
    [[nodiscard]] PersonId person() const { return m_person; }
    /// Returns the id of the person in audit and files; empty for a guest.
    [[nodiscard]] const std::string& uid() const { return m_uid; }
    [[nodiscard]] const std::string& username() const { return m_username; }
    /// Returns the full name, "Ada Lovelace"; the username of a person without a name.
    [[nodiscard]] const std::string& fullName() const { return m_fullName; }
    /// Returns the role at the time of the login; for the window, which shows the pages of that role.
    [[nodiscard]] Role role() const { return m_role; }
    bool operator==(const Login&) const = default;

private:
    friend class sql::Logins;
    /// What a server needs to know again from a station whose account may not read passwords.
    struct Proof
    {
        std::string token;
        std::string passwordHash;
    };
    PersonId m_person;
    std::string m_uid;
    std::string m_username;
    std::string m_fullName;
    Role m_role = Role::Guest;
    std::shared_ptr<Proof> m_proof;  ///< shared by the copies, used by Logins only; null where none is needed
};

}  // namespace database
