// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/HandpieceChooser.h"

#include <QHBoxLayout>
#include <QToolButton>

#include "ui/shell/Actions.h"
#include "ui/shell/Theme.h"
#include "ui/text/EveryLanguage.h"

namespace ui::shell {

HandpieceChooser::HandpieceChooser(const QList<QAction*>& actions, QWidget* parent) : QWidget(parent)
{
    text::inEveryLanguage(this, [this] { setAccessibleName(tr("Handpieces")); });
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(kSpace1);
    for (QAction* action : actions) {
        QToolButton* button = barButton(action, true, this);
        button->setToolButtonStyle(Qt::ToolButtonTextOnly);
        button->setProperty("kind", "segment");
        button->setFont(typeface(kSmall, QFont::Medium));
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        row->addWidget(button);
    }
}

}  // namespace ui::shell
