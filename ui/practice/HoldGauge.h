// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/grading/Exercise.h"

namespace ui::practice {

/// A large gauge of a force and the band in which the user must hold it. Smooths trembling that is too fast to see.
class HoldGauge final : public QWidget
{
    Q_OBJECT
public:
    explicit HoldGauge(QWidget* parent);

    /// Sets the band.
    void setAsked(const core::grading::ForceToHold& asked);
    /// Updates the force. Call once per frame.
    void setForce(double newtons);
    [[nodiscard]] QSize sizeHint() const override { return {400, 56}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void sayBand();
    [[nodiscard]] double placeOf(double newtons) const;

    core::grading::ForceToHold m_asked;
    double m_forceN = 0.0;  ///< smoothed
};

}  // namespace ui::practice
