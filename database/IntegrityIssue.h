// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

}  // namespace database
