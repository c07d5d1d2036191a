// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/replay/TimeLine.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QCoreApplication>
#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>

#include "core/bur/Bur.h"
#include "core/servo/ServoState.h"
#include "core/session/SessionChannels.h"
#include "ui/kit/Theme.h"
#include "ui/practice/ExerciseCard.h"
#include "ui/practice/InfractionCard.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/Texts.h"

namespace ui::replay {
namespace {

using namespace ui::kit;

constexpr int kMarksPx = 16;
constexpr int kStrokesPx = 14;
constexpr int kStrokeLanePx = kMarksPx + kStrokesPx + 2;
constexpr int kScalePx = 16;
constexpr int kSidePx = 16;           ///< margin at both ends, for the knob
constexpr double kNarrowestPx = 2.0;  ///< least width of a stroke
constexpr double kHitPx = 6.0;
constexpr double kMostLabelsPx = 72.0;  ///< least distance between two times on the scale
constexpr double kSignPx = 6.0;         ///< half the size of a sign
constexpr int kMostWords = 280;         ///< characters of a comment in the tooltip; the score card shows all of it

/// Least contrast between a bar and its background (WCAG 2.1, 1.4.11).
constexpr double kBarContrast = 3.0;

/// Colours of the common burs, after Okabe and Ito, in the order of core::bur::burs().
constexpr std::array<QRgb, core::bur::kCommonBurs> kCommonBurColours{0xFF56B4E9, 0xFFE69F00, 0xFF2FB98D, 0xFFD991BD};

/// Returns the catalogue number of a bur: "330".
QString burNumber(std::uint64_t index)
{
    const auto burs = core::bur::burs();
    return index < burs.size() ? QString::fromStdString(burs[index].id) : QStringLiteral("?");
}

double scaleStep(double lengthS, double widthPx)
{
    for (const double step : {1.0, 2.0, 5.0, 10.0, 15.0, 30.0, 60.0, 120.0, 300.0, 600.0})
        if (step / lengthS * widthPx >= kMostLabelsPx)
            return step;
    return 1800.0;
}

/// Paints a triangle with an exclamation mark.
void paintInfraction(QPainter& painter, QPointF at, const Tones& tone)
{
    QPainterPath sign;
    sign.moveTo(at + QPointF(0.0, -kSignPx));
    sign.lineTo(at + QPointF(kSignPx, kSignPx - 1.0));
    sign.lineTo(at + QPointF(-kSignPx, kSignPx - 1.0));
    sign.closeSubpath();
    painter.setPen(Qt::NoPen);
    painter.setBrush(tone.harmText);
    painter.drawPath(sign);
    painter.setPen(QPen(roomPalette().color(QPalette::Base), 1.6));
    painter.drawLine(at + QPointF(0.0, -2.0), at + QPointF(0.0, 1.5));
    painter.drawPoint(at + QPointF(0.0, 3.5));
}

/// Paints a speech bubble.
void paintRemark(QPainter& painter, QPointF at)
{
    QPainterPath sign;
    sign.addRoundedRect(QRectF(at + QPointF(-kSignPx, -kSignPx), QSizeF(2.0 * kSignPx, 1.5 * kSignPx)), 2.5, 2.5);
    sign.moveTo(at + QPointF(-3.0, 0.4 * kSignPx));
    sign.lineTo(at + QPointF(-1.5, kSignPx));
    sign.lineTo(at + QPointF(2.0, 0.4 * kSignPx));
    sign.closeSubpath();
    sign.setFillRule(Qt::WindingFill);
    painter.setPen(Qt::NoPen);
    painter.setBrush(roomPalette().color(QPalette::Link));
    painter.drawPath(sign);
    painter.setPen(QPen(roomPalette().color(QPalette::Base), 1.2));
    painter.drawLine(at + QPointF(-3.5, -3.2), at + QPointF(3.5, -3.2));
    painter.drawLine(at + QPointF(-3.5, -0.6), at + QPointF(1.5, -0.6));
}

/// Paints an arrow in the direction in which time jumped.
void paintArrow(QPainter& painter, QPointF at, double way)
{
    painter.drawLine(at + QPointF(3.5 * way, 0.0), at - QPointF(3.5 * way, 0.0));
    painter.drawLine(at + QPointF(3.5 * way, 0.0), at + QPointF(0.5 * way, -3.0));
    painter.drawLine(at + QPointF(3.5 * way, 0.0), at + QPointF(0.5 * way, 3.0));
}

void paintMark(QPainter& painter, QPointF at, const Mark& mark)
{
    painter.setPen(QPen(roomPalette().color(QPalette::PlaceholderText), 1.5));
    painter.setBrush(Qt::NoBrush);
    switch (mark.kind) {
    case Mark::Kind::Undo:
        paintArrow(painter, at, -1.0);
        break;
    case Mark::Kind::Redo:
        paintArrow(painter, at, 1.0);
        break;
    case Mark::Kind::StartAgain:
        paintArrow(painter, at, -1.0);
        painter.drawLine(at + QPointF(-4.5, -3.5), at + QPointF(-4.5, 3.5));
        break;
    case Mark::Kind::Bur:
        painter.setPen(QColor(burColour(static_cast<std::uint8_t>(mark.value))));
        painter.setFont(typeface(11, QFont::DemiBold));
        painter.drawText(QRectF(at - QPointF(24.0, 8.0), QSizeF(48.0, 16.0)), Qt::AlignCenter, burNumber(mark.value));
        break;
    case Mark::Kind::Aids:
        painter.drawEllipse(at, 3.0, 3.0);
        break;
    case Mark::Kind::Touched:
        painter.drawLine(at + QPointF(-3.0, 0.0), at + QPointF(-1.0, 2.5));
        painter.drawLine(at + QPointF(-1.0, 2.5), at + QPointF(3.5, -3.0));
        break;
    case Mark::Kind::Handpiece:
    case Mark::Kind::Note:
    case Mark::Kind::Home:
    case Mark::Kind::Resumed:
        painter.drawRect(QRectF(at - QPointF(2.5, 2.5), QSizeF(5.0, 5.0)));
        break;
    }
}

/// Returns the text of an answer given in an exercise, or an empty string for other marks.
QString noteWords(std::uint64_t code)
{
    if (const auto answer = core::grading::answerOf(code); answer && answer->pad < core::grading::kPads)
        //: %1 is "Left", "Middle" or "Right", %2 a tissue
        return QCoreApplication::translate("TimeLine", "%1 pad: answer %2")
            .arg(practice::padName(answer->pad), text::materialName(answer->said));
    if (code == core::servo::kGradedNote)
        return QCoreApplication::translate("TimeLine", "Graded");
    return QCoreApplication::translate("TimeLine", "Note %1").arg(code);
}

QString burWords(std::uint64_t index)
{
    const auto burs = core::bur::burs();
    return index < burs.size() ? text::burName(burs[index].id) : QString::number(index + 1);
}

}  // namespace

QColor burColour(std::uint8_t index)
{
    if (index < kCommonBurColours.size())
        return kCommonBurColours.at(index);
    // Steps of the golden ratio distribute any number of hues evenly.
    constexpr double kGoldenRatio = 0.61803398875;
    constexpr std::array kLightness{0.62F, 0.74F, 0.86F};
    const double turns = kGoldenRatio * index;
    QColor colour = QColor::fromHslF(static_cast<float>(turns - std::floor(turns)), 0.7F, kLightness.at(index % 3));
    const QColor bed = roomPalette().color(QPalette::Midlight);
    while (contrast(colour, bed) < kBarContrast)
        colour = colour.lighter(105);
    return colour;
}

QString markWords(const Mark& mark)
{
    switch (mark.kind) {
    case Mark::Kind::Undo:
        return QCoreApplication::translate("TimeLine", "Undone");
    case Mark::Kind::Redo:
        return QCoreApplication::translate("TimeLine", "Redone");
    case Mark::Kind::StartAgain:
        return QCoreApplication::translate("TimeLine", "Tooth reset");
    case Mark::Kind::Bur:
        //: %1: a bur such as "Pear, No. 330"
        return QCoreApplication::translate("TimeLine", "Bur: %1").arg(burWords(mark.value));
    case Mark::Kind::Handpiece:
        return QCoreApplication::translate("TimeLine", "Handpiece: %1").arg(text::handpieceName(mark.name));
    case Mark::Kind::Aids:
        return text::aidWords(mark.value);
    case Mark::Kind::Note:
        return noteWords(mark.value);
    case Mark::Kind::Home:
        return QCoreApplication::translate("TimeLine", "The hand was guided back");
    case Mark::Kind::Touched:
        return QCoreApplication::translate("TimeLine", "Point %1 touched").arg(mark.value + 1);
    case Mark::Kind::Resumed:
        break;
    }
    return QCoreApplication::translate("TimeLine", "Resumed");
}

QString remarkWords(const Remark& remark)
{
    const QString words = QString::fromStdString(remark.words).simplified();
    const QString shown = words.size() > kMostWords ? words.left(kMostWords).trimmed() + u'…' : words;
    //: %1 who remarked something on an attempt, %2 the words
    return QCoreApplication::translate("TimeLine", "%1: %2").arg(QString::fromStdString(remark.author), shown);
}

TimeLine::TimeLine(QWidget* parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("timeLine"));
    text::bindTranslation(this, [this] {
        setAccessibleName(tr("Time line"));
        setAccessibleDescription(
            tr("Left and Right move from stroke to stroke, Home and End to the beginning and the end."));
    });
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setCursor(Qt::PointingHandCursor);
    setMouseTracking(true);
}

QSize TimeLine::sizeHint() const
{
    return {200, static_cast<int>(lanes().size()) * kStrokeLanePx + kScalePx + kSpace1};
}

void TimeLine::setCourse(const AttemptTimeline& course)
{
    m_course = course;
    update();
}

void TimeLine::setBeside(const AttemptTimeline& beside)
{
    const bool another = (beside.lengthS > 0.0) != (m_beside.lengthS > 0.0);
    m_beside = beside;
    if (another)
        updateGeometry();
    update();
}

void TimeLine::setPosition(double seconds)
{
    if (std::abs(xOf(seconds) - xOf(m_positionS)) < 0.25) {
        m_positionS = seconds;
        return;
    }
    m_positionS = seconds;
    update();
}

QList<TimeLine::Lane> TimeLine::lanes() const
{
    QList<Lane> all{{m_course, kSpace1}};
    if (m_beside.lengthS > 0.0)
        all << Lane{m_beside, kSpace1 + kStrokeLanePx};
    return all;
}

double TimeLine::xIn(const AttemptTimeline& course, double seconds) const
{
    const double share = course.lengthS > 0.0 ? std::clamp(seconds / course.lengthS, 0.0, 1.0) : 0.0;
    return kSidePx + share * (width() - 2 * kSidePx);
}

double TimeLine::xOf(double seconds) const
{
    return xIn(m_course, seconds);
}

double TimeLine::secondsAt(double x) const
{
    return std::clamp((x - kSidePx) / std::max(1, width() - 2 * kSidePx), 0.0, 1.0) * m_course.lengthS;
}

QStringList TimeLine::saidAt(const QPoint& place) const
{
    QStringList said;
    for (const Lane& lane : lanes()) {
        if (place.y() < lane.top || place.y() >= lane.top + kStrokeLanePx)
            continue;
        const auto isHere = [&](double seconds) { return std::abs(xIn(lane.course, seconds) - place.x()) <= kHitPx; };
        const auto at = [](double seconds, const QString& what) {
            //: On a time line: a time, and what happened then
            return tr("%1  %2").arg(text::duration(seconds), what);
        };
        for (const core::grading::Infraction& infraction : lane.course.infractions)
            if (isHere(infraction.seconds))
                said << at(infraction.seconds, practice::breachName(infraction));
        for (const Remark& remark : lane.course.remarks)
            if (isHere(remark.atS))
                said << at(remark.atS, remarkWords(remark));
        for (const Mark& mark : lane.course.marks)
            if (isHere(mark.atS))
                said << at(mark.atS, markWords(mark));
        if (place.y() < lane.top + kMarksPx)
            continue;
        for (std::size_t n = 0; n < lane.course.strokes.size(); ++n) {
            const Stroke& stroke = lane.course.strokes[n];
            if (place.x() < xIn(lane.course, stroke.fromS) - 1.0 || place.x() > xIn(lane.course, stroke.toS) + 1.0)
                continue;
            said << at(stroke.fromS, tr("Stroke %1, %2 s, %3")
                                         .arg(n + 1)
                                         .arg(text::number(stroke.toS - stroke.fromS, 1), burWords(stroke.burIndex)));
            break;
        }
        for (const Rest& rest : lane.course.rests)
            if (place.x() >= xIn(lane.course, rest.fromS) && place.x() <= xIn(lane.course, rest.toS))
                said << at(
                    rest.fromS,
                    tr("Interruption of %1, not counted as working time").arg(text::duration(rest.toS - rest.fromS)));
    }
    return said;
}

void TimeLine::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    for (const Lane& lane : lanes())
        paintLane(painter, lane);
    paintScale(painter);
    for (const Lane& lane : lanes())
        paintMarks(painter, lane);
    paintNow(painter);
}

void TimeLine::paintLane(QPainter& painter, const Lane& lane) const
{
    const QRectF bed(kSidePx, lane.top + kMarksPx, width() - 2 * kSidePx, kStrokesPx);
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette().color(QPalette::Midlight));
    painter.drawRoundedRect(bed, 3.0, 3.0);
    const double readyX = xIn(lane.course, lane.course.readyS);
    if (lane.course.readyS < lane.course.lengthS) {
        painter.setBrush(QBrush(palette().color(QPalette::Mid), Qt::BDiagPattern));
        painter.drawRect(QRectF(QPointF(readyX, bed.top()), bed.bottomRight()));
    }
    painter.setBrush(QBrush(palette().color(QPalette::Mid), Qt::Dense5Pattern));
    for (const Rest& rest : lane.course.rests)
        painter.drawRect(QRectF(QPointF(xIn(lane.course, rest.fromS), bed.top()),
                                QPointF(xIn(lane.course, rest.toS), bed.bottom())));
    for (const Stroke& stroke : lane.course.strokes) {
        const double x = xIn(lane.course, stroke.fromS);
        const double wide = std::max(kNarrowestPx, xIn(lane.course, stroke.toS) - x);
        painter.fillRect(QRectF(x, bed.top() + 2.0, wide, bed.height() - 4.0), burColour(stroke.burIndex));
    }
}

/// Paints the marks. Rule violations are painted last, so that no mark hides them, and comments just before them.
void TimeLine::paintMarks(QPainter& painter, const Lane& lane) const
{
    const double y = lane.top + kMarksPx / 2.0;
    for (const Mark& mark : lane.course.marks)
        paintMark(painter, {xIn(lane.course, mark.atS), y}, mark);
    for (const Remark& remark : lane.course.remarks)
        paintRemark(painter, {xIn(lane.course, remark.atS), y});
    for (const core::grading::Infraction& infraction : lane.course.infractions)
        paintInfraction(painter, {xIn(lane.course, infraction.seconds), y}, tones(palette()));
}

void TimeLine::paintScale(QPainter& painter) const
{
    if (!(m_course.lengthS > 0.0))
        return;
    const int top = height() - kScalePx;
    painter.setFont(typeface(11));
    painter.setPen(palette().color(QPalette::PlaceholderText));
    const double step = scaleStep(m_course.lengthS, width() - 2 * kSidePx);
    for (double s = 0.0; s <= m_course.lengthS; s += step) {
        const double x = xOf(s);
        painter.drawLine(QPointF(x, top), QPointF(x, top + 3.0));
        const double from = std::clamp(x - 30.0, 2.0, width() - 62.0);
        painter.drawText(QRectF(from, top + 2.0, 60.0, kScalePx - 2.0),
                         (from > x - 29.0 ? Qt::AlignLeft : Qt::AlignHCenter) | Qt::AlignTop, text::duration(s));
    }
}

void TimeLine::paintNow(QPainter& painter) const
{
    const double x = xOf(m_positionS);
    const QColor colour = palette().color(QPalette::WindowText);
    painter.setPen(QPen(colour, 2.0));
    painter.drawLine(QPointF(x, kSpace1 + 2.0), QPointF(x, height() - kScalePx + 2.0));
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawEllipse(QPointF(x, kSpace1 + 2.0), 5.0, 5.0);
}

void TimeLine::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton)
        return;
    const double x = event->position().x();
    for (const Lane& lane : lanes()) {
        const double y = event->position().y() - lane.top;
        if (y < 0.0 || y >= kMarksPx)
            continue;
        std::vector<double> signs;
        for (const core::grading::Infraction& infraction : lane.course.infractions)
            signs.push_back(infraction.seconds);
        for (const Remark& remark : lane.course.remarks)
            signs.push_back(remark.atS);
        for (const double atS : signs) {
            if (std::abs(xIn(lane.course, atS) - x) > kHitPx)
                continue;
            emit seekRequested(secondsAt(xIn(lane.course, atS - kLeadUpS)));
            return;
        }
    }
    m_scrubs = true;
    emit seekRequested(secondsAt(x));
}

void TimeLine::mouseMoveEvent(QMouseEvent* event)
{
    if (m_scrubs)
        emit seekRequested(secondsAt(event->position().x()));
}

void TimeLine::mouseReleaseEvent(QMouseEvent*)
{
    m_scrubs = false;
}

bool TimeLine::event(QEvent* event)
{
    if (event->type() != QEvent::ToolTip)
        return QWidget::event(event);
    const auto* help = dynamic_cast<QHelpEvent*>(event);
    QStringList said = saidAt(help->pos());
    if (said.isEmpty())
        said << text::duration(secondsAt(help->pos().x()));
    QToolTip::showText(help->globalPos(), said.join(u'\n'), this);
    return true;
}

}  // namespace ui::replay
