// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include <QWidget>

#include "ui/charts/Chart.h"
#include "ui/charts/Drawing.h"

namespace ui::charts {

/// What a key asks for.
enum class Step : std::uint8_t { Back, On, First, Last, Open };

/// A chart along which the arrow keys walk when it has the focus, as the pointer does; then it has a ring around it.
class WalkedChart : public QWidget
{
protected:
    explicit WalkedChart(QWidget* parent);

    /// Where the chart is drawn: to be put into a layout.
    [[nodiscard]] QWidget* view() const { return m_view; }
    void setDrawn(const Chart& chart);
    [[nodiscard]] const Chart& drawn() const { return m_drawn; }
    /// In the view, px.
    [[nodiscard]] Plot plot() const;
    /// The value along the lying axis that a step leads to from another.
    [[nodiscard]] static double stepped(Step step, double from, double by, double most);

    /// Whether a key that stands for this step is the chart's, whatever else it is a key of.
    [[nodiscard]] virtual bool takes(Step step) const;
    virtual void walk(Step step) = 0;
    /// @param at  in the view, px; nothing: the pointer is gone
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
