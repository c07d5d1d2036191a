// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/falcon/FirmwareImage.h"

#include <algorithm>
#include <array>
#include <utility>

#include <sodium.h>

namespace haptics::falcon {
namespace {

using core::ErrorCode;
using core::LocalizableText;
using core::noted;
using core::unexpected;

constexpr std::size_t kWordBytes = 2;
constexpr std::array<std::uint8_t, kWordBytes> kKey{0xAA, 0x08};
constexpr std::size_t kEntryAt = 18;      ///< after the key and eight reserved words
constexpr std::size_t kHeaderBytes = 22;  ///< with the entry point
constexpr std::size_t kDestinationBytes = 4;
constexpr std::uint32_t kAddresses = 1U << 22U;  ///< a program address has 22 bits

struct KnownFirmware
{
    std::string_view sha256;
    std::string_view name;
};

/// The files in libnifalcon's folder "firmware".
constexpr KnownFirmware kKnown[] = {
    {"1119e39c39fab1f37678ea62dfc715b23dd86ee7f13d78f88f707d9f09b896a1", "Novint nVent 2008 (nvent_firmware.bin)"},
    {"b2700d5cd5ca217e48565fb4de5a502a636c53f6e01ebd0cad193e9f84856c6a",
     "Novint test utilities 2008 (test_firmware.bin)"},
    {"ae838730af34b5822c9c3949859b446614af0410730b832cc17a6ad627ea64a4", "Novint SDK 2008, T0 (novint_T0.bin)"},
    {"e0ae3598670fa1c8d9277bd6943c99b3152b97c400c46c1c42c60de77ff4e816", "Novint SDK 2008, T2 (novint_T2.bin)"},
};

std::uint32_t wordAt(std::span<const std::uint8_t> bytes, std::size_t at)
{
    return bytes[at] | static_cast<std::uint32_t>(bytes[at + 1]) << 8U;
}

/// Returns the size of the block at the front. If its first word is 0 (the end of the stream) or incomplete, returns
/// the size of that word.
std::size_t blockBytesAt(std::span<const std::uint8_t> bytes)
{
    const std::size_t words = bytes.size() < kWordBytes ? 0 : wordAt(bytes, 0);
    return words == 0 ? kWordBytes : kWordBytes + kDestinationBytes + words * kWordBytes;
}

std::string sha256Of(std::span<const std::uint8_t> bytes)
{
    [[maybe_unused]] const int begun = sodium_init();  // a hash needs no random numbers: it works even if this fails
    std::array<unsigned char, crypto_hash_sha256_BYTES> hash{};
    std::array<char, 2 * crypto_hash_sha256_BYTES + 1> hex{};
    crypto_hash_sha256(hash.data(), bytes.data(), bytes.size());
    sodium_bin2hex(hex.data(), hex.size(), hash.data(), hash.size());
    return hex.data();
}

tl::unexpected<core::Error> notFirmware()
{
    return unexpected(ErrorCode::WrongKind,
                      LocalizableText{"This is not firmware for the Falcon; choose another file."});
}

}  // namespace

core::Result<FirmwareImage> FirmwareImage::check(std::vector<std::uint8_t> bytes)
{
    if (bytes.empty())
        return unexpected(ErrorCode::FileEmpty, LocalizableText{"The firmware file is empty; choose another file."});
    if (bytes.size() > kLargestBytes)
        return unexpected(
            ErrorCode::FileTooLarge,
            LocalizableText{"The file is larger than %1 KiB and cannot be firmware for the Falcon; choose another "
                            "file.",
                            {noted(std::to_string(kLargestBytes / 1024))}});
    const std::span<const std::uint8_t> all(bytes);
    const auto keyBytes = all.first(std::min(all.size(), kWordBytes));
    const auto reserved = all.subspan(keyBytes.size(), std::min(all.size(), kEntryAt) - keyBytes.size());
    if (!std::equal(keyBytes.begin(), keyBytes.end(), kKey.begin()) ||
        std::any_of(reserved.begin(), reserved.end(), [](std::uint8_t byte) { return byte != 0; }))
        return notFirmware();
    if (all.size() < kHeaderBytes)
        return unexpected(
            ErrorCode::FileTruncated,
            LocalizableText{"The firmware file is too short: it has %1 bytes, and its header alone has %2. Use a "
                            "complete copy.",
                            {noted(std::to_string(all.size())), noted(std::to_string(kHeaderBytes))}});

    FirmwareImage image;
    image.m_entryPoint = wordAt(all, kEntryAt) << 16U | wordAt(all, kEntryAt + kWordBytes);
    if (image.m_entryPoint >= kAddresses)
        return notFirmware();
    auto rest = all.subspan(kHeaderBytes);
    for (bool ended = false; !ended;) {
        const std::size_t blockBytes = blockBytesAt(rest);
        if (rest.size() < blockBytes)
            return unexpected(
                ErrorCode::FileTruncated,
                LocalizableText{"The firmware file ends before its block %1 is complete. Use a complete copy.",
                                {noted(std::to_string(image.m_blockCount + 1))}});
        rest = rest.subspan(blockBytes);
        ended = blockBytes == kWordBytes;
        image.m_blockCount += ended ? 0 : 1;
    }
    if (!rest.empty())
        return unexpected(
            ErrorCode::BadStructure,
            LocalizableText{"The firmware ends after %1 bytes, but the file has %2. Use an unchanged copy.",
                            {noted(std::to_string(all.size() - rest.size())), noted(std::to_string(all.size()))}});
    if (image.m_blockCount == 0)
        return notFirmware();
    image.m_sha256 = sha256Of(all);
    image.m_bytes = std::move(bytes);
    return image;
}

std::string_view FirmwareImage::name() const
{
    return knownFirmware(m_sha256);
}

std::string_view knownFirmware(std::string_view sha256)
{
    for (const KnownFirmware& known : kKnown)
        if (known.sha256 == sha256)
            return known.name;
    return {};
}

}  // namespace haptics::falcon
