// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recording/Recording.h"

#include <array>
#include <cmath>
#include <fstream>
#include <limits>

#include <zstd.h>

#include "core/base/Bytes.h"
#include "core/base/WholeFile.h"

namespace core::recording {
namespace {

using session::ServoEvent;

constexpr std::string_view kMagic{"CUSPREC\n", 8};
constexpr std::uint32_t kVersion = 3;
constexpr std::size_t kChunkEvents = 4096;
constexpr int kPackLevel = 3;

constexpr std::uint64_t kMaxToothBytes = std::uint64_t{64} * 1024 * 1024;
constexpr std::uint64_t kMaxChunkBytes = std::uint64_t{1} * 1024 * 1024;
/// Columns that the undo steps of one recording may set back, all together: 44,000 steps at grid 150, half a minute's
/// work. A small hostile file could otherwise ask for hours.
constexpr std::uint64_t kMaxRestoredColumns = 1'000'000'000;
constexpr std::uintmax_t kMaxFileBytes = std::uintmax_t{1024} * 1024 * 1024;

enum class Section : std::uint32_t { Settings = 1, Tooth = 2, Events = 3, End = 4 };

std::string pack(std::string_view raw)
{
    std::string packed(ZSTD_compressBound(raw.size()), '\0');
    const std::size_t size = ZSTD_compress(packed.data(), packed.size(), raw.data(), raw.size(), kPackLevel);
    packed.resize(size);  // with the bound given, ZSTD_compress cannot fail but for lack of memory
    return packed;
}

std::optional<std::string> unpack(std::string_view packed, std::uint64_t mostBytes)
{
    const unsigned long long size = ZSTD_getFrameContentSize(packed.data(), packed.size());
    if (size == ZSTD_CONTENTSIZE_ERROR || size == ZSTD_CONTENTSIZE_UNKNOWN || size > mostBytes)
        return std::nullopt;
    std::string raw(static_cast<std::size_t>(size), '\0');
    const std::size_t got = ZSTD_decompress(raw.data(), raw.size(), packed.data(), packed.size());
    if (ZSTD_isError(got) != 0 || got != raw.size())
        return std::nullopt;
    return raw;
}

void putSection(ByteWriter& out, Section kind, std::string_view payload)
{
    out.put(static_cast<std::uint32_t>(kind));
    out.put(static_cast<std::uint64_t>(payload.size()));
    out.put(fnv1a(payload));
    out.putAll(std::span(payload.data(), payload.size()));
}

std::string settingsBytes(const session::ServoSettings& settings)
{
    ByteWriter out;
    out.putText(settings.method);
    out.put(settings.force.stiffnessNPerMm);
    out.put(settings.force.dampingNSPerM);
    out.put(settings.force.fastDampingNSPerM);
    out.put(settings.force.brakeN);
    out.put(settings.force.friction);
    out.put(settings.force.lateralGain);
    out.put(settings.force.verticalGain);
    out.put(settings.force.clampN);
    out.put(settings.force.slewNPerS);
    out.put(settings.force.workAreaMm);
    out.put(settings.force.vibrationN);
    out.putText(settings.hardness.name);
    for (const settings::MaterialHardness& material : settings.hardness.material) {
        out.put(material.rateMm3PerNs);
        out.put(material.thresholdN);
    }
    out.put(settings.hardness.axialShare);
    out.putText(settings.handpiece.name);
    out.put(settings.handpiece.freeRpm);
    out.put(settings.handpiece.stallTorqueNmm);
    out.put(static_cast<std::uint8_t>(settings.breakOff.on ? 1 : 0));
    out.put(settings.breakOff.slenderness);
    return out.bytes();
}

std::optional<session::ServoSettings> settingsFrom(std::string_view bytes)
{
    ByteReader in(bytes);
    session::ServoSettings settings;
    settings.method = in.takeText();
    settings.force.stiffnessNPerMm = in.take<double>();
    settings.force.dampingNSPerM = in.take<double>();
    settings.force.fastDampingNSPerM = in.take<double>();
    settings.force.brakeN = in.take<double>();
    settings.force.friction = in.take<double>();
    settings.force.lateralGain = in.take<double>();
    settings.force.verticalGain = in.take<double>();
    settings.force.clampN = in.take<double>();
    settings.force.slewNPerS = in.take<double>();
    settings.force.workAreaMm = in.take<double>();
    settings.force.vibrationN = in.take<double>();
    settings.hardness.name = in.takeText();
    for (settings::MaterialHardness& material : settings.hardness.material) {
        material.rateMm3PerNs = in.take<double>();
        material.thresholdN = in.take<double>();
    }
    settings.hardness.axialShare = in.take<double>();
    settings.handpiece.name = in.takeText();
    settings.handpiece.freeRpm = in.take<double>();
    settings.handpiece.stallTorqueNmm = in.take<double>();
    settings.breakOff.on = in.take<std::uint8_t>() != 0;
    settings.breakOff.slenderness = in.take<double>();
    if (!in.ok() || in.left() != 0)
        return std::nullopt;
    return settings;
}

std::string toothBytes(const terrain::ToothAnatomy& tooth)
{
    ByteWriter out;
    out.putText(tooth.name);
    out.put(static_cast<std::int32_t>(tooth.fdi));
    out.put(tooth.seed);
    out.put(static_cast<std::int32_t>(tooth.grid.side));
    out.put(tooth.grid.cellMm);
    out.put(tooth.grid.originMm.x);
    out.put(tooth.grid.originMm.y);
    out.putAll(std::span(std::as_const(tooth.top)));
    out.putAll(std::span(std::as_const(tooth.bottom)));
    out.putAll(std::span(std::as_const(tooth.layers)));
    out.putAll(std::span(std::as_const(tooth.areaMm2)));
    return out.bytes();
}

bool plausible(const terrain::ToothAnatomy& tooth)
{
    // Every height is finite and within the sentinels; areas are not negative; nothing else is relied upon.
    const auto sane = [](float v) { return v >= terrain::kEmptyTop && v <= terrain::kEmptyBottom; };
    for (std::size_t k = 0; k < tooth.top.size(); ++k) {
        const terrain::ColumnLayers& c = tooth.layers[k];
        if (!(sane(tooth.top[k]) && sane(tooth.bottom[k]) && sane(c.cariesRoof) && sane(c.cariesFloor) && sane(c.dej) &&
              sane(c.pulpRoof) && sane(c.pulpFloor) && tooth.areaMm2[k] >= 0.0F && tooth.areaMm2[k] < 1.0e3F))
            return false;
    }
    return true;
}

std::shared_ptr<const terrain::ToothAnatomy> toothFrom(std::string_view bytes)
{
    ByteReader in(bytes);
    auto tooth = std::make_shared<terrain::ToothAnatomy>();
    tooth->name = in.takeText();
    tooth->fdi = in.take<std::int32_t>();
    tooth->seed = in.take<std::uint64_t>();
    tooth->grid.side = in.take<std::int32_t>();
    tooth->grid.cellMm = in.take<double>();
    tooth->grid.originMm.x = in.take<double>();
    tooth->grid.originMm.y = in.take<double>();
    const terrain::Grid& grid = tooth->grid;
    const bool gridIsSane = grid.side >= terrain::kMinGridSide && grid.side <= terrain::kMaxGridSide &&
                            grid.cellMm >= 0.005 && grid.cellMm <= 1.0 && std::abs(grid.originMm.x) < 1.0e4 &&
                            std::abs(grid.originMm.y) < 1.0e4;
    if (!in.ok() || !gridIsSane || in.left() != grid.count() * (3 * sizeof(float) + sizeof(terrain::ColumnLayers)))
        return nullptr;
    tooth->top.resize(grid.count());
    tooth->bottom.resize(grid.count());
    tooth->layers.resize(grid.count());
    tooth->areaMm2.resize(grid.count());
    in.takeAll(std::span(tooth->top));
    in.takeAll(std::span(tooth->bottom));
    in.takeAll(std::span(tooth->layers));
    in.takeAll(std::span(tooth->areaMm2));
    return in.ok() && plausible(*tooth) ? tooth : nullptr;
}

/// Kinds, steps and the four byte planes of each coordinate, one after another: like stands beside like.
std::string eventBytes(std::span<const ServoEvent> events)
{
    ByteWriter out;
    out.put(static_cast<std::uint32_t>(events.size()));
    for (const ServoEvent& event : events)
        out.put(static_cast<std::uint8_t>(event.kind));
    for (const ServoEvent& event : events)
        out.put(event.dtUs);
    for (int axis = 0; axis < 3; ++axis) {
        for (unsigned shift = 0; shift < 32; shift += 8) {
            std::uint32_t before = 0;
            for (const ServoEvent& event : events) {
                const auto bits = std::bit_cast<std::uint32_t>(event.deviceMm[axis]);
                out.put(static_cast<std::uint8_t>((bits ^ before) >> shift));
                before = bits;
            }
        }
    }
    for (const ServoEvent& event : events)
        if (event.kind != ServoEvent::Kind::Tick && event.kind != ServoEvent::Kind::NoDevice)
            out.put(event.value);
    return out.bytes();
}

std::optional<std::vector<ServoEvent>> eventsFrom(std::string_view bytes)
{
    ByteReader in(bytes);
    const auto count = in.take<std::uint32_t>();
    if (count > kChunkEvents)
        return std::nullopt;
    std::vector<ServoEvent> events(count);
    for (ServoEvent& event : events) {
        const auto kind = in.take<std::uint8_t>();
        if (kind > static_cast<std::uint8_t>(ServoEvent::Kind::Home))
            return std::nullopt;
        event.kind = static_cast<ServoEvent::Kind>(kind);
    }
    for (ServoEvent& event : events)
        event.dtUs = in.take<std::uint16_t>();
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<std::uint32_t> bits(count, 0);
        for (unsigned shift = 0; shift < 32; shift += 8)
            for (std::uint32_t& word : bits)
                word |= static_cast<std::uint32_t>(in.take<std::uint8_t>()) << shift;
        std::uint32_t before = 0;
        for (std::size_t k = 0; k < bits.size(); ++k) {
            before ^= bits[k];
            events[k].deviceMm[axis] = std::bit_cast<float>(before);
        }
    }
    for (ServoEvent& event : events) {
        if (event.kind == ServoEvent::Kind::Tick || event.kind == ServoEvent::Kind::NoDevice)
            continue;
        event.value = in.take<std::uint64_t>();
        if (event.kind == ServoEvent::Kind::Bur && event.value >= drilling::burs().size())
            return std::nullopt;
        if (event.kind == ServoEvent::Kind::Spring && (event.value < 1 || event.value > 100))
            return std::nullopt;
    }
    if (!in.ok() || in.left() != 0)
        return std::nullopt;
    return events;
}

/// @param place  "in its settings"
tl::unexpected<Error> damaged(std::string_view place)
{
    return unexpected(ErrorCode::BadStructure, "The recording is damaged " + std::string(place) +
                                                   ". Use a copy of the file, or make the attempt again.");
}

}  // namespace

Recording::Recording(session::ServoSettings settings, std::shared_ptr<const terrain::ToothAnatomy> anatomy)
    : m_settings(std::move(settings)), m_anatomy(std::move(anatomy))
{
    m_tail.reserve(kChunkEvents);
}

void Recording::append(const ServoEvent& event)
{
    m_tail.push_back(event);
    if (event.kind == ServoEvent::Kind::Tick || event.kind == ServoEvent::Kind::NoDevice) {
        ++m_ticks;
        m_duration += std::chrono::microseconds(event.dtUs);
    }
    if (m_tail.size() == kChunkEvents)
        packTail();
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

void Recording::forEach(const std::function<void(const ServoEvent&)>& visit) const
{
    for (const std::string& chunk : m_chunks) {
        // Packed by us, or checked when it was read.
        const auto raw = unpack(chunk, kMaxChunkBytes);
        const auto events = raw ? eventsFrom(*raw) : std::nullopt;
        for (const ServoEvent& event : events.value_or(std::vector<ServoEvent>{}))
            visit(event);
    }
    for (const ServoEvent& event : m_tail)
        visit(event);
}

std::string Recording::toBytes() const
{
    ByteWriter out;
    out.putAll(std::span(kMagic.data(), kMagic.size()));
    out.put(kVersion);
    putSection(out, Section::Settings, pack(settingsBytes(m_settings)));
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

Result<Recording> Recording::fromBytes(std::string_view bytes)
{
    if (bytes.empty())
        return unexpected(ErrorCode::FileEmpty, "The recording is empty; choose another file.");
    ByteReader in(bytes);
    if (in.takeBytes(kMagic.size()) != kMagic)
        return unexpected(ErrorCode::WrongKind, "This is not a Cusp recording; choose a file that Cusp has saved.");
    const auto version = in.take<std::uint32_t>();
    if (in.ok() && version == 0)
        return unexpected(ErrorCode::WrongKind, "This is not a Cusp recording; choose a file that Cusp has saved.");
    if (in.ok() && version > kVersion)
        return unexpected(ErrorCode::NewerVersion, "The recording is of version " + std::to_string(version) +
                                                       ", this Cusp reads up to version " + std::to_string(kVersion) +
                                                       "; open it with a newer Cusp.");
    if (in.ok() && version < kVersion)
        return unexpected(ErrorCode::WrongKind, "The recording is of version " + std::to_string(version) +
                                                    ", from an older Cusp; this one reads version " +
                                                    std::to_string(kVersion) +
                                                    " only. Make the attempt again, or keep the Cusp that made it.");
    std::optional<session::ServoSettings> settings;
    std::shared_ptr<const terrain::ToothAnatomy> anatomy;
    std::optional<Recording> recording;
    std::uint64_t restoredColumns = 0;
    while (in.ok()) {
        const auto kind = in.take<std::uint32_t>();
        const auto size = in.take<std::uint64_t>();
        const auto checksum = in.take<std::uint64_t>();
        if (!in.ok() || size > in.left())
            break;
        const std::string_view payload = in.takeBytes(static_cast<std::size_t>(size));
        if (fnv1a(payload) != checksum)
            return damaged("in section " + std::to_string(kind));
        switch (static_cast<Section>(kind)) {
        case Section::Settings: {
            const auto raw = unpack(payload, kMaxChunkBytes);
            settings = raw ? settingsFrom(*raw) : std::nullopt;
            if (!settings)
                return damaged("in its settings");
            if (auto servo = session::makeServoTick(*settings); !servo)
                return tl::unexpected(servo.error());
            break;
        }
        case Section::Tooth: {
            const auto raw = unpack(payload, kMaxToothBytes);
            anatomy = raw ? toothFrom(*raw) : nullptr;
            if (!anatomy || !settings || recording)
                return damaged("in its tooth");
            recording.emplace(*settings, anatomy);
            break;
        }
        case Section::Events: {
            const auto raw = unpack(payload, kMaxChunkBytes);
            const auto events = raw ? eventsFrom(*raw) : std::nullopt;
            if (!events || !recording)
                return damaged("in its events");
            for (const ServoEvent& event : *events) {
                if (event.kind == ServoEvent::Kind::Restore && event.value > recording->m_ticks)
                    return damaged("in an undo step");
                restoredColumns += event.kind == ServoEvent::Kind::Restore ? anatomy->grid.count() : 0;
                if (restoredColumns > kMaxRestoredColumns)
                    return unexpected(ErrorCode::BadStructure, "The recording has more undo steps than anyone makes; "
                                                               "it was not made by Cusp and is not replayed.");
                recording->append(event);
            }
            break;
        }
        case Section::End: {
            ByteReader end(payload);
            const auto ticks = end.take<std::uint64_t>();
            const bool hasWitness = end.take<std::uint8_t>() != 0;
            Witness witness;
            witness.tick = end.take<std::uint64_t>();
            witness.stateHash = end.take<std::uint64_t>();
            if (!end.ok() || !recording || ticks != recording->m_ticks || witness.tick > ticks)
                return damaged("at its end");
            if (in.left() != 0)
                return damaged("behind its end, where nothing should be");
            if (hasWitness)
                recording->setWitness(witness);
            return std::move(*recording);
        }
        default:
            return damaged("in section " + std::to_string(kind));
        }
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
        if (bytes.size() > kMaxFileBytes)
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
