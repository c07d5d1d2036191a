// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/Result.h"

namespace database {

/// A field of a CSV line as RFC 4180 has it, quoted where it must be. What a spreadsheet would run as a formula gets an
/// apostrophe before it.
[[nodiscard]] std::string csvField(std::string_view text);

/// Fields of one line, with where it stands in the file.
struct CsvRow
{
    int line = 0;  ///< from 1
    std::vector<std::string> fields;
};

/// Why a file cannot be read as CSV, and where: from 1, the sign within its line.
struct CsvFault
{
    enum class Kind {
        TooLarge,   ///< over 16 MiB, wherever
        NoUtf8,     ///< from here on
        OpenQuote,  ///< begins here and is not closed
        AfterQuote  ///< words stand behind a closing quote
    };
    Kind kind = Kind::NoUtf8;
    int line = 1;
    std::size_t sign = 1;
};

/// Reads CSV in UTF-8, with or without a byte order mark; the separator is whichever of comma, semicolon and tab the
/// first line has most of, or the one that a line "sep=;" before it names. Empty lines, and those of separators only,
/// are left out.
[[nodiscard]] tl::expected<std::vector<CsvRow>, CsvFault> readCsv(std::string_view bytes);

}  // namespace database
