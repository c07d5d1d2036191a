// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "core/terrain/Tooth.h"

namespace core::audio {

/// The kind of a handpiece's drive, which decides its sound.
enum class Drive : std::uint8_t { Turbine, Electric, LowSpeed };
inline constexpr std::size_t kDriveCount = 3;

/// Returns the drive of a handpiece with this free speed. Electric ones end at 200,000 turns of the bur per minute, and
/// low-speed ones at 40,000.
[[nodiscard]] Drive driveOf(double freeRpm) noexcept;

/// Input of the synthesiser at one moment. Plain values: the servo publishes one every tick.
struct SoundState
{
    Drive drive = Drive::Turbine;
    bool turns = false;                                      ///< the handpiece is on; the bur may have stalled
    float freeRpm = 320'000;                                 ///< turns of the bur per minute without a load
    float burRpm = 0.0F;                                     ///< current turns of the bur per minute
    bool isTouching = false;                                 ///< the bur touches the tooth
    float cutMm3PerS = 0.0F;                                 ///< material that is removed
    float chatter = 0.0F;                                    ///< 0 a steady cut, 1 a bur that bounces on an edge
    bool spray = false;                                      ///< the cooling spray is on
    bool suction = false;                                    ///< the suction is on
    std::uint32_t contacts = 0;                              ///< increases by one whenever the bur touches the tooth
    float contactMmPerS = 0.0F;                              ///< speed of the last contact
    terrain::Material material = terrain::Material::Enamel;  ///< under the bur; valid while touching

    /// Returns the share of the stall torque that brakes the bur, 0 to 1.
    [[nodiscard]] float load() const noexcept
    {
        return turns && freeRpm > 0.0F && burRpm < freeRpm ? 1.0F - burRpm / freeRpm : 0.0F;
    }
};

/// Parts of the sound with separate volumes.
enum class Part : std::uint8_t { Handpiece, Cutting, Contact, Spray, Suction };
inline constexpr std::size_t kPartCount = 5;

/// Volumes from 0 (silent) to 1.
struct Volumes
{
    float master = 0.7F;
    std::array<float, kPartCount> parts{0.8F, 0.8F, 0.8F, 0.5F, 0.3F};  ///< indexed by Part
    bool isMuted = false;
    bool operator==(const Volumes&) const = default;
};

}  // namespace core::audio
