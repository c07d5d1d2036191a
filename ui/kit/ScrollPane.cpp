// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/ScrollPane.h"

#include <algorithm>

#include <QApplication>
#include <QKeyEvent>
#include <QLinearGradient>
#include <QPainter>
#include <QScrollBar>

#include "ui/kit/LineIcon.h"
#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"

namespace ui::kit {
namespace {

constexpr int kEdgePx = 36;
constexpr int kArrowPx = 18;

/// Fades the lower edge of the scrolled content.
class LowerEdge : public QWidget
{
public:
    /// @param page  has the background colour, which the style sheet changes for the scroll area
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

/// A focus ring around content that the keyboard scrolls.
class Ring : public QWidget
{
public:
    explicit Ring(QWidget* parent) : QWidget(parent)
    {
        setAttribute(Qt::WA_TransparentForMouseEvents);
        hide();
    }

protected:
    void paintEvent(QPaintEvent*) override
    {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(palette().color(QPalette::Link), 2.0));
        painter.drawRoundedRect(QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0), kRadius, kRadius);
    }
};

/// Returns whether the content contains a widget that can have the focus. If so, that widget's keys scroll.
bool hasStop(const QWidget& content)
{
    const auto all = content.findChildren<QWidget*>();
    return std::any_of(all.begin(), all.end(), [&content](const QWidget* one) {
        return (one->focusPolicy() & Qt::TabFocus) != 0 && one->isEnabled() && one->isVisibleTo(&content);
    });
}

bool isScrollKey(const QKeyEvent& event)
{
    constexpr int kKeys[] = {Qt::Key_Up, Qt::Key_Down, Qt::Key_PageUp, Qt::Key_PageDown, Qt::Key_Home, Qt::Key_End};
    return (event.modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier &&
           std::find(std::begin(kKeys), std::end(kKeys), event.key()) != std::end(kKeys);
}

}  // namespace

ScrollPane::ScrollPane(QWidget* content, QPalette::ColorRole ground, QWidget* parent)
    : QScrollArea(parent), m_edge(new LowerEdge(ground, *parent, this)), m_ring(new Ring(this))
{
    setWidget(content);
    setWidgetResizable(true);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFocusPolicy(Qt::NoFocus);
    viewport()->setAutoFillBackground(false);
    content->setAutoFillBackground(false);
    connect(verticalScrollBar(), &QScrollBar::rangeChanged, this, &ScrollPane::placeEdge);
    connect(verticalScrollBar(), &QScrollBar::valueChanged, this, &ScrollPane::placeEdge);
    // A widget that gets the focus by a click must stay under the pointer until the button is released.
    connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) {
        if (now != nullptr && widget()->isAncestorOf(now) && QGuiApplication::mouseButtons() == Qt::NoButton)
            reveal(*now);
    });
    text::bindTranslation(this, [this] {
        setAccessibleName(tr("More than there is room for"));
        setAccessibleDescription(tr("Page Up, Page Down and the arrow keys scroll"));
    });
}

/// Scrolls to a widget with a margin around it, clear of the fading edge. If the widget is higher than the pane, shows
/// its upper end.
void ScrollPane::reveal(const QWidget& what)
{
    QScrollBar* const bar = verticalScrollBar();
    const int top = what.mapTo(widget(), QPoint(0, 0)).y() - kSpace4;
    const int lowest = top + kSpace4 + what.height() + kEdgePx - viewport()->height();
    if (top < bar->value() || lowest > bar->value())
        bar->setValue(top < bar->value() ? top : std::min(top, lowest));
}

bool ScrollPane::hasMoreBelow() const
{
    // Ignores the last margin, which is empty.
    return verticalScrollBar()->maximum() - verticalScrollBar()->value() > kSpace2;
}

void ScrollPane::resizeEvent(QResizeEvent* event)
{
    QScrollArea::resizeEvent(event);
    placeEdge();
}

bool ScrollPane::event(QEvent* event)
{
    // Some of these keys are also shortcuts of a replay. Up and Down move from button to button while one inside has
    // the focus.
    if (event->type() == QEvent::ShortcutOverride && verticalScrollBar()->maximum() > 0) {
        const auto* key = static_cast<QKeyEvent*>(event);
        const bool isArrow = key->key() == Qt::Key_Up || key->key() == Qt::Key_Down;
        if (isScrollKey(*key) && (hasFocus() || !isArrow)) {
            event->accept();
            return true;
        }
    }
    return QScrollArea::event(event);
}

/// Handles the keys that no widget inside uses.
void ScrollPane::keyPressEvent(QKeyEvent* event)
{
    if (isScrollKey(*event) && (event->key() == Qt::Key_Home || event->key() == Qt::Key_End))
        verticalScrollBar()->triggerAction(event->key() == Qt::Key_Home ? QScrollBar::SliderToMinimum
                                                                        : QScrollBar::SliderToMaximum);
    else
        QScrollArea::keyPressEvent(event);
}

void ScrollPane::focusInEvent(QFocusEvent* event)
{
    QScrollArea::focusInEvent(event);
    m_ring->show();
    m_ring->raise();
}

void ScrollPane::focusOutEvent(QFocusEvent* event)
{
    QScrollArea::focusOutEvent(event);
    m_ring->hide();
}

void ScrollPane::placeEdge()
{
    const bool scrolls = verticalScrollBar()->maximum() > 0;
    setFocusPolicy(scrolls && (hasFocus() || !hasStop(*widget())) ? Qt::TabFocus : Qt::NoFocus);
    m_ring->setGeometry(rect());
    const QRect shown = viewport()->geometry();
    m_edge->setGeometry(shown.left(), shown.bottom() + 1 - kEdgePx, shown.width(), kEdgePx);
    m_edge->setVisible(hasMoreBelow());
    m_edge->raise();
}

}  // namespace ui::kit
