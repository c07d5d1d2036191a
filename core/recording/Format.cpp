// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recording/Format.h"
#include "core/servo/ServoState.h"

#include <bit>
#include <cmath>
#include <string>
#include <utility>

#include <zstd.h>

#include "core/base/Bytes.h"
#include "core/bur/Bur.h"
#include "core/servo/ServoParameters.h"

namespace core::recording {
namespace {

constexpr int kPackLevel = 3;
constexpr std::uint8_t kHasDecayZones = 1;
constexpr std::uint32_t kWithNumbers = 6;
constexpr std::uint32_t kWithSpeeds = 7;
constexpr std::uint32_t kWithEndsAndFullLoad = 8;
constexpr std::uint32_t kWithDecayZones = 9;
/// Largest number of columns that all undo steps of one recording together may restore: 44,000 steps at grid 150, which
/// take half a minute. Otherwise a small hostile file could take hours.
constexpr std::uint64_t kMaxRestoredColumns = 1'000'000'000;

bool plausible(const terrain::ToothAnatomy& tooth)
{
    // Every height must be finite and within the sentinels, and areas must not be negative. The code relies on nothing
    // else.
    const auto sane = [](float v) { return v >= terrain::kEmptyTop && v <= terrain::kEmptyBottom; };
    for (std::size_t k = 0; k < tooth.top.size(); ++k) {
        const terrain::ColumnLayers& c = tooth.layers[k];
        if (!(sane(tooth.top[k]) && sane(tooth.bottom[k]) && sane(c.cariesRoof) && sane(c.cariesFloor) && sane(c.dej) &&
              sane(c.pulpRoof) && sane(c.pulpFloor) && tooth.areaMm2[k] >= 0.0F && tooth.areaMm2[k] < 1.0e3F))
            return false;
    }
    return true;
}

/// Returns whether an attempt has the cutting of versions of Cusp without flat ends and full loads.
bool isCutAsBefore(const settings::HardnessPreset& hardness)
{
    return hardness == settings::withoutEndsAndFullLoad(hardness);
}

}  // namespace

std::uint32_t versionWith(const ServoEvent& event)
{
    switch (event.kind) {
    case ServoEvent::Kind::Speed:
        return kWithSpeeds;
    case ServoEvent::Kind::Number:
        return servo::isOfFirstParameters(event.value) ? kWithNumbers : kWithEndsAndFullLoad;
    default:
        return kOldestVersion;
    }
}

std::uint32_t versionWith(const servo::ServoSettings& settings)
{
    if (settings.hardness.decayZones)
        return kWithDecayZones;
    return isCutAsBefore(settings.hardness) ? kOldestVersion : kWithEndsAndFullLoad;
}

std::string pack(std::string_view raw)
{
    std::string packed(ZSTD_compressBound(raw.size()), '\0');
    const std::size_t size = ZSTD_compress(packed.data(), packed.size(), raw.data(), raw.size(), kPackLevel);
    packed.resize(size);     // with this much space, ZSTD_compress fails only if memory runs out
    packed.shrink_to_fit();  // a recording keeps thousands of these for hours
    return packed;
}

std::optional<std::uint64_t> unpackedSize(std::string_view packed)
{
    const unsigned long long size = ZSTD_getFrameContentSize(packed.data(), packed.size());
    if (size == ZSTD_CONTENTSIZE_ERROR || size == ZSTD_CONTENTSIZE_UNKNOWN)
        return std::nullopt;
    return size;
}

std::optional<std::string> unpack(std::string_view packed, std::uint64_t mostBytes)
{
    const auto size = unpackedSize(packed);
    if (!size || *size > mostBytes)
        return std::nullopt;
    std::string raw(static_cast<std::size_t>(*size), '\0');
    const std::size_t got = ZSTD_decompress(raw.data(), raw.size(), packed.data(), packed.size());
    if (ZSTD_isError(got) != 0 || got != raw.size())
        return std::nullopt;
    return raw;
}

std::string settingsBytes(const servo::ServoSettings& settings)
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
    out.put(static_cast<std::uint8_t>(settings.handpieces.size()));
    for (const settings::Handpiece& handpiece : settings.handpieces) {
        out.putText(handpiece.name);
        out.put(handpiece.freeRpm);
        out.put(handpiece.stallTorqueNmm);
    }
    out.put(static_cast<std::uint8_t>(settings.breakOff.on ? 1 : 0));
    out.put(settings.breakOff.slenderness);
    const auto& zones = settings.hardness.decayZones;
    if (zones || !isCutAsBefore(settings.hardness)) {
        out.put(settings.hardness.flatEndShare);
        out.put(settings.hardness.fullLoadN);
    }
    if (zones) {
        for (const settings::MaterialHardness& zone : {zones->leathery, zones->firm}) {
            out.put(zone.rateMm3PerNs);
            out.put(zone.thresholdN);
        }
    }
    return out.bytes();
}

std::optional<servo::ServoSettings> settingsFrom(std::string_view bytes)
{
    ByteReader in(bytes);
    servo::ServoSettings settings;
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
    settings.handpieces.resize(in.take<std::uint8_t>());
    for (settings::Handpiece& handpiece : settings.handpieces) {
        handpiece.name = in.takeText();
        handpiece.freeRpm = in.take<double>();
        handpiece.stallTorqueNmm = in.take<double>();
    }
    settings.breakOff.on = in.take<std::uint8_t>() != 0;
    settings.breakOff.slenderness = in.take<double>();
    settings.hardness = settings::withoutEndsAndFullLoad(std::move(settings.hardness));
    if (in.left() != 0) {
        settings.hardness.flatEndShare = in.take<double>();
        settings.hardness.fullLoadN = in.take<double>();
    }
    if (in.left() != 0) {
        settings::DecayZoneHardness& zones = settings.hardness.decayZones.emplace();
        for (settings::MaterialHardness* zone : {&zones.leathery, &zones.firm}) {
            zone->rateMm3PerNs = in.take<double>();
            zone->thresholdN = in.take<double>();
        }
    }
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
    if (!tooth.lying.isUpright()) {
        out.put(static_cast<std::uint8_t>(tooth.lying.up));
        out.put(tooth.lying.tiltDeg);
    }
    if (tooth.hasDecayZones)
        out.put(kHasDecayZones);
    return out.bytes();
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
    constexpr std::size_t kLyingBytes = sizeof(std::uint8_t) + sizeof(double);
    const std::size_t mapBytes = grid.count() * (3 * sizeof(float) + sizeof(terrain::ColumnLayers));
    if (!in.ok() || !gridIsSane || in.left() < mapBytes)
        return nullptr;
    const std::size_t behindMaps = in.left() - mapBytes;
    const bool isLaid = behindMaps >= kLyingBytes;
    const std::size_t behindLying = behindMaps - (isLaid ? kLyingBytes : 0);
    if (behindLying > sizeof(kHasDecayZones))
        return nullptr;
    tooth->top.resize(grid.count());
    tooth->bottom.resize(grid.count());
    tooth->layers.resize(grid.count());
    tooth->areaMm2.resize(grid.count());
    in.takeAll(std::span(tooth->top));
    in.takeAll(std::span(tooth->bottom));
    in.takeAll(std::span(tooth->layers));
    in.takeAll(std::span(tooth->areaMm2));
    if (isLaid) {
        tooth->lying.up = static_cast<terrain::ToothSide>(in.take<std::uint8_t>());
        tooth->lying.tiltDeg = in.take<double>();
        if (!tooth->lying.isSound() || tooth->lying.isUpright())
            return nullptr;
    }
    if (behindLying != 0) {
        if (in.take<std::uint8_t>() != kHasDecayZones)
            return nullptr;
        tooth->hasDecayZones = true;
    }
    return in.ok() && plausible(*tooth) ? tooth : nullptr;
}

/// Returns the kinds, the steps and the four byte planes of each coordinate, one after another. Similar bytes together
/// compress better.
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
        if (!isTick(event.kind))
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
        if (kind > static_cast<std::uint8_t>(ServoEvent::Kind::Speed))
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
        if (isTick(event.kind))
            continue;
        event.value = in.take<std::uint64_t>();
        if (event.kind == ServoEvent::Kind::Bur && event.value >= bur::kMostBurs)
            return std::nullopt;
        if (event.kind == ServoEvent::Kind::Spring && (event.value < 1 || event.value > 100))
            return std::nullopt;
        if (event.kind == ServoEvent::Kind::Speed && (event.value < 1 || event.value > 100))
            return std::nullopt;
        if (event.kind == ServoEvent::Kind::Number && !servo::unpackParameter(event.value))
            return std::nullopt;
        if (event.kind == ServoEvent::Kind::Aids && event.value > servo::kAllAids)
            return std::nullopt;
    }
    if (!in.ok() || in.left() != 0)
        return std::nullopt;
    return events;
}

std::string unknownBurWords(std::uint64_t index)
{
    return "uses bur " + std::to_string(index + 1) + " of the list, and this Cusp has " +
           std::to_string(bur::burs().size());
}

EventGuard::Verdict EventGuard::look(const ServoEvent& event, const Recording& soFar)
{
    if (event.kind == ServoEvent::Kind::Bur && event.value >= bur::burs().size())
        return Verdict::BurOfNewerCusp;
    if (event.kind == ServoEvent::Kind::Handpiece && event.value >= soFar.settings().handpieces.size())
        return Verdict::NoSuchHandpiece;
    const bool restores = event.kind == ServoEvent::Kind::Restore;
    if (restores && event.value > soFar.ticks())
        return Verdict::IntoTheFuture;
    if (restores || event.kind == ServoEvent::Kind::Resume)
        m_restoredColumns += soFar.anatomy()->grid.count();
    return m_restoredColumns > kMaxRestoredColumns ? Verdict::TooManySteps : Verdict::Sound;
}

}  // namespace core::recording
