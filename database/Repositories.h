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

/// Interfaces to the data of a school, one method per use case. Each method runs in a transaction of its own. It checks
/// the user's current role first: NotAllowed if the role does not permit the operation, Disabled if the account was
/// disabled. Any method can also return the errors of the connection (ConnectionLost, Busy, FileMissing ...). Call all
/// methods in the thread of the connection. database/sql/Repositories.h implements the interfaces for SQLite and
/// PostgreSQL.
namespace database {

/// Attempts and their recordings.
class AttemptRepository
{
public:
    virtual ~AttemptRepository() = default;
    /// Returns the last attempts of a person, newest first, without score sheets.
    [[nodiscard]] virtual core::Result<std::vector<AttemptRecord>> history(const Login& who, PersonId person,
                                                                           const HistoryQuery& query) const = 0;
    /// Returns one attempt with its score sheet. UnknownName: it does not exist.
    [[nodiscard]] virtual core::Result<AttemptRecord> open(const Login& who, AttemptId id) const = 0;
    /// Returns the recording of an attempt. FileMissing: none was saved. BadStructure: its bytes are damaged.
    [[nodiscard]] virtual core::Result<QByteArray> recording(const Login& who, AttemptId id) const = 0;
    /// Returns the exams that a person has begun and that have no score, newest first.
    [[nodiscard]] virtual core::Result<std::vector<ExamStart>> examsWithoutScore(const Login& who,
                                                                                 PersonId person) const = 0;
    /// Returns all exams at a lesson that a person has begun, with a score or without.
    [[nodiscard]] virtual core::Result<std::vector<ExamStart>> examStarts(const Login& who, PersonId person,
                                                                          const std::string& lessonId) const = 0;
    /// Returns the newest attempts that no teacher or admin has checked yet (database/AttemptCheck.h), newest first.
    /// Teachers: of their classes. Admins.
    [[nodiscard]] virtual core::Result<std::vector<AttemptId>> toCheck(const Login& who, int limit) const = 0;
    /// Records the result of a check.
    [[nodiscard]] virtual core::Status noteCheck(const Login& who, AttemptId id, Doubt found) = 0;
    /// Returns the scores of a person's classmates at a lesson, by attempt. Empty for fewer than lessons::kFewestPeople
    /// people.
    [[nodiscard]] virtual core::Result<std::vector<BandPoint>> classBand(const Login& who, PersonId person,
                                                                         const std::string& lessonId) const = 0;
    /// Returns the median score and duration of the same people. Empty for fewer than lessons::kFewestPeople people.
    [[nodiscard]] virtual core::Result<std::optional<LessonMedians>>
    classMedians(const Login& who, PersonId person, const std::string& lessonId) const = 0;
};

/// Comments on attempts, and the scores with which instructors override computed ones.
class CommentRepository
{
public:
    virtual ~CommentRepository() = default;
    /// Returns the comments on an attempt and its overrides, oldest first.
    [[nodiscard]] virtual core::Result<AttemptTalk> list(const Login& who, AttemptId id) const = 0;
    [[nodiscard]] virtual core::Status add(const Login& who, AttemptId id, const NewComment& comment) = 0;
    /// Hides the user's own comment. ChangedSince: it is hidden already.
    [[nodiscard]] virtual core::Status withdraw(const Login& who, std::int64_t comment) = 0;
    /// Overrides the computed score, in tenths of a point; empty: the computed score counts again. ChangedSince: the
    /// number of overrides so far is not `before`.
    [[nodiscard]] virtual core::Status giveScore(const Login& who, AttemptId id, std::optional<int> tenths,
                                                 const std::string& reason, std::size_t before) = 0;
    /// Returns the attempts of a person that others have commented on or overridden, newest feedback first.
    [[nodiscard]] virtual core::Result<std::vector<Feedback>> feedbackFor(const Login& who, PersonId person) const = 0;
    /// Records that the user has seen all feedback so far on their attempt.
    [[nodiscard]] virtual core::Status markSeen(const Login& who, const AttemptRecord& attempt) = 0;
};

/// Classes, their assignments and their results.
class ClassRepository
{
public:
    virtual ~ClassRepository() = default;
    /// Returns the classes that the user may access, by name.
    [[nodiscard]] virtual core::Result<std::vector<SchoolClass>> list(const Login& who) const = 0;
    /// Creates a class. OutOfRange: the name is taken or not allowed. Admins.
    [[nodiscard]] virtual core::Status add(const Login& who, const std::string& name) = 0;
    [[nodiscard]] virtual core::Status rename(const Login& who, ClassId id, const std::string& name) = 0;
    /// Returns the results of all students of a class by lesson. Teachers of the class and admins.
    [[nodiscard]] virtual core::Result<ClassOverview> overview(const Login& who, ClassId id) const = 0;
    /// Returns the results of a class at one lesson. Teachers of the class and admins.
    [[nodiscard]] virtual core::Result<LessonResults> results(const Login& who, ClassId id,
                                                              const std::string& lessonId) const = 0;
    /// Returns the assignments of all classes that the user may access, by due date.
    [[nodiscard]] virtual core::Result<std::vector<ClassAssignment>> assignments(const Login& who) const = 0;
    /// Assigns a lesson to a class, or changes the assignment. ChangedSince: the assignment differs from `before`.
    /// @param before  the assignment as shown to the user; empty: there was none
    /// @param pack    of the version that the assignment names (lessons::packVersion()); empty if it is stored already
    [[nodiscard]] virtual core::Status assign(const Login& who, const ClassAssignment& assignment,
                                              const std::optional<ClassAssignment>& before, const QByteArray& pack) = 0;
    /// Removes an assignment; its attempts stay in the database. ChangedSince as for assign().
    [[nodiscard]] virtual core::Status unassign(const Login& who, const ClassAssignment& before) = 0;
    /// Records in the audit that a report or a table of a class is exported.
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
    /// Replaces the password of a person with a one-time code.
    [[nodiscard]] virtual core::Result<Entered> resetPassword(const Login& who, PersonId person) = 0;
    /// Removes a person's names and login and the texts about them; the attempts stay under a pseudonym. It cannot be
    /// undone. NobodyLeft: as for change(). NotAllowed: the user's own account. ChangedSince: erased already.
    [[nodiscard]] virtual core::Result<ErasedPerson> erase(const Login& who, PersonId person) = 0;
    /// Creates the people of a class list (CSV), all or none of them.
    /// @param isDryRun  returns the outcome without changing anything, and without codes
    /// @param asSeen    the outcome shown to the user. ChangedSince: the import would now have another outcome
    [[nodiscard]] virtual core::Result<RosterOutcome> import(const Login& who, std::string_view csv, bool isDryRun,
                                                             const RosterOutcome& asSeen) = 0;
};

/// A lesson that is assigned to at least one class of the user.
struct AssignedLesson
{
    std::string lessonId;
    std::vector<std::pair<std::string, std::string>> classes;  ///< name and due date (ISO 8601; empty: none) of each
    std::optional<int> attemptsLeft;                           ///< empty: no limit
    /// The version for new attempts (lessons::Lesson::hash); of several classes, the one assigned last. Empty: none was
    /// stored.
    std::string lessonHash = {};
};

/// The user's results, assignments and feedback, for the list of lessons.
struct LessonsOfUser
{
    std::vector<LessonStanding> standings;
    std::vector<AssignedLesson> assigned;  ///< students only
    std::vector<Feedback> feedback;        ///< students only
};

/// The data with which a new grade is compared.
struct GradeContext
{
    std::vector<AttemptRecord> history;  ///< earlier attempts of the user, newest first
    lessons::ClassStanding standing;
    std::optional<int> attemptsLeft;  ///< empty: no limit
};

/// The attempts of a user that are in the database.
struct KnownAttempts
{
    std::set<std::string> usedUp = {};  ///< lessons without an attempt left
    /// Uids of the newest attempts; empty: not known.
    std::optional<std::set<std::string>> kept = {};
};

/// The user's lessons: assignments, results and attempts left.
class LessonRepository
{
public:
    virtual ~LessonRepository() = default;
    [[nodiscard]] virtual core::Result<LessonsOfUser> ofUser(const Login& who) const = 0;
    /// Returns the pack of a version that a class of the user was assigned (lessons/LessonVersion.h). UnknownName: it
    /// was not.
    [[nodiscard]] virtual core::Result<QByteArray> version(const Login& who, const std::string& hash) const = 0;
    /// Returns the number of attempts left at a lesson; empty: no limit.
    [[nodiscard]] virtual core::Result<std::optional<int>> attemptsLeft(const Login& who,
                                                                        const std::string& lessonId) const = 0;
    /// Returns the data with which the grade of `attempt` is compared.
    /// @param historyLength  largest number of earlier attempts: of the same lesson or, without a lesson, at the same
    ///                       tooth
    [[nodiscard]] virtual core::Result<GradeContext> contextOf(const Login& who, const AttemptRecord& attempt,
                                                               int historyLength) const = 0;
    /// @param newest  largest number of attempts to return
    [[nodiscard]] virtual core::Result<KnownAttempts> known(const Login& who, int newest) const = 0;
    /// Returns the score sheets of attempts at exactly this lesson, newest first: the user's own and others they may
    /// read.
    [[nodiscard]] virtual core::Result<std::vector<KeptSheet>>
    sheets(const Login& who, const std::string& lessonId, const std::string& lessonHash, int limit) const = 0;
};

/// Logins and passwords. Most methods hash a password, which takes a fraction of a second.
class LoginRepository
{
public:
    virtual ~LoginRepository() = default;
    /// Logs a person in. Errors WrongLogin, TooSoon and NewPassword as for sql::Logins::login().
    [[nodiscard]] virtual core::Result<Login> login(const std::string& username, const std::string& password) = 0;
    /// Uses up a one-time code and sets the password.
    [[nodiscard]] virtual core::Result<Login> redeem(const std::string& username, const std::string& code,
                                                     const std::string& password) = 0;
    /// Creates the first person of a school, an admin. NotAllowed: the school has people already.
    [[nodiscard]] virtual core::Result<Login> createFirstAdmin(const NewPerson& admin, const std::string& password) = 0;
    [[nodiscard]] virtual core::Status logout(const Login& who) = 0;
    /// Changes the user's password. WrongLogin: `old` is not the current password.
    [[nodiscard]] virtual core::Status changePassword(const Login& who, const std::string& old,
                                                      const std::string& password) = 0;
    /// Returns the hash of the user's password, for unlocking the window while the database cannot be reached.
    [[nodiscard]] virtual core::Result<std::string> ownHash(const Login& who) const = 0;
    /// Returns the user's current role.
    [[nodiscard]] virtual core::Result<Role> role(const Login& who) const = 0;
    /// Raises the cost of password hashes, if the new cost is at least twice the present one. Admins.
    [[nodiscard]] virtual core::Status raiseCost(const Login& who, const PasswordCost& cost) = 0;
};

/// Hardness presets of a school. Its settings kPresetInUse and kRetiredPresets name the preset in use and the retired
/// ones.
class PresetRepository
{
public:
    virtual ~PresetRepository() = default;
    /// Returns all versions of all presets, by name, the newest version of each first.
    [[nodiscard]] virtual core::Result<std::vector<KeptPreset>> list(const Login& who) const = 0;
    /// Saves a version, which never changes afterwards. OutOfRange: the version exists with different contents. Admins.
    [[nodiscard]] virtual core::Status add(const Login& who, const KeptPreset& preset) = 0;
};

/// Settings of a school and of its people.
class SettingsRepository
{
public:
    virtual ~SettingsRepository() = default;
    /// Returns the user's settings and the school's. If both have a setting of the same name, the school's is returned.
    [[nodiscard]] virtual core::Result<SettingsMap> read(const Login& who) const = 0;
    /// Changes a setting of the school. OutOfRange: the value has more than 16,000 characters. Admins.
    /// @param of  changes the setting only if this is its present value; empty: always
    [[nodiscard]] virtual core::Result<ReplacedSetting> replace(const Login& who, const std::string& name,
                                                                const std::string& value,
                                                                const std::optional<std::string>& of) = 0;
    /// Changes a setting of the user. OutOfRange as above.
    [[nodiscard]] virtual core::Status changeOwn(const Login& who, const std::string& name,
                                                 const std::string& value) = 0;
};

/// The audit log: the actions of all users, in a chain of signed rows.
class AuditRepository
{
public:
    virtual ~AuditRepository() = default;
    /// Returns at most `limit` rows before row `beforeSeq` (0: the newest rows), newest first. Admins.
    [[nodiscard]] virtual core::Result<std::vector<AuditRow>> read(const Login& who, int limit, std::int64_t beforeSeq,
                                                                   AuditRows rows) const = 0;
    /// Returns number and hash of the newest row, for reports. All users.
    [[nodiscard]] virtual core::Result<AuditHead> head() const = 0;
};

/// Backups and checks of the whole database. Admins. Both take long: use a separate connection.
class MaintenanceRepository
{
public:
    /// Called repeatedly during the work; returns false to cancel it.
    using GoesOn = std::function<bool()>;

    virtual ~MaintenanceRepository() = default;
    /// Writes a verified backup of the file into a folder, removes the backups that the rotation does not retain, and
    /// records the backup in the audit. Returns the path of the backup.
    [[nodiscard]] virtual core::Result<QString> backUp(const Login& who, const QString& folder, const QDateTime& nowUtc,
                                                       const GoesOn& goesOn) = 0;
    /// Checks the whole database.
    /// @param witnesses  audit codes of printed reports
    [[nodiscard]] virtual core::Result<CheckReport> check(const Login& who, const std::vector<std::string>& witnesses,
                                                          const GoesOn& goesOn) const = 0;
};

/// All repositories of a school, over the connection of this station.
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
