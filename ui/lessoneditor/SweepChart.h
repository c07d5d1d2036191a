// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/charts/Chart.h"
#include "ui/charts/WalkedChart.h"
#include "ui/lessoneditor/ToleranceSweep.h"

namespace ui::charts {
class SaveButton;
}

namespace ui::lessoneditor {

/// Scores of past attempts over the tolerance, 0 to 3 times what the rubric says: a line for each attempt, or the
/// median and the quartiles where they are many; dashed, how many percent pass. Says the figures under the pointer, or
/// where the arrow keys have got to, and can be saved.
class SweepChart : public charts::WalkedChart
{
    Q_OBJECT
public:
    explicit SweepChart(QWidget* parent);
    void setSweep(const Sweep& sweep);
    /// What is chosen with the pointer, in words: "At 1.5 times the tolerance 7 of 12 pass; median 78.4".
    [[nodiscard]] QString words(double times) const;
    /// As it is saved: in the colours of a light page.
    [[nodiscard]] charts::Chart chart() const;
    [[nodiscard]] QSize minimumSizeHint() const override { return {280, 180}; }

signals:
    /// @param words  empty: nothing any more
    void pointedAt(const QString& words);
    /// What became of a file, as a sentence.
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
    double m_toldTimes = 1.0;  ///< by the keys
};

}  // namespace ui::lessoneditor
