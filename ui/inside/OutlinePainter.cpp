// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inside/OutlinePainter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>
#include <vector>

#include <QCoreApplication>
#include <QPainter>

#include "core/grading/Columns.h"
#include "core/grading/Outline.h"
#include "ui/inside/PictureKey.h"
#include "ui/kit/Theme.h"
#include "ui/text/Texts.h"

namespace ui::inside {
namespace {

constexpr QRgb kGround = 0xFF15181A;
constexpr QRgb kWords = 0xFFB6BDBF;
constexpr QRgb kIdeal = 0xFFFFD23F;
constexpr QRgb kUnderIdeal = 0xB0101214;
constexpr QRgb kBand = 0x9056C7C9;
constexpr QRgb kBandEdge = 0xFF0B4F51;
constexpr QRgb kSpan = 0x48E0932A;
constexpr QRgb kPlane = 0xFFECEEEE;
constexpr double kMarginPx = 24.0;
constexpr QMarginsF kMargins(kMarginPx, kMarginPx, kMarginPx, 2.0 * kMarginPx);
constexpr double kAroundMm = 0.4;
constexpr double kLightX = -0.5;
constexpr double kLightY = 0.6;
constexpr double kLightZ = 0.62;
constexpr int kReliefPx = 600;         ///< approximate side of the relief; large enough to look smooth
constexpr int kMostFiner = 4;          ///< pixels of the relief per cell
constexpr float kRimSharpness = 6.0F;  ///< the rim changes from outside to inside within about a pixel of the relief

struct Fit
{
    double pxPerMm = 1.0;
    QPointF middle;
    QPointF middleMm;

    [[nodiscard]] QPointF at(QPointF mm) const
    {
        return middle + QPointF((mm.x() - middleMm.x()) * pxPerMm, (middleMm.y() - mm.y()) * pxPerMm);
    }
};

Fit fitOf(const QRectF& area, const FromAbove& above)
{
    const QRectF plot = area.marginsRemoved(kMargins);
    const QRectF mm = above.shownMm;
    return {
        std::max(1.0, std::min(plot.width() / std::max(1.0, mm.width()), plot.height() / std::max(1.0, mm.height()))),
        plot.center(), mm.center()};
}

/// The colour at a node of the lattice; each value is 0 to 1. Nodes outside the tooth have the light and decay of the
/// rim.
struct ReliefNode
{
    float isTooth = 0.0F;
    float light = 0.0F;
    float decay = 0.0F;  ///< decay that is open at the surface
};

/// Returns the weighted mean of the solid nodes in the 3 x 3 around (i, j), and their share of the weights.
/// @param valueOf  returns the value at the index of a node
template <typename Value>
std::pair<float, float> smoothed(const core::terrain::ToothAnatomy& anatomy, int i, int j, const Value& valueOf)
{
    const core::terrain::Grid& grid = anatomy.grid;
    float sum = 0.0F;
    float weights = 0.0F;
    for (int dj = -1; dj <= 1; ++dj) {
        for (int di = -1; di <= 1; ++di) {
            if (!grid.contains(i + di, j + dj) || !core::grading::wasSolid(anatomy, grid.index(i + di, j + dj)))
                continue;
            const auto weight = static_cast<float>((2 - std::abs(di)) * (2 - std::abs(dj))) / 16.0F;
            sum += weight * valueOf(grid.index(i + di, j + dj));
            weights += weight;
        }
    }
    return {weights > 0.0F ? sum / weights : 0.0F, weights};
}

std::vector<ReliefNode> reliefNodes(const core::terrain::ToothAnatomy& anatomy)
{
    const core::terrain::Grid& grid = anatomy.grid;
    const std::size_t count = anatomy.top.size();
    std::vector<float> heights(count);
    std::vector<ReliefNode> nodes(count);
    const auto eachNode = [&grid](const auto& work) {
        for (int j = 0; j < grid.side; ++j)
            for (int i = 0; i < grid.side; ++i)
                work(i, j, grid.index(i, j));
    };
    eachNode([&](int i, int j, std::size_t k) {
        std::tie(heights[k], nodes[k].isTooth) =
            smoothed(anatomy, i, j, [&](std::size_t other) { return anatomy.top[other]; });
    });
    std::vector<float> light(count);
    eachNode([&](int i, int j, std::size_t k) {
        const auto height = [&](int x, int y) {
            return grid.contains(x, y) && core::grading::wasSolid(anatomy, grid.index(x, y)) ? heights[grid.index(x, y)]
                                                                                             : heights[k];
        };
        const double dx = static_cast<double>(height(i + 1, j) - height(i - 1, j)) / (2.0 * grid.cellMm);
        const double dy = static_cast<double>(height(i, j + 1) - height(i, j - 1)) / (2.0 * grid.cellMm);
        light[k] = static_cast<float>(
            std::max(0.0, (-kLightX * dx - kLightY * dy + kLightZ) / std::sqrt(1.0 + dx * dx + dy * dy)));
    });
    eachNode([&](int i, int j, std::size_t k) {
        const bool isInside = core::grading::wasSolid(anatomy, k);
        nodes[k].light =
            isInside ? light[k] : smoothed(anatomy, i, j, [&](std::size_t other) { return light[other]; }).first;
        nodes[k].decay =
            smoothed(anatomy, i, j, [&](std::size_t other) {
                const core::terrain::ColumnLayers& column = anatomy.layers[other];
                return column.cariesRoof > column.cariesFloor && column.cariesRoof >= anatomy.top[other] ? 1.0F : 0.0F;
            }).first;
    });
    return nodes;
}

QRgb reliefPixel(const ReliefNode& node)
{
    // The rim is where half of a node's neighbourhood is tooth: a smooth line across the steps of the lattice.
    const float inside = std::clamp((node.isTooth - 0.5F) * kRimSharpness + 0.5F, 0.0F, 1.0F);
    const float grey = 70.0F + 150.0F * node.light;
    const auto channel = [&](float enamel, float decay) {
        const float shade = std::min(255.0F, grey * (enamel + (decay - enamel) * node.decay));
        return static_cast<int>(std::lround(inside * shade));
    };
    return qRgba(channel(1.0F, 0.44F), channel(0.97F, 0.24F), channel(0.92F, 0.11F),
                 static_cast<int>(std::lround(inside * 255.0F)));
}

/// Returns a picture of the tooth in soft light from the upper left. Open decay is brown.
QImage reliefOf(const core::terrain::ToothAnatomy& anatomy, QRectF& shownMm)
{
    const core::terrain::Grid& grid = anatomy.grid;
    for (int j = 0; j < grid.side; ++j) {
        for (int i = 0; i < grid.side; ++i) {
            if (!core::grading::wasSolid(anatomy, grid.index(i, j)))
                continue;
            const glm::dvec2 at = grid.nodeMm(i, j);
            shownMm |= QRectF(at.x, at.y, grid.cellMm, grid.cellMm);
        }
    }
    const std::vector<ReliefNode> nodes = reliefNodes(anatomy);
    const int fine = std::clamp(kReliefPx / grid.side, 1, kMostFiner);
    const int side = fine * grid.side;
    QImage picture(side, side, QImage::Format_ARGB32_Premultiplied);
    picture.fill(Qt::transparent);
    for (int y = 0; y < side; ++y) {
        auto* line = reinterpret_cast<QRgb*>(picture.scanLine(side - 1 - y));
        const float v = std::clamp((static_cast<float>(y) + 0.5F) / static_cast<float>(fine) - 0.5F, 0.0F,
                                   static_cast<float>(grid.side) - 1.001F);
        const int j = static_cast<int>(v);
        for (int x = 0; x < side; ++x) {
            const float u = std::clamp((static_cast<float>(x) + 0.5F) / static_cast<float>(fine) - 0.5F, 0.0F,
                                       static_cast<float>(grid.side) - 1.001F);
            const int i = static_cast<int>(u);
            const std::array<const ReliefNode*, 4> corners{&nodes[grid.index(i, j)], &nodes[grid.index(i + 1, j)],
                                                           &nodes[grid.index(i, j + 1)],
                                                           &nodes[grid.index(i + 1, j + 1)]};
            const auto between = [&](float ReliefNode::*field) {
                const float s = u - static_cast<float>(i);
                const float t = v - static_cast<float>(j);
                return (corners[0]->*field * (1.0F - s) + corners[1]->*field * s) * (1.0F - t) +
                       (corners[2]->*field * (1.0F - s) + corners[3]->*field * s) * t;
            };
            const ReliefNode here{between(&ReliefNode::isTooth), between(&ReliefNode::light),
                                  between(&ReliefNode::decay)};
            if (here.isTooth > 0.0F)
                line[x] = reliefPixel(here);
        }
    }
    return picture;
}

PictureKey keyOf(const OutlineScene& scene)
{
    PictureKey key;
    if (scene.above->outlineMm.isEmpty())
        return key;
    key.add(QCoreApplication::translate("Section", "ideal preparation"), 20.0, [](QPainter& on, const QRectF& box) {
        on.setPen(QPen(QColor(kIdeal), 2.0));
        on.drawLine(QPointF(box.left(), box.center().y()), QPointF(box.right(), box.center().y()));
    });
    const auto filled = [&key](const QString& name, const QBrush& brush, const QBrush& hatch) {
        key.add(name, PictureKey::kSignPx, [brush, hatch](QPainter& on, const QRectF& box) {
            on.fillRect(box, brush);
            on.fillRect(box, hatch);
        });
    };
    if (scene.toleranceMm > 0.0)
        filled(QCoreApplication::translate("Section", "within tolerance"), QColor::fromRgba(kBand),
               QBrush(QColor(kBandEdge), Qt::BDiagPattern));
    if (scene.spanMm > 0.0)
        //: In the key of a picture: farther out, all points of this criterion are lost
        filled(QCoreApplication::translate("Section", "costs points"), QColor::fromRgba(kSpan), Qt::NoBrush);
    return key;
}

}  // namespace

FromAbove fromAbove(const core::terrain::ToothAnatomy& anatomy, const std::vector<float>& idealTop)
{
    FromAbove above;
    const core::terrain::Grid& grid = anatomy.grid;
    above.relief = reliefOf(anatomy, above.shownMm);
    above.shownMm.adjust(-kAroundMm, -kAroundMm, kAroundMm, kAroundMm);
    const double wide = grid.side * grid.cellMm;
    above.reliefMm = {grid.originMm.x - 0.5 * grid.cellMm, grid.originMm.y - 0.5 * grid.cellMm, wide, wide};
    std::vector<float> end = idealTop;
    for (std::size_t k = 0; k < end.size(); ++k)
        if (core::grading::wasSolid(anatomy, k))
            end[k] = std::max(end[k], anatomy.bottom[k]);
    for (const auto& segment : core::grading::Outline(anatomy, end).segments()) {
        above.outlineMm.moveTo(segment.fromMm.x, segment.fromMm.y);
        above.outlineMm.lineTo(segment.toMm.x, segment.toMm.y);
    }
    return above;
}

QRectF areaAround(const QRectF& picture)
{
    return picture.marginsAdded(kMargins);
}

QPointF placeOf(const QRectF& area, const FromAbove& above, QPointF mm)
{
    return fitOf(area, above).at(mm);
}

QPointF mmAt(const QRectF& area, const FromAbove& above, QPointF place)
{
    const Fit fit = fitOf(area, above);
    const QPointF way = (place - fit.middle) / fit.pxPerMm;
    return {fit.middleMm.x() + way.x(), fit.middleMm.y() - way.y()};
}

void paintOutline(QPainter& painter, const QRectF& area, const OutlineScene& scene)
{
    const FromAbove& above = *scene.above;
    const Fit fit = fitOf(area, above);
    painter.save();
    painter.setClipRect(area, Qt::IntersectClip);
    painter.fillRect(area, QColor(kGround));
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.drawImage(QRectF(fit.at({above.reliefMm.left(), above.reliefMm.bottom()}),
                             fit.at({above.reliefMm.right(), above.reliefMm.top()})),
                      above.relief);
    QTransform onPaper(fit.pxPerMm, 0.0, 0.0, -fit.pxPerMm, 0.0, 0.0);
    const QPointF origin = fit.at({0.0, 0.0});
    onPaper *= QTransform::fromTranslate(origin.x(), origin.y());
    const QPainterPath outline = onPaper.map(above.outlineMm);
    // A stroke of this width covers exactly the points within the band's distance of the outline.
    const auto band = [&](double wideMm, const QBrush& brush) {
        if (wideMm > 0.0)
            painter.strokePath(outline, QPen(brush, 2.0 * wideMm * fit.pxPerMm, Qt::SolidLine, Qt::RoundCap));
    };
    if (scene.spanMm > 0.0)
        band(scene.toleranceMm + scene.spanMm, QColor::fromRgba(kSpan));
    band(scene.toleranceMm, QColor::fromRgba(kBand));
    band(scene.toleranceMm, QBrush(QColor(kBandEdge), Qt::BDiagPattern));
    painter.strokePath(outline, QPen(QColor::fromRgba(kUnderIdeal), 4.0, Qt::SolidLine, Qt::RoundCap));
    painter.strokePath(outline, QPen(QColor(kIdeal), 2.0, Qt::SolidLine, Qt::RoundCap));

    const PictureKey key = keyOf(scene);
    const double wide = area.width() - 16.0;
    const double keyTop = area.bottom() - key.heightFor(wide) - 4.0;
    if (scene.plane) {
        const glm::dvec2 way = scene.plane->direction();
        const glm::dvec2 through = scene.plane->throughMm;
        const double far = above.shownMm.width() + above.shownMm.height();
        painter.save();
        painter.setClipRect(QRectF(QPointF(area.left(), area.top() + kMarginPx), QPointF(area.right(), keyTop)),
                            Qt::IntersectClip);
        painter.setPen(QPen(QColor(kPlane), 1.4, Qt::DashLine));
        painter.drawLine(fit.at({through.x - far * way.x, through.y - far * way.y}),
                         fit.at({through.x + far * way.x, through.y + far * way.y}));
        painter.restore();
    }

    painter.setFont(kit::typeface(kit::kSmall, QFont::Medium));
    painter.setPen(QColor(kWords));
    const QRectF words = area.adjusted(8.0, 4.0, -8.0, -kMarginPx);
    const auto side = [&](double angleRad) { return text::directionName(*scene.anatomy, angleRad); };
    using std::numbers::pi;
    const QString up = QChar(0x2191) + QStringLiteral(" ") + side(0.5 * pi);
    const QString left = QChar(0x2190) + QStringLiteral(" ") + side(pi);
    const QString right = side(0.0) + QStringLiteral(" ") + QChar(0x2192);
    painter.drawText(words, Qt::AlignTop | Qt::AlignLeft, left);
    painter.drawText(words, Qt::AlignTop | Qt::AlignRight, right);
    const QFontMetricsF metrics = painter.fontMetrics();
    const double beside = std::max(metrics.horizontalAdvance(left), metrics.horizontalAdvance(right));
    if (0.5 * metrics.horizontalAdvance(up) + beside + 4.0 < 0.5 * words.width())  // the others show the orientation
        painter.drawText(words, Qt::AlignTop | Qt::AlignHCenter, up);
    key.paint(painter, QRectF(area.left() + 8.0, keyTop, wide, 0.0), QColor(kWords));
    painter.restore();
}

}  // namespace ui::inside
