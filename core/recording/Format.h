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

/// The parts of which recordings and journals are made, as bytes. Pure functions; readers check all that a replay
/// relies on and answer with nothing where it does not hold.
namespace core::recording {

using servo::ServoEvent;

inline constexpr std::uint32_t kFormatVersion = 9;
/// Oldest version that is read. A recording is written in the oldest version that has its tooth, its settings and all
/// of its events (versionWith()).
inline constexpr std::uint32_t kOldestVersion = 5;
inline constexpr std::size_t kChunkEvents = 4096;
inline constexpr std::uint64_t kMaxToothBytes = std::uint64_t{64} * 1024 * 1024;
/// Of settings, lesson and events, unpacked.
inline constexpr std::uint64_t kMaxChunkBytes = std::uint64_t{1} * 1024 * 1024;

enum class Section : std::uint32_t { Settings = 1, Tooth = 2, Events = 3, End = 4, Lesson = 5, Begun = 6 };

/// A step of the servo, with a reading or without.
[[nodiscard]] inline bool isTick(ServoEvent::Kind kind)
{
    return kind == ServoEvent::Kind::Tick || kind == ServoEvent::Kind::NoDevice;
}

/// Returns the oldest version that has such an event, or such settings. Version 6 brought numbers of the feel, 7 the
/// speed of a pedal, 8 the share of flat ends and the full load, 9 the zones of decay.
[[nodiscard]] std::uint32_t versionWith(const ServoEvent& event);
[[nodiscard]] std::uint32_t versionWith(const servo::ServoSettings& settings);
/// Returns the oldest version that has such a tooth. Version 8 brought teeth that lie on a side, 9 the zones of decay.
[[nodiscard]] inline std::uint32_t versionWith(const terrain::ToothAnatomy& tooth)
{
    if (tooth.hasDecayZones)
        return 9;
    return tooth.lying.isUpright() ? kOldestVersion : 8;
}

/// By Zstandard.
[[nodiscard]] std::string pack(std::string_view raw);
/// Nothing if it is damaged, or says that it unpacks to more than so many bytes.
[[nodiscard]] std::optional<std::string> unpack(std::string_view packed, std::uint64_t mostBytes);

/// What versionWith() says an older version knows is written as that version does.
[[nodiscard]] std::string settingsBytes(const servo::ServoSettings& settings);
/// Settings that end before the share of flat ends were made without one, and those that end behind the full load
/// without zones of decay. Values are not checked: makeServoTick() does.
[[nodiscard]] std::optional<servo::ServoSettings> settingsFrom(std::string_view bytes);

/// How a tooth lies comes behind its maps, and only if it lies on a side. One byte more, 1, says that its decay has
/// zones.
[[nodiscard]] std::string toothBytes(const terrain::ToothAnatomy& tooth);
/// Null if it is damaged or no tooth can be like that.
[[nodiscard]] std::shared_ptr<const terrain::ToothAnatomy> toothFrom(std::string_view bytes);

/// Kinds, steps and the four byte planes of each coordinate, one after another: like stands beside like.
[[nodiscard]] std::string eventBytes(std::span<const ServoEvent> events);
/// At most kChunkEvents of them. A bur may be one that this program does not have: EventGuard finds it.
[[nodiscard]] std::optional<std::vector<ServoEvent>> eventsFrom(std::string_view bytes);

/// "uses bur 33 of the list, and this Cusp has 32".
/// @param index  of a bur that is not in burs()
[[nodiscard]] std::string unknownBurWords(std::uint64_t index);

/// Looks at events before they are appended to a recording that is being read: would a replay come to an end?
class EventGuard
{
public:
    enum class Verdict { Sound, IntoTheFuture, TooManySteps, NoSuchHandpiece, BurOfNewerCusp };
    [[nodiscard]] Verdict look(const ServoEvent& event, const Recording& soFar);

private:
    std::uint64_t m_restoredColumns = 0;
};

}  // namespace core::recording
