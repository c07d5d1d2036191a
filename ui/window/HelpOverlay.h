// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QList>
#include <QWidget>

class QToolButton;

namespace ui::kit {
class Actions;
class ScrollPane;
}  // namespace ui::kit

namespace ui::window {

/// An overlay over the window that lists what every key does, from the action table, and what the mouse does over the
/// tooth. Shows as many columns as there is room for.
class HelpOverlay : public QWidget
{
    Q_OBJECT
public:
    HelpOverlay(const kit::Actions& actions, QWidget* parent);

signals:
    /// Emitted when the user clicks beside the card.
    void leftByClick();

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void makeGroups(const kit::Actions& actions);
    void arrange();
    void fill(int columns);

    QFrame* m_card;
    QToolButton* m_close;
    QWidget* m_content;
    kit::ScrollPane* m_scroll = nullptr;
    QList<QWidget*> m_groups;  ///< each a heading with its rows
    int m_columns = 0;         ///< present number of columns; 0: the groups must be arranged again
};

}  // namespace ui::window
