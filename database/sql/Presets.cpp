// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sql/Presets.h"

#include "database/sql/Audit.h"
#include "database/sql/Statement.h"

namespace database::sql {

core::Result<std::vector<KeptPreset>> listPresets(const DatabaseContext& school, const Login& session)
{
    if (auto who = authorize(school, session, Operation::ListPresets); !who)
        return tl::unexpected(who.error());
    std::vector<KeptPreset> presets;
    if (auto read =
            forEach(school.db, "SELECT name, version, hash, json FROM presets ORDER BY name, version DESC",
                    "list the presets", {},
                    [&](const QSqlQuery& row) {
                        presets.push_back({textOf(row, 0), row.value(1).toInt(), textOf(row, 2), textOf(row, 3)});
                    });
        !read)
        return tl::unexpected(read.error());
    return presets;
}

core::Status addPreset(const DatabaseContext& school, const Login& session, const KeptPreset& preset)
{
    if (auto who = authorize(school, session, Operation::AddPreset); !who)
        return tl::unexpected(who.error());
    const std::string doing = "keep the preset";
    return inTurn(school, doing, [&]() -> core::Status {
        const auto there = ask(school.db, "SELECT hash FROM presets WHERE name = ? AND version = ?", doing,
                               {text(preset.name), preset.version});
        if (!there)
            return tl::unexpected(there.error());
        if (!there->isNull()) {
            if (there->toString().toStdString() == preset.hash)
                return {};
            return core::unexpected(core::ErrorCode::OutOfRange,
                                    "there is a version " + std::to_string(preset.version) + " of \"" + preset.name +
                                        "\" already, with other values; keep this one as the next version");
        }
        if (auto added = execute(school.db,
                                 "INSERT INTO presets (name, version, hash, json, author_id, created_utc) VALUES "
                                 "(?, ?, ?, ?, ?, ?)",
                                 doing,
                                 {text(preset.name), preset.version, text(preset.hash), text(preset.json),
                                  static_cast<qlonglong>(session.person().value), text(school.now())});
            !added)
            return added;
        return note(school, session.uid(), "preset.add",
                    "preset:" + preset.name + " v" + std::to_string(preset.version),
                    {{"hash", QString::fromStdString(preset.hash)}});
    });
}

}  // namespace database::sql
