// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scoring/HeatMap.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include "core/grading/Columns.h"
#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/Texts.h"

namespace ui::scoring {
namespace {

using namespace ui::kit;

constexpr QRgb kGround = 0xFF15181A;
constexpr QRgb kWords = 0xFFB6BDBF;
constexpr QRgb kBright = 0xFFFFFFFF;
constexpr QRgb kDark = 0xFF101214;
constexpr QRgb kUntouched = 0xFF6E7375;
constexpr QRgb kRight = 0xFFF2EFE6;  ///< cut exactly to the ideal
/// Colours from slightly off to the end of the scale. Vermilion and sky blue of Okabe and Ito are in the middle.
constexpr QRgb kJustDeep = 0xFFF6CBB0;
constexpr QRgb kDeep = 0xFFB33C00;
constexpr QRgb kJustLeft = 0xFFC9E6F7;
constexpr QRgb kLeft = 0xFF1F6FB2;
constexpr QRgb kInk = 0xB0101214;
constexpr double kToldFromMm = 0.03;  ///< a smaller distance to the ideal is not shown
constexpr double kHeadPx = 22.0;
constexpr double kLegendPx = 44.0;
constexpr double kSidePx = 18.0;
constexpr int kPatternPx = 7;
constexpr double kRingPx = 9.0;
constexpr double kPinPx = 8.0;       ///< radius of a pin's head
constexpr QRgb kPin = 0xFF101214;    ///< differs from the colours for too deep and too high
constexpr double kKeyStepMm = 0.25;  ///< distance that an arrow key moves the pin

QRgb between(QRgb a, QRgb b, double share)
{
    const auto mix = [share](int from, int to) { return static_cast<int>(std::lround(from + (to - from) * share)); };
    return qRgb(mix(qRed(a), qRed(b)), mix(qGreen(a), qGreen(b)), mix(qBlue(a), qBlue(b)));
}

QRgb lit(QRgb colour, double light)
{
    const auto of = [light](int value) { return std::clamp(static_cast<int>(std::lround(value * light)), 0, 255); };
    return qRgb(of(qRed(colour)), of(qGreen(colour)), of(qBlue(colour)));
}

/// Returns whether a pixel has ink: stripes where the cut is too deep, dots where material remains to be removed.
bool hasInk(double aboveMm, int x, int y)
{
    if (aboveMm < -kToldFromMm)
        return (x + y) % kPatternPx < 2;
    return aboveMm > kToldFromMm && x % kPatternPx < 2 && y % kPatternPx < 2;
}

/// Returns the brightness of a column lit from the upper left; about 1 on level ground.
double lightOn(const core::terrain::Tooth& tooth, int i, int j)
{
    const core::terrain::Grid& grid = tooth.grid();
    const auto height = [&](int ni, int nj) {
        const std::size_t k = grid.index(std::clamp(ni, 0, grid.side - 1), std::clamp(nj, 0, grid.side - 1));
        const std::size_t here = core::grading::wasSolid(*tooth.anatomy, k) ? k : grid.index(i, j);
        return static_cast<double>(core::grading::endOf(tooth, here));
    };
    const double slopeX = (height(i + 1, j) - height(i - 1, j)) / (2.0 * grid.cellMm);
    const double slopeY = (height(i, j + 1) - height(i, j - 1)) / (2.0 * grid.cellMm);
    const glm::dvec3 normal = glm::normalize(glm::dvec3(-slopeX, -slopeY, 1.0));
    return 0.62 + 0.45 * std::max(0.0, glm::dot(normal, glm::normalize(glm::dvec3(-0.45, 0.55, 0.9))));
}

}  // namespace

QRgb heatColour(double aboveMm)
{
    const double share = std::min(1.0, std::abs(aboveMm) / render::kIdealScaleMm);
    return aboveMm < 0.0 ? between(kJustDeep, kDeep, share) : between(kJustLeft, kLeft, share);
}

HeatMap::HeatMap(QWidget* parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setMouseTracking(true);
    text::bindTranslation(this, [this] { retranslateUi(); });
}

void HeatMap::retranslateUi()
{
    setAccessibleName(tr("The tooth from above, coloured by what is too deep and what is still to cut"));
    setToolTip(
        m_isPinnable
            ? brokenIntoLines(
                  tr("To mark the place of a comment, click the tooth or use the arrow keys. Delete removes the mark."))
            : QString());
}

void HeatMap::setWork(const ScoredWork& work)
{
    m_work = work;
    m_probed.reset();
    const core::terrain::Grid& grid = work.tooth->grid();
    m_i0 = m_j0 = grid.side;
    m_i1 = m_j1 = -1;
    for (int j = 0; j < grid.side; ++j)
        for (int i = 0; i < grid.side; ++i) {
            if (!core::grading::wasSolid(*work.tooth->anatomy, grid.index(i, j)))
                continue;
            m_i0 = std::min(m_i0, i);
            m_i1 = std::max(m_i1, i);
            m_j0 = std::min(m_j0, j);
            m_j1 = std::max(m_j1, j);
        }
    draw();
}

void HeatMap::setMark(std::optional<std::size_t> node, const core::imaging::SectionPlane& plane)
{
    m_mark = node;
    m_plane = plane;
    update();
}

void HeatMap::setPin(const std::optional<std::array<double, 3>>& placeMm)
{
    m_pin = placeMm;
    update();
}

void HeatMap::setPinnable(bool pinnable)
{
    m_isPinnable = pinnable;
    setFocusPolicy(pinnable ? Qt::StrongFocus : Qt::NoFocus);
    setCursor(pinnable ? Qt::CrossCursor : Qt::ArrowCursor);
    retranslateUi();
}

void HeatMap::choosePin(const std::optional<std::array<double, 3>>& placeMm)
{
    if (placeMm == m_pin)
        return;
    setPin(placeMm);
    emit pinned(placeMm);
}

std::array<double, 3> HeatMap::placeOf(std::size_t node) const
{
    const glm::dvec2 at = m_work.tooth->grid().nodeMm(node);
    return {at.x, at.y, static_cast<double>(core::grading::endOf(*m_work.tooth, node))};
}

void HeatMap::setColours(render::Palette colours)
{
    m_colours = colours;
    draw();
}

void HeatMap::setOnPaper(bool onPaper)
{
    m_onPaper = onPaper;
    update();
}

QColor HeatMap::wordColour() const
{
    return QColor(m_onPaper ? kDark : kWords);
}

QPointF HeatMap::Frame::at(double i, double j) const
{
    return {plot.left() + (i - firstI) * pxPerCell, plot.top() + (lastJ - j) * pxPerCell};
}

HeatMap::Frame HeatMap::frame() const
{
    const QRectF room = QRectF(rect()).adjusted(kSidePx, kHeadPx, -kSidePx, -kLegendPx - kHeadPx);
    const double columns = m_i1 - m_i0 + 1.0;
    const double rows = m_j1 - m_j0 + 1.0;
    Frame made;
    made.pxPerCell = std::max(0.1, std::min(room.width() / columns, room.height() / rows));
    made.plot = QRectF(0.0, 0.0, columns * made.pxPerCell, rows * made.pxPerCell);
    made.plot.moveCenter(room.center());
    made.plot.moveTopLeft(made.plot.topLeft().toPoint());
    made.firstI = m_i0 - 0.5;
    made.lastJ = m_j1 + 0.5;
    return made;
}

std::optional<std::size_t> HeatMap::nodeAt(const Frame& frame, const QPointF& at) const
{
    if (!m_work.tooth)
        return std::nullopt;
    const int i = static_cast<int>(std::lround(frame.firstI + (at.x() - frame.plot.left()) / frame.pxPerCell));
    const int j = static_cast<int>(std::lround(frame.lastJ - (at.y() - frame.plot.top()) / frame.pxPerCell));
    const core::terrain::Grid& grid = m_work.tooth->grid();
    if (!grid.contains(i, j) || !core::grading::wasSolid(*m_work.tooth->anatomy, grid.index(i, j)))
        return std::nullopt;
    return grid.index(i, j);
}

void HeatMap::draw()
{
    update();
    if (!m_work.tooth || m_i1 < m_i0)
        return;
    const core::terrain::Tooth& tooth = *m_work.tooth;
    const core::terrain::Grid& grid = tooth.grid();
    QImage columns(m_i1 - m_i0 + 1, m_j1 - m_j0 + 1, QImage::Format_ARGB32_Premultiplied);
    columns.fill(Qt::transparent);
    for (int j = m_j0; j <= m_j1; ++j)
        for (int i = m_i0; i <= m_i1; ++i) {
            const std::size_t k = grid.index(i, j);
            if (!core::grading::wasSolid(*tooth.anatomy, k))
                continue;
            const double above = static_cast<double>(aboveIdeal(m_work, k));
            const bool isOff = std::abs(above) > kToldFromMm;
            const QRgb colour = isOff ? heatColour(above) : core::grading::isCut(tooth, k) ? kRight : kUntouched;
            // Coloured columns are shaded less, so that their colours can be compared with the scale.
            const double light = lightOn(tooth, i, j);
            columns.setPixel(i - m_i0, m_j1 - j, lit(colour, isOff ? 0.7 + 0.3 * light : light));
        }
    const Frame here = frame();
    const QSize size = (here.plot.size() * devicePixelRatioF()).toSize().expandedTo({1, 1});
    m_picture = columns.scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    if (m_colours == render::Palette::Distinct) {
        const double ratio = devicePixelRatioF();
        for (int y = 0; y < m_picture.height(); ++y)
            for (int x = 0; x < m_picture.width(); ++x)
                if (const auto k = nodeAt(here, here.plot.topLeft() + QPointF(x + 0.5, y + 0.5) / ratio);
                    k && hasInk(static_cast<double>(aboveIdeal(m_work, *k)), x, y))
                    m_picture.setPixel(x, y, between(m_picture.pixel(x, y), kInk | 0xFF000000, 0.6));
    }
    m_picture.setDevicePixelRatio(devicePixelRatioF());
}

void HeatMap::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    draw();
}

void HeatMap::mouseMoveEvent(QMouseEvent* event)
{
    const auto probed = nodeAt(frame(), event->position());
    if (probed == m_probed)
        return;
    m_probed = probed;
    update();
}

void HeatMap::leaveEvent(QEvent*)
{
    m_probed.reset();
    update();
}

void HeatMap::mousePressEvent(QMouseEvent* event)
{
    if (!m_isPinnable || event->button() != Qt::LeftButton) {
        QWidget::mousePressEvent(event);
        return;
    }
    const auto node = nodeAt(frame(), event->position());
    choosePin(node ? std::optional(placeOf(*node)) : std::nullopt);
}

/// Claims the arrow keys, which are also shortcuts of the replay and scroll the page.
bool HeatMap::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride && m_isPinnable) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if ((key >= Qt::Key_Left && key <= Qt::Key_Down) || key == Qt::Key_Delete) {
            event->accept();
            return true;
        }
    }
    return QWidget::event(event);
}

/// Moves the pin with the arrow keys. It begins at the pin, the ring or the middle. Shift moves it column by column.
void HeatMap::keyPressEvent(QKeyEvent* event)
{
    const auto way = [event]() -> glm::dvec2 {
        switch (event->key()) {
        case Qt::Key_Left:
            return {-1.0, 0.0};
        case Qt::Key_Right:
            return {1.0, 0.0};
        case Qt::Key_Up:
            return {0.0, 1.0};
        case Qt::Key_Down:
            return {0.0, -1.0};
        default:
            return {0.0, 0.0};
        }
    }();
    if (!m_isPinnable || !m_work.tooth || (way == glm::dvec2(0.0) && event->key() != Qt::Key_Delete)) {
        QWidget::keyPressEvent(event);
        return;
    }
    if (event->key() == Qt::Key_Delete) {
        choosePin({});
        return;
    }
    const core::terrain::Grid& grid = m_work.tooth->grid();
    glm::dvec2 at = grid.middleMm();
    if (m_pin)
        at = glm::dvec2((*m_pin)[0], (*m_pin)[1]) +
             way * (event->modifiers().testFlag(Qt::ShiftModifier) ? grid.cellMm : kKeyStepMm);
    else if (m_mark)
        at = grid.nodeMm(*m_mark);
    const glm::dvec2 lattice = grid.latticeOf(at);
    const auto i = static_cast<int>(std::lround(lattice.x));
    const auto j = static_cast<int>(std::lround(lattice.y));
    if (grid.contains(i, j) && core::grading::wasSolid(*m_work.tooth->anatomy, grid.index(i, j)))
        choosePin(placeOf(grid.index(i, j)));
}

void HeatMap::focusInEvent(QFocusEvent* event)
{
    QWidget::focusInEvent(event);
    update();
}

void HeatMap::focusOutEvent(QFocusEvent* event)
{
    QWidget::focusOutEvent(event);
    update();
}

void HeatMap::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(m_onPaper ? QColor(Qt::white) : QColor(kGround));
    painter.drawRoundedRect(rect(), kRadius, kRadius);
    if (!m_work.tooth)
        return;
    const Frame here = frame();
    painter.drawImage(here.plot.topLeft(), m_picture);
    paintEnds(painter, here);
    paintMark(painter, here);
    paintPin(painter);
    if (hasFocus()) {
        painter.setPen(QPen(palette().color(QPalette::Link), 2.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawRoundedRect(QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0), kRadius, kRadius);
    }
    paintLegend(painter, QRectF(12.0, height() - kLegendPx, width() - 24.0, kLegendPx));
}

void HeatMap::paintEnds(QPainter& painter, const Frame&) const
{
    const core::terrain::ToothAnatomy& anatomy = *m_work.tooth->anatomy;
    const auto towards = [&](double quarters) {
        return text::directionName(anatomy, quarters * 0.5 * std::numbers::pi);
    };
    painter.setPen(wordColour());
    painter.setFont(typeface(kSmall, QFont::Medium));
    const QRectF room = QRectF(rect()).adjusted(0.0, 0.0, 0.0, -kLegendPx);
    painter.drawText(QRectF(room.left(), room.top() + 2.0, room.width(), kHeadPx), Qt::AlignCenter, towards(1.0));
    painter.drawText(QRectF(room.left(), room.bottom() - kHeadPx, room.width(), kHeadPx), Qt::AlignCenter,
                     towards(3.0));
    for (const int side : {-1, 1}) {
        painter.save();
        painter.translate(side < 0 ? room.left() + 0.5 * kSidePx : room.right() - 0.5 * kSidePx, room.center().y());
        painter.rotate(side < 0 ? -90.0 : 90.0);
        painter.drawText(QRectF(-0.5 * room.height(), -0.5 * kSidePx, room.height(), kSidePx), Qt::AlignCenter,
                         towards(side < 0 ? 2.0 : 0.0));
        painter.restore();
    }
}

void HeatMap::paintMark(QPainter& painter, const Frame& frame) const
{
    if (!m_mark)
        return;
    const core::terrain::Grid& grid = m_work.tooth->grid();
    const auto side = static_cast<std::size_t>(grid.side);
    const std::size_t row = *m_mark / side;
    const QPointF middle = frame.at(static_cast<double>(*m_mark % side), static_cast<double>(row));
    const glm::dvec2 along = m_plane.direction();
    const QPointF way(along.x, -along.y);
    const double reach = width() + height();
    painter.save();
    painter.setClipRect(frame.plot);  // not over the text beside it
    painter.setBrush(Qt::NoBrush);
    for (const auto& [colour, wide] : {std::pair(kDark, 3.0), std::pair(kBright, 1.2)}) {
        QPen pen(QColor(colour), wide);
        pen.setDashPattern({9.0 / wide, 6.0 / wide});
        painter.setPen(pen);
        for (const double sign : {-1.0, 1.0})
            painter.drawLine(middle + sign * kRingPx * way, middle + sign * reach * way);
    }
    painter.setClipping(false);
    for (const auto& [colour, wide] : {std::pair(kDark, 4.5), std::pair(kBright, 2.0)}) {
        painter.setPen(QPen(QColor(colour), wide));
        painter.drawEllipse(middle, kRingPx, kRingPx);
    }
    painter.restore();
}

QPointF HeatMap::pointOf(const std::array<double, 3>& placeMm) const
{
    const glm::dvec2 lattice = m_work.tooth->grid().latticeOf(glm::dvec2(placeMm[0], placeMm[1]));
    return frame().at(lattice.x, lattice.y);
}

/// Paints a pin whose point is at the place. Its shape differs from the ring.
void HeatMap::paintPin(QPainter& painter) const
{
    if (!m_pin)
        return;
    const QPointF tip = pointOf(*m_pin);
    const QPointF head = tip - QPointF(0.0, 2.2 * kPinPx);
    QPainterPath pin(tip);
    pin.quadTo(head + QPointF(-kPinPx, 0.9 * kPinPx), head - QPointF(kPinPx, 0.0));
    pin.arcTo(QRectF(head.x() - kPinPx, head.y() - kPinPx, 2.0 * kPinPx, 2.0 * kPinPx), 180.0, -180.0);
    pin.quadTo(head + QPointF(kPinPx, 0.9 * kPinPx), tip);
    painter.setPen(QPen(QColor(kBright), 1.6));
    painter.setBrush(QColor(kPin));
    painter.drawPath(pin);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(kBright));
    painter.drawEllipse(head, 0.36 * kPinPx, 0.36 * kPinPx);
}

void HeatMap::paintLegend(QPainter& painter, const QRectF& area) const
{
    painter.setRenderHint(QPainter::Antialiasing, false);
    const QRectF bar(area.left(), area.top() + 18.0, area.width(), 9.0);
    const double middle = bar.center().x();
    for (int x = 0; x < static_cast<int>(bar.width()); ++x) {
        const double above = -render::kIdealScaleMm * (bar.left() + x + 0.5 - middle) / (0.5 * bar.width());
        painter.fillRect(QRectF(bar.left() + x, bar.top(), 1.0, bar.height()),
                         QColor(std::abs(above) > kToldFromMm ? heatColour(above) : kRight));
        if (m_colours == render::Palette::Distinct)
            for (int y = 0; y < static_cast<int>(bar.height()); ++y)
                if (hasInk(above, x, y))
                    painter.fillRect(QRectF(bar.left() + x, bar.top() + y, 1.0, 1.0), QColor(kDark));
    }
    painter.setPen(wordColour());
    painter.setFont(typeface(kSmall));
    const QRectF words(area.left(), area.top(), area.width(), 16.0);
    if (m_probed) {
        const double above = static_cast<double>(aboveIdeal(m_work, *m_probed));
        const QString mm = text::number(std::abs(above), 2);
        painter.setPen(QColor(kBright));
        painter.drawText(words, Qt::AlignCenter,
                         std::abs(above) <= kToldFromMm ? tr("as it should be")
                         : above < 0.0                  ? tr("%1 mm too deep").arg(mm)
                                                        : tr("%1 mm still to cut").arg(mm));
        painter.setPen(wordColour());
    } else {
        painter.drawText(words, Qt::AlignLeft | Qt::AlignVCenter, tr("still to cut"));
        painter.drawText(words, Qt::AlignRight | Qt::AlignVCenter, tr("too deep"));
    }
    const QRectF feet(area.left(), bar.bottom() + 1.0, area.width(), 15.0);
    const QString end = text::number(render::kIdealScaleMm, 1) + QStringLiteral(" mm");
    painter.drawText(feet, Qt::AlignLeft | Qt::AlignVCenter, end);
    painter.drawText(feet, Qt::AlignCenter, QStringLiteral("0"));
    painter.drawText(feet, Qt::AlignRight | Qt::AlignVCenter, end);
}

}  // namespace ui::scoring
