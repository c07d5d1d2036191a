// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>
#include <QPalette>
#include <QString>

class QLabel;
class QWidget;

namespace ui::scoring {

/// Makes a label of plain text. The parent owns it.
[[nodiscard]] QLabel* scoreLabel(const QString& words, int size, QFont::Weight weight, QPalette::ColorRole role,
                                 QWidget* parent);

/// Makes a label wrap its text. The label takes the height that its width needs and reserves no more.
void fold(QLabel* words);

}  // namespace ui::scoring
