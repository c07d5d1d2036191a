// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/devices/HandGuidePicture.h"

#include <algorithm>

#include <QPainter>
#include <QPainterPath>

#include "core/session/RestHeight.h"
#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"

namespace ui::devices {
namespace {

using namespace ui::kit;

// The drawings are made in a box of this size.
constexpr double kWide = 360.0;
constexpr double kHigh = 240.0;
constexpr double kDeskY = 196.0;
constexpr double kInkPx = 1.6;
constexpr double kForearmPx = 15.0;

QPen inkPen(const QColor& colour, double widthPx = kInkPx, Qt::PenStyle style = Qt::SolidLine)
{
    return {colour, widthPx, style, Qt::RoundCap, Qt::RoundJoin};
}

QColor ink(const QWidget& widget)
{
    return widget.palette().color(QPalette::WindowText);
}

/// Paints a thick line with an outline: a forearm or a finger.
void paintLimb(QPainter& painter, const QWidget& widget, const QPainterPath& path, double widthPx = kForearmPx)
{
    painter.setBrush(Qt::NoBrush);
    painter.setPen(inkPen(ink(widget), widthPx));
    painter.drawPath(path);
    painter.setPen(inkPen(widget.palette().color(QPalette::Base), widthPx - 2.0 * kInkPx));
    painter.drawPath(path);
}

QPainterPath limbThrough(std::initializer_list<QPointF> points)
{
    QPainterPath path(*points.begin());
    for (const QPointF& point : points)
        path.lineTo(point);
    return path;
}

void paintDesk(QPainter& painter, const QWidget& widget)
{
    painter.setPen(inkPen(widget.palette().color(QPalette::Mid), 3.0));
    painter.drawLine(QPointF(10.0, kDeskY), QPointF(kWide - 10.0, kDeskY));
}

}  // namespace

HandGuidePicture::HandGuidePicture(QWidget* parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("handGuidePicture"));
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    // Repaints the text in the picture. The text beside the picture says the same to screen readers.
    text::bindTranslation(this, [this] { update(); });
}

void HandGuidePicture::setScene(Scene scene, bool isLeft, bool hasForce)
{
    m_scene = scene;
    m_isLeft = isLeft;
    m_hasForce = hasForce;
    update();
}

void HandGuidePicture::setHeights(std::optional<double> gripMm, double restMm)
{
    if (gripMm == m_gripMm && restMm == m_restMm)
        return;
    m_gripMm = gripMm;
    m_restMm = restMm;
    update();
}

/// Paints the view from above: the screen, the tooth, and a forearm with the handpiece.
void HandGuidePicture::paintHand(QPainter& painter) const
{
    painter.setPen(inkPen(ink(*this)));
    painter.setBrush(palette().color(QPalette::Midlight));
    painter.drawRoundedRect(QRectF(110.0, 14.0, 140.0, 14.0), 3.0, 3.0);
    const QPointF tooth(0.5 * kWide, 92.0);
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawRoundedRect(QRectF(tooth.x() - 17.0, tooth.y() - 15.0, 34.0, 30.0), 11.0, 11.0);
    const QPointF head(0.5 * kWide, 212.0);
    painter.drawRoundedRect(QRectF(head.x() - 62.0, head.y() - 14.0, 124.0, 28.0), 14.0, 14.0);
    painter.drawEllipse(head, 20.0, 20.0);
    painter.save();
    if (m_isLeft) {
        painter.translate(kWide, 0.0);
        painter.scale(-1.0, 1.0);
    }
    paintLimb(painter, *this, limbThrough({{236.0, 206.0}, {272.0, 162.0}, {224.0, 118.0}}));
    painter.setPen(inkPen(tones(palette()).accent, 5.0));
    painter.drawLine(QPointF(228.0, 122.0), QPointF(186.0, 95.0));
    painter.restore();
}

/// Paints the view from the side: the eye, and the screen at arm's length with its upper edge at eye level or below.
void HandGuidePicture::paintScreen(QPainter& painter) const
{
    paintDesk(painter, *this);
    const QPointF eye(82.0, 62.0);
    painter.setPen(inkPen(ink(*this)));
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawEllipse(QPointF(66.0, 66.0), 26.0, 30.0);
    painter.drawRoundedRect(QRectF(38.0, 104.0, 50.0, 122.0), 22.0, 22.0);
    painter.setBrush(ink(*this));
    painter.drawEllipse(eye, 2.5, 2.5);
    paintLimb(painter, *this, limbThrough({{62.0, 128.0}, {78.0, 182.0}, {148.0, 184.0}}));
    painter.setPen(inkPen(ink(*this)));
    painter.setBrush(palette().color(QPalette::Midlight));
    painter.drawRoundedRect(QRectF(276.0, 64.0, 10.0, 98.0), 3.0, 3.0);
    painter.drawLine(QPointF(283.0, 162.0), QPointF(283.0, kDeskY - 2.0));
    painter.drawLine(QPointF(262.0, kDeskY - 3.0), QPointF(304.0, kDeskY - 3.0));
    painter.setPen(inkPen(tones(palette()).accent, kInkPx, Qt::DashLine));
    painter.drawLine(eye, QPointF(330.0, eye.y()));
    painter.drawLine(eye, QPointF(276.0, 112.0));
    painter.setFont(typeface(kSmall));
    painter.setPen(ink(*this));
    //: Between the eyes and the screen
    painter.drawText(QRectF(100.0, 30.0, 170.0, 26.0), Qt::AlignCenter, tr("50 to 70 cm"));
}

/// Paints the view from the side: the forearm on the table, or the hand on a rest in front of a force device.
void HandGuidePicture::paintRest(QPainter& painter) const
{
    paintDesk(painter, *this);
    if (!m_hasForce) {
        paintLimb(painter, *this, limbThrough({{52.0, 108.0}, {92.0, kDeskY - 10.0}, {216.0, kDeskY - 10.0}}), 17.0);
        paintLimb(painter, *this, limbThrough({{216.0, kDeskY - 12.0}, {246.0, kDeskY - 24.0}, {262.0, kDeskY - 8.0}}),
                  11.0);
        painter.setPen(inkPen(tones(palette()).accent, 5.0));
        painter.drawLine(QPointF(236.0, kDeskY - 58.0), QPointF(266.0, kDeskY - 6.0));
        return;
    }
    painter.setPen(inkPen(ink(*this)));
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawRect(QRectF(104.0, 150.0, 62.0, kDeskY - 152.0));  // the rest
    painter.drawPolygon(QPolygonF{{244.0, 160.0}, {272.0, 160.0}, {284.0, kDeskY - 2.0}, {232.0, kDeskY - 2.0}});
    painter.setBrush(palette().color(QPalette::Midlight));
    painter.drawEllipse(QPointF(258.0, 128.0), 34.0, 34.0);
    const QPointF grip(188.0, 126.0);
    for (const double side : {-1.0, 1.0})
        painter.drawPolyline(QPolygonF{{234.0, 128.0 + side * 20.0}, {210.0, 128.0 + side * 22.0}, grip});
    paintLimb(painter, *this, limbThrough({{20.0, 104.0}, {120.0, 122.0}}), 17.0);
    paintLimb(painter, *this, limbThrough({{120.0, 122.0}, {160.0, 106.0}, {182.0, 122.0}}), 10.0);
    paintLimb(painter, *this, limbThrough({{124.0, 124.0}, {148.0, 136.0}, {156.0, 148.0}}),
              9.0);  // the finger on its rest
    painter.setPen(Qt::NoPen);
    painter.setBrush(tones(palette()).accent);
    painter.drawEllipse(grip, 8.0, 8.0);
    paintHeights(painter);
}

/// Paints the work area as a vertical scale: a point for the grip, a line for the stored height.
void HandGuidePicture::paintHeights(QPainter& painter) const
{
    const QRectF scale(326.0, 40.0, 10.0, 150.0);
    const auto yAt = [&](double mm) {
        const double share = std::clamp(mm / core::session::kHandReachMm, -1.0, 1.0);
        return scale.center().y() - 0.5 * share * scale.height();
    };
    painter.setPen(inkPen(palette().color(QPalette::Mid), 1.0));
    painter.setBrush(palette().color(QPalette::Window));
    painter.drawRoundedRect(scale, 5.0, 5.0);
    painter.drawLine(QPointF(scale.left() - 4.0, yAt(0.0)), QPointF(scale.right() + 4.0, yAt(0.0)));
    painter.setPen(inkPen(ink(*this), 2.0));
    painter.drawLine(QPointF(scale.left() - 8.0, yAt(m_restMm)), QPointF(scale.right() + 8.0, yAt(m_restMm)));
    if (!m_gripMm)
        return;
    painter.setPen(inkPen(palette().color(QPalette::Base), 1.5));
    painter.setBrush(tones(palette()).accent);
    painter.drawEllipse(QPointF(scale.center().x(), yAt(*m_gripMm)), 8.0, 8.0);
}

/// Paints a target to aim at, and the trace of a trembling hand.
void HandGuidePicture::paintStill(QPainter& painter) const
{
    const QPointF middle(0.5 * kWide, 0.5 * kHigh);
    painter.setPen(inkPen(palette().color(QPalette::Mid), 1.0));
    painter.setBrush(palette().color(QPalette::Base));
    for (const double radius : {90.0, 60.0, 30.0})
        painter.drawEllipse(middle, radius, radius);
    painter.setPen(inkPen(ink(*this), 1.0));
    painter.drawLine(middle - QPointF(100.0, 0.0), middle + QPointF(100.0, 0.0));
    painter.drawLine(middle - QPointF(0.0, 100.0), middle + QPointF(0.0, 100.0));
    QPainterPath trace(middle);
    for (int k = 1; k <= 14; ++k)
        trace.lineTo(middle + QPointF(3.4 * k + (k % 2 == 0 ? 4.0 : -4.0), -1.6 * k + (k % 3 == 0 ? 6.0 : -4.0)));
    painter.setBrush(Qt::NoBrush);
    painter.setPen(inkPen(tones(palette()).accent, 2.0));
    painter.drawPath(trace);
}

void HandGuidePicture::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double scale = std::min(width() / kWide, height() / kHigh);
    painter.translate(0.5 * (width() - scale * kWide), 0.5 * (height() - scale * kHigh));
    painter.scale(scale, scale);
    switch (m_scene) {
    case Scene::Hand:
        paintHand(painter);
        break;
    case Scene::Screen:
        paintScreen(painter);
        break;
    case Scene::Rest:
        paintRest(painter);
        break;
    case Scene::Still:
        paintStill(painter);
        break;
    }
}

}  // namespace ui::devices
