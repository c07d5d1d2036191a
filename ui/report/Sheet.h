// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>
#include <QPainter>
#include <QRectF>
#include <QString>

#include "ui/charts/Chart.h"
#include "ui/report/Report.h"

namespace ui::report {

inline constexpr int kTitlePt = 18;
inline constexpr int kHeadPt = 11;
inline constexpr int kTextPt = 9;
inline constexpr int kSmallPt = 7;

/// Returns a font without ligatures and alternate forms. A PDF could not map those back to characters, and copied text
/// would lose them.
[[nodiscard]] QFont paperFont(int size, QFont::Weight weight = QFont::Normal);

/// Paints a report from top to bottom, with a footer on every page. All lengths are in points.
class Sheet
{
public:
    Sheet(QPainter& painter, const QSizeF& page, const NextPage& next, const QString& title,
          const scoring::Proof& proof);

    [[nodiscard]] QPainter& painter() { return m_painter; }
    [[nodiscard]] double top() const { return m_top; }
    [[nodiscard]] double width() const { return m_page.width(); }
    [[nodiscard]] int pages() const { return m_pages; }
    /// Returns whether pages are only being counted, without painting.
    [[nodiscard]] bool isCounting() const { return !m_next; }
    [[nodiscard]] double left() const { return bottom() - m_top; }

    /// Starts the next page if less than this height is left.
    void need(double height);
    void skip(double height) { m_top += height; }
    /// Adds text across the page, wrapped into lines. The text is not split between pages.
    void say(const QString& words, int size, QFont::Weight weight = QFont::Normal);
    /// Adds a heading. It is on the same page as the next `with` points of content.
    void head(const QString& words, double with);
    void rule();
    void chart(const charts::Chart& chart, double height);
    /// Adds charts side by side.
    void chartRow(const QList<charts::Chart>& row, double height);
    /// Paints text in a box without moving the current position.
    /// @return height of the text
    double put(const QRectF& box, const QString& words, int size, QFont::Weight weight, int flags);
    [[nodiscard]] double heightOf(double wide, const QString& words, int size, QFont::Weight weight);
    [[nodiscard]] double widthOf(const QString& words, int size, QFont::Weight weight);

private:
    [[nodiscard]] double bottom() const;
    void foot();

    QPainter& m_painter;
    QSizeF m_page;
    const NextPage& m_next;
    QString m_title;
    const scoring::Proof& m_proof;
    double m_top = 0.0;
    int m_pages = 1;
};

}  // namespace ui::report
