// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/Files.h"

#include <cstdlib>
#include <fstream>
#include <iterator>

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
