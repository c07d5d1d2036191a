// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QScrollArea>

namespace ui::shell {

/// What may be higher than there is room for. While some of it lies below, its lower edge fades and an arrow points
/// there. It never scrolls sideways, and Tab passes it by.
class ScrollPane : public QScrollArea
{
    Q_OBJECT
public:
    /// @param ground  what lies behind the content
    ScrollPane(QWidget* content, QPalette::ColorRole ground, QWidget* parent);

    /// Some of the content lies below what is shown.
    [[nodiscard]] bool hasMoreBelow() const;

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void placeEdge();

    QWidget* m_edge;
};

}  // namespace ui::shell
