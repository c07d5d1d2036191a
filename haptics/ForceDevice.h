// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/DeviceReport.h"
#include "haptics/HapticDevice.h"

namespace haptics {

/// Base class of real force devices. A device is found, started and monitored in its own thread. Each kind of device is
/// one class and one row in app/devices/StationDevices.
///
/// The functions here are for the ui thread and return at once.
class ForceDevice : public HapticDevice
{
public:
    /// Starts searching for the device, until stop().
    virtual void start() = 0;
    /// Sets the force to zero, closes the device and waits until it is closed.
    virtual void stop() = 0;
    [[nodiscard]] virtual core::session::DeviceReport report() const = 0;
    /// Returns whether exchange() returns positions. Any thread.
    [[nodiscard]] virtual bool isReady() const noexcept = 0;
    virtual void setUp(const core::session::DeviceSetup& setup) = 0;
    /// Sets the path of the firmware that the device needs; empty: none. A device without firmware ignores it.
    virtual void setFirmware(const std::string& /*path*/) {}
    /// Adds a force of at most 1 N for a test, tooth frame. The force ends by itself 0.5 s after the last call.
    virtual void setTestForce(const glm::dvec3& forceN) = 0;
};

}  // namespace haptics
