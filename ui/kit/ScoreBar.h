// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace ui::kit {

/// A bar of 0 to 100 points with a mark at the pass mark.
class ScoreBar : public QWidget
{
    Q_OBJECT
public:
    explicit ScoreBar(QWidget* parent);
    void setScore(int scoreTenths, int passMarkTenths);
    [[nodiscard]] QSize sizeHint() const override { return {240, 34}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    int m_scoreTenths = 0;
    int m_passMarkTenths = 0;
};

}  // namespace ui::kit
