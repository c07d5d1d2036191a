// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <vector>

#include <QByteArray>

#include "core/base/Result.h"
#include "database/AttemptRecord.h"
#include "database/Repositories.h"

namespace app {

/// An attempt whose recording has not been marked again yet, with what that needs from the database.
struct AttemptToCheck
{
    database::AttemptRecord attempt;
    std::optional<QByteArray> recording;  ///< no value: it cannot be read now; empty: none, or damaged
    QByteArray pack;                      ///< of its lesson's version; empty: in the cache, or not assigned
    std::vector<database::ExamStart> starts;
};

/// Returns the newest attempt to check, without its recording if that cannot be read; empty if there is none left.
/// Call it on the thread of the database.
/// @param postponed  ids of attempts to leave out
[[nodiscard]] core::Result<std::optional<AttemptToCheck>>
nextToCheck(const database::Repositories& school, const database::Login& who, const std::set<std::int64_t>& postponed);

/// Replays the recording of an attempt, grades it again and compares, see database::checkAttempt(). Takes as long as
/// the replay. Any thread.
[[nodiscard]] database::Doubt check(const AttemptToCheck& toCheck);
/// Does the same with an attempt from the outbox. Compares the tooth of a scan only if this computer has the assigned
/// version of the lesson in its cache.
[[nodiscard]] database::Doubt checkArriving(const database::AttemptRecord& attempt, const QByteArray& recording);

}  // namespace app
