// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sql/Export.h"

#include <array>
#include <cstdio>
#include <string>

#include <QSqlError>

#include "database/Csv.h"
#include "database/sql/Audit.h"
#include "database/sql/Statement.h"

namespace database::sql {
namespace {

/// score and passed are those that count: of the score that a teacher gave, otherwise of the automatic one. An attempt
/// in doubt (database/Doubt.h) counts only with a score that a teacher gave.
constexpr std::string_view kHead = "attempt,username,given_name,family_name,finished_utc,lesson,tooth,score,passed,"
                                   "given_score,expected,duration_s,mean_force_n,peak_force_n,device,method,grid,"
                                   "view_mode,seed,preset,preset_hash,rubric_hash,lesson_hash,program,state_hash,"
                                   "recording_hash,automatic_score,doubt\r\n";

/// Returns a number of tenths or thousandths as a decimal: 823 tenths are "82.3".
std::string decimal(qlonglong parts, int digits)
{
    std::array<char, 32> buffer{};
    const qlonglong one = digits == 1 ? 10 : 1000;
    const int size = std::snprintf(buffer.data(), buffer.size(), "%lld.%0*lld", parts / one, digits, parts % one);
    return {buffer.data(), static_cast<std::size_t>(size)};
}

void put(std::string& line, std::string_view field)
{
    if (!line.empty())
        line += ',';
    line += field;
}

}  // namespace

core::Result<std::int64_t> exportAttempts(const DatabaseContext& school, const Login& session,
                                          const std::function<bool(std::string_view line)>& write)
{
    const auto who = authorize(school, session, Operation::ExportAttempts);
    if (!who)
        return tl::unexpected(who.error());
    QString whose;
    QVariantList values;
    if (who->reach != Reach::All) {
        whose = QStringLiteral(" WHERE a.person_id IN %1").arg(classmates());
        values = {static_cast<qlonglong>(session.person().value)};
    }
    const std::string doing = "export the attempts";
    if (auto noted = inTurn(school, doing, [&] { return note(school, session.uid(), "attempts.export", "attempts"); });
        !noted)
        return tl::unexpected(noted.error());
    auto rows = run(
        school.db,
        "SELECT a.uid, COALESCE(p.username, ''), COALESCE(p.given_name, ''), COALESCE(p.family_name, ''), "
        "a.finished_utc, a.lesson_id, a.tooth, a.device, a.method, a.view_mode, a.seed, a.preset, "
        "a.preset_hash, a.rubric_hash, a.lesson_hash, a.program, a.state_hash, a.recording_hash, "
        "COALESCE(a.given_tenths, a.score_tenths), CASE WHEN a.given_tenths IS NULL THEN CASE WHEN a.doubt = '' "
        "THEN a.passed ELSE 0 END WHEN a.given_tenths >= a.pass_mark_tenths THEN 1 ELSE 0 END, a.given_tenths, "
        "a.expected_tenths, "
        "a.duration_ms, a.mean_force_mn, a.peak_force_mn, a.grid, a.score_tenths, a.doubt FROM attempts a LEFT JOIN "
        "people p ON p.id = a.person_id" +
            whose + " ORDER BY a.id",
        doing, values);
    if (!rows)
        return tl::unexpected(rows.error());
    const core::Error stopped{core::ErrorCode::FileUnwritable,
                              "the attempts could not all be written; make room on the disk and try again"};
    if (!write(kHead))
        return tl::unexpected(stopped);
    std::int64_t count = 0;
    std::string line;
    while (rows->next()) {
        line.clear();
        const auto words = [&](int column) { put(line, csvField(textOf(*rows, column))); };
        const auto tenths = [&](int column) {
            put(line, rows->isNull(column) ? std::string() : decimal(rows->value(column).toLongLong(), 1));
        };
        line = csvField(textOf(*rows, 0));
        for (int column = 1; column <= 6; ++column)
            words(column);
        tenths(18);
        put(line, rows->value(19).toInt() != 0 ? "yes" : "no");
        tenths(20);
        tenths(21);
        for (int column = 22; column <= 24; ++column)
            put(line, decimal(rows->value(column).toLongLong(), 3));
        words(7);
        words(8);
        put(line, std::to_string(rows->value(25).toInt()));
        for (int column = 9; column <= 17; ++column)
            words(column);
        tenths(26);
        words(27);
        line += "\r\n";
        if (!write(line))
            return tl::unexpected(stopped);
        ++count;
    }
    if (rows->lastError().isValid())
        return tl::unexpected(dialect::error(school.db, rows->lastError(), doing));
    return count;
}

core::Status noteClassExport(const DatabaseContext& school, const Login& session, ClassId ofClass)
{
    if (auto who = authorizeForClass(school, session, Operation::ReadClass, ofClass); !who)
        return tl::unexpected(who.error());
    return inTurn(school, "note the report of a class", [&] {
        return note(school, session.uid(), "class.export", "class:" + std::to_string(ofClass.value));
    });
}

}  // namespace database::sql
