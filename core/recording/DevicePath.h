// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <string_view>

#include <glm/vec3.hpp>

#include "core/base/Result.h"

namespace core::recording {

/// The position of a device at one time.
struct PathPoint
{
    double timeS = 0.0;
    glm::dvec3 tipMm{0.0};
    bool drill = false;  ///< from this point to the next
};

/// A device path: points in time, with straight lines between them.
struct DevicePath
{
    std::deque<PathPoint> points;  ///< at least one, in order of time; a deque, so that growing does not copy all
                                   ///< points

    [[nodiscard]] double durationS() const { return points.back().timeS - points.front().timeS; }
    /// Returns the number of ticks at `rateHz`, both ends included.
    [[nodiscard]] std::uint64_t ticks(double rateHz) const;
};

/// Walks along a path in order of time. Remembers its place, so that a whole walk is one pass.
class PathCursor
{
public:
    explicit PathCursor(const DevicePath& path) : m_path(path) {}
    /// Returns the point at `timeS` after the path's start; before it the first point, after the end the last.
    PathPoint at(double timeS) noexcept;

private:
    const DevicePath& m_path;
    std::size_t m_segment = 0;
};

inline constexpr std::size_t kMaxPathPoints = 5'000'000;
inline constexpr double kMaxPathMm = 1000.0;

/// Reads CSV text with a header that names t_s, x_mm, y_mm, z_mm and drill (0 or 1) in any order; other columns are
/// ignored. Lines end with LF, CR LF or CR. Times must not decrease. The error names line and column.
/// @param needDrill  false: the drill column is optional
[[nodiscard]] Result<DevicePath> parseDevicePath(std::string_view text, bool needDrill);
/// Reads a path from a file, with only a few lines in memory at a time.
[[nodiscard]] Result<DevicePath> readDevicePath(const std::filesystem::path& path, bool needDrill);

}  // namespace core::recording
