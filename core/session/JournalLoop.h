// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <filesystem>
#include <mutex>
#include <optional>

#include "core/recording/JournalFile.h"
#include "core/rt/Loop.h"
#include "core/session/SessionLoop.h"

namespace core::session {

/// Brings an attempt to the disk while it goes on, so that a killed program or a cut of power takes no more than the
/// last tenth of a second of it. It asks the session for what is new (about 25 times a second) and waits for the disk,
/// in a thread of its own: session and servo never do. What a slow disk is behind stays in the session's recording.
///
/// A file comes into being with the first cut, and goes when the attempt is put away: when another tooth is taken, and
/// by putAway(). Every other end leaves it to be found (recording::journalsIn).
class JournalLoop final : public rt::Loop
{
public:
    static constexpr std::chrono::milliseconds kPeriod{40};

    /// @param session  must outlive the loop
    JournalLoop(const SessionLoop& session, std::filesystem::path folder);

    void tick(std::chrono::microseconds dt) override;
    /// Writes what there is.
    void end() override;

    /// Before an attempt that was found is resumed as the tooth of this generation: its file is kept for it. Any
    /// thread.
    void takeUp(std::uint64_t generation, recording::FoundAttempt found);
    /// The attempt has been saved or given up: its file goes. When the loop has ended.
    void putAway();

    /// The first failure since it was asked last, and again after things had gone well. Any thread. Writing is tried
    /// again by and by, from where it failed.
    [[nodiscard]] std::optional<Error> failure();
    /// Events of the present attempt that are on the disk. Any thread.
    [[nodiscard]] std::uint64_t eventsOnDisk() const { return m_onDisk.load(std::memory_order_acquire); }

private:
    [[nodiscard]] Status bringUpToDate();
    void begin(std::uint64_t generation);

    const SessionLoop& m_session;
    std::filesystem::path m_folder;
    std::uint64_t m_generation = 0;  ///< of the tooth whose attempt this is
    std::int64_t m_begunUtcMs = 0;
    std::filesystem::path m_path;
    std::optional<recording::JournalFile> m_file;
    std::optional<recording::JournalLock> m_older;  ///< of the file that m_file will take the place of
    std::chrono::microseconds m_rest{0};            ///< until writing is tried again
    bool m_failing = false;
    std::atomic<std::uint64_t> m_onDisk{0};

    std::mutex m_mutex;  ///< guards what follows
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
