// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <QByteArray>

#include "database/AttemptRecord.h"
#include "database/ClassOverview.h"
#include "database/sql/DatabaseContext.h"
#include "lessons/ClassStanding.h"

namespace database::sql {

using database::HistoryQuery;
using database::NewComment;

/// Stores an attempt with its recording (empty: none); both are on the disk when this returns. If an attempt with this
/// uid is stored already, returns its id and changes nothing. The person is attempt.personUid, as the outbox of this
/// station signed it: they may have logged out, or been disabled, since the attempt.
[[nodiscard]] core::Result<AttemptId> deliverAttempt(const DatabaseContext& school, const AttemptRecord& attempt,
                                                     const QByteArray& recording);

/// Returns the last attempts of a person, newest first, without their score sheets.
[[nodiscard]] core::Result<std::vector<AttemptRecord>> history(const DatabaseContext& school, const Login& session,
                                                               PersonId person, const HistoryQuery& query);

/// Returns the standing in every lesson that a person has attempted.
[[nodiscard]] core::Result<std::vector<LessonStanding>> standingsOf(const DatabaseContext& school, const Login& session,
                                                                    PersonId person);

/// Returns one attempt with all its data. UnknownName if there is none.
[[nodiscard]] core::Result<AttemptRecord> openAttempt(const DatabaseContext& school, const Login& session,
                                                      AttemptId id);
/// Returns the recording of an attempt; FileMissing if none was stored.
[[nodiscard]] core::Result<QByteArray> openRecording(const DatabaseContext& school, const Login& session, AttemptId id);

/// Returns the score sheets of attempts at exactly this lesson, newest first: the user's own, and those that the user
/// may read.
[[nodiscard]] core::Result<std::vector<KeptSheet>> sheetsOfLesson(const DatabaseContext& school, const Login& session,
                                                                  const std::string& lessonId,
                                                                  const std::string& lessonHash, int limit);

/// Returns the SQL for the input device by which attempts are compared, from the column that stores it. In old attempts
/// "pointer" stands for mouse, pen, keyboard and gamepad. It counts as a mouse, because nearly all of them used one.
[[nodiscard]] QString comparedDevice(const QString& column);

/// Returns the rank of a score, in tenths of a point, among the best scores of the user's classmates in a lesson, by
/// the same rubric and with the same input device. The user's own best score counts as well; without a class it is the
/// only one. Classmates are the students who can log in and are currently in one of the user's classes.
/// @param device  as AttemptRecord::device
[[nodiscard]] core::Result<lessons::ClassStanding>
standingAmongClassmates(const DatabaseContext& school, const Login& session, const std::string& lessonId,
                        const std::string& rubricHash, const std::string& device, int tenths);

/// Overrides the computed score, which stays in the database. ChangedSince: the number of overrides is not `before`.
/// @param before  number of overrides that the user has seen; empty: not checked
[[nodiscard]] core::Status overrideScore(const DatabaseContext& school, const Login& session, AttemptId id,
                                         std::optional<int> tenths, const std::string& reason,
                                         std::optional<std::size_t> before = {});

[[nodiscard]] core::Result<std::int64_t> addComment(const DatabaseContext& school, const Login& session, AttemptId id,
                                                    const NewComment& comment);
/// Withdraws the user's own comment: it is no longer shown, but stays in the database. ChangedSince: it is withdrawn
/// already.
[[nodiscard]] core::Status withdrawComment(const DatabaseContext& school, const Login& session, std::int64_t comment);

/// Calls `take` for every attempt of a person, with its score sheet and the detail of its audit row (JSON; empty: there
/// is no such row). For checking and copying the database. Does not check permissions.
[[nodiscard]] core::Status
forEachAttempt(const QSqlDatabase& db,
               const std::function<void(const AttemptRecord& attempt, const std::string& noted)>& take);

/// Returns the audit's digest of an attempt: a hash of all its fields that never change.
[[nodiscard]] std::string digestOfAttempt(const AttemptRecord& attempt);

/// Returns the audit's digest of a text that a teacher wrote, from its row. Columns of a comment: words, x_um, y_um,
/// z_um, moment_ms, written_utc. Columns of an override: reason, given_utc.
[[nodiscard]] std::string digestOfComment(const QVariantList& row);

}  // namespace database::sql
