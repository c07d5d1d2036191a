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
#include "database/IntegrityIssue.h"
#include "database/sql/DatabaseContext.h"
#include "database/sql/Statement.h"

/// What was done here and by whom. Each row holds the hash of the row before it; the newest row is signed by the
/// station that wrote it. Changing, removing, inserting or moving rows breaks the chain there; cutting off its end
/// breaks the signed head, and a printed report shows an older head to compare with. Each station is noted before the
/// first row that it signs.
namespace database::sql {

/// BLAKE2b-256 over the hash of the row before and all of this row but its hash, each part with its length.
[[nodiscard]] std::string hashOf(const AuditRow& row, const std::string& hashBefore);

/// Adds rows inside one transaction, and signs the last: for many at once.
class AuditBatch
{
public:
    /// @param school  outlives the batch
    explicit AuditBatch(const DatabaseContext& school) : m_school(school) {}
    /// As note().
    [[nodiscard]] core::Status note(const std::string& actor, const std::string& action, const std::string& object,
                                    const QJsonObject& detail = {});
    /// Does nothing where nothing was noted.
    [[nodiscard]] core::Status seal();

private:
    [[nodiscard]] core::Status begin();

    const DatabaseContext& m_school;
    std::optional<QSqlQuery> m_insert;
    std::int64_t m_seq = 0;
    std::string m_hash;
};

/// Adds a row, inside the transaction of what it tells of: they are kept together or not at all.
[[nodiscard]] core::Status note(const DatabaseContext& school, const std::string& actor, const std::string& action,
                                const std::string& object, const QJsonObject& detail = {});

/// Inside a transaction, before it reads what it will change: waits until no other one that notes something goes on. On
/// a server two of them would otherwise each decide by what was there before the other (two admins who disable each
/// other), or wait for each other for ever. A file lets one write at a time anyway.
[[nodiscard]] core::Status takeTurn(const DatabaseContext& school);

/// A transaction that takes its turn first.
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

/// Number and hash of the newest row; 0 and empty where nothing was noted.
struct AuditHead
{
    std::int64_t seq = 0;
    std::string hash;
    bool operator==(const AuditHead&) const = default;

    /// As reports show it: "412-9f3ac07be1d2", which `cusp db check --witness` takes.
    [[nodiscard]] std::string code() const;
};
[[nodiscard]] core::Result<AuditHead> auditHead(const QSqlDatabase& db);
[[nodiscard]] inline core::Result<AuditHead> auditHead(const DatabaseContext& school)
{
    return auditHead(school.db);
}
/// Whether somebody has typed such a code: small or capital letters, and as much of the hash as he likes beyond what is
/// shown.
[[nodiscard]] bool isAuditCode(const std::string& typed);

/// Of a school that practises nearly every row tells of an attempt that was begun or kept.
enum class AuditRows { All, WithoutAttempts };

/// The newest rows of these, newest first, at most `limit`, those before row `beforeSeq` if that is not 0. Admins.
[[nodiscard]] core::Result<std::vector<AuditRow>> readAudit(const DatabaseContext& school, const Login& session,
                                                            int limit, std::int64_t beforeSeq = 0,
                                                            AuditRows rows = AuditRows::All);

/// Follows the chain from its first row to its signed head and stops at the first row that does not hold: one finding.
/// Empty: the chain is sound, or `progress` returned false. Where others write meanwhile, call it in a transaction.
/// @param witnesses  audit codes of printed reports
/// @param progress  number of the row that was looked at
[[nodiscard]] core::Result<std::vector<IntegrityIssue>>
checkAudit(const QSqlDatabase& db, const std::vector<std::string>& witnesses,
           const std::function<bool(std::int64_t rows)>& progress = {});

}  // namespace database::sql
