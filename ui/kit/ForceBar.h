// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace ui::kit {

/// The force on the hand as a bar, with a mark at the force the pointer is set to push with. It has the scale of the
/// slider that sets it: both reach to the same force.
class ForceBar : public QWidget
{
    Q_OBJECT
public:
    ForceBar(double fullN, QWidget* parent);

    /// @param limited  the force wanted more than the device may give: drawn in the colour of attention
    void setForce(double forceN, double setN, bool limited);
    [[nodiscard]] QSize sizeHint() const override { return {160, 12}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    double m_fullN;
    double m_forceN = 0.0;
    double m_setN = 1.0;
    bool m_limited = false;
};

}  // namespace ui::kit
