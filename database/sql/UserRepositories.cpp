// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sql/UserRepositories.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "database/Passwords.h"
#include "database/sql/Attempts.h"
#include "database/sql/Classes.h"
#include "database/sql/Feedback.h"
#include "database/sql/LessonVersions.h"
#include "database/sql/Logins.h"

namespace database::sql {
namespace {

class SqlLessons final : public LessonRepository
{
public:
    explicit SqlLessons(const DatabaseContext& school) : m_school(school) {}

    core::Result<LessonsOfUser> ofUser(const Login& who) const override
    {
        auto standings = standingsOf(m_school, who, who.person());
        if (!standings)
            return tl::unexpected(standings.error());
        LessonsOfUser found{std::move(*standings), {}, {}};
        if (who.role() != Role::Student)
            return found;
        auto feedback = feedbackFor(m_school, who, who.person());
        if (!feedback)
            return tl::unexpected(feedback.error());
        auto assigned = assignedTo(who);
        if (!assigned)
            return tl::unexpected(assigned.error());
        found.feedback = std::move(*feedback);
        found.assigned = std::move(*assigned);
        return found;
    }

    core::Result<QByteArray> version(const Login& who, const std::string& hash) const override
    {
        return versionPack(m_school, who, hash);
    }

    core::Result<std::optional<int>> attemptsLeft(const Login& who, const std::string& lessonId) const override
    {
        return sql::attemptsLeft(m_school, who, lessonId);
    }

    core::Result<GradeContext> contextOf(const Login& who, const AttemptRecord& attempt,
                                         int historyLength) const override
    {
        auto history = sql::history(m_school, who, who.person(),
                                    {attempt.lessonId, attempt.lessonId.empty() ? attempt.tooth : "", historyLength});
        if (!history)
            return tl::unexpected(history.error());
        const auto standing = standingAmongClassmates(m_school, who, attempt.lessonId, attempt.rubricHash,
                                                      attempt.device, attempt.scoreTenths);
        if (!standing)
            return tl::unexpected(standing.error());
        const auto left = sql::attemptsLeft(m_school, who, attempt.lessonId);
        return GradeContext{std::move(*history), *standing, left.value_or(std::nullopt)};
    }

    core::Result<KnownAttempts> known(const Login& who, int newest) const override
    {
        KnownAttempts found;
        if (who.role() == Role::Student) {
            const auto assigned = assignedTo(who);
            if (!assigned)
                return tl::unexpected(assigned.error());
            for (const AssignedLesson& one : *assigned)
                if (one.attemptsLeft && *one.attemptsLeft <= 0)
                    found.usedUp.insert(one.lessonId);
        }
        const auto attempts = sql::history(m_school, who, who.person(), {"", "", newest});
        if (!attempts)
            return tl::unexpected(attempts.error());
        found.kept.emplace();
        for (const AttemptRecord& one : *attempts)
            found.kept->insert(one.uid);
        return found;
    }

    core::Result<std::vector<KeptSheet>> sheets(const Login& who, const std::string& lessonId,
                                                const std::string& lessonHash, int limit) const override
    {
        return sheetsOfLesson(m_school, who, lessonId, lessonHash, limit);
    }

private:
    /// Returns the lessons that are assigned to a student's classes, without duplicates.
    [[nodiscard]] core::Result<std::vector<AssignedLesson>> assignedTo(const Login& who) const
    {
        const auto classes = listClasses(m_school, who);
        if (!classes)
            return tl::unexpected(classes.error());
        const auto assignments = listAssignments(m_school, who);
        if (!assignments)
            return tl::unexpected(assignments.error());
        std::vector<AssignedLesson> lessons;
        std::map<std::string, std::int64_t> newest;  // id of the assignment whose version is used, by lesson
        for (const ClassAssignment& one : *assignments) {
            auto lesson = std::find_if(lessons.begin(), lessons.end(),
                                       [&](const AssignedLesson& other) { return other.lessonId == one.lessonId; });
            if (lesson == lessons.end()) {
                const auto left = sql::attemptsLeft(m_school, who, one.lessonId);
                if (!left)
                    return tl::unexpected(left.error());
                lesson = lessons.insert(lessons.end(), AssignedLesson{one.lessonId, {}, *left});
            }
            const auto ofClass = std::find_if(classes->begin(), classes->end(),
                                              [&](const SchoolClass& other) { return other.id == one.classId; });
            lesson->classes.emplace_back(ofClass != classes->end() ? ofClass->name : std::string(), one.dueUtc);
            if (std::int64_t& of = newest[one.lessonId]; one.id > of) {
                of = one.id;
                lesson->lessonHash = one.lessonHash;
            }
        }
        return lessons;
    }

    const DatabaseContext& m_school;
};

class SqlLogins final : public LoginRepository
{
public:
    explicit SqlLogins(const DatabaseContext& school) : m_school(school) {}

    core::Result<Login> login(const std::string& username, const std::string& password) override
    {
        return Logins::login(m_school, username, password);
    }
    core::Result<Login> redeem(const std::string& username, const std::string& code,
                               const std::string& password) override
    {
        return Logins::redeem(m_school, username, code, password);
    }
    core::Result<Login> createFirstAdmin(const NewPerson& admin, const std::string& password) override
    {
        return Logins::createFirstAdmin(m_school, admin, password, timedCost());
    }
    core::Status logout(const Login& who) override { return Logins::logout(m_school, who); }
    core::Status changePassword(const Login& who, const std::string& old, const std::string& password) override
    {
        return Logins::changePassword(m_school, who, old, password);
    }
    core::Result<std::string> ownHash(const Login& who) const override { return Logins::ownHash(m_school, who); }
    core::Result<Role> role(const Login& who) const override
    {
        const auto now = authorize(m_school, who, Operation::ReadSettings);
        if (!now)
            return tl::unexpected(now.error());
        return now->role;
    }
    core::Status raiseCost(const Login& who, const PasswordCost& cost) override
    {
        return raisePasswordCost(m_school, who, cost);
    }

private:
    const DatabaseContext& m_school;
};

}  // namespace

std::unique_ptr<LessonRepository> lessonRepository(const DatabaseContext& school)
{
    return std::make_unique<SqlLessons>(school);
}

std::unique_ptr<LoginRepository> loginRepository(const DatabaseContext& school)
{
    return std::make_unique<SqlLogins>(school);
}

}  // namespace database::sql
