// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace ui::kit {

/// Shows the force on the hand as a bar, with a mark at the push force set for the pointer. The scale is that of the
/// push force slider.
class ForceBar : public QWidget
{
    Q_OBJECT
public:
    /// @param fullN  the force at the right end, N
    ForceBar(double fullN, QWidget* parent);

    /// @param setN     the push force set for the pointer, N
    /// @param limited  the force was clamped to the device's limit; the bar then has the attention colour
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
