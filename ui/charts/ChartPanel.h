// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "ui/charts/WalkedChart.h"

class QLabel;

namespace ui::charts {

class SaveButton;

/// A chart with its title. The pointer, or the arrow keys when it has the focus, go from value to value, and each is
/// told in words; a click or Enter opens what the value stands for. Can be saved as a picture or as a table; over the
/// foot stands what became of the file, until a value is told or the chart is another one.
class ChartPanel : public WalkedChart
{
    Q_OBJECT
public:
    explicit ChartPanel(QWidget* parent);

    void setChart(const Chart& chart);
    [[nodiscard]] const Chart& chart() const { return m_chart; }

    /// The value that is being told; nothing: none.
    [[nodiscard]] std::optional<qsizetype> stop() const { return m_stop; }
    void setStop(std::optional<qsizetype> stop);
    [[nodiscard]] QString said() const;

    [[nodiscard]] QSize sizeHint() const override { return {420, 280}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {260, 180}; }

signals:
    /// A value was opened, and stands for something.
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
    /// Draws as much of the chart as there is room for.
    void fit();
    void tell();
    void say(const QString& words, const QPoint& at);
    [[nodiscard]] std::optional<qsizetype> nearest(const QPointF& at) const;

    Chart m_chart;
    QList<Dot> m_stops;  ///< of what there is room for
    std::optional<qsizetype> m_stop;
    QLabel* m_title;
    QLabel* m_note;
    SaveButton* m_save;
    QLabel* m_empty;
    QLabel* m_callout;
};

}  // namespace ui::charts
