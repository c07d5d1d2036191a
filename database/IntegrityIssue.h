// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <QString>

namespace database {

/// An issue that a check of a database found: a sentence and, separately, its values, so that a window can translate
/// it.
struct IntegrityIssue
{
    /// English, with "%1" for the first value; marked for translation in the context "Finding".
    const char* words = "";
    /// As stored: "attempt:1f...", "class:5", "attempt.add", "2026-11-20T10:15:00Z".
    std::vector<std::string> values;

    [[nodiscard]] QString english() const;
};

inline constexpr std::size_t kMostFindings = 100;

/// The result of a check of everything in a database.
struct CheckReport
{
    std::vector<IntegrityIssue> findings;  ///< empty: the database is sound
    std::vector<IntegrityIssue> notes;     ///< how to read the findings
    std::int64_t attempts = 0;
    std::int64_t auditRows = 0;
    std::string auditCode;                     ///< of the newest row, as reports show it
    std::string signedBy;                      ///< key of the station that wrote that row, 64 hex digits
    bool isStopped = false;                    ///< the check was stopped before its end
    bool isWhole = true;                       ///< false: a part could not be checked, as the last finding says
    std::size_t mostFindings = kMostFindings;  ///< further findings are left out
};

}  // namespace database
