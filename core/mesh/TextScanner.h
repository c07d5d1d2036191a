// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <charconv>
#include <cmath>
#include <cstddef>
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

/// Parses a whole word as a finite float; empty for "nan", "inf", "1e99" or "1.5x".
[[nodiscard]] inline std::optional<float> finiteNumber(std::string_view word)
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
    const auto number = static_cast<float>(value);
    return std::isfinite(number) ? std::optional(number) : std::nullopt;
}

/// Iterates over the lines of a text. Lines end with LF or CR LF, or with CR in a text without LF.
class Lines
{
public:
    explicit Lines(std::string_view text) : m_rest(text), m_end(text.find('\n') == std::string_view::npos ? '\r' : '\n')
    {}

    [[nodiscard]] bool next(std::string_view& line)
    {
        if (m_rest.empty())
            return false;
        const std::size_t end = m_rest.find(m_end);
        line = m_rest.substr(0, end);
        m_rest.remove_prefix(end == std::string_view::npos ? m_rest.size() : end + 1);
        if (line.ends_with('\r'))
            line.remove_suffix(1);
        ++m_number;
        return true;
    }
    [[nodiscard]] std::size_t number() const { return m_number; }  ///< of the line last given, from 1

private:
    std::string_view m_rest;
    char m_end;
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

}  // namespace core::mesh
