// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

/// Functions shared by the text readers. None depends on the locale.
namespace core::mesh {

[[nodiscard]] inline bool isBlank(char c)
{
    return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

/// Removes the first word from the line and returns it; empty if there is none.
[[nodiscard]] inline std::string_view takeWord(std::string_view& line)
{
    std::size_t begin = 0;
    while (begin < line.size() && isBlank(line[begin]))
        ++begin;
    std::size_t end = begin;
    while (end < line.size() && !isBlank(line[end]))
        ++end;
    const std::string_view word = line.substr(begin, end - begin);
    line.remove_prefix(end);
    return word;
}

/// Returns whether texts are equal, ignoring the case of ASCII letters; `lower` must be in lower case.
[[nodiscard]] inline bool equalsIgnoringCase(std::string_view text, std::string_view lower)
{
    if (text.size() != lower.size())
        return false;
    for (std::size_t k = 0; k < text.size(); ++k) {
        const char c = text[k];
        if ((c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c) != lower[k])
            return false;
    }
    return true;
}

/// Parses a whole word as a number that a float can hold; empty for "nan", "inf", "1e99" or "1.5x".
[[nodiscard]] inline std::optional<double> finiteNumber(std::string_view word)
{
    if (word.starts_with('+'))
        word.remove_prefix(1);
    double value = 0.0;
    const char* const end = word.data() + word.size();
    const auto [stop, failure] = std::from_chars(word.data(), end, value);
    if (stop != end || word.empty())
        return std::nullopt;
    if (failure == std::errc::result_out_of_range) {
        // A number that is too small becomes zero, and one that is too large is refused. from_chars reports both in the
        // same way.
        if (word.find("e-") == std::string_view::npos && word.find("E-") == std::string_view::npos)
            return std::nullopt;
        value = 0.0;
    } else if (failure != std::errc()) {
        return std::nullopt;
    }
    return std::abs(value) <= static_cast<double>(std::numeric_limits<float>::max()) ? std::optional(value)
                                                                                     : std::nullopt;
}

/// Iterates over the lines of a text. Lines end with LF, CR LF or CR, also mixed in one file.
class Lines
{
public:
    explicit Lines(std::string_view text) : m_text(text) {}

    [[nodiscard]] bool next(std::string_view& line)
    {
        if (m_at >= m_text.size())
            return false;
        // Each byte is searched for LF once, so that a file with CR alone does not take quadratic time.
        if (m_lineFeed < m_at || !m_hasSearched) {
            m_lineFeed = std::min(m_text.find('\n', m_at), m_text.size());
            m_hasSearched = true;
        }
        const std::string_view upToFeed = m_text.substr(m_at, m_lineFeed - m_at);
        const std::size_t end = std::min(upToFeed.find('\r'), upToFeed.size());
        line = upToFeed.substr(0, end);
        m_at += end + 1;
        if (end < upToFeed.size() && m_at == m_lineFeed)  // CR LF
            ++m_at;
        ++m_number;
        return true;
    }
    [[nodiscard]] std::size_t number() const { return m_number; }  ///< of the line last given, from 1
    [[nodiscard]] std::size_t at() const { return m_at; }          ///< index of the first byte of the next line

private:
    std::string_view m_text;
    std::size_t m_at = 0;
    std::size_t m_lineFeed = 0;  ///< index of the next LF, or the size of the text
    bool m_hasSearched = false;
    std::size_t m_number = 0;
};

/// Returns the text after a UTF-8 byte order mark, if there is one.
[[nodiscard]] inline std::string_view withoutMark(std::string_view text)
{
    return text.starts_with("\xEF\xBB\xBF") ? text.substr(3) : text;
}

/// Returns a word of the file for a message: short, printable ASCII.
[[nodiscard]] inline std::string quoted(std::string_view word)
{
    std::string text = "\"";
    for (const char c : word.substr(0, 24))
        text += c >= ' ' && c < '\x7f' ? c : '?';
    return text + (word.size() > 24 ? "...\"" : "\"");
}

/// Returns why a word cannot be a coordinate: "the coordinate "1,5" has a decimal comma, ...".
[[nodiscard]] inline std::string whyNoCoordinate(std::string_view word)
{
    std::string text = "the coordinate " + quoted(word);
    std::string withPoint(word.substr(0, 64));
    const std::size_t comma = withPoint.find(',');
    if (comma != std::string::npos) {
        withPoint[comma] = '.';
        if (finiteNumber(withPoint))
            return text + " has a decimal comma; let the program that wrote it use decimal points";
    }
    return text + " is not a finite number";
}

}  // namespace core::mesh
