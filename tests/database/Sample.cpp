// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/database/Sample.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/Rng.h"
#include "database/Passwords.h"
#include "database/sql/Attempts.h"
#include "database/sql/Audit.h"
#include "database/sql/Classes.h"
#include "database/sql/Database.h"
#include "database/sql/Logins.h"
#include "database/sql/People.h"
#include "database/sql/Statement.h"
#include "lessons/LessonCatalog.h"

namespace support {
namespace {

using namespace database;
using namespace database::sql;

const std::string kDoing = "make up a school";
constexpr std::int64_t kToldEvery = 5000;
constexpr int kDays = 180;
constexpr std::array kGiven{"Ada", "Ben", "Chloe", "Dan", "Emi", "Finn", "Grace", "Hugo", "Ines", "Jun", "Kim", "Lea"};
constexpr std::array kFamily{"Abe",  "Bauer", "Costa",  "Diaz", "Endo",  "Fischer", "Garcia",
                             "Hart", "Ito",   "Jansen", "Kato", "Lopez", "Meyer",   "Nowak"};

struct Student
{
    PersonId id;
    std::string uid;
    double talent = 0.0;    ///< of the first attempt, 0 .. 1
    double learning = 0.0;  ///< how soon they get better
    std::vector<int> done;  ///< attempts at each lesson
};

class SampleMaker
{
public:
    SampleMaker(const School& school, const Session& admin, const SampleSize& size,
                const std::vector<lessons::Lesson>& lessons)
        : m_school(school), m_admin(admin), m_size(size), m_lessons(lessons), m_rng(size.seed)
    {}

    core::Status make(const std::function<void(std::int64_t)>& progress)
    {
        auto done = inTransaction(m_school.db, kDoing, [this] { return enterPeople(); });
        for (std::int64_t k = 0; done && k < m_size.attempts; ++k) {
            Student& student = m_students[pick(m_students.size())];
            if (auto kept = deliverAttempt(m_school, attemptOf(student, pick(m_lessons.size()), k), {}); !kept)
                done = tl::unexpected(kept.error());
            if (progress && (k + 1) % kToldEvery == 0)
                progress(k + 1);
        }
        return done;
    }

private:
    double uniform() { return m_rng.uniform(); }
    std::size_t pick(std::size_t count) { return static_cast<std::size_t>(m_rng.below(static_cast<int>(count))); }

    core::Status enterPeople()
    {
        AuditBatch audit(m_school);
        ClassId ofClass;
        for (int k = 0; k < m_size.students; ++k) {
            if (k % m_size.classSize == 0) {
                const std::string teacherName = QStringLiteral("teacher%1").arg(k / m_size.classSize + 1).toStdString();
                const auto made = classNamed(m_school, audit, m_admin.uid(),
                                             QStringLiteral("Year %1").arg(k / m_size.classSize + 1).toStdString());
                const auto teacher =
                    enter(m_school, audit, m_admin.uid(), {teacherName, "Tess", teacherName, Role::Instructor}, {});
                if (!made || !teacher)
                    return tl::unexpected(made ? teacher.error() : made.error());
                ofClass = *made;
                if (auto put = putInto(m_school, audit, m_admin.uid(), ofClass, teacher->id); !put)
                    return put;
            }
            const std::string name = QStringLiteral("s%1").arg(k + 1, 4, 10, QLatin1Char('0')).toStdString();
            const auto student =
                enter(m_school, audit, m_admin.uid(),
                      {name, kGiven.at(pick(kGiven.size())), kFamily.at(pick(kFamily.size())), Role::Student}, {});
            if (!student)
                return tl::unexpected(student.error());
            if (auto put = putInto(m_school, audit, m_admin.uid(), ofClass, student->id); !put)
                return put;
            m_students.push_back({student->id, student->uid, 0.3 + 0.5 * uniform(), 0.03 + 0.3 * uniform(),
                                  std::vector<int>(m_lessons.size())});
        }
        return audit.seal();
    }

    AttemptRecord attemptOf(Student& student, std::size_t lesson, std::int64_t number)
    {
        const int before = student.done[lesson]++;
        const double skill = 1.0 - (1.0 - student.talent) * std::exp(-student.learning * before);
        AttemptRecord record;
        record.uid = newUid();
        record.person = student.id;
        record.personUid = student.uid;
        const double share = static_cast<double>(number) / static_cast<double>(m_size.attempts);
        record.finishedUtc = m_school.nowUtc()
                                 .addSecs(static_cast<qint64>(-86400.0 * kDays * (1.0 - share)))
                                 .toString(Qt::ISODate)
                                 .toStdString();
        const lessons::Lesson& of = m_lessons[lesson];
        const auto* made = std::get_if<lessons::MadeTooth>(&of.tooth);
        record.tooth = made != nullptr ? std::to_string(made->fdi) : "block";
        record.lessonId = of.id;
        record.lessonHash = of.hash;
        record.rubricHash = of.rubric.hash;
        int total = 1000;
        for (const lessons::CriterionRule& rule : of.rubric.criteria) {
            const double loss = std::clamp((1.0 - skill) * (0.5 + 1.2 * uniform()), 0.0, 1.0);
            const int lost = static_cast<int>(std::lround(loss * rule.weightTenths));
            record.criteria.push_back({rule.id, lost, rule.weightTenths});
            total -= lost;
        }
        record.scoreTenths = total;
        record.passMarkTenths = of.rubric.passMarkTenths;
        record.passed = total >= of.rubric.passMarkTenths;
        record.expectedTenths = std::clamp(total + static_cast<int>(200.0 * (uniform() - 0.4)), 0, 1000);
        record.durationMs = static_cast<std::int64_t>(120'000.0 + 480'000.0 * (1.1 - skill) * (0.6 + 0.8 * uniform()));
        record.scoreSheetJson = "{\"format\":2,\"sample\":true}";
        record.stateHash = record.uid.substr(0, 16);
        record.device = "pointer";
        record.method = "continuous";
        record.grid = 150;
        record.viewMode = "flat";
        record.seed = std::to_string(m_size.seed);
        record.preset = "natural v1";
        record.program = "sample";
        record.meanForceMn = static_cast<int>(600.0 + 900.0 * uniform());
        record.peakForceMn = record.meanForceMn * 2 + static_cast<int>(800.0 * (1.0 - skill));
        return record;
    }

    const School& m_school;
    const Session& m_admin;
    const SampleSize& m_size;
    const std::vector<lessons::Lesson>& m_lessons;
    core::Rng m_rng;
    std::vector<Student> m_students;
};

}  // namespace

core::Status makeSample(const School& school, const Session& admin, const SampleSize& size,
                        const std::vector<lessons::Lesson>& lessons, const std::function<void(std::int64_t)>& progress)
{
    // A disk that fails meanwhile costs a school that can be made up again.
    const char* const hurry =
        dialect::isPostgres(school.db) ? "SET synchronous_commit = off" : "PRAGMA synchronous = OFF";
    if (auto set = execute(school.db, hurry, kDoing); !set)
        return set;
    return SampleMaker(school, admin, size, lessons).make(progress);
}

core::Result<std::string> makeSchool(const QString& where, const SampleSize& size)
{
    const auto opened = Database::open(where);
    if (!opened)
        return tl::unexpected(opened.error());
    const School school{(*opened)->handle(), StationKey::make()};
    const std::string password = newCode() + "x";
    const auto admin = Logins::createFirstAdmin(school, {"admin", "", "", Role::Admin}, password, PasswordCost{});
    if (!admin)
        return tl::unexpected(admin.error());
    std::vector<lessons::Lesson> lessons;
    for (const lessons::CatalogEntry& entry : lessons::readCatalog({}))
        if (entry.read.lesson)
            lessons.push_back(*entry.read.lesson);
    if (auto made = makeSample(school, *admin, size, lessons); !made)
        return tl::unexpected(made.error());
    return password;
}

}  // namespace support
