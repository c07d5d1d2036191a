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

/// The servo settings that may change while the servo runs: rate and threshold of caries, enamel, dentin and pulp, the
/// axial share, stiffness, damping, damping of fast motion, friction, force limit, the share of flat ends, the full
/// load. Recordings store their indices: add new ones at the end only.
inline constexpr std::size_t kServoNumbers = 2 * terrain::kMaterialCount + 8;
using ServoParameters = std::array<double, kServoNumbers>;

/// Returns the current values of all parameters.
[[nodiscard]] ServoParameters parametersOf(const ServoSettings& settings);

/// Returns whether the servo accepts a parameter: the index exists and the value is finite and in its range
/// (settings::feelFields()). Any thread.
[[nodiscard]] bool isServoNumber(const SetParameter& number) noexcept;
/// Sets a parameter. Does nothing if isServoNumber() is false. No allocation.
void setServoNumber(ServoSettings& settings, const SetParameter& number) noexcept;

/// Packs a parameter into the value of ServoEvent::Kind::Number.
[[nodiscard]] std::uint64_t packNumber(const SetParameter& number) noexcept;
/// Unpacks a parameter. Empty if isServoNumber() is false.
[[nodiscard]] std::optional<SetParameter> unpackParameter(std::uint64_t packed) noexcept;
/// Returns whether a packed parameter is one of the first recordings', up to the force limit.
[[nodiscard]] bool isOfFirstParameters(std::uint64_t packed) noexcept;

}  // namespace core::servo
