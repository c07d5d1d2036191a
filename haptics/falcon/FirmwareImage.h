// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/Result.h"

namespace haptics::falcon {

/// Firmware for the Falcon's controller that has passed a check. Objects are created by check() only, so that no other
/// data can be sent to a device.
///
/// The file is a boot stream for the SCI boot loader of TI's C28x processors, 8-bit data, as TI's boot ROM guides
/// describe it (SPRUI07, "Bootloader Data Stream Structure"): 16-bit words, low byte first; the key 0x08AA; eight
/// reserved words; the 22-bit entry point, high word first; blocks of {size in words, destination, data}; the size 0.
/// After that word the processor starts the program.
///
/// Any thread. Allocates.
class FirmwareImage
{
public:
    /// The known files have 7 to 9 KiB.
    static constexpr std::size_t kLargestBytes = 64 * 1024;

    /// Checks a firmware file.
    /// @param bytes  the whole file, or its first kLargestBytes + 1 bytes if it is larger
    /// Errors: FileEmpty, FileTooLarge, WrongKind (not a boot stream, or one without a program), FileTruncated (ends
    /// within the header or a block), BadStructure (bytes after the end). The words are in the ui's translations.
    [[nodiscard]] static core::Result<FirmwareImage> check(std::vector<std::uint8_t> bytes);

    /// Returns all bytes of the file, which are to be sent.
    [[nodiscard]] std::span<const std::uint8_t> bytes() const { return m_bytes; }
    [[nodiscard]] std::uint32_t entryPoint() const { return m_entryPoint; }
    [[nodiscard]] int blockCount() const { return m_blockCount; }
    /// Returns the SHA-256 of all bytes: 64 hexadecimal digits, lower case.
    [[nodiscard]] const std::string& sha256() const { return m_sha256; }
    /// Returns origin and file name of a known firmware; empty for any other.
    [[nodiscard]] std::string_view name() const;

private:
    FirmwareImage() = default;

    std::vector<std::uint8_t> m_bytes;
    std::uint32_t m_entryPoint = 0;
    int m_blockCount = 0;
    std::string m_sha256;
};

/// Returns the name of the firmware with this checksum; empty if it is not one of the four that libnifalcon lists.
/// @param sha256  64 hexadecimal digits, lower case
[[nodiscard]] std::string_view knownFirmware(std::string_view sha256);

}  // namespace haptics::falcon
