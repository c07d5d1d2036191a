// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QList>

class QHBoxLayout;
class QToolButton;

namespace ui::shell {

/// A bar of buttons. Where it is too narrow for the words of those that may fold, all of them show their drawing alone.
class FoldingBar : public QFrame
{
    Q_OBJECT
public:
    explicit FoldingBar(QWidget* parent);

    [[nodiscard]] QHBoxLayout& row() { return *m_row; }
    /// A button that shows words beside its drawing, and has a tooltip. It must stand in the row.
    void mayFold(QToolButton* button);

protected:
    void resizeEvent(QResizeEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void fold();

    QHBoxLayout* m_row;
    QList<QToolButton*> m_buttons;
};

}  // namespace ui::shell
