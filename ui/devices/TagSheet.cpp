// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/devices/TagSheet.h"

#include <cmath>
#include <cstddef>
#include <numbers>

#include <QBuffer>
#include <QPageSize>
#include <QPainter>
#include <QPainterPath>
#include <QPdfWriter>

namespace ui::devices {
namespace {

using core::tracking::kCellsASide;
using core::tracking::kEdgeCells;

constexpr double kMmPerInch = 25.4;
constexpr int kSheetDpi = 1200;
/// Size of all pages' content, so that A4 and Letter have a margin of at least 12 mm.
constexpr QSizeF kContentMm{186.0, 250.0};
constexpr double kThinMm = 0.2;
constexpr double kTitleMm = 5.0;  ///< heights of letters
constexpr double kTextMm = 3.4;
constexpr double kSmallPrintMm = 2.6;
constexpr double kLabelMm = 8.0;  ///< below the white border of a tag
constexpr double kTiltDeg = 20.0;

double withBorder(double edgeMm)
{
    return edgeMm * kCellsASide / kEdgeCells;
}

}  // namespace

/// Draws with coordinates in millimetres. Text is laid out in dots, because font sizes are whole numbers.
class TagSheet::Pen
{
public:
    explicit Pen(QPainter& painter) : m_painter(painter), m_dotsPerMm(painter.device()->logicalDpiX() / kMmPerInch)
    {
        m_painter.setRenderHint(QPainter::Antialiasing);
        m_painter.scale(m_dotsPerMm, m_dotsPerMm);
    }

    QPainter& painter() { return m_painter; }
    void fill(const QRectF& where) { m_painter.fillRect(where, Qt::black); }
    void fill(const QPainterPath& shape) { m_painter.fillPath(shape, Qt::black); }
    void cutLine(const QRectF& around)
    {
        m_painter.setPen(::QPen(Qt::gray, kThinMm, Qt::DashLine));
        m_painter.drawRect(around);
    }
    void foldLine(const QPointF& from, const QPointF& to)
    {
        m_painter.setPen(::QPen(Qt::gray, kThinMm, Qt::DotLine));
        m_painter.drawLine(from, to);
    }
    void write(const QRectF& where, double sizeMm, const QString& words,
               Qt::Alignment at = Qt::AlignLeft | Qt::AlignTop)
    {
        m_painter.save();
        m_painter.translate(where.topLeft());
        m_painter.scale(1.0 / m_dotsPerMm, 1.0 / m_dotsPerMm);
        QFont font;
        font.setPixelSize(static_cast<int>(std::lround(sizeMm * m_dotsPerMm)));
        m_painter.setFont(font);
        m_painter.setPen(Qt::black);
        m_painter.drawText(QRectF({}, where.size() * m_dotsPerMm), static_cast<int>(at) | Qt::TextWordWrap, words);
        m_painter.restore();
    }
    /// Draws an arrow that points up. Its width is half its height.
    void upArrow(const QRectF& where)
    {
        QPainterPath arrow;
        const double middle = where.top() + 0.5 * where.height();
        arrow.addPolygon(QPolygonF{{where.center().x(), where.top()}, {where.right(), middle}, {where.left(), middle}});
        arrow.addRect(where.center().x() - 0.15 * where.width(), middle, 0.3 * where.width(), 0.5 * where.height());
        fill(arrow);
    }

private:
    QPainter& m_painter;
    double m_dotsPerMm;
};

TagSheet::TagSheet(int id, const core::tracking::TagCells& cells) : m_id(id), m_cells(cells) {}

void TagSheet::paint(QPainter& painter, Page page, const QSizeF& paperMm) const
{
    painter.save();
    Pen pen(painter);
    const QSizeF rest = 0.5 * (paperMm - kContentMm);
    painter.translate(rest.width(), rest.height());
    switch (page) {
    case Page::Tags:
        paintTags(pen);
        break;
    case Page::Headband:
        paintHeadband(pen);
        break;
    case Page::Board:
        paintBoard(pen);
        break;
    }
    painter.restore();
}

QByteArray TagSheet::pdf() const
{
    QBuffer buffer;
    QPdfWriter writer(&buffer);
    if (!buffer.open(QIODevice::WriteOnly))
        return {};
    writer.setTitle(tr("Head tracking: tag %1").arg(m_id));
    writer.setCreator(QStringLiteral("Cusp"));
    writer.setResolution(kSheetDpi);
    const QPageSize paper(QPageSize::A4);
    writer.setPageSize(paper);
    writer.setPageMargins({});
    {
        QPainter painter(&writer);
        for (const Page page : kPages) {
            if (page != kPages.front())
                writer.newPage();
            paint(painter, page, paper.size(QPageSize::Millimeter));
        }
    }
    return buffer.data();
}

void TagSheet::paintTags(Pen& pen) const
{
    pen.write({0.0, 0.0, kContentMm.width(), 8.0}, kTitleMm, tr("Head tracking: tag %1").arg(m_id));
    pen.write(
        {0.0, 10.0, kContentMm.width(), 22.0}, kTextMm,
        tr("Print this on matte paper. Cut a tag out along the dashed line. Do not cut off its white border: without "
           "it the tag is not found. Glue the tag to a piece of stiff, flat card."));
    paintRuler(pen, {0.0, 36.0});
    const std::array<QPointF, kEdgesMm.size()> places{{{0.0, 56.0}, {90.0, 56.0}, {0.0, 152.0}}};
    for (std::size_t n = 0; n < places.size(); ++n) {
        const double side = withBorder(kEdgesMm.at(n));
        paintTag(pen, places.at(n), kEdgesMm.at(n));
        pen.cutLine({places.at(n), QSizeF(side, side + kLabelMm)});
    }
    pen.write(
        {66.0, 152.0, kContentMm.width() - 66.0, 60.0}, kTextMm,
        tr("Wear the tag on your forehead with the arrow pointing up, tilted by 15 to 25 degrees: its lower edge is "
           "nearer to the camera than its upper edge.") +
            QStringLiteral("\n\n") +
            tr("Tell Cusp the length of the tag's edge. It stands below the tag and is the side of the black "
               "square."));
}

void TagSheet::paintTag(Pen& pen, const QPointF& upperLeft, double edgeMm) const
{
    const double cell = edgeMm / kEdgeCells;
    const double side = withBorder(edgeMm);
    QPainterPath black;
    for (int row = 0; row < kCellsASide; ++row)
        for (int column = 0; column < kCellsASide; ++column)
            if (!m_cells.at(static_cast<std::size_t>(row * kCellsASide + column)))
                black.addRect(upperLeft.x() + column * cell, upperLeft.y() + row * cell, cell, cell);
    // Filled as one shape, because some programs show white lines between separate cells.
    pen.fill(black.simplified());
    const QRectF label(upperLeft.x(), upperLeft.y() + side, side, kLabelMm);
    pen.write(label.adjusted(0.5 * cell, 1.0, 0.0, 0.0), kSmallPrintMm, tr("Tag %1, edge %2 mm").arg(m_id).arg(edgeMm));
    pen.upArrow({label.right() - 5.0, label.top() + 0.5, 3.0, 6.0});
}

void TagSheet::paintHeadband(Pen& pen) const
{
    constexpr double kLengthMm = 250.0;
    constexpr double kSlotMm = 22.0;
    constexpr double kSlotFromEndMm = 12.0;
    const double tag = withBorder(kBandEdgeMm);
    const double height = tag + kLabelMm;
    pen.painter().save();
    pen.painter().translate(0.0, kLengthMm);
    pen.painter().rotate(-90.0);
    paintTag(pen, {0.5 * (kLengthMm - tag), 0.0}, kBandEdgeMm);
    pen.cutLine({0.0, 0.0, kLengthMm, height});
    for (const double x : {kSlotFromEndMm, kLengthMm - kSlotFromEndMm})
        pen.cutLine({x - 1.0, 0.5 * (height - kSlotMm), 2.0, kSlotMm});
    pen.painter().restore();

    constexpr double kLeft = 80.0;
    const double width = kContentMm.width() - kLeft;
    paintRuler(pen, {kLeft, 5.0});
    pen.write(
        {kLeft, 28.0, width, 62.0}, kTextMm,
        tr("The headband: cut it out and cut its two slots. Pull an elastic band, 20 mm wide and about 35 cm long, "
           "through the slots.") +
            QStringLiteral("\n\n") +
            tr("The wedge: glue it to stiff card, cut it out, fold it along the dotted lines to a triangle, and glue "
               "its flap to its foot. Glue it behind the tag, the foot below. It keeps the tag flat and tilts it by "
               "20 degrees."));
    // The net of the wedge.
    constexpr double kFlapMm = 10.0;
    constexpr double kSideMm = 60.0;
    const double foot = 2.0 * kSideMm * std::sin(0.5 * kTiltDeg * std::numbers::pi / 180.0);
    const double x = kLeft + 0.5 * (width - kSideMm);
    double y = 96.0;
    pen.cutLine({x, y, kSideMm, kFlapMm + 2.0 * kSideMm + foot});
    const auto part = [&](double partMm, const QString& words, bool isLast = false) {
        pen.write({x, y, kSideMm, partMm}, kSmallPrintMm, words, Qt::AlignCenter);
        y += partMm;
        if (!isLast)
            pen.foldLine({x, y}, {x + kSideMm, y});
    };
    part(kFlapMm, tr("Flap"));
    part(kSideMm, tr("This side to the forehead"));
    part(kSideMm, tr("This side to the tag"));
    part(foot, tr("Foot"), true);
}

void TagSheet::paintBoard(Pen& pen)
{
    constexpr int kColumns = 7;
    constexpr int kRows = 10;
    constexpr double kLeft = 11.0;
    for (int row = 0; row < kRows; ++row)
        for (int column = row % 2; column < kColumns; column += 2)
            pen.fill(QRectF(kLeft + column * kSquareMm, row * kSquareMm, kSquareMm, kSquareMm));
    pen.painter().save();
    pen.painter().translate(0.0, kContentMm.height());
    pen.painter().rotate(-90.0);
    paintRuler(pen, {0.0, 3.0});
    pen.write({kRulerMm + 8.0, 0.0, kContentMm.height() - kRulerMm - 8.0, 9.0}, kSmallPrintMm,
              tr("Board for the calibration of a camera. Glue it to something stiff and flat. Show it to the camera at "
                 "many places and tilted to all sides."));
    pen.painter().restore();
}

void TagSheet::paintRuler(Pen& pen, const QPointF& leftEnd)
{
    constexpr int kMarks = 10;
    constexpr double kLongMm = 3.0;
    constexpr double kShortMm = 1.8;
    pen.fill(QRectF(leftEnd.x(), leftEnd.y() - kThinMm, kRulerMm, kThinMm));
    for (int mark = 0; mark <= kMarks; ++mark) {
        const double length = mark % 5 == 0 ? kLongMm : kShortMm;
        // The first mark begins where the line begins, and the last one ends where it ends.
        const double x = leftEnd.x() + (kRulerMm - kThinMm) * mark / kMarks;
        pen.fill(QRectF(x, leftEnd.y() - length, kThinMm, length));
    }
    pen.write({leftEnd.x(), leftEnd.y() + 1.0, kRulerMm + 6.0, 9.0}, kSmallPrintMm,
              tr("Measure this line: it must be 100 mm long. Otherwise print without scaling (100 %)."));
}

}  // namespace ui::devices
