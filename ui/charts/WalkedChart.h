// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include <QWidget>

#include "ui/charts/Chart.h"
#include "ui/charts/Drawing.h"

namespace ui::charts {

/// The step that a key makes.
enum class Step : std::uint8_t { Back, On, First, Last, Open };

/// A chart whose values can be selected by the pointer, and by the arrow keys when it has the focus. Paints a focus
/// ring.
class WalkedChart : public QWidget
{
protected:
    explicit WalkedChart(QWidget* parent);

    /// Returns the widget in which the chart is drawn, for a layout.
    [[nodiscard]] QWidget* view() const { return m_view; }
    void setDrawn(const Chart& chart);
    [[nodiscard]] const Chart& drawn() const { return m_drawn; }
    /// Returns the axes in the view, px.
    [[nodiscard]] Plot plot() const;
    /// Returns the value along the horizontal axis after a step, a multiple of `by` from 0 to `most`.
    [[nodiscard]] static double stepped(Step step, double from, double by, double most);

    /// Returns whether the chart handles the keys of this step, even if they are shortcuts elsewhere.
    [[nodiscard]] virtual bool takes(Step step) const;
    virtual void walk(Step step) = 0;
    /// @param at  position in the view, px; empty: the pointer has left
    virtual void point(std::optional<QPointF> at) = 0;
    virtual void viewResized() {}
    virtual void paintOver(QPainter&) {}

    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    Chart m_drawn;
    QWidget* m_view;
};

}  // namespace ui::charts
