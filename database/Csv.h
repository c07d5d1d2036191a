// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/Result.h"

namespace database {

/// Returns a field of a CSV line as in RFC 4180, quoted if necessary. Text that a spreadsheet would run as a formula
/// gets an apostrophe in front.
[[nodiscard]] std::string csvField(std::string_view text);

/// The fields of one line, with its number.
struct CsvRow
{
    int line = 0;  ///< from 1
    std::vector<std::string> fields;
};

/// The reason why a file cannot be read as CSV, and the place: line and character from 1.
struct CsvFault
{
    enum class Kind {
        TooLarge,   ///< over 16 MiB; without a place
        NoUtf8,     ///< not UTF-8 from here on
        OpenQuote,  ///< a quote that begins here is not closed
        AfterQuote  ///< text follows a closing quote
    };
    Kind kind = Kind::NoUtf8;
    int line = 1;
    std::size_t sign = 1;
};

/// Reads CSV in UTF-8, with or without a byte order mark. The separator is the most frequent of comma, semicolon and
/// tab in the first line, or the one given by a first line "sep=;". Skips empty lines and lines of separators only.
[[nodiscard]] tl::expected<std::vector<CsvRow>, CsvFault> readCsv(std::string_view bytes);

}  // namespace database
