// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <QJsonObject>
#include <QSqlQuery>

#include "core/base/Result.h"
#include "database/AttemptRecord.h"
#include "database/AuditHead.h"
#include "database/IntegrityIssue.h"
#include "database/sql/DatabaseContext.h"
#include "database/sql/Statement.h"

/// The audit log records what was done, when and by whom. Each row contains the hash of the row before it, and the
/// station that wrote the newest row has signed it. Changing, removing, inserting or moving rows breaks the chain.
/// Cutting off its end invalidates the signed head; a printed report shows an older head to compare with. Before the
/// first row that a station signs, a row records the station's key.
namespace database::sql {

/// Returns the BLAKE2b-256 of the hash of the previous row and all fields of this row except its own hash, each with
/// its length.
[[nodiscard]] std::string hashOf(const AuditRow& row, const std::string& hashBefore);

/// Adds several rows inside one transaction, and signs the last.
class AuditBatch
{
public:
    /// @param school  must outlive the batch
    explicit AuditBatch(const DatabaseContext& school) : m_school(school) {}
    /// Adds a row, like note().
    [[nodiscard]] core::Status note(const std::string& actor, const std::string& action, const std::string& object,
                                    const QJsonObject& detail = {});
    /// Signs the last row. Does nothing if there are no rows.
    [[nodiscard]] core::Status seal();

private:
    [[nodiscard]] core::Status begin();

    const DatabaseContext& m_school;
    std::optional<QSqlQuery> m_insert;
    std::int64_t m_seq = 0;
    std::string m_hash;
};

/// Adds a row, inside the transaction of the change that it describes, so that both are committed or neither.
[[nodiscard]] core::Status note(const DatabaseContext& school, const std::string& actor, const std::string& action,
                                const std::string& object, const QJsonObject& detail = {});

/// Waits until no other transaction that adds audit rows is running. Call it inside a transaction before reading the
/// data that the transaction will change. On a server, two such transactions could otherwise both decide by the same
/// old state (two admins who disable each other), or deadlock. A file allows only one write at a time anyway.
[[nodiscard]] core::Status takeTurn(const DatabaseContext& school);

/// Runs a transaction that calls takeTurn() first.
/// @param work  returns a core::Result or core::Status
template <class Work>
auto inTurn(const DatabaseContext& school, const std::string& doing, Work work) -> decltype(work())
{
    return inTransaction(school.db, doing, [&]() -> decltype(work()) {
        if (auto turn = takeTurn(school); !turn)
            return tl::unexpected(turn.error());
        return work();
    });
}

using database::AuditHead;
using database::AuditRows;

[[nodiscard]] core::Result<AuditHead> auditHead(const QSqlDatabase& db);
[[nodiscard]] inline core::Result<AuditHead> auditHead(const DatabaseContext& school)
{
    return auditHead(school.db);
}
/// Returns whether an older copy has taken the place of this database: its audit does not have a row that this computer
/// has seen, and no backup was restored by Cusp since. Notes that in the audit.
/// @param seenUtc  when the row was seen
[[nodiscard]] core::Result<bool> isOlderThan(const DatabaseContext& school, const AuditHead& seen,
                                             const std::string& seenUtc);
/// Returns the newest of the selected rows, newest first, at most `limit`; if `beforeSeq` is not 0, only rows before
/// it. Admins.
[[nodiscard]] core::Result<std::vector<AuditRow>> readAudit(const DatabaseContext& school, const Login& session,
                                                            int limit, std::int64_t beforeSeq = 0,
                                                            AuditRows rows = AuditRows::All);

/// Verifies the chain from its first row to its signed head and stops at the first invalid row. Returns one finding
/// about that row. Returns none if the chain is valid or `progress` returned false. If others may write meanwhile, call
/// it in a transaction.
/// @param witnesses  audit codes of printed reports
/// @param progress  called with the number of rows checked
[[nodiscard]] core::Result<std::vector<IntegrityIssue>>
checkAudit(const QSqlDatabase& db, const std::vector<std::string>& witnesses,
           const std::function<bool(std::int64_t rows)>& progress = {});

}  // namespace database::sql
