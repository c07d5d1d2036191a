// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <QByteArray>
#include <QDateTime>
#include <QString>

#include "core/base/Result.h"
#include "database/AttemptRecord.h"
#include "database/AuditHead.h"
#include "database/ClassOverview.h"
#include "database/IntegrityIssue.h"
#include "database/Login.h"
#include "database/Passwords.h"
#include "database/Person.h"
#include "database/SchoolSettings.h"
#include "database/StationKey.h"
#include "lessons/ClassStanding.h"

/// What the program does with the data of a school, one method per use case. Each method runs in a transaction of its
/// own and checks whether the present role of the login allows it: NotAllowed if not, Disabled for an account that was
/// disabled. Any method also returns the errors of the connection (ConnectionLost, Busy, FileMissing ...). Thread: that
/// of the connection. database/sql/Repositories.h implements the interfaces for SQLite and PostgreSQL.
namespace database {

/// Attempts and their recordings.
class AttemptRepository
{
public:
    virtual ~AttemptRepository() = default;
    /// The last attempts of a person, newest first, without score sheets.
    [[nodiscard]] virtual core::Result<std::vector<AttemptRecord>> history(const Login& who, PersonId person,
                                                                           const HistoryQuery& query) const = 0;
    /// One attempt with its score sheet. UnknownName: it does not exist.
    [[nodiscard]] virtual core::Result<AttemptRecord> open(const Login& who, AttemptId id) const = 0;
    /// The bytes of its recording. FileMissing: none was saved. BadStructure: the bytes are damaged.
    [[nodiscard]] virtual core::Result<QByteArray> recording(const Login& who, AttemptId id) const = 0;
    /// The exams that a person has begun and that have no score, newest first.
    [[nodiscard]] virtual core::Result<std::vector<ExamStart>> examsWithoutScore(const Login& who,
                                                                                 PersonId person) const = 0;
    /// How the classmates of a person do at a lesson, attempt by attempt. Empty for fewer than lessons::kFewestPeople.
    [[nodiscard]] virtual core::Result<std::vector<BandPoint>> classBand(const Login& who, PersonId person,
                                                                         const std::string& lessonId) const = 0;
    /// Score and duration of the same people. Empty for fewer than lessons::kFewestPeople.
    [[nodiscard]] virtual core::Result<std::optional<LessonMedians>>
    classMedians(const Login& who, PersonId person, const std::string& lessonId) const = 0;
};

/// Comments and scores that instructors give.
class CommentRepository
{
public:
    virtual ~CommentRepository() = default;
    /// Comments and given scores of an attempt, oldest first.
    [[nodiscard]] virtual core::Result<AttemptTalk> list(const Login& who, AttemptId id) const = 0;
    [[nodiscard]] virtual core::Status add(const Login& who, AttemptId id, const NewComment& comment) = 0;
    /// Hides one's own comment. ChangedSince: it is hidden already.
    [[nodiscard]] virtual core::Status withdraw(const Login& who, std::int64_t comment) = 0;
    /// Gives a score in tenths of a point, which replaces the machine's; empty: the machine's score counts again.
    /// ChangedSince: another number of scores than `before` has been given so far.
    [[nodiscard]] virtual core::Status giveScore(const Login& who, AttemptId id, std::optional<int> tenths,
                                                 const std::string& reason, std::size_t before) = 0;
    /// Attempts of a person that others have commented on or given a score, newest comment first.
    [[nodiscard]] virtual core::Result<std::vector<Feedback>> feedbackFor(const Login& who, PersonId person) const = 0;
    /// Records that the login's person has seen the comments on their attempt so far.
    [[nodiscard]] virtual core::Status markSeen(const Login& who, const AttemptRecord& attempt) = 0;
};

/// Classes, their assignments, and how they do.
class ClassRepository
{
public:
    virtual ~ClassRepository() = default;
    /// The classes within reach of the login, by name.
    [[nodiscard]] virtual core::Result<std::vector<SchoolClass>> list(const Login& who) const = 0;
    /// OutOfRange: the name is taken or not allowed. Admins.
    [[nodiscard]] virtual core::Status add(const Login& who, const std::string& name) = 0;
    [[nodiscard]] virtual core::Status rename(const Login& who, ClassId id, const std::string& name) = 0;
    /// Students by lessons. Teachers of the class and admins.
    [[nodiscard]] virtual core::Result<ClassOverview> overview(const Login& who, ClassId id) const = 0;
    /// The results of a class at one lesson. Teachers of the class and admins.
    [[nodiscard]] virtual core::Result<LessonResults> results(const Login& who, ClassId id,
                                                              const std::string& lessonId) const = 0;
    /// The assignments of all classes within reach, by due date.
    [[nodiscard]] virtual core::Result<std::vector<ClassAssignment>> assignments(const Login& who) const = 0;
    /// Assigns a lesson to a class, or changes the assignment. ChangedSince: the assignment differs from `before`.
    /// @param before  the assignment as shown to the user; empty: there was none
    [[nodiscard]] virtual core::Status assign(const Login& who, const ClassAssignment& assignment,
                                              const std::optional<ClassAssignment>& before) = 0;
    /// Removes an assignment; attempts stay. ChangedSince as above.
    [[nodiscard]] virtual core::Status unassign(const Login& who, const ClassAssignment& before) = 0;
    /// Records in the audit that a report or table of a class leaves the school.
    [[nodiscard]] virtual core::Status noteExport(const Login& who, ClassId id) = 0;
};

/// The people of a school. Admins.
class PeopleRepository
{
public:
    virtual ~PeopleRepository() = default;
    [[nodiscard]] virtual core::Result<std::vector<Person>> list(const Login& who) const = 0;
    /// Creates a person and puts them into these classes. OutOfRange: the username or a name is not allowed or taken.
    [[nodiscard]] virtual core::Result<Entered> add(const Login& who, const NewPerson& person,
                                                    const std::vector<ClassId>& classes) = 0;
    /// Changes the fields and classes in which `person` and `asItWas` differ. ChangedSince: another user has changed
    /// the same field to another value. NobodyLeft: this is the last admin who can log in.
    /// @param asItWas  the person as shown to the user
    [[nodiscard]] virtual core::Result<Person> change(const Login& who, const Person& person,
                                                      const Person& asItWas) = 0;
    /// Replaces the password of a person by a one-time code.
    [[nodiscard]] virtual core::Result<Entered> resetPassword(const Login& who, PersonId person) = 0;
    /// Enters the people of a class list (CSV), all or none of them.
    /// @param isDryRun  returns the outcome without a change, and without codes
    /// @param asSeen    the outcome as shown to the user. ChangedSince: the outcome would be another by now
    [[nodiscard]] virtual core::Result<RosterOutcome> import(const Login& who, std::string_view csv, bool isDryRun,
                                                             const RosterOutcome& asSeen) = 0;
};

/// A lesson that the classes of a user were assigned.
struct AssignedLesson
{
    std::string lessonId;
    std::vector<std::pair<std::string, std::string>> classes;  ///< name and due date (ISO 8601; empty: none) of each
    std::optional<int> attemptsLeft;                           ///< empty: no limit
};

/// What the list of lessons shows of a user.
struct LessonsOfUser
{
    std::vector<LessonStanding> standings;
    std::vector<AssignedLesson> assigned;  ///< students only
    std::vector<Feedback> feedback;        ///< students only
};

/// What a new grade is compared with.
struct GradeContext
{
    std::vector<AttemptRecord> history;  ///< earlier attempts of the user, newest first
    lessons::ClassStanding standing;
    std::optional<int> attemptsLeft;  ///< empty: no limit
};

/// The attempts of a user that the school knows.
struct KnownAttempts
{
    std::set<std::string> usedUp = {};  ///< lessons without an attempt left
    /// Uids of the newest attempts; empty: unknown.
    std::optional<std::set<std::string>> kept = {};
};

/// The lessons of the login's person: what was assigned, what was reached, what is left.
class LessonRepository
{
public:
    virtual ~LessonRepository() = default;
    [[nodiscard]] virtual core::Result<LessonsOfUser> ofUser(const Login& who) const = 0;
    /// The number of attempts left at a lesson; empty: no limit.
    [[nodiscard]] virtual core::Result<std::optional<int>> attemptsLeft(const Login& who,
                                                                        const std::string& lessonId) const = 0;
    /// @param historyLength  the most earlier attempts: of the same lesson, or without a lesson at the same tooth
    [[nodiscard]] virtual core::Result<GradeContext> contextOf(const Login& who, const AttemptRecord& attempt,
                                                               int historyLength) const = 0;
    /// @param newest  so many attempts are looked at
    [[nodiscard]] virtual core::Result<KnownAttempts> known(const Login& who, int newest) const = 0;
    /// The score sheets of attempts at exactly this lesson, newest first: the user's own and those that they may read.
    [[nodiscard]] virtual core::Result<std::vector<KeptSheet>>
    sheets(const Login& who, const std::string& lessonId, const std::string& lessonHash, int limit) const = 0;
};

/// Logins and passwords. Most calls hash a password and take a moment.
class LoginRepository
{
public:
    virtual ~LoginRepository() = default;
    /// WrongLogin, TooSoon and NewPassword as sql::Logins::login() says.
    [[nodiscard]] virtual core::Result<Login> login(const std::string& username, const std::string& password) = 0;
    /// Uses up a one-time code and sets the password.
    [[nodiscard]] virtual core::Result<Login> redeem(const std::string& username, const std::string& code,
                                                     const std::string& password) = 0;
    /// Enters the first person of a school, an admin. NotAllowed if there is one already.
    [[nodiscard]] virtual core::Result<Login> createFirstAdmin(const NewPerson& admin, const std::string& password) = 0;
    [[nodiscard]] virtual core::Status logout(const Login& who) = 0;
    /// WrongLogin if `old` is not the password.
    [[nodiscard]] virtual core::Status changePassword(const Login& who, const std::string& old,
                                                      const std::string& password) = 0;
    /// The hash of the user's password, for unlocking the window while the database cannot be reached.
    [[nodiscard]] virtual core::Result<std::string> ownHash(const Login& who) const = 0;
    /// The role that the user has now.
    [[nodiscard]] virtual core::Result<Role> role(const Login& who) const = 0;
    /// Raises the cost of hashing passwords if it at least doubles. Admins.
    [[nodiscard]] virtual core::Status raiseCost(const Login& who, const PasswordCost& cost) = 0;
};

/// Hardness presets of a school. The settings kPresetInUse and kRetiredPresets name the one in use and the retired.
class PresetRepository
{
public:
    virtual ~PresetRepository() = default;
    /// All versions of all presets, by name, the newest version of each first.
    [[nodiscard]] virtual core::Result<std::vector<KeptPreset>> list(const Login& who) const = 0;
    /// Saves a version, which never changes afterwards. OutOfRange: the version exists with another content. Admins.
    [[nodiscard]] virtual core::Status add(const Login& who, const KeptPreset& preset) = 0;
};

/// Settings of a school and of its people.
class SettingsRepository
{
public:
    virtual ~SettingsRepository() = default;
    /// The settings of the login's person, replaced by those of the school where both have one of the same name.
    [[nodiscard]] virtual core::Result<SettingsMap> read(const Login& who) const = 0;
    /// Changes a setting of the school. OutOfRange: the value has more than 16,000 characters. Admins.
    /// @param of  changes it only if this is its value; empty: whatever its value is
    [[nodiscard]] virtual core::Result<ReplacedSetting> replace(const Login& who, const std::string& name,
                                                                const std::string& value,
                                                                const std::optional<std::string>& of) = 0;
    /// Changes a setting of the login's person. OutOfRange as above.
    [[nodiscard]] virtual core::Status changeOwn(const Login& who, const std::string& name,
                                                 const std::string& value) = 0;
};

/// The audit: who has done what, in a chain of signed rows.
class AuditRepository
{
public:
    virtual ~AuditRepository() = default;
    /// At most `limit` rows before row `beforeSeq` (0: the newest), newest first. Admins.
    [[nodiscard]] virtual core::Result<std::vector<AuditRow>> read(const Login& who, int limit, std::int64_t beforeSeq,
                                                                   AuditRows rows) const = 0;
    /// The newest row, for reports. Everybody.
    [[nodiscard]] virtual core::Result<AuditHead> head() const = 0;
};

/// Backups and checks of the whole database. Admins. Takes long: use a connection of its own.
class MaintenanceRepository
{
public:
    /// Called again and again during the work; returns false to stop it.
    using GoesOn = std::function<bool()>;

    virtual ~MaintenanceRepository() = default;
    /// Makes a verified backup of the file in a folder, removes the backups that the rotation does not keep, and notes
    /// the backup in the audit. Returns its path.
    [[nodiscard]] virtual core::Result<QString> backUp(const Login& who, const QString& folder, const QDateTime& nowUtc,
                                                       const GoesOn& goesOn) = 0;
    /// Checks everything in the database.
    /// @param witnesses  audit codes of printed reports
    [[nodiscard]] virtual core::Result<CheckReport> check(const Login& who, const std::vector<std::string>& witnesses,
                                                          const GoesOn& goesOn) const = 0;
};

/// The data of a school as this station sees it.
struct Repositories
{
    AttemptRepository& attempts;
    CommentRepository& comments;
    ClassRepository& classes;
    PeopleRepository& people;
    PresetRepository& presets;
    SettingsRepository& settings;
    AuditRepository& audit;
    MaintenanceRepository& maintenance;
    LessonRepository& lessons;
    LoginRepository& logins;
    const StationKey& stationKey;  ///< of this computer
};

}  // namespace database
