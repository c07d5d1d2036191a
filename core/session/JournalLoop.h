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

/// Brings an attempt to the disk while it goes on, so that a killed program or a cut of power takes no more than the
/// last tenth of a second of it. It asks the session for what is new, 25 times a second, and writes that, which no end
/// of the program undoes; syncing() waits for that and then until the disk has it, which no cut of power undoes. Each
/// has a thread of its own: session and servo never wait for a disk, and what a slow one is behind stays in the
/// session's recording.
///
/// A file comes into being with the first cut, and goes when the attempt is put away: when another tooth is taken, and
/// by putAway(). Every other end leaves it to be found (recording::journalsIn).
class JournalLoop final : public rt::Loop
{
public:
    static constexpr std::chrono::milliseconds kPeriod{40};
    static constexpr std::chrono::milliseconds kSyncRest{1};  ///< period of syncing(), which waits in its ticks

    /// @param session  must outlive the loop
    JournalLoop(const SessionLoop& session, std::filesystem::path folder);

    void tick(std::chrono::microseconds dt) override;
    /// Writes what there is and waits for the disk.
    void end() override;
    /// For the other thread. A tick waits up to kPeriod for something to sync.
    [[nodiscard]] rt::Loop& syncing() { return m_syncing; }

    /// Before an attempt that was found is resumed as the tooth of this generation: its file is kept for it. Any
    /// thread.
    void takeUp(std::uint64_t generation, recording::FoundAttempt found);
    /// What is done to the tooth of this generation is nobody's work, and of it and those before no file is begun any
    /// more. Before it is begun. Any thread.
    void leaveOut(std::uint64_t generation) { m_leftOut.store(generation, std::memory_order_release); }
    /// The attempt has been saved or given up: its file goes. When the loop has ended.
    void putAway();

    /// A failure that has not been told yet, once until things have gone well again. Any thread. Writing is tried again
    /// by and by, from where it failed.
    [[nodiscard]] std::optional<Error> failure();
    /// Things go well, or go well again. Any thread.
    [[nodiscard]] bool isWell() const { return !m_cannotWrite.load() && !m_cannotSync.load(); }
    /// The file of the attempt at the tooth of this generation, whether it is there yet or not; empty: that is not the
    /// present one. Any thread.
    [[nodiscard]] std::filesystem::path fileOf(std::uint64_t generation);
    /// Events of the present attempt that are written. Any thread.
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
    void tellWritten();
    void setFile(std::shared_ptr<recording::JournalFile> file);
    void tell(const Error& error);

    const SessionLoop& m_session;
    std::filesystem::path m_folder;
    std::uint64_t m_generation = 0;  ///< of the tooth whose attempt this is; written under the mutex
    std::int64_t m_begunUtcMs = 0;
    std::filesystem::path m_path;  ///< written under the mutex
    std::shared_ptr<recording::JournalFile> m_file;
    std::optional<recording::JournalLock> m_older;  ///< of the file that m_file takes the place of
    std::chrono::microseconds m_rest{0};            ///< until writing is tried again
    std::atomic<bool> m_cannotWrite{false};
    std::atomic<std::uint64_t> m_written{0};
    std::atomic<std::uint64_t> m_leftOut{0};  ///< the last generation of which no file is begun
    Syncing m_syncing{*this};
    std::atomic<bool> m_cannotSync{false};  ///< of the thread that syncs

    std::condition_variable m_somethingWritten;
    std::mutex m_mutex;  ///< guards what follows
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
