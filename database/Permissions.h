// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace database {

/// The role of a person. A guest has no account and no stored data.
enum class Role : std::uint8_t { Guest, Student, Instructor, Admin };
inline constexpr std::size_t kRoles = 4;

/// Returns "guest", "student", "instructor" or "admin", as in files and in the database.
[[nodiscard]] std::string_view roleName(Role role);
[[nodiscard]] std::optional<Role> roleOf(std::string_view name);

/// All operations on the school's data. Each is one function of database/sql, which checks its permission here first.
enum class Operation : std::uint8_t {
    ChangeOwnPassword,
    ListPeople,
    AddPerson,
    ChangePerson,  ///< names, role, whether disabled; also erase a person
    ResetPassword,
    ListClasses,
    ChangeClasses,  ///< add and rename them, and change their members
    ListAssignments,
    Assign,
    AddAttempt,   ///< through the outbox; also the start of an exam
    ReadHistory,  ///< lists of a person's attempts
    OpenAttempt,  ///< its score sheet and recording
    CompareWithClass,
    Comment,
    WithdrawComment,
    Override,
    CheckAttempt,  ///< mark its recording again, and note whether the score is what the station reported
    ReadClass,     ///< the overview of a class
    ExportAttempts,
    ListPresets,
    AddPreset,
    ReadSettings,
    ChangeSettings,     ///< of the school
    ChangeOwnSettings,  ///< of the user
    ReadAudit,
    KeepBackups,  ///< create and verify them, and check the database
    CopySchool,   ///< to another database
};
inline constexpr std::size_t kOperations = static_cast<std::size_t>(Operation::CopySchool) + 1;

/// The data that an operation may access.
enum class Reach : std::uint8_t {
    Nothing,
    Own,
    Classes,  ///< of the classes that the person is enrolled in
    All
};

/// Returns the access that a role has for an operation, from the table of permissions.
[[nodiscard]] Reach reachOf(Operation operation, Role role);

}  // namespace database
