// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <utility>

namespace core {

/// Locks a name against other programs, and other parts of this one, while the object exists (flock). The lock ends
/// with the program, however that ends. Creates the file of that name, and removes it with the lock.
class FileLock
{
public:
    /// Tries to lock and does not wait: see isHeld().
    explicit FileLock(std::filesystem::path name);
    ~FileLock();
    FileLock(FileLock&& other) noexcept : m_name(std::move(other.m_name)), m_file(std::exchange(other.m_file, -1)) {}
    FileLock& operator=(FileLock&& other) noexcept
    {
        std::swap(m_name, other.m_name);
        std::swap(m_file, other.m_file);
        return *this;
    }
    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;

    [[nodiscard]] bool isHeld() const { return m_file >= 0; }

private:
    std::filesystem::path m_name;
    int m_file = -1;
};

}  // namespace core
