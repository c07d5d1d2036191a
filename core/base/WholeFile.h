// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string_view>

#include "core/base/Result.h"

namespace core {

/// Writes a file that appears whole or not at all: into a new file beside its place (never one that is there), then
/// renamed. Whatever fails, an older file stays as it was. A folder, device or pipe is not replaced; behind a link, its
/// target is written. FileUnwritable with one sentence otherwise.
/// @param what  what the sentence calls it: "The mesh"
[[nodiscard]] Status writeWhole(const std::filesystem::path& path, std::string_view bytes, std::string_view what);

/// Brings a file, or the names in a folder, to the disk. False: that could not be done.
bool bringToDisk(const std::filesystem::path& path);

/// Do two names stand for the same file, be it there already or not?
[[nodiscard]] bool isSameFile(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace core
