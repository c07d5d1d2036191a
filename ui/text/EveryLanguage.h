// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <QObject>

namespace ui::text {

/// Says something now, and again in each language that is chosen while `listener` lives: the words of a widget, set
/// where the widget is made.
///
///     bindTranslation(button, [button] { button->setText(tr("Log in")); });
///
/// @param listener  a widget, or a child of one: Qt tells nobody else that the language has changed. Ui thread.
void bindTranslation(QObject* listener, std::function<void()> say);

}  // namespace ui::text
