// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "app/attempt/Demonstration.h"
#include "bench/InParallel.h"
#include "bench/Spoiling.h"
#include "bench/Suites.h"
#include "haptics/simulated/DecayCavity.h"
#include "lessons/Assignment.h"
#include "lessons/LessonCatalog.h"

namespace bench {
namespace {

/// A student's error, and the letter that a strict instructor gives for it (docs/marks.md): D and F fail.
struct Fault
{
    const char* what;
    char letter;
    void (*spoil)(Spoiling&);
};

constexpr Fault kOfAny[] = {
    {"as it ought to be", 'A', [](Spoiling&) {}},
    {"nothing done", 'F',
     [](Spoiling& s) {
         s.leave(1.0);
         s.lower(-20.0);
     }},
    {"a scratch of 0.08 mm on a cusp", 'A', [](Spoiling& s) { s.hole(0.08); }},
    {"a hole of 0.6 mm in a cusp", 'F', [](Spoiling& s) { s.hole(0.6); }},
    {"a hole of 1.2 mm in a cusp", 'F', [](Spoiling& s) { s.hole(1.2); }},
    {"half the surface scribbled 0.4 mm deep", 'F', [](Spoiling& s) { s.scribble(0.4); }},
    {"half the surface scribbled 0.7 mm deep", 'F', [](Spoiling& s) { s.scribble(0.7); }},
    {"0.9 mm of the ridge left", 'F', [](Spoiling& s) { s.cutRidge(0.9); }},
    {"the ridge cut through", 'F', [](Spoiling& s) { s.cutRidge(-1.0); }},
    {"the pulp opened", 'F', [](Spoiling& s) { s.nearPulp(-0.1); }},
    {"0.15 mm left over the pulp", 'F', [](Spoiling& s) { s.nearPulp(0.15); }},
    {"0.3 mm left over the pulp", 'F', [](Spoiling& s) { s.nearPulp(0.3); }},
};

constexpr Fault kOfPreparations[] = {
    {"0.15 mm too deep", 'A', [](Spoiling& s) { s.lower(0.15); }},
    {"0.3 mm too deep", 'B', [](Spoiling& s) { s.lower(0.3); }},
    {"0.5 mm too deep", 'C', [](Spoiling& s) { s.lower(0.5); }},
    {"0.8 mm too deep", 'F', [](Spoiling& s) { s.lower(0.8); }},
    {"1.0 mm too deep", 'F', [](Spoiling& s) { s.lower(1.0); }},
    {"0.15 mm too shallow", 'A', [](Spoiling& s) { s.lower(-0.15); }},
    {"0.3 mm too shallow", 'B', [](Spoiling& s) { s.lower(-0.3); }},
    {"0.5 mm too shallow", 'D', [](Spoiling& s) { s.lower(-0.5); }},
    {"0.75 mm too shallow", 'F', [](Spoiling& s) { s.lower(-0.75); }},
    {"0.15 mm too wide", 'A', [](Spoiling& s) { s.widen(0.15); }},
    {"0.25 mm too wide", 'B', [](Spoiling& s) { s.widen(0.25); }},
    {"0.5 mm too wide", 'D', [](Spoiling& s) { s.widen(0.5); }},
    {"0.75 mm too wide", 'F', [](Spoiling& s) { s.widen(0.75); }},
    {"floor tilted by 4 degrees", 'B', [](Spoiling& s) { s.tilt(4.0); }},
    {"floor tilted by 14 degrees", 'D', [](Spoiling& s) { s.tilt(14.0); }},
    {"floor tilted by 20 degrees", 'D', [](Spoiling& s) { s.tilt(20.0); }},
    {"a gouge of 0.25 mm in the floor", 'B', [](Spoiling& s) { s.gouge(0.25); }},
    {"a gouge of 0.45 mm in the floor", 'C', [](Spoiling& s) { s.gouge(0.45); }},
    {"a gouge of 0.84 mm in the floor", 'D', [](Spoiling& s) { s.gouge(0.84); }},
    {"a gouge of 1.2 mm in the floor", 'F', [](Spoiling& s) { s.gouge(1.2); }},
    {"walls lean by 6 degrees", 'B', [](Spoiling& s) { s.lean(6.0); }},
    {"walls lean by 10 degrees", 'C', [](Spoiling& s) { s.lean(10.0); }},
    {"walls lean by 20 degrees", 'D', [](Spoiling& s) { s.lean(20.0); }},
    {"waves of 0.1 mm in the floor", 'B', [](Spoiling& s) { s.ripple(0.1); }},
    {"waves of 0.4 mm in the floor", 'D', [](Spoiling& s) { s.ripple(0.4); }},
    {"a step of 0.25 mm in the floor", 'B', [](Spoiling& s) { s.step(0.25); }},
    {"a step of 0.6 mm in the floor", 'D', [](Spoiling& s) { s.step(0.6); }},
    {"a tenth not cut", 'C', [](Spoiling& s) { s.leave(0.1); }},
    {"three tenths not cut", 'F', [](Spoiling& s) { s.leave(0.3); }},
    {"half not cut", 'F', [](Spoiling& s) { s.leave(0.5); }},
    {"0.3 mm too deep and 0.2 mm too wide", 'C',
     [](Spoiling& s) {
         s.widen(0.2);
         s.lower(0.3);
     }},
    {"0.15 mm too deep, tilted by 4 degrees", 'B',
     [](Spoiling& s) {
         s.tilt(4.0);
         s.lower(0.15);
     }},
    {"0.4 mm too deep and 0.4 mm too wide", 'D',
     [](Spoiling& s) {
         s.widen(0.4);
         s.lower(0.4);
     }},
};

constexpr Fault kOfMolars[] = {
    {"1.3 mm of the ridge left", 'D', [](Spoiling& s) { s.cutRidge(1.3); }},
};

constexpr Fault kOfPremolars[] = {
    {"1.3 mm of the ridge left", 'B', [](Spoiling& s) { s.cutRidge(1.3); }},
    {"1.0 mm of the ridge left", 'D', [](Spoiling& s) { s.cutRidge(1.0); }},
};

constexpr Fault kOfDecay[] = {
    {"0.1 mm more to all sides", 'A', [](Spoiling& s) { s.widen(0.1); }},
    {"0.2 mm more to all sides", 'B', [](Spoiling& s) { s.widen(0.2); }},
    {"0.3 mm more to all sides", 'C', [](Spoiling& s) { s.widen(0.3); }},
    {"0.5 mm more to all sides", 'D', [](Spoiling& s) { s.widen(0.5); }},
    {"0.8 mm more to all sides", 'F', [](Spoiling& s) { s.widen(0.8); }},
    {"1.2 mm more to all sides", 'F', [](Spoiling& s) { s.widen(1.2); }},
    {"0.25 mm deeper than the decay", 'B', [](Spoiling& s) { s.lower(0.25); }},
    {"0.5 mm deeper than the decay", 'C', [](Spoiling& s) { s.lower(0.5); }},
    {"1 mm deeper than the decay", 'D', [](Spoiling& s) { s.lower(1.0); }},
    {"a gouge of 1 mm below the decay", 'D', [](Spoiling& s) { s.gouge(1.0); }},
    {"a gouge of 0.3 mm below the decay", 'B', [](Spoiling& s) { s.gouge(0.3); }},
    {"1 % of the decay left on the floor", 'A', [](Spoiling& s) { s.leaveDecay(0.01, false); }},
    {"3 % of the decay left on the floor", 'C', [](Spoiling& s) { s.leaveDecay(0.03, false); }},
    {"8 % of the decay left on the floor", 'D', [](Spoiling& s) { s.leaveDecay(0.08, false); }},
    {"20 % of the decay left on the floor", 'F', [](Spoiling& s) { s.leaveDecay(0.2, false); }},
    {"5 % of the decay left at the junction", 'F', [](Spoiling& s) { s.leaveDecay(0.05, true); }},
    {"10 % of the decay left at the junction", 'F', [](Spoiling& s) { s.leaveDecay(0.1, true); }},
    {"20 % of the decay left at the junction", 'F', [](Spoiling& s) { s.leaveDecay(0.2, true); }},
    {"50 % of the decay left", 'F', [](Spoiling& s) { s.leaveDecay(0.5, false); }},
    {"half the surface scribbled, decay left", 'F',
     [](Spoiling& s) {
         s.scribble(0.5);
         s.leaveDecay(0.2, false);
     }},
    {"0.2 mm more to all sides, 0.25 mm deeper", 'B',
     [](Spoiling& s) {
         s.widen(0.2);
         s.lower(0.25);
     }},
};

constexpr std::array kLessons{"class1-36",         "class1-24",         "class1-26",
                              "decay-36-moderate", "decay-26-moderate", "decay-35-moderate"};

struct Attempt
{
    std::size_t lesson = 0;
    Fault fault{};
    bool isNew = false;  ///< in the half that was not used for tuning
    int scoreTenths = 0;
    bool isPassed = false;
    std::string error;

    [[nodiscard]] bool shouldPass() const { return fault.letter <= 'C'; }
    [[nodiscard]] double grade() const { return fault.letter == 'F' ? 0.0 : 'E' - fault.letter; }
};

std::vector<Attempt> attemptsAt(std::size_t lesson, const lessons::Assignment& assignment)
{
    const bool isDecay = !assignment.ideal;
    const bool isMolar = assignment.anatomy->fdi % 10 >= 6;
    std::vector<Attempt> all;
    const auto add = [&](std::span<const Fault> faults) {
        for (const Fault& fault : faults)
            all.push_back({lesson, fault, (all.size() + lesson) % 2 == 1, 0, false, {}});
    };
    add(kOfAny);
    add(isDecay ? std::span<const Fault>(kOfDecay) : std::span<const Fault>(kOfPreparations));
    if (!isDecay)
        add(isMolar ? std::span<const Fault>(kOfMolars) : std::span<const Fault>(kOfPremolars));
    return all;
}

void take(Attempt& attempt, const lessons::Assignment& assignment)
{
    const core::terrain::ToothAnatomy& anatomy = *assignment.anatomy;
    const auto bur = core::bur::findBur(assignment.lesson->burs.front());
    Spoiling work(anatomy, assignment.ideal ? *assignment.ideal->top
                                            : haptics::decayCavity(anatomy, core::bur::burs()[bur.value()]));
    attempt.fault.spoil(work);
    const auto cut = app::cutInstead(assignment, work.wanted());
    const auto marked = cut ? lessons::mark(assignment, cut->tooth, lessons::Conduct{}) : tl::unexpected(cut.error());
    if (!marked) {
        attempt.error = marked.error().detail;
        return;
    }
    attempt.scoreTenths = marked->sheet.totalTenths;
    attempt.isPassed = marked->sheet.passed();
}

/// Returns the rank of each value; equal values get the mean of their ranks.
std::vector<double> ranksOf(const std::vector<double>& values)
{
    std::vector<double> ranks;
    for (const double value : values) {
        const auto below = std::count_if(values.begin(), values.end(), [&](double other) { return other < value; });
        const auto equal = std::count(values.begin(), values.end(), value);
        ranks.push_back(static_cast<double>(below) + 0.5 * static_cast<double>(equal + 1));
    }
    return ranks;
}

/// Returns Spearman's rank correlation, from -1 to 1.
double rankCorrelation(const std::vector<double>& a, const std::vector<double>& b)
{
    const std::vector<double> x = ranksOf(a);
    const std::vector<double> y = ranksOf(b);
    const double mean = 0.5 * static_cast<double>(x.size() + 1);
    double xx = 0.0;
    double xy = 0.0;
    double yy = 0.0;
    for (std::size_t n = 0; n < x.size(); ++n) {
        xx += (x[n] - mean) * (x[n] - mean);
        xy += (x[n] - mean) * (y[n] - mean);
        yy += (y[n] - mean) * (y[n] - mean);
    }
    return xx > 0.0 && yy > 0.0 ? xy / std::sqrt(xx * yy) : 0.0;
}

struct Agreement
{
    double wronglyPassedPercent = 0.0;
    double wronglyFailedPercent = 0.0;
    double rank = 0.0;
    int attempts = 0;
};

Agreement agreementOf(const std::vector<Attempt>& attempts, bool isNew)
{
    std::array<int, 2> all{};  // attempts that should fail, and that should pass
    std::array<int, 2> wrong{};
    std::vector<double> letters;
    std::vector<double> scores;
    for (const Attempt& attempt : attempts) {
        if (attempt.isNew != isNew)
            continue;
        const std::size_t should = attempt.shouldPass() ? 1 : 0;
        ++all.at(should);
        wrong.at(should) += attempt.isPassed != attempt.shouldPass() ? 1 : 0;
        letters.push_back(attempt.grade());
        scores.push_back(attempt.scoreTenths);
    }
    const auto percent = [&](std::size_t should) { return 100.0 * wrong.at(should) / std::max(1, all.at(should)); };
    return {percent(0), percent(1), rankCorrelation(letters, scores), static_cast<int>(letters.size())};
}

/// Returns a chart of score against letter.
NamedChart chartOf(const std::vector<Attempt>& attempts)
{
    ui::charts::Curve content;
    content.x = {QStringLiteral("letter of a strict instructor"), -0.5, 4.5};
    content.x.labels = {QStringLiteral("F"), QStringLiteral("D"), QStringLiteral("C"), QStringLiteral("B"),
                        QStringLiteral("A")};
    content.y = {QStringLiteral("points"), 0.0, 100.0};
    content.limits = {{75.0, false, QStringLiteral("pass mark")}};
    for (const bool isNew : {false, true}) {
        ui::charts::Line line;
        line.name = isNew ? QStringLiteral("not used for tuning") : QStringLiteral("used for tuning");
        line.mark = isNew ? ui::charts::Mark::Circle : ui::charts::Mark::HollowDiamond;
        line.isJoined = false;
        std::array<int, 5> inColumn{};
        for (const Attempt& attempt : attempts)
            if (attempt.isNew == isNew) {
                const int n = inColumn.at(static_cast<std::size_t>(attempt.grade()))++;
                constexpr int kAbreast = 16;
                const double aside = (n % kAbreast) * 0.02 + (isNew ? 0.02 : -0.34);
                line.dots << ui::charts::Dot{attempt.grade() + aside, 0.1 * attempt.scoreTenths,
                                             QLatin1String(kLessons.at(attempt.lesson)) + QStringLiteral(": ") +
                                                 QLatin1String(attempt.fault.what)};
            }
        content.lines << line;
    }
    return {QStringLiteral("marks"),
            {QStringLiteral("Points of the program against letters by the book"),
             QStringLiteral("%1 attempts at %2 lessons; a simulated hand cuts what is right, spoiled in a known way.")
                 .arg(attempts.size())
                 .arg(kLessons.size()),
             {},
             content}};
}

void report(Figures& figures, const std::vector<Attempt>& attempts)
{
    for (const Attempt& attempt : attempts) {
        QString key = QStringLiteral("marks_%1_%2")
                          .arg(QLatin1String(kLessons.at(attempt.lesson)), QLatin1String(attempt.fault.what));
        for (QChar& letter : key)
            letter = letter.isLetterOrNumber() && letter.unicode() < 128 ? letter.toLower() : QChar(u'_');
        const QString wrong = attempt.isPassed == attempt.shouldPass() ? QString()
                              : attempt.isPassed                       ? QStringLiteral(", wrongly passed")
                                                                       : QStringLiteral(", wrongly failed");
        figures << Figure{
            key,
            QStringLiteral("%1: %2").arg(QLatin1String(kLessons.at(attempt.lesson)), QLatin1String(attempt.fault.what)),
            0.1 * attempt.scoreTenths, QStringLiteral("points"),
            QStringLiteral("%1%2%3")
                .arg(QLatin1Char(attempt.fault.letter))
                .arg(wrong, attempt.isNew ? QStringLiteral(" (new)") : QString())};
    }
    for (const bool isNew : {false, true}) {
        const Agreement found = agreementOf(attempts, isNew);
        const QString before = isNew ? QStringLiteral("marks_") : QStringLiteral("marks_tuned_");
        const QString half = isNew ? QStringLiteral("not tuned on, ") : QStringLiteral("tuned on, ");
        const auto add = [&](const char* key, const char* what, double value, const char* unit, const char* reach) {
            figures << Figure{before + QLatin1String(key), half + QLatin1String(what), value, QLatin1String(unit),
                              isNew ? QLatin1String(reach) : QString()};
        };
        add("attempts", "attempts", found.attempts, "", "");
        add("wrongly_passed_percent", "passed of those that should fail", found.wronglyPassedPercent, "%", "<= 3");
        add("wrongly_failed_percent", "failed of those that should pass", found.wronglyFailedPercent, "%", "<= 3");
        add("rank", "rank correlation of points and letter", found.rank, "", ">= 0.9");
    }
}

}  // namespace

core::Result<Figures> marksSuite(const Context& context)
{
    std::vector<lessons::Assignment> assignments;
    std::vector<Attempt> attempts;
    for (const char* const id : kLessons) {
        const auto lesson = lessons::lessonNamed(QLatin1String(id));
        if (!lesson)
            return tl::unexpected(lesson.error());
        auto assigned = lessons::assign(*lesson);
        if (!assigned)
            return tl::unexpected(assigned.error());
        const auto more = attemptsAt(assignments.size(), assigned->assignment);
        attempts.insert(attempts.end(), more.begin(), more.end());
        assignments.push_back(std::move(assigned->assignment));
    }
    inParallel(
        attempts.size(), [&](std::size_t k) { take(attempts[k], assignments[attempts[k].lesson]); },
        [&](std::size_t done) {
            context.progress(QStringLiteral("attempts"), static_cast<int>(done), static_cast<int>(attempts.size()));
        });
    for (const Attempt& attempt : attempts)
        if (!attempt.error.empty())
            return core::unexpected(core::ErrorCode::BadStructure, attempt.error);
    Figures figures;
    report(figures, attempts);
    context.show(chartOf(attempts));
    return figures;
}

}  // namespace bench
