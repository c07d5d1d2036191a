// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QWidget>

class QToolButton;

namespace ui::shell {

class Actions;

/// What every key does, made from the action table, and what the mouse does over the tooth. Lies over the window.
class HelpOverlay : public QWidget
{
    Q_OBJECT
public:
    HelpOverlay(const Actions& actions, QWidget* parent);

signals:
    /// A click beside the card.
    void leftByClick();

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    QFrame* m_card;
    QToolButton* m_close;
};

}  // namespace ui::shell
