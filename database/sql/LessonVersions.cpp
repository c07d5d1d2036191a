// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sql/LessonVersions.h"

#include "database/sql/Statement.h"
#include "lessons/LessonVersion.h"

namespace database::sql {
namespace {

using core::ErrorCode;

const std::string kKeepVersion = "keep the lesson";
const std::string kReadVersion = "read the assigned lesson";

}  // namespace

core::Status putVersion(const DatabaseContext& school, const std::string& lessonId, const std::string& hash,
                        const QByteArray& pack)
{
    const auto there =
        ask(school.db, "SELECT lesson_id FROM lesson_versions WHERE hash = ?", kKeepVersion, {text(hash)});
    if (!there)
        return tl::unexpected(there.error());
    if (!there->isNull() && there->toString().toStdString() == lessonId)
        return {};
    const auto version = lessons::versionIn(pack);
    if (!version && !pack.isEmpty())
        return tl::unexpected(version.error());
    if (!version || version->hash != hash || version->id != lessonId)
        return core::unexpected(ErrorCode::OutOfRange,
                                "the lesson has changed meanwhile; open the page again and assign it again");
    return execute(school.db, "INSERT INTO lesson_versions (hash, lesson_id, version, pack) VALUES (?, ?, ?, ?)",
                   kKeepVersion, {text(hash), text(lessonId), version->version, pack});
}

core::Result<QByteArray> versionPack(const DatabaseContext& school, const Login& session, const std::string& hash)
{
    const auto who = authorize(school, session, Operation::ListAssignments);
    if (!who)
        return tl::unexpected(who.error());
    QString whose;
    QVariantList values{text(hash)};
    if (who->reach != Reach::All) {
        whose = QStringLiteral(" AND EXISTS (SELECT 1 FROM assigned_versions v JOIN enrolments e ON e.class_id = "
                               "v.class_id WHERE v.lesson_hash = l.hash AND e.person_id = ?)");
        values += number(session.person().value);
    }
    const auto pack =
        ask(school.db, "SELECT l.pack FROM lesson_versions l WHERE l.hash = ?" + whose, kReadVersion, values);
    if (!pack)
        return tl::unexpected(pack.error());
    if (pack->isNull())
        return core::unexpected(ErrorCode::UnknownName, "this version of the lesson was not assigned to your classes");
    return pack->toByteArray();
}

core::Status checkVersions(const QSqlDatabase& db, const std::function<void(const IntegrityIssue&)>& say)
{
    return forEach(db, "SELECT hash, lesson_id, version, pack FROM lesson_versions", kReadVersion, {},
                   [&](const QSqlQuery& row) {
                       const auto found = lessons::versionIn(row.value(3).toByteArray());
                       const lessons::LessonVersion named{textOf(row, 1), row.value(2).toInt(), textOf(row, 0)};
                       if (!found || *found != named)
                           say({QT_TRANSLATE_NOOP("Finding", "version %1 of the lesson %2 was changed or is damaged; "
                                                             "assign the lesson again"),
                                {std::to_string(named.version), named.id}});
                   });
}

}  // namespace database::sql
