// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include <QImage>
#include <QRect>
#include <QString>
#include <QtGlobal>

#include "core/servo/ServoState.h"

/// Statistics of pictures. The bytes are not compared, because no two drivers draw the same ones.
namespace pictures {

/// Writes the picture to the folder CUSP_PICTURES, for inspection. Does nothing if that is not set.
inline void keep(const QImage& image, const QString& name)
{
    if (const QString folder = qEnvironmentVariable("CUSP_PICTURES"); !folder.isEmpty())
        image.save(folder + '/' + name + QStringLiteral(".png"));
}

struct Colour
{
    double red = 0.0;
    double green = 0.0;
    double blue = 0.0;
    [[nodiscard]] double brightness() const { return (red + green + blue) / 3.0; }
};

/// Returns the mean colour of the part of `area` inside the image, 0 .. 255 a channel.
inline Colour mean(const QImage& image, const QRect& area)
{
    Colour sum;
    const QRect inside = area.intersected(image.rect());
    for (int y = inside.top(); y <= inside.bottom(); ++y) {
        for (int x = inside.left(); x <= inside.right(); ++x) {
            const QRgb pixel = image.pixel(x, y);
            sum.red += qRed(pixel);
            sum.green += qGreen(pixel);
            sum.blue += qBlue(pixel);
        }
    }
    const double count = std::max(1, inside.width() * inside.height());
    return {sum.red / count, sum.green / count, sum.blue / count};
}

/// Returns the square of pixels around a point.
inline QRect around(double x, double y, int reach)
{
    return {qRound(x) - reach, qRound(y) - reach, 2 * reach + 1, 2 * reach + 1};
}

inline bool differs(QRgb p, QRgb q, int threshold)
{
    return std::max({std::abs(qRed(p) - qRed(q)), std::abs(qGreen(p) - qGreen(q)), std::abs(qBlue(p) - qBlue(q))}) >
           threshold;
}

/// The number of pixels in which two pictures differ by more than `threshold` in a channel, and their bounding box.
struct Difference
{
    int pixels = 0;
    QRect box;
};
inline Difference difference(const QImage& a, const QImage& b, int threshold = 10)
{
    Difference found;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            if (differs(a.pixel(x, y), b.pixel(x, y), threshold)) {
                ++found.pixels;
                found.box |= QRect(x, y, 1, 1);
            }
        }
    }
    return found;
}

/// Returns the number of pixels for which `fits` returns true.
template <class Fits>
int count(const QImage& image, const Fits& fits)
{
    int found = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            found += fits(image.pixel(x, y)) ? 1 : 0;
    return found;
}

/// Returns the tile of the grid that contains a point, with every height above `floorMm` lowered to it.
inline core::servo::TilePatch cutTile(const core::terrain::ToothAnatomy& tooth, glm::dvec2 pointMm, float floorMm,
                                      std::uint64_t generation = 1, bool last = true)
{
    constexpr int kSide = core::servo::kTileSide;
    const glm::ivec2 tile = glm::ivec2(tooth.grid.latticeOf(pointMm)) / kSide;
    core::servo::TilePatch patch;
    patch.toothGeneration = generation;
    patch.tileX = static_cast<std::uint16_t>(tile.x);
    patch.tileY = static_cast<std::uint16_t>(tile.y);
    patch.last = last;
    for (std::size_t k = 0; k < patch.top.size(); ++k) {
        const int i = tile.x * kSide + static_cast<int>(k) % kSide;
        const int j = tile.y * kSide + static_cast<int>(k) / kSide;
        patch.top[k] =
            tooth.grid.contains(i, j) ? std::min(tooth.top[tooth.grid.index(i, j)], floorMm) : core::terrain::kEmptyTop;
    }
    return patch;
}

/// Returns the middle of the tile that contains a point.
inline glm::dvec2 tileMiddle(const core::terrain::Grid& grid, glm::dvec2 pointMm)
{
    constexpr int kSide = core::servo::kTileSide;
    const glm::ivec2 first = glm::ivec2(grid.latticeOf(pointMm)) / kSide * kSide;
    return grid.nodeMm(first.x, first.y) + glm::dvec2(0.5 * (kSide - 1) * grid.cellMm);
}

}  // namespace pictures
