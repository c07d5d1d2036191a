// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <QGraphicsRectItem>

#include "app/cli/bench/charts/Sheet.h"

namespace app::cli::bench {
namespace {

constexpr double kLegendHeight = 48.0;
constexpr double kHeadHeight = 66.0;
constexpr double kRowTitleWidth = 140.0;
constexpr double kGroupGap = 14.0;
constexpr double kSwatchPx = 34.0;
constexpr double kInsetPx = 5.0;  ///< of what is written in a cell

/// Black or white, whichever stands out more from it.
QColor inkOn(const QColor& ground)
{
    const auto linear = [](float channel) { return std::pow(channel, 2.2F); };
    const float luminance =
        0.2126F * linear(ground.redF()) + 0.7152F * linear(ground.greenF()) + 0.0722F * linear(ground.blueF());
    return luminance > 0.18F ? inkColour() : QColor(Qt::white);
}

void addLegend(QGraphicsScene& scene, const QRectF& place, const MapChart& content)
{
    double left = place.left() + kRowTitleWidth;
    const double middle = place.top() + 0.4 * kLegendHeight;
    for (const MapChart::Finding& finding : content.findings) {
        const QColor colour(finding.colour);
        scene.addRect(left, middle - 0.5 * kSwatchPx, kSwatchPx, kSwatchPx, Qt::NoPen, colour);
        addText(scene, finding.letter, chartFont(kTextPx, true), inkOn(colour), {left + 0.5 * kSwatchPx, middle},
                Qt::AlignHCenter);
        const auto* const text =
            addText(scene, finding.name, chartFont(kTextPx), inkColour(), {left + kSwatchPx + 10.0, middle});
        left += kSwatchPx + text->boundingRect().width() + 40.0;
    }
}

}  // namespace

void add(QGraphicsScene& scene, const QRectF& place, const MapChart& content)
{
    addLegend(scene, place, content);
    const auto groups = static_cast<double>(content.groups.size());
    const auto columns = static_cast<double>(content.columns.size());
    const QRectF field(place.left() + kRowTitleWidth, place.top() + kLegendHeight + kHeadHeight,
                       place.width() - kRowTitleWidth, place.height() - kLegendHeight - kHeadHeight - 8.0);
    const double width = (field.width() - (groups - 1.0) * kGroupGap) / (groups * columns);
    const double height = field.height() / static_cast<double>(content.rows.size());
    const auto leftOf = [&](qsizetype group, qsizetype column) {
        return field.left() + static_cast<double>(group) * (columns * width + kGroupGap) +
               static_cast<double>(column) * width;
    };
    addText(scene, content.columnTitle, chartFont(kNotePx), quietColour(),
            {field.left() - 12.0, field.top() - 0.25 * kHeadHeight}, Qt::AlignRight);
    for (qsizetype g = 0; g < content.groups.size(); ++g) {
        addText(scene, content.groups[g], chartFont(kTextPx, true), inkColour(),
                {leftOf(g, 0) + 0.5 * columns * width, field.top() - 0.72 * kHeadHeight}, Qt::AlignHCenter);
        for (qsizetype c = 0; c < content.columns.size(); ++c)
            addText(scene, content.columns[c], chartFont(kNotePx), inkColour(),
                    {leftOf(g, c) + 0.5 * width, field.top() - 0.25 * kHeadHeight}, Qt::AlignHCenter);
    }
    for (qsizetype r = 0; r < content.rows.size(); ++r) {
        const double top = field.top() + static_cast<double>(r) * height;
        addText(scene, content.rows[r], chartFont(kTextPx), inkColour(), {field.left() - 12.0, top + 0.5 * height},
                Qt::AlignRight);
        for (qsizetype k = 0; k < content.cells[r].size(); ++k) {
            const MapChart::Cell& cell = content.cells[r][k];
            const MapChart::Finding& finding = content.findings[cell.finding];
            const QColor colour(finding.colour);
            const double left = leftOf(k / content.columns.size(), k % content.columns.size());
            scene.addRect(left + 1.0, top + 1.0, width - 2.0, height - 2.0, Qt::NoPen, colour);
            const double middle = top + 0.5 * height;
            const bool isAlone = cell.note.isEmpty();
            addText(scene, finding.letter, chartFont(kTextPx, true), inkOn(colour),
                    {left + (isAlone ? 0.5 * width : kInsetPx), middle}, isAlone ? Qt::AlignHCenter : Qt::AlignLeft);
            addText(scene, cell.note, chartFont(kNotePx), inkOn(colour), {left + width - kInsetPx, middle},
                    Qt::AlignRight);
        }
    }
}

}  // namespace app::cli::bench
