// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/falcon/FirmwareLoader.h"

#include <algorithm>
#include <array>

namespace haptics::falcon {
namespace {

using namespace std::chrono_literals;
using core::ErrorCode;
using core::LocalizableText;
using core::noted;
using core::unexpected;
using Clock = std::chrono::steady_clock;

constexpr std::array<std::uint8_t, 3> kGreeting{0x0A, 0x43, 0x0D};
constexpr std::array<std::uint8_t, 4> kGreetingAnswer{0x0A, 0x44, 0x2C, 0x0D};
constexpr int kGreetings = 20;
constexpr auto kGreetingPatience = 200ms;
constexpr std::array<std::uint8_t, 1> kBaudByte{0x41};
constexpr int kBaudBytes = 3;
constexpr auto kBaudPatience = 300ms;
/// This many bytes return as one full packet, which the chip sends without waiting for its latency timer.
constexpr std::size_t kBlockBytes = kUsbPacketBytes - kUsbStatusBytes;
constexpr auto kEchoPatience = 1000ms;
constexpr auto kLoadingLatency = 16ms;
constexpr auto kRunningLatency = 1ms;
constexpr int kProbes = 15;
constexpr auto kProbePatience = 20ms;
constexpr auto kSlice = 5ms;

core::Status silent()
{
    return unexpected(
        ErrorCode::ConnectionLost,
        LocalizableText{"The Falcon does not answer. Check that its mains adapter is plugged in, then unplug its USB "
                        "cable and plug it in again."});
}

core::Status gone()
{
    return unexpected(ErrorCode::ConnectionLost,
                      LocalizableText{"The Falcon was unplugged while its firmware was loaded."});
}

/// Waits until the previous bytes are sent, then starts to send these. Returns false under the conditions of
/// FtdiPort::send().
bool sendWhenFree(FtdiPort& port, std::span<const std::uint8_t> bytes)
{
    // Bytes received meanwhile are discarded.
    for (const auto until = Clock::now() + kEchoPatience; port.isSending() && Clock::now() < until;)
        static_cast<void>(port.receive(1ms));
    return port.send(bytes);
}

/// Passes each received byte to a function until it returns true. Returns false if the time is over before that.
template <class Take>
bool takeUntil(FtdiPort& port, std::chrono::milliseconds patience, Take take)
{
    const auto until = Clock::now() + patience;
    while (Clock::now() < until && !port.isGone()) {
        auto transfer = port.receive(kSlice);
        while (const auto packet = takePacket(transfer))
            for (const std::uint8_t byte : packet->data)
                if (take(byte))
                    return true;
    }
    return false;
}

core::Status greet(FtdiPort& port)
{
    for (int n = 0; n < kGreetings && !port.isGone(); ++n) {
        if (!sendWhenFree(port, kGreeting))
            break;
        // Some controllers send a zero first: the answer may begin anywhere.
        std::size_t matched = 0;
        if (takeUntil(port, kGreetingPatience, [&](std::uint8_t byte) {
                matched = byte == kGreetingAnswer.at(matched) ? matched + 1 : byte == kGreetingAnswer.front() ? 1U : 0U;
                return matched == kGreetingAnswer.size();
            }))
            return {};
    }
    return port.isGone() ? gone() : silent();
}

core::Status settleBaud(FtdiPort& port)
{
    for (int n = 0; n < kBaudBytes && !port.isGone(); ++n)
        if (sendWhenFree(port, kBaudByte) &&
            takeUntil(port, kBaudPatience, [](std::uint8_t byte) { return byte == kBaudByte.front(); }))
            return {};
    return port.isGone() ? gone() : silent();
}

core::Status sendBlock(FtdiPort& port, std::span<const std::uint8_t> block, std::size_t at)
{
    if (!sendWhenFree(port, block))
        return port.isGone() ? gone() : silent();
    std::size_t matched = 0;
    bool isWrong = false;
    const bool ended = takeUntil(port, kEchoPatience, [&](std::uint8_t byte) {
        isWrong = byte != block[matched];
        return isWrong || ++matched == block.size();
    });
    if (isWrong)
        return unexpected(
            ErrorCode::ConnectionLost,
            LocalizableText{"The Falcon received byte %1 of the firmware wrongly. Try another USB port, without a hub.",
                            {noted(std::to_string(at + matched))}});
    if (!ended)
        return port.isGone() ? gone() : silent();
    return {};
}

}  // namespace

core::Status setForRunning(FtdiPort& port)
{
    if (auto done = port.setLatency(kRunningLatency); !done)
        return done;
    if (auto done = port.setFormat(); !done)
        return done;
    if (auto done = port.setBaud(FtdiPort::Baud::Running); !done)
        return done;
    return port.purge();
}

core::Result<bool> firmwareRuns(FtdiPort& port)
{
    if (auto done = setForRunning(port); !done)
        return tl::unexpected(done.error());
    const Frame request = encode({});
    FrameReader reader;
    for (int n = 0; n < kProbes && !port.isGone(); ++n) {
        if (!port.isSending() && !port.send(request))
            break;
        reader.dropIncomplete();
        for (const auto until = Clock::now() + kProbePatience; Clock::now() < until && !port.isGone();)
            if (reader.read(port.receive(kSlice)).answers > 0)
                return true;
    }
    if (port.isGone())
        return tl::unexpected(gone().error());
    return false;
}

core::Status loadFirmware(FtdiPort& port, const FirmwareImage& image, const std::function<bool(double)>& goOn)
{
    using Line = FtdiPort::Line;
    const auto prepare = [&]() -> core::Status {
        if (auto done = port.purge(); !done)
            return done;
        if (auto done = port.setLatency(kLoadingLatency); !done)
            return done;
        if (auto done = port.setBaud(FtdiPort::Baud::Hello); !done)
            return done;
        if (auto done = port.setFormat(); !done)
            return done;
        for (const Line line : {Line::RtsOff, Line::DtrOff, Line::DtrOn})
            if (auto done = port.setLine(line); !done)
                return done;
        return greet(port);
    };
    if (auto done = prepare(); !done)
        return done;
    if (auto done = port.setLine(Line::DtrOff); !done)
        return done;
    if (auto done = port.setBaud(FtdiPort::Baud::Loading); !done)
        return done;
    if (auto done = settleBaud(port); !done)
        return done;
    const auto all = image.bytes();
    for (std::size_t at = 0; at < all.size(); at += kBlockBytes) {
        if (!goOn(static_cast<double>(at) / static_cast<double>(all.size())))
            return unexpected(ErrorCode::Busy, LocalizableText{"Loading the firmware was stopped."});
        if (auto done = sendBlock(port, all.subspan(at, std::min(kBlockBytes, all.size() - at)), at); !done)
            return done;
    }
    return setForRunning(port);
}

}  // namespace haptics::falcon
