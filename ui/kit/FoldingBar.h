// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QList>

class QHBoxLayout;
class QToolButton;

namespace ui::kit {

/// A bar of buttons. If it is too narrow, it first hides the widget of mayGo(), then reduces the buttons of mayFold()
/// to their icons.
class FoldingBar : public QFrame
{
    Q_OBJECT
public:
    explicit FoldingBar(QWidget* parent);

    [[nodiscard]] QHBoxLayout& row() { return *m_row; }
    /// Lets the bar reduce a button to its icon. The button must be in row() and have text, an icon and a tooltip.
    void mayFold(QToolButton* button);
    /// Lets the bar hide a widget whose content is also shown elsewhere. The widget must be in row(). Only one widget
    /// can be set.
    void mayGo(QWidget* widget);
    /// Lays the bar out again. Call after the text of a widget in row() has changed.
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
