// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QString>
#include <QWidget>

namespace ui::scoring {

/// The last scores as columns, oldest first, the newest marked, with the pass mark as a line. What was marked by
/// another rubric is hatched: it is shown and not compared. The pointer on a column is told what it stands for.
class RecentScoresChart : public QWidget
{
    Q_OBJECT
public:
    struct Score
    {
        int tenths = 0;
        bool isComparable = true;
        QString when{};  ///< in words; empty: nobody knows
    };

    explicit RecentScoresChart(QWidget* parent);
    void setScores(const QList<Score>& oldestFirst, int passMarkTenths);
    [[nodiscard]] QSize sizeHint() const override { return {240, 84}; }

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    /// Of what is written at the pass mark, with the air around it.
    [[nodiscard]] double marginPx() const;
    [[nodiscard]] double stepPx() const;
    [[nodiscard]] int wholePoints(int tenths) const;
    [[nodiscard]] QString passMarkWords() const;
    [[nodiscard]] static QString words(const Score& score);

    QList<Score> m_scores;
    int m_passMarkTenths = 0;
};

}  // namespace ui::scoring
