// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include <QPainter>
#include <QRectF>
#include <QString>

namespace ui::inside {

/// The legend of a picture: signs with text, in as many rows as its width needs.
class PictureKey
{
public:
    using Sign = std::function<void(QPainter& painter, const QRectF& box)>;

    /// Adds an entry.
    /// @param signPx  width of the sign; its height is kSignPx
    void add(const QString& words, double signPx, Sign sign);
    /// Makes the next entry start a row.
    void endRow() { m_endsRow = true; }
    [[nodiscard]] double heightFor(double widthPx) const;
    /// Paints the legend from the top left of an area.
    void paint(QPainter& painter, const QRectF& area, const QColor& wordsColour) const;

    static constexpr double kSignPx = 13.0;

private:
    struct Entry
    {
        QString words;
        double signPx = kSignPx;
        Sign sign;
        bool beginsRow = false;
    };
    /// Returns the position of each entry's sign, from the top left of the legend.
    [[nodiscard]] std::vector<QPointF> places(double widthPx) const;

    std::vector<Entry> m_entries;
    bool m_endsRow = false;
};

}  // namespace ui::inside
