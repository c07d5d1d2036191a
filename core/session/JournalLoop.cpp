// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/JournalLoop.h"

#include <algorithm>
#include <string>

#include <unistd.h>

namespace core::session {
namespace {

constexpr std::chrono::seconds kRestAfterFailure{5};

}  // namespace

JournalLoop::JournalLoop(const SessionLoop& session, std::filesystem::path folder)
    : m_session(session), m_folder(std::move(folder))
{}

void JournalLoop::tick(std::chrono::microseconds dt)
{
    m_rest -= std::min(m_rest, dt);
    if (m_rest > std::chrono::microseconds(0))
        return;
    const Status done = bringUpToDate();
    if (!done) {
        m_rest = kRestAfterFailure;
        if (!m_cannotWrite)
            tell(done.error());
    }
    m_cannotWrite = !done;
}

void JournalLoop::end()
{
    m_rest = {};
    tick(kPeriod);
    sync();
}

void JournalLoop::tell(const Error& error)
{
    const std::lock_guard lock(m_mutex);
    m_failure = error;
}

Status JournalLoop::bringUpToDate()
{
    for (;;) {
        const RecordedPart part = m_session.recordedSince(m_generation, m_file ? m_file->events() : 0);
        if (part.generation != m_generation) {
            beginWith(part.generation);
            continue;
        }
        if (m_file) {
            if (part.events.empty())
                return {};
            if (Status written = m_file->append(part.events); !written)
                return written;
            reportWritten();
        } else {
            if (!part.isWorthKeeping || m_generation <= m_leftOut.load(std::memory_order_acquire))
                return {};
            const auto soFar = m_session.recordingSoFar();
            if (!soFar)
                return {};
            auto made = recording::JournalFile::create(m_path, *soFar, m_begunUtcMs);
            if (!made)
                return tl::unexpected(made.error());
            setFile(std::move(*made));
            reportWritten();
        }
        m_written.store(m_file->events(), std::memory_order_release);
    }
}

void JournalLoop::setFile(std::shared_ptr<recording::JournalFile> file)
{
    if (m_file && !file)
        m_file->remove();
    m_file = std::move(file);
    const std::lock_guard lock(m_mutex);
    m_toSync = m_file;
}

void JournalLoop::reportWritten()
{
    {
        const std::lock_guard lock(m_mutex);
        m_isToBeSynced = true;
    }
    m_somethingWritten.notify_one();
}

/// Waits until something was written, but at most kPeriod, then syncs the file. Runs in the thread that syncs.
void JournalLoop::syncWhenWritten()
{
    {
        std::unique_lock lock(m_mutex);
        m_somethingWritten.wait_for(lock, kPeriod, [this] { return m_isToBeSynced; });
        m_isToBeSynced = false;
    }
    sync();
}

/// Syncs the file once. Runs in the thread that syncs.
void JournalLoop::sync()
{
    std::shared_ptr<recording::JournalFile> file;
    {
        const std::lock_guard lock(m_mutex);
        file = m_toSync;
    }
    const Status done = file ? file->sync() : Status();
    if (!done && !m_cannotSync)
        tell(done.error());
    m_cannotSync = !done;
}

/// Begins a new attempt. The user has already answered the question about the unfinished one.
void JournalLoop::beginWith(std::uint64_t generation)
{
    setFile(nullptr);
    m_older.reset();
    m_written.store(0, std::memory_order_release);
    const std::lock_guard lock(m_mutex);
    m_generation = generation;
    if (m_found && m_found->generation == generation) {
        m_begunUtcMs = m_found->begunUtcMs;
        m_path = m_found->path;
        m_older = std::move(m_found->lock);
    } else {
        const auto now = std::chrono::system_clock::now().time_since_epoch();
        m_begunUtcMs = std::chrono::duration_cast<std::chrono::milliseconds>(now).count();
        m_path = m_folder / (std::to_string(m_begunUtcMs) + "-" + std::to_string(getpid()) + ".cuspjournal");
    }
    if (m_found && m_found->generation <= generation)
        m_found.reset();
}

void JournalLoop::takeUp(std::uint64_t generation, recording::FoundAttempt found)
{
    const std::lock_guard lock(m_mutex);
    m_found = {generation, std::move(found.path), found.begunUtcMs, std::move(found.lock)};
}

std::filesystem::path JournalLoop::fileOf(std::uint64_t generation)
{
    const std::lock_guard lock(m_mutex);
    return generation == m_generation ? m_path : std::filesystem::path();
}

void JournalLoop::putAway()
{
    setFile(nullptr);
}

std::optional<Error> JournalLoop::failure()
{
    const std::lock_guard lock(m_mutex);
    return std::exchange(m_failure, std::nullopt);
}

}  // namespace core::session
