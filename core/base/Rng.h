// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace core {

/// A seeded random generator, implemented here so that a seed gives the same tooth with every compiler and library.
///
/// SplitMix64 (Steele, Lea, Flood 2014): 64 bits of state, passes BigCrush, one multiply-xor chain per number.
class Rng
{
public:
    explicit constexpr Rng(std::uint64_t seed) : m_state(seed) {}

    constexpr std::uint64_t next()
    {
        m_state += 0x9E3779B97F4A7C15ULL;
        std::uint64_t z = m_state;
        z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
        z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
        return z ^ (z >> 31U);
    }

    /// Returns a uniform number in [0, 1), 53 bits.
    constexpr double uniform() { return static_cast<double>(next() >> 11U) * 0x1.0p-53; }

    /// Returns a uniform number in [low, high).
    constexpr double uniform(double low, double high) { return low + (high - low) * uniform(); }

    /// Returns a number of mean 0 and standard deviation 1 from twelve uniform ones (Irwin-Hall): no transcendental
    /// function, no value beyond 6.
    constexpr double normal()
    {
        double sum = -6.0;
        for (int i = 0; i < 12; ++i)
            sum += uniform();
        return sum;
    }

    /// Returns a uniform integer from 0 to count - 1; count must be positive.
    constexpr int below(int count) { return static_cast<int>(next() % static_cast<std::uint64_t>(count)); }

private:
    std::uint64_t m_state;
};

}  // namespace core
