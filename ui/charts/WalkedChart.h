// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace ui::charts {

/// A chart of curves over one axis along which the arrow keys walk when it has the focus, as the pointer does; then it
/// has a ring around it.
class WalkedChart : public QWidget
{
protected:
    /// @param step  of a key
    /// @param most  the axis goes from 0 to this
    WalkedChart(double step, double most, QWidget* parent);

    /// Where the keys have got to.
    [[nodiscard]] virtual double told() const = 0;
    /// Tells the figures there; may be beyond either end.
    virtual void walkTo(double value) = 0;

    /// The keys that walk are the chart's, whatever else they are keys of.
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    double m_step;
    double m_most;
};

}  // namespace ui::charts
