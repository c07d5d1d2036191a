// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <QByteArray>

#include "database/AttemptRecord.h"
#include "database/sql/DatabaseContext.h"
#include "lessons/ClassStanding.h"

namespace database::sql {

/// Keeps an attempt with its recording (empty: none), on the disk when this returns. Exactly once: one with a uid that
/// is kept already is that one, and its id is returned. It comes from this station's outbox, which vouches for whose it
/// is (record.personUid): he may have logged out, or been disabled, meanwhile.
[[nodiscard]] core::Result<AttemptId> deliverAttempt(const DatabaseContext& school, const AttemptRecord& attempt,
                                                     const QByteArray& recording);

/// The last attempts of a person, newest first, without their score sheets. `attempts` 0: as many as there are.
struct HistoryQuery
{
    std::string lessonId;  ///< empty: of any lesson
    std::string tooth;     ///< not empty: practice without a lesson, at this tooth
    int limit = 0;
};
[[nodiscard]] core::Result<std::vector<AttemptRecord>> history(const DatabaseContext& school, const Login& session,
                                                               PersonId person, const HistoryQuery& query);

/// Every lesson that a person ever attempted, by its id.
[[nodiscard]] core::Result<std::vector<LessonStanding>> standingsOf(const DatabaseContext& school, const Login& session,
                                                                    PersonId person);

/// One attempt with all there is of it. UnknownName where there is none.
[[nodiscard]] core::Result<AttemptRecord> openAttempt(const DatabaseContext& school, const Login& session,
                                                      AttemptId id);
/// Its recording; FileMissing where none was kept.
[[nodiscard]] core::Result<QByteArray> openRecording(const DatabaseContext& school, const Login& session, AttemptId id);

/// What is kept of attempts at exactly this lesson, newest first: the session's person's own, and those within his
/// reach.
struct KeptSheet
{
    std::string finishedUtc;
    std::string json;
};
[[nodiscard]] core::Result<std::vector<KeptSheet>> sheetsOfLesson(const DatabaseContext& school, const Login& session,
                                                                  const std::string& lessonId,
                                                                  const std::string& lessonHash, int limit);

/// Returns the SQL for the input device by which attempts are compared, from the column that stores it. Before mouse,
/// pen, keyboard and gamepad were told apart, nearly everybody used a mouse: "pointer" counts as one.
[[nodiscard]] QString comparedDevice(const QString& column);

/// Where a score, in tenths of a point, stands among each classmate's best of a lesson by that rubric and with the same
/// input device, the session's own among them; without a class it is alone. Classmates are the students who can log in
/// and are in a class with him at present.
/// @param device  as AttemptRecord::device
[[nodiscard]] core::Result<lessons::ClassStanding>
standingAmongClassmates(const DatabaseContext& school, const Login& session, const std::string& lessonId,
                        const std::string& rubricHash, const std::string& device, int tenths);

/// The machine's score stays; this one counts. Nothing: the machine's counts again.
/// ChangedSince: there are not as many as `before` says.
/// @param before  so many were given so far, as whoever gives this one has seen it; nothing: however many
[[nodiscard]] core::Status overrideScore(const DatabaseContext& school, const Login& session, AttemptId id,
                                         std::optional<int> tenths, const std::string& reason,
                                         std::optional<std::size_t> before = {});

struct NewComment
{
    std::string words;
    std::optional<std::array<double, 3>> placeMm;  ///< in the tooth's frame
    std::optional<std::int64_t> momentMs;          ///< since the attempt began
};
[[nodiscard]] core::Result<std::int64_t> addComment(const DatabaseContext& school, const Login& session, AttemptId id,
                                                    const NewComment& comment);
/// One's own: nobody is shown it any more, and its words stay in the database. ChangedSince: that is done already.
[[nodiscard]] core::Status withdrawComment(const DatabaseContext& school, const Login& session, std::int64_t comment);

/// Every attempt of a person, with its score sheet, and what the audit noted when it was kept (JSON; empty: nothing).
/// For who checks or copies the database; asks nobody's leave.
[[nodiscard]] core::Status
forEachAttempt(const QSqlDatabase& db,
               const std::function<void(const AttemptRecord& attempt, const std::string& noted)>& take);

/// What the audit says of an attempt when it is kept: a hash of everything in it that never changes.
[[nodiscard]] std::string digestOfAttempt(const AttemptRecord& attempt);

/// The same of what a teacher said, as its row holds it: of a comment words, x_um, y_um, z_um, moment_ms, written_utc;
/// of another score reason, given_utc.
[[nodiscard]] std::string digestOfComment(const QVariantList& row);

}  // namespace database::sql
