// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/Page.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/kit/Actions.h"
#include "ui/kit/LineIcon.h"
#include "ui/kit/Theme.h"

namespace ui::kit {
namespace {

/// A title of one line, elided if it does not fit.
class Title final : public QLabel
{
public:
    using QLabel::QLabel;

protected:
    void paintEvent(QPaintEvent*) override
    {
        const QString shown = fontMetrics().elidedText(text(), Qt::ElideRight, contentsRect().width());
        QPainter painter(this);
        painter.drawText(contentsRect(), Qt::AlignLeft | Qt::AlignVCenter, shown);
        setToolTip(shown == text() ? QString() : text());
    }
};

}  // namespace

Page::Page(const Actions& actions, QWidget* parent) : QWidget(parent), m_title(new Title(this)), m_body(new QVBoxLayout)
{
    setAutoFillBackground(true);
    auto* back = new QToolButton(this);
    back->setIcon(lineIcon(QStringLiteral("back"), palette()));
    back->setIconSize({22, 22});
    followWords(actions.back, back, [back, action = actions.back] {
        back->setToolTip(action->toolTip());
        back->setStatusTip(action->statusTip());
        back->setAccessibleName(action->text());
    });
    back->setFocusPolicy(Qt::TabFocus);
    connect(back, &QToolButton::clicked, actions.back, &QAction::trigger);
    back->installEventFilter(this);
    m_title->setFont(typeface(kTitle, QFont::DemiBold));
    m_title->setTextFormat(Qt::PlainText);
    m_title->setMinimumWidth(1);

    auto* head = new QHBoxLayout;
    head->setSpacing(kSpace2);
    head->addWidget(back);
    head->addWidget(m_title, 1);
    for (QAction* action : {actions.lessons, actions.attempts, actions.classes, actions.school}) {
        QPushButton* button = pageButton(action, "quiet", this);
        button->setVisible(action->isVisible());
        connect(action, &QAction::visibleChanged, button,
                [button, action] { button->setVisible(action->isVisible()); });
        head->addWidget(button);
    }
    head->addWidget(guestSign(actions, this));
    QPushButton* account = pageButton(actions.account, "quiet", this);
    account->setObjectName(QStringLiteral("accountButton"));
    head->addWidget(account);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(kSpace4, kSpace2, kSpace6, kSpace6);
    column->setSpacing(kSpace4);
    column->addLayout(head);
    column->addLayout(m_body, 1);
}

/// Makes Enter press the back arrow, as it presses the buttons beside it. Qt gives a tool button only the space bar.
bool Page::eventFilter(QObject* watched, QEvent* event)
{
    if (auto* arrow = qobject_cast<QToolButton*>(watched);
        arrow != nullptr && arrow->parent() == this && event->type() == QEvent::KeyPress)
        if (const int key = static_cast<QKeyEvent*>(event)->key(); key == Qt::Key_Return || key == Qt::Key_Enter) {
            arrow->click();
            return true;
        }
    return QWidget::eventFilter(watched, event);
}

void Page::removeGuestSign()
{
    delete findChild<QLabel*>(QStringLiteral("guestSign"));
}

bool Page::focusSearch() const
{
    for (auto* field : findChildren<QLineEdit*>())
        if (field->isClearButtonEnabled() && field->isVisible()) {
            field->setFocus(Qt::ShortcutFocusReason);
            field->selectAll();
            return true;
        }
    return false;
}

void Page::setTitle(const QString& title)
{
    m_title->setText(title);
}

}  // namespace ui::kit
