// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>

#include <QCoreApplication>
#include <QLocale>
#include <QTextBoundaryFinder>

#include "ui/kit/Theme.h"
#include "ui/people/ClassCharts.h"
#include "ui/people/ClassModel.h"
#include "ui/report/Report.h"
#include "ui/report/Sheet.h"
#include "ui/text/Texts.h"

namespace ui::report {
namespace {

using people::Need;

struct Words
{
    Q_DECLARE_TR_FUNCTIONS(ui::report::ClassReport)
};

constexpr double kNamePt = 130.0;
constexpr double kLastPt = 48.0;
constexpr double kCellPt = 44.0;  ///< minimum; the longest word of a title may need more
constexpr double kCellGapPt = 4.0;
constexpr double kRowPt = 14.0;
constexpr double kHeadsPt = 47.0;   ///< height of four lines of a lesson's title and its due date
constexpr double kTitlesPt = 44.0;  ///< height of the matrix's title and legend
constexpr int kBegunRows = 8;       ///< least number of rows on the page where a part begins
constexpr double kChartPt = 150.0;
constexpr int kShownHash = 16;

/// Paints the names of the students who need help, by kind of need.
void paintNeeds(Sheet& sheet, const people::ClassModel& model)
{
    const auto list = [&](Need need, const QString& what) {
        QStringList names;
        for (int row = 0; row < model.rowCount(); ++row)
            if (model.needs(row, need))
                names << people::nameOf(model.overview().students[static_cast<std::size_t>(row)]);
        if (!names.isEmpty())
            //: %1: what they need; %2: names
            sheet.say(Words::tr("%1: %2").arg(what, names.join(QStringLiteral("; "))), kTextPt);
    };
    list(Need::NoneLeft, Words::tr("No attempts left at a lesson that is not passed"));
    list(Need::Stuck, Words::tr("Stuck (three attempts in a row, not passed, not better by five points)"));
    list(Need::NeverLoggedIn, Words::tr("Never logged in"));
    list(Need::Late, Words::tr("Late: a lesson is overdue and not passed"));
    list(Need::NotBegun, Words::tr("Logged in, no graded attempt yet"));
}

/// Returns a date in numbers, because "yesterday" on paper is soon wrong.
QString day(const std::string& utc)
{
    const QDateTime at = text::momentOf(utc);
    return at.isValid() ? QLocale().toString(at.toLocalTime().date(), QLocale::ShortFormat) : QStringLiteral("–");
}

/// Paints the title of the matrix. It is repeated on every page that begins with the matrix.
void paintTitle(Sheet& sheet)
{
    sheet.head(Words::tr("Best scores"), kHeadsPt);
    sheet.say(Words::tr("✓: passed; ▲: overdue, or no attempts left; ⚠: does not match its recording; ▲ behind a "
                        "name: needs the teacher"),
              kTextPt);
    sheet.skip(2.0);
}

/// Returns the text of a cell as on the screen, with its signs.
QString cellWords(const people::ClassModel& model, const QModelIndex& index)
{
    QString words = model.data(index, Qt::DisplayRole).toString();
    if (model.cell(index)->passed)
        words += QStringLiteral(" ✓");
    if (model.isLate(index) || model.hasNoneLeft(index))
        words.prepend(QStringLiteral("▲ "));
    return words;
}

/// Returns the width of a lesson's column, in which no word of a title and no score is cut.
double cellWidth(Sheet& sheet, const people::ClassModel& model, int lessons)
{
    const QString score = text::points(::lessons::kFullTenths) + QStringLiteral(" ✓");
    double widest = std::max(kCellPt, kCellGapPt + sheet.widthOf(score, kTextPt, QFont::DemiBold));
    for (int k = 0; k < lessons; ++k) {
        const QString title =
            model.headerData(people::ClassModel::kFirstLesson + k, Qt::Horizontal, Qt::DisplayRole).toString();
        QTextBoundaryFinder finder(QTextBoundaryFinder::Line, title);
        for (qsizetype from = 0, to = finder.toNextBoundary(); to > from; from = to, to = finder.toNextBoundary())
            widest = std::max(
                widest, kCellGapPt + sheet.widthOf(title.mid(from, to - from).trimmed(), kSmallPt, QFont::DemiBold));
    }
    return std::min(widest, sheet.width() - kNamePt - kLastPt);
}

/// Paints the part of the matrix with as many lessons as fit the page's width. The next part begins below it if there
/// is room for some rows.
void paintPart(Sheet& sheet, const people::ClassModel& model, double cellPt, int first, int count)
{
    const auto heads = [&] {
        if (sheet.top() == 0.0)
            paintTitle(sheet);
        const double top = sheet.top();
        const auto head = [&](double left, double wide, int column, int flags) {
            sheet.put(QRectF(left, top, wide - 3.0, kHeadsPt),
                      model.headerData(column, Qt::Horizontal, Qt::DisplayRole).toString(), kSmallPt, QFont::DemiBold,
                      flags | Qt::AlignBottom | Qt::TextWordWrap);
        };
        head(kNamePt, kLastPt, people::ClassModel::kLast, Qt::AlignLeft);
        for (int k = 0; k < count; ++k)
            head(kNamePt + kLastPt + k * cellPt, cellPt, people::ClassModel::kFirstLesson + first + k,
                 Qt::AlignHCenter);
        sheet.skip(kHeadsPt + 2.0);
        sheet.rule();
    };
    sheet.need(kTitlesPt + kHeadsPt + kRowPt * std::min(model.rowCount(), kBegunRows));
    if (first == 0 && sheet.top() > 0.0)
        paintTitle(sheet);
    heads();
    for (int row = 0; row < model.rowCount(); ++row) {
        if (sheet.left() < kRowPt) {
            sheet.need(kRowPt);
            heads();
        }
        const QRectF name(0.0, sheet.top(), kNamePt - 4.0, kRowPt);
        QPainter& painter = sheet.painter();
        painter.setFont(paperFont(kTextPt));
        const QString whole = model.headerData(row, Qt::Vertical, Qt::DisplayRole).toString();
        sheet.put(name, people::shortened(whole, painter.fontMetrics(), static_cast<int>(name.width())), kTextPt,
                  QFont::Normal, Qt::AlignLeft | Qt::AlignVCenter);
        sheet.put(QRectF(kNamePt, sheet.top(), kLastPt, kRowPt),
                  day(model.overview().students[static_cast<std::size_t>(row)].lastAttemptUtc), kSmallPt, QFont::Normal,
                  Qt::AlignLeft | Qt::AlignVCenter);
        for (int k = 0; k < count; ++k) {
            const QModelIndex index = model.index(row, people::ClassModel::kFirstLesson + first + k);
            const database::MatrixCell& cell = *model.cell(index);
            const QRectF box(kNamePt + kLastPt + k * cellPt, sheet.top(), cellPt - 1.0, kRowPt - 1.0);
            if (cell.attempts > 0) {
                // A higher score is darker, but light enough for black text.
                const int grey = 250 - cell.bestTenths * 70 / 1000;
                painter.fillRect(box, QColor(grey, grey, grey));
            }
            sheet.put(box, cellWords(model, index), kTextPt, cell.passed ? QFont::DemiBold : QFont::Normal,
                      Qt::AlignCenter);
        }
        sheet.skip(kRowPt);
    }
    sheet.skip(kRowPt);
}

}  // namespace

int paint(QPainter& painter, const QSizeF& pagePt, const NextPage& next, const ClassReport& report)
{
    people::ClassModel model(nullptr);
    model.setOverview(report.overview, report.proof.printed);
    model.setAssignments(report.given);
    model.setTitles(report.titles);
    Sheet sheet(painter, pagePt, next, report.className, report.proof);
    sheet.say(Words::tr("Class: %1").arg(report.className), kTitlePt, QFont::DemiBold);
    const QString students = Words::tr("%n student(s)", nullptr, model.rowCount());
    sheet.say(report.teacher.isEmpty() ? students : QStringLiteral("%1, %2").arg(report.teacher, students), kHeadPt);
    sheet.skip(4.0);
    paintNeeds(sheet, model);

    if (!report.results.lessonId.empty()) {
        sheet.head(Words::tr("The class at: %1").arg(text::lessonTitle(report.titles, report.results.lessonId)),
                   kChartPt);
        sheet.chartRow({people::distributionChart(report.results, report.passMarkTenths),
                        people::learningChart(report.results, report.passMarkTenths)},
                       kChartPt);
        sheet.chart(people::difficultyChart(report.results, report.criteria), kChartPt);
        if (!report.rubricHash.empty())
            sheet.say(Words::tr("Rubric: %1, version %2, content %3")
                          .arg(QString::fromStdString(
                                   lessons::inLanguage(report.rubricTitle, QLocale().name().toStdString())),
                               QString::number(report.rubricVersion),
                               QString::fromStdString(report.rubricHash).left(kShownHash)),
                      kTextPt);
    }

    const auto lessons = static_cast<int>(report.overview.lessons.size());
    const double cellPt = cellWidth(sheet, model, lessons);
    const int most = std::max(1, static_cast<int>((pagePt.width() - kNamePt - kLastPt) / cellPt));
    const int parts = std::max(1, (lessons + most - 1) / most);
    const int each = std::max(1, (lessons + parts - 1) / parts);
    for (int first = 0; first < lessons; first += each)
        paintPart(sheet, model, cellPt, first, std::min(each, lessons - first));
    return sheet.pages();
}

}  // namespace ui::report
