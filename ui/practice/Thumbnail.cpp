// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/practice/Thumbnail.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace ui::practice {
namespace {

const glm::vec3 kLight = glm::normalize(glm::vec3(-0.5F, 0.6F, 0.8F));
constexpr float kDark = 0.35F;
constexpr float kTint = 0.45F;
constexpr float kCutMm = 0.02F;  ///< a shallower cut is a scratch
constexpr int kFiner = 2;        ///< each side is drawn with so many times the pixels, to avoid jagged edges

/// Returns the slope at a node, or 0 at the edge of the tooth.
float rise(const core::terrain::Grid& grid, std::span<const float> top, int i, int j, int di, int dj)
{
    if (!grid.contains(i + di, j + dj) || !grid.contains(i - di, j - dj))
        return 0.0F;
    const float ahead = top[grid.index(i + di, j + dj)];
    const float behind = top[grid.index(i - di, j - dj)];
    if (ahead <= core::terrain::kEmptyTop || behind <= core::terrain::kEmptyTop)
        return 0.0F;
    return (ahead - behind) / (2.0F * static_cast<float>(grid.cellMm * std::max(di, dj)));
}

QRgb shaded(QRgb colour, float light)
{
    const auto part = [light](int value) { return static_cast<int>(light * static_cast<float>(value)); };
    return qRgb(part(qRed(colour)), part(qGreen(colour)), part(qBlue(colour)));
}

QRgb tinted(QRgb colour, QRgb tint)
{
    const auto part = [](int from, int to) {
        return static_cast<int>((1.0F - kTint) * static_cast<float>(from) + kTint * static_cast<float>(to));
    };
    return qRgb(part(qRed(colour), qRed(tint)), part(qGreen(colour), qGreen(tint)), part(qBlue(colour), qBlue(tint)));
}

QImage drawn(const core::terrain::ToothAnatomy& anatomy, std::span<const float> top, int sidePx,
             const ThumbnailColours& colours)
{
    QImage image(sidePx, sidePx, QImage::Format_RGB32);
    const core::terrain::Grid& grid = anatomy.grid;
    const double cells = static_cast<double>(grid.side) / sidePx;
    const int reach = std::max(1, static_cast<int>(std::lround(0.5 * cells)));
    for (int y = 0; y < sidePx; ++y) {
        for (int x = 0; x < sidePx; ++x) {
            const int i = std::min(grid.side - 1, static_cast<int>((x + 0.5) * cells));
            const int j = std::min(grid.side - 1, static_cast<int>((sidePx - y - 0.5) * cells));
            const std::size_t k = grid.index(i, j);
            if (top[k] <= core::terrain::kEmptyTop) {
                image.setPixel(x, y, colours.beside);
                continue;
            }
            const glm::vec3 normal =
                glm::normalize(glm::vec3(-rise(grid, top, i, j, reach, 0), -rise(grid, top, i, j, 0, reach), 1.0F));
            const float light = kDark + (1.0F - kDark) * std::max(0.0F, glm::dot(normal, kLight));
            const auto material = core::terrain::materialAt(anatomy.layers[k], top[k]);
            QRgb colour = colours.materials.at(static_cast<std::size_t>(material));
            if (top[k] < anatomy.top[k] - kCutMm)
                colour = tinted(colour, colours.cut);
            image.setPixel(x, y, shaded(colour, std::min(1.0F, light)));
        }
    }
    return image;
}

}  // namespace

QImage thumbnail(const core::terrain::ToothAnatomy& anatomy, std::span<const float> top, int sidePx,
                 const ThumbnailColours& colours)
{
    return drawn(anatomy, top, kFiner * sidePx, colours)
        .scaled(sidePx, sidePx, Qt::IgnoreAspectRatio, Qt::SmoothTransformation)
        .convertToFormat(QImage::Format_RGB16);
}

}  // namespace ui::practice
