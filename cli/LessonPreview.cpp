// SPDX-License-Identifier: GPL-3.0-or-later
// `cusp lesson preview`: the task of a lesson on one sheet.
#include <algorithm>
#include <numbers>

#include <QFileInfo>
#include <QImage>
#include <QLocale>
#include <QPainter>
#include <QTextDocument>

#include "app/threads/Display.h"
#include "cli/Commands.h"
#include "cli/parts/Arguments.h"
#include "cli/parts/LessonParts.h"
#include "cli/render/Pictures.h"
#include "lessons/Assignment.h"
#include "lessons/IdealFromRecordings.h"
#include "lessons/LessonCatalog.h"
#include "ui/catalog/LessonScene.h"
#include "ui/inside/OutlinePainter.h"
#include "ui/inside/SectionPainter.h"
#include "ui/kit/Theme.h"
#include "ui/text/LessonTexts.h"

namespace cli {
namespace {

constexpr int kGapPx = 12;
constexpr double kPicturesShare = 0.56;  ///< of the sheet's height

QString english(const lessons::LocalText& text)
{
    return QString::fromStdString(lessons::inLanguage(text, "en"));
}

/// Returns goal, facts and rubric, as on the page of lessons.
QString sheetText(const lessons::Lesson& lesson)
{
    const auto escaped = [](const QString& words) { return words.toHtmlEscaped(); };
    QString html = QStringLiteral("<p style='font-size:14px'>%1</p>").arg(escaped(english(lesson.goal)));
    html += QStringLiteral("<p><b>Tooth</b> %1 &nbsp; <b>Time</b> %2 &nbsp; <b>Burs</b> %3 &nbsp; <b>Aids</b> %4%5</p>")
                .arg(escaped(ui::text::toothWords(lesson)), escaped(ui::text::timeWords(lesson)),
                     escaped(ui::text::burWords(lesson)), escaped(ui::text::aidWords(lesson.aids)),
                     lesson.exam ? QStringLiteral(" &nbsp; <b>Exam</b>") : QString());
    html += QStringLiteral("<p><b>%1</b>, passed from %2 of 100</p><table cellspacing='0' cellpadding='1'>")
                .arg(escaped(english(lesson.rubric.title)))
                .arg(0.1 * lesson.rubric.passMarkTenths, 0, 'f', 1);
    for (const lessons::CriterionRule& rule : lesson.rubric.criteria)
        html += QStringLiteral("<tr><td>%1&nbsp;&nbsp;</td><td>%2</td></tr>")
                    .arg(escaped(ui::text::titleOf(rule)), escaped(ui::text::ruleWords(rule)));
    html += QStringLiteral("</table>");
    if (!lesson.notModelled.empty())
        html += QStringLiteral("<p><i>Not modelled: %1</i></p>").arg(escaped(english(lesson.notModelled)));
    return html;
}

void paintText(QPainter& painter, const QRectF& area, const lessons::Lesson& lesson)
{
    QTextDocument document;
    document.setDefaultFont(ui::kit::typeface(ui::kit::kSmall));
    document.setDefaultStyleSheet(QStringLiteral("p, td { margin: 2px 0 4px 0; }"));
    document.setTextWidth(area.width());
    document.setHtml(sheetText(lesson));
    // A long rubric is scaled down, so that it is complete.
    const double scale = std::min(1.0, area.height() / document.size().height());
    document.setTextWidth(area.width() / scale);
    painter.save();
    painter.translate(area.topLeft());
    painter.scale(scale, scale);
    document.drawContents(&painter);
    painter.restore();
}

core::Result<QImage> sheetOf(const lessons::Lesson& lesson, QSize size)
{
    const auto assigned = lessons::assign(lesson);
    if (!assigned)
        return tl::unexpected(assigned.error());
    const lessons::Assignment& assignment = assigned->assignment;
    const core::terrain::ToothAnatomy& anatomy = *assignment.anatomy;
    const core::grading::IdealTop ideal = assignment.shownIdeal();
    const core::terrain::Tooth whole(assignment.anatomy);

    QImage sheet(size, QImage::Format_RGB32);
    sheet.fill(Qt::white);
    QPainter painter(&sheet);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF page = QRectF(sheet.rect()).adjusted(kGapPx, kGapPx, -kGapPx, -kGapPx);
    painter.setFont(ui::kit::typeface(ui::kit::kTitle, QFont::DemiBold));
    painter.drawText(page, Qt::AlignLeft | Qt::AlignTop, english(lesson.title));
    const double top = page.top() + 30.0;
    const double wide = (page.width() - 2.0 * kGapPx) / 3.0;
    const auto place = [&](int k) {
        return QRectF(page.left() + k * (wide + kGapPx), top, wide, kPicturesShare * page.height());
    };
    const RenderSubject prepared{ideal ? core::terrain::restored(assignment.anatomy, *ideal) : whole, std::nullopt,
                                 ideal};
    auto inSpace = rendered(prepared, {}, QStringLiteral("above"), place(0).size().toSize());
    if (!inSpace)
        return inSpace;
    painter.drawImage(place(0).topLeft(), *inSpace);

    const auto tolerances = lessons::tolerancesOf(lesson.rubric);
    core::imaging::SectionPlane plane{anatomy.grid.middleMm(), 0.5 * std::numbers::pi};
    if (const auto throughDecay = ui::catalog::planeThroughDecay(whole))
        plane = *throughDecay;
    std::optional<core::preparation::ToleranceBand> band;
    if (assignment.ideal) {
        band = core::preparation::toleranceBand(anatomy, *assignment.ideal, tolerances.outlineMm, tolerances.depthMm);
        plane = ui::catalog::planeThroughIdeal(anatomy, *assignment.ideal);
    }
    const ui::inside::FromAbove above = ui::inside::fromAbove(anatomy, ideal ? *ideal : anatomy.top);
    ui::inside::paintOutline(painter, place(1), {&anatomy, &above, band ? tolerances.outlineMm : 0.0, 0.0, plane});
    ui::inside::SectionScene section;
    section.tooth = &whole;
    section.plane = plane;
    section.ideal = ideal;
    section.band = band ? &*band : nullptr;
    ui::inside::paintSection(painter, place(2), section);
    paintText(painter,
              QRectF(page.left(), place(0).bottom() + 8.0, page.width(), page.bottom() - place(0).bottom() - 8.0),
              lesson);
    return sheet;
}

}  // namespace

int previewLessonPart(const QStringList& arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral(
        "Draws what a lesson asks for on one sheet: the tooth as it is to become, the ideal with its tolerances from "
        "above and in section, goal and rubric in words. Without a display it makes one of its own by xvfb-run."));
    parser.addPositionalArgument(QStringLiteral("FILE|ID"), QStringLiteral("A lesson's file or id."));
    parser.addOption({QStringLiteral("out"), QStringLiteral("The picture."), QStringLiteral("PICTURE.png")});
    parser.addOption({QStringLiteral("size"), QStringLiteral("Of the picture in pixels; 1280x800 if not given."),
                      QStringLiteral("WxH"), QStringLiteral("1280x800")});
    const QString usage = QStringLiteral("cusp lesson preview FILE|ID --out PICTURE.png [--size WxH]");
    if (const auto code = parse(parser, arguments, usage))
        return *code;
    const QString out = parser.value(QStringLiteral("out"));
    if (parser.positionalArguments().size() != 1 || !out.endsWith(QStringLiteral(".png"), Qt::CaseInsensitive))
        return wrongUsage(QStringLiteral("name one lesson, and --out with a picture that ends in .png; usage: ") +
                          usage);
    const auto size = pictureSize(parser.value(QStringLiteral("size")));
    constexpr int kLeastWidePx = 600;
    constexpr int kLeastHighPx = 400;
    if (!size || size->width() < kLeastWidePx || size->height() < kLeastHighPx)
        return wrongUsage(QStringLiteral("--size wants width x height in pixels, 600x400 to 8192x8192"));
    const auto lesson = lessons::lessonNamed(parser.positionalArguments().front());
    if (!lesson)
        return failed(lesson.error());
    if (!app::hasDisplay()) {
        const int code =
            app::runOnDisplay(QStringList{QStringLiteral("lesson"), QStringLiteral("preview")} + arguments, false);
        return code >= 0 ? code
                         : failed({core::ErrorCode::FileUnreadable,
                                   "A picture needs a display with OpenGL 3.3, or xvfb-run (Debian package xvfb)"});
    }
    QLocale::setDefault(QLocale::c());
    const auto sheet = sheetOf(*lesson, *size);
    if (!sheet)
        return failed(sheet.error());
    const core::Status saved = savePng(*sheet, out);
    return saved ? kDone : failed(saved.error());
}

}  // namespace cli
