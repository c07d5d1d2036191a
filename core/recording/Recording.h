// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/Result.h"
#include "core/servo/ServoChannels.h"
#include "core/servo/ServoTick.h"

namespace core::recording {

/// The state hash of a tooth at one tick, with which a replay is verified.
struct Witness
{
    std::uint64_t tick = 0;
    std::uint64_t stateHash = 0;
    bool operator==(const Witness&) const = default;
};

/// The longest attempt that can be recorded. After that, nothing more is cut: see Recording::isFull().
inline constexpr std::chrono::hours kLongestAttempt{6};
/// The number of events of that time at 1 kHz. A recording with this many is full, too.
inline constexpr std::uint64_t kEventsOfLongestAttempt = 21'600'000;
/// Largest number of events of a recording. It leaves room for the events that arrive until the attempt has ended.
inline constexpr std::uint64_t kMaxEvents = 22'000'000;

/// The longest lesson text that a recording stores.
inline constexpr std::size_t kMaxLessonBytes = std::size_t{1} * 1024 * 1024;
/// Checks whether a recording can store this text: UTF-8, not too long; may be empty.
[[nodiscard]] Status checkLesson(std::string_view lesson);

/// One attempt: the tooth at its start and all events of the servo since. A replay gives the bit-identical tooth on
/// every machine and in every build.
///
/// Events are packed as they arrive, 4096 at a time (device positions as exclusive-or with the one before, split into
/// byte planes, Zstandard), about half a megabyte per minute. One thread at a time.
class Recording
{
public:
    /// @param lesson  the lesson as text in the format of the lessons library; must pass checkLesson()
    Recording(servo::ServoSettings settings, std::shared_ptr<const terrain::ToothAnatomy> anatomy,
              std::string lesson = {});

    /// Appends an event. The recording must have fewer than kMaxEvents.
    void append(const servo::ServoEvent& event);
    /// Returns whether the attempt must end, because it is as long as a recording may be.
    [[nodiscard]] bool isFull() const;
    /// Stores the state of the tooth after a tick, in place of an earlier witness.
    void setWitness(const Witness& witness) { m_witness = witness; }

    [[nodiscard]] const servo::ServoSettings& settings() const { return m_settings; }
    [[nodiscard]] const std::shared_ptr<const terrain::ToothAnatomy>& anatomy() const { return m_anatomy; }
    /// Returns the lesson; empty: none.
    [[nodiscard]] const std::string& lesson() const { return m_lesson; }
    [[nodiscard]] const std::optional<Witness>& witness() const { return m_witness; }
    [[nodiscard]] std::uint64_t ticks() const { return m_ticks; }
    /// Returns the sum of the steps of all ticks.
    [[nodiscard]] std::chrono::microseconds duration() const { return m_duration; }
    /// Returns whether a parameter was changed during the attempt, so that its preset no longer describes it.
    [[nodiscard]] bool isRetuned() const { return m_isRetuned; }
    [[nodiscard]] std::size_t packedBytes() const;

    [[nodiscard]] std::uint64_t events() const;
    /// Returns events from number `first` on, counted from 0: those of one chunk, at most 4096. Empty if there are none
    /// yet.
    [[nodiscard]] std::vector<servo::ServoEvent> eventsSince(std::uint64_t first) const;
    /// Calls `visit` for all events in order.
    void forEach(const std::function<void(const servo::ServoEvent&)>& visit) const;

    /// Returns the bytes of the file.
    [[nodiscard]] std::string toBytes() const;
    /// Reads and checks the bytes of a file; the error says what is wrong and where. Memory is bounded by fixed limits.
    /// FileTooLarge: more than kMaxEvents, which is determined before any event is unpacked.
    [[nodiscard]] static Result<Recording> fromBytes(std::string_view bytes);

private:
    void packTail();

    servo::ServoSettings m_settings;
    std::shared_ptr<const terrain::ToothAnatomy> m_anatomy;
    std::string m_lesson;
    std::vector<std::string> m_chunks;  ///< packed
    std::vector<servo::ServoEvent> m_tail;
    std::optional<Witness> m_witness;
    bool m_isRetuned = false;
    std::uint32_t m_version = 0;  ///< of the format that has all of its events; 0: any
    std::uint64_t m_ticks = 0;
    std::chrono::microseconds m_duration{0};
};

/// Reads a file. The error is one sentence.
[[nodiscard]] Result<Recording> readRecording(const std::filesystem::path& path);

/// Writes a file. An existing file is unchanged on failure (writeWhole).
[[nodiscard]] Status writeRecording(const std::filesystem::path& path, const Recording& recording);

}  // namespace core::recording
