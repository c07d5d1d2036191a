// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <QString>

namespace database {

/// An issue that a check of a database found: a sentence and its values. They are separate so that the window can
/// translate the sentence.
struct IntegrityIssue
{
    /// English, with "%1" for the first value; marked for translation in the context "Finding".
    const char* words = "";
    /// The values as stored: "attempt:1f...", "class:5", "attempt.add", "2026-11-20T10:15:00Z".
    std::vector<std::string> values;

    [[nodiscard]] QString english() const;
};

inline constexpr std::size_t kMostFindings = 100;

/// The result of a check of everything in a database.
struct CheckReport
{
    std::vector<IntegrityIssue> findings;  ///< empty: the check found no issue
    std::vector<IntegrityIssue> notes;     ///< remarks on how to read the findings
    std::int64_t attempts = 0;
    std::int64_t auditRows = 0;
    std::string auditCode;                     ///< of the newest row, as reports show it
    std::string signedBy;                      ///< key of the station that wrote that row, 64 hex digits
    bool isStopped = false;                    ///< the check was stopped before its end
    bool isWhole = true;                       ///< false: a part could not be checked; the last finding names it
    std::size_t mostFindings = kMostFindings;  ///< further findings are left out
};

}  // namespace database
