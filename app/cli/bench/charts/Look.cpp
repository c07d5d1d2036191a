// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/bench/charts/Look.h"

#include <array>

#include <QFontDatabase>

namespace app::cli::bench {

const Look& lookOf(LookIndex index)
{
    // Colours: Okabe & Ito 2008, but for their yellow, which is too pale for a line on white.
    static const std::array<Look, 6> looks{{
        {QColor(0x00, 0x72, 0xB2), QScatterSeries::MarkerShapeCircle, Qt::SolidLine, Qt::SolidPattern},
        {QColor(0xD5, 0x5E, 0x00), QScatterSeries::MarkerShapeRectangle, Qt::DashLine, Qt::BDiagPattern},
        {QColor(0x00, 0x9E, 0x73), QScatterSeries::MarkerShapeTriangle, Qt::DotLine, Qt::CrossPattern},
        {QColor(0xCC, 0x79, 0xA7), QScatterSeries::MarkerShapeRotatedRectangle, Qt::DashDotLine, Qt::FDiagPattern},
        {QColor(0xE6, 0x9F, 0x00), QScatterSeries::MarkerShapePentagon, Qt::DashDotDotLine, Qt::HorPattern},
        {QColor(0x56, 0xB4, 0xE9), QScatterSeries::MarkerShapeStar, Qt::DashLine, Qt::VerPattern},
    }};
    return looks[static_cast<std::size_t>(index) % looks.size()];
}

QFont chartFont(int pixels, bool bold)
{
    static const QString family = QFontDatabase::families().contains(QStringLiteral("Inter"))
                                      ? QStringLiteral("Inter")
                                      : QStringLiteral("DejaVu Sans");
    QFont font(family);
    font.setPixelSize(pixels);
    font.setBold(bold);
    return font;
}

QColor inkColour()
{
    return {0x1B, 0x1F, 0x24};
}

QColor quietColour()
{
    return {0x55, 0x5B, 0x62};
}

QColor gridColour()
{
    return {0xDD, 0xE0, 0xE3};
}

QColor limitColour()
{
    return {0x1B, 0x1F, 0x24};
}

}  // namespace app::cli::bench
