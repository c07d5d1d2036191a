// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/audio/WaveFile.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace core::audio {
namespace {

constexpr std::uint32_t kHeaderBytes = 44;
constexpr std::uint32_t kRiffBytes = 8;  ///< header bytes that are not counted in the size
constexpr float kFullScale = 32767.0F;

/// Appends a number, lowest byte first.
void append(std::string& bytes, std::uint32_t value, int count)
{
    constexpr std::uint32_t kByte = 0xFFU;
    for (int k = 0; k < count; ++k)
        bytes += static_cast<char>(static_cast<unsigned char>((value >> (8U * static_cast<unsigned>(k))) & kByte));
}

}  // namespace

std::string waveFile(std::span<const float> samples, int rateHz)
{
    const auto rate = static_cast<std::uint32_t>(rateHz);
    const auto dataBytes = static_cast<std::uint32_t>(2 * samples.size());
    std::string bytes = "RIFF";
    bytes.reserve(kHeaderBytes + dataBytes);
    append(bytes, kHeaderBytes - kRiffBytes + dataBytes, 4);
    bytes += "WAVEfmt ";
    append(bytes, 16, 4);  // size of the format chunk
    append(bytes, 1, 2);   // PCM
    append(bytes, 1, 2);   // channels
    append(bytes, rate, 4);
    append(bytes, 2 * rate, 4);  // bytes per second
    append(bytes, 2, 2);         // bytes per frame
    append(bytes, 16, 2);        // bits per sample
    bytes += "data";
    append(bytes, dataBytes, 4);
    for (const float sample : samples) {
        const long value = std::lround(kFullScale * std::clamp(sample, -1.0F, 1.0F));
        append(bytes, static_cast<std::uint16_t>(static_cast<std::int16_t>(value)), 2);
    }
    return bytes;
}

}  // namespace core::audio
