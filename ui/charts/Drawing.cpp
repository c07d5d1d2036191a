// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/Drawing.h"

#include <algorithm>
#include <cmath>

#include <QBuffer>
#include <QCoreApplication>
#include <QFontMetricsF>
#include <QImage>
#include <QLocale>
#include <QPainter>
#include <QPolygonF>
#include <QSvgGenerator>
#include <QTextBoundaryFinder>

#include "ui/kit/Theme.h"
#include "ui/text/Texts.h"

namespace ui::charts {
namespace {

using namespace ui::kit;

constexpr double kMarkPx = 9.0;
constexpr double kBarShare = 0.62;    ///< height of a bar, as a share of the height of its row
constexpr double kNameShare = 0.42;   ///< share of the chart's width for the names of bars
constexpr int kNameLines = 2;         ///< more lines would leave room for too few bars
constexpr double kNameEdgesPx = 4.0;  ///< margins above and below a name together
constexpr double kNameGapPx = 8.0;    ///< gap between a name and the axis
constexpr double kFootPx = 46.0;      ///< height of the axis below horizontal bars
constexpr double kTickPx = 48.0;      ///< height of the chart per tick of its vertical axis
constexpr double kLabelGapPx = 12.0;  ///< between two labels of a horizontal axis
constexpr double kSignPx = 24.0;      ///< width of a sign in the key
constexpr double kGroupGapPx = 6.0;   ///< gap between the columns of a map
constexpr int kNotePx = 10;           ///< size of the text in a map's cells
constexpr int kMostTicks = 6;
constexpr int kFewestRows = 3;
constexpr QSize kPicturePx{960, 600};
constexpr double kPictureDensity = 2.0;
constexpr double kAloneHalf = 0.3;  ///< half-width of a single slice, in attempts

QFontMetricsF metrics()
{
    return QFontMetricsF(typeface(kSmall));
}

double widest(const QStringList& words)
{
    double wide = 0.0;
    for (const QString& one : words)
        wide = std::max(wide, metrics().horizontalAdvance(one));
    return wide;
}

struct Tick
{
    double at;
    QString words;
};

QList<Tick> ticksOf(const Axis& axis, int most)
{
    QList<Tick> ticks;
    for (qsizetype k = 0; k < axis.labels.size(); ++k)
        ticks << Tick{static_cast<double>(k), axis.labels[k]};
    if (!ticks.isEmpty())
        return ticks;
    constexpr double kRounding = 1.0e-9;
    if (axis.base > 0.0) {
        const double first = std::ceil(std::log(axis.low) / std::log(axis.base) - kRounding);
        for (double at = std::pow(axis.base, first); at <= axis.high * (1.0 + kRounding); at *= axis.base)
            ticks << Tick{at, QString::number(at)};
        return ticks;
    }
    const double span = axis.high - axis.low;
    double step = roundEnd(span / most);
    if (axis.isWhole)
        step = std::max(1.0, std::ceil(step));
    const int decimals = step >= 1.0 && step == std::floor(step) ? 0 : step >= 0.1 && step != 0.25 ? 1 : 2;
    const double anchor = axis.isWhole ? std::ceil(axis.low) : 0.0;
    const double first = std::ceil((axis.low - anchor) / step - kRounding);
    for (double k = first; anchor + k * step <= axis.high + kRounding * span; k += 1.0)
        ticks << Tick{anchor + k * step, QLocale().toString(anchor + k * step, 'f', decimals)};
    return ticks;
}

QStringList wordsOf(const QList<Tick>& ticks)
{
    QStringList words;
    for (const Tick& tick : ticks)
        words << tick.words;
    return words;
}

/// Returns as many ticks as have room for their labels.
QList<Tick> ticksAlong(const Axis& axis, double lengthPx)
{
    int most = kMostTicks;
    QList<Tick> ticks = ticksOf(axis, most);
    while (most > 1 && static_cast<double>(ticks.size()) * (widest(wordsOf(ticks)) + kLabelGapPx) > lengthPx)
        ticks = ticksOf(axis, --most);
    return ticks;
}

QList<Tick> ticksUp(const Axis& axis, double heightPx)
{
    return ticksOf(axis, std::clamp(static_cast<int>(heightPx / kTickPx), 2, kMostTicks));
}

void paintMark(QPainter& painter, const QPointF& at, const Line& line, const QColor& colour, const Ink& ink)
{
    const bool isHollow = line.mark == Mark::HollowDiamond;
    const double radius = 0.5 * kMarkPx;
    painter.setPen(QPen(isHollow ? colour : ink.ground, 1.0));
    painter.setBrush(isHollow ? ink.ground : colour);
    if (line.mark == Mark::Circle)
        return painter.drawEllipse(at, radius, radius);
    if (line.mark == Mark::Square)
        return painter.drawRect(QRectF(at.x() - radius, at.y() - radius, kMarkPx, kMarkPx));
    const int corners = line.mark == Mark::Triangle ? 3 : line.mark == Mark::Pentagon ? 5 : 4;
    QPolygonF shape;
    for (int k = 0; k < corners; ++k) {
        const double angle = 2.0 * M_PI * k / corners;
        shape << at + (radius + 1.2) * QPointF(std::sin(angle), -std::cos(angle));
    }
    painter.drawPolygon(shape);
}

QPen penOf(const Limit& limit, const Ink& ink)
{
    return {ink.quiet, 1.4, limit.isUpright ? Qt::DashDotLine : Qt::DotLine};
}

QColor colourOf(const Line& line, const Ink& ink)
{
    const bool isSecond = line.mark == Mark::HollowDiamond || line.mark == Mark::Square;
    return line.colour.isValid() ? line.colour : isSecond ? ink.second : ink.first;
}

QPen penOf(const Line& line, const Ink& ink)
{
    return {colourOf(line, ink), line.widthPx, line.stroke};
}

QPen edgePen(const Ink& ink)
{
    QColor edge = ink.quiet;
    edge.setAlphaF(0.6F);
    return {edge, 0.8};
}

QPen middlePen(const Ink& ink)
{
    return {ink.quiet, 1.8, Qt::DashLine};
}

/// An entry of the key: the name and the sign of a line, mark or area.
struct Entry
{
    QString name;
    QPen pen{Qt::NoPen};              ///< stroke of a line, or of an area's border
    QBrush area{Qt::NoBrush};         ///< fill of a rectangle
    Line marked{{}, {}, Mark::None};  ///< a line with its mark
};

QList<Entry> entriesOf(const Chart& chart, const Ink& ink)
{
    QList<Entry> entries;
    const auto addLimits = [&](const QList<Limit>& limits) {
        for (const Limit& limit : limits)
            entries << Entry{limit.name, penOf(limit, ink)};
    };
    if (const auto* curve = std::get_if<Curve>(&chart.content)) {
        if (!curve->band.slices.isEmpty())
            entries << Entry{curve->band.name, edgePen(ink), ink.band} << Entry{curve->band.middleName, middlePen(ink)};
        addLimits(curve->limits);
        for (const Line& line : curve->lines)
            entries << Entry{line.name, line.isJoined ? penOf(line, ink) : QPen(Qt::NoPen), Qt::NoBrush, line};
    } else if (const auto* histogram = std::get_if<Histogram>(&chart.content)) {
        addLimits(histogram->limits);
    }
    return entries;
}

/// The key below a chart. It has as many rows as it needs.
class Key
{
public:
    Key(const Chart& chart, double widthPx, const Ink& ink) : m_ink(ink), m_rowPx(metrics().height() + kSpace1)
    {
        double left = 0.0;
        for (const Entry& entry : entriesOf(chart, ink)) {
            const auto isSame = [&](const Placed& other) { return other.entry.name == entry.name; };
            if (entry.name.isEmpty() || std::any_of(m_entries.begin(), m_entries.end(), isSame))
                continue;
            const double wide = kSignPx + kSpace1 + metrics().horizontalAdvance(entry.name);
            if (left > 0.0 && left + wide > widthPx) {
                left = 0.0;
                ++m_rows;
            }
            m_entries << Placed{entry, QRectF(left, m_rows * m_rowPx, wide + kSpace4, m_rowPx)};
            left += wide + kSpace4;
        }
    }

    [[nodiscard]] double height() const { return m_entries.isEmpty() ? 0.0 : (m_rows + 1) * m_rowPx + kSpace1; }

    void paint(QPainter& painter, const QPointF& corner) const
    {
        for (const Placed& placed : m_entries) {
            const QRectF box = placed.box.translated(corner);
            const QRectF sign(box.topLeft(), QSizeF(kSignPx, m_rowPx));
            const Entry& entry = placed.entry;
            painter.setPen(entry.pen);
            painter.setBrush(entry.area);
            if (entry.area.style() != Qt::NoBrush)
                painter.drawRect(sign.adjusted(0.0, 3.0, 0.0, -3.0));
            else if (entry.pen.style() != Qt::NoPen)
                painter.drawLine(QPointF(sign.left(), sign.center().y()), QPointF(sign.right(), sign.center().y()));
            if (entry.marked.mark != Mark::None && entry.marked.mark != Mark::Plain)
                paintMark(painter, sign.center(), entry.marked, colourOf(entry.marked, m_ink), m_ink);
            painter.setFont(typeface(kSmall));
            painter.setPen(m_ink.words);
            painter.drawText(box.adjusted(kSignPx + kSpace1, 0.0, 0.0, 0.0), Qt::AlignLeft | Qt::AlignVCenter,
                             entry.name);
        }
    }

private:
    struct Placed
    {
        Entry entry;
        QRectF box;
    };

    Ink m_ink;
    QList<Placed> m_entries;
    double m_rowPx;
    int m_rows = 0;  ///< after the first row
};

/// Wraps a name into the lines that a bar has room for. Elides it in the middle, because names often begin alike.
QString folded(const QString& name, double widthPx, int most)
{
    QStringList lines{QString()};
    QTextBoundaryFinder places(QTextBoundaryFinder::Line, name);
    for (auto from = places.position(); places.toNextBoundary() > 0; from = places.position()) {
        const QString longer = lines.back() + name.mid(from, places.position() - from);
        if (lines.back().isEmpty() || lines.size() == most || metrics().horizontalAdvance(longer.trimmed()) <= widthPx)
            lines.back() = longer;
        else
            lines << name.mid(from, places.position() - from);
    }
    for (QString& line : lines)
        line = metrics().elidedText(line.trimmed(), Qt::ElideMiddle, widthPx);
    return lines.join(u'\n');
}

/// Returns the width to the left of the plot: labels and title of the vertical axis, or names of bars.
double leftOf(const Chart& chart, const Axis& y, const QSizeF& roomPx)
{
    if (const auto* bars = std::get_if<Bars>(&chart.content)) {
        QStringList lines;
        for (const QString& name : namesOf(*bars, roomPx))
            lines << name.split(u'\n');
        return widest(lines) + kNameGapPx;
    }
    if (const auto* map = std::get_if<Map>(&chart.content))
        return widest(map->rows + QStringList(map->columnTitle)) + kNameGapPx;
    return metrics().height() + kSpace1 + widest(wordsOf(ticksUp(y, roomPx.height()))) + kSpace1;
}

void drawGrid(QPainter& painter, const Plot& plot, const Axis& axis, const QList<Tick>& ticks, bool isLying,
              const Ink& ink)
{
    const auto across = [&](double value) {
        const QPointF at = plot.at(isLying ? value : plot.x.low, isLying ? plot.y.low : value);
        if (isLying)
            painter.drawLine(QPointF(at.x(), plot.px.top()), QPointF(at.x(), plot.px.bottom()));
        else
            painter.drawLine(QPointF(plot.px.left(), at.y()), QPointF(plot.px.right(), at.y()));
    };
    QColor faint = ink.grid;
    faint.setAlphaF(0.5F);
    painter.setPen(QPen(faint, 0.5));
    if (axis.base == 10.0)
        for (double decade = std::pow(10.0, std::floor(std::log10(axis.low))); decade < axis.high; decade *= 10.0)
            for (int k = 2; k < 10; ++k)
                if (k * decade >= axis.low && k * decade <= axis.high)
                    across(k * decade);
    painter.setPen(QPen(ink.grid, 1.0));
    for (const Tick& tick : ticks)
        across(tick.at);
}

void drawAxes(QPainter& painter, const Plot& plot, const Chart& chart, double roomPx, const Ink& ink)
{
    const bool isBars = std::holds_alternative<Bars>(chart.content);
    const QList<Tick> lying = ticksAlong(plot.x, plot.px.width());
    const QList<Tick> upright = isBars ? QList<Tick>() : ticksUp(plot.y, roomPx);
    if (!std::holds_alternative<Histogram>(chart.content))
        drawGrid(painter, plot, plot.x, lying, true, ink);
    drawGrid(painter, plot, plot.y, upright, false, ink);
    painter.setPen(QPen(ink.grid, 1.0));
    painter.drawLine(plot.px.bottomLeft(), plot.px.bottomRight());
    painter.drawLine(plot.px.topLeft(), plot.px.bottomLeft());
    painter.setFont(typeface(kSmall));
    painter.setPen(ink.quiet);
    const double high = metrics().height();
    for (const Tick& tick : lying) {
        const double x = plot.at(tick.at, plot.y.low).x();
        painter.drawText(QRectF(x - 200.0, plot.px.bottom() + kSpace1, 400.0, high), Qt::AlignHCenter, tick.words);
    }
    for (const Tick& tick : upright) {
        const double y = plot.at(plot.x.low, tick.at).y();
        painter.drawText(QRectF(plot.px.left() - 200.0 - kSpace1, y - 0.5 * high, 200.0, high),
                         Qt::AlignRight | Qt::AlignVCenter, tick.words);
    }
    painter.drawText(QRectF(plot.px.left(), plot.px.bottom() + high + 2.0 * kSpace1, plot.px.width(), high),
                     Qt::AlignHCenter, plot.x.title);
    if (plot.y.title.isEmpty())
        return;
    painter.save();
    painter.translate(plot.px.left() - widest(wordsOf(upright)) - 2.0 * kSpace1 - high, plot.px.center().y());
    painter.rotate(-90.0);
    painter.drawText(QRectF(-0.5 * plot.px.height(), 0.0, plot.px.height(), high), Qt::AlignCenter, plot.y.title);
    painter.restore();
}

void drawLimits(QPainter& painter, const Plot& plot, const QList<Limit>& limits, const Ink& ink)
{
    for (const Limit& limit : limits) {
        painter.setPen(penOf(limit, ink));
        const QPointF at = plot.at(limit.isUpright ? limit.at : plot.x.low, limit.isUpright ? plot.y.low : limit.at);
        if (limit.isUpright)
            painter.drawLine(QPointF(at.x(), plot.px.top()), at);
        else
            painter.drawLine(at, QPointF(plot.px.right(), at.y()));
    }
}

void drawBand(QPainter& painter, const Plot& plot, QList<Slice> slices, const Ink& ink)
{
    if (slices.isEmpty())
        return;
    if (slices.size() == 1) {  // a single slice has no width, so it is widened
        slices << slices.front();
        slices.front().x -= kAloneHalf;
        slices.back().x += kAloneHalf;
    }
    QPolygonF half, middle;
    for (const Slice& slice : slices) {
        half.prepend(plot.at(slice.x, slice.low));
        half.append(plot.at(slice.x, slice.high));
        middle << plot.at(slice.x, slice.middle);
    }
    painter.setPen(edgePen(ink));
    painter.setBrush(ink.band);
    painter.drawPolygon(half);
    painter.setPen(middlePen(ink));
    painter.drawPolyline(middle);
}

/// Draws the note of each dot beside it, where it covers the least of other notes and lines.
void drawNotes(QPainter& painter, const Plot& plot, const Curve& curve, const Ink& ink)
{
    constexpr double kLineStepPx = 5.0;
    constexpr double kFarCost = 20.0;  // px2 of overlap that weigh as much as half a mark of distance
    const auto around = [](const QPointF& middle, double wide, double high) {
        return QRectF(middle.x() - 0.5 * wide, middle.y() - 0.5 * high, wide, high);
    };
    const auto common = [](const QRectF& a, const QRectF& b) {
        const QRectF both = a.intersected(b);
        return both.width() * both.height();
    };
    QList<QRectF> taken;
    for (const Limit& limit : curve.limits)
        taken << (limit.isUpright
                      ? QRectF(plot.at(limit.at, plot.y.low).x() - 1.0, plot.px.top(), 2.0, plot.px.height())
                      : QRectF(plot.px.left(), plot.at(plot.x.low, limit.at).y() - 1.0, plot.px.width(), 2.0));
    for (const Line& line : curve.lines)
        for (qsizetype k = 0; k < line.dots.size(); ++k) {
            const QPointF here = plot.at(line.dots[k].x, line.dots[k].y);
            taken << around(here, kMarkPx, kMarkPx);
            const Dot& before = line.dots[std::max(k - 1, qsizetype{0})];
            const QLineF way(here, plot.at(before.x, before.y));
            for (double along = 0.0; along < way.length(); along += kLineStepPx)
                taken << around(way.pointAt(along / way.length()), kLineStepPx, kLineStepPx);
        }
    painter.setFont(typeface(kSmall));
    for (const Line& line : curve.lines)
        for (const Dot& dot : line.dots) {
            if (dot.note.isEmpty())
                continue;
            const double wide = metrics().horizontalAdvance(dot.note);
            const double high = metrics().ascent();
            QRectF best;
            double least = std::numeric_limits<double>::max();
            for (const double far : {0.7, 1.2, 2.0})
                for (const QPoint& to : {QPoint(1, 0), {1, -1}, {1, 1}, {-1, 0}, {-1, -1}, {-1, 1}, {0, -1}, {0, 1}}) {
                    const QRectF box = around(plot.at(dot.x, dot.y) + QPointF(to.x() * (far * kMarkPx + 0.5 * wide),
                                                                              to.y() * (far * kMarkPx + 0.4 * high)),
                                              wide, high);
                    double cost = kFarCost * far + wide * high - common(box, plot.px);
                    for (const QRectF& other : taken)
                        cost += common(box, other);
                    if (cost < least) {
                        least = cost;
                        best = box;
                    }
                }
            taken << best;
            painter.setPen(colourOf(line, ink).darker(150));
            painter.drawText(best.adjusted(-20.0, -4.0, 20.0, 4.0), Qt::AlignCenter, dot.note);
        }
}

void drawContent(QPainter& painter, const Plot& plot, const Curve& curve, const QSizeF&, const Ink& ink)
{
    drawBand(painter, plot, curve.band.slices, ink);
    drawLimits(painter, plot, curve.limits, ink);
    for (const Line& line : curve.lines) {
        QPolygonF points;
        for (const Dot& dot : line.dots)
            points << plot.at(dot.x, dot.y);
        if (line.isJoined) {
            painter.setPen(penOf(line, ink));
            painter.drawPolyline(points);
        }
        if (line.mark != Mark::None && line.mark != Mark::Plain)
            for (const QPointF& point : points)
                paintMark(painter, point, line, colourOf(line, ink), ink);
    }
    drawNotes(painter, plot, curve, ink);
}

/// Draws bars. Their names replace the labels of the axis.
void drawContent(QPainter& painter, const Plot& plot, const Bars& bars, const QSizeF& roomPx, const Ink& ink)
{
    const QStringList names = namesOf(bars, roomPx);
    const double rowPx = plot.px.height() / static_cast<double>(names.size());
    for (qsizetype k = 0; k < names.size(); ++k) {
        const double y = -static_cast<double>(k);
        painter.fillRect(
            QRectF(plot.at(plot.x.low, y + 0.5 * kBarShare), plot.at(bars.bars[k].value, y - 0.5 * kBarShare)),
            ink.first);
        const QRectF row(0.0, plot.px.top() + static_cast<double>(k) * rowPx, plot.px.left() - kNameGapPx, rowPx);
        painter.setFont(typeface(kSmall));
        painter.setPen(ink.words);
        painter.drawText(row, Qt::AlignRight | Qt::AlignVCenter | Qt::TextDontClip, names[k]);
    }
}

void drawContent(QPainter& painter, const Plot& plot, const Histogram& histogram, const QSizeF&, const Ink& ink)
{
    for (const Histogram::Bin& bin : histogram.bins) {
        const double gap = 0.04 * (bin.to - bin.from);
        painter.fillRect(QRectF(plot.at(bin.from + gap, bin.count), plot.at(bin.to - gap, 0.0)), ink.first);
    }
    drawLimits(painter, plot, histogram.limits, ink);
}

void drawContent(QPainter& painter, const Plot& plot, const Map& map, const QSizeF&, const Ink& ink)
{
    const auto columns = map.columns.size();
    const double gapsPx = kGroupGapPx * static_cast<double>(map.groups.size() - 1);
    const double wide = (plot.px.width() - gapsPx) / plot.x.high;
    const double high = plot.px.height() / -plot.y.low;
    const auto cellAt = [&](qsizetype row, qsizetype k) {
        const qsizetype group = k / columns;
        return QRectF(plot.px.left() + static_cast<double>(k) * wide + kGroupGapPx * static_cast<double>(group),
                      plot.px.top() + static_cast<double>(row) * high, wide, high);
    };
    const auto write = [&](const QRectF& box, int flags, const QString& words, const QColor& colour,
                           QFont::Weight weight = QFont::Normal, int size = kSmall) {
        painter.setFont(typeface(size, weight));
        painter.setPen(colour);
        painter.drawText(box, flags | Qt::AlignVCenter | Qt::TextDontClip, words);
    };
    const double line = metrics().height() + kSpace1;
    const double besidePx = plot.px.left() - kNameGapPx;
    write({0.0, plot.px.top() - line, besidePx, line}, Qt::AlignRight, map.columnTitle, ink.quiet);
    for (qsizetype k = 0; k < map.groups.size() * columns; ++k) {
        const QRectF head = cellAt(0, k).adjusted(0.0, -line, 0.0, -high);
        write(head, Qt::AlignHCenter, map.columns[k % columns], ink.quiet);
        if (k % columns == 0)
            write(head.adjusted(0.0, -line, static_cast<double>(columns - 1) * wide, -line), Qt::AlignHCenter,
                  map.groups[k / columns], ink.words, QFont::DemiBold);
    }
    for (qsizetype row = 0; row < map.rows.size(); ++row) {
        write({0.0, cellAt(row, 0).top(), besidePx, high}, Qt::AlignRight, map.rows[row], ink.words);
        for (qsizetype k = 0; k < map.cells[row].size(); ++k) {
            const Map::Cell& cell = map.cells[row][k];
            const QRectF box = cellAt(row, k).adjusted(1.0, 1.0, -1.0, -1.0);
            painter.fillRect(box, cell.colour);
            const bool isPale = contrast(Qt::black, cell.colour) > contrast(Qt::white, cell.colour);
            const QColor colour = isPale ? Qt::black : Qt::white;
            const bool isBoth = !cell.note.isEmpty() && !cell.letter.isEmpty();
            const QRectF within = isBoth ? box.adjusted(1.5, 0.0, -1.5, 0.0) : box;
            const int size = isBoth ? kNotePx : kSmall;
            write(within, isBoth ? Qt::AlignLeft : Qt::AlignHCenter, cell.letter, colour, QFont::Bold, size);
            write(within, isBoth ? Qt::AlignRight : Qt::AlignHCenter, cell.note, colour, QFont::Normal, size);
        }
    }
}

/// Paints text in a column and returns its height in pixels.
double paintWords(QPainter& painter, const QRectF& area, const QString& words, const QFont& font, const QColor& colour)
{
    if (words.isEmpty())
        return 0.0;
    painter.setFont(font);
    painter.setPen(colour);
    QRectF used;
    painter.drawText(area, Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, words, &used);
    return used.height() + 2.0;
}

void paintPicture(QPainter& painter, const Chart& chart)
{
    const Ink ink = inkOf(pagePalette(false));
    const QRectF sheet(QPointF(0.0, 0.0), kPicturePx);
    painter.fillRect(sheet, Qt::white);
    Chart alone = chart;
    if (!chart.of.isEmpty()) {
        alone.title += QStringLiteral(" · ") + chart.of;
        alone.note += (chart.note.isEmpty() ? QString() : QStringLiteral(" · ")) +
                      QLocale().toString(QDate::currentDate(), QLocale::ShortFormat);
    }
    paint(painter, sheet.adjusted(kSpace6, kSpace4, -kSpace6, -kSpace4), alone, ink);
}

}  // namespace

Ink inkOf(const QPalette& palette)
{
    const Tones tone = tones(palette);
    QColor band = tone.accent;
    band.setAlphaF(isDark(palette) ? 0.26F : 0.18F);
    return {palette.color(QPalette::WindowText),
            palette.color(QPalette::PlaceholderText),
            palette.color(QPalette::Mid),
            palette.color(QPalette::Base),
            tone.accent,
            tone.attention,
            band};
}

Ink paperInk()
{
    return {Qt::black,
            QColor(0x40, 0x40, 0x40),
            QColor(0xC8, 0xC8, 0xC8),
            Qt::white,
            QColor(0x1A, 0x1A, 0x1A),
            QColor(0x60, 0x60, 0x60),
            QColor(0xE2, 0xE2, 0xE2)};
}

int rowsFor(const Chart& chart, const QSizeF& roomPx)
{
    const auto* const bars = std::get_if<Bars>(&chart.content);
    if (bars == nullptr)
        return kFewestRows;
    const bool isLong = std::any_of(bars->bars.begin(), bars->bars.end(), [&](const Bars::Bar& bar) {
        return metrics().horizontalAdvance(bar.name) > kNameShare * roomPx.width();
    });
    const auto rows = [&](int lines) {
        const double rowPx = lines * metrics().lineSpacing() + kNameEdgesPx;
        return std::max(kFewestRows, static_cast<int>((roomPx.height() - kFootPx) / rowPx));
    };
    // Shortens names if all bars fit then.
    const int loose = rows(isLong ? kNameLines : 1);
    return bars->bars.size() > loose && bars->bars.size() <= rows(1) ? rows(1) : loose;
}

QStringList namesOf(const Bars& bars, const QSizeF& roomPx)
{
    const double rowPx = (roomPx.height() - kFootPx) / static_cast<double>(std::max(qsizetype{1}, bars.bars.size()));
    const int lines = std::clamp(static_cast<int>((rowPx - kNameEdgesPx) / metrics().lineSpacing()), 1, kNameLines);
    QStringList names;
    for (const Bars::Bar& bar : bars.bars)
        names << folded(bar.name, kNameShare * roomPx.width(), lines);
    return names;
}

QPointF Plot::at(double xValue, double yValue) const
{
    return {px.left() + px.width() * x.shareOf(xValue), px.bottom() - px.height() * y.shareOf(yValue)};
}

double Plot::xAt(double atPx) const
{
    return x.valueAt((atPx - px.left()) / px.width());
}

Plot plotOf(const Chart& chart, const QRectF& area)
{
    const auto [x, y] = axesOf(chart);
    const double line = metrics().height() + kSpace1;
    const double key = Key(chart, area.width(), paperInk()).height();
    if (std::holds_alternative<Map>(chart.content))
        return {area.adjusted(leftOf(chart, y, area.size()), 2.0 * line, 0.0, -key - kSpace2), x, y};
    QRectF px = area.adjusted(leftOf(chart, y, area.size()), 0.5 * line, 0.0, -2.0 * line - kSpace1 - key);
    // Half of the last label extends beyond the end of its axis.
    const QList<Tick> ticks = ticksAlong(x, px.width());
    if (!ticks.isEmpty())
        px.adjust(0.0, 0.0, -0.5 * metrics().horizontalAdvance(ticks.back().words) * x.shareOf(ticks.back().at), 0.0);
    return {px, x, y};
}

void draw(QPainter& painter, const QRectF& area, const Chart& chart, const Ink& ink)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(area.topLeft());
    const QRectF room(QPointF(0.0, 0.0), area.size());
    const Plot plot = plotOf(chart, room);
    if (!std::holds_alternative<Map>(chart.content))
        drawAxes(painter, plot, chart, room.height(), ink);
    std::visit([&](const auto& content) { drawContent(painter, plot, content, room.size(), ink); }, chart.content);
    const Key key(chart, room.width(), ink);
    key.paint(painter, QPointF(0.0, room.bottom() - key.height()));
    painter.restore();
}

void paint(QPainter& painter, const QRectF& area, const Chart& chart, const Ink& ink)
{
    painter.save();
    double top = area.top();
    top += paintWords(painter, QRectF(area.left(), top, area.width(), area.height()), chart.title,
                      typeface(kBody, QFont::DemiBold), ink.words);
    top += paintWords(painter, QRectF(area.left(), top, area.width(), area.height()), chart.note, typeface(kSmall),
                      ink.quiet);
    const QRectF rest(area.left(), top, area.width(), area.bottom() - top);
    if (stopsOf(chart).isEmpty())
        paintWords(painter, rest, chart.emptyWords, typeface(kBody), ink.quiet);
    else
        draw(painter, rest, chart, ink);
    painter.restore();
}

QByteArray png(const Chart& chart)
{
    if (stopsOf(chart).isEmpty())
        return {};
    QImage image(kPicturePx * kPictureDensity, QImage::Format_RGB32);
    image.setDevicePixelRatio(kPictureDensity);
    QPainter painter(&image);
    paintPicture(painter, chart);
    painter.end();
    QByteArray bytes;
    QBuffer buffer(&bytes);
    image.save(&buffer, "PNG");
    return bytes;
}

QByteArray svg(const Chart& chart)
{
    if (stopsOf(chart).isEmpty())
        return {};
    QByteArray bytes;
    QBuffer buffer(&bytes);
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setSize(kPicturePx);
    generator.setViewBox(QRect(QPoint(0, 0), kPicturePx));
    generator.setTitle(chart.title);
    QPainter painter(&generator);
    paintPicture(painter, chart);
    painter.end();
    // The reader's computer may not have the font Inter.
    return bytes.replace("font-family=\"Inter\"", "font-family=\"Inter, DejaVu Sans, Arial, sans-serif\"");
}

}  // namespace ui::charts
