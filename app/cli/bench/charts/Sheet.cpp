// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/bench/charts/Sheet.h"

#include <QBuffer>
#include <QGraphicsSimpleTextItem>
#include <QImage>
#include <QPainter>
#include <QSvgGenerator>

#include "app/cli/bench/charts/Compact.h"

namespace app::cli::bench {
namespace {

constexpr QRectF kSheet(0.0, 0.0, kChartWidth, kChartHeight);
constexpr double kMargin = 40.0;
constexpr double kAboutTop = 98.0;
constexpr double kAboutLine = 30.0;
constexpr double kFooterHeight = 50.0;

QByteArray svgOf(QGraphicsScene& scene, const QString& title)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setSize(kSheet.size().toSize());
    generator.setViewBox(kSheet);
    generator.setResolution(96);
    generator.setTitle(title);
    generator.setDescription(QStringLiteral("Drawn by cusp bench"));
    QPainter painter(&generator);
    scene.render(&painter, kSheet, kSheet);
    painter.end();
    return compacted(bytes, chartFont(kTextPx).family());
}

QByteArray pngOf(QGraphicsScene& scene)
{
    QImage image(kSheet.size().toSize(), QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
    scene.render(&painter, kSheet, kSheet);
    painter.end();
    QByteArray bytes;
    QBuffer buffer(&bytes);
    image.save(&buffer, "PNG");
    return bytes;
}

}  // namespace

QGraphicsItem* addText(QGraphicsScene& scene, const QString& text, const QFont& font, const QColor& colour, QPointF at,
                       Qt::Alignment alignment)
{
    auto* const item = scene.addSimpleText(text, font);
    item->setBrush(colour);
    const QRectF box = item->boundingRect();
    const double left = (alignment & Qt::AlignRight) != 0     ? box.width()
                        : (alignment & Qt::AlignHCenter) != 0 ? 0.5 * box.width()
                                                              : 0.0;
    item->setPos(at - QPointF(left, 0.5 * box.height()));
    item->setZValue(100.0);
    return item;
}

Pictures draw(const Chart& chart, const QString& footer)
{
    QGraphicsScene scene;
    scene.setSceneRect(kSheet);
    scene.addRect(kSheet, Qt::NoPen, Qt::white);
    addText(scene, chart.title, chartFont(kTitlePx, true), inkColour(), {kMargin, 52.0});
    double top = kAboutTop;
    for (const QString& line : chart.about.split(u'\n')) {
        addText(scene, line, chartFont(kTextPx), quietColour(), {kMargin, top});
        top += kAboutLine;
    }
    const QRectF place(kMargin, top, kSheet.width() - 2.0 * kMargin, kSheet.height() - kFooterHeight - top);
    std::visit([&](const auto& content) { add(scene, place, content); }, chart.content);
    addText(scene, footer, chartFont(kNotePx), quietColour(), {kMargin, kSheet.height() - 0.6 * kFooterHeight});
    return {svgOf(scene, chart.title), pngOf(scene)};
}

}  // namespace app::cli::bench
