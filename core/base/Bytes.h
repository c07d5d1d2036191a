// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

namespace core {

static_assert(std::endian::native == std::endian::little, "recordings are little-endian and read in place");

/// Returns the 64-bit FNV-1a hash of bytes: a checksum against damage, not against forgery.
/// @param hash  the hash of the bytes before these
[[nodiscard]] inline std::uint64_t fnv1a(std::string_view bytes, std::uint64_t hash = 0xCBF29CE484222325ULL)
{
    for (const char byte : bytes) {
        hash ^= static_cast<unsigned char>(byte);
        hash *= 0x100000001B3ULL;
    }
    return hash;
}

/// Returns whether text is well-formed UTF-8: without truncated or overlong sequences, surrogates and code points above
/// U+10FFFF.
[[nodiscard]] inline bool isUtf8(std::string_view text)
{
    for (std::size_t at = 0; at < text.size();) {
        const auto byte = [&](std::size_t n) {
            return at + n < text.size() ? static_cast<unsigned char>(text[at + n]) : 0U;
        };
        const unsigned first = byte(0);
        const std::size_t more = first < 0x80 ? 0 : first < 0xE0 ? 1 : first < 0xF0 ? 2 : 3;
        if (first > 0xF4 || (first >= 0x80 && first < 0xC2))
            return false;
        for (std::size_t n = 1; n <= more; ++n)
            if ((byte(n) & 0xC0U) != 0x80)
                return false;
        if ((first == 0xE0 && byte(1) < 0xA0) || (first == 0xED && byte(1) >= 0xA0) ||
            (first == 0xF0 && byte(1) < 0x90) || (first == 0xF4 && byte(1) >= 0x90))
            return false;
        at += 1 + more;
    }
    return true;
}

/// Appends plain values to a string of bytes.
class ByteWriter
{
public:
    template <class T>
    void put(const T& value)
    {
        static_assert(std::is_arithmetic_v<T>);
        m_bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    void putText(std::string_view text)
    {
        put(static_cast<std::uint32_t>(text.size()));
        m_bytes.append(text);
    }
    template <class T>
    void putAll(std::span<const T> values)
    {
        static_assert(std::is_trivially_copyable_v<T>);
        m_bytes.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
    }
    [[nodiscard]] const std::string& bytes() const { return m_bytes; }

private:
    std::string m_bytes;
};

/// Reads plain values from bytes. Past the end it returns zeros; check ok() once, after the last value.
class ByteReader
{
public:
    explicit ByteReader(std::string_view bytes) : m_bytes(bytes) {}

    template <class T>
    T take()
    {
        static_assert(std::is_arithmetic_v<T>);
        T value{};
        const std::string_view from = takeBytes(sizeof value);
        if (from.size() == sizeof value)
            std::memcpy(&value, from.data(), sizeof value);
        return value;
    }
    [[nodiscard]] std::string takeText() { return std::string(takeBytes(take<std::uint32_t>())); }
    template <class T>
    void takeAll(std::span<T> values)
    {
        static_assert(std::is_trivially_copyable_v<T>);
        const std::string_view from = takeBytes(values.size_bytes());
        if (!from.empty())
            std::memcpy(static_cast<void*>(values.data()), from.data(), from.size());
    }
    /// Returns the next bytes. If fewer are left, returns an empty view and sets ok() to false.
    [[nodiscard]] std::string_view takeBytes(std::size_t count)
    {
        if (count > m_bytes.size()) {
            m_ok = false;
            m_bytes = {};
            return {};
        }
        const std::string_view from = m_bytes.substr(0, count);
        m_bytes.remove_prefix(count);
        return from;
    }
    [[nodiscard]] bool ok() const { return m_ok; }
    [[nodiscard]] std::size_t left() const { return m_bytes.size(); }

private:
    std::string_view m_bytes;
    bool m_ok = true;
};

}  // namespace core
