// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/PictureFrame.h"

#include <algorithm>

#include <QPainter>
#include <QPainterPath>

#include "ui/shell/Theme.h"

namespace ui::shell {

PictureFrame::PictureFrame(QWidget* parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void PictureFrame::setPicture(const QImage& picture)
{
    m_picture = picture;
    setVisible(!picture.isNull());
    update();
}

void PictureFrame::paintEvent(QPaintEvent*)
{
    if (m_picture.isNull())
        return;
    QPainter painter(this);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    QPainterPath frame;
    frame.addRoundedRect(rect(), kRadius, kRadius);
    painter.setClipPath(frame);
    const double share =
        std::min(m_picture.width() / static_cast<double>(width()), m_picture.height() / static_cast<double>(height()));
    QRectF part(QPointF(0, 0), QSizeF(size()) * share);
    part.moveCenter(QRectF(m_picture.rect()).center());
    painter.drawImage(QRectF(rect()), m_picture, part);
}

}  // namespace ui::shell
