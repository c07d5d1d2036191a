// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sql/DatabaseContext.h"

#include <ctime>

#include "database/sql/Logins.h"
#include "database/sql/Statement.h"

namespace database::sql {
namespace {

core::Error notAllowed(const std::string& why)
{
    return {core::ErrorCode::NotAllowed, why};
}

/// Looks up a user's present role, and whether the user is disabled. A station's connection then acts for the user, see
/// Logins::tokenOf().
core::Result<QSqlQuery> lookUp(const DatabaseContext& school, const Login& session)
{
    const std::string doing = "see whether that is allowed";
    const QVariantList values{number(session.person().value), text(session.uid())};
    if (dialect::isStation(school.db))
        return run(school.db, "SELECT role, disabled FROM cusp_resume(?) WHERE id = ? AND uid = ?", doing,
                   QVariantList{text(Logins::tokenOf(session))} + values);
    return session.isGuest()
               ? core::Result<QSqlQuery>(QSqlQuery(school.db))
               : run(school.db, "SELECT role, disabled FROM people WHERE id = ? AND uid = ?", doing, values);
}

core::Status within(const DatabaseContext& school, const QString& question, const QVariantList& values)
{
    const auto found = ask(school.db, question, "see whether that is allowed", values);
    if (!found)
        return tl::unexpected(found.error());
    if (found->isNull())
        return tl::unexpected(
            notAllowed("that belongs to a class which is not one of yours; ask an admin to enrol you"));
    return {};
}

/// Fails if a teacher would grade their own attempt, or override the score of a person who is no student.
core::Status expectToMark(const DatabaseContext& school, const Login& session, Operation operation, PersonId owner)
{
    if (operation != Operation::Comment && operation != Operation::Override)
        return {};
    if (owner == session.person())
        return tl::unexpected(notAllowed("that is your own work; let another teacher mark it"));
    if (operation == Operation::Comment)
        return {};
    const auto student = ask(school.db, "SELECT 1 FROM people WHERE id = ? AND role = 'student'",
                             "see whether that is allowed", {number(owner.value)});
    if (!student)
        return tl::unexpected(student.error());
    if (student->isNull())
        return tl::unexpected(notAllowed("that is not a student's work; another score is given to students only"));
    return {};
}

/// Returns the time since boot. It includes time in standby, and no user can set it.
qint64 msSinceBoot()
{
    timespec since{};
    clock_gettime(CLOCK_BOOTTIME, &since);
    return static_cast<qint64>(since.tv_sec) * 1000 + since.tv_nsec / 1'000'000;
}

}  // namespace

std::string DatabaseContext::now() const
{
    return nowUtc().toString(Qt::ISODate).toStdString();
}

std::function<QDateTime()> clockOf(const QSqlDatabase& db)
{
    if (dialect::isPostgres(db))
        if (const auto there = ask(db, "SELECT CAST(extract(epoch FROM clock_timestamp()) * 1000 AS BIGINT)",
                                   "ask what time it is there");
            there)
            return [atBoot = there->toLongLong() - msSinceBoot()] {
                return QDateTime::fromMSecsSinceEpoch(atBoot + msSinceBoot(), Qt::UTC);
            };
    return &QDateTime::currentDateTimeUtc;
}

core::Status checkClock(const QDateTime& nowUtc)
{
    constexpr int kLastYear = 9999;  // the largest with four digits
    const int year = nowUtc.date().year();
    if (year >= 1 && year <= kLastYear)
        return {};
    return core::unexpected(core::ErrorCode::OutOfRange, "the computer's clock is wrong, it shows the year " +
                                                             std::to_string(year) + "; set it and try again");
}

core::Result<AuthorizedUser> authorize(const DatabaseContext& school, const Login& session, Operation operation)
{
    AuthorizedUser who;
    auto row = lookUp(school, session);
    if (!row)
        return tl::unexpected(row.error());
    if (!session.isGuest()) {
        // People are never deleted, so the database at this location is another one now.
        if (!row->next())
            return core::unexpected(core::ErrorCode::OtherSchool, "this school does not know who asks; log in again");
        if (row->value(1).toInt() != 0)
            return core::unexpected(core::ErrorCode::Disabled, "this account has been disabled; ask an admin");
        who.role = roleOf(textOf(*row, 0)).value_or(Role::Guest);
    }
    who.reach = reachOf(operation, who.role);
    if (who.reach == Reach::Nothing)
        return tl::unexpected(notAllowed(session.isGuest()
                                             ? std::string("that needs a login; log in first")
                                             : (who.role == Role::Student ? "a " : "an ") +
                                                   std::string(roleName(who.role)) + " may not do that; ask an admin"));
    return who;
}

core::Result<AuthorizedUser> authorizeFor(const DatabaseContext& school, const Login& session, Operation operation,
                                          PersonId owner)
{
    auto who = authorize(school, session, operation);
    if (!who)
        return who;
    if (auto may = expectToMark(school, session, operation, owner); !may)
        return tl::unexpected(may.error());
    if (who->reach == Reach::All || owner == session.person())
        return who;
    if (who->reach == Reach::Own)
        return tl::unexpected(notAllowed("that belongs to somebody else"));
    const qlonglong me = session.person().value;
    const qlonglong other = owner.value;
    if (auto fit = within(school,
                          "SELECT 1 FROM enrolments mine JOIN enrolments theirs ON mine.class_id = theirs.class_id "
                          "WHERE mine.person_id = ? AND theirs.person_id = ? LIMIT 1",
                          {me, other});
        !fit)
        return tl::unexpected(fit.error());
    return who;
}

core::Result<AuthorizedUser> authorizeForClass(const DatabaseContext& school, const Login& session, Operation operation,
                                               ClassId ofClass)
{
    auto who = authorize(school, session, operation);
    if (!who || who->reach == Reach::All)
        return who;
    const qlonglong me = session.person().value;
    const qlonglong there = ofClass.value;
    if (auto fit = within(school, "SELECT 1 FROM enrolments WHERE person_id = ? AND class_id = ?", {me, there}); !fit)
        return tl::unexpected(fit.error());
    return who;
}

QString personByUid(const QSqlDatabase& db)
{
    return dialect::isStation(db) ? QStringLiteral("SELECT cusp_person_of(?)")
                                  : QStringLiteral("SELECT id FROM people WHERE uid = ?");
}

QString classmates()
{
    return QStringLiteral("(SELECT theirs.person_id FROM enrolments mine JOIN enrolments theirs ON mine.class_id = "
                          "theirs.class_id WHERE mine.person_id = ?)");
}

}  // namespace database::sql
