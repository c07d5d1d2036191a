// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/practice/HandpieceChooser.h"

#include <QAction>
#include <QHBoxLayout>
#include <QToolButton>

#include "ui/kit/Actions.h"
#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"

namespace ui::practice {

HandpieceChooser::HandpieceChooser(const QList<QAction*>& actions, QWidget* parent) : QWidget(parent)
{
    text::bindTranslation(this, [this] { setAccessibleName(tr("Handpieces")); });
    m_row = new QHBoxLayout(this);
    m_row->setContentsMargins(0, 0, 0, 0);
    m_row->setSpacing(kit::kSpace1);
    for (QAction* action : actions) {
        QToolButton* button = kit::barButton(action, true, this);
        button->setToolButtonStyle(Qt::ToolButtonTextOnly);
        button->setProperty("kind", "segment");
        button->setFont(kit::typeface(kit::kSmall, QFont::Medium));
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        m_row->addWidget(button);
        // Queued until all buttons exist and have their translated text.
        const auto later = [this] {
            QMetaObject::invokeMethod(this, &HandpieceChooser::arrange, Qt::QueuedConnection);
        };
        kit::followWords(action, button, later);
        connect(action, &QAction::visibleChanged, this, later);
    }
}

void HandpieceChooser::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    arrange();
}

void HandpieceChooser::arrange()
{
    int together = 0;
    int count = 0;
    for (const QToolButton* button : findChildren<QToolButton*>())
        if (!button->isHidden()) {
            together += button->sizeHint().width();
            ++count;
        }
    const bool fits = together + (count - 1) * kit::kSpace1 <= width();
    m_row->setDirection(fits ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
}

}  // namespace ui::practice
