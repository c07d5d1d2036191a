// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QScrollArea>

namespace ui::kit {

/// A vertical scroll area. While content is hidden below, the lower edge fades and shows an arrow. A widget inside that
/// gets the focus is scrolled into view, and keys that it does not use scroll. If no widget inside can have the focus
/// and there is something to scroll, the pane itself takes it.
class ScrollPane : public QScrollArea
{
    Q_OBJECT
public:
    /// @param ground  colour role of the background behind the content
    ScrollPane(QWidget* content, QPalette::ColorRole ground, QWidget* parent);

    /// Returns whether content is hidden below the visible part.
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
