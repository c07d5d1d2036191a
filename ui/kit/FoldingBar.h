// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QList>

class QHBoxLayout;
class QToolButton;

namespace ui::kit {

/// A bar of buttons. Where it is too narrow, what may go goes first; then all buttons that may fold show their drawing
/// alone.
class FoldingBar : public QFrame
{
    Q_OBJECT
public:
    explicit FoldingBar(QWidget* parent);

    [[nodiscard]] QHBoxLayout& row() { return *m_row; }
    /// A button that shows words beside its drawing, and has a tooltip. It must stand in the row.
    void mayFold(QToolButton* button);
    /// What says nothing that is not said elsewhere. It must stand in the row, which shows and hides it.
    void mayGo(QWidget* widget);
    /// Looks again what there is room for, after words in the row have changed.
    void fold();

protected:
    bool event(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QHBoxLayout* m_row;
    QList<QToolButton*> m_buttons;
    QWidget* m_dispensable = nullptr;
};

}  // namespace ui::kit
