// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/session/ControllerReport.h"

namespace ui::devices {

/// Shows the axes of a controller as bars that move with them, and its buttons as lights. The light of a held button is
/// filled.
class AxisBars : public QWidget
{
    Q_OBJECT
public:
    explicit AxisBars(QWidget* parent);

    /// @param pedalAxis  the axis to mark; kNoAxis: none
    void setController(const core::session::Controller& controller, int pedalAxis);
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void describe();
    void paintAxis(QPainter& painter, std::size_t axis) const;
    void paintButton(QPainter& painter, std::size_t button) const;

    core::session::Controller m_controller;
    int m_pedalAxis = -1;
};

}  // namespace ui::devices
