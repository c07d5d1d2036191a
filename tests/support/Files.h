// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

class QString;

/// Whole files. What cannot be written ends the test program; what cannot be read is empty.
namespace support {

[[nodiscard]] std::string bytesOf(const std::filesystem::path& path);
/// Makes the folder as well.
void write(const std::filesystem::path& path, std::string_view bytes);
void write(const QString& path, std::string_view bytes);

/// Whether a file of the repository lists what a table says. Prints what is missing and how to add it. With
/// CUSP_REWRITE_LISTS=1 in the environment it writes the list anew.
/// @param file    from the root of the repository: "docs/burs.md"
/// @param before  the text that ends where the list begins
/// @param after   the text that begins where the list ends
/// @param list    the text between the two
[[nodiscard]] bool isListUpToDate(const char* file, std::string_view before, std::string_view after,
                                  const std::string& list);
/// The same for the ids under "$defs" in lessons/schema/lesson.schema.json.
/// @param definition  "bur"
[[nodiscard]] bool isSchemaUpToDate(const std::string& definition, const std::vector<std::string>& ids);

/// The seeds of a fuzzer, from tests/fuzz/corpus/NAME: gives each to `use`. False if there are none.
[[nodiscard]] bool forEachSeed(const char* name, const std::function<void(const std::string&)>& use);
/// CUSP_REWRITE_CORPUS=1 makes the seeds anew.
[[nodiscard]] bool rewritesSeeds();
void writeSeed(const char* name, const std::string& file, std::string_view bytes);

}  // namespace support
