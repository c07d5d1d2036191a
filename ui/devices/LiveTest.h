// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

#include "core/session/DeviceReport.h"

class QBoxLayout;
class QGridLayout;
class QLabel;

namespace ui::kit {
class TabularDigitsLabel;
}

namespace ui::devices {

class ButtonLights;
class ForceTest;
class IntervalChart;
class PositionView;

/// Shows measurements of a ready device: position, grip buttons, and statistics of the communication with it. Six
/// buttons test its force.
class LiveTest : public QFrame
{
    Q_OBJECT
public:
    explicit LiveTest(QWidget* parent);

    /// @param scale  movement of the hand per movement of the bur
    void setReport(const core::session::DeviceReport& report, double scale);
    /// Sets whether the parts are one below the other, for a narrow page.
    void setNarrow(bool isNarrow);
    [[nodiscard]] const ForceTest& force() const { return *m_force; }

private:
    kit::TabularDigitsLabel* addFigure(QGridLayout& grid, int row, int column, const char* name, QLabel*& caption);

    QBoxLayout* m_columns;
    PositionView* m_position;
    ForceTest* m_force;
    ButtonLights* m_buttons;
    IntervalChart* m_intervals;
    kit::TabularDigitsLabel* m_rate = nullptr;
    kit::TabularDigitsLabel* m_trip = nullptr;
    kit::TabularDigitsLabel* m_slowTrip = nullptr;
    kit::TabularDigitsLabel* m_lost = nullptr;
    kit::TabularDigitsLabel* m_rejected = nullptr;
};

}  // namespace ui::devices
