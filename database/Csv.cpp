// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/Csv.h"

#include <algorithm>

#include "core/base/Bytes.h"

namespace database {
namespace {

using core::ErrorCode;

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

core::Error fault(int line, std::size_t column, const std::string& what)
{
    return {ErrorCode::BadStructure,
            "line " + std::to_string(line) + ", column " + std::to_string(column) + ": " + what};
}

}  // namespace

std::string csvField(std::string_view text)
{
    std::string field(text);
    if (!field.empty() && std::string_view("=+-@\t\r").find(field.front()) != std::string_view::npos)
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

core::Result<std::vector<CsvRow>> readCsv(std::string_view bytes)
{
    if (bytes.size() > kLargestBytes)
        return core::unexpected(ErrorCode::FileTooLarge, "the file is larger than 16 MiB; split it");
    if (bytes.substr(0, kByteOrderMark.size()) == kByteOrderMark)
        bytes.remove_prefix(kByteOrderMark.size());
    if (!core::isUtf8(bytes) || bytes.find('\0') != std::string_view::npos)
        return core::unexpected(ErrorCode::BadStructure,
                                "the file is not UTF-8 text; save it from the spreadsheet as \"CSV UTF-8\"");
    // A spreadsheet's own first line, "sep=;", names the separator and nothing else.
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
        // A spreadsheet writes the rows below the last as separators only.
        const auto isBlank = [](const std::string& text) {
            return text.find_first_not_of(" \t\r") == std::string::npos;
        };
        if (!std::all_of(row.fields.begin(), row.fields.end(), isBlank) && !(isNamed && line == 1))
            rows.push_back(std::move(row));
        row = {line + 1, {}};
    };
    for (std::size_t at = 0; at < bytes.size(); ++at, ++column) {
        // Lines end with \n, \r\n, or as on an old Macintosh with \r.
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
        } else if (c == '\r' && (at + 1 == bytes.size() || bytes[at + 1] == '\n')) {
            // the end of a line, as Windows writes it
        } else if (in == In::AfterQuoted) {
            return tl::unexpected(
                fault(line, column, "words stand behind a closing quote; double quotes within a field"));
        } else if (c == '"' && field.empty()) {
            in = In::Quoted;
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
        return tl::unexpected(fault(quoteLine, quoteColumn, "a quote begins here and is not closed"));
    if (!field.empty() || !row.fields.empty())
        endRow();
    return rows;
}

}  // namespace database
