// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sql/Settings.h"

#include "database/sql/Audit.h"
#include "database/sql/Statement.h"

namespace database::sql {
namespace {

const std::string kKeep = "keep the setting";
/// What belongs to logins is told to nobody.
const QString kSecret = QStringLiteral("password.%");

core::Status refuseSecret(const std::string& name)
{
    if (name.rfind("password.", 0) != 0)
        return {};
    return core::unexpected(core::ErrorCode::NotAllowed, "the setting \"" + name + "\" is Cusp's own");
}

}  // namespace

core::Result<SettingsMap> readSettings(const School& school, const Session& session)
{
    if (auto who = admit(school, session, Operation::ReadSettings); !who)
        return tl::unexpected(who.error());
    SettingsMap settings;
    // The school's come first, and one's own replace them.
    if (auto read = forEach(school.db,
                            "SELECT name, value FROM settings WHERE (owner = '' OR owner = ?) AND name NOT LIKE ? "
                            "ORDER BY owner",
                            "read the settings", {text(session.uid()), kSecret},
                            [&](const QSqlQuery& row) { settings[textOf(row, 0)] = textOf(row, 1); });
        !read)
        return tl::unexpected(read.error());
    return settings;
}

core::Status putSetting(const School& school, const std::string& owner, const std::string& name,
                        const std::string& value)
{
    return execute(school.db,
                   "INSERT INTO settings (owner, name, value) VALUES (?, ?, ?) "
                   "ON CONFLICT (owner, name) DO UPDATE SET value = excluded.value",
                   kKeep, {text(owner), text(name), text(value)});
}

core::Status changeSetting(const School& school, const Session& session, const std::string& name,
                           const std::string& value)
{
    if (auto who = admit(school, session, Operation::ChangeSettings); !who)
        return tl::unexpected(who.error());
    if (auto fit = refuseSecret(name); !fit)
        return fit;
    return inTurn(school, kKeep, [&]() -> core::Status {
        const auto before =
            ask(school.db, "SELECT value FROM settings WHERE owner = '' AND name = ?", kKeep, {text(name)});
        if (!before)
            return tl::unexpected(before.error());
        if (!before->isNull() && before->toString().toStdString() == value)
            return {};  // nothing was changed, and nothing is noted
        if (auto kept = putSetting(school, "", name, value); !kept)
            return kept;
        return note(school, session.uid(), "setting.change", "setting:" + name,
                    {{"value", QString::fromStdString(value)}});
    });
}

core::Status changeOwnSetting(const School& school, const Session& session, const std::string& name,
                              const std::string& value)
{
    if (auto who = admit(school, session, Operation::ChangeOwnSettings); !who)
        return tl::unexpected(who.error());
    if (auto fit = refuseSecret(name); !fit)
        return fit;
    return inTransaction(school.db, kKeep, [&] { return putSetting(school, session.uid(), name, value); });
}

}  // namespace database::sql
