// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

namespace database {

/// One finished and graded attempt, as it is kept.
struct AttemptRecord
{
    std::int64_t id = 0;      ///< given by the database
    std::string finishedUtc;  ///< ISO 8601, "2026-11-20T10:15:00Z"
    std::string tooth;        ///< FDI number or file name
    int score = 0;            ///< 0 .. 100
    std::int64_t durationMs = 0;
    std::string scoreSheetJson;  ///< the whole explanation, so that an old score stays readable
    std::string stateHash;       ///< 16 hex digits of the tooth's state
    std::string recordingFile;   ///< where the recording lies, empty if it was not saved
    bool operator==(const AttemptRecord&) const = default;
};

}  // namespace database
