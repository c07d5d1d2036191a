// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "ui/study/ToleranceSweep.h"

class QChart;
class QChartView;

namespace ui::study {

/// Scores of past attempts over the tolerance, 0 to 3 times what the rubric says: a line for each attempt, or the
/// median and the middle half where they are many; how many pass, dashed, at the right axis. Says the figures under the
/// pointer.
class SweepChart : public QWidget
{
    Q_OBJECT
public:
    explicit SweepChart(QWidget* parent);
    void setSweep(const Sweep& sweep);
    /// What is chosen with the pointer, in words: "At 1.5 times the tolerance 7 of 12 pass; median 78.4".
    [[nodiscard]] QString words(double times) const;
    [[nodiscard]] QSize minimumSizeHint() const override { return {280, 180}; }

signals:
    /// @param words  empty: nothing any more
    void pointedAt(const QString& words);

protected:
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void draw();

    QChart* m_chart;
    QChartView* m_view;
    Sweep m_sweep;
};

}  // namespace ui::study
