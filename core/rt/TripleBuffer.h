// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace core::rt {

/// The newest value from one writer thread to one reader thread. Neither ever waits; older values are dropped.
///
/// Three slots: one for the writer, one for the reader, one between. The index of the middle slot and a "fresh" bit are
/// in one atomic byte, so that publishing and reading are one exchange each.
template <class T>
class TripleBuffer
{
public:
    TripleBuffer() = default;
    explicit TripleBuffer(const T& value) : m_slots{value, value, value} {}

    /// Writer: returns the slot to fill. It contains some older value, not the one published last.
    [[nodiscard]] T& back() noexcept { return m_slots[m_back]; }

    /// Writer: publishes back() after it was filled.
    void publish() noexcept
    {
        const auto fresh = static_cast<std::uint8_t>(m_back | kFresh);
        m_back = m_middle.exchange(fresh, std::memory_order_acq_rel) & kIndex;
    }

    /// Writer: fills and publishes.
    void publish(const T& value) noexcept
    {
        back() = value;
        publish();
    }

    /// Reader: returns the newest published value; the reference is valid until the next call.
    [[nodiscard]] const T& latest() noexcept
    {
        if ((m_middle.load(std::memory_order_relaxed) & kFresh) != 0)
            m_front = m_middle.exchange(m_front, std::memory_order_acq_rel) & kIndex;
        return m_slots[m_front];
    }

private:
    static constexpr std::uint8_t kFresh = 4;
    static constexpr std::uint8_t kIndex = 3;

    std::array<T, 3> m_slots{};
    std::uint8_t m_back = 0;
    std::atomic<std::uint8_t> m_middle{1};
    std::uint8_t m_front = 2;
};

}  // namespace core::rt
