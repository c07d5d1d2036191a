// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scoring/ScoreWords.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <variant>

#include <QLocale>
#include <QStringList>

#include "ui/practice/ExerciseCard.h"
#include "ui/scoring/ScorePage.h"
#include "ui/text/LessonTexts.h"
#include "ui/text/Texts.h"

namespace ui::scoring {
namespace {

constexpr std::size_t kShownHash = 12;

/// Returns, for each pad, its tissue and the tissue that the student named.
QString padWords(const core::grading::PadsToName& asked, const core::grading::Named& named)
{
    QStringList pads;
    for (std::size_t pad = 0; pad < core::grading::kPads; ++pad) {
        const core::terrain::Material is = asked.madeOf.at(pad);
        const auto said = named.saidToBe.at(pad);
        //: %1 is "Left", "Middle" or "Right", %2 and %3 are tissues
        pads << (!said         ? ScorePage::tr("%1: %2, no answer").arg(practice::padName(pad), text::materialName(is))
                 : *said == is ? ScorePage::tr("%1: %2, correct").arg(practice::padName(pad), text::materialName(is))
                               : ScorePage::tr("%1: %2, your answer: %3")
                                     .arg(practice::padName(pad), text::materialName(is), text::materialName(*said)));
    }
    return pads.join(QStringLiteral(" · "));
}

}  // namespace

QString expectationWords(int expectedTenths, int totalTenths)
{
    const int gap = expectedTenths - totalTenths;
    const QString expected = text::points(expectedTenths);
    if (gap == 0)
        return ScorePage::tr("You expected %1 points, which is exactly right.").arg(expected);
    return (gap > 0 ? ScorePage::tr("You expected %1 points. You overestimated by %2 points.")
                    : ScorePage::tr("You expected %1 points. You underestimated by %2 points."))
        .arg(expected, text::points(std::abs(gap)));
}

QString expectedWorstWords(const std::string& expected, const ::lessons::ScoreSheet& sheet)
{
    const auto worst = std::max_element(sheet.criteria.begin(), sheet.criteria.end(),
                                        [](const auto& a, const auto& b) { return a.lostTenths < b.lostTenths; });
    const auto said = std::find_if(sheet.criteria.begin(), sheet.criteria.end(),
                                   [&](const ::lessons::Criterion& criterion) { return criterion.id == expected; });
    if (worst == sheet.criteria.end() || worst->lostTenths == 0)
        return said == sheet.criteria.end() ? QString() : ScorePage::tr("You lost no points.");
    const QString name = text::criterionName(*worst);
    if (said == sheet.criteria.end())
        return ScorePage::tr("Your biggest loss: %1.").arg(name);
    if (said->lostTenths == worst->lostTenths)
        return ScorePage::tr("You named your biggest loss correctly: %1.").arg(text::criterionName(*said));
    return ScorePage::tr("You expected \"%1\" to be your biggest loss; it was \"%2\".")
        .arg(text::criterionName(*said), name);
}

QString practisedWords(const ScoredWork& work)
{
    using namespace core::grading;
    if (!work.exercise || !work.measured.practised)
        return {};
    if (const auto* pads = std::get_if<PadsToName>(&*work.exercise))
        return padWords(*pads, std::get<Named>(*work.measured.practised));
    if (const auto* force = std::get_if<ForceToHold>(&*work.exercise)) {
        const Held& held = std::get<Held>(*work.measured.practised);
        return ScorePage::tr("Held for %1 of %2 s, mean deviation %3 N")
            .arg(text::number(held.longestS, 1), text::number(force->seconds, 0), text::number(held.meanErrorN, 2));
    }
    const Touched& touched = std::get<Touched>(*work.measured.practised);
    if (touched.count() == touched.atS.size())
        return ScorePage::tr("All points were touched");
    return ScorePage::tr("%1 of %2 points touched; the ring marks a missed point")
        .arg(touched.count())
        .arg(touched.atS.size());
}

std::optional<std::size_t> missedNode(const ScoredWork& work)
{
    const auto* asked = work.exercise ? std::get_if<core::grading::PointsToTouch>(&*work.exercise) : nullptr;
    const auto& practised = work.measured.practised;
    const auto* touched = practised ? std::get_if<core::grading::Touched>(&*practised) : nullptr;
    if (asked == nullptr || touched == nullptr)
        return std::nullopt;
    const core::terrain::Grid& grid = work.tooth->grid();
    for (std::size_t point = 0; point < std::min(asked->pointsMm.size(), touched->atS.size()); ++point) {
        const glm::dvec2 at = grid.latticeOf(asked->pointsMm[point]);
        const auto i = static_cast<int>(std::lround(at.x));
        const auto j = static_cast<int>(std::lround(at.y));
        if (!touched->atS[point] && grid.contains(i, j))
            return grid.index(i, j);
    }
    return std::nullopt;
}

QString rubricWords(const ::lessons::ScoreSheet& sheet)
{
    const QString name =
        QString::fromStdString(::lessons::inLanguage(sheet.rubricTitle, QLocale().name().toStdString()));
    //: %1 is the name of a rubric, %2 its version, %3 the beginning of its hash
    return ScorePage::tr("Rubric \"%1\", version %2, content %3. Undercuts and walls past 90° are not measured, "
                         "because the model is a height field.")
        .arg(name, QString::number(sheet.rubricVersion),
             QString::fromStdString(sheet.rubricHash.substr(0, kShownHash)));
}

}  // namespace ui::scoring
