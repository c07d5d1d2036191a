// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QScrollArea>

namespace ui::kit {

/// What may be higher than there is room for. While some of it lies below, its lower edge fades and an arrow points
/// there. It never scrolls sideways. Whatever gets the keyboard within comes into sight, and the keys that it has no
/// use for scroll; where nothing within can have it and there is something to scroll, Tab stops at the pane itself.
class ScrollPane : public QScrollArea
{
    Q_OBJECT
public:
    /// @param ground  what lies behind the content
    ScrollPane(QWidget* content, QPalette::ColorRole ground, QWidget* parent);

    /// Some of the content lies below what is shown.
    [[nodiscard]] bool hasMoreBelow() const;

protected:
    bool event(QEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void placeEdge();
    void reveal(const QWidget& what);

    QWidget* m_edge;
    QWidget* m_ring;
};

}  // namespace ui::kit
