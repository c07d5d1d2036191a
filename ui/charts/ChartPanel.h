// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "ui/charts/WalkedChart.h"

class QLabel;

namespace ui::charts {

class SaveButton;

/// A chart with its title. The pointer, or the arrow keys when the chart has the focus, select values, and each is
/// described in words. A click or Enter opens the attempt of the value. The chart can be exported as a picture or a
/// table. The result of the export is shown at the bottom until another value is selected or the chart changes.
class ChartPanel : public WalkedChart
{
    Q_OBJECT
public:
    explicit ChartPanel(QWidget* parent);

    void setChart(const Chart& chart);
    [[nodiscard]] const Chart& chart() const { return m_chart; }

    /// Returns the selected value; empty: none.
    [[nodiscard]] std::optional<qsizetype> stop() const { return m_stop; }
    void setStop(std::optional<qsizetype> stop);
    [[nodiscard]] QString said() const;

    [[nodiscard]] QSize sizeHint() const override { return {420, 280}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {260, 180}; }

signals:
    /// Emitted when the user opens a value that has an id.
    void chosen(qint64 id);

protected:
    [[nodiscard]] bool takes(Step step) const override;
    void walk(Step step) override;
    void point(std::optional<QPointF> at) override;
    void viewResized() override { fit(); }
    void paintOver(QPainter& painter) override;
    void focusOutEvent(QFocusEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void showWords();
    /// Draws as much of the chart as fits.
    void fit();
    void tell();
    void say(const QString& words, const QPoint& at);
    [[nodiscard]] std::optional<qsizetype> nearest(const QPointF& at) const;

    Chart m_chart;
    QList<Dot> m_stops;  ///< values of the part that fits
    std::optional<qsizetype> m_stop;
    QLabel* m_title;
    QLabel* m_note;
    SaveButton* m_save;
    QLabel* m_empty;
    QLabel* m_callout;
};

}  // namespace ui::charts
