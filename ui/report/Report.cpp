// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/Report.h"

#include <QPageLayout>
#include <QPagedPaintDevice>
#include <QPainter>
#include <QPicture>

namespace ui::report {
namespace {

constexpr double kPointsPerInch = 72.0;

/// Runs the content once without painting, to count its pages.
template <typename Content>
Content counted(Content content, const QSizeF& pagePt)
{
    QPicture nothing;
    QPainter painter(&nothing);
    content.proof.pages = paint(painter, pagePt, {}, content);
    return content;
}

template <typename Content>
bool paintPages(QPagedPaintDevice& device, const Content& content)
{
    const QSizeF pagePt = device.pageLayout().paintRect(QPageLayout::Point).size();
    QPainter painter;
    if (!painter.begin(&device))
        return false;
    painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
    const double dots = device.logicalDpiX() / kPointsPerInch;
    painter.scale(dots, dots);
    bool isWell = true;
    paint(
        painter, pagePt, [&] { isWell = device.newPage() && isWell; }, counted(content, pagePt));
    return painter.end() && isWell;
}

}  // namespace

bool paintOn(QPagedPaintDevice& device, const scoring::ScoreCard& card)
{
    return paintPages(device, card);
}

bool paintOn(QPagedPaintDevice& device, const ClassReport& report)
{
    return paintPages(device, report);
}

}  // namespace ui::report
