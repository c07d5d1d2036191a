// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

class QString;

/// Whole files. What cannot be written ends the test program; what cannot be read is empty.
namespace support {

[[nodiscard]] std::string bytesOf(const std::filesystem::path& path);
/// Makes the folder as well.
void write(const std::filesystem::path& path, std::string_view bytes);
void write(const QString& path, std::string_view bytes);

/// The seeds of a fuzzer, from tests/fuzz/corpus/NAME: gives each to `use`. False if there are none.
[[nodiscard]] bool forEachSeed(const char* name, const std::function<void(const std::string&)>& use);
/// CUSP_REWRITE_CORPUS=1 makes the seeds anew.
[[nodiscard]] bool rewritesSeeds();
void writeSeed(const char* name, const std::string& file, std::string_view bytes);

}  // namespace support
