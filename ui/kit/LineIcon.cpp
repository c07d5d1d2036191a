// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/LineIcon.h"

#include <QFile>
#include <QIconEngine>
#include <QPainter>
#include <QSvgRenderer>

namespace ui::kit {
namespace {

QByteArray drawing(const QString& name)
{
    QFile file(QStringLiteral(":/ui/icons/%1.svg").arg(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// Paints a drawing in a colour. The drawing uses currentColor, which the renderer does not support, so the colour is
/// inserted into the source before it is parsed.
void paintDrawing(QPainter& painter, const QRectF& where, QByteArray svg, const QColor& colour)
{
    svg.replace("currentColor", colour.name(QColor::HexRgb).toLatin1());
    QSvgRenderer renderer(svg);
    painter.setOpacity(static_cast<double>(colour.alphaF()));
    renderer.render(&painter, where);
}

class LineIconEngine : public QIconEngine
{
public:
    LineIconEngine(QByteArray svg, const QColor& normal, const QColor& disabled)
        : m_svg(std::move(svg)), m_normal(normal), m_disabled(disabled)
    {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override
    {
        const int side = std::min(rect.width(), rect.height());
        QRectF square(0, 0, side, side);
        square.moveCenter(QRectF(rect).center());
        painter->save();
        paintDrawing(*painter, square, m_svg, mode == QIcon::Disabled ? m_disabled : m_normal);
        painter->restore();
    }

    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override
    {
        QPixmap picture(size);
        picture.fill(Qt::transparent);
        QPainter painter(&picture);
        paint(&painter, QRect(QPoint(0, 0), size), mode, state);
        return picture;
    }

    QIconEngine* clone() const override { return new LineIconEngine(*this); }

private:
    QByteArray m_svg;
    QColor m_normal;
    QColor m_disabled;
};

}  // namespace

QIcon lineIcon(const QString& name, const QPalette& palette)
{
    QByteArray svg = drawing(name);
    if (svg.isEmpty())
        return {};
    return QIcon(new LineIconEngine(std::move(svg), palette.color(QPalette::Active, QPalette::ButtonText),
                                    palette.color(QPalette::Disabled, QPalette::ButtonText)));
}

QPixmap linePixmap(const QString& name, const QColor& colour, int sizePx, double devicePixelRatio)
{
    QPixmap picture(QSize(sizePx, sizePx) * devicePixelRatio);
    picture.setDevicePixelRatio(devicePixelRatio);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    paintDrawing(painter, QRectF(0, 0, sizePx, sizePx), drawing(name), colour);
    return picture;
}

}  // namespace ui::kit
