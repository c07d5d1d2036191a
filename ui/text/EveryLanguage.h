// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <QObject>

namespace ui::text {

/// Calls `say` now, and again whenever the language changes while `listener` exists. For the texts of a widget, where
/// the widget is created.
///
///     bindTranslation(button, [button] { button->setText(tr("Log in")); });
///
/// @param listener  a widget, or a child of one: Qt notifies only widgets of a change of language. Ui thread.
void bindTranslation(QObject* listener, std::function<void()> say);

}  // namespace ui::text
