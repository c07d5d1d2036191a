// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QWidget>

#include "core/settings/PedalSettings.h"

namespace ui::devices {

/// A small picture of the speed of the bur over the travel of the pedal, with a point where the pedal is now.
class SpeedCurve : public QWidget
{
    Q_OBJECT
public:
    explicit SpeedCurve(QWidget* parent);

    void setShape(const core::settings::PedalSettings& shape);
    /// @param reading  of the axis; empty: the pedal is not plugged in
    void setReading(std::optional<double> reading);
    [[nodiscard]] QSize sizeHint() const override { return {180, 120}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    core::settings::PedalSettings m_shape;
    std::optional<double> m_reading;
};

}  // namespace ui::devices
