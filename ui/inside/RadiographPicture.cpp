// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inside/RadiographPicture.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/imaging/Canals.h"

namespace ui::inside {
namespace {

/// Density window of the scanner. In a correctly exposed film nothing of a tooth has less than the white density. Air
/// has the black density, or less where the tooth needs little radiation.
constexpr double kWhiteDensity = 0.6;
constexpr double kBlackDensity = 2.95;

int grey(double density, double blackDensity)
{
    const double shown = (blackDensity - density) / (blackDensity - kWhiteDensity);
    return static_cast<int>(std::lround(255.0 * std::clamp(shown, 0.0, 1.0)));
}

}  // namespace

bool isUpper(int fdi)
{
    return fdi / 10 == 1 || fdi / 10 == 2;
}

QImage radiographPicture(std::span<const core::imaging::XrayedTooth> teeth, const core::imaging::Beam& beam,
                         const core::imaging::FilmArea& area, double pixelMm, const core::imaging::Exposure& exposure)
{
    if (teeth.empty())
        return {};
    const core::terrain::ToothAnatomy& first = *teeth.front().tooth->anatomy;
    std::vector<core::terrain::Tooth> whole;
    std::vector<core::imaging::XrayedTooth> pictured(teeth.begin(), teeth.end());
    whole.reserve(teeth.size());
    for (core::imaging::XrayedTooth& xrayed : pictured) {
        whole.push_back(core::imaging::withCanals(*xrayed.tooth));
        xrayed.tooth = &whole.back();
    }
    const core::imaging::Shadow shadow = core::imaging::castShadow(pictured, beam, area, pixelMm);
    core::imaging::Exposure given = exposure;
    const double usual = core::imaging::usualExposure(first, beam);
    given.relative *= usual;
    const double black =
        std::min(kBlackDensity,
                 core::imaging::opticalDensity(core::imaging::kQuantaPerMm2 * usual * pixelMm * pixelMm, pixelMm));
    const std::vector<float> quanta = core::imaging::quantaOn(shadow, given);
    QImage picture(shadow.width, shadow.height, QImage::Format_Grayscale8);
    for (int row = 0; row < shadow.height; ++row) {
        uchar* line = picture.scanLine(row);
        for (int column = 0; column < shadow.width; ++column) {
            const auto k = static_cast<std::size_t>(row) * static_cast<std::size_t>(shadow.width) +
                           static_cast<std::size_t>(column);
            const double density = core::imaging::opticalDensity(static_cast<double>(quanta[k]), pixelMm);
            line[column] = static_cast<uchar>(grey(density, black));
        }
    }
    return isUpper(first.fdi) ? picture.mirrored(false, true) : picture;
}

}  // namespace ui::inside
