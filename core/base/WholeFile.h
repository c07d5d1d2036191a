// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string_view>

#include "core/base/Result.h"

namespace core {

/// Writes a file completely or not at all: writes a new file beside it and renames that. On failure an existing file is
/// unchanged. A folder, device or pipe is not replaced; of a link, the target is written. Error FileUnwritable with one
/// sentence.
/// @param what  subject of the sentence: "The mesh"
[[nodiscard]] Status writeWhole(const std::filesystem::path& path, std::string_view bytes, std::string_view what);

/// Flushes a file, or the entries of a folder, to the disk. Returns false on failure.
bool bringToDisk(const std::filesystem::path& path);

/// Returns whether two names refer to the same file, which need not exist.
[[nodiscard]] bool isSameFile(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace core
