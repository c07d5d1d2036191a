// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/base/Rng.h"

namespace support {

/// Faults of one exchange.
enum class Fault : std::uint8_t {
    LostRequest,    ///< the firmware does not see it, and does not answer
    LostAnswer,     ///< the request acts, but its answer does not arrive
    ShortAnswer,    ///< a byte of the answer is missing
    FlippedBit,     ///< in a byte of the answer
    WrongByte,      ///< a byte of the answer has a random value
    LateAnswer,     ///< by 2 to 40 ms
    DoubledAnswer,  ///< the answer is sent twice
    StrayBytes,     ///< 1 to 5 random bytes before the answer
    LineError,      ///< a parity, framing, overrun or break error with a wrong byte
};
inline constexpr std::size_t kFaults = 9;
inline constexpr std::array<Fault, kFaults> kAllFaults{Fault::LostRequest,   Fault::LostAnswer, Fault::ShortAnswer,
                                                       Fault::FlippedBit,    Fault::WrongByte,  Fault::LateAnswer,
                                                       Fault::DoubledAnswer, Fault::StrayBytes, Fault::LineError};

namespace falcon {

/// Decides, from a seed, which faults an exchange has, and counts them.
class Faults
{
public:
    explicit Faults(std::uint64_t seed) : m_rng(seed) {}

    void setShare(Fault fault, double share) { of(fault).share = share; }
    void addNext(Fault fault, int exchanges) { of(fault).next += exchanges; }
    [[nodiscard]] std::uint64_t count(Fault fault) const { return m_kinds[static_cast<std::size_t>(fault)].count; }

    /// Returns whether the present exchange has this fault.
    [[nodiscard]] bool happens(Fault fault)
    {
        Kind& kind = of(fault);
        const bool now = kind.next > 0 || (kind.share > 0.0 && m_rng.uniform() < kind.share);
        kind.next -= kind.next > 0 ? 1 : 0;
        kind.count += now ? 1 : 0;
        return now;
    }
    [[nodiscard]] core::Rng& rng() { return m_rng; }

private:
    struct Kind
    {
        double share = 0.0;
        int next = 0;
        std::uint64_t count = 0;
    };
    Kind& of(Fault fault) { return m_kinds[static_cast<std::size_t>(fault)]; }

    core::Rng m_rng;
    std::array<Kind, kFaults> m_kinds{};
};

}  // namespace falcon
}  // namespace support
