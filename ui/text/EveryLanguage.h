// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <QObject>

namespace ui::text {

/// Calls `say` now, and again whenever the language changes while `listener` exists. Use it to set the texts of a
/// widget where the widget is created.
///
///     bindTranslation(button, [button] { button->setText(tr("Log in")); });
///
/// @param listener  a widget, or a child of one, because Qt sends language changes only to widgets. Ui thread.
void bindTranslation(QObject* listener, std::function<void()> say);

}  // namespace ui::text
