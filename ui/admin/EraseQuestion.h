// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <QString>

class QWidget;

namespace ui::admin {

/// Asks in a window whether a person is to be erased: what is removed, what stays, and that it cannot be undone.
/// @param erase  called if the user confirms
void askToErase(QWidget* window, const QString& person, std::function<void()> erase);

}  // namespace ui::admin
