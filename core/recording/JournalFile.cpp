// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recording/JournalFile.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <map>
#include <string>
#include <system_error>
#include <thread>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/base/Bytes.h"
#include "core/recording/Format.h"

namespace core::recording {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kJournalMagic{"CUSPJRN\n", 8};
constexpr std::string_view kSuffix = ".cuspjournal";
constexpr std::string_view kPart = ".part";
constexpr std::string_view kDiscarded = "discarded";
constexpr std::chrono::hours kKeptDiscarded{7 * 24};
constexpr std::size_t kMaxJournalBytes = std::size_t{256} * 1024 * 1024;

struct Frame
{
    Section kind{};
    std::uint64_t first = 0;  ///< number of the first event
    std::string_view payload;
};

std::string frameBytes(const Frame& frame)
{
    ByteWriter out;
    out.put(static_cast<std::uint32_t>(frame.kind));
    out.put(static_cast<std::uint32_t>(frame.payload.size()));
    out.put(frame.first);
    out.put(fnv1a(frame.payload, fnv1a(out.bytes())));
    out.putAll(std::span(frame.payload.data(), frame.payload.size()));
    return out.bytes();
}

/// Returns the next frame; empty if no complete frame is left. Do not use `in` after that.
std::optional<Frame> takeFrame(ByteReader& in)
{
    const std::string_view head = in.takeBytes(sizeof(std::uint32_t) * 2 + sizeof(std::uint64_t));
    ByteReader fields(head);
    Frame frame;
    frame.kind = static_cast<Section>(fields.take<std::uint32_t>());
    const auto size = fields.take<std::uint32_t>();
    frame.first = fields.take<std::uint64_t>();
    const auto checksum = in.take<std::uint64_t>();
    frame.payload = in.takeBytes(size);
    if (!in.ok() || fnv1a(frame.payload, fnv1a(head)) != checksum)
        return std::nullopt;
    return frame;
}

std::string headBytes(const Recording& recording, std::int64_t begunUtcMs)
{
    ByteWriter out;
    out.putAll(std::span(kJournalMagic.data(), kJournalMagic.size()));
    out.put(kFormatVersion);
    ByteWriter begun;
    begun.put(begunUtcMs);
    std::string bytes = out.bytes() + frameBytes({Section::Begun, 0, begun.bytes()}) +
                        frameBytes({Section::Settings, 0, pack(settingsBytes(recording.settings()))});
    if (!recording.lesson().empty())
        bytes += frameBytes({Section::Lesson, 0, pack(recording.lesson())});
    return bytes + frameBytes({Section::Tooth, 0, pack(toothBytes(*recording.anatomy()))});
}

/// Returns the temporary path of a journal, which it has until it is on the disk.
fs::path partOf(fs::path path)
{
    path += kPart;
    return path;
}

tl::unexpected<Error> unwritable(const fs::path& path, int number)
{
    return unexpected(ErrorCode::FileUnwritable, "The attempt could not be kept on the disk while it goes on, in '" +
                                                     path.string() + "': " + std::system_category().message(number) +
                                                     ".");
}

/// Creates a file, or opens an existing one, and locks it. Between the two steps, a search for attempts may remove the
/// file because it is empty; it is then created again. Does not open a file that another program has locked. Returns -1
/// with errno set on failure.
int createLocked(const fs::path& path)
{
    constexpr int kTries = 50;
    constexpr std::chrono::milliseconds kRest{10};
    for (int n = 0; n < kTries; ++n) {
        const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
        if (file < 0)
            return file;
        // If the file system does not support locks, no other program is excluded.
        const bool isTaken = ::flock(file, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
        struct stat made
        {};
        struct stat named
        {};
        if (!isTaken && ::fstat(file, &made) == 0 && ::stat(path.c_str(), &named) == 0 && made.st_ino == named.st_ino &&
            made.st_dev == named.st_dev)
            return file;
        ::close(file);
        if (isTaken)
            std::this_thread::sleep_for(kRest);
    }
    errno = EWOULDBLOCK;
    return -1;
}

tl::unexpected<Error> nothingIn(ErrorCode code, const std::string& what)
{
    return unexpected(code, "The unfinished attempt cannot be taken up: " + what + ".");
}

}  // namespace

JournalLock::~JournalLock()
{
    if (m_file >= 0)
        ::close(m_file);
}

Result<std::shared_ptr<JournalFile>> JournalFile::create(const fs::path& path, const Recording& soFar,
                                                         std::int64_t begunUtcMs)
{
    std::error_code failure;
    if (fs::create_directories(path.parent_path(), failure))
        fs::permissions(path.parent_path(), fs::perms::owner_all, failure);
    const int file = createLocked(partOf(path));
    if (file < 0)
        return unwritable(path, errno);
    const std::shared_ptr<JournalFile> journal(new JournalFile(path, file));
    Status written;
    if (::ftruncate(file, 0) != 0 || !journal->write(headBytes(soFar, begunUtcMs)))
        written = unwritable(path, errno);
    for (std::vector<ServoEvent> events; written && !(events = soFar.eventsSince(journal->events())).empty();)
        written = journal->append(events);
    if (written)
        return journal;
    fs::remove(partOf(path), failure);  // removes the new file only; an older file of that name stays
    return tl::unexpected(written.error());
}

JournalFile::~JournalFile()
{
    if (m_file >= 0)
        ::close(m_file);
}

/// Writes all bytes or none. Sets errno on failure.
bool JournalFile::write(std::string_view bytes)
{
    std::string_view rest = bytes;
    while (!rest.empty()) {
        const ssize_t took =
            ::pwrite(m_file, rest.data(), rest.size(), static_cast<off_t>(m_bytes + (bytes.size() - rest.size())));
        if (took < 0 && errno == EINTR)
            continue;
        if (took <= 0) {
            const int number = took < 0 ? errno : ENOSPC;
            static_cast<void>(::ftruncate(m_file, static_cast<off_t>(m_bytes)));
            errno = number;
            return false;
        }
        rest.remove_prefix(static_cast<std::size_t>(took));
    }
    m_bytes += bytes.size();
    return true;
}

Status JournalFile::append(std::span<const ServoEvent> events)
{
    if (!write(frameBytes({Section::Events, m_events, pack(eventBytes(events))})))
        return unwritable(m_path, errno);
    m_events += events.size();
    return {};
}

Status JournalFile::sync()
{
    const std::uint64_t written = events();
    if (written == m_synced)
        return {};
    if (::fdatasync(m_file) != 0)
        return unwritable(m_path, errno);
    m_synced = written;
    {
        const std::lock_guard lock(m_nameMutex);
        if (m_hasItsName || m_isRemoved)
            return {};
        if (::rename(partOf(m_path).c_str(), m_path.c_str()) != 0)
            return unwritable(m_path, errno);
        m_hasItsName = true;
    }
    // The directory entry has to be on the disk as well.
    if (const int folder = ::open(m_path.parent_path().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC); folder >= 0) {
        static_cast<void>(::fsync(folder));
        ::close(folder);
    }
    return {};
}

void JournalFile::remove()
{
    const std::lock_guard lock(m_nameMutex);
    std::error_code ignored;
    fs::remove(partOf(m_path), ignored);
    fs::remove(m_path, ignored);
    m_isRemoved = true;
}

std::vector<fs::path> journalsIn(const fs::path& folder)
{
    std::map<fs::path, fs::file_time_type> found;
    std::error_code failure;
    for (fs::directory_iterator at(folder, failure), end; !failure && at != end; at.increment(failure)) {
        std::error_code gone;
        fs::path path = at->path();
        if (path.extension() == kPart)
            path.replace_extension();
        if (path.extension() != kSuffix || !at->is_regular_file(gone))
            continue;
        const fs::file_time_type time = at->last_write_time(gone);
        const auto entry = found.try_emplace(path, time).first;
        entry->second = std::max(entry->second, time);
    }
    std::vector<fs::path> paths;
    paths.reserve(found.size());
    for (const auto& [path, time] : found)
        paths.push_back(path);
    std::stable_sort(paths.rbegin(), paths.rend(),
                     [&](const fs::path& a, const fs::path& b) { return found[a] < found[b]; });
    return paths;
}

Result<FoundAttempt> attemptFrom(std::string_view bytes, const fs::path& path, JournalLock lock)
{
    ByteReader in(bytes);
    if (in.takeBytes(kJournalMagic.size()) != kJournalMagic)
        return nothingIn(ErrorCode::WrongKind, "its file is not a journal of Cusp");
    const auto version = in.take<std::uint32_t>();
    if (in.ok() && (version < kOldestVersion || version > kFormatVersion))
        return nothingIn(version > kFormatVersion ? ErrorCode::NewerVersion : ErrorCode::WrongKind,
                         "it is of version " + std::to_string(version) + ", this Cusp reads versions " +
                             std::to_string(kOldestVersion) + " to " + std::to_string(kFormatVersion) +
                             "; use the Cusp that made it");
    const auto cutOff = [] {
        return nothingIn(ErrorCode::FileTruncated, "its file is damaged before the first thing that was done");
    };
    std::optional<std::int64_t> begun;
    std::optional<servo::ServoSettings> settings;
    std::string lesson;
    std::shared_ptr<const terrain::ToothAnatomy> anatomy;
    while (!anatomy) {
        const auto frame = takeFrame(in);
        if (!frame)
            return cutOff();
        std::optional<std::string> raw;
        if (frame->kind != Section::Begun)
            raw = unpack(frame->payload, frame->kind == Section::Tooth ? kMaxToothBytes : kMaxChunkBytes);
        if (frame->kind == Section::Begun && !begun && frame->payload.size() == sizeof(std::int64_t)) {
            begun = ByteReader(frame->payload).take<std::int64_t>();
        } else if (frame->kind == Section::Settings && raw && begun && !settings) {
            settings = settingsFrom(*raw);
            if (!settings || !servo::makeServoTick(*settings))
                return cutOff();
        } else if (frame->kind == Section::Lesson && raw && settings && lesson.empty() && checkLesson(*raw)) {
            lesson = std::move(*raw);
        } else if (frame->kind == Section::Tooth && raw && settings) {
            anatomy = toothFrom(*raw);
            if (!anatomy)
                return cutOff();
        } else {
            return cutOff();
        }
    }
    FoundAttempt found{path, Recording(*settings, anatomy, std::move(lesson)), *begun, std::move(lock)};
    EventGuard guard;
    while (const auto frame = takeFrame(in)) {
        const auto raw = frame->kind == Section::Events ? unpack(frame->payload, kMaxChunkBytes) : std::nullopt;
        const auto events = raw ? eventsFrom(*raw) : std::nullopt;
        if (!events || frame->first != found.recording.events() || frame->first + events->size() > kMaxEvents)
            break;
        bool sound = true;
        for (const ServoEvent& event : *events) {
            const EventGuard::Verdict verdict = guard.look(event, found.recording);
            if (verdict == EventGuard::Verdict::BurOfNewerCusp)
                return nothingIn(ErrorCode::NewerVersion,
                                 "it " + unknownBurWords(event.value) + "; use the Cusp that made it");
            sound = sound && verdict == EventGuard::Verdict::Sound;
            if (sound)
                found.recording.append(event);
        }
        if (!sound)
            break;
    }
    if (found.recording.ticks() == 0)
        return cutOff();
    return found;
}

namespace {

enum class Access { Ours, Missing, InUse };

/// The content of a file that is locked.
struct LockedBytes
{
    Access access = Access::Missing;
    JournalLock lock;
    Result<std::string> bytes;
};

LockedBytes readLocked(const fs::path& path)
{
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0)
        return {errno == ENOENT ? Access::Missing : Access::Ours, JournalLock(),
                nothingIn(ErrorCode::FileUnreadable, std::system_category().message(errno))};
    LockedBytes read{Access::Ours, JournalLock(file), std::string()};
    // If the file system does not support locks, no other program is excluded.
    if (::flock(file, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
        read.access = Access::InUse;
        return read;
    }
    std::array<char, 65536> block{};
    for (ssize_t took = 0; (took = ::read(file, block.data(), block.size())) != 0;) {
        if (took < 0 && errno == EINTR)
            continue;
        if (took < 0)
            break;  // the part that was read may be sufficient
        read.bytes->append(block.data(), static_cast<std::size_t>(took));
        if (read.bytes->size() > kMaxJournalBytes) {
            read.bytes = nothingIn(ErrorCode::FileTooLarge, "its file is larger than any journal");
            break;
        }
    }
    return read;
}

/// Reads an attempt from locked bytes. If there is none, `read` keeps the lock.
Result<FoundAttempt> attemptIn(LockedBytes& read, const fs::path& path)
{
    if (!read.bytes)
        return tl::unexpected(read.bytes.error());
    auto found = attemptFrom(*read.bytes, path);
    if (found)
        found->lock = std::move(read.lock);
    return found;
}

}  // namespace

Result<std::optional<FoundAttempt>> findAttempt(const fs::path& path)
{
    LockedBytes part = readLocked(partOf(path));
    LockedBytes whole = readLocked(path);
    if (part.access == Access::InUse || whole.access == Access::InUse)
        return std::nullopt;
    const bool wasThere = whole.access != Access::Missing;
    auto found = attemptIn(whole, path);
    if (part.access == Access::Ours) {
        auto newer = attemptIn(part, path);
        std::error_code ignored;
        if (newer && (!found || newer->recording.events() >= found->recording.events())) {
            if (const int file = ::open(partOf(path).c_str(), O_RDONLY | O_CLOEXEC); file >= 0) {
                static_cast<void>(::fsync(file));
                ::close(file);
            }
            fs::rename(partOf(path), path, ignored);
            found = std::move(newer);
        } else {
            fs::remove(partOf(path), ignored);
        }
    }
    // A file that never got its final name contains only the first moments of an attempt.
    if (!found && !wasThere)
        return std::nullopt;
    if (!found)
        return unexpected(found.error().code, found.error().detail + " (" + path.string() + ")");
    return std::optional<FoundAttempt>(std::move(*found));
}

std::optional<fs::path> discardJournal(const fs::path& path)
{
    const fs::path folder = path.parent_path() / kDiscarded;
    std::error_code failure;
    fs::create_directories(folder, failure);
    fs::rename(path, folder / path.filename(), failure);
    if (failure) {
        fs::remove(path, failure);
        return std::nullopt;
    }
    // The days that the file is retained in the folder count from now.
    fs::last_write_time(folder / path.filename(), fs::file_time_type::clock::now(), failure);
    return folder / path.filename();
}

bool bringBackJournal(const fs::path& discarded)
{
    std::error_code failure;
    fs::rename(discarded, discarded.parent_path().parent_path() / discarded.filename(), failure);
    return !failure;
}

void tidyJournals(const fs::path& folder)
{
    std::error_code failure;
    for (fs::directory_iterator at(folder / kDiscarded, failure), end; !failure && at != end; at.increment(failure)) {
        std::error_code ignored;
        const auto age = fs::file_time_type::clock::now() - at->last_write_time(ignored);
        if (at->path().extension() == kSuffix && age > kKeptDiscarded)
            fs::remove(at->path(), ignored);
    }
}

}  // namespace core::recording
