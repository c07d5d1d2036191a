// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/WholeFile.h"

#include <cerrno>
#include <cstdio>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

namespace core {
namespace {

namespace fs = std::filesystem;

/// Creates a new file beside a path, named after it. Returns null, with errno set, if none can be made.
std::FILE* openBeside(const fs::path& path, fs::path& beside)
{
    constexpr int kMostNames = 100;
    for (int n = 0; n < kMostNames; ++n) {
        beside = path;
        beside += n == 0 ? std::string(".part") : ".part" + std::to_string(n);
        std::FILE* const file = std::fopen(beside.c_str(), "wbx");
        if (file != nullptr || errno != EEXIST)
            return file;
    }
    return nullptr;
}

bool fill(std::FILE* file, std::string_view bytes)
{
    const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size() && std::fflush(file) == 0 &&
                         fsync(fileno(file)) == 0;
    return std::fclose(file) == 0 && written;
}

}  // namespace

Status writeWhole(const fs::path& path, std::string_view bytes, std::string_view what)
{
    const auto failed = [&](const std::string& why) {
        return unexpected(ErrorCode::FileUnwritable,
                          std::string(what) + " could not be written to '" + path.string() + "': " + why + ".");
    };
    std::error_code failure;
    fs::path target = fs::is_symlink(path, failure) ? fs::weakly_canonical(path, failure) : path;
    const fs::file_status status = fs::status(target, failure);
    if (fs::is_directory(status))
        return failed("that is a folder; name a file in it");
    if (fs::exists(status) && !fs::is_regular_file(status))
        return failed("that is a device or a pipe; name a file");
    fs::path beside;
    std::FILE* const file = openBeside(target, beside);
    if (file == nullptr)
        return failed("the folder is missing or does not allow it; name another");
    const bool filled = fill(file, bytes);
    if (filled)
        fs::rename(beside, target, failure);
    if (filled && !failure)
        return {};
    std::error_code ignored;
    fs::remove(beside, ignored);
    return failed(filled ? failure.message()
                         : "the disk is full or the connection to it broke; make room or name another");
}

bool bringToDisk(const fs::path& path)
{
    const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0)
        return false;
    const bool done = fsync(file) == 0;
    close(file);
    return done;
}

bool isSameFile(const fs::path& a, const fs::path& b)
{
    std::error_code failure;
    if (fs::exists(a, failure) && fs::exists(b, failure))
        return fs::equivalent(a, b, failure);
    const fs::path first = fs::weakly_canonical(fs::absolute(a, failure), failure);
    return first == fs::weakly_canonical(fs::absolute(b, failure), failure);
}

}  // namespace core
