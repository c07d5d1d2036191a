// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <utility>

namespace core {

/// Keeps other programs, and other parts of this one, from what the name stands for while it lives (flock): whatever
/// ends the program, and whatever the computer is called by then, nothing is held any more. The file of that name is
/// made, and goes with the lock.
class FileLock
{
public:
    /// Waits for nobody: see isHeld().
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
