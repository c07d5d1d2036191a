// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/ScrollPane.h"

#include <QLinearGradient>
#include <QPainter>
#include <QScrollBar>

#include "ui/shell/LineIcon.h"
#include "ui/shell/Theme.h"

namespace ui::shell {
namespace {

constexpr int kEdgePx = 36;
constexpr int kArrowPx = 18;

/// Over the lower end of what scrolls.
class LowerEdge : public QWidget
{
public:
    /// @param page  has the ground's colour; the style sheet takes it from the scroll area
    LowerEdge(QPalette::ColorRole ground, const QWidget& page, QWidget* parent)
        : QWidget(parent), m_page(page), m_ground(ground)
    {
        setAttribute(Qt::WA_TransparentForMouseEvents);
        hide();
    }

protected:
    void paintEvent(QPaintEvent*) override
    {
        QPainter painter(this);
        const QColor solid = m_page.palette().color(m_ground);
        QColor clear = solid;
        clear.setAlpha(0);
        QLinearGradient fade(0, 0, 0, height());
        fade.setColorAt(0.0, clear);
        fade.setColorAt(0.6, solid);
        painter.fillRect(rect(), fade);
        painter.drawPixmap(
            (width() - kArrowPx) / 2, height() - kArrowPx,
            linePixmap(QStringLiteral("down"), palette().color(QPalette::WindowText), kArrowPx, devicePixelRatioF()));
    }

private:
    const QWidget& m_page;
    QPalette::ColorRole m_ground;
};

}  // namespace

ScrollPane::ScrollPane(QWidget* content, QPalette::ColorRole ground, QWidget* parent)
    : QScrollArea(parent), m_edge(new LowerEdge(ground, *parent, this))
{
    setWidget(content);
    setWidgetResizable(true);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFocusPolicy(Qt::NoFocus);
    viewport()->setAutoFillBackground(false);
    content->setAutoFillBackground(false);
    connect(verticalScrollBar(), &QScrollBar::rangeChanged, this, &ScrollPane::placeEdge);
    connect(verticalScrollBar(), &QScrollBar::valueChanged, this, &ScrollPane::placeEdge);
}

bool ScrollPane::hasMoreBelow() const
{
    // The last margin is nothing to look for.
    return verticalScrollBar()->maximum() - verticalScrollBar()->value() > kSpace2;
}

void ScrollPane::resizeEvent(QResizeEvent* event)
{
    QScrollArea::resizeEvent(event);
    placeEdge();
}

void ScrollPane::placeEdge()
{
    const QRect shown = viewport()->geometry();
    m_edge->setGeometry(shown.left(), shown.bottom() + 1 - kEdgePx, shown.width(), kEdgePx);
    m_edge->setVisible(hasMoreBelow());
    m_edge->raise();
}

}  // namespace ui::shell
