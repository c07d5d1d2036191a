// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sql/Repositories.h"

#include <cassert>

#include "database/sql/Attempts.h"
#include "database/sql/Audit.h"
#include "database/sql/Backups.h"
#include "database/sql/Check.h"
#include "database/sql/Classes.h"
#include "database/sql/Dialect.h"
#include "database/sql/Doubts.h"
#include "database/sql/Erasing.h"
#include "database/sql/Export.h"
#include "database/sql/Feedback.h"
#include "database/sql/Overview.h"
#include "database/sql/People.h"
#include "database/sql/Presets.h"
#include "database/sql/Roster.h"
#include "database/sql/Settings.h"
#include "database/sql/StartedExams.h"
#include "database/sql/UserRepositories.h"

namespace database::sql {
namespace {

/// Base class of repositories over a connection.
template <class Interface>
class Over : public Interface
{
public:
    explicit Over(const DatabaseContext& school) : m_school(school) {}

protected:
    const DatabaseContext& m_school;
};

class SqlAttempts final : public Over<AttemptRepository>
{
public:
    using Over::Over;

    core::Result<std::vector<AttemptRecord>> history(const Login& who, PersonId person,
                                                     const HistoryQuery& query) const override
    {
        return sql::history(m_school, who, person, query);
    }
    core::Result<AttemptRecord> open(const Login& who, AttemptId id) const override
    {
        return openAttempt(m_school, who, id);
    }
    core::Result<QByteArray> recording(const Login& who, AttemptId id) const override
    {
        return openRecording(m_school, who, id);
    }
    core::Result<std::vector<ExamStart>> examsWithoutScore(const Login& who, PersonId person) const override
    {
        return sql::examsWithoutScore(m_school, who, person);
    }
    core::Result<std::vector<ExamStart>> examStarts(const Login& who, PersonId person,
                                                    const std::string& lessonId) const override
    {
        return sql::examStarts(m_school, who, person, lessonId);
    }
    core::Result<std::vector<AttemptId>> toCheck(const Login& who, int limit) const override
    {
        return attemptsToCheck(m_school, who, limit);
    }
    core::Status noteCheck(const Login& who, AttemptId id, Doubt found) override
    {
        return sql::noteCheck(m_school, who, id, found);
    }
    core::Result<std::vector<BandPoint>> classBand(const Login& who, PersonId person,
                                                   const std::string& lessonId) const override
    {
        return sql::classBand(m_school, who, person, lessonId);
    }
    core::Result<std::optional<LessonMedians>> classMedians(const Login& who, PersonId person,
                                                            const std::string& lessonId) const override
    {
        return sql::classMedians(m_school, who, person, lessonId);
    }
};

class SqlComments final : public Over<CommentRepository>
{
public:
    using Over::Over;

    core::Result<AttemptTalk> list(const Login& who, AttemptId id) const override
    {
        return readTalk(m_school, who, id);
    }
    core::Status add(const Login& who, AttemptId id, const NewComment& comment) override
    {
        return addComment(m_school, who, id, comment).map([](std::int64_t) {});
    }
    core::Status withdraw(const Login& who, std::int64_t comment) override
    {
        return withdrawComment(m_school, who, comment);
    }
    core::Status giveScore(const Login& who, AttemptId id, std::optional<int> tenths, const std::string& reason,
                           std::size_t before) override
    {
        return overrideScore(m_school, who, id, tenths, reason, before);
    }
    core::Result<std::vector<Feedback>> feedbackFor(const Login& who, PersonId person) const override
    {
        return sql::feedbackFor(m_school, who, person);
    }
    core::Status markSeen(const Login& who, const AttemptRecord& attempt) override
    {
        return seeFeedback(m_school, who, attempt);
    }
};

class SqlClasses final : public Over<ClassRepository>
{
public:
    using Over::Over;

    core::Result<std::vector<SchoolClass>> list(const Login& who) const override { return listClasses(m_school, who); }
    core::Status add(const Login& who, const std::string& name) override
    {
        return addClass(m_school, who, name).map([](ClassId) {});
    }
    core::Status rename(const Login& who, ClassId id, const std::string& name) override
    {
        return renameClass(m_school, who, id, name);
    }
    core::Result<ClassOverview> overview(const Login& who, ClassId id) const override
    {
        return classOverview(m_school, who, id);
    }
    core::Result<LessonResults> results(const Login& who, ClassId id, const std::string& lessonId) const override
    {
        return lessonResults(m_school, who, id, lessonId);
    }
    core::Result<std::vector<ClassAssignment>> assignments(const Login& who) const override
    {
        return listAssignments(m_school, who);
    }
    core::Status assign(const Login& who, const ClassAssignment& assignment,
                        const std::optional<ClassAssignment>& before, const QByteArray& pack) override
    {
        return sql::assign(m_school, who, assignment, before, pack);
    }
    core::Status unassign(const Login& who, const ClassAssignment& before) override
    {
        return sql::unassign(m_school, who, before);
    }
    core::Status noteExport(const Login& who, ClassId id) override { return noteClassExport(m_school, who, id); }
};

class SqlPeople final : public Over<PeopleRepository>
{
public:
    using Over::Over;

    core::Result<std::vector<Person>> list(const Login& who) const override { return listPeople(m_school, who); }
    core::Result<Entered> add(const Login& who, const NewPerson& person, const std::vector<ClassId>& classes) override
    {
        return addPerson(m_school, who, person, classes);
    }
    core::Result<Person> change(const Login& who, const Person& person, const Person& asItWas) override
    {
        return changePerson(m_school, who, person, asItWas);
    }
    core::Result<Entered> resetPassword(const Login& who, PersonId person) override
    {
        return sql::resetPassword(m_school, who, person);
    }
    core::Result<ErasedPerson> erase(const Login& who, PersonId person) override
    {
        return erasePerson(m_school, who, person);
    }
    core::Result<RosterOutcome> import(const Login& who, std::string_view csv, bool isDryRun,
                                       const RosterOutcome& asSeen) override
    {
        return importRoster(m_school, who, csv, isDryRun, &asSeen);
    }
};

class SqlPresets final : public Over<PresetRepository>
{
public:
    using Over::Over;

    core::Result<std::vector<KeptPreset>> list(const Login& who) const override { return listPresets(m_school, who); }
    core::Status add(const Login& who, const KeptPreset& preset) override { return addPreset(m_school, who, preset); }
};

class SqlSettings final : public Over<SettingsRepository>
{
public:
    using Over::Over;

    core::Result<SettingsMap> read(const Login& who) const override { return readSettings(m_school, who); }
    core::Result<ReplacedSetting> replace(const Login& who, const std::string& name, const std::string& value,
                                          const std::optional<std::string>& of) override
    {
        return replaceSetting(m_school, who, name, value, of);
    }
    core::Status changeOwn(const Login& who, const std::string& name, const std::string& value) override
    {
        return changeOwnSetting(m_school, who, name, value);
    }
};

class SqlAudit final : public Over<AuditRepository>
{
public:
    using Over::Over;

    core::Result<std::vector<AuditRow>> read(const Login& who, int limit, std::int64_t beforeSeq,
                                             AuditRows rows) const override
    {
        return readAudit(m_school, who, limit, beforeSeq, rows);
    }
    core::Result<AuditHead> head() const override { return auditHead(m_school); }
};

class SqlMaintenance final : public Over<MaintenanceRepository>
{
public:
    using Over::Over;

    core::Result<QString> backUp(const Login& who, const QString& folder, const QDateTime& nowUtc,
                                 const GoesOn& goesOn) override
    {
        if (auto may = authorize(m_school, who, Operation::KeepBackups); !may)
            return tl::unexpected(may.error());
        auto made = sql::backUp(m_school.db, folder, nowUtc, goesOn);
        if (!made)
            return made;
        removeOldBackups(m_school.db, folder);
        if (auto noted = noteBackup(m_school, who, *made); !noted)
            return tl::unexpected(noted.error());
        return made;
    }
    core::Result<CheckReport> check(const Login& who, const std::vector<std::string>& witnesses,
                                    const GoesOn& goesOn) const override
    {
        if (auto may = authorize(m_school, who, Operation::KeepBackups); !may)
            return tl::unexpected(may.error());
        // Several stations write to a server, but only one to a file.
        const std::string onlyStation = dialect::isPostgres(m_school.db) ? std::string() : m_school.key.publicHex();
        return checkDatabase(
            m_school.db, witnesses, [&goesOn](const char*, std::int64_t) { return !goesOn || goesOn(); }, onlyStation);
    }
};

}  // namespace

void withRepositories(const DatabaseContext& school, const std::function<void(const Repositories&)>& use)
{
    assert(use);
    SqlAttempts attempts(school);
    SqlComments comments(school);
    SqlClasses classes(school);
    SqlPeople people(school);
    SqlPresets presets(school);
    SqlSettings settings(school);
    SqlAudit audit(school);
    SqlMaintenance maintenance(school);
    const std::unique_ptr<LessonRepository> lessons = lessonRepository(school);
    const std::unique_ptr<LoginRepository> logins = loginRepository(school);
    use({attempts, comments, classes, people, presets, settings, audit, maintenance, *lessons, *logins, school.key});
}

}  // namespace database::sql
