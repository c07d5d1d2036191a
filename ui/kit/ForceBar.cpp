// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/ForceBar.h"

#include <algorithm>
#include <cmath>

#include <QPainter>

#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"

namespace ui::kit {

ForceBar::ForceBar(double fullN, QWidget* parent) : QWidget(parent), m_fullN(fullN)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    text::bindTranslation(this, [this] {
        setAccessibleName(tr("Force against the force that is set"));
        setToolTip(tr("The mark is the force that is set. A wall that presses sideways adds to it."));
    });
}

void ForceBar::setForce(double forceN, double setN, bool limited)
{
    if (std::abs(forceN - m_forceN) < 0.005 && setN == m_setN && limited == m_limited)
        return;
    m_forceN = forceN;
    m_setN = setN;
    m_limited = limited;
    update();
}

void ForceBar::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF groove(0, 3, width(), 6);
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette().color(QPalette::Mid));
    painter.drawRoundedRect(groove, 3, 3);
    const double share = std::clamp(m_forceN / m_fullN, 0.0, 1.0);
    const Tones tone = tones(palette());
    if (share > 0.01) {
        const QRectF bar(0, 3, std::max(6.0, share * width()), 6);
        painter.setBrush(m_limited ? tone.attention : tone.accent);
        painter.drawRoundedRect(bar, 3, 3);
    }
    const double mark = std::clamp(m_setN / m_fullN * width(), 1.0, width() - 1.0);
    painter.setBrush(palette().color(QPalette::WindowText));
    painter.drawRoundedRect(QRectF(mark - 1, 0, 2, 12), 1, 1);
}

}  // namespace ui::kit
