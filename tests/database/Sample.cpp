// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/database/Sample.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

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
constexpr int kDays = 180;
constexpr int kClassSize = 35;
constexpr std::array kGiven{"Ada", "Ben", "Chloe", "Dan", "Emi", "Finn", "Grace", "Hugo", "Ines", "Jun", "Kim", "Lea"};
constexpr std::array kFamily{"Abe",  "Bauer", "Costa",  "Diaz", "Endo",  "Fischer", "Garcia",
                             "Hart", "Ito",   "Jansen", "Kato", "Lopez", "Meyer",   "Nowak"};

struct Student
{
    PersonId id;
    std::string uid;
    double talent = 0.0;    ///< skill at the first attempt, 0 .. 1
    double learning = 0.0;  ///< how fast the student gets better
    std::vector<int> done;  ///< number of attempts at each lesson
};

class Maker
{
public:
    Maker(const DatabaseContext& school, const Login& admin, std::uint64_t seed)
        : m_school(school), m_admin(admin), m_seed(seed), m_rng(seed)
    {
        for (const lessons::CatalogEntry& entry : lessons::readCatalog({}))
            if (entry.read.lesson)
                m_lessons.push_back(*entry.read.lesson);
    }

    core::Status make(int students, std::int64_t attempts)
    {
        auto done = inTransaction(m_school.db, kDoing, [this, students] { return enterPeople(students); });
        for (std::int64_t k = 0; done && k < attempts; ++k) {
            const double share = static_cast<double>(k) / static_cast<double>(attempts);
            Student& student = m_students[pick(m_students.size())];
            if (auto kept = deliverAttempt(m_school, attemptOf(student, pick(m_lessons.size()), share), {}); !kept)
                done = tl::unexpected(kept.error());
        }
        // They have no recordings.
        return done ? execute(m_school.db, "UPDATE attempts SET checked = 2", kDoing) : done;
    }

private:
    double uniform() { return m_rng.uniform(); }
    std::size_t pick(std::size_t count) { return static_cast<std::size_t>(m_rng.below(static_cast<int>(count))); }

    core::Status enterPeople(int students)
    {
        AuditBatch audit(m_school);
        ClassId ofClass;
        const auto add = [&](const NewPerson& who) -> core::Result<Person> {
            auto entered = enter(m_school, audit, m_admin.uid(), who, {});
            if (entered)
                if (auto put = putInto(m_school, audit, m_admin.uid(), ofClass, entered->id); !put)
                    return tl::unexpected(put.error());
            return entered;
        };
        for (int k = 0; k < students; ++k) {
            if (k % kClassSize == 0) {
                const std::string number = std::to_string(k / kClassSize + 1);
                const auto made = classNamed(m_school, audit, m_admin.uid(), "Year " + number);
                if (!made)
                    return tl::unexpected(made.error());
                ofClass = *made;
                if (auto teacher = add({"teacher" + number, "Tess", "teacher" + number, Role::Instructor}); !teacher)
                    return tl::unexpected(teacher.error());
            }
            const std::string name = QStringLiteral("s%1").arg(k + 1, 4, 10, QLatin1Char('0')).toStdString();
            const auto student =
                add({name, kGiven.at(pick(kGiven.size())), kFamily.at(pick(kFamily.size())), Role::Student});
            if (!student)
                return tl::unexpected(student.error());
            m_students.push_back({student->id, student->uid, 0.3 + 0.5 * uniform(), 0.03 + 0.3 * uniform(),
                                  std::vector<int>(m_lessons.size())});
        }
        return audit.seal();
    }

    AttemptRecord attemptOf(Student& student, std::size_t lesson, double share)
    {
        const int before = student.done[lesson]++;
        const double skill = 1.0 - (1.0 - student.talent) * std::exp(-student.learning * before);
        AttemptRecord record;
        record.uid = newUid();
        record.person = student.id;
        record.personUid = student.uid;
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
        record.seed = std::to_string(m_seed);
        record.preset = "natural v1";
        record.program = "sample";
        record.meanForceMn = static_cast<int>(600.0 + 900.0 * uniform());
        record.peakForceMn = record.meanForceMn * 2 + static_cast<int>(800.0 * (1.0 - skill));
        return record;
    }

    const DatabaseContext& m_school;
    const Login& m_admin;
    std::uint64_t m_seed;
    core::Rng m_rng;
    std::vector<lessons::Lesson> m_lessons;
    std::vector<Student> m_students;
};

}  // namespace

core::Result<std::string> makeSchool(const QString& where, const SampleSize& size)
{
    const auto opened = Database::open(where);
    if (!opened)
        return tl::unexpected(opened.error());
    const DatabaseContext school{(*opened)->handle(), StationKey::make()};
    const std::string password = newCode() + "x";
    const auto admin = Logins::createFirstAdmin(school, {"admin", "", "", Role::Admin}, password, PasswordCost{});
    if (!admin)
        return tl::unexpected(admin.error());
    // No sync to the disk: if it fails, the school can be generated again.
    const char* const hurry =
        dialect::isPostgres(school.db) ? "SET synchronous_commit = off" : "PRAGMA synchronous = OFF";
    auto done = execute(school.db, hurry, kDoing);
    if (done)
        done = Maker(school, *admin, size.seed).make(size.students, size.attempts);
    if (!done)
        return tl::unexpected(done.error());
    return password;
}

}  // namespace support
