// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/servo/ServoState.h"
#include "core/servo/ServoTick.h"
#include "core/settings/FeelPreset.h"

namespace core::servo {

/// What of a servo's settings may change while it works: rate and threshold of caries, enamel, dentin and pulp, the
/// axial share, stiffness, damping, damping of fast motion, friction, force limit, the share of flat ends, the full
/// load. Their numbers are in recordings: new ones go to the end.
inline constexpr std::size_t kServoNumbers = 2 * terrain::kMaterialCount + 8;
using ServoParameters = std::array<double, kServoNumbers>;

[[nodiscard]] ServoParameters parametersOf(const ServoSettings& settings);

/// Whether the servo takes this: a number there is, finite and in its range (settings::feelFields()). Any thread.
[[nodiscard]] bool isServoNumber(const SetParameter& number) noexcept;
/// Nothing where isServoNumber() says no. No allocation.
void setServoNumber(ServoSettings& settings, const SetParameter& number) noexcept;

/// As ServoEvent::Kind::Number keeps it.
[[nodiscard]] std::uint64_t packNumber(const SetParameter& number) noexcept;
/// Nothing where isServoNumber() says no.
[[nodiscard]] std::optional<SetParameter> unpackParameter(std::uint64_t packed) noexcept;
/// True if the packed number is one of those up to the force limit, which recordings had first.
[[nodiscard]] bool isOfFirstParameters(std::uint64_t packed) noexcept;

}  // namespace core::servo
