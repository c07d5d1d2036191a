// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/Exercises.h"

#include <span>

#include "core/base/Bytes.h"
#include "core/recording/JournalFile.h"
#include "core/session/ResumableAttempt.h"

namespace fuzz {
namespace {

constexpr std::uint64_t kMostEvents = 4000;
constexpr int kLargestGrid = 160;

void readJournal(std::string_view bytes)
{
    const auto found = core::recording::attemptFrom(bytes);
    if (!found) {
        promise(found.error().detail.ends_with('.'));
        return;
    }
    const core::recording::Recording& recording = found->recording;
    playRecording(recording.toBytes());
    if (recording.events() > kMostEvents || recording.anatomy()->grid.side > kLargestGrid)
        return;
    const auto attempt = core::session::rebuild(recording);
    promise(attempt.has_value() && (*attempt)->recording.events() == recording.events());
}

/// Corrects the checksums of a journal whose frames a fuzzer has changed.
std::string withChecksums(std::string_view bytes)
{
    constexpr std::size_t kFileHeader = 12;
    constexpr std::size_t kFields = 16;
    constexpr std::size_t kFrameHeader = kFields + 8;
    if (bytes.size() < kFileHeader)
        return std::string(bytes);
    core::ByteWriter out;
    out.putAll(std::span(bytes.data(), kFileHeader));
    std::string_view rest = bytes.substr(kFileHeader);
    while (rest.size() >= kFrameHeader) {
        core::ByteReader in(rest.substr(4));
        const std::size_t size = in.take<std::uint32_t>();
        if (size > rest.size() - kFrameHeader)
            break;
        const std::string_view payload = rest.substr(kFrameHeader, size);
        out.putAll(std::span(rest.data(), kFields));
        out.put(core::fnv1a(payload, core::fnv1a(rest.substr(0, kFields))));
        out.putAll(std::span(payload.data(), payload.size()));
        rest.remove_prefix(kFrameHeader + size);
    }
    out.putAll(std::span(rest.data(), rest.size()));
    return out.bytes();
}

}  // namespace

void exerciseJournal(std::string_view bytes)
{
    readJournal(bytes);
    readJournal(withChecksums(bytes));
}

}  // namespace fuzz
