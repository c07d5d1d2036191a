// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/devices/TagPicture.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <QPainter>
#include <QPainterPath>

#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"

namespace ui::devices {
namespace {

using namespace ui::kit;

constexpr double kOutlinePx = 3.0;
constexpr double kHaloPx = 6.0;
constexpr double kTopMarkPx = 7.0;  ///< height of the arrow on the upper edge of the tag

/// The camera's picture is the same in both themes, so its outlines are light on dark in both.
const QColor kOutline(0x3D, 0xD6, 0xD0);
const QColor kHalo(0, 0, 0, 170);

}  // namespace

TagPicture::TagPicture(QWidget* parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("tagPicture"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    text::bindTranslation(this, [this] { describe(); });
}

void TagPicture::setPicture(const core::tracking::Picture& picture, const std::optional<Corners>& tag)
{
    const auto bytes = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
    if (picture.pixels.empty() || picture.pixels.size() < bytes)
        return;
    m_picture =
        QImage(picture.pixels.data(), picture.width, picture.height, picture.width, QImage::Format_Grayscale8).copy();
    m_tag = tag;
    describe();
    update();
}

void TagPicture::setWords(const QString& words)
{
    if (!hasPicture() && words == m_words)
        return;
    m_picture = {};
    m_tag.reset();
    m_words = words;
    describe();
    update();
}

void TagPicture::setMirrored(bool isMirrored)
{
    m_isMirrored = isMirrored;
    update();
}

void TagPicture::describe()
{
    setAccessibleName(!hasPicture() ? m_words
                      : m_tag       ? tr("Picture of the camera, with the tag outlined")
                                    : tr("Picture of the camera, without the tag"));
}

/// Returns the rectangle of the picture, scaled to fit.
QRectF TagPicture::place() const
{
    const QSizeF fitting = QSizeF(m_picture.size()).scaled(QSizeF(size()), Qt::KeepAspectRatio);
    return {QPointF(0.5 * (width() - fitting.width()), 0.5 * (height() - fitting.height())), fitting};
}

QPolygonF TagPicture::outline() const
{
    QPolygonF corners;
    if (!hasPicture() || !m_tag)
        return corners;
    const QRectF where = place();
    const double scale = where.width() / m_picture.width();
    for (const glm::dvec2& corner : *m_tag) {
        const double x = m_isMirrored ? m_picture.width() - corner.x : corner.x;
        corners << where.topLeft() + scale * QPointF(x, corner.y);
    }
    return corners;
}

void TagPicture::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    QPainterPath frame;
    frame.addRoundedRect(rect(), kRadius, kRadius);
    const QPalette dark = roomPalette();  // in both themes, like the surroundings of a film
    painter.fillPath(frame, dark.color(QPalette::Window));
    if (!hasPicture()) {
        painter.setFont(typeface(kBody));
        painter.setPen(dark.color(QPalette::WindowText));
        painter.drawText(rect().adjusted(kSpace4, kSpace4, -kSpace4, -kSpace4), Qt::AlignCenter | Qt::TextWordWrap,
                         m_words);
        return;
    }
    painter.setClipPath(frame);
    const QRectF where = place();
    painter.save();
    if (m_isMirrored) {
        painter.translate(width(), 0.0);
        painter.scale(-1.0, 1.0);
    }
    painter.drawImage(where, m_picture);
    painter.restore();
    const QPolygonF corners = outline();
    if (corners.isEmpty())
        return;
    for (const bool isHalo : {true, false}) {
        painter.setPen(
            QPen(isHalo ? kHalo : kOutline, isHalo ? kHaloPx : kOutlinePx, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.setBrush(Qt::NoBrush);
        painter.drawPolygon(corners);
        // An arrow at the upper edge shows whether a tag is upside down.
        const QPointF middle = 0.5 * (corners.at(2) + corners.at(3));
        const QPointF along = 0.5 * (corners.at(2) - corners.at(3));
        QPointF up = middle - 0.25 * (corners.at(0) + corners.at(1) + corners.at(2) + corners.at(3));
        up *= kTopMarkPx / std::max(1.0, std::hypot(up.x(), up.y()));
        painter.setBrush(isHalo ? kHalo : kOutline);
        painter.drawPolygon(QPolygonF({middle - 0.25 * along, middle + up, middle + 0.25 * along}));
    }
}

}  // namespace ui::devices
