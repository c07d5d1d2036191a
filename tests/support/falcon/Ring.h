// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cassert>
#include <cstddef>
#include <vector>

namespace support::falcon {

/// A queue of fixed capacity. Only the constructor allocates.
template <typename T>
class Ring
{
public:
    explicit Ring(std::size_t capacity) : m_items(capacity) {}

    [[nodiscard]] std::size_t size() const { return m_size; }
    [[nodiscard]] bool empty() const { return m_size == 0; }
    [[nodiscard]] bool full() const { return m_size == m_items.size(); }
    /// @param n  0 is the oldest
    [[nodiscard]] const T& operator[](std::size_t n) const
    {
        assert(n < m_size);
        return m_items[(m_first + n) % m_items.size()];
    }
    void push(const T& item)
    {
        assert(!full());
        m_items[(m_first + m_size++) % m_items.size()] = item;
    }
    T pop()
    {
        assert(!empty());
        const T item = m_items[m_first];
        m_first = (m_first + 1) % m_items.size();
        --m_size;
        return item;
    }
    void clear() { m_size = 0; }

private:
    std::vector<T> m_items;
    std::size_t m_first = 0;
    std::size_t m_size = 0;
};

}  // namespace support::falcon
