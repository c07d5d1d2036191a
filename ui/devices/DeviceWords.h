// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include <QPalette>
#include <QPixmap>
#include <QString>

#include "core/session/DeviceReport.h"
#include "ui/devices/DeviceKind.h"

/// Texts about force devices in the user's language.
namespace ui::devices {

/// The icon beside a state.
enum class Sign : std::uint8_t {
    Ready,      ///< a tick
    Working,    ///< an hourglass: the device becomes ready by itself
    Attention,  ///< a triangle: the user must do something
    Missing,    ///< a cross: there is no device
    Off         ///< a pale eye: the user has not switched it on
};

[[nodiscard]] Sign signOf(const DeviceKind& kind, const core::session::DeviceReport& report);
[[nodiscard]] QPixmap signPixmap(Sign sign, const QPalette& palette, int sizePx, double devicePixelRatio);
/// Returns a sentence on the state, such as "Plugged in, but it cannot be opened."
[[nodiscard]] QString stateWords(const DeviceKind& kind, const core::session::DeviceReport& report);
/// Returns one or two sentences on what to do in this state; empty if there is nothing to do.
[[nodiscard]] QString helpWords(const DeviceKind& kind, const core::session::DeviceReport& report);
/// Returns whether the device is plugged in and the user lacks the permission to open it.
[[nodiscard]] bool lacksPermission(const core::session::DeviceReport& report);
/// Returns the function of a grip button in the order of DeviceReport::presses: "Drill", "Undo", "Mirror", "Centre".
[[nodiscard]] QString gripButtonName(std::size_t button);

}  // namespace ui::devices
