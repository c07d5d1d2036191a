// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
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

/// A journal being written. Any one thread; every call may wait for the disk.
class JournalFile
{
public:
    /// Makes the file, locked, with all of an attempt so far. It appears whole, in place of one of that name, or not at
    /// all. FileUnwritable with a sentence otherwise.
    [[nodiscard]] static Result<JournalFile> create(const std::filesystem::path& path, const Recording& soFar,
                                                    std::int64_t begunUtcMs);
    JournalFile(JournalFile&& other) noexcept;
    JournalFile& operator=(JournalFile&& other) noexcept;
    JournalFile(const JournalFile&) = delete;
    JournalFile& operator=(const JournalFile&) = delete;
    ~JournalFile();

    /// Writes what happened next, at most 4096 events, and waits until the disk has it. After a failure the file is
    /// whole as far as events() says, and may be tried again.
    [[nodiscard]] Status append(std::span<const session::ServoEvent> events);
    /// How many events it holds.
    [[nodiscard]] std::uint64_t events() const { return m_events; }
    [[nodiscard]] const std::filesystem::path& path() const { return m_path; }
    /// Deletes the file. Nothing can be written any more.
    void remove();

private:
    JournalFile(std::filesystem::path path, int file) : m_path(std::move(path)), m_file(file) {}
    [[nodiscard]] bool put(std::span<const session::ServoEvent> events);
    [[nodiscard]] bool write(std::string_view bytes);

    std::filesystem::path m_path;
    int m_file = -1;
    std::uint64_t m_bytes = 0;
    std::uint64_t m_events = 0;
};

/// An attempt that nobody finished.
struct FoundAttempt
{
    std::filesystem::path path;
    Recording recording;          ///< up to the last moment that reached the disk
    std::int64_t begunUtcMs = 0;  ///< milliseconds since 1970
    JournalLock lock;             ///< as long as it lives, nobody else finds the attempt
};

/// Journals in a folder, newest first. Locked or not. Empty where the folder cannot be read.
[[nodiscard]] std::vector<std::filesystem::path> journalsIn(const std::filesystem::path& folder);

/// What a journal's bytes hold, up to the first frame that is not whole and sound. An error, one sentence, if that is
/// before the first event. @param path, lock  for FoundAttempt
[[nodiscard]] Result<FoundAttempt> attemptFrom(std::string_view bytes, const std::filesystem::path& path = {},
                                               JournalLock lock = {});

/// Locks a journal and reads it. Nothing if a running program is at work on it, or it has gone; an error if there is no
/// attempt in it.
[[nodiscard]] Result<std::optional<FoundAttempt>> findAttempt(const std::filesystem::path& path);

/// Puts a journal into the folder "discarded" beside it, where it is kept for 7 days, or deletes it where that cannot
/// be done.
void discardJournal(const std::filesystem::path& path);
/// Deletes discarded journals older than 7 days, and what an interrupted create() left.
void tidyJournals(const std::filesystem::path& folder);

}  // namespace core::recording
