// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QPointF>

namespace ui::tooth {

/// Turns the places of the fingers on a touch screen into turns and zooms of the view: one finger turns, two zoom.
class TouchGesture
{
public:
    struct Step
    {
        QPointF turnPx;      ///< way of the one finger
        double zoom = 1.0;   ///< ratio of the distance of two fingers to that before
        QPointF middlePx{};  ///< between the two fingers
    };

    /// Takes the places of all fingers that are down. A finger more or less begins anew.
    [[nodiscard]] Step move(const QList<QPointF>& fingersPx);
    void end() { m_fingersPx.clear(); }

private:
    QList<QPointF> m_fingersPx;
};

}  // namespace ui::tooth
