// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sql/Copy.h"

#include <array>

#include <QSqlError>
#include <QSqlQuery>

#include "database/sql/Audit.h"
#include "database/sql/Grants.h"
#include "database/sql/Migrations.h"
#include "database/sql/Recordings.h"
#include "database/sql/RowSum.h"
#include "database/sql/Statement.h"

namespace database::sql {
namespace {

using core::ErrorCode;

constexpr std::int64_t kToldEveryRows = 5000;

struct Table
{
    const char* name;
    bool hasIds;
};

/// Tables in the order of their references. Failed logins are not copied, and recordings are copied separately.
constexpr std::array kTables{
    Table{"people", true},           Table{"classes", true},     Table{"enrolments", false},
    Table{"lesson_versions", false}, Table{"assignments", true}, Table{"assigned_versions", false},
    Table{"settings", false},        Table{"attempts", true},    Table{"exam_starts", false},
    Table{"score_sheets", false},    Table{"standings", false},  Table{"comments", true},
    Table{"overrides", true},        Table{"presets", true},     Table{"audit", false}};

core::Status stopped()
{
    return core::unexpected(ErrorCode::FileUnwritable, "the copying was stopped; nothing was kept of it");
}

core::Status copyTable(const DatabaseContext& from, const DatabaseContext& to, const QString& table, RowSum& sum,
                       const CopyProgress& progress)
{
    const std::string doing = "copy the table " + table.toStdString();
    const QStringList columns = columnsOf(from.db, table);
    QSqlQuery insert(to.db);
    const QString places = QStringList(columns.size(), QStringLiteral("?")).join(u',');
    if (!insert.prepare(QStringLiteral("INSERT INTO %1 (%2) VALUES (%3)").arg(table, columns.join(u','), places)))
        return tl::unexpected(dialect::error(to.db, insert.lastError(), doing));
    auto rows = run(from.db, QStringLiteral("SELECT %1 FROM %2").arg(columns.join(u','), table), doing);
    if (!rows)
        return tl::unexpected(rows.error());
    while (rows->next()) {
        for (int k = 0; k < columns.size(); ++k)
            insert.bindValue(k, rows->isNull(k) ? QVariant() : rows->value(k));
        if (!insert.exec())
            return tl::unexpected(dialect::error(to.db, insert.lastError(), doing));
        sum.add(*rows, columns.size());
        if (progress && sum.rows() % kToldEveryRows == 0 && !progress(table, sum.rows()))
            return stopped();
    }
    if (rows->lastError().isValid())
        return tl::unexpected(dialect::error(from.db, rows->lastError(), doing));
    return {};
}

core::Status verifyTable(const DatabaseContext& to, const QString& table, const RowSum& expected)
{
    const auto sum = sumOf(to.db, table);
    if (!sum)
        return tl::unexpected(sum.error());
    if (*sum == expected)
        return {};
    return core::unexpected(ErrorCode::BadStructure, "the table " + table.toStdString() +
                                                         " did not arrive as it was sent; nothing was kept, try again");
}

core::Status copyRecordings(const DatabaseContext& from, const DatabaseContext& to, CopyReport& report,
                            const CopyProgress& progress)
{
    const auto hashes = recordingsNamed(from.db);
    if (!hashes)
        return tl::unexpected(hashes.error());
    for (const std::string& hash : *hashes) {
        const auto bytes = recordingOf(from.db, hash);
        // A missing recording does not stop the copy. The report has the number of missing recordings.
        if (!bytes && (bytes.error().code == ErrorCode::FileMissing || bytes.error().code == ErrorCode::BadStructure)) {
            ++report.recordingsMissing;
            continue;
        }
        if (!bytes)
            return tl::unexpected(bytes.error());
        if (auto put = putRecording(to, *bytes); !put)
            return tl::unexpected(put.error());
        if (const auto back = recordingOf(to.db, hash); !back)
            return tl::unexpected(back.error());
        ++report.recordings;
        if (progress && !progress(QStringLiteral("recordings"), report.recordings))
            return stopped();
    }
    return {};
}

core::Status copySeal(const DatabaseContext& from, const DatabaseContext& to)
{
    const std::string doing = "copy the head of the audit";
    auto seal = run(from.db, "SELECT seq, hash, signature, station_key FROM audit_seal", doing);
    if (!seal)
        return tl::unexpected(seal.error());
    if (!seal->next())
        return {};
    const QVariantList values{seal->value(0), seal->value(1), seal->value(2), seal->value(3)};
    return execute(to.db, "UPDATE audit_seal SET seq = ?, hash = ?, signature = ?, station_key = ? WHERE id = 1", doing,
                   values);
}

core::Status expectEmpty(const QSqlDatabase& to)
{
    const auto version = dialect::schemaVersion(to);
    if (!version)
        return tl::unexpected(version.error());
    if (*version == 0)
        return {};
    // Every change adds an audit row, so an empty audit means an empty database.
    const auto row = ask(to, QStringLiteral("SELECT 1 FROM audit LIMIT 1"), "look into it");
    if (!row)
        return tl::unexpected(row.error());
    if (row->isNull())
        return {};
    return core::unexpected(ErrorCode::OutOfRange,
                            "database " + dialect::nameOf(to) + ": it holds a school already; copy into an empty one");
}

/// Creates the schema inside the transaction of the copy. Another program that copies into the same database has to
/// wait, and then finds that it is not empty.
core::Status makeSchema(const QSqlDatabase& to)
{
    const auto steps = shippedMigrations();
    if (!steps)
        return tl::unexpected(steps.error());
    if (auto made = applyAll(to, *steps); !made)
        return made;
    if (dialect::isPostgres(to))
        // applyAll() limits pauses in the transaction, but the copy pauses while it reads the source.
        for (const char* sql :
             {"SET LOCAL idle_in_transaction_session_timeout = DEFAULT", "LOCK TABLE people IN EXCLUSIVE MODE"})
            if (auto done = execute(to, QLatin1String(sql), "make a schema"); !done)
                return done;
    return expectEmpty(to);
}

}  // namespace

core::Result<CopyReport> copySchool(const DatabaseContext& from, const Login& session, const DatabaseContext& to,
                                    const CopyProgress& progress)
{
    if (auto may = authorize(from, session, Operation::CopySchool); !may)
        return tl::unexpected(may.error());
    for (const QSqlDatabase& db : {from.db, to.db})
        if (auto owner = expectOwner(db, "cusp db copy"); !owner)
            return tl::unexpected(owner.error());
    if (auto empty = expectEmpty(to.db); !empty)
        return tl::unexpected(empty.error());
    // Recorded before the copy begins, so that the copy contains the row as well.
    if (auto noted =
            inTurn(from, "note the copying", [&] { return note(from, session.uid(), "school.copy", "school"); });
        !noted)
        return tl::unexpected(noted.error());
    CopyReport report;
    // Reads one consistent state, even if others write meanwhile.
    if (auto begun = execute(from.db, dialect::beginRead(from.db), "read it"); !begun)
        return tl::unexpected(begun.error());
    const auto bring = [&]() -> core::Status {
        if (auto made = makeSchema(to.db); !made)
            return made;
        for (const Table& table : kTables) {
            RowSum sum;
            const QString name = QLatin1String(table.name);
            if (progress && !progress(name, 0))
                return stopped();
            if (auto copied = copyTable(from, to, name, sum, progress); !copied)
                return copied;
            if (auto same = verifyTable(to, name, sum); !same)
                return same;
            if (table.hasIds)
                if (auto gone = dialect::continueIds(to.db, name); !gone)
                    return gone;
            report.rows += sum.rows();
        }
        if (auto copied = copyRecordings(from, to, report, progress); !copied)
            return copied;
        if (auto copied = copySeal(from, to); !copied)
            return copied;
        // Signs the audit of the copy with the key of this computer. This row also gives the copy its own identity, see
        // schoolOf().
        return note(to, session.uid(), "school.copied", "school");
    };
    const core::Status done = inTransaction(to.db, "copy the school", bring);
    static_cast<void>(execute(from.db, "ROLLBACK", "end reading it"));
    if (!done)
        return tl::unexpected(done.error());
    return report;
}

}  // namespace database::sql
