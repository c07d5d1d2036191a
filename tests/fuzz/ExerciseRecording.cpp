// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/Exercises.h"

#include <cmath>
#include <functional>
#include <span>

#include <glm/geometric.hpp>

#include "core/base/Bytes.h"
#include "core/recording/Format.h"
#include "core/recording/Replay.h"

namespace fuzz {
namespace {

using namespace core::recording;
using core::servo::ServoEvent;

constexpr std::uint64_t kMostTicks = 4000;
constexpr int kMostRestores = 20;
constexpr std::uint32_t kEndSection = 4;
constexpr std::size_t kLargestSection = 64ULL * 1024 * 1024;
constexpr int kLargestGrid = 160;  // a larger one takes too long for a fuzzer

/// Returns the bytes after applying `change` to the payload of each whole section. Sizes and checksums are updated.
std::string forEachSection(std::string_view bytes,
                           const std::function<std::string(std::uint32_t, std::string_view)>& change)
{
    constexpr std::size_t kFileHeader = 12;
    constexpr std::size_t kSectionHeader = 20;
    if (bytes.size() < kFileHeader)
        return std::string(bytes);
    core::ByteWriter out;
    out.putAll(std::span(bytes.data(), kFileHeader));
    std::string_view rest = bytes.substr(kFileHeader);
    while (rest.size() >= kSectionHeader) {
        core::ByteReader in(rest);
        const auto kind = in.take<std::uint32_t>();
        const auto size = in.take<std::uint64_t>();
        if (size > rest.size() - kSectionHeader)
            break;
        const std::string payload = change(kind, rest.substr(kSectionHeader, static_cast<std::size_t>(size)));
        out.put(kind);
        out.put(static_cast<std::uint64_t>(payload.size()));
        out.put(core::fnv1a(payload));
        out.putAll(std::span(payload.data(), payload.size()));
        rest.remove_prefix(kSectionHeader + static_cast<std::size_t>(size));
    }
    out.putAll(std::span(rest.data(), rest.size()));
    return out.bytes();
}

}  // namespace

std::string unpacked(std::string_view bytes)
{
    return forEachSection(bytes, [](std::uint32_t kind, std::string_view payload) {
        const auto raw = kind == kEndSection ? std::nullopt : unpack(payload, kLargestSection);
        return raw.value_or(std::string(payload));
    });
}

void exerciseRecording(std::string_view bytes)
{
    playRecording(bytes);
    playRecording(forEachSection(bytes, [](std::uint32_t, std::string_view payload) { return std::string(payload); }));
    playRecording(forEachSection(bytes, [](std::uint32_t kind, std::string_view payload) {
        return kind == kEndSection ? std::string(payload) : pack(payload);
    }));
}

void playRecording(std::string_view bytes)
{
    const auto recording = Recording::fromBytes(bytes);
    if (!recording) {
        promise(!recording.error().detail.empty());
        return;
    }
    const auto again = Recording::fromBytes(recording->toBytes());
    promise(again && again->ticks() == recording->ticks() && again->witness() == recording->witness());

    int restores = 0;
    recording->forEach([&](const ServoEvent& event) {
        restores += event.kind == ServoEvent::Kind::Restore || event.kind == ServoEvent::Kind::Resume ? 1 : 0;
    });
    if (recording->ticks() > kMostTicks || restores > kMostRestores || recording->anatomy()->grid.side > kLargestGrid)
        return;
    const double clampN = recording->settings().force.clampN;
    const auto outcome = replay(*recording, [&](const ServoEvent&, const Replayer& servo) {
        promise(glm::length(servo.state().forceN) <= clampN * (1.0 + 1.0e-9));  // false for NaN
    });
    promise(outcome.has_value());
    const core::terrain::Tooth& tooth = outcome->tooth;
    for (std::size_t k = 0; k < tooth.top.size(); ++k)
        promise(tooth.top[k] <= tooth.anatomy->top[k]);
}

}  // namespace fuzz
