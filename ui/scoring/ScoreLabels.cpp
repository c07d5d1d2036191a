// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scoring/ScoreLabels.h"

#include <QLabel>

#include "ui/kit/Theme.h"

namespace ui::scoring {

QLabel* scoreLabel(const QString& words, int size, QFont::Weight weight, QPalette::ColorRole role, QWidget* parent)
{
    auto* made = new QLabel(words, parent);
    made->setTextFormat(Qt::PlainText);
    made->setFont(kit::typeface(size, weight));
    made->setForegroundRole(role);
    return made;
}

void fold(QLabel* words)
{
    words->setWordWrap(true);
    words->setMinimumSize(1, 1);
}

}  // namespace ui::scoring
