// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recording/Recording.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <fstream>

#include "core/base/Bytes.h"
#include "core/base/WholeFile.h"
#include "core/recording/Format.h"

namespace core::recording {
namespace {

constexpr std::string_view kRecordingMagic{"CUSPREC\n", 8};
constexpr std::uintmax_t kMaxRecordingBytes = std::uintmax_t{1024} * 1024 * 1024;

void putSection(ByteWriter& out, Section kind, std::string_view payload)
{
    out.put(static_cast<std::uint32_t>(kind));
    out.put(static_cast<std::uint64_t>(payload.size()));
    out.put(fnv1a(payload));
    out.putAll(std::span(payload.data(), payload.size()));
}

/// Unpacks a chunk that this program has packed, or has checked when it was read.
std::vector<ServoEvent> unpackedEvents(std::string_view chunk)
{
    const auto raw = unpack(chunk, kMaxChunkBytes);
    return (raw ? eventsFrom(*raw) : std::nullopt).value_or(std::vector<ServoEvent>{});
}

/// @param place  where the recording is damaged: "in its settings"
tl::unexpected<Error> damaged(std::string_view place)
{
    return unexpected(ErrorCode::BadStructure, "The recording is damaged " + std::string(place) +
                                                   ". Use a copy of the file, or make the attempt again.");
}

tl::unexpected<Error> tooLong()
{
    return unexpected(ErrorCode::FileTooLarge, "The recording is longer than six hours, the longest attempt that Cusp "
                                               "records; it is not read.");
}

/// Checks that a recording begins here, in a version that this program can read.
Status readHead(ByteReader& in)
{
    constexpr const char* kOtherFile = "This is not a Cusp recording; choose a file that Cusp has saved.";
    if (in.takeBytes(kRecordingMagic.size()) != kRecordingMagic)
        return unexpected(ErrorCode::WrongKind, kOtherFile);
    const auto version = in.take<std::uint32_t>();
    if (in.ok() && version == 0)
        return unexpected(ErrorCode::WrongKind, kOtherFile);
    if (in.ok() && version > kFormatVersion)
        return unexpected(ErrorCode::NewerVersion, "The recording is of version " + std::to_string(version) +
                                                       ", this Cusp reads up to version " +
                                                       std::to_string(kFormatVersion) + "; open it with a newer Cusp.");
    if (in.ok() && version < kOldestVersion)
        return unexpected(ErrorCode::WrongKind, "The recording is of version " + std::to_string(version) +
                                                    ", from an older Cusp; this one reads from version " +
                                                    std::to_string(kOldestVersion) +
                                                    " on. Make the attempt again, or keep the Cusp that made it.");
    return {};
}

/// A section as it is stored.
struct StoredSection
{
    std::uint32_t kind = 0;
    std::uint64_t checksum = 0;
    std::string_view payload;
};

/// Returns the next section; empty if no complete one is left.
std::optional<StoredSection> takeSection(ByteReader& in)
{
    StoredSection section;
    section.kind = in.take<std::uint32_t>();
    const auto size = in.take<std::uint64_t>();
    section.checksum = in.take<std::uint64_t>();
    if (!in.ok() || size > in.left())
        return std::nullopt;
    section.payload = in.takeBytes(static_cast<std::size_t>(size));
    return section;
}

/// Checks, without unpacking it, that a recording is no longer than one can be: a few kilobytes unpack to years.
/// @param in  behind the head of the recording
Status checkLength(ByteReader in)
{
    std::uint64_t unpackedBytes = 0;
    while (const auto section = takeSection(in)) {
        // A section that declares more than one can have is damaged, which readEvents() reports.
        const std::uint64_t bytes = unpackedSize(section->payload).value_or(0);
        if (static_cast<Section>(section->kind) == Section::Events && bytes <= kMaxChunkBytes)
            unpackedBytes += bytes;
        if (unpackedBytes > kMaxEventBytes)
            return tooLong();
    }
    return {};
}

/// Reads the sections of a recording in the order in which they are stored.
class SectionReader
{
public:
    /// Reads one section; `End` is read by readEnd().
    Status read(Section kind, std::string_view payload)
    {
        switch (kind) {
        case Section::Settings:
            return readSettings(payload);
        case Section::Lesson:
            return readLesson(payload);
        case Section::Tooth:
            return readTooth(payload);
        case Section::Events:
            return readEvents(payload);
        case Section::End:
        case Section::Begun:
        default:
            return damaged("in section " + std::to_string(static_cast<std::uint32_t>(kind)));
        }
    }

    /// Reads the last section and returns the whole recording.
    /// @param left  number of bytes after this section
    Result<Recording> readEnd(std::string_view payload, std::size_t left)
    {
        ByteReader end(payload);
        const auto ticks = end.take<std::uint64_t>();
        const bool hasWitness = end.take<std::uint8_t>() != 0;
        Witness witness;
        witness.tick = end.take<std::uint64_t>();
        witness.stateHash = end.take<std::uint64_t>();
        if (!end.ok() || !m_recording || ticks != m_recording->ticks() || witness.tick > ticks)
            return damaged("at its end");
        if (left != 0)
            return damaged("behind its end, where nothing should be");
        if (hasWitness)
            m_recording->setWitness(witness);
        return std::move(*m_recording);
    }

private:
    Status readSettings(std::string_view payload)
    {
        const auto raw = unpack(payload, kMaxChunkBytes);
        m_settings = raw ? settingsFrom(*raw) : std::nullopt;
        if (!m_settings)
            return damaged("in its settings");
        if (auto servo = servo::makeServoTick(*m_settings); !servo)
            return tl::unexpected(servo.error());
        return {};
    }

    Status readLesson(std::string_view payload)
    {
        auto raw = unpack(payload, kMaxLessonBytes);
        if (!raw || raw->empty() || !checkLesson(*raw) || !m_lesson.empty() || m_recording)
            return damaged("in its lesson");
        m_lesson = std::move(*raw);
        return {};
    }

    Status readTooth(std::string_view payload)
    {
        const auto raw = unpack(payload, kMaxToothBytes);
        const auto anatomy = raw ? toothFrom(*raw) : nullptr;
        if (!anatomy || !m_settings || m_recording)
            return damaged("in its tooth");
        m_recording.emplace(*m_settings, anatomy, m_lesson);
        return {};
    }

    Status readEvents(std::string_view payload)
    {
        const auto raw = unpack(payload, kMaxChunkBytes);
        const auto events = raw ? eventsFrom(*raw) : std::nullopt;
        if (!events || !m_recording)
            return damaged("in its events");
        if (m_recording->events() + events->size() > kMaxEvents)
            return tooLong();
        for (const ServoEvent& event : *events) {
            switch (m_guard.look(event, *m_recording)) {
            case EventGuard::Verdict::Sound:
                break;
            case EventGuard::Verdict::IntoTheFuture:
                return damaged("in an undo step");
            case EventGuard::Verdict::BurOfNewerCusp:
                return unexpected(ErrorCode::NewerVersion,
                                  "The recording " + unknownBurWords(event.value) + "; open it with a newer Cusp.");
            case EventGuard::Verdict::NoSuchHandpiece:
                return damaged("where another handpiece is taken");
            case EventGuard::Verdict::TooManySteps:
                return unexpected(ErrorCode::BadStructure, "The recording has more undo steps than anyone makes; "
                                                           "it was not made by Cusp and is not replayed.");
            }
            m_recording->append(event);
        }
        return {};
    }

    std::optional<servo::ServoSettings> m_settings;
    std::string m_lesson;
    std::optional<Recording> m_recording;
    EventGuard m_guard;
};

}  // namespace

Recording::Recording(servo::ServoSettings settings, std::shared_ptr<const terrain::ToothAnatomy> anatomy,
                     std::string lesson)
    : m_settings(std::move(settings)), m_anatomy(std::move(anatomy)), m_lesson(std::move(lesson))
{
    assert(checkLesson(m_lesson));
    m_tail.reserve(kChunkEvents);
}

void Recording::append(const ServoEvent& event)
{
    assert(events() < kMaxEvents);
    m_tail.push_back(event);
    m_isRetuned = m_isRetuned || event.kind == ServoEvent::Kind::Number;
    m_version = std::max(m_version, versionWith(event));
    if (isTick(event.kind)) {
        ++m_ticks;
        m_duration += std::chrono::microseconds(event.dtUs);
    }
    if (m_tail.size() == kChunkEvents)
        packTail();
}

bool Recording::isFull() const
{
    return m_duration >= kLongestAttempt || events() >= kEventsOfLongestAttempt;
}

void Recording::packTail()
{
    m_chunks.push_back(pack(eventBytes(m_tail)));
    m_tail.clear();
}

std::size_t Recording::packedBytes() const
{
    std::size_t sum = 0;
    for (const std::string& chunk : m_chunks)
        sum += chunk.size();
    return sum;
}

std::uint64_t Recording::events() const
{
    return kChunkEvents * m_chunks.size() + m_tail.size();
}

std::vector<ServoEvent> Recording::eventsSince(std::uint64_t first) const
{
    const auto chunk = static_cast<std::size_t>(first / kChunkEvents);
    const auto inside = static_cast<std::ptrdiff_t>(first % kChunkEvents);
    if (first >= events())
        return {};
    if (chunk == m_chunks.size())
        return {m_tail.begin() + inside, m_tail.end()};
    std::vector<ServoEvent> events = unpackedEvents(m_chunks[chunk]);
    events.erase(events.begin(), events.begin() + inside);
    return events;
}

void Recording::forEach(const std::function<void(const ServoEvent&)>& visit) const
{
    for (const std::string& chunk : m_chunks) {
        for (const ServoEvent& event : unpackedEvents(chunk))
            visit(event);
    }
    for (const ServoEvent& event : m_tail)
        visit(event);
}

std::string Recording::toBytes() const
{
    ByteWriter out;
    out.putAll(std::span(kRecordingMagic.data(), kRecordingMagic.size()));
    out.put(std::max({m_version, versionWith(m_settings), versionWith(*m_anatomy)}));
    putSection(out, Section::Settings, pack(settingsBytes(m_settings)));
    if (!m_lesson.empty())
        putSection(out, Section::Lesson, pack(m_lesson));
    putSection(out, Section::Tooth, pack(toothBytes(*m_anatomy)));
    for (const std::string& chunk : m_chunks)
        putSection(out, Section::Events, chunk);
    if (!m_tail.empty())
        putSection(out, Section::Events, pack(eventBytes(m_tail)));
    ByteWriter end;
    end.put(m_ticks);
    end.put(static_cast<std::uint8_t>(m_witness.has_value() ? 1 : 0));
    end.put(m_witness.value_or(Witness{}).tick);
    end.put(m_witness.value_or(Witness{}).stateHash);
    putSection(out, Section::End, end.bytes());
    return out.bytes();
}

Status checkLesson(std::string_view lesson)
{
    if (lesson.size() > kMaxLessonBytes)
        return unexpected(ErrorCode::FileTooLarge,
                          "The lesson is longer than a recording may hold (1 MiB); shorten it.");
    if (!isUtf8(lesson))
        return unexpected(ErrorCode::BadStructure, "The lesson is not UTF-8 text; save it as such.");
    return {};
}

Result<Recording> Recording::fromBytes(std::string_view bytes)
{
    if (bytes.empty())
        return unexpected(ErrorCode::FileEmpty, "The recording is empty; choose another file.");
    ByteReader in(bytes);
    if (const Status head = readHead(in); !head)
        return tl::unexpected(head.error());
    if (const Status length = checkLength(in); !length)
        return tl::unexpected(length.error());
    SectionReader sections;
    while (const auto section = takeSection(in)) {
        if (fnv1a(section->payload) != section->checksum)
            return damaged("in section " + std::to_string(section->kind));
        if (static_cast<Section>(section->kind) == Section::End)
            return sections.readEnd(section->payload, in.left());
        if (const Status read = sections.read(static_cast<Section>(section->kind), section->payload); !read)
            return tl::unexpected(read.error());
    }
    return unexpected(ErrorCode::FileTruncated,
                      "The recording ends early: it was cut off while being written or copied. Use a whole copy.");
}

Result<Recording> readRecording(const std::filesystem::path& path)
{
    std::error_code failure;
    const auto status = std::filesystem::status(path, failure);
    if (!std::filesystem::exists(status))
        return unexpected(ErrorCode::FileMissing, "There is no recording at " + path.string() + "; check the name.");
    if (std::filesystem::is_directory(status))
        return unexpected(ErrorCode::FileUnreadable, path.string() + " is a folder; name a recording in it.");
    if (!std::filesystem::is_regular_file(status))
        return unexpected(ErrorCode::FileUnreadable, path.string() + " is not a file; name a recording.");
    std::ifstream file(path, std::ios::binary);
    if (!file)
        return unexpected(ErrorCode::FileUnreadable,
                          "The recording " + path.string() + " cannot be opened; check its rights.");
    std::string bytes;
    std::array<char, 65536> block{};
    while (file.read(block.data(), block.size()), file.gcount() > 0) {
        bytes.append(block.data(), static_cast<std::size_t>(file.gcount()));
        if (bytes.size() > kMaxRecordingBytes)
            return unexpected(ErrorCode::FileTooLarge,
                              path.string() + " is larger than any recording; choose another file.");
    }
    auto recording = Recording::fromBytes(bytes);
    if (!recording)
        return unexpected(recording.error().code, path.string() + ": " + recording.error().detail);
    return recording;
}

Status writeRecording(const std::filesystem::path& path, const Recording& recording)
{
    return writeWhole(path, recording.toBytes(), "The recording");
}

}  // namespace core::recording
