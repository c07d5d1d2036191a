// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QString>
#include <QWidget>

namespace ui::scoring {

/// The last scores as columns, oldest first, with a line at the pass mark. The newest is highlighted. Scores of another
/// rubric are hatched, because they are not comparable. A tooltip describes the column under the pointer.
class RecentScoresChart : public QWidget
{
    Q_OBJECT
public:
    struct Score
    {
        int tenths = 0;
        bool isComparable = true;
        QString when{};  ///< date in words; empty: unknown
    };

    explicit RecentScoresChart(QWidget* parent);
    void setScores(const QList<Score>& oldestFirst, int passMarkTenths);
    [[nodiscard]] QSize sizeHint() const override { return {240, 84}; }

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    /// Returns the width of the text at the pass mark with its margins.
    [[nodiscard]] double marginPx() const;
    [[nodiscard]] double stepPx() const;
    [[nodiscard]] QString passMarkWords() const;
    [[nodiscard]] static QString words(const Score& score);

    QList<Score> m_scores;
    int m_passMarkTenths = 0;
};

}  // namespace ui::scoring
