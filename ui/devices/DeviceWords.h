// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include <QPalette>
#include <QPixmap>
#include <QString>

#include "core/session/DeviceReport.h"
#include "ui/devices/DeviceKind.h"

/// States of force devices in the user's language.
namespace ui::devices {

/// The shape beside a state.
enum class Sign : std::uint8_t {
    Ready,      ///< a tick
    Working,    ///< an hourglass: it gets ready by itself
    Attention,  ///< a triangle: the user has to do something
    Missing,    ///< a cross: there is nothing to use
    Off         ///< an eye, quiet: the user has not turned it on
};

[[nodiscard]] Sign signOf(const DeviceKind& kind, const core::session::DeviceReport& report);
[[nodiscard]] QPixmap signPixmap(Sign sign, const QPalette& palette, int sizePx, double devicePixelRatio);
/// "Plugged in, but it cannot be opened."
[[nodiscard]] QString stateWords(const DeviceKind& kind, const core::session::DeviceReport& report);
/// What to do about the state, one or two sentences; empty if there is nothing to do.
[[nodiscard]] QString helpWords(const DeviceKind& kind, const core::session::DeviceReport& report);
/// The device is plugged in, and the user lacks the right to open it.
[[nodiscard]] bool lacksPermission(const core::session::DeviceReport& report);
/// "Drill", "Undo", "Mirror", "Centre": the grip buttons in the order of DeviceReport::presses.
[[nodiscard]] QString gripButtonName(std::size_t button);

}  // namespace ui::devices
