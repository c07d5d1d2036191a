// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/session/DeviceReport.h"

namespace ui::devices {

/// Histogram of the intervals between the answers of a device, over the last second.
class IntervalChart : public QWidget
{
    Q_OBJECT
public:
    explicit IntervalChart(QWidget* parent);

    void setFigures(const core::session::ExchangeFigures& figures);
    [[nodiscard]] QSize sizeHint() const override { return {280, 120}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {220, 100}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void describe();

    core::session::ExchangeFigures m_figures;
};

}  // namespace ui::devices
