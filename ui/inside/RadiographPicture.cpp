// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inside/RadiographPicture.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace ui::inside {
namespace {

/// A share of the light box's light as the screen wants it (sRGB).
int grey(double light)
{
    const double shown = light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1.0 / 2.4) - 0.055;
    return static_cast<int>(std::lround(255.0 * std::clamp(shown, 0.0, 1.0)));
}

}  // namespace

QImage radiographPicture(std::span<const core::imaging::XrayedTooth> teeth, const core::imaging::Beam& beam,
                         const core::imaging::FilmArea& area, double pixelMm, const core::imaging::Exposure& exposure)
{
    const core::imaging::Shadow shadow = core::imaging::castShadow(teeth, beam, area, pixelMm);
    const std::vector<float> quanta = core::imaging::quantaOn(shadow, exposure);
    const double brightest = core::imaging::lightThroughFilm(0.0, pixelMm);
    QImage picture(shadow.width, shadow.height, QImage::Format_Grayscale8);
    for (int row = 0; row < shadow.height; ++row) {
        uchar* line = picture.scanLine(row);
        for (int column = 0; column < shadow.width; ++column) {
            const auto k = static_cast<std::size_t>(row) * static_cast<std::size_t>(shadow.width) +
                           static_cast<std::size_t>(column);
            line[column] = static_cast<uchar>(
                grey(core::imaging::lightThroughFilm(static_cast<double>(quanta[k]), pixelMm) / brightest));
        }
    }
    return picture;
}

}  // namespace ui::inside
