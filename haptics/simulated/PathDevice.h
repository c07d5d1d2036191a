// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recording/DevicePath.h"
#include "haptics/HapticDevice.h"

namespace haptics {

/// A hand that follows a path regardless of the force: for headless runs, demonstrations and tests.
class PathDevice final : public HapticDevice
{
public:
    /// @param path  must outlive the device
    PathDevice(const core::recording::DevicePath& path, double rateHz) : m_cursor(path), m_rateHz(rateHz) {}

    DeviceSample exchange(const glm::dvec3&) noexcept override
    {
        const core::recording::PathPoint point = m_cursor.at(static_cast<double>(m_tick++) / m_rateHz);
        return {glm::vec3(point.tipMm), true};
    }

private:
    core::recording::PathCursor m_cursor;
    double m_rateHz;
    std::uint64_t m_tick = 0;
};

}  // namespace haptics
