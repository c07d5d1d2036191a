// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <optional>

#include "core/recording/JournalFile.h"
#include "core/rt/Loop.h"
#include "core/session/SessionLoop.h"

namespace core::session {

/// Writes an attempt to the disk while it is being made, so that a killed program or a power failure loses no more than
/// the last tenth of a second. 25 times a second, tick() gets the new events from the session and writes them, after
/// which they survive the end of the program; syncing() then waits until they are on the disk, after which they survive
/// a power failure. Each has its own thread: session and servo never wait for a disk, and events that a slow disk has
/// not taken stay in the session's recording.
///
/// A file is created at the first cut. It is removed when another tooth begins, and by putAway(). After any other end
/// it stays and is found by recording::journalsIn().
class JournalLoop final : public rt::Loop
{
public:
    static constexpr std::chrono::milliseconds kPeriod{40};
    static constexpr std::chrono::milliseconds kSyncRest{1};  ///< period of syncing(), which waits in its ticks

    /// @param session  must outlive the loop
    JournalLoop(const SessionLoop& session, std::filesystem::path folder);

    void tick(std::chrono::microseconds dt) override;
    /// Writes all events and waits for the disk.
    void end() override;
    /// Returns the loop that waits for the disk, for a second thread. Its tick waits up to kPeriod for new data.
    [[nodiscard]] rt::Loop& syncing() { return m_syncing; }

    /// Assigns the file of an attempt that was found to the tooth of this generation. Call before that attempt is
    /// resumed. Any thread.
    void takeUp(std::uint64_t generation, recording::FoundAttempt found);
    /// Writes no file for the tooth of this generation and those before it, because the work belongs to no user. Call
    /// before that tooth begins. Any thread.
    void leaveOut(std::uint64_t generation) { m_leftOut.store(generation, std::memory_order_release); }
    /// Removes the file, because the attempt was saved or discarded. Call after the loop has ended.
    void putAway();

    /// Returns the first failure since the last success, once. Writing is retried from where it failed. Any thread.
    [[nodiscard]] std::optional<Error> failure();
    /// Returns whether the last write and the last sync succeeded. Any thread.
    [[nodiscard]] bool isWell() const { return !m_cannotWrite.load() && !m_cannotSync.load(); }
    /// Returns the path of the journal file, existing or not, of the tooth of this generation; empty if that is not the
    /// current tooth. Any thread.
    [[nodiscard]] std::filesystem::path fileOf(std::uint64_t generation);
    /// Returns the number of events of the current attempt that are written. Any thread.
    [[nodiscard]] std::uint64_t eventsWritten() const { return m_written.load(std::memory_order_acquire); }

private:
    class Syncing final : public rt::Loop
    {
    public:
        explicit Syncing(JournalLoop& journal) : m_journal(journal) {}
        void tick(std::chrono::microseconds) override { m_journal.syncWhenWritten(); }

    private:
        JournalLoop& m_journal;
    };

    [[nodiscard]] Status bringUpToDate();
    void beginWith(std::uint64_t generation);
    void sync();
    void syncWhenWritten();
    void reportWritten();
    void setFile(std::shared_ptr<recording::JournalFile> file);
    void tell(const Error& error);

    const SessionLoop& m_session;
    std::filesystem::path m_folder;
    std::uint64_t m_generation = 0;  ///< of the current tooth; written under the mutex
    std::int64_t m_begunUtcMs = 0;
    std::filesystem::path m_path;  ///< written under the mutex
    std::shared_ptr<recording::JournalFile> m_file;
    std::optional<recording::JournalLock> m_older;  ///< of the file that m_file replaces
    std::chrono::microseconds m_rest{0};            ///< time until writing is retried
    std::atomic<bool> m_cannotWrite{false};
    std::atomic<std::uint64_t> m_written{0};
    std::atomic<std::uint64_t> m_leftOut{0};  ///< no files for teeth up to this generation
    Syncing m_syncing{*this};
    std::atomic<bool> m_cannotSync{false};  ///< of the thread that syncs

    std::condition_variable m_somethingWritten;
    std::mutex m_mutex;  ///< guards the members below
    bool m_isToBeSynced = false;
    std::shared_ptr<recording::JournalFile> m_toSync;
    std::optional<Error> m_failure;
    struct Found
    {
        std::uint64_t generation = 0;
        std::filesystem::path path;
        std::int64_t begunUtcMs = 0;
        recording::JournalLock lock;
    };
    std::optional<Found> m_found;
};

}  // namespace core::session
