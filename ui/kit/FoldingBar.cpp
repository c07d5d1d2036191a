// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/FoldingBar.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QToolButton>

#include "ui/kit/Theme.h"

namespace ui::kit {
namespace {

constexpr int kHeightPx = 52;

}  // namespace

FoldingBar::FoldingBar(QWidget* parent) : QFrame(parent), m_row(new QHBoxLayout(this))
{
    setProperty("kind", "bar");
    setFixedHeight(kHeightPx);
    m_row->setContentsMargins(kSpace2, 0, kSpace2, 0);
    m_row->setSpacing(kSpace1);
}

void FoldingBar::mayFold(QToolButton* button)
{
    button->installEventFilter(this);
    m_buttons << button;
}

void FoldingBar::mayGo(QWidget* widget)
{
    m_dispensable = widget;
}

bool FoldingBar::event(QEvent* event)
{
    const bool taken = QFrame::event(event);
    if (event->type() == QEvent::LanguageChange)  // all widgets in the row have been retranslated by now
        fold();
    return taken;
}

void FoldingBar::resizeEvent(QResizeEvent* event)
{
    QFrame::resizeEvent(event);
    fold();
}

bool FoldingBar::eventFilter(QObject* watched, QEvent* event)
{
    // Folds again when a button appears or vanishes. After a language change, waits until all buttons have been
    // retranslated.
    if (event->type() == QEvent::ShowToParent || event->type() == QEvent::HideToParent)
        fold();
    else if (event->type() == QEvent::LanguageChange)
        QMetaObject::invokeMethod(this, &FoldingBar::fold, Qt::QueuedConnection);
    return QFrame::eventFilter(watched, event);
}

void FoldingBar::fold()
{
    const auto show = [this](Qt::ToolButtonStyle style) {
        for (QToolButton* button : m_buttons)
            button->setToolButtonStyle(style);
        m_row->invalidate();
    };
    const auto isTooNarrow = [this] { return m_row->minimumSize().width() > width(); };
    show(Qt::ToolButtonTextBesideIcon);
    if (m_dispensable != nullptr) {
        m_dispensable->show();
        m_row->invalidate();
        m_dispensable->setVisible(!isTooNarrow());
        m_row->invalidate();
    }
    if (isTooNarrow())
        show(Qt::ToolButtonIconOnly);
}

}  // namespace ui::kit
