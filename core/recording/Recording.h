// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

/// A tooth's state at one tick, kept so that a replay can prove itself.
struct Witness
{
    std::uint64_t tick = 0;
    std::uint64_t stateHash = 0;
    bool operator==(const Witness&) const = default;
};

/// The longest text of a lesson that a recording takes along.
inline constexpr std::size_t kMaxLessonBytes = std::size_t{1} * 1024 * 1024;
/// Can a recording take this text along? UTF-8, not too long; may be empty.
[[nodiscard]] Status checkLesson(std::string_view lesson);

/// One attempt: the tooth it began with and everything that happened to the servo since. Replaying it gives the
/// bit-identical tooth, on every machine and in every build.
///
/// Events are packed as they come, 4096 at a time (device positions as exclusive-or with the one before, split into
/// byte planes, Zstandard), so an attempt holds about half a megabyte a minute. Any one thread at a time.
class Recording
{
public:
    /// @param lesson  what the attempt is made for, as text that only lessons understands; checked (checkLesson)
    Recording(servo::ServoSettings settings, std::shared_ptr<const terrain::ToothAnatomy> anatomy,
              std::string lesson = {});

    void append(const servo::ServoEvent& event);
    /// Notes what the tooth was after a tick; the last one said is stored.
    void setWitness(const Witness& witness) { m_witness = witness; }

    [[nodiscard]] const servo::ServoSettings& settings() const { return m_settings; }
    [[nodiscard]] const std::shared_ptr<const terrain::ToothAnatomy>& anatomy() const { return m_anatomy; }
    /// Empty: the attempt was made for no lesson.
    [[nodiscard]] const std::string& lesson() const { return m_lesson; }
    [[nodiscard]] const std::optional<Witness>& witness() const { return m_witness; }
    [[nodiscard]] std::uint64_t ticks() const { return m_ticks; }
    /// Sum of the steps of all ticks.
    [[nodiscard]] std::chrono::microseconds duration() const { return m_duration; }
    /// Its settings were changed while the attempt went on: it is no longer made with the preset they name.
    [[nodiscard]] bool isRetuned() const { return m_isRetuned; }
    [[nodiscard]] std::size_t packedBytes() const;

    [[nodiscard]] std::uint64_t events() const;
    /// Events from number `first` on, counted from nought: as many as are at hand together, at most 4096. Empty if
    /// there are none yet.
    [[nodiscard]] std::vector<servo::ServoEvent> eventsSince(std::uint64_t first) const;
    /// All events in order.
    void forEach(const std::function<void(const servo::ServoEvent&)>& visit) const;

    /// The file's bytes.
    [[nodiscard]] std::string toBytes() const;
    /// Checks everything it reads; the error says what is wrong and where. Never holds more than the file promises
    /// within fixed limits.
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

/// Reads a whole file, with a sentence for each thing that can be wrong with it.
[[nodiscard]] Result<Recording> readRecording(const std::filesystem::path& path);

/// An older file survives any failure (writeWhole).
[[nodiscard]] Status writeRecording(const std::filesystem::path& path, const Recording& recording);

}  // namespace core::recording
