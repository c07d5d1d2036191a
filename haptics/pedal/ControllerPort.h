// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/base/Result.h"
#include "core/session/ControllerReport.h"

namespace haptics {

/// Access to the pedals and gamepads of the computer. One thread opens, uses and closes a port.
class ControllerPort
{
public:
    ControllerPort() = default;
    ControllerPort(const ControllerPort&) = delete;
    ControllerPort& operator=(const ControllerPort&) = delete;
    virtual ~ControllerPort() = default;

    /// Reads all controllers that are plugged in now. Leaves `presses` empty.
    virtual void read(std::vector<core::session::Controller>& controllers) = 0;
};

/// Opens the port of this system: SDL 2. Unsupported if this program was built without it.
[[nodiscard]] core::Result<std::unique_ptr<ControllerPort>> openControllerPort();

/// Returns whether this program was built with SDL 2.
[[nodiscard]] bool hasControllers() noexcept;

}  // namespace haptics
