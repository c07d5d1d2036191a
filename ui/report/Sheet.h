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

/// Draws every sign as itself: of what the window's font would join or exchange for another form a PDF could not say
/// which signs it was made of, and copying out of it would lose them.
[[nodiscard]] QFont paperFont(int size, QFont::Weight weight = QFont::Normal);

/// A report that is being painted from top to bottom, with its foot on every page. All lengths are points.
class Sheet
{
public:
    Sheet(QPainter& painter, const QSizeF& page, const NextPage& next, const QString& title,
          const scoring::Proof& proof);

    [[nodiscard]] QPainter& painter() { return m_painter; }
    [[nodiscard]] double top() const { return m_top; }
    [[nodiscard]] double width() const { return m_page.width(); }
    [[nodiscard]] int pages() const { return m_pages; }
    /// Nobody sees it: pages are counted.
    [[nodiscard]] bool isCounting() const { return !m_next; }
    [[nodiscard]] double left() const { return bottom() - m_top; }

    /// Goes on to the next page if there is less height left than that.
    void need(double height);
    void skip(double height) { m_top += height; }
    /// Words over the whole width, broken into lines and over pages as wholes.
    void say(const QString& words, int size, QFont::Weight weight = QFont::Normal);
    /// A heading, kept together with what follows.
    void head(const QString& words, double with);
    void rule();
    void chart(const charts::Chart& chart, double height);
    /// Charts side by side.
    void chartRow(const QList<charts::Chart>& row, double height);
    /// Words in a part of the present line; does not go on.
    /// @return the height they take
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
