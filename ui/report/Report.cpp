// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/Report.h"

#include <QPageLayout>
#include <QPagedPaintDevice>
#include <QPainter>

namespace ui::report {
namespace {

constexpr double kPointsPerInch = 72.0;

template <typename Content>
bool paintPages(QPagedPaintDevice& device, const Content& content)
{
    QPainter painter;
    if (!painter.begin(&device))
        return false;
    painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
    const double dots = device.logicalDpiX() / kPointsPerInch;
    painter.scale(dots, dots);
    bool isWell = true;
    paint(
        painter, device.pageLayout().paintRect(QPageLayout::Point).size(), [&] { isWell = device.newPage() && isWell; },
        content);
    return painter.end() && isWell;
}

}  // namespace

bool paintOn(QPagedPaintDevice& device, const ScoreCard& card)
{
    return paintPages(device, card);
}

bool paintOn(QPagedPaintDevice& device, const ClassReport& report)
{
    return paintPages(device, report);
}

}  // namespace ui::report
