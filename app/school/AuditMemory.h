// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include <QString>

#include "database/AuditHead.h"

namespace app {

/// Remembers the newest row of the audit that this account has seen of each school, in a file of the account's settings
/// and not beside the database: an older copy in the place of a database does not have that row. Any thread.
class AuditMemory
{
public:
    /// @param file  for tests
    explicit AuditMemory(QString file = defaultFile()) : m_file(std::move(file)) {}

    /// The newest row, and when it was seen.
    struct Seen
    {
        database::AuditHead head;
        std::string atUtc;
    };
    /// @param school  letters, digits and '-': identity of the school (database::sql::schoolOf()) and its place
    [[nodiscard]] std::optional<Seen> of(const std::string& school) const;
    void remember(const std::string& school, const database::AuditHead& head, const std::string& nowUtc) const;
    /// Forgets a school: a backup takes its place.
    void forget(const std::string& school) const;

    [[nodiscard]] static QString defaultFile();

private:
    QString m_file;
};

}  // namespace app
