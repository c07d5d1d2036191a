// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "database/Login.h"

namespace database {

/// What is said of a person when he is entered.
struct NewPerson
{
    std::string username;  ///< letters a to z, digits, dot, hyphen, underline, at; capitals do not count
    std::string givenName;
    std::string familyName;
    Role role = Role::Student;
    bool operator==(const NewPerson&) const = default;
};

struct Person
{
    PersonId id;
    std::string uid;
    std::string username;
    std::string givenName;
    std::string familyName;
    Role role = Role::Student;
    bool disabled = false;
    bool hasPassword = false;
    std::string codeUntilUtc;  ///< until then a one-time code lets him in, once; empty: he has none
    std::string lastLoginUtc;  ///< empty: never
    std::vector<ClassId> classes;
    bool operator==(const Person&) const = default;

    [[nodiscard]] std::string fullName() const
    {
        return givenName + (givenName.empty() || familyName.empty() ? "" : " ") + familyName;
    }
};

struct SchoolClass
{
    ClassId id;
    std::string name;
    int students = 0;  ///< and teachers: who is disabled does not count
    int teachers = 0;
    bool operator==(const SchoolClass&) const = default;
};

/// A lesson that a class is to do.
struct ClassAssignment
{
    std::int64_t id = 0;  ///< given by the database
    ClassId classId;
    std::string lessonId;
    std::string dueUtc;    ///< "2026-11-27T23:00:00Z"; empty: none
    int attemptLimit = 0;  ///< 0: as many as one likes
    bool operator==(const ClassAssignment&) const = default;
};

/// What an import of a class list found, or did.
struct RosterFault
{
    enum class Kind {
        Fields,         ///< more than the head names
        Username,       ///< empty, too long, or with signs that it may not have
        Twice,          ///< stood in another line already, which is the value
        Name,           ///< of a person: too long, or with signs that cannot be seen
        Role,           ///< none that there is
        OtherRole,      ///< is something else here, which is the value
        Class,          ///< a name that no class can have
        NoUtf8,         ///< the file, from this sign of the line on, which is the value
        OpenQuote,      ///< begins at this sign of the line, which is the value, and is not closed
        AfterQuote,     ///< words stand behind a closing quote, at this sign
        NoSuchColumn,   ///< that a class list has; the value is the one that was perhaps meant, if any
        ColumnTwice,    ///< is named by the head again
        ColumnMissing,  ///< in the head
        Refused         ///< by the database
    };
    int line = 0;        ///< of the file, from 1
    std::string column;  ///< its name; empty: the whole line
    std::string what;    ///< in English
    Kind kind = Kind::Refused;
    std::string value = {};
};
struct RosterPerson
{
    std::string username;
    std::string fullName;
    Role role = Role::Student;
    std::vector<std::string> classes;  ///< that the list names
    bool isNew = false;
    std::string code;        ///< of a new one: it lets him in once, and is kept nowhere else
    std::string nameBefore;  ///< of who is known under another name so far; empty: it stays
    bool isShort = false;    ///< his line ends before all fields that the head names
    bool operator==(const RosterPerson&) const = default;
};
struct RosterOutcome
{
    std::vector<RosterFault> faults;  ///< any: nothing was entered
    std::vector<RosterPerson> people;
    std::vector<std::string> newClasses;  ///< that nobody had before
};

}  // namespace database
