// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inside/PictureKey.h"

#include <utility>

#include <QFontMetricsF>

#include "ui/kit/Theme.h"

namespace ui::inside {
namespace {

constexpr double kRowPx = 19.0;
constexpr double kBesidePx = 5.0;  ///< gap between a sign and its text
constexpr double kApartPx = 12.0;

QFont wordsFont()
{
    return kit::typeface(kit::kSmall);
}

}  // namespace

void PictureKey::add(const QString& words, double signPx, Sign sign)
{
    m_entries.push_back({words, signPx, std::move(sign), std::exchange(m_endsRow, false)});
}

std::vector<QPointF> PictureKey::places(double widthPx) const
{
    const QFontMetricsF metrics(wordsFont());
    std::vector<QPointF> places;
    QPointF at;
    for (const Entry& entry : m_entries) {
        const double wide = entry.signPx + kBesidePx + metrics.horizontalAdvance(entry.words);
        if (entry.beginsRow || (at.x() > 0.0 && at.x() + wide > widthPx))
            at = QPointF(0.0, at.y() + kRowPx);
        places.push_back(at);
        at.rx() += wide + kApartPx;
    }
    return places;
}

double PictureKey::heightFor(double widthPx) const
{
    return m_entries.empty() ? 0.0 : places(widthPx).back().y() + kRowPx;
}

void PictureKey::paint(QPainter& painter, const QRectF& area, const QColor& wordsColour) const
{
    painter.setFont(wordsFont());
    const std::vector<QPointF> all = places(area.width());
    for (std::size_t k = 0; k < m_entries.size(); ++k) {
        const Entry& entry = m_entries[k];
        const QPointF at = area.topLeft() + all[k];
        entry.sign(painter, QRectF(at.x(), at.y() + 0.5 * (kRowPx - kSignPx), entry.signPx, kSignPx));
        painter.setPen(wordsColour);
        painter.drawText(QRectF(at.x() + entry.signPx + kBesidePx, at.y(), area.width(), kRowPx),
                         Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip, entry.words);
    }
}

}  // namespace ui::inside
