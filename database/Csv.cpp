// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/Csv.h"

#include <algorithm>
#include <array>
#include <optional>

#include <QString>

#include "core/base/Bytes.h"

namespace database {
namespace {

constexpr std::size_t kLargestBytes = std::size_t{16} << 20U;
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

char separatorOf(std::string_view firstLine)
{
    char best = ',';
    for (const char candidate : {';', '\t'})
        if (std::count(firstLine.begin(), firstLine.end(), candidate) >
            std::count(firstLine.begin(), firstLine.end(), best))
            best = candidate;
    return best;
}

/// Returns the number of characters, not bytes: continuation bytes are not counted.
std::size_t signsIn(std::string_view text)
{
    constexpr unsigned kMore = 0x80;
    constexpr unsigned kMoreMask = 0xC0;
    return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned>(c) & kMoreMask) != kMore; }));
}

/// Spreadsheets write blanks beside quotes, which do not belong to the field.
bool isBlank(char c)
{
    return c == ' ' || c == '\t';
}

/// In bytes.
constexpr std::size_t kLongestSign = 4;

/// Returns the first place that is not valid text, if there is one.
std::optional<CsvFault> noTextIn(std::string_view bytes)
{
    const auto isText = [](std::string_view part) {
        return core::isUtf8(part) && part.find('\0') == std::string_view::npos;
    };
    for (int line = 1; !bytes.empty(); ++line) {
        const std::string_view present = bytes.substr(0, bytes.find('\n'));
        if (!isText(present)) {
            std::size_t good = 0;
            for (std::size_t end = 1; end <= present.size() && end - good <= kLongestSign; ++end)
                if (isText(present.substr(good, end - good)))
                    good = end;
            return CsvFault{CsvFault::Kind::NoUtf8, line, signsIn(present.substr(0, good)) + 1};
        }
        bytes.remove_prefix(std::min(bytes.size(), present.size() + 1));
    }
    return {};
}

/// Returns whether a spreadsheet would read a text as a formula. Japanese and Chinese ones accept full-width signs too.
bool beginsFormula(std::string_view text)
{
    constexpr std::array<std::string_view, 10> kBeginnings{"=",  "+",      "-",      "@",      "\t",
                                                           "\r", "\uFF1D", "\uFF0B", "\uFF0D", "\uFF20"};
    return std::any_of(kBeginnings.begin(), kBeginnings.end(),
                       [text](std::string_view beginning) { return text.substr(0, beginning.size()) == beginning; });
}

}  // namespace

std::string csvField(std::string_view text)
{
    std::string field(text);
    if (beginsFormula(text))
        field.insert(field.begin(), '\'');
    if (field.find_first_of(",;\"\n\r\t") == std::string::npos)
        return field;
    std::string quoted = "\"";
    for (const char c : field) {
        if (c == '"')
            quoted += '"';
        quoted += c;
    }
    return quoted + '"';
}

tl::expected<std::vector<CsvRow>, CsvFault> readCsv(std::string_view bytes)
{
    if (bytes.size() > kLargestBytes)
        return tl::unexpected(CsvFault{CsvFault::Kind::TooLarge});
    if (bytes.substr(0, kByteOrderMark.size()) == kByteOrderMark)
        bytes.remove_prefix(kByteOrderMark.size());
    if (const auto fault = noTextIn(bytes))
        return tl::unexpected(*fault);
    // The line "sep=;", which some spreadsheets write first, only names the separator.
    constexpr std::string_view kNamed = "sep=";
    const std::string_view first = bytes.substr(0, bytes.find_first_of("\r\n"));
    const bool isNamed = first.size() == kNamed.size() + 1 && first.substr(0, kNamed.size()) == kNamed;
    const char separator = isNamed ? first.back() : separatorOf(first);
    std::vector<CsvRow> rows;
    CsvRow row{1, {}};
    std::string field;
    enum class In { Plain, Quoted, AfterQuoted } in = In::Plain;
    int line = 1;
    std::size_t column = 1;
    int quoteLine = 0;
    std::size_t quoteColumn = 0;
    const auto endField = [&] {
        row.fields.push_back(std::move(field));
        field.clear();
        in = In::Plain;
    };
    const auto endRow = [&] {
        endField();
        // Spreadsheets write empty rows after the last one as separators only.
        const auto isEmpty = [](const std::string& text) {
            return text.find_first_not_of(" \t\r") == std::string::npos;
        };
        if (!std::all_of(row.fields.begin(), row.fields.end(), isEmpty) && !(isNamed && line == 1))
            rows.push_back(std::move(row));
        row = {line + 1, {}};
    };
    for (std::size_t at = 0; at < bytes.size(); ++at, ++column) {
        // Lines end with \n, \r\n or, in files of old Macintosh computers, \r.
        const bool isOldEnd = bytes[at] == '\r' && at + 1 < bytes.size() && bytes[at + 1] != '\n';
        const char c = isOldEnd && in != In::Quoted ? '\n' : bytes[at];
        if (in == In::Quoted) {
            if (c == '"' && at + 1 < bytes.size() && bytes[at + 1] == '"') {
                field += c;
                ++at;
                ++column;
            } else if (c == '"') {
                in = In::AfterQuoted;
            } else {
                field += c;
            }
        } else if (c == separator) {
            endField();
        } else if (c == '\n') {
            endRow();
        } else if ((c == '\r' && (at + 1 == bytes.size() || bytes[at + 1] == '\n')) ||
                   (in == In::AfterQuoted && isBlank(c))) {
            // the end of a line, as Windows writes it; blanks between a closing quote and the separator
        } else if (in == In::AfterQuoted) {
            return tl::unexpected(CsvFault{CsvFault::Kind::AfterQuote, line, column});
        } else if (c == '"' && QString::fromStdString(field).trimmed().isEmpty()) {
            in = In::Quoted;
            field.clear();
            quoteLine = line;
            quoteColumn = column;
        } else {
            field += c;
        }
        if (c == '\n') {
            ++line;
            column = 0;
        }
    }
    if (in == In::Quoted)
        return tl::unexpected(CsvFault{CsvFault::Kind::OpenQuote, quoteLine, quoteColumn});
    if (!field.empty() || !row.fields.empty())
        endRow();
    return rows;
}

}  // namespace database
