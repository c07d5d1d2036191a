// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/people/ClassCharts.h"

#include <algorithm>

#include <QCoreApplication>

#include "lessons/ClassStanding.h"
#include "ui/scoring/AttemptCharts.h"
#include "ui/text/PeopleTexts.h"
#include "ui/text/Texts.h"

namespace ui::people {
namespace {

using namespace ui::charts;

struct Words
{
    Q_DECLARE_TR_FUNCTIONS(ui::people::ClassCharts)
};

constexpr int kBins = 10;
constexpr int kBinTenths = 100;
constexpr double kPointsEnd = 103.0;
constexpr double kWholeScore = 100.0;

QString tooFew()
{
    return Words::tr("Shown when %1 people have tried the lesson, so that nobody can be made out.")
        .arg(::lessons::kFewestPeople);
}

}  // namespace

Chart distributionChart(const database::LessonResults& results, int passMarkTenths)
{
    Histogram histogram;
    const auto people = static_cast<int>(results.bestTenths.size());
    histogram.x = {Words::tr("Best score"), 0.0, kWholeScore};
    if (people >= ::lessons::kFewestPeople) {
        int most = 0;
        for (int bin = 0; bin < kBins; ++bin) {
            const int from = bin * kBinTenths;
            // A full score belongs to the last bin.
            const int to = bin == kBins - 1 ? from + 2 * kBinTenths : from + kBinTenths;
            const auto count = static_cast<int>(std::count_if(results.bestTenths.begin(), results.bestTenths.end(),
                                                              [&](int t) { return t >= from && t < to; }));
            most = std::max(most, count);
            histogram.bins << Histogram::Bin{from / 10.0, (from + kBinTenths) / 10.0, count,
                                             Words::tr("%1 to %2 points: %n student(s)", nullptr, count)
                                                 .arg(from / 10)
                                                 .arg((from + kBinTenths) / 10)};
        }
        if (passMarkTenths > 0)
            histogram.limits << Limit{passMarkTenths / 10.0, true, Words::tr("Pass mark")};
        histogram.count = {Words::tr("Students"), 0.0, std::max(4.0, most + 1.0), true};
    }
    return {Words::tr("Distribution"),
            people > 0 ? Words::tr("Best scores of %n student(s)", nullptr, people) : QString(), tooFew(), histogram};
}

Chart learningChart(const database::LessonResults& results, int passMarkTenths)
{
    Curve curve;
    curve.band = scoring::bandOf(results.curve);
    double last = 5.0;
    for (const Slice& slice : curve.band.slices)
        last = std::max(last, slice.x);
    curve.x = {Words::tr("Attempt"), 0.5, last + 0.5, true};
    curve.y = {Words::tr("Points"), 0.0, kPointsEnd};
    if (passMarkTenths > 0)
        curve.limits << Limit{passMarkTenths / 10.0, false, Words::tr("Pass mark")};
    // A single attempt has no area, so it is drawn as a mark.
    Line middles{{}, {}, Mark::Circle, false};
    for (const Slice& slice : curve.band.slices)
        middles.dots << Dot{slice.x, slice.middle, slice.words, 0};
    curve.lines << middles;
    return {Words::tr("Learning curve"),
            curve.band.slices.isEmpty() ? QString() : Words::tr("Of those who made so many attempts"), tooFew(), curve};
}

QString difficultyWords(const database::LessonDifficulty& difficulty)
{
    if (difficulty.people < ::lessons::kFewestPeople)
        return tooFew();
    const QString first = text::number(difficulty.meanTenths / 10.0, 1);
    if (difficulty.passed < ::lessons::kFewestPeople)
        return Words::tr("%1 of %2 passed; first attempts: %3 points")
            .arg(difficulty.passed)
            .arg(difficulty.people)
            .arg(first);
    return Words::tr("%1 of %2 passed, after %3 attempts on the average; first attempts: %4 points")
        .arg(difficulty.passed)
        .arg(difficulty.people)
        .arg(text::number(difficulty.attemptsToPass, 1), first);
}

Chart difficultyChart(const database::LessonResults& results, const std::map<std::string, QString>& names)
{
    Bars bars;
    bars.value = {Words::tr("Lost, % of what it counts"), 0.0, kWholeScore};
    bars.nameTitle = Words::tr("Criterion");
    const bool isShown = results.difficulty.people >= ::lessons::kFewestPeople;
    if (isShown)
        for (const database::LessonDifficulty::Item& item : results.difficulty.items) {
            const QString name = text::criterionName(names, item.criterion);
            bars.bars << Bars::Bar{name, kWholeScore * item.share,
                                   Words::tr("%1: the class loses %2 % of its points")
                                       .arg(name, text::number(kWholeScore * item.share, 0))};
        }
    return {Words::tr("Difficulty"), isShown ? difficultyWords(results.difficulty) : QString(), tooFew(), bars};
}

}  // namespace ui::people
