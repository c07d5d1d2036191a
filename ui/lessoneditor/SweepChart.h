// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/charts/Chart.h"
#include "ui/charts/WalkedChart.h"
#include "ui/lessoneditor/ToleranceSweep.h"

namespace ui::charts {
class SaveButton;
}

namespace ui::lessoneditor {

/// A chart of past scores against the tolerance, from 0 to 3 times that of the rubric: a line for each attempt, or the
/// median and quartiles if there are many. A dashed line shows the percentage that passes. The chart shows the figures
/// at the pointer or at the position of the arrow keys, and can be exported.
class SweepChart : public charts::WalkedChart
{
    Q_OBJECT
public:
    explicit SweepChart(QWidget* parent);
    void setSweep(const Sweep& sweep);
    /// Returns the figures at a tolerance in words: "At 1.5 times the tolerance 7 of 12 pass; median 78.4".
    [[nodiscard]] QString words(double times) const;
    /// Returns the chart for export, in the colours of a light page.
    [[nodiscard]] charts::Chart chart() const;
    [[nodiscard]] QSize minimumSizeHint() const override { return {280, 180}; }

signals:
    /// Emitted when the user points at another tolerance.
    /// @param words  empty: the pointer has left
    void pointedAt(const QString& words);
    /// Emitted when the chart was exported, or the export has failed.
    void saved(const QString& sentence);

protected:
    void walk(charts::Step step) override;
    void point(std::optional<QPointF> at) override;
    void changeEvent(QEvent* event) override;

private:
    [[nodiscard]] charts::Chart chartIn(const QPalette& palette) const;
    [[nodiscard]] QList<charts::Line> attemptLines() const;

    charts::SaveButton* m_save = nullptr;
    Sweep m_sweep;
    double m_toldTimes = 1.0;  ///< position of the arrow keys
};

}  // namespace ui::lessoneditor
