// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/Permissions.h"

#include <algorithm>

namespace database {
namespace {

constexpr std::array<std::string_view, kRoles> kRoleNames{"guest", "student", "instructor", "admin"};

constexpr Reach kNone = Reach::Nothing;
constexpr Reach kOwn = Reach::Own;
constexpr Reach kClasses = Reach::Classes;
constexpr Reach kAll = Reach::All;

/// Columns: guest, student, instructor, admin. Rows: in the order of Operation. Admins do not grade.
constexpr std::array<std::array<Reach, kRoles>, kOperations> kTable{{
    {kNone, kOwn, kOwn, kOwn},          // ChangeOwnPassword
    {kNone, kNone, kClasses, kAll},     // ListPeople
    {kNone, kNone, kNone, kAll},        // AddPerson
    {kNone, kNone, kNone, kAll},        // ChangePerson
    {kNone, kNone, kNone, kAll},        // ResetPassword
    {kNone, kClasses, kClasses, kAll},  // ListClasses
    {kNone, kNone, kNone, kAll},        // ChangeClasses
    {kNone, kClasses, kClasses, kAll},  // ListAssignments
    {kNone, kNone, kClasses, kAll},     // Assign
    {kNone, kOwn, kOwn, kOwn},          // AddAttempt
    {kNone, kOwn, kClasses, kAll},      // ReadHistory
    {kNone, kOwn, kClasses, kAll},      // OpenAttempt
    {kNone, kOwn, kClasses, kAll},      // CompareWithClass
    {kNone, kNone, kClasses, kNone},    // Comment
    {kNone, kNone, kOwn, kNone},        // WithdrawComment
    {kNone, kNone, kClasses, kNone},    // Override
    {kNone, kNone, kClasses, kAll},     // CheckAttempt
    {kNone, kNone, kClasses, kAll},     // ReadClass
    {kNone, kNone, kClasses, kAll},     // ExportAttempts
    {kAll, kAll, kAll, kAll},           // ListPresets
    {kNone, kNone, kNone, kAll},        // AddPreset
    {kAll, kAll, kAll, kAll},           // ReadSettings
    {kNone, kNone, kNone, kAll},        // ChangeSettings
    {kNone, kOwn, kOwn, kOwn},          // ChangeOwnSettings
    {kNone, kNone, kNone, kAll},        // ReadAudit
    {kNone, kNone, kNone, kAll},        // KeepBackups
    {kNone, kNone, kNone, kAll},        // CopySchool
}};

}  // namespace

std::string_view roleName(Role role)
{
    return kRoleNames[static_cast<std::size_t>(role)];
}

std::optional<Role> roleOf(std::string_view name)
{
    const auto* const found = std::find(kRoleNames.begin(), kRoleNames.end(), name);
    if (found == kRoleNames.end())
        return {};
    return static_cast<Role>(found - kRoleNames.begin());
}

Reach reachOf(Operation operation, Role role)
{
    return kTable[static_cast<std::size_t>(operation)][static_cast<std::size_t>(role)];
}

}  // namespace database
