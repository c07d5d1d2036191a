// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/Drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include <QAreaSeries>
#include <QBuffer>
#include <QChart>
#include <QCoreApplication>
#include <QDateTime>
#include <QDateTimeAxis>
#include <QFontMetricsF>
#include <QGraphicsLayout>
#include <QGraphicsScene>
#include <QGraphicsSimpleTextItem>
#include <QImage>
#include <QLegendMarker>
#include <QLineSeries>
#include <QLocale>
#include <QPainter>
#include <QScatterSeries>
#include <QSvgGenerator>
#include <QTextLayout>
#include <QTextOption>
#include <QValueAxis>

#include "ui/shell/Theme.h"
#include "ui/text/Texts.h"

namespace ui::charts {
namespace {

using namespace ui::shell;

constexpr double kEdgeShare = 0.05;
constexpr double kLinePx = 2.0;
constexpr double kMarkPx = 9.0;
constexpr double kBarShare = 0.62;    ///< of the height of its row
constexpr double kNameShare = 0.42;   ///< of the width of the chart, for the names of bars
constexpr int kNameLines = 2;         ///< and no more, or too few bars have room
constexpr double kNameEdgesPx = 4.0;  ///< above and below together
constexpr double kNameGapPx = 8.0;    ///< to the axis
constexpr double kFootPx = 46.0;      ///< of the axis beneath bars
constexpr double kUprightPx = 64.0;   ///< of an upright axis with its labels and title
constexpr double kLabelGapPx = 12.0;  ///< between two labels of an axis: or else Qt cuts them
constexpr int kFewestRows = 3;
constexpr QSize kPicturePx{960, 600};
constexpr double kPictureDensity = 2.0;
constexpr std::array kStrokes{Qt::SolidLine, Qt::DashLine, Qt::DashDotLine};
constexpr qint64 kDayMs = 86'400'000;
constexpr double kAloneHalf = 0.3;  ///< of an attempt

/// Whoever draws: the chart that is filled, its axes, and the colours.
struct Board
{
    QChart& chart;
    const Ink& ink;
    QSizeF roomPx;
    QMargins edges;  ///< of the chart, for what is beside its axes
    QAbstractAxis* x = nullptr;
    QAbstractAxis* y = nullptr;

    template <typename Series>
    Series* add(Series* series, const QString& legend)
    {
        series->setName(legend);
        chart.addSeries(series);
        series->attachAxis(x);
        series->attachAxis(y);
        return series;
    }
    QLineSeries* line(const QList<QPointF>& points, const QPen& pen, const QString& legend)
    {
        auto* made = new QLineSeries;
        made->append(points);
        made->setPen(pen);
        return add(made, legend);
    }
    /// What lies between two lines with the same x.
    QAreaSeries* area(const QList<QPointF>& upper, const QList<QPointF>& lower, const QBrush& brush, const QPen& pen,
                      const QString& legend)
    {
        auto* top = new QLineSeries;
        auto* foot = new QLineSeries;
        top->append(upper);
        foot->append(lower);
        auto* made = new QAreaSeries(top, foot);
        top->setParent(made);
        foot->setParent(made);
        made->setBrush(brush);
        made->setPen(pen);
        return add(made, legend);
    }
};

void dressAxis(QAbstractAxis& axis, const QString& title, const Ink& ink)
{
    axis.setTitleText(title);
    axis.setLabelsFont(typeface(kSmall));
    axis.setTitleFont(typeface(kSmall));
    axis.setLabelsColor(ink.quiet);
    axis.setTitleBrush(ink.quiet);
    axis.setLinePenColor(ink.grid);
    axis.setGridLineColor(ink.grid);
}

QAbstractAxis* axisOf(const Axis& axis, const Ink& ink, int ticks = kMostTicks)
{
    if (axis.isTime) {
        auto* time = new QDateTimeAxis;
        time->setRange(QDateTime::fromMSecsSinceEpoch(static_cast<qint64>(axis.low)),
                       QDateTime::fromMSecsSinceEpoch(static_cast<qint64>(axis.high)));
        const double days = (axis.high - axis.low) / static_cast<double>(kDayMs);
        time->setFormat(days < 2.0 ? QLocale().timeFormat(QLocale::ShortFormat)
                        //: A day without its year, as QLocale::toString() takes it: "27 Nov". Japanese "M月d日"
                        : days < 330.0 ? text::dayFormat(QCoreApplication::translate("Chart", "d MMM"))
                                       //: A month, as QLocale::toString() takes it: "Nov 2024"
                                       : QCoreApplication::translate("Chart", "MMM yyyy"));
        time->setTickCount(5);
        dressAxis(*time, axis.title, ink);
        return time;
    }
    auto* made = new QValueAxis;
    made->setRange(axis.low, axis.high);
    const double span = axis.high - axis.low;
    double step = roundEnd(span / ticks);
    if (axis.isWhole)
        step = std::max(1.0, std::ceil(step));
    made->setTickType(QValueAxis::TicksDynamic);
    made->setTickAnchor(axis.isWhole ? std::ceil(axis.low) : 0.0);
    made->setTickInterval(step);
    made->setLabelFormat(step >= 1.0 && step == std::floor(step) ? QStringLiteral("%.0f")
                         : step >= 0.1 && step != 0.25           ? QStringLiteral("%.1f")
                                                                 : QStringLiteral("%.2f"));
    dressAxis(*made, axis.title, ink);
    return made;
}

/// So many of a lying axis have room for their labels.
int ticksAcross(const Axis& axis, double plotPx)
{
    const QFontMetricsF metrics(typeface(kSmall));
    double widest = 0.0;
    for (const double end : {axis.low, axis.high})
        widest = std::max(widest, metrics.horizontalAdvance(QLocale().toString(end, 'f', 0)));
    return std::clamp(static_cast<int>(plotPx / (widest + kLabelGapPx)) - 1, 1, kMostTicks);
}

void addLimits(Board& board, const QList<Limit>& limits, const Frame& frame)
{
    for (const Limit& limit : limits) {
        const QPen pen(board.ink.quiet, 1.4, limit.isUpright ? Qt::DashDotLine : Qt::DotLine);
        if (limit.isUpright)
            board.line({{limit.at, frame.yLow}, {limit.at, frame.yHigh}}, pen, limit.name);
        else
            board.line({{frame.xLow, limit.at}, {frame.xHigh, limit.at}}, pen, limit.name);
    }
}

void addMarks(Board& board, const Line& line, const QColor& colour, const QString& legend)
{
    auto* marks = new QScatterSeries;
    for (const Dot& dot : line.dots)
        marks->append(dot.x, dot.y);
    const bool isHollow = line.mark == Mark::HollowDiamond;
    marks->setMarkerShape(isHollow                    ? QScatterSeries::MarkerShapeRotatedRectangle
                          : line.mark == Mark::Square ? QScatterSeries::MarkerShapeRectangle
                                                      : QScatterSeries::MarkerShapeCircle);
    marks->setMarkerSize(isHollow ? kMarkPx + 2.0 : kMarkPx);
    marks->setColor(isHollow ? board.ink.ground : colour);
    marks->setBorderColor(isHollow ? colour : board.ink.ground);
    board.add(marks, legend);
}

void draw(const Curve& curve, Board& board)
{
    const Frame frame{curve.x.low, curve.x.high, curve.y.low, curve.y.high};
    if (!curve.band.slices.isEmpty()) {
        QList<QPointF> low, middle, high;
        QList<Slice> slices = curve.band.slices;
        if (slices.size() == 1) {  // a place alone has no width to be seen by
            slices << slices.front();
            slices.front().x -= kAloneHalf;
            slices.back().x += kAloneHalf;
        }
        for (const Slice& slice : slices) {
            low << QPointF(slice.x, slice.low);
            middle << QPointF(slice.x, slice.middle);
            high << QPointF(slice.x, slice.high);
        }
        QColor edge = board.ink.quiet;
        edge.setAlphaF(0.6F);
        QAreaSeries* half = board.area(high, low, board.ink.band, QPen(edge, 0.8), curve.band.name);
        for (QLegendMarker* marker : board.chart.legend()->markers(half)) {
            marker->setPen(QPen(edge, 0.8));
            marker->setBrush(board.ink.band);
        }
        board.line(middle, QPen(board.ink.quiet, 1.8, Qt::DashLine), curve.band.middleName);
    }
    addLimits(board, curve.limits, frame);
    qsizetype strokes = 0;
    for (const Line& line : curve.lines) {
        const bool isPlain = line.mark == Mark::None || line.mark == Mark::Plain;
        const bool isFirst = line.mark == Mark::Circle || isPlain;
        const QColor colour = line.colour.isValid() ? line.colour : isFirst ? board.ink.first : board.ink.second;
        if (line.isJoined && line.dots.size() > 1) {
            QList<QPointF> points;
            for (const Dot& dot : line.dots)
                points << QPointF(dot.x, dot.y);
            const Qt::PenStyle stroke = kStrokes.at(static_cast<std::size_t>(strokes) % kStrokes.size());
            board.line(points, QPen(colour, kLinePx, stroke), isPlain ? line.name : QString());
        }
        // One of many of the same name is drawn as the others are.
        const bool isLastOfName = line.name.isEmpty() || &line == &curve.lines.back() || (&line)[1].name != line.name;
        if (line.isJoined && isLastOfName)
            ++strokes;
        if (!isPlain)
            addMarks(board, line, colour, line.name);
    }
}

void draw(const Bars& bars, Board& board)
{
    for (qsizetype k = 0; k < bars.bars.size(); ++k) {
        const double y = -static_cast<double>(k);
        const double value = bars.bars[k].value;
        board.area({{0.0, y + 0.5 * kBarShare}, {value, y + 0.5 * kBarShare}},
                   {{0.0, y - 0.5 * kBarShare}, {value, y - 0.5 * kBarShare}}, board.ink.first, Qt::NoPen, {});
    }
}

void draw(const Histogram& histogram, Board& board)
{
    for (const Histogram::Bin& bin : histogram.bins) {
        const double gap = 0.04 * (bin.to - bin.from);
        const double count = bin.count;
        board.area({{bin.from + gap, count}, {bin.to - gap, count}}, {{bin.from + gap, 0.0}, {bin.to - gap, 0.0}},
                   board.ink.first, Qt::NoPen, {});
    }
    addLimits(board, histogram.limits, {histogram.x.low, histogram.x.high, histogram.count.low, histogram.count.high});
}

void makeAxes(const Curve& curve, Board& board)
{
    board.x = axisOf(curve.x, board.ink, ticksAcross(curve.x, board.roomPx.width() - kUprightPx));
    QAbstractAxis* y = axisOf(curve.y, board.ink, ticksFor(board.roomPx.height()));
    // A mark on the edge, as of a score of 0, is seen whole.
    const double spare = kEdgeShare * (curve.y.high - curve.y.low);
    const auto hasMark = [&](double at) {
        return std::any_of(curve.lines.begin(), curve.lines.end(), [&](const Line& line) {
            return line.mark != Mark::None && std::any_of(line.dots.begin(), line.dots.end(),
                                                          [&](const Dot& dot) { return std::abs(dot.y - at) < spare; });
        });
    };
    y->setRange(curve.y.low - (hasMark(curve.y.low) ? spare : 0.0),
                curve.y.high + (hasMark(curve.y.high) ? spare : 0.0));
    board.y = y;
}

void makeAxes(const Histogram& histogram, Board& board)
{
    board.x = axisOf(histogram.x, board.ink, ticksAcross(histogram.x, board.roomPx.width() - kUprightPx));
    board.y = axisOf(histogram.count, board.ink, ticksFor(board.roomPx.height()));
    board.x->setGridLineVisible(false);
}

/// Words in lines that are not wider, broken between words where that is possible.
QStringList wrapped(const QString& words, double widthPx)
{
    QTextLayout layout(words, typeface(kSmall));
    QTextOption option;
    option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    layout.setTextOption(option);
    QStringList lines;
    layout.beginLayout();
    for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
        line.setLineWidth(widthPx);
        lines << words.mid(line.textStart(), line.textLength()).trimmed();
    }
    layout.endLayout();
    return lines;
}

/// What is left out is left out in the middle, for names often begin alike; whole words where two of them have room.
QString shortened(const QString& words, double widthPx)
{
    const QFontMetricsF metrics(typeface(kSmall));
    const QString gap = QStringLiteral(" … ");
    const QStringList all = words.split(u' ', Qt::SkipEmptyParts);
    qsizetype first = 0;
    qsizetype last = 0;
    QString made;
    const auto fits = [&](qsizetype ahead, qsizetype behind) {
        const QString tried = all.mid(0, ahead).join(u' ') + gap + all.mid(all.size() - behind).join(u' ');
        if (ahead + behind >= all.size() || metrics.horizontalAdvance(tried) > widthPx)
            return false;
        made = tried;
        return true;
    };
    if (all.size() > 2 && fits(1, 1))
        first = last = 1;
    while (first > 0 && fits(first, last + 1))
        ++last;
    while (first > 0 && fits(first + 1, last))
        ++first;
    return made.isEmpty() ? metrics.elidedText(words, Qt::ElideMiddle, widthPx) : made;
}

/// In as many lines as a bar has room for, about as long as each other.
QString folded(const QString& name, double widthPx, int most)
{
    constexpr double kStepPx = 6.0;
    QStringList lines = wrapped(name, widthPx);
    if (lines.size() > most) {
        const QString rest = lines.mid(most - 1).join(u' ');
        lines = lines.mid(0, most - 1) << shortened(rest, widthPx);
    } else if (lines.size() > 1) {
        for (double narrow = widthPx - kStepPx; narrow > 0.0; narrow -= kStepPx) {
            const QStringList closer = wrapped(name, narrow);
            if (closer.size() != lines.size() || closer.join(u' ') != name)  // a word would be broken
                break;
            lines = closer;
        }
    }
    return lines.join(u'\n');
}

/// The names of bars stand where their axis has no labels: those of Qt are cut, and at the front, wherever they are
/// wider than it thinks.
void addNames(const Bars& bars, Board& board)
{
    const double rowPx =
        (board.roomPx.height() - kFootPx) / static_cast<double>(std::max(qsizetype{1}, bars.bars.size()));
    const double linePx = QFontMetricsF(typeface(kSmall)).lineSpacing();
    const int lines = std::clamp(static_cast<int>((rowPx - kNameEdgesPx) / linePx), 1, kNameLines);
    QList<QGraphicsSimpleTextItem*> names;
    double widest = 0.0;
    for (const Bars::Bar& bar : bars.bars) {
        const QString words = folded(bar.name, kNameShare * board.roomPx.width(), lines);
        auto* name = new QGraphicsSimpleTextItem(words, &board.chart);
        name->setFont(typeface(kSmall));
        name->setBrush(board.ink.words);
        widest = std::max(widest, name->boundingRect().width());
        names << name;
    }
    board.edges.setLeft(static_cast<int>(std::ceil(widest)));
    QObject::connect(&board.chart, &QChart::plotAreaChanged, &board.chart, [names](const QRectF& plot) {
        const double eachPx = plot.height() / static_cast<double>(names.size());
        double middle = plot.top() + 0.5 * eachPx;
        for (QGraphicsSimpleTextItem* name : names) {
            const QRectF box = name->boundingRect();
            name->setPos(plot.left() - kNameGapPx - box.width(), middle - 0.5 * box.height());
            middle += eachPx;
        }
    });
}

void makeAxes(const Bars& bars, Board& board)
{
    const Frame frame = frameOf({{}, {}, {}, bars});
    addNames(bars, board);
    const double plotPx = board.roomPx.width() - board.edges.left() - 2.0 * kNameGapPx;
    board.x = axisOf(bars.value, board.ink, ticksAcross(bars.value, plotPx));
    board.y = axisOf({{}, frame.yLow, frame.yHigh}, board.ink);
    board.y->setLabelsVisible(false);
    board.y->setGridLineVisible(false);
}

/// Words in a column, as high as they come out.
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

/// What lines and marks stand for, in as many rows as they need: the legend of Qt Charts has one, and cuts their names.
class Key final : public QGraphicsItem
{
public:
    Key(QChart& chart, double widthPx, const Ink& ink) : QGraphicsItem(&chart), m_words(ink.words), m_widthPx(widthPx)
    {
        const QFontMetricsF metrics(typeface(kSmall));
        m_rowPx = metrics.height() + kSpace1;
        double left = 0.0;
        for (QLegendMarker* marker : chart.legend()->markers()) {
            if (marker->label().isEmpty() || isNamed(marker->label()))
                continue;
            const double wide = kSignPx + kSpace1 + metrics.horizontalAdvance(marker->label());
            if (left > 0.0 && left + wide > widthPx) {
                left = 0.0;
                ++m_rows;
            }
            m_entries << Entry{marker, QPointF(left, m_rows * m_rowPx)};
            left += wide + kSpace4;
        }
    }

    [[nodiscard]] double height() const { return m_entries.isEmpty() ? 0.0 : (m_rows + 1) * m_rowPx + kSpace1; }
    [[nodiscard]] QRectF boundingRect() const override { return {0.0, 0.0, m_widthPx, height()}; }

    void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override
    {
        painter->setRenderHint(QPainter::Antialiasing);
        for (const Entry& entry : m_entries) {
            const QRectF sign(entry.at, QSizeF(kSignPx, m_rowPx));
            paintSign(*painter, sign, *entry.marker);
            painter->setFont(typeface(kSmall));
            painter->setPen(m_words);
            painter->drawText(QRectF(sign.right() + kSpace1, sign.top(), m_widthPx, m_rowPx),
                              Qt::AlignLeft | Qt::AlignVCenter, entry.marker->label());
        }
    }

private:
    struct Entry
    {
        QLegendMarker* marker;
        QPointF at;
    };

    [[nodiscard]] bool isNamed(const QString& label) const
    {
        return std::any_of(m_entries.begin(), m_entries.end(),
                           [&](const Entry& entry) { return entry.marker->label() == label; });
    }

    static void paintSign(QPainter& painter, const QRectF& sign, QLegendMarker& marker)
    {
        const QPointF middle = sign.center();
        if (const auto* marks = qobject_cast<QScatterSeries*>(marker.series())) {
            painter.setPen(marks->borderColor());
            painter.setBrush(marks->color());
            const double half = 0.5 * marks->markerSize();
            const QRectF box(middle - QPointF(half, half), QSizeF(2.0 * half, 2.0 * half));
            if (marks->markerShape() == QScatterSeries::MarkerShapeRectangle)
                painter.drawRect(box);
            else if (marks->markerShape() == QScatterSeries::MarkerShapeRotatedRectangle)
                painter.drawPolygon(QPolygonF{middle - QPointF(half, 0.0), middle - QPointF(0.0, half),
                                              middle + QPointF(half, 0.0), middle + QPointF(0.0, half)});
            else
                painter.drawEllipse(box);
        } else if (const auto* line = qobject_cast<QLineSeries*>(marker.series())) {
            painter.setPen(line->pen());
            painter.drawLine(QPointF(sign.left(), middle.y()), QPointF(sign.right(), middle.y()));
        } else {
            painter.setPen(marker.pen());
            painter.setBrush(marker.brush());
            painter.drawRect(sign.adjusted(0.0, 3.0, 0.0, -3.0));
        }
    }

    static constexpr double kSignPx = 24.0;
    QList<Entry> m_entries;
    QColor m_words;
    double m_widthPx;
    double m_rowPx = 0.0;
    int m_rows = 0;  ///< after the first
};

void addKey(Board& board)
{
    auto* key = new Key(board.chart, board.roomPx.width(), board.ink);
    board.chart.legend()->hide();
    board.edges.setBottom(static_cast<int>(std::ceil(key->height())));
    QObject::connect(&board.chart, &QChart::plotAreaChanged, &board.chart,
                     [key, &chart = board.chart] { key->setPos(0.0, chart.size().height() - key->height()); });
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

int ticksFor(double heightPx)
{
    constexpr double kTickPx = 48.0;  // with its share of what title and legend take
    return std::clamp(static_cast<int>(heightPx / kTickPx), 2, kMostTicks);
}

int rowsFor(const Chart& chart, const QSizeF& roomPx)
{
    const auto* const bars = std::get_if<Bars>(&chart.content);
    if (bars == nullptr)
        return kFewestRows;
    const QFontMetricsF metrics(typeface(kSmall));
    const bool isLong = std::any_of(bars->bars.begin(), bars->bars.end(), [&](const Bars::Bar& bar) {
        return metrics.horizontalAdvance(bar.name) > kNameShare * roomPx.width();
    });
    const auto rows = [&](int lines) {
        const double rowPx = lines * metrics.lineSpacing() + kNameEdgesPx;
        return std::max(kFewestRows, static_cast<int>((roomPx.height() - kFootPx) / rowPx));
    };
    // A bar whose name is shortened tells more than none.
    const int loose = rows(isLong ? kNameLines : 1);
    return bars->bars.size() > loose && bars->bars.size() <= rows(1) ? rows(1) : loose;
}

void draw(const Chart& content, const Ink& ink, QChart& into, const QSizeF& roomPx)
{
    into.setBackgroundVisible(false);
    into.layout()->setContentsMargins(0, 0, 0, 0);
    into.setLocalizeNumbers(true);
    into.setLocale(QLocale());
    Board board{into, ink, roomPx, {}};
    std::visit([&](const auto& what) { makeAxes(what, board); }, content.content);
    into.addAxis(board.x, Qt::AlignBottom);
    into.addAxis(board.y, Qt::AlignLeft);
    std::visit([&](const auto& what) { draw(what, board); }, content.content);
    addKey(board);
    into.setMargins(board.edges);
}

void paint(QPainter& painter, const QRectF& area, const Chart& chart, const Ink& ink)
{
    painter.save();
    double top = area.top();
    top += paintWords(painter, QRectF(area.left(), top, area.width(), area.height()), chart.title,
                      typeface(kBody, QFont::DemiBold), ink.words);
    top += paintWords(painter, QRectF(area.left(), top, area.width(), area.height()), chart.note, typeface(kSmall),
                      ink.quiet);
    const QRectF plot(area.left(), top, area.width(), area.bottom() - top);
    if (stopsOf(chart).isEmpty()) {
        paintWords(painter, plot, chart.emptyWords, typeface(kBody), ink.quiet);
    } else {
        QGraphicsScene scene;
        auto* drawn = new QChart;
        drawn->setAnimationOptions(QChart::NoAnimation);
        scene.addItem(drawn);
        draw(chart, ink, *drawn, plot.size());
        drawn->resize(plot.size());
        scene.setSceneRect(QRectF(QPointF(0.0, 0.0), plot.size()));
        drawn->layout()->activate();
        painter.setRenderHint(QPainter::Antialiasing);
        scene.render(&painter, plot, scene.sceneRect());
    }
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
    return bytes;
}

}  // namespace ui::charts
