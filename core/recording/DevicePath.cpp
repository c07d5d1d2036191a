// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recording/DevicePath.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <string>

namespace core::recording {
namespace {

constexpr std::array<std::string_view, 5> kColumns{"t_s", "x_mm", "y_mm", "z_mm", "drill"};
constexpr std::size_t kDrillColumn = 4;
constexpr std::uintmax_t kMaxFileBytes = std::uintmax_t{256} * 1024 * 1024;
constexpr std::size_t kMaxLineBytes = 1024 * 1024;

std::string_view trimmed(std::string_view text)
{
    const auto isBlank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
    while (!text.empty() && isBlank(text.front()))
        text.remove_prefix(1);
    while (!text.empty() && isBlank(text.back()))
        text.remove_suffix(1);
    return text;
}

/// Removes the text up to the next separator, and the separator, and returns the text.
std::string_view takeUntil(std::string_view& text, char separator)
{
    const std::size_t end = text.find(separator);
    const std::string_view part = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    return part;
}

/// Removes one cell of a row and returns it without surrounding blanks. A quoted cell may contain commas.
std::string_view takeCell(std::string_view& row)
{
    row = trimmed(row);
    if (row.empty() || row.front() != '"')
        return trimmed(takeUntil(row, ','));
    row.remove_prefix(1);
    const std::string_view cell = takeUntil(row, '"');
    takeUntil(row, ',');
    return trimmed(cell);
}

std::optional<double> numberIn(std::string_view cell)
{
    if (cell.size() > 1 && cell[0] == '+' && cell[1] != '-')
        cell.remove_prefix(1);
    double value = 0.0;
    const auto [end, failure] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (failure != std::errc{} || end != cell.data() + cell.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

tl::unexpected<Error> wrong(ErrorCode code, std::size_t line, const std::string& what)
{
    return unexpected(code, "Line " + std::to_string(line) + " of the device path: " + what);
}

std::string shown(std::string_view cell)
{
    std::string text;
    for (const char c : cell.substr(0, 40))
        text += c >= ' ' && c <= '~' ? c : '?';
    return "'" + text + "'";
}

/// Parses a text that arrives in pieces, which may end anywhere.
class PathParser
{
public:
    explicit PathParser(bool needDrill) : m_needDrill(needDrill) { m_place.fill(-1); }

    Status take(std::string_view text)
    {
        while (!text.empty()) {
            const std::size_t end = text.find_first_of("\r\n");
            m_line.append(text.substr(0, end));
            if (m_line.size() > kMaxLineBytes)
                return wrong(ErrorCode::WrongKind, m_number + 1, "it is longer than a megabyte; save the path as CSV.");
            if (end == std::string_view::npos)
                break;
            const bool secondOfPair = text[end] == '\n' && m_lastWasReturn && m_line.empty();
            m_lastWasReturn = text[end] == '\r' && end + 1 >= text.size();
            if (text[end] == '\r' && end + 1 < text.size() && text[end + 1] == '\n')
                text.remove_prefix(1);
            text.remove_prefix(end + 1);
            if (secondOfPair)
                continue;
            if (Status status = endLine(); !status)
                return status;
        }
        return {};
    }

    Result<DevicePath> finish()
    {
        if (Status status = endLine(); !status)
            return tl::unexpected(std::move(status).error());
        if (m_columns == 0)
            return unexpected(ErrorCode::FileEmpty,
                              "The device path is empty; it needs a header line t_s,x_mm,y_mm,z_mm,drill and rows.");
        if (m_path.points.empty())
            return unexpected(ErrorCode::BadStructure, "The device path has a header but no rows; add at least one.");
        if (m_path.durationS() > 86400.0)
            return unexpected(ErrorCode::OutOfRange,
                              "The device path lasts more than a day; check the unit of t_s (seconds).");
        return std::move(m_path);
    }

private:
    Status endLine()
    {
        std::string_view line = m_line;
        ++m_number;
        if (m_number == 1 && line.starts_with("\xEF\xBB\xBF"))
            line.remove_prefix(3);
        if (line.find('\0') != std::string_view::npos)
            return unexpected(ErrorCode::WrongKind, "The device path is not text (UTF-8 or ASCII); save it as CSV.");
        Status status;
        if (!trimmed(line).empty())
            status = m_columns == 0 ? takeHeader(line) : takeRow(line);
        m_line.clear();
        return status;
    }

    Status takeHeader(std::string_view header)
    {
        for (; !header.empty(); ++m_columns) {
            const std::string_view name = takeCell(header);
            for (std::size_t c = 0; c < kColumns.size(); ++c) {
                if (name != kColumns[c])
                    continue;
                if (m_place[c] >= 0)
                    return unexpected(ErrorCode::BadStructure, "The device path has two columns " +
                                                                   std::string(kColumns[c]) + "; keep one of them.");
                m_place[c] = m_columns;
            }
        }
        for (std::size_t c = 0; c < kColumns.size(); ++c)
            if (m_place[c] < 0 && (c != kDrillColumn || m_needDrill))
                return unexpected(ErrorCode::BadStructure, "The device path has no column " + std::string(kColumns[c]) +
                                                               "; its first line must name t_s,x_mm,y_mm,z_mm,drill.");
        return {};
    }

    Status takeRow(std::string_view row)
    {
        std::array<double, kColumns.size()> value{};
        unsigned found = 0;
        for (int column = 0; !row.empty(); ++column) {
            const std::string_view cell = takeCell(row);
            if (column >= m_columns && !cell.empty())
                return wrong(ErrorCode::BadStructure, m_number,
                             "it has more cells than the header; write decimals with a point.");
            for (std::size_t c = 0; c < kColumns.size(); ++c) {
                if (m_place[c] != column)
                    continue;
                const auto number = numberIn(cell);
                if (!number)
                    return wrong(ErrorCode::BadNumber, m_number,
                                 shown(cell) + " in column " + std::string(kColumns[c]) + " is not a number.");
                value[c] = *number;
                found |= 1U << c;
            }
        }
        for (std::size_t c = 0; c < kColumns.size(); ++c)
            if (m_place[c] >= 0 && (found & (1U << c)) == 0)
                return wrong(ErrorCode::BadStructure, m_number, "column " + std::string(kColumns[c]) + " is missing.");
        for (std::size_t c = 1; c < kDrillColumn; ++c)
            if (std::abs(value[c]) > kMaxPathMm)
                return wrong(ErrorCode::OutOfRange, m_number,
                             std::string(kColumns[c]) + " is more than a metre from the tooth.");
        if (value[kDrillColumn] != 0.0 && value[kDrillColumn] != 1.0)
            return wrong(ErrorCode::OutOfRange, m_number, "drill must be 0 or 1.");
        std::deque<PathPoint>& points = m_path.points;
        if (!points.empty() && value[0] <= points.back().timeS)
            return wrong(ErrorCode::BadStructure, m_number,
                         value[0] == points.back().timeS ? "t_s stands still; each row needs a later time."
                                                         : "t_s goes backwards; each row needs a later time.");
        if (points.size() == kMaxPathPoints)
            return wrong(ErrorCode::FileTooLarge, m_number, "the path has more than 5 million points; split it.");
        points.push_back({value[0], {value[1], value[2], value[3]}, value[kDrillColumn] == 1.0});
        return {};
    }

    bool m_needDrill;
    std::array<int, kColumns.size()> m_place{};  ///< column of the file for each of our columns; -1: none
    int m_columns = 0;                           ///< of the header; 0 before it is read
    std::string m_line;                          ///< the line that has not ended yet
    std::size_t m_number = 0;                    ///< number of complete lines
    bool m_lastWasReturn = false;                ///< the last piece ended with CR: an LF may follow
    DevicePath m_path;
};

}  // namespace

std::uint64_t DevicePath::ticks(double rateHz) const
{
    // Rounding of its times must not remove the last tick of a path recorded at this rate.
    return static_cast<std::uint64_t>(std::floor(durationS() * rateHz + 1.0e-6)) + 1;
}

PathPoint PathCursor::at(double timeS) noexcept
{
    const std::deque<PathPoint>& points = m_path.points;
    const double time = points.front().timeS + timeS;
    while (m_segment + 1 < points.size() && points[m_segment + 1].timeS <= time)
        ++m_segment;
    const PathPoint& from = points[m_segment];
    if (m_segment + 1 == points.size() || time <= from.timeS)
        return {time, from.tipMm, from.drill};
    const PathPoint& to = points[m_segment + 1];
    const double share = (time - from.timeS) / (to.timeS - from.timeS);
    return {time, from.tipMm + (to.tipMm - from.tipMm) * share, from.drill};
}

Result<DevicePath> parseDevicePath(std::string_view text, bool needDrill)
{
    PathParser parser(needDrill);
    Status status = parser.take(text);
    return status ? parser.finish() : tl::unexpected(std::move(status).error());
}

Result<DevicePath> readDevicePath(const std::filesystem::path& path, bool needDrill)
{
    std::error_code failure;
    const auto status = std::filesystem::status(path, failure);
    if (!std::filesystem::exists(status))
        return unexpected(ErrorCode::FileMissing, "There is no device path at " + path.string() + "; check the name.");
    if (std::filesystem::is_directory(status))
        return unexpected(ErrorCode::FileUnreadable, path.string() + " is a folder; name a CSV file in it.");
    if (!std::filesystem::is_regular_file(status))
        return unexpected(ErrorCode::FileUnreadable, path.string() + " is not a file; name a CSV file.");
    if (std::filesystem::file_size(path, failure) > kMaxFileBytes)
        return unexpected(ErrorCode::FileTooLarge, path.string() + " is larger than any device path; split it.");
    std::ifstream file(path, std::ios::binary);
    PathParser parser(needDrill);
    Status taken;
    std::array<char, 65536> block{};
    while (taken && (file.read(block.data(), block.size()), file.gcount() > 0))
        taken = parser.take({block.data(), static_cast<std::size_t>(file.gcount())});
    if (taken && !file.eof())
        return unexpected(ErrorCode::FileUnreadable, path.string() + " cannot be read; check its rights.");
    auto parsed = taken ? parser.finish() : tl::unexpected(std::move(taken).error());
    if (!parsed)
        return unexpected(parsed.error().code, path.string() + ": " + parsed.error().detail);
    return parsed;
}

}  // namespace core::recording
