// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include <QPainter>
#include <QRectF>
#include <QString>

namespace ui::inside {

/// The key of a picture: signs with words beside them, in as many rows as its width asks for.
class PictureKey
{
public:
    using Sign = std::function<void(QPainter& painter, const QRectF& box)>;

    /// @param signPx  how wide the sign is; it is kSignPx high
    void add(const QString& words, double signPx, Sign sign);
    /// What is added next begins a row.
    void endRow() { m_endsRow = true; }
    [[nodiscard]] double heightFor(double widthPx) const;
    /// From the top left of an area down.
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
    /// Where each entry's sign is, from the top left of the key.
    [[nodiscard]] std::vector<QPointF> places(double widthPx) const;

    std::vector<Entry> m_entries;
    bool m_endsRow = false;
};

}  // namespace ui::inside
