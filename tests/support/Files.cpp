// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/Files.h"

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>

#include <QString>

namespace support {
namespace {

std::filesystem::path corpus(const char* name)
{
    return std::filesystem::path(CUSP_SOURCE_DIR) / "tests" / "fuzz" / "corpus" / name;
}

}  // namespace

std::string bytesOf(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

void write(const std::filesystem::path& path, std::string_view bytes)
{
    std::filesystem::create_directories(path.parent_path());
    std::ofstream file(path, std::ios::binary | std::ios::trunc);
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    if (!file.flush())
        qFatal("%s cannot be written", path.c_str());
}

void write(const QString& path, std::string_view bytes)
{
    write(std::filesystem::path(path.toStdString()), bytes);
}

bool isListUpToDate(const char* file, std::string_view before, std::string_view after, const std::string& list)
{
    const std::filesystem::path path = std::filesystem::path(CUSP_SOURCE_DIR) / file;
    std::string text = bytesOf(path);
    const std::size_t begin = text.find(before);
    const std::size_t from = begin + before.size();
    const std::size_t to = begin == std::string::npos ? begin : text.find(after, from);
    if (to == std::string::npos) {
        qWarning("%s has no list between the lines that the test looks for.", file);
        return false;
    }
    const std::string found = text.substr(from, to - from);
    if (found == list)
        return true;
    if (std::getenv("CUSP_REWRITE_LISTS") != nullptr) {
        write(path, text.replace(from, to - from, list));
        return true;
    }
    std::istringstream lines(list);
    for (std::string line; std::getline(lines, line);)
        if ((found + '\n').find(line + '\n') == std::string::npos)
            qWarning("%s lacks the line: %s", file, line.c_str());
    qWarning("%s does not list what the table says, in its order. Run the test with CUSP_REWRITE_LISTS=1 to write the "
             "list anew, and look at the change.",
             file);
    return false;
}

bool isSchemaUpToDate(const std::string& definition, const std::vector<std::string>& ids)
{
    std::string list;
    for (const std::string& id : ids)
        list += (list.empty() ? "        \"" : ",\n        \"") + id + '"';
    return isListUpToDate("lessons/schema/lesson.schema.json", "\n    \"" + definition + "\": {\n      \"enum\": [\n",
                          "\n      ]", list);
}

bool forEachSeed(const char* name, const std::function<void(const std::string&)>& use)
{
    bool any = false;
    for (const auto& entry : std::filesystem::directory_iterator(corpus(name))) {
        use(bytesOf(entry.path()));
        any = true;
    }
    return any;
}

bool rewritesSeeds()
{
    return std::getenv("CUSP_REWRITE_CORPUS") != nullptr;
}

void writeSeed(const char* name, const std::string& file, std::string_view bytes)
{
    write(corpus(name) / file, bytes);
}

}  // namespace support
