// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inside/SectionPainter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QImage>
#include <QPainter>
#include <QPainterPath>

#include "core/imaging/Canals.h"
#include "core/terrain/DecayZones.h"
#include "ui/inside/PictureKey.h"
#include "ui/kit/Theme.h"
#include "ui/text/Texts.h"

namespace ui::inside {
namespace {

using core::imaging::Section;
using core::imaging::SectionSample;
using core::terrain::Material;
using core::terrain::MaterialSpan;
using core::terrain::ToothAnatomy;

/// Colours of the background, for the screen and for paper.
struct Ground
{
    QRgb ground, grid, words;
};
constexpr Ground kScreen{0xFF15181A, 0xFF2C3134, 0xFFB6BDBF};
constexpr Ground kPaper{0xFFFFFFFF, 0xFFDADDDF, 0xFF2A2F31};
constexpr QRgb kOverTissue = 0x30000000;  ///< grid lines over the tooth
constexpr QRgb kSurface = 0xFF56C7C9;     ///< the original surface
constexpr QRgb kIdealLine = 0xFFFFD23F;   ///< the ideal surface
constexpr QRgb kIdealShade = 0xB0101214;
constexpr QRgb kToleranceFill = 0x9056C7C9;  ///< between the limits of a tolerance
constexpr QRgb kToleranceHatch = 0xFF0B4F51;
constexpr QRgb kSteel = 0xE6AEB8BC;
constexpr QRgb kBorder = 0xFF000000;
constexpr QRgb kPale = 0xFFE8C9A0;
constexpr double kLeatheryPaler = 0.25;
constexpr double kFirmPaler = 0.5;
constexpr double kInkShare = 0.55;  ///< opacity of a pattern or a border over the tissue
constexpr QRgb kSteelEdge = 0xFF11140F;
constexpr QRgb kMark = 0xFFFFFFFF;
constexpr double kMarkPx = 9.0;  ///< radius of the ring

constexpr double kGutterPx = 30.0;  ///< left margin for heights
constexpr double kFootPx = 20.0;    ///< lower margin for lengths
constexpr double kHeadPx = 24.0;    ///< upper margin for the directions of both ends
constexpr double kBelowKeyPx = 6.0;
constexpr double kAboveMm = 1.6;       ///< height shown above the highest point
constexpr double kAboveSmallMm = 0.6;  ///< the same in a small picture
constexpr double kBesideMm = 0.5;
constexpr double kLeastDepthMm = 9.0;  ///< least depth shown below the highest point
constexpr double kBetweenPx = 6.0;     ///< gap between two numbers below the picture
constexpr double kLabelPx = 20.0;      ///< least distance between labels; some are omitted otherwise

/// Converts millimetres in the plane to pixels of the picture.
struct Frame
{
    QRectF plot;
    double pxPerMm = 1.0;
    double leftMm = 0.0;  ///< distance along the plane at the left edge
    double topMm = 0.0;   ///< height at the upper edge

    [[nodiscard]] double x(double alongMm) const { return plot.left() + (alongMm - leftMm) * pxPerMm; }
    [[nodiscard]] double y(double heightMm) const { return plot.top() + (topMm - heightMm) * pxPerMm; }
    [[nodiscard]] double rightMm() const { return leftMm + plot.width() / pxPerMm; }
    [[nodiscard]] double bottomMm() const { return topMm - plot.height() / pxPerMm; }
};

/// Returns a frame for the full width of the tooth along the plane, wherever the plane is. The picture therefore does
/// not jump while the bur moves.
/// @param aboveMm  height shown above the highest point
Frame frameFor(const QRectF& plot, const SectionScene& scene, double aboveMm)
{
    const ToothAnatomy& anatomy = *scene.tooth->anatomy;
    const glm::dvec2 right = scene.plane.direction();
    const int stride = std::max(1, anatomy.grid.side / core::terrain::kDefaultGridSide);
    double low = 1.0e9;
    double high = -1.0e9;
    double top = -1.0e9;
    for (int j = 0; j < anatomy.grid.side; j += stride) {
        for (int i = 0; i < anatomy.grid.side; i += stride) {
            const std::size_t k = anatomy.grid.index(i, j);
            if (!(anatomy.top[k] > anatomy.bottom[k]))
                continue;
            const double along = glm::dot(anatomy.grid.nodeMm(i, j), right);
            low = std::min(low, along);
            high = std::max(high, along);
            top = std::max(top, static_cast<double>(anatomy.top[k]));
        }
    }
    if (low > high) {
        low = -1.0;
        high = 1.0;
        top = 0.0;
    }
    Frame frame;
    frame.plot = plot;
    frame.pxPerMm = std::max(
        1.0, std::min(plot.width() / (high - low + 2.0 * kBesideMm), plot.height() / (aboveMm + kLeastDepthMm)));
    frame.leftMm = 0.5 * (low + high) - 0.5 * plot.width() / frame.pxPerMm;
    frame.topMm = top + aboveMm;
    return frame;
}

void paintGrid(QPainter& painter, const Frame& frame, const QColor& colour)
{
    painter.setPen(QPen(colour, 0));
    for (double mm = std::ceil(frame.leftMm); mm <= frame.rightMm(); mm += 1.0)
        painter.drawLine(QPointF(frame.x(mm), frame.plot.top()), QPointF(frame.x(mm), frame.plot.bottom()));
    for (double mm = std::ceil(frame.bottomMm()); mm <= frame.topMm; mm += 1.0)
        painter.drawLine(QPointF(frame.plot.left(), frame.y(mm)), QPointF(frame.plot.right(), frame.y(mm)));
}

void paintLabels(QPainter& painter, const Frame& frame, const QColor& words)
{
    painter.setPen(words);
    painter.setFont(kit::typeface(kit::kSmall));
    const auto stepFor = [&frame](double labelPx) {
        return frame.pxPerMm >= labelPx ? 1 : frame.pxPerMm >= labelPx / 2 ? 2 : frame.pxPerMm >= labelPx / 5 ? 5 : 10;
    };
    const auto multiple = [](double mm, int every) { return static_cast<int>(std::lround(mm)) % every == 0; };
    const int up = stepFor(kLabelPx);
    // A number such as "-12" is wider than it is high.
    const QFontMetricsF metrics(painter.font());
    double widest = 0.0;
    for (const double end : {std::ceil(frame.leftMm), std::floor(frame.rightMm())})
        widest = std::max(widest, metrics.horizontalAdvance(text::number(end, 0)));
    const int along = stepFor(std::max(kLabelPx, widest + kBetweenPx));
    for (double mm = std::ceil(frame.bottomMm()); mm <= frame.topMm - 0.5; mm += 1.0)
        if (const double y = frame.y(mm); multiple(mm, up) && y < frame.plot.bottom() - 5.0)
            painter.drawText(QRectF(frame.plot.left() - kGutterPx, y - 8.0, kGutterPx - 6.0, 16.0),
                             Qt::AlignRight | Qt::AlignVCenter, text::number(mm, 0));
    const QString unit = QStringLiteral("mm");
    for (double mm = std::ceil(frame.leftMm); mm <= frame.rightMm(); mm += 1.0)
        if (const double x = frame.x(mm);
            multiple(mm, along) && x < frame.plot.right() - 10.0 && x > frame.plot.left() + 6.0)
            painter.drawText(QRectF(x - 20.0, frame.plot.bottom() + 2.0, 40.0, 16.0), Qt::AlignCenter,
                             text::number(mm, 0));
    painter.drawText(QRectF(frame.plot.left() - kGutterPx, frame.plot.bottom() + 2.0, kGutterPx - 6.0, 16.0),
                     Qt::AlignRight | Qt::AlignVCenter, unit);
}

/// Returns whether a pattern has ink at a pixel: rising strokes, wide or thin falling strokes, or dots.
bool hasInk(Qt::BrushStyle pattern, int x, int y)
{
    constexpr int kStrokesPx = 8;
    constexpr int kThinStrokesPx = 14;
    constexpr int kDotsPx = 4;
    if (pattern == Qt::BDiagPattern)
        return (x + y) % kStrokesPx < 2;
    if (pattern == Qt::FDiagPattern)
        return std::abs(x - y) % kThinStrokesPx == 0;
    return pattern != Qt::NoBrush && x % kDotsPx == 0 && (y + (x / kDotsPx % 2) * kDotsPx / 2) % kDotsPx == 0;
}

QRgb mixed(QRgb below, QRgb above, double share)
{
    const auto channel = [share](int from, int to) {
        return static_cast<int>(std::lround(from + (to - from) * share));
    };
    return qRgba(channel(qRed(below), qRed(above)), channel(qGreen(below), qGreen(above)),
                 channel(qBlue(below), qBlue(above)), channel(qAlpha(below), qAlpha(above)));
}

/// Returns how much paler decay is at a height in mm. Leathery decay is paler than soft decay, and firm decay paler
/// than leathery.
double paleShare(const core::terrain::DecayZones& zones, double heightMm)
{
    if (heightMm <= static_cast<double>(zones.firmRoof))
        return kFirmPaler;
    return heightMm <= static_cast<double>(zones.leatheryRoof) ? kLeatheryPaler : 0.0;
}

/// Returns the picture of the materials, with one column of device pixels per sample. It has no seams at any scale. It
/// is drawn pixel by pixel, because a thousand rectangles take longer.
QImage tissue(const Section& section, const Frame& frame, double pixelRatio, render::Palette palette)
{
    const int width = static_cast<int>(section.samples.size());
    const int height = std::max(1, static_cast<int>(std::ceil(frame.plot.height() * pixelRatio)));
    QImage image(width, height, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    auto* pixels = reinterpret_cast<QRgb*>(image.bits());
    const qsizetype stride = image.bytesPerLine() / static_cast<qsizetype>(sizeof(QRgb));
    std::array<kit::MaterialLook, core::terrain::kMaterialCount> looks;
    for (std::size_t m = 0; m < looks.size(); ++m)
        looks.at(m) = kit::materialLook(static_cast<Material>(m), palette);
    const double scale = frame.pxPerMm * pixelRatio;
    for (int x = 0; x < width; ++x) {
        const SectionSample& sample = section.samples[static_cast<std::size_t>(x)];
        const MaterialSpan* below = nullptr;
        for (const MaterialSpan& span : sample.present) {
            const kit::MaterialLook& look = looks.at(static_cast<std::size_t>(span.material));
            const QRgb plainFill = look.fill.rgb();
            const QRgb plainInk = mixed(plainFill, look.letter.rgb(), kInkShare);
            const double top = (frame.topMm - static_cast<double>(span.highMm)) * scale;
            const double bottom = (frame.topMm - static_cast<double>(span.lowMm)) * scale;
            const int first = std::max(0, static_cast<int>(std::floor(top)));
            const int last = static_cast<int>(std::min<double>(height, std::ceil(bottom))) - 1;
            for (int y = first; y <= last; ++y) {
                QRgb& pixel = pixels[y * stride + x];
                QRgb colour = hasInk(look.pattern, x, y) ? plainInk : plainFill;
                if (span.material == Material::Caries && sample.zones)
                    colour = mixed(colour, kPale, paleShare(*sample.zones, frame.topMm - (y + 0.5) / scale));
                const double share = std::min(bottom, y + 1.0) - std::max(top, static_cast<double>(y));
                pixel = share >= 1.0 ? colour : mixed(pixel, colour, share);
            }
            // A thin dark line where two materials meet, so that a border is not shown by colour alone.
            const int border = static_cast<int>(std::floor(bottom));
            if (below != nullptr && border >= 0 && border < height) {
                QRgb& pixel = pixels[border * stride + x];
                pixel = mixed(pixel, kBorder, kInkShare);
            }
            below = &span;
        }
    }
    return image;
}

/// Paints a line through the heights, with gaps where there is no tooth or no height.
void paintHeights(QPainter& painter, const Section& section, const Frame& frame, float SectionSample::*height,
                  const QPen& pen)
{
    QPainterPath path;
    bool isBroken = true;
    for (std::size_t k = 0; k < section.samples.size(); ++k) {
        const SectionSample& sample = section.samples[k];
        const bool isThere = sample.wasTooth && sample.*height > core::terrain::kEmptyTop;
        if (isThere) {
            const QPointF here(frame.x(section.fromMm + static_cast<double>(k) * section.stepMm),
                               frame.y(static_cast<double>(sample.*height)));
            if (isBroken)
                path.moveTo(here);
            else
                path.lineTo(here);
        }
        isBroken = !isThere;
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(pen);
    painter.drawPath(path);
}

QPen surfacePen()
{
    return {QColor(kSurface), 1.6};
}

QPen idealPen()
{
    QPen pen(QColor(kIdealLine), 2.0);
    pen.setDashPattern({3.0, 2.0});
    return pen;
}

/// Paints the band between the highest and the lowest cut that lose no points, sample by sample. It is hatched, so that
/// it is visible on any colour.
void paintBand(QPainter& painter, const Frame& frame, const SectionScene& scene, const Section& section)
{
    const double toMm = section.fromMm + static_cast<double>(section.samples.size() - 1) * section.stepMm;
    const int count = static_cast<int>(section.samples.size());
    const auto limit = [&](const std::vector<float>& heights) {
        return core::imaging::sectionOf(*scene.tooth, scene.plane, section.fromMm, toMm, count, &heights);
    };
    const Section high = limit(scene.band->shallowestMm);
    const Section low = limit(scene.band->deepestMm);
    QPainterPath band;
    for (std::size_t k = 0; k < section.samples.size(); ++k) {
        const double top = static_cast<double>(high.samples[k].idealTopMm);
        const double bottom = static_cast<double>(low.samples[k].idealTopMm);
        if (!high.samples[k].wasTooth || !(top > bottom) || bottom <= static_cast<double>(core::terrain::kEmptyTop))
            continue;
        const double x = frame.x(section.fromMm + (static_cast<double>(k) - 0.5) * section.stepMm);
        band.addRect(QRectF(QPointF(x, frame.y(top)), QPointF(x + section.stepMm * frame.pxPerMm, frame.y(bottom))));
    }
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.fillPath(band, QColor::fromRgba(kToleranceFill));
    painter.fillPath(band, QBrush(QColor(kToleranceHatch), Qt::BDiagPattern));
    painter.restore();
}

void paintBur(QPainter& painter, const Frame& frame, const SectionScene& scene)
{
    const double along = scene.plane.alongMm({scene.tipMm.x, scene.tipMm.y});
    const auto at = [&](double radiusMm, double heightMm) {
        return QPointF(frame.x(along + radiusMm), frame.y(scene.tipMm.z + heightMm));
    };
    if (scene.downToPulpMm && *scene.downToPulpMm > 0.0) {
        painter.setPen(QPen(QColor(kSteelEdge), 1.4, Qt::DotLine));
        painter.drawLine(at(0.0, 0.0), at(0.0, -*scene.downToPulpMm));
    }
    const double shankTop = frame.topMm - scene.tipMm.z + 1.0;
    QPolygonF outline;
    for (const core::bur::Bur::Point& point : scene.bur->outline)
        outline << at(point.radiusMm, point.heightMm);
    const core::bur::Bur::Point last = scene.bur->outline.back();
    outline << at(scene.bur->shankRadiusMm, last.heightMm);
    if (shankTop > last.heightMm)
        outline << at(scene.bur->shankRadiusMm, shankTop) << at(-scene.bur->shankRadiusMm, shankTop);
    outline << at(-scene.bur->shankRadiusMm, last.heightMm);
    for (auto point = scene.bur->outline.rbegin(); point != scene.bur->outline.rend(); ++point)
        outline << at(-point->radiusMm, point->heightMm);
    painter.setBrush(QColor::fromRgba(kSteel));
    painter.setPen(QPen(QColor(kSteelEdge), 1.2));
    painter.drawPolygon(outline);
}

void paintMark(QPainter& painter, const Frame& frame, const SectionScene& scene)
{
    const QPointF at(frame.x(scene.plane.alongMm({scene.markMm->x, scene.markMm->y})), frame.y(scene.markMm->z));
    painter.setBrush(Qt::NoBrush);
    for (const auto& [colour, wide] : {std::pair(kBorder, 4.5), std::pair(kMark, 2.0)}) {
        painter.setPen(QPen(QColor(colour), wide));
        painter.drawEllipse(at, kMarkPx, kMarkPx);
    }
}

bool meetsTooth(const Section& section)
{
    return std::any_of(section.samples.begin(), section.samples.end(), [](const SectionSample& sample) {
        return sample.wasTooth || sample.present.begin() != sample.present.end();
    });
}

/// Paints the note that the plane misses the tooth, in the lower half and clear of the bur.
void paintNothingHere(QPainter& painter, const QRectF& plot, const Ground& ground)
{
    const QString words = QCoreApplication::translate("Section", "The plane does not meet the tooth here.");
    painter.setFont(kit::typeface(kit::kBody));
    const QRectF room(plot.left() + 12.0, plot.center().y(), plot.width() - 24.0, 0.4 * plot.height());
    const int flags = Qt::AlignCenter | Qt::TextWordWrap;
    const QRectF plate = painter.boundingRect(room, flags, words).adjusted(-10.0, -6.0, 10.0, 6.0);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(ground.ground));
    painter.drawRoundedRect(plate, kit::kRadius, kit::kRadius);
    painter.setPen(QColor(ground.words));
    painter.drawText(room, flags, words);
}

void paintEnds(QPainter& painter, const QRectF& head, const SectionScene& scene)
{
    const ToothAnatomy& anatomy = *scene.tooth->anatomy;
    painter.setPen(QColor((scene.onPaper ? kPaper : kScreen).words));
    painter.setFont(kit::typeface(kit::kSmall, QFont::Medium));
    painter.drawText(head, Qt::AlignLeft | Qt::AlignVCenter,
                     QChar(0x2190) + QStringLiteral(" ") +
                         text::directionName(anatomy, scene.plane.angleRad + std::numbers::pi));
    painter.drawText(head, Qt::AlignRight | Qt::AlignVCenter,
                     text::directionName(anatomy, scene.plane.angleRad) + QStringLiteral(" ") + QChar(0x2192));
}

PictureKey keyOf(const SectionScene& scene)
{
    PictureKey key;
    const auto area = [&key](const kit::MaterialLook& look, const QString& words) {
        key.add(words, PictureKey::kSignPx, [look](QPainter& painter, const QRectF& box) {
            painter.fillRect(box, look.fill);
            if (look.pattern == Qt::NoBrush)
                return;
            QColor ink = look.letter;
            ink.setAlphaF(static_cast<float>(kInkShare));
            painter.fillRect(box, QBrush(ink, look.pattern));
        });
    };
    for (const Material material : {Material::Enamel, Material::Dentin, Material::Caries, Material::Pulp}) {
        const kit::MaterialLook look = kit::materialLook(material, scene.palette);
        if (material != Material::Caries || !scene.tooth->anatomy->hasDecayZones) {
            area(look, text::materialName(material));
            continue;
        }
        const auto paler = [&look](double share) {
            kit::MaterialLook zone = look;
            zone.fill = QColor(mixed(look.fill.rgb(), kPale, share));
            return zone;
        };
        area(look, QCoreApplication::translate("Section", "soft decay"));
        area(paler(kLeatheryPaler), QCoreApplication::translate("Section", "leathery decay"));
        area(paler(kFirmPaler), QCoreApplication::translate("Section", "firm decay"));
    }
    key.endRow();
    const auto line = [&key](const QPen& pen, double width, const QString& words) {
        key.add(words, width, [pen](QPainter& painter, const QRectF& box) {
            painter.setPen(pen);
            painter.drawLine(QPointF(box.left(), box.center().y()), QPointF(box.right(), box.center().y()));
        });
    };
    //: In the key of a picture, beside a line
    line(surfacePen(), PictureKey::kSignPx, QCoreApplication::translate("Section", "original surface"));
    if (scene.ideal)
        line(idealPen(), 2.0 * PictureKey::kSignPx, QCoreApplication::translate("Section", "ideal preparation"));
    if (scene.band != nullptr)
        //: In the key of a picture: what may be cut or left without losing points
        key.add(QCoreApplication::translate("Section", "within tolerance"), PictureKey::kSignPx,
                [](QPainter& painter, const QRectF& box) {
                    painter.fillRect(box, QColor::fromRgba(kToleranceFill));
                    painter.fillRect(box, QBrush(QColor(kToleranceHatch), Qt::BDiagPattern));
                });
    return key;
}

/// Paints the materials, with one sample per column of device pixels. Returns the section.
Section paintTissue(QPainter& painter, const Frame& frame, const SectionScene& scene)
{
    const double pixelRatio = painter.device()->devicePixelRatioF();
    const int columns = std::max(2, static_cast<int>(std::ceil(frame.plot.width() * pixelRatio)));
    // A sample is in the middle of its column of pixels.
    const double halfPixelMm = 0.5 / (pixelRatio * frame.pxPerMm);
    const double toMm = frame.leftMm + (2.0 * columns - 1.0) * halfPixelMm;
    Section section = core::imaging::sectionOf(core::imaging::withCanals(*scene.tooth), scene.plane,
                                               frame.leftMm + halfPixelMm, toMm, columns, scene.ideal.get());
    QImage materials = tissue(section, frame, pixelRatio, scene.palette);
    materials.setDevicePixelRatio(pixelRatio);
    painter.drawImage(frame.plot.topLeft(), materials);
    return section;
}

void paintIdeal(QPainter& painter, const Section& section, const Frame& frame)
{
    // A dark line below makes the ideal line visible on every tissue.
    QPen under = idealPen();
    under.setColor(QColor::fromRgba(kIdealShade));
    under.setStyle(Qt::SolidLine);
    under.setWidthF(4.0);
    paintHeights(painter, section, frame, &SectionSample::idealTopMm, under);
    paintHeights(painter, section, frame, &SectionSample::idealTopMm, idealPen());
}

}  // namespace

void paintSection(QPainter& painter, const QRectF& area, const SectionScene& scene)
{
    painter.save();
    painter.setClipRect(area, Qt::IntersectClip);
    const Ground& ground = scene.onPaper ? kPaper : kScreen;
    painter.fillRect(area, QColor(ground.ground));
    const PictureKey key = keyOf(scene);
    const double keyPx = key.heightFor(area.width() - 16.0) + kBelowKeyPx;
    const QRectF plot = area.adjusted(kGutterPx, kHeadPx, -8.0, -kFootPx - keyPx);
    const Frame frame = frameFor(plot, scene, kAboveMm);
    painter.setRenderHint(QPainter::Antialiasing, false);
    paintGrid(painter, frame, QColor(ground.grid));

    painter.setClipRect(plot, Qt::IntersectClip);
    const Section section = paintTissue(painter, frame, scene);
    paintGrid(painter, frame, QColor::fromRgba(kOverTissue));
    painter.setRenderHint(QPainter::Antialiasing);
    if (scene.band != nullptr)
        paintBand(painter, frame, scene, section);
    if (scene.ideal)
        paintIdeal(painter, section, frame);
    paintHeights(painter, section, frame, &SectionSample::originalTopMm, surfacePen());
    if (scene.bur != nullptr)
        paintBur(painter, frame, scene);
    if (scene.markMm)
        paintMark(painter, frame, scene);
    if (!meetsTooth(section))
        paintNothingHere(painter, plot, ground);
    painter.setClipRect(area);
    paintLabels(painter, frame, QColor(ground.words));
    paintEnds(painter, QRectF(plot.left(), area.top(), plot.width(), kHeadPx), scene);
    key.paint(painter, QRectF(area.left() + 8.0, area.bottom() - keyPx, area.width() - 16.0, keyPx),
              QColor(ground.words));
    painter.restore();
}

void paintSmallSection(QPainter& painter, const QRectF& area, const SectionScene& scene)
{
    painter.save();
    painter.setClipRect(area, Qt::IntersectClip);
    painter.fillRect(area, QColor(kScreen.ground));
    const Frame frame = frameFor(area, scene, kAboveSmallMm);
    const Section section = paintTissue(painter, frame, scene);
    painter.setRenderHint(QPainter::Antialiasing);
    if (scene.ideal)
        paintIdeal(painter, section, frame);
    painter.restore();
}

}  // namespace ui::inside
