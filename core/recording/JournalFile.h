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

/// The journal of an attempt: a file that grows while the student works, so that a killed program or a cut of power
/// leaves all but the last moments of it. It holds what a recording holds, in small frames with a checksum each, and is
/// read up to the first one that is not whole.
///
/// Format: "CUSPJRN\n", the version of recordings, then frames of kind, size, number of their first event, checksum and
/// payload: when it was begun, settings, lesson if there is one, tooth, events, events, ...
namespace core::recording {

/// Keeps other programs, and other parts of this one, from a journal while it lives (flock).
class JournalLock
{
public:
    JournalLock() = default;
    /// Takes over an open file that is locked.
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

/// A journal being written. One thread appends and removes, another may sync at the same time.
class JournalFile
{
public:
    /// Makes the file, locked, with all of an attempt so far. Until sync() it stands beside its name ("….part"), where
    /// it is found as well, so that an older journal of that name stays until the disk has the new one. FileUnwritable
    /// with a sentence otherwise.
    [[nodiscard]] static Result<std::shared_ptr<JournalFile>> create(const std::filesystem::path& path,
                                                                     const Recording& soFar, std::int64_t begunUtcMs);
    JournalFile(const JournalFile&) = delete;
    JournalFile& operator=(const JournalFile&) = delete;
    ~JournalFile();

    /// Writes what happened next, at most 4096 events: from then on no end of this program can undo it. After a failure
    /// the file is whole as far as events() says, and may be tried again.
    [[nodiscard]] Status append(std::span<const servo::ServoEvent> events);
    /// How many events it holds.
    [[nodiscard]] std::uint64_t events() const { return m_events.load(std::memory_order_acquire); }
    /// Deletes the file, and an older one of its name. Nothing is to be written any more.
    void remove();

    /// Waits until the disk has all that was written before: from then on a cut of power cannot undo it either.
    [[nodiscard]] Status sync();

private:
    JournalFile(std::filesystem::path path, int file) : m_path(std::move(path)), m_file(file) {}
    [[nodiscard]] bool write(std::string_view bytes);

    std::filesystem::path m_path;
    int m_file;
    std::uint64_t m_bytes = 0;
    std::atomic<std::uint64_t> m_events{0};
    std::uint64_t m_synced = 0;  ///< of them, by the thread that syncs

    std::mutex m_nameMutex;  ///< guards what follows
    bool m_hasItsName = false;
    bool m_isRemoved = false;
};

/// An attempt that nobody finished.
struct FoundAttempt
{
    std::filesystem::path path;
    Recording recording;          ///< up to the last moment that reached the disk
    std::int64_t begunUtcMs = 0;  ///< milliseconds since 1970
    JournalLock lock;             ///< as long as it lives, nobody else finds the attempt
};

/// Names of the journals in a folder, newest first. Locked or not. Empty where the folder cannot be read.
[[nodiscard]] std::vector<std::filesystem::path> journalsIn(const std::filesystem::path& folder);

/// What a journal's bytes hold, up to the first frame that is not whole and sound. An error, one sentence, if that is
/// before the first event. @param path, lock  for FoundAttempt
[[nodiscard]] Result<FoundAttempt> attemptFrom(std::string_view bytes, const std::filesystem::path& path = {},
                                               JournalLock lock = {});

/// Locks a journal and reads it. Where a newer one stands beside its name, that takes its place if it holds as much.
/// Nothing if a running program is at work on it, or it has gone; an error if there is no attempt in it.
[[nodiscard]] Result<std::optional<FoundAttempt>> findAttempt(const std::filesystem::path& path);

/// Puts a journal into the folder "discarded" beside it, where it is kept for 7 days, or deletes it where that cannot
/// be done. Returns where it is then; nothing if it is gone.
std::optional<std::filesystem::path> discardJournal(const std::filesystem::path& path);
/// Puts a discarded journal back to where it will be found; false if it has gone or cannot be moved.
bool bringBackJournal(const std::filesystem::path& discarded);
/// Deletes discarded journals older than 7 days.
void tidyJournals(const std::filesystem::path& folder);

}  // namespace core::recording
