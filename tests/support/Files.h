// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

class QString;

/// Reads and writes whole files. If a file cannot be written, the test program ends; if it cannot be read, the result
/// is empty.
namespace support {

[[nodiscard]] std::string bytesOf(const std::filesystem::path& path);
/// Writes a file, and creates its folder if needed.
void write(const std::filesystem::path& path, std::string_view bytes);
void write(const QString& path, std::string_view bytes);

/// Returns whether a list in a file of the repository matches a table. Prints the missing entries and how to add them.
/// With CUSP_REWRITE_LISTS=1 in the environment it writes the list again.
/// @param file    from the root of the repository: "docs/burs.md"
/// @param before  the text that ends where the list begins
/// @param after   the text that begins where the list ends
/// @param list    the text between the two
[[nodiscard]] bool isListUpToDate(const char* file, std::string_view before, std::string_view after,
                                  const std::string& list);
/// Returns whether the ids under "$defs" in lessons/schema/lesson.schema.json match a table, likewise.
/// @param definition  "bur"
[[nodiscard]] bool isSchemaUpToDate(const std::string& definition, const std::vector<std::string>& ids);

/// Passes each seed of a fuzzer, from tests/fuzz/corpus/NAME, to `use`. Returns false if there are none.
[[nodiscard]] bool forEachSeed(const char* name, const std::function<void(const std::string&)>& use);
/// Returns whether the seeds should be written again (CUSP_REWRITE_CORPUS=1).
[[nodiscard]] bool rewritesSeeds();
void writeSeed(const char* name, const std::string& file, std::string_view bytes);

}  // namespace support
