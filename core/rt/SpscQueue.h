// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>

namespace core::rt {

/// Whether elements of a queue may own heap memory. Elements that a real-time thread pushes or pops must not.
enum class Elements { Plain, MayOwn };

/// A queue of fixed capacity from one producer thread to one consumer thread. Elements arrive in order, and neither
/// thread waits.
/// Storage is allocated once, in the constructor. Capacity must be a power of two.
template <class T, std::size_t Capacity, Elements Kind = Elements::Plain>
class SpscQueue
{
    static_assert((Capacity & (Capacity - 1)) == 0 && Capacity > 0);
    static_assert(Kind == Elements::MayOwn || std::is_trivially_copyable_v<T>,
                  "no hidden heap may cross a real-time boundary");
    static_assert(std::is_nothrow_move_assignable_v<T>);

public:
    SpscQueue() : m_slots(std::make_unique<T[]>(Capacity)) {}

    /// Producer: adds an element. Returns false if the queue is full; `value` is then unchanged.
    [[nodiscard]] bool tryPush(T&& value) noexcept
    {
        const std::size_t tail = m_tail.load(std::memory_order_relaxed);
        if (tail - m_head.load(std::memory_order_acquire) == Capacity)
            return false;
        m_slots[tail & (Capacity - 1)] = std::move(value);
        m_tail.store(tail + 1, std::memory_order_release);
        return true;
    }

    [[nodiscard]] bool tryPush(const T& value) noexcept requires std::is_trivially_copyable_v<T>
    {
        return tryPush(T(value));
    }

    /// Consumer: removes the first element. Returns false if the queue is empty; `value` is then unchanged.
    [[nodiscard]] bool tryPop(T& value) noexcept
    {
        const std::size_t head = m_head.load(std::memory_order_relaxed);
        if (head == m_tail.load(std::memory_order_acquire))
            return false;
        value = std::move(m_slots[head & (Capacity - 1)]);
        m_head.store(head + 1, std::memory_order_release);
        return true;
    }

    /// Producer: returns the number of tryPush() calls that will succeed now.
    [[nodiscard]] std::size_t space() const noexcept
    {
        return Capacity - (m_tail.load(std::memory_order_relaxed) - m_head.load(std::memory_order_acquire));
    }

private:
    std::unique_ptr<T[]> m_slots;
    alignas(64) std::atomic<std::size_t> m_head{0};
    alignas(64) std::atomic<std::size_t> m_tail{0};
};

}  // namespace core::rt
