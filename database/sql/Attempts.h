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
/// uid is stored already, returns its id and changes nothing. The outbox of this station vouches for the person
/// (attempt.personUid), who may have logged out or been disabled meanwhile.
[[nodiscard]] core::Result<AttemptId> deliverAttempt(const DatabaseContext& school, const AttemptRecord& attempt,
                                                     const QByteArray& recording);

/// The last attempts of a person, newest first, without their score sheets.
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

/// Returns the SQL for the input device by which attempts are compared, from the column that stores it. In old
/// attempts, "pointer" stands for mouse, pen, keyboard and gamepad; nearly all used a mouse, so it counts as one.
[[nodiscard]] QString comparedDevice(const QString& column);

/// Returns the rank of a score, in tenths of a point, among the best scores of the user's classmates in a lesson, by
/// the same rubric and with the same input device, including the user's own; without a class it is the only one.
/// Classmates are the students who can log in and are currently in one of the user's classes.
/// @param device  as AttemptRecord::device
[[nodiscard]] core::Result<lessons::ClassStanding>
standingAmongClassmates(const DatabaseContext& school, const Login& session, const std::string& lessonId,
                        const std::string& rubricHash, const std::string& device, int tenths);

/// Sets the score that counts in place of the computed one, which is kept. ChangedSince: the number of given scores is
/// not `before`.
/// @param before  number of scores given so far, as the user has seen it; empty: not checked
[[nodiscard]] core::Status overrideScore(const DatabaseContext& school, const Login& session, AttemptId id,
                                         std::optional<int> tenths, const std::string& reason,
                                         std::optional<std::size_t> before = {});

[[nodiscard]] core::Result<std::int64_t> addComment(const DatabaseContext& school, const Login& session, AttemptId id,
                                                    const NewComment& comment);
/// Withdraws the user's own comment: it is no longer shown, but stays in the database. ChangedSince: it is withdrawn
/// already.
[[nodiscard]] core::Status withdrawComment(const DatabaseContext& school, const Login& session, std::int64_t comment);

/// Calls `take` for every attempt of a person, with its score sheet and the audit's note when it was stored (JSON;
/// empty: none). For checking and copying the database; without a permission check.
[[nodiscard]] core::Status
forEachAttempt(const QSqlDatabase& db,
               const std::function<void(const AttemptRecord& attempt, const std::string& noted)>& take);

/// Returns the audit's digest of an attempt: a hash of all its fields that never change.
[[nodiscard]] std::string digestOfAttempt(const AttemptRecord& attempt);

/// Returns the digest of what a teacher wrote, from its row: of a comment words, x_um, y_um, z_um, moment_ms,
/// written_utc; of a given score reason, given_utc.
[[nodiscard]] std::string digestOfComment(const QVariantList& row);

}  // namespace database::sql
