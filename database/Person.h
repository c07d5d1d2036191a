// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "database/Login.h"

namespace database {

/// The data of a new person.
struct NewPerson
{
    std::string username;  ///< letters a to z, digits, dot, hyphen, underscore, at; case is ignored
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
    std::string codeUntilUtc;  ///< until then a one-time code allows one login; empty: there is none
    std::string lastLoginUtc;  ///< empty: never
    std::vector<ClassId> classes;
    bool operator==(const Person&) const = default;

    [[nodiscard]] std::string fullName() const
    {
        return givenName + (givenName.empty() || familyName.empty() ? "" : " ") + familyName;
    }
    /// Returns the username that replaces the person's own when they are erased. Migration 10 contains it, too.
    [[nodiscard]] std::string pseudonym() const
    {
        constexpr std::size_t kDigits = 12;
        return "erased-" + uid.substr(0, kDigits);
    }
    /// Returns whether the person was erased: only the attempts are left, and the account cannot be used again.
    [[nodiscard]] bool isErased() const { return username == pseudonym(); }
};

/// The outcome of erasing a person.
struct ErasedPerson
{
    Person person;            ///< as they are now, with a pseudonym
    bool isFileClean = true;  ///< false: unused parts of the database file may still contain what was erased
};

/// A person who cannot log in by password yet, and the one-time code for their first login. Only a hash of the code is
/// stored, so show the code now.
struct Entered
{
    Person person;
    std::string code;
};

struct SchoolClass
{
    ClassId id;
    std::string name;
    int students = 0;  ///< students and teachers without disabled people
    int teachers = 0;
    bool operator==(const SchoolClass&) const = default;
};

/// A lesson that is assigned to a class.
struct ClassAssignment
{
    std::int64_t id = 0;  ///< assigned by the database
    ClassId classId;
    std::string lessonId;
    std::string dueUtc;           ///< "2026-11-27T23:00:00Z"; empty: no due date
    int attemptLimit = 0;         ///< 0: no limit
    std::string lessonHash = {};  ///< version for new attempts (lessons::Lesson::hash); empty: none was stored
    int lessonVersion = 0;        ///< its number, as stored; ignored by assign()
    bool operator==(const ClassAssignment&) const = default;
};

/// The largest number of lines of a class list, including the header.
inline constexpr std::size_t kMostRosterLines = 20'000;

/// A fault of a class list that an import found.
struct RosterFault
{
    enum class Kind {
        Fields,         ///< more than the header names
        Username,       ///< empty, too long, or with characters that are not allowed
        Twice,          ///< occurs in another line already, which is the value
        Name,           ///< of a person: too long, or with invisible characters
        Role,           ///< an unknown role
        OtherRole,      ///< differs from the person's role in the database, which is the value
        Erased,         ///< of a person who was erased
        Class,          ///< an invalid name of a class
        NoUtf8,         ///< not UTF-8 from this character of the line on, which is the value
        OpenQuote,      ///< a quote that begins at this character of the line, which is the value, is not closed
        AfterQuote,     ///< text follows a closing quote, at this character
        NoSuchColumn,   ///< not a column of a class list; the value is the column that may be meant, if any
        ColumnTwice,    ///< named twice in the header
        ColumnMissing,  ///< missing in the header
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
    std::vector<std::string> classes;  ///< in the list
    bool isNew = false;
    std::string code;        ///< of a new person: allows one login, and is stored nowhere in clear
    std::string nameBefore;  ///< name so far of a known person; empty: unchanged
    bool isShort = false;    ///< the line ends before all fields of the header
    bool operator==(const RosterPerson&) const = default;
};
struct RosterOutcome
{
    std::vector<RosterFault> faults;  ///< if there are any, no person was entered
    std::vector<RosterPerson> people;
    std::vector<std::string> newClasses;  ///< created by the list
};

}  // namespace database
