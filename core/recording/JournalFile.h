// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/recording/Recording.h"

/// The journal of an attempt: a file that grows during the work, so that a killed program or a power failure loses only
/// the last moments. It contains the same as a recording, in small frames with a checksum each, and is read up to the
/// first frame that is incomplete.
///
/// Format: "CUSPJRN\n", the version of recordings, then frames of kind, size, number of their first event, checksum and
/// payload: start time, settings, lesson if there is one, tooth, events, events, ...
namespace core::recording {

/// Locks a journal against other programs, and other parts of this one, while the object exists (flock).
class JournalLock
{
public:
    JournalLock() = default;
    /// Takes ownership of an open, locked file.
    explicit JournalLock(int file) : m_file(file) {}
    JournalLock(JournalLock&& other) noexcept : m_file(std::exchange(other.m_file, -1)) {}
    JournalLock& operator=(JournalLock&& other) noexcept
    {
        std::swap(m_file, other.m_file);
        return *this;
    }
    JournalLock(const JournalLock&) = delete;
    JournalLock& operator=(const JournalLock&) = delete;
    ~JournalLock();

private:
    int m_file = -1;
};

/// A journal that is being written. One thread appends and removes; another may sync at the same time.
class JournalFile
{
public:
    /// Creates the file, locked, with the whole attempt so far. Until sync() it has the suffix ".part", with which it
    /// is also found, so that an older journal of this name stays until the disk has the new one. Error FileUnwritable
    /// with one sentence.
    [[nodiscard]] static Result<std::shared_ptr<JournalFile>> create(const std::filesystem::path& path,
                                                                     const Recording& soFar, std::int64_t begunUtcMs);
    JournalFile(const JournalFile&) = delete;
    JournalFile& operator=(const JournalFile&) = delete;
    ~JournalFile();

    /// Appends events, at most 4096. They then survive the end of this program. After a failure the file is valid up to
    /// events(), and the call may be repeated.
    [[nodiscard]] Status append(std::span<const servo::ServoEvent> events);
    /// Returns the number of events in the file.
    [[nodiscard]] std::uint64_t events() const { return m_events.load(std::memory_order_acquire); }
    /// Deletes the file, and an older one of its name. Nothing may be written afterwards.
    void remove();

    /// Waits until the disk has all that was written before. That then survives a power failure.
    [[nodiscard]] Status sync();

private:
    JournalFile(std::filesystem::path path, int file) : m_path(std::move(path)), m_file(file) {}
    [[nodiscard]] bool write(std::string_view bytes);

    std::filesystem::path m_path;
    int m_file;
    std::uint64_t m_bytes = 0;
    std::atomic<std::uint64_t> m_events{0};
    std::uint64_t m_synced = 0;  ///< number of events synced; used by the thread that syncs

    std::mutex m_nameMutex;  ///< guards the members below
    bool m_hasItsName = false;
    bool m_isRemoved = false;
};

/// An unfinished attempt.
struct FoundAttempt
{
    std::filesystem::path path;
    Recording recording;          ///< up to the last moment that reached the disk
    std::int64_t begunUtcMs = 0;  ///< milliseconds since 1970
    JournalLock lock;             ///< while it exists, no other program finds the attempt
};

/// Returns the names of the journals in a folder, locked or not, newest first. Empty if the folder cannot be read.
[[nodiscard]] std::vector<std::filesystem::path> journalsIn(const std::filesystem::path& folder);

/// Reads a journal up to the first frame that is incomplete or damaged, at most kMaxEvents events. Error, one sentence,
/// if that is before the first event. @param path, lock  for FoundAttempt
[[nodiscard]] Result<FoundAttempt> attemptFrom(std::string_view bytes, const std::filesystem::path& path = {},
                                               JournalLock lock = {});

/// Locks a journal and reads it. A newer ".part" file beside it replaces it if it contains at least as much. Empty if a
/// running program uses it, or if it does not exist; an error if it contains no attempt.
[[nodiscard]] Result<std::optional<FoundAttempt>> findAttempt(const std::filesystem::path& path);

/// Moves a journal to the folder "discarded" beside it, where it is kept for 7 days, or deletes it if that fails.
/// Returns its new path; empty if it was deleted.
std::optional<std::filesystem::path> discardJournal(const std::filesystem::path& path);
/// Moves a discarded journal back. Returns false if it does not exist or cannot be moved.
bool bringBackJournal(const std::filesystem::path& discarded);
/// Deletes discarded journals older than 7 days.
void tidyJournals(const std::filesystem::path& folder);

}  // namespace core::recording
