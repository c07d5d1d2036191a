// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QWidget>

#include "ui/charts/Chart.h"

class QChart;
class QChartView;
class QGraphicsEllipseItem;
class QLabel;
class QTimer;

namespace ui::charts {

class SaveButton;

/// A chart with its title. The pointer, or the arrow keys when it has the focus, go from value to value, and each is
/// told in words; a click or Enter opens what the value stands for. Can be saved as a picture or as a table.
class ChartPanel : public QWidget
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

    /// Writes .png, .svg or .csv, by the name's ending, and says over the foot of the chart what became of it: for some
    /// seconds, or until the chart is another one where it came to nothing.
    bool save(const QString& path);

    [[nodiscard]] QSize sizeHint() const override { return {420, 280}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {260, 180}; }

signals:
    /// A value was opened, and stands for something.
    void chosen(qint64 id);

protected:
    void paintEvent(QPaintEvent* event) override;
    /// The keys that walk are the chart's, whatever else they are keys of.
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void showWords();
    /// Once before it is painted next, however often it is asked for, and where it is hidden not before it is shown:
    /// drawing takes milliseconds.
    void redrawSoon();
    void redrawWhenSeen();
    void redrawIfStale();
    void redraw();
    void placeSaved();
    void tell();
    void open();
    void saySaved(const QString& sentence, bool isSaved);
    /// Where a value lies in the view, px.
    [[nodiscard]] QPointF placeOf(const Dot& dot) const;
    [[nodiscard]] std::optional<qsizetype> nearest(const QPointF& at) const;

    Chart m_chart;
    Chart m_shown;  ///< what of it there is room for
    QList<Dot> m_stops;
    std::optional<qsizetype> m_stop;
    bool m_isStale = false;  ///< what is drawn is not what is to be
    QLabel* m_title;
    QLabel* m_note;
    SaveButton* m_save;
    QChart* m_drawn = nullptr;
    QChartView* m_view;
    QGraphicsEllipseItem* m_ring = nullptr;
    QLabel* m_empty;
    QLabel* m_callout;
    QLabel* m_saved;
    QTimer* m_forSaved;  ///< until that goes
};

}  // namespace ui::charts
