// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace database {

/// Why an attempt does not count until a teacher gives it a score.
enum class Doubt : std::uint8_t {
    None,       ///< it counts
    Version,    ///< it was made with another version of the lesson than those that were assigned: it is practice
    Recording,  ///< it has no recording, or one that is damaged or of another lesson, tooth, attempt or person
    Score,      ///< its recording, marked again, gives another result
    Start,      ///< the school has no start of the exam that fits the recording
};

/// Returns the name by which the database stores a doubt; empty for Doubt::None.
[[nodiscard]] std::string doubtId(Doubt doubt);
/// Returns the doubt of that name. A name from a newer program counts as Doubt::Score.
[[nodiscard]] Doubt doubtNamed(std::string_view id);

}  // namespace database
