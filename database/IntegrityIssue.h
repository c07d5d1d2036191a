// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <QString>

namespace database {

/// What a check of a database found: a sentence, and apart from it what it is about, so that a window can say both in
/// its own language.
struct IntegrityIssue
{
    /// English, with "%1" for the first of the values; marked for translation in the context "Finding".
    const char* words = "";
    /// As they are noted: "attempt:1f...", "class:5", "attempt.add", "2026-11-20T10:15:00Z".
    std::vector<std::string> values;

    [[nodiscard]] QString english() const;
};

}  // namespace database
