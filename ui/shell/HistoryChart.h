// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QWidget>

namespace ui::shell {

/// The last scores as columns, oldest first, the newest marked, with the pass mark as a line. What was marked by
/// another rubric is hatched: it is shown and not compared.
class HistoryChart : public QWidget
{
    Q_OBJECT
public:
    struct Score
    {
        int tenths = 0;
        bool isComparable = true;
    };

    explicit HistoryChart(QWidget* parent);
    void setScores(const QList<Score>& oldestFirst, int passMarkTenths);
    [[nodiscard]] QSize sizeHint() const override { return {240, 84}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QList<Score> m_scores;
    int m_passMarkTenths = 0;
};

}  // namespace ui::shell
