// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/recording/Recording.h"
#include "core/terrain/Tooth.h"

/// The sections of recordings and journals as bytes. Pure functions. Readers check all that a replay relies on and
/// return empty if it is not valid.
namespace core::recording {

using servo::ServoEvent;

inline constexpr std::uint32_t kFormatVersion = 9;
/// The oldest version that is read. A recording is written in the oldest version that can represent its tooth, its
/// settings and all of its events (versionWith()).
inline constexpr std::uint32_t kOldestVersion = 5;
inline constexpr std::size_t kChunkEvents = 4096;
inline constexpr std::uint64_t kMaxToothBytes = std::uint64_t{64} * 1024 * 1024;
/// Limit of settings, lesson and events, unpacked.
inline constexpr std::uint64_t kMaxChunkBytes = std::uint64_t{1} * 1024 * 1024;
/// Limit of all events of a recording, unpacked. A step has 15 bytes, any other event has 23.
inline constexpr std::uint64_t kMaxEventBytes = 16 * kMaxEvents;

enum class Section : std::uint32_t { Settings = 1, Tooth = 2, Events = 3, End = 4, Lesson = 5, Begun = 6 };

/// Returns whether an event is a step of the servo, with a reading or without.
[[nodiscard]] inline bool isTick(ServoEvent::Kind kind)
{
    return kind == ServoEvent::Kind::Tick || kind == ServoEvent::Kind::NoDevice;
}

/// Returns the oldest version with such an event, or such settings. Version 6 added parameters of the feel, 7 the speed
/// of a pedal, 8 the share of flat ends and the full load, 9 the zones of decay.
[[nodiscard]] std::uint32_t versionWith(const ServoEvent& event);
[[nodiscard]] std::uint32_t versionWith(const servo::ServoSettings& settings);
/// Returns the oldest version with such a tooth. Version 8 added teeth placed on a side, 9 the zones of decay.
[[nodiscard]] inline std::uint32_t versionWith(const terrain::ToothAnatomy& tooth)
{
    if (tooth.hasDecayZones)
        return 9;
    return tooth.lying.isUpright() ? kOldestVersion : 8;
}

/// Compresses with Zstandard.
[[nodiscard]] std::string pack(std::string_view raw);
/// Returns the size that the data declare, without decompressing them. Empty if they are damaged or declare none.
[[nodiscard]] std::optional<std::uint64_t> unpackedSize(std::string_view packed);
/// Decompresses. Empty if the data are damaged or declare more than `mostBytes`.
[[nodiscard]] std::optional<std::string> unpack(std::string_view packed, std::uint64_t mostBytes);

/// Returns the settings in the oldest version that versionWith() gives.
[[nodiscard]] std::string settingsBytes(const servo::ServoSettings& settings);
/// Reads settings. Settings that end before the share of flat ends have none, and those that end after the full load
/// have no zones of decay. Values are not checked: makeServoTick() does that.
[[nodiscard]] std::optional<servo::ServoSettings> settingsFrom(std::string_view bytes);

/// Returns a tooth. Its orientation follows its maps, if it is placed on a side. One more byte, 1, means that its decay
/// has zones.
[[nodiscard]] std::string toothBytes(const terrain::ToothAnatomy& tooth);
/// Reads a tooth. Null if it is damaged or impossible.
[[nodiscard]] std::shared_ptr<const terrain::ToothAnatomy> toothFrom(std::string_view bytes);

/// Returns events: kinds, steps and the four byte planes of each coordinate, one after another, for better compression.
[[nodiscard]] std::string eventBytes(std::span<const ServoEvent> events);
/// Reads at most kChunkEvents events. A bur may be unknown to this program: EventGuard detects that.
[[nodiscard]] std::optional<std::vector<ServoEvent>> eventsFrom(std::string_view bytes);

/// Returns a text such as "uses bur 33 of the list, and this Cusp has 32".
/// @param index  of a bur that is not in burs()
[[nodiscard]] std::string unknownBurWords(std::uint64_t index);

/// Checks events before they are appended to a recording that is being read, so that a replay of it terminates.
class EventGuard
{
public:
    enum class Verdict { Sound, IntoTheFuture, TooManySteps, NoSuchHandpiece, BurOfNewerCusp };
    [[nodiscard]] Verdict look(const ServoEvent& event, const Recording& soFar);

private:
    std::uint64_t m_restoredColumns = 0;
};

}  // namespace core::recording
