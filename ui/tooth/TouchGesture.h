// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QPointF>

namespace ui::tooth {

/// Converts the positions of fingers on a touch screen to rotation and zoom of the view: one finger rotates, two zoom.
class TouchGesture
{
public:
    struct Step
    {
        QPointF turnPx;      ///< movement of the finger, if there is one
        double zoom = 1.0;   ///< ratio of the distance of two fingers to the distance before
        QPointF middlePx{};  ///< between the two fingers
    };

    /// Handles the positions of all fingers that touch the screen. When their number changes, the gesture starts again.
    [[nodiscard]] Step move(const QList<QPointF>& fingersPx);
    void end() { m_fingersPx.clear(); }

private:
    QList<QPointF> m_fingersPx;
};

}  // namespace ui::tooth
