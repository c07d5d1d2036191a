// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scoring/AttemptCharts.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QCoreApplication>

#include "lessons/ClassStanding.h"
#include "ui/text/Texts.h"

namespace ui::scoring {
namespace {

using database::AttemptRecord;
using namespace ui::charts;

struct HistoryWords
{
    Q_DECLARE_TR_FUNCTIONS(ui::people::HistoryCharts)
};

constexpr qsizetype kCriteriaOver = 10;  ///< number of latest attempts that the criteria chart covers
constexpr double kMsPerMinute = 60'000.0;
constexpr double kChartEnd = 103.0;  ///< leaves room for a whole mark at 100

double points(int tenths)
{
    return 0.1 * tenths;
}

/// Returns the number of an attempt, which is its x coordinate: 1 for the oldest.
double placeOf(const ChartedAttempts& attempts, qsizetype k)
{
    return static_cast<double>(attempts.newestFirst.size() - k);
}

/// Calls `take` for each charted attempt, oldest first, with its number and the beginning of its description: "Attempt
/// 3, 20/11/2026 10:15".
template <typename Take>
void each(const ChartedAttempts& attempts, const Take& take)
{
    for (qsizetype k = std::min(kMostCharted, attempts.newestFirst.size()); k-- > 0;) {
        const AttemptRecord& record = attempts.newestFirst[k];
        const double place = placeOf(attempts, k);
        //: %1: a count; %2: date and time
        const QString which =
            attempts.isOneLesson
                ? HistoryWords::tr("Attempt %1, %2").arg(place, 0, 'f', 0).arg(text::when(record.finishedUtc))
                : QStringLiteral("%1, %2").arg(text::lessonTitle(attempts.titles, record.lessonId),
                                               text::when(record.finishedUtc));
        take(record, place, which);
    }
}

/// Returns the lesson's title if the charts cover several lessons, otherwise an empty string.
QString lessonOf(const ChartedAttempts& attempts, const AttemptRecord& record)
{
    return attempts.isOneLesson ? QString() : text::lessonTitle(attempts.titles, record.lessonId);
}

Axis xAxis(const ChartedAttempts& attempts)
{
    const qsizetype shown = std::min(kMostCharted, attempts.newestFirst.size());
    if (shown == 0)
        return {};
    const double first = placeOf(attempts, shown - 1);
    const double last = placeOf(attempts, 0);
    return {HistoryWords::tr("Attempt"), first - 0.5, std::max(last + 0.5, first + 4.5), true};
}

QString noteOf(const ChartedAttempts& attempts)
{
    const qsizetype all = attempts.newestFirst.size();
    if (all > kMostCharted)
        return HistoryWords::tr("The newest %1 of %2 attempts").arg(kMostCharted).arg(QLocale().toString(all));
    return HistoryWords::tr("%n attempt(s)", nullptr, static_cast<int>(all));
}

/// Returns "82.4 points, passed", and the computed score if a teacher has overridden it.
QString scoreWords(const AttemptRecord& record)
{
    const QString given = text::points(record.countingTenths());
    QString words = record.countsAsPassed() ? HistoryWords::tr("%1 points, passed").arg(given)
                                            : HistoryWords::tr("%1 points, not passed").arg(given);
    if (record.givenTenths)
        words += u' ' + HistoryWords::tr("(machine: %1)").arg(text::points(record.scoreTenths));
    return words;
}

QString joined(const QString& which, const QString& value)
{
    //: %1: which attempt; %2: what it came to
    return HistoryWords::tr("%1: %2").arg(which, value);
}

double end(const QList<Line>& lines)
{
    double high = 0.0;
    for (const Line& line : lines)
        for (const Dot& dot : line.dots)
            high = std::max(high, dot.y);
    return roundEnd(high * 1.02);
}

}  // namespace

Band bandOf(const std::vector<database::BandPoint>& bandPoints)
{
    Band band{HistoryWords::tr("Middle half"), HistoryWords::tr("Class median"), {}};
    for (const database::BandPoint& point : bandPoints) {
        if (point.people < ::lessons::kFewestPeople)
            continue;
        band.slices << Slice{static_cast<double>(point.attempt), points(point.lowerQuartileTenths),
                             points(point.medianTenths), points(point.upperQuartileTenths),
                             //: Of a class; %1: a count of attempts, %2: of people, %3 to %5: points
                             HistoryWords::tr("Attempt %1: median %3, middle half %4 to %5, %2 people")
                                 .arg(point.attempt)
                                 .arg(point.people)
                                 .arg(text::points(point.medianTenths), text::points(point.lowerQuartileTenths),
                                      text::points(point.upperQuartileTenths))};
    }
    return band;
}

Chart scoreChart(const ChartedAttempts& attempts)
{
    Curve curve;
    curve.ofTitle = attempts.isOneLesson ? QString() : HistoryWords::tr("Lesson");
    curve.x = xAxis(attempts);
    curve.y = {HistoryWords::tr("Points"), 0.0, kChartEnd};
    Line way{HistoryWords::tr("Score"), {}, Mark::None, true};
    Line passed{HistoryWords::tr("Passed"), {}, Mark::Circle, false};
    Line failed{HistoryWords::tr("Not passed"), {}, Mark::HollowDiamond, false};
    each(attempts, [&](const AttemptRecord& record, double place, const QString& which) {
        const Dot dot{place, points(record.countingTenths()), joined(which, scoreWords(record)), record.id,
                      lessonOf(attempts, record)};
        way.dots << dot;
        (record.countsAsPassed() ? passed : failed).dots << dot;
    });
    if (attempts.isOneLesson) {
        curve.lines << way;
        curve.band = bandOf(attempts.band);
        // Other students of the class may have made more attempts. Cuts the band off at the chart's edge.
        const auto beyond = [&](const Slice& slice) { return slice.x < curve.x.low || slice.x > curve.x.high; };
        curve.band.slices.removeIf(beyond);
        if (!attempts.newestFirst.isEmpty())
            curve.limits << Limit{points(attempts.newestFirst.front().passMarkTenths), false,
                                  HistoryWords::tr("Pass mark")};
    }
    for (const Line& line : {passed, failed})
        if (!line.dots.isEmpty())
            curve.lines << line;
    return {HistoryWords::tr("Score"), noteOf(attempts),
            HistoryWords::tr("After the first graded attempt its score is here, and then how it goes on."), curve};
}

Chart criteriaChart(const ChartedAttempts& attempts)
{
    struct Sum
    {
        int lostTenths = 0;
        int weightTenths = 0;
        int attempts = 0;        ///< number of attempts in which this criterion counts
        qsizetype counted = -1;  ///< index of the latest attempt that was counted, or -1
    };
    const auto namesOf = [&](const AttemptRecord& record) {
        const auto known = attempts.criteria.find(record.lessonId);
        return known == attempts.criteria.end() ? text::CriterionNames() : known->second;
    };
    // Sums are kept by name, because an id is unique only within its lesson.
    std::map<QString, Sum> sums;
    const qsizetype over = std::min(kCriteriaOver, attempts.newestFirst.size());
    for (qsizetype k = 0; k < over; ++k) {
        const text::CriterionNames names = namesOf(attempts.newestFirst[k]);
        for (const database::CriterionLoss& loss : attempts.newestFirst[k].criteria) {
            Sum& sum = sums[text::criterionName(names, loss.id)];
            sum.lostTenths += loss.lostTenths;
            sum.weightTenths += loss.weightTenths;
            if (std::exchange(sum.counted, k) != k)
                ++sum.attempts;
        }
    }
    Bars bars;
    bars.nameTitle = HistoryWords::tr("Criterion");
    double most = 0.0;
    for (const auto& [name, sum] : sums) {
        if (sum.weightTenths == 0 && sum.lostTenths == 0)  // a limit that the student observed
            continue;
        const double lost = 0.1 * sum.lostTenths / sum.attempts;
        most = std::max(most, lost);
        //: %1: a criterion; %2: a number
        bars.bars << Bars::Bar{name, lost, HistoryWords::tr("%1: %2 points lost").arg(name, text::number(lost, 1))};
    }
    bars.value = {HistoryWords::tr("Points lost"), 0.0, roundEnd(std::max(1.0, most))};
    std::stable_sort(bars.bars.begin(), bars.bars.end(),
                     [](const Bars::Bar& a, const Bars::Bar& b) { return a.value > b.value; });
    return {HistoryWords::tr("What costs points"),
            attempts.isOneLesson
                ? HistoryWords::tr("Average of the last %n attempt(s)", nullptr, static_cast<int>(over))
                : HistoryWords::tr("Of the last %n attempt(s), each in those where it counts", nullptr,
                                   static_cast<int>(over)),
            HistoryWords::tr("After the first graded attempt you see here which criterion costs most."), bars};
}

Chart timeChart(const ChartedAttempts& attempts)
{
    Curve curve;
    curve.ofTitle = attempts.isOneLesson ? QString() : HistoryWords::tr("Lesson");
    curve.x = xAxis(attempts);
    Line minutes{HistoryWords::tr("Minutes"), {}, Mark::Circle, attempts.isOneLesson};
    each(attempts, [&](const AttemptRecord& record, double place, const QString& which) {
        minutes.dots << Dot{place, static_cast<double>(record.durationMs) / kMsPerMinute,
                            //: %1: "12:07"
                            joined(which, HistoryWords::tr("%1 min").arg(text::clock(record.durationMs))), record.id,
                            lessonOf(attempts, record)};
    });
    curve.y = {HistoryWords::tr("Minutes"), 0.0, end({minutes})};
    minutes.name.clear();
    curve.lines << minutes;
    return {HistoryWords::tr("Time"), noteOf(attempts),
            HistoryWords::tr("After the first graded attempt you see here how long it took."), curve};
}

Chart forceChart(const ChartedAttempts& attempts)
{
    Curve curve;
    curve.ofTitle = attempts.isOneLesson ? QString() : HistoryWords::tr("Lesson");
    curve.x = xAxis(attempts);
    Line mean{HistoryWords::tr("Mean"), {}, Mark::Circle, attempts.isOneLesson};
    Line peak{HistoryWords::tr("Highest"), {}, Mark::Square, attempts.isOneLesson, {}, Qt::DashLine};
    each(attempts, [&](const AttemptRecord& record, double place, const QString& which) {
        const double meanN = 0.001 * record.meanForceMn;
        const double peakN = 0.001 * record.peakForceMn;
        const QString words = joined(which, HistoryWords::tr("mean %1 N, highest %2 N while cutting")
                                                .arg(text::number(meanN, 2), text::number(peakN, 2)));
        mean.dots << Dot{place, meanN, words, record.id, lessonOf(attempts, record)};
        peak.dots << Dot{place, peakN, words, record.id, lessonOf(attempts, record)};
    });
    curve.y = {HistoryWords::tr("Newtons"), 0.0, end({mean, peak})};
    curve.lines << mean << peak;
    return {HistoryWords::tr("Force while cutting"), noteOf(attempts),
            HistoryWords::tr("After the first graded attempt you see here how hard the bur was pressed."), curve};
}

Chart speedChart(const ChartedAttempts& attempts)
{
    Curve curve;
    curve.ofTitle = attempts.isOneLesson ? QString() : HistoryWords::tr("Lesson");
    Line passed{HistoryWords::tr("Passed"), {}, Mark::Circle, false};
    Line failed{HistoryWords::tr("Not passed"), {}, Mark::HollowDiamond, false};
    double longest = 0.0;
    each(attempts, [&](const AttemptRecord& record, double, const QString& which) {
        const double minutes = static_cast<double>(record.durationMs) / kMsPerMinute;
        longest = std::max(longest, minutes);
        (record.countsAsPassed() ? passed : failed).dots << Dot{
            minutes, points(record.countingTenths()),
            joined(which, HistoryWords::tr("%1 in %2 min").arg(scoreWords(record), text::clock(record.durationMs))),
            record.id, lessonOf(attempts, record)};
    });
    if (attempts.medians && attempts.medians->people >= ::lessons::kFewestPeople) {
        const double minutes = static_cast<double>(attempts.medians->durationMs) / kMsPerMinute;
        longest = std::max(longest, minutes);
        curve.limits << Limit{minutes, true, HistoryWords::tr("Class median, time")}
                     << Limit{points(attempts.medians->tenths), false, HistoryWords::tr("Class median, points")};
    }
    curve.x = {HistoryWords::tr("Minutes"), 0.0, roundEnd(1.02 * longest)};
    curve.y = {HistoryWords::tr("Points"), 0.0, kChartEnd};
    for (const Line& line : {passed, failed})
        if (!line.dots.isEmpty())
            curve.lines << line;
    return {HistoryWords::tr("Speed and accuracy"), HistoryWords::tr("Good and quick is at the top left"),
            HistoryWords::tr("After the first graded attempt you see here time against points."), curve};
}

}  // namespace ui::scoring
