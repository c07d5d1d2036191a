// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace database {

/// What a person is here. A guest has no account; nothing of his is kept.
enum class Role : std::uint8_t { Guest, Student, Instructor, Admin };
inline constexpr std::size_t kRoles = 4;

/// "guest", "student", "instructor", "admin": as in files and in the database.
[[nodiscard]] std::string_view roleName(Role role);
[[nodiscard]] std::optional<Role> roleOf(std::string_view name);

/// Everything that can be asked of the school's data. Each is one function of database/sql, which takes the session
/// and looks here first.
enum class Operation : std::uint8_t {
    ChangeOwnPassword,
    ListPeople,
    AddPerson,
    ChangePerson,  ///< names, role, whether disabled
    ResetPassword,
    ListClasses,
    ChangeClasses,  ///< add and rename them, and who belongs to them
    ListAssignments,
    Assign,
    AddAttempt,   ///< into the outbox, and so into the database; also that an exam has begun
    ReadHistory,  ///< lists of somebody's attempts
    OpenAttempt,  ///< its score sheet and recording
    CompareWithClass,
    Comment,
    WithdrawComment,
    Override,
    ReadClass,  ///< the overview of a class
    ExportAttempts,
    ListPresets,
    AddPreset,
    ReadSettings,
    ChangeSettings,     ///< the school's
    ChangeOwnSettings,  ///< one's own
    ReadAudit,
    KeepBackups,  ///< make and try them, and check everything
    CopySchool,   ///< into another database
};
inline constexpr std::size_t kOperations = static_cast<std::size_t>(Operation::CopySchool) + 1;

/// To whose data an operation reaches.
enum class Reach : std::uint8_t {
    Nothing,
    Own,
    Classes,  ///< those of the classes one is enrolled in
    All
};

/// The table of what is allowed.
[[nodiscard]] Reach reachOf(Operation operation, Role role);

}  // namespace database
