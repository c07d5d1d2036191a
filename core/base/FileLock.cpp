// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/FileLock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace core {
namespace {

/// Returns whether the path still refers to the open file: the previous holder of the lock may have removed it.
bool isStillCalled(const std::filesystem::path& name, int file)
{
    struct stat open
    {};
    struct stat named
    {};
    return fstat(file, &open) == 0 && stat(name.c_str(), &named) == 0 && open.st_dev == named.st_dev &&
           open.st_ino == named.st_ino;
}

}  // namespace

FileLock::FileLock(std::filesystem::path name) : m_name(std::move(name))
{
    const int opened = open(m_name.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, S_IRUSR | S_IWUSR);
    if (opened < 0)
        return;
    if (flock(opened, LOCK_EX | LOCK_NB) == 0 && isStillCalled(m_name, opened))
        m_file = opened;
    else
        close(opened);
}

FileLock::~FileLock()
{
    if (m_file < 0)
        return;
    unlink(m_name.c_str());  // removed before the lock is released
    close(m_file);
}

}  // namespace core
