// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tooth/TouchGesture.h"

#include <algorithm>

#include <QLineF>

namespace ui::tooth {
namespace {

/// Least distance between two fingers; a smaller one counts as this.
constexpr double kNearestPx = 20.0;

double distancePx(const QList<QPointF>& fingersPx)
{
    return std::max(kNearestPx, QLineF(fingersPx[0], fingersPx[1]).length());
}

}  // namespace

TouchGesture::Step TouchGesture::move(const QList<QPointF>& fingersPx)
{
    Step step;
    if (fingersPx.size() == m_fingersPx.size() && fingersPx.size() == 1)
        step.turnPx = fingersPx[0] - m_fingersPx[0];
    if (fingersPx.size() == m_fingersPx.size() && fingersPx.size() == 2) {
        step.zoom = distancePx(fingersPx) / distancePx(m_fingersPx);
        step.middlePx = 0.5 * (fingersPx[0] + fingersPx[1]);
    }
    m_fingersPx = fingersPx;
    return step;
}

}  // namespace ui::tooth
