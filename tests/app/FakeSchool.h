// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <QByteArray>
#include <QDateTime>
#include <QString>

#include "app/school/SchoolAccess.h"
#include "core/base/Result.h"
#include "database/Repositories.h"

/// A school in memory, for tests of controllers. It checks no permissions: a test sets `refusal` for that.
namespace support {

/// The base of all fake repositories.
struct Fake
{
    std::optional<core::Error> refusal;  ///< if set, every call returns it

    template <class T>
    [[nodiscard]] core::Result<T> orRefusal(T value) const
    {
        if (refusal)
            return tl::unexpected(*refusal);
        return value;
    }
    [[nodiscard]] core::Status done() const { return refusal ? tl::unexpected(*refusal) : core::Status(); }
};

inline tl::unexpected<core::Error> unknown()
{
    return core::unexpected(core::ErrorCode::UnknownName, "it does not exist");
}

struct FakeAttempts final : database::AttemptRepository, Fake
{
    std::vector<database::AttemptRecord> all;  ///< newest first
    std::map<std::int64_t, QByteArray> recordings;
    std::vector<database::ExamStart> exams;
    std::vector<database::BandPoint> band;
    std::optional<database::LessonMedians> medians;

    core::Result<std::vector<database::AttemptRecord>> history(const database::Login&, database::PersonId person,
                                                               const database::HistoryQuery& query) const override
    {
        std::vector<database::AttemptRecord> found;
        for (const auto& one : all)
            if (one.person == person && (query.lessonId.empty() || one.lessonId == query.lessonId) &&
                (query.tooth.empty() || (one.lessonId.empty() && one.tooth == query.tooth)))
                found.push_back(one);
        if (query.limit > 0 && found.size() > static_cast<std::size_t>(query.limit))
            found.resize(static_cast<std::size_t>(query.limit));
        return orRefusal(found);
    }
    core::Result<database::AttemptRecord> open(const database::Login&, database::AttemptId id) const override
    {
        for (const auto& one : all)
            if (one.id == id.value)
                return orRefusal(one);
        return unknown();
    }
    core::Result<QByteArray> recording(const database::Login&, database::AttemptId id) const override
    {
        const auto found = recordings.find(id.value);
        if (found == recordings.end())
            return core::unexpected(core::ErrorCode::FileMissing, "no recording was saved");
        return orRefusal(found->second);
    }
    core::Result<std::vector<database::ExamStart>> examsWithoutScore(const database::Login&,
                                                                     database::PersonId) const override
    {
        return orRefusal(exams);
    }
    core::Result<std::vector<database::ExamStart>> examStarts(const database::Login&, database::PersonId,
                                                              const std::string&) const override
    {
        return orRefusal(exams);
    }
    core::Result<std::vector<database::AttemptId>> toCheck(const database::Login&, int) const override
    {
        return orRefusal(std::vector<database::AttemptId>());
    }
    core::Status noteCheck(const database::Login&, database::AttemptId, database::Doubt) override { return done(); }
    core::Result<std::vector<database::BandPoint>> classBand(const database::Login&, database::PersonId,
                                                             const std::string&) const override
    {
        return orRefusal(band);
    }
    core::Result<std::optional<database::LessonMedians>> classMedians(const database::Login&, database::PersonId,
                                                                      const std::string&) const override
    {
        return orRefusal(medians);
    }
};

struct FakeComments final : database::CommentRepository, Fake
{
    std::map<std::int64_t, database::AttemptTalk> talks;  ///< by attempt
    std::vector<database::Feedback> feedback;
    std::vector<std::int64_t> seen;  ///< ids of attempts
    std::int64_t lastId = 0;

    core::Result<database::AttemptTalk> list(const database::Login&, database::AttemptId id) const override
    {
        const auto found = talks.find(id.value);
        return orRefusal(found == talks.end() ? database::AttemptTalk() : found->second);
    }
    core::Status add(const database::Login& who, database::AttemptId id, const database::NewComment& comment) override
    {
        if (!refusal)
            talks[id.value].comments.push_back({++lastId, who.fullName(), "2026-11-20T10:15:00Z", comment.words,
                                                comment.placeMm, comment.momentMs, true});
        return done();
    }
    core::Status withdraw(const database::Login&, std::int64_t comment) override
    {
        if (refusal)
            return done();
        for (auto& [attempt, talk] : talks)
            if (std::erase_if(talk.comments, [&](const auto& one) { return one.id == comment; }) > 0)
                return {};
        return core::unexpected(core::ErrorCode::ChangedSince, "it was withdrawn already");
    }
    core::Status giveScore(const database::Login& who, database::AttemptId id, std::optional<int> tenths,
                           const std::string& reason, std::size_t before) override
    {
        auto& given = talks[id.value].overrides;
        if (given.size() != before)
            return core::unexpected(core::ErrorCode::ChangedSince, "another score was given");
        if (!refusal)
            given.push_back({who.fullName(), "2026-11-20T10:15:00Z", tenths, reason});
        return done();
    }
    core::Result<std::vector<database::Feedback>> feedbackFor(const database::Login&, database::PersonId) const override
    {
        return orRefusal(feedback);
    }
    core::Status markSeen(const database::Login&, const database::AttemptRecord& attempt) override
    {
        if (!refusal)
            seen.push_back(attempt.id);
        return done();
    }
};

struct FakeClasses final : database::ClassRepository, Fake
{
    std::vector<database::SchoolClass> all;
    std::vector<database::ClassOverview> overviews;
    std::vector<database::LessonResults> lessons;
    std::vector<database::ClassAssignment> given;
    std::vector<database::ClassId> exported;

    core::Result<std::vector<database::SchoolClass>> list(const database::Login&) const override
    {
        return orRefusal(all);
    }
    core::Status add(const database::Login&, const std::string& name) override
    {
        if (!refusal)
            all.push_back({{static_cast<std::int64_t>(all.size()) + 1}, name});
        return done();
    }
    core::Status rename(const database::Login&, database::ClassId id, const std::string& name) override
    {
        for (auto& one : all)
            if (one.id == id && !refusal)
                one.name = name;
        return done();
    }
    core::Result<database::ClassOverview> overview(const database::Login&, database::ClassId id) const override
    {
        for (const auto& one : overviews)
            if (one.id == id)
                return orRefusal(one);
        return unknown();
    }
    core::Result<database::LessonResults> results(const database::Login&, database::ClassId,
                                                  const std::string& lessonId) const override
    {
        for (const auto& one : lessons)
            if (one.lessonId == lessonId)
                return orRefusal(one);
        return unknown();
    }
    core::Result<std::vector<database::ClassAssignment>> assignments(const database::Login&) const override
    {
        return orRefusal(given);
    }
    core::Status assign(const database::Login&, const database::ClassAssignment& assignment,
                        const std::optional<database::ClassAssignment>&, const QByteArray&) override
    {
        if (!refusal)
            given.push_back(assignment);
        return done();
    }
    core::Status unassign(const database::Login&, const database::ClassAssignment& before) override
    {
        if (!refusal)
            std::erase_if(given, [&](const auto& one) {
                return one.classId == before.classId && one.lessonId == before.lessonId;
            });
        return done();
    }
    core::Status noteExport(const database::Login&, database::ClassId id) override
    {
        if (!refusal)
            exported.push_back(id);
        return done();
    }
};

struct FakePeople final : database::PeopleRepository, Fake
{
    std::vector<database::Person> all;
    database::RosterOutcome outcome;  ///< result of import()
    int imports = 0;                  ///< without dry runs
    bool isFileClean = true;          ///< result of erase()

    core::Result<std::vector<database::Person>> list(const database::Login&) const override { return orRefusal(all); }
    core::Result<database::Entered> add(const database::Login&, const database::NewPerson& person,
                                        const std::vector<database::ClassId>& classes) override
    {
        if (refusal)
            return tl::unexpected(*refusal);
        database::Person added;
        added.id = {static_cast<std::int64_t>(all.size()) + 100};
        added.username = person.username;
        added.givenName = person.givenName;
        added.familyName = person.familyName;
        added.role = person.role;
        added.classes = classes;
        all.push_back(added);
        return database::Entered{added, "ABCD-EFGH"};
    }
    core::Result<database::Person> change(const database::Login&, const database::Person& person,
                                          const database::Person& asItWas) override
    {
        for (auto& one : all)
            if (one.id == person.id) {
                if (!refusal && !(one == asItWas))
                    return core::unexpected(core::ErrorCode::ChangedSince, "the person has been changed");
                if (!refusal)
                    one = person;
                return orRefusal(one);
            }
        return unknown();
    }
    core::Result<database::Entered> resetPassword(const database::Login&, database::PersonId person) override
    {
        for (const auto& one : all)
            if (one.id == person)
                return orRefusal(database::Entered{one, "ABCD-EFGH"});
        return unknown();
    }
    core::Result<database::ErasedPerson> erase(const database::Login&, database::PersonId person) override
    {
        for (auto& one : all)
            if (one.id == person) {
                if (refusal)
                    return tl::unexpected(*refusal);
                one.username = one.pseudonym();
                one.givenName.clear();
                one.familyName.clear();
                one.disabled = true;
                return database::ErasedPerson{one, isFileClean};
            }
        return unknown();
    }
    core::Result<database::RosterOutcome> import(const database::Login&, std::string_view, bool isDryRun,
                                                 const database::RosterOutcome& asSeen) override
    {
        if (!isDryRun && asSeen.people != outcome.people)
            return core::unexpected(core::ErrorCode::ChangedSince, "the list would do something else by now");
        imports += isDryRun ? 0 : 1;
        return orRefusal(outcome);
    }
};

struct FakePresets final : database::PresetRepository, Fake
{
    std::vector<database::KeptPreset> all;
    std::function<void()> beforeAdd = [] {};  ///< called before the assignment is added, as a change by another station

    core::Result<std::vector<database::KeptPreset>> list(const database::Login&) const override
    {
        return orRefusal(all);
    }
    core::Status add(const database::Login&, const database::KeptPreset& preset) override
    {
        const auto before = beforeAdd;  // a copy, because the function may replace itself
        before();
        for (const auto& one : all)
            if (one.name == preset.name && one.version == preset.version && one.hash != preset.hash)
                return core::unexpected(core::ErrorCode::OutOfRange, "the version exists");
        if (!refusal)
            all.push_back(preset);
        return done();
    }
};

struct FakeSettings final : database::SettingsRepository, Fake
{
    database::SettingsMap all;
    std::function<void()> beforeReplace = [] {};  ///< called first, as a change by another station

    core::Result<database::SettingsMap> read(const database::Login&) const override { return orRefusal(all); }
    core::Result<database::ReplacedSetting> replace(const database::Login&, const std::string& name,
                                                    const std::string& value,
                                                    const std::optional<std::string>& of) override
    {
        const auto before = beforeReplace;  // a copy, because the function may replace itself
        before();
        if (refusal)
            return tl::unexpected(*refusal);
        database::ReplacedSetting replaced{true, all[name]};
        if (of && *of != replaced.before)
            replaced.isDone = false;
        else
            all[name] = value;
        return replaced;
    }
    core::Status changeOwn(const database::Login&, const std::string& name, const std::string& value) override
    {
        if (!refusal)
            all[name] = value;
        return done();
    }
};

struct FakeAudit final : database::AuditRepository, Fake
{
    std::vector<database::AuditRow> rows;  ///< newest first
    database::AuditHead newest;

    core::Result<std::vector<database::AuditRow>> read(const database::Login&, int limit, std::int64_t beforeSeq,
                                                       database::AuditRows) const override
    {
        std::vector<database::AuditRow> found;
        for (const auto& row : rows)
            if ((beforeSeq == 0 || row.seq < beforeSeq) && static_cast<int>(found.size()) < limit)
                found.push_back(row);
        return orRefusal(found);
    }
    core::Result<database::AuditHead> head() const override { return orRefusal(newest); }
};

struct FakeMaintenance final : database::MaintenanceRepository, Fake
{
    database::CheckReport report;

    core::Result<QString> backUp(const database::Login&, const QString& folder, const QDateTime&,
                                 const GoesOn&) override
    {
        return orRefusal(folder + QStringLiteral("/backup.sqlite"));
    }
    core::Result<database::CheckReport> check(const database::Login&, const std::vector<std::string>&,
                                              const GoesOn& goesOn) const override
    {
        database::CheckReport found = report;
        found.isStopped = !goesOn();
        return orRefusal(found);
    }
};

struct FakeLessons final : database::LessonRepository, Fake
{
    database::LessonsOfUser lessons;
    std::map<std::string, int> left;  ///< by lesson; missing: no limit
    database::GradeContext context;
    std::vector<database::KeptSheet> kept;

    core::Result<database::LessonsOfUser> ofUser(const database::Login&) const override { return orRefusal(lessons); }
    core::Result<QByteArray> version(const database::Login&, const std::string&) const override { return unknown(); }
    core::Result<std::optional<int>> attemptsLeft(const database::Login&, const std::string& lessonId) const override
    {
        const auto found = left.find(lessonId);
        return orRefusal(found != left.end() ? std::optional(found->second) : std::nullopt);
    }
    core::Result<database::GradeContext> contextOf(const database::Login&, const database::AttemptRecord&,
                                                   int) const override
    {
        return orRefusal(context);
    }
    core::Result<database::KnownAttempts> known(const database::Login&, int) const override
    {
        database::KnownAttempts all{{}, std::set<std::string>()};
        for (const auto& [lesson, count] : left)
            if (count <= 0)
                all.usedUp.insert(lesson);
        return orRefusal(all);
    }
    core::Result<std::vector<database::KeptSheet>> sheets(const database::Login&, const std::string&,
                                                          const std::string&, int) const override
    {
        return orRefusal(kept);
    }
};

/// Refuses every login, because only the database can make one.
struct FakeLogins final : database::LoginRepository, Fake
{
    static core::Result<database::Login> nobody()
    {
        return core::unexpected(core::ErrorCode::WrongLogin, "there is nobody here");
    }
    core::Result<database::Login> login(const std::string&, const std::string&) override { return nobody(); }
    core::Result<database::Login> redeem(const std::string&, const std::string&, const std::string&) override
    {
        return nobody();
    }
    core::Result<database::Login> createFirstAdmin(const database::NewPerson&, const std::string&) override
    {
        return nobody();
    }
    core::Status logout(const database::Login&) override { return done(); }
    core::Status changePassword(const database::Login&, const std::string&, const std::string&) override
    {
        return done();
    }
    core::Result<std::string> ownHash(const database::Login&) const override { return orRefusal(std::string()); }
    core::Result<database::Role> role(const database::Login& who) const override { return orRefusal(who.role()); }
    core::Status raiseCost(const database::Login&, const database::PasswordCost&) override { return done(); }
};

/// A school in memory. Its requests wait until answer() is called, so that a test decides what happens in between.
class FakeSchool final : public app::SchoolAccess
{
public:
    FakeAttempts attempts;
    FakeComments comments;
    FakeClasses classes;
    FakePeople people;
    FakePresets presets;
    FakeSettings settings;
    FakeAudit audit;
    FakeMaintenance maintenance;
    FakeLessons lessons;
    FakeLogins logins;
    std::optional<core::Error> outage;  ///< if set, there is no connection
    int waiting = 0;                    ///< attempts in the outbox

    [[nodiscard]] database::Repositories all()
    {
        return {attempts, comments, classes, people, presets, settings, audit, maintenance, lessons, logins, m_key};
    }
    [[nodiscard]] bool isAsked() const { return !m_jobs.empty(); }
    /// Answers all requests, and those that are made while these are answered.
    void answer()
    {
        while (!m_jobs.empty()) {
            const Job job = std::move(m_jobs.front());
            m_jobs.pop_front();
            const database::Repositories repositories = all();
            static_cast<void>(job.work(outage ? core::Result<const database::Repositories*>(tl::unexpected(*outage))
                                              : core::Result<const database::Repositories*>(&repositories)));
            if (job.owner)
                job.done();
        }
    }

    void countWaiting(QObject*, const database::Login&, const std::function<void(int)>& done) override
    {
        done(waiting);
    }
    void expectAlone(QObject*, const database::Login&, const std::function<void(const core::Status&)>& done) override
    {
        done({});
    }
    [[nodiscard]] int retryMs() const override { return 10; }

private:
    void run(Job job) override { m_jobs.push_back(std::move(job)); }
    void runBeside(Job job) override { m_jobs.push_back(std::move(job)); }

    std::deque<Job> m_jobs;
    database::StationKey m_key = database::StationKey::make();
};

}  // namespace support
