// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/Sheet.h"

#include <algorithm>

#include <QCoreApplication>
#include <QLocale>

#include "ui/charts/Drawing.h"
#include "ui/kit/Theme.h"

namespace ui::report {
namespace {

struct SheetWords
{
    Q_DECLARE_TR_FUNCTIONS(ui::report::Sheet)
};

constexpr double kFootPt = 30.0;
constexpr double kGapPt = 10.0;
constexpr double kChartScale = 0.72;  ///< text of 12 and 14 px becomes 8.6 and 10 pt
constexpr int kFoldedWords = Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap;

}  // namespace

QFont paperFont(int size, QFont::Weight weight)
{
    QFont font = kit::typeface(size, weight);
    font.setStyleStrategy(QFont::PreferNoShaping);  // for scripts that are readable without shaping
    return font;
}

Sheet::Sheet(QPainter& painter, const QSizeF& page, const NextPage& next, const QString& title,
             const scoring::Proof& proof)
    : m_painter(painter), m_page(page), m_next(next), m_title(title), m_proof(proof)
{
    foot();
}

double Sheet::bottom() const
{
    return m_page.height() - kFootPt;
}

/// Paints the page number, the program, and the code that verifies the paper.
void Sheet::foot()
{
    const QRectF box(0.0, m_page.height() - kFootPt + 6.0, m_page.width(), kFootPt - 6.0);
    m_painter.setPen(QPen(Qt::black, 0.5));
    m_painter.drawLine(box.topLeft(), box.topRight());
    const QRectF lines = box.adjusted(0.0, 3.0, 0.0, 0.0);
    put(lines,
        SheetWords::tr("Cusp %1, printed %2")
            .arg(m_proof.program, QLocale().toString(m_proof.printed.toLocalTime(), QLocale::ShortFormat)),
        kSmallPt, QFont::Normal, Qt::AlignLeft | Qt::AlignTop);
    const QString page =
        m_proof.pages > 0
            //: %1: a report; %2 of %3 pages
            ? SheetWords::tr("%1, page %2 of %3").arg(m_title, QString::number(m_pages), QString::number(m_proof.pages))
            : SheetWords::tr("%1, page %2").arg(m_title, QString::number(m_pages));
    put(lines, page, kSmallPt, QFont::Normal, Qt::AlignRight | Qt::AlignTop);
    const QRectF second = lines.adjusted(0.0, kSmallPt + 3.0, 0.0, 0.0);
    if (m_proof.auditCode.isEmpty()) {
        put(second, SheetWords::tr("Not kept in a school's database: there is no audit code"), kSmallPt, QFont::Medium,
            Qt::AlignLeft | Qt::AlignTop);
        return;
    }
    put(second, SheetWords::tr("Audit code: %1").arg(m_proof.auditCode), kSmallPt, QFont::Medium,
        Qt::AlignLeft | Qt::AlignTop);
}

void Sheet::need(double height)
{
    if (m_top + height <= bottom() || m_top == 0.0)
        return;
    if (m_next)
        m_next();
    ++m_pages;
    m_top = 0.0;
    foot();
}

double Sheet::heightOf(double wide, const QString& words, int size, QFont::Weight weight)
{
    m_painter.setFont(paperFont(size, weight));
    return m_painter.boundingRect(QRectF(0.0, 0.0, wide, 1.0e5), kFoldedWords, words).height();
}

double Sheet::widthOf(const QString& words, int size, QFont::Weight weight)
{
    m_painter.setFont(paperFont(size, weight));
    return m_painter.boundingRect(QRectF(0.0, 0.0, 1.0e5, 1.0e5), Qt::AlignLeft, words).width();
}

double Sheet::put(const QRectF& box, const QString& words, int size, QFont::Weight weight, int flags)
{
    m_painter.setFont(paperFont(size, weight));
    m_painter.setPen(Qt::black);
    QRectF used;
    m_painter.drawText(box, flags, words, &used);
    return used.height();
}

void Sheet::say(const QString& words, int size, QFont::Weight weight)
{
    if (words.isEmpty())
        return;
    const double high = heightOf(width(), words, size, weight);
    need(high);
    put(QRectF(0.0, m_top, width(), high + 1.0), words, size, weight, kFoldedWords);
    m_top += high + 2.0;
}

void Sheet::head(const QString& words, double with)
{
    need(kHeadPt + 3.0 * kGapPt + with);
    if (m_top > 0.0)
        skip(kGapPt);
    say(words, kHeadPt, QFont::DemiBold);
    skip(2.0);
}

void Sheet::rule()
{
    m_painter.setPen(QPen(QColor(0x80, 0x80, 0x80), 0.4));
    m_painter.drawLine(QPointF(0.0, m_top), QPointF(width(), m_top));
    m_top += 3.0;
}

void Sheet::chart(const charts::Chart& one, double height)
{
    chartRow({one}, height);
}

void Sheet::chartRow(const QList<charts::Chart>& row, double height)
{
    need(height + kGapPt);
    skip(kGapPt);
    const double each = (width() - kGapPt * static_cast<double>(row.size() - 1)) / static_cast<double>(row.size());
    for (qsizetype k = 0; k < row.size() && !isCounting(); ++k) {
        m_painter.save();
        m_painter.translate(static_cast<double>(k) * (each + kGapPt), m_top);
        m_painter.scale(kChartScale, kChartScale);
        charts::paint(m_painter, QRectF(0.0, 0.0, each / kChartScale, height / kChartScale), row[k],
                      charts::paperInk());
        m_painter.restore();
    }
    m_top += height;
}

}  // namespace ui::report
