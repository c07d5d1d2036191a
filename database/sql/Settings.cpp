// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sql/Settings.h"

#include <QJsonObject>

#include "database/Passwords.h"
#include "database/sql/Audit.h"
#include "database/sql/Statement.h"

namespace database::sql {
namespace {

const std::string kKeep = "keep the setting";
constexpr qsizetype kLongestValue = 16'000;
/// SQL pattern of the settings for logins, which are never returned.
const QString kSecret = QStringLiteral("password.%");

core::Status refuseSecret(const std::string& name)
{
    if (name.rfind("password.", 0) != 0)
        return {};
    return core::unexpected(core::ErrorCode::NotAllowed, "the setting \"" + name + "\" is Cusp's own");
}

core::Status checkLength(const std::string& name, const std::string& value)
{
    if (QString::fromStdString(value).toUcs4().size() <= kLongestValue)
        return {};
    return core::unexpected(core::ErrorCode::OutOfRange, "the setting \"" + name + "\" has more than " +
                                                             std::to_string(kLongestValue) + " characters; shorten it");
}

/// @param owner  uid; empty: the school
core::Status put(const DatabaseContext& school, const std::string& owner, const std::string& name,
                 const std::string& value)
{
    return execute(school.db,
                   "INSERT INTO settings (owner, name, value) VALUES (?, ?, ?) "
                   "ON CONFLICT (owner, name) DO UPDATE SET value = excluded.value",
                   kKeep, {text(owner), text(name), text(value)});
}

}  // namespace

core::Result<SettingsMap> readSettings(const DatabaseContext& school, const Login& session)
{
    if (auto who = authorize(school, session, Operation::ReadSettings); !who)
        return tl::unexpected(who.error());
    SettingsMap settings;
    // The rows of the school come last, so that they replace the user's.
    if (auto read = forEach(school.db,
                            "SELECT name, value FROM settings WHERE (owner = '' OR owner = ?) AND name NOT LIKE ? "
                            "ORDER BY owner DESC",
                            "read the settings", {text(session.uid()), kSecret},
                            [&](const QSqlQuery& row) { settings[textOf(row, 0)] = textOf(row, 1); });
        !read)
        return tl::unexpected(read.error());
    return settings;
}

core::Status putSetting(const DatabaseContext& school, const std::string& actor, const std::string& name,
                        const std::string& value)
{
    if (auto kept = put(school, "", name, value); !kept)
        return kept;
    // The audit gets only a digest of the secret settings of logins.
    const QJsonObject detail = refuseSecret(name) ? QJsonObject{{"value", QString::fromStdString(value)}}
                                                  : QJsonObject{{"digest", QString::fromStdString(digestOf(value))}};
    return note(school, actor, "setting.change", "setting:" + name, detail);
}

core::Status changeSetting(const DatabaseContext& school, const Login& session, const std::string& name,
                           const std::string& value)
{
    const auto replaced = replaceSetting(school, session, name, value);
    return replaced ? core::Status() : tl::unexpected(replaced.error());
}

core::Result<ReplacedSetting> replaceSetting(const DatabaseContext& school, const Login& session,
                                             const std::string& name, const std::string& value,
                                             const std::optional<std::string>& of)
{
    if (auto who = authorize(school, session, Operation::ChangeSettings); !who)
        return tl::unexpected(who.error());
    if (auto fit = refuseSecret(name); !fit)
        return tl::unexpected(fit.error());
    if (auto fit = checkLength(name, value); !fit)
        return tl::unexpected(fit.error());
    ReplacedSetting replaced;
    const core::Status kept = inTurn(school, kKeep, [&]() -> core::Status {
        const auto before =
            ask(school.db, "SELECT value FROM settings WHERE owner = '' AND name = ?", kKeep, {text(name)});
        if (!before)
            return tl::unexpected(before.error());
        replaced = {true, before->toString().toStdString()};
        if (!before->isNull() && replaced.before == value)
            return {};  // nothing was changed, so the audit gets no row
        if (of && replaced.before != *of) {
            replaced.isDone = false;
            return {};
        }
        return putSetting(school, session.uid(), name, value);
    });
    if (!kept)
        return tl::unexpected(kept.error());
    return replaced;
}

core::Status changeOwnSetting(const DatabaseContext& school, const Login& session, const std::string& name,
                              const std::string& value)
{
    if (auto who = authorize(school, session, Operation::ChangeOwnSettings); !who)
        return tl::unexpected(who.error());
    if (auto fit = refuseSecret(name); !fit)
        return fit;
    if (auto fit = checkLength(name, value); !fit)
        return fit;
    return inTransaction(school.db, kKeep, [&] { return put(school, session.uid(), name, value); });
}

}  // namespace database::sql
