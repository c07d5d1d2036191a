// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include <cmath>
#include <set>
#include <string>

#include <glm/geometric.hpp>

#include "core/grading/Preparation.h"
#include "lessons/Advice.h"
#include "lessons/LessonCatalog.h"
#include "tests/support/Rig.h"
#include "tests/support/Scenes.h"
#include "tests/support/Suite.h"
#include "tests/support/SyntheticTooth.h"

using namespace lessons;
using Rule = Advice::Rule;

namespace {

Assignment shippedAssignment(const std::string& id)
{
    for (const CatalogEntry& entry : readCatalog({}))
        if (entry.read.lesson && entry.read.lesson->id == id)
            return assign(*entry.read.lesson).value().assignment;
    qFatal("the lesson %s is gone", id.c_str());
}

Assignment classOne()
{
    return shippedAssignment("class1-36");
}

/// Returns free practice on a slab with decay in the middle and pulp below it.
Assignment decayed()
{
    return practiceOn(support::decayedSlab(26, 37)).value();
}

std::vector<Advice> adviceFor(const Assignment& assignment, const core::terrain::Tooth& tooth)
{
    const Mark marked = mark(assignment, tooth).value();
    return adviceOn(marked.sheet, marked.measured, {});
}

const Advice* find(const std::vector<Advice>& all, Rule rule)
{
    const auto found = std::find_if(all.begin(), all.end(), [&](const Advice& a) { return a.rule == rule; });
    return found == all.end() ? nullptr : &*found;
}

/// Changes the height of a column of the ideal preparation.
using Change = std::function<float(const Assignment&, std::size_t k, glm::dvec2 atMm, float idealMm)>;

core::terrain::Tooth changed(const Assignment& assignment, const Change& change)
{
    std::vector<float> top = *assignment.ideal->top;
    support::eachNode(assignment.anatomy->grid, [&](std::size_t k, glm::dvec2 at) {
        top[k] = std::min(assignment.anatomy->top[k], change(assignment, k, at, top[k]));
    });
    return core::terrain::restored(assignment.anatomy, top);
}

bool isCut(const Assignment& assignment, std::size_t k)
{
    return (*assignment.ideal->top)[k] < assignment.anatomy->top[k] - 0.3F;
}

/// Returns the tooth after cutting both the ideal cavity and the same cavity shifted by whole nodes.
core::terrain::Tooth widened(const Assignment& assignment, int nodes)
{
    const core::terrain::Grid& grid = assignment.anatomy->grid;
    std::vector<float> top = *assignment.ideal->top;
    const std::vector<float>& ideal = *assignment.ideal->top;
    for (int j = nodes; j < grid.side - nodes; ++j)
        for (int i = nodes; i < grid.side - nodes; ++i)
            for (const int step : {-nodes, nodes}) {
                const std::size_t from = grid.index(i, j + step);
                if (isCut(assignment, from))
                    top[grid.index(i, j)] = std::min(top[grid.index(i, j)], ideal[from]);
            }
    return core::terrain::restored(assignment.anatomy, top);
}

struct PlungeAttempt
{
    Assignment assignment = decayed();
    support::Rig rig;

    PlungeAttempt()
    {
        rig.drill(assignment.anatomy);
        rig.run(1500);
    }
    /// Moves straight down to a height at this many mm/s, and lifts.
    void plunge(double toMm, double mmPerS)
    {
        for (double z = 0.3; z > toMm; z -= 1.0e-3 * mmPerS) {
            rig.device.tipMm = glm::vec3(0.0, 0.0, z);
            rig.run(1);
        }
        rig.lift();
    }
    [[nodiscard]] std::vector<Advice> advice() const
    {
        const PointLossTimeline found = momentsOf(assignment, rig.session->recordingSoFar().value()).value().value();
        return adviceOn(found.sheet, mark(assignment, rig.live()).value().measured, found.ofCriteria);
    }
};

}  // namespace

class TestAdvice : public QObject
{
    Q_OBJECT
private slots:
    void everyMeasureLeadsToAdvice()
    {
        // Measures that have no advice.
        const std::set<std::string_view> without{"lesion_mm3",
                                                 "access_mm3",
                                                 "smallest_cavity_mm3",
                                                 "enamel_removed_mm3",
                                                 "deepest_cut_mm",
                                                 "ideal_mm3",
                                                 "dice",
                                                 "iou",
                                                 "isthmus_width_mm",
                                                 "longest_pause_s",
                                                 "path_mm",
                                                 "path_cutting_mm",
                                                 "strokes",
                                                 "stroke_length_mean_mm",
                                                 "stroke_time_mean_s",
                                                 "lift_offs",
                                                 "jerk_rms_mm_s3",
                                                 "drill_in_air_s",
                                                 "contact_bur_off_s",
                                                 "undo_count",
                                                 "infractions",
                                                 "aids_used"};
        for (const core::grading::MeasureInfo& measure : core::grading::measureTable()) {
            Criterion line;
            line.measure = std::string(measure.id);
            line.measured = 1.0;
            line.share = 1.0;
            line.lostTenths = kFullTenths;
            ScoreSheet sheet;
            sheet.criteria = {line};
            const bool hasAdvice = !adviceOn(sheet, core::grading::Measured{}, {}).empty();
            QVERIFY2(
                hasAdvice != without.contains(measure.id),
                (line.measure + (hasAdvice ? " leads to advice: remove it from `without` in this test"
                                           : " leads to no advice: add it to findingOf() in lessons/Advice.cpp, or "
                                             "to `without` in this test"))
                    .c_str());
        }
    }

    void aPerfectPreparationNeedsNone()
    {
        const Assignment assignment = classOne();
        QVERIFY(adviceFor(assignment, changed(assignment, [](auto&, auto, auto, float z) { return z; })).empty());
    }

    void aFormThatIsOff_data()
    {
        QTest::addColumn<Change>("change");
        QTest::addColumn<int>("rule");
        const auto row = [](const char* name, Rule rule, Change change) {
            QTest::newRow(name) << std::move(change) << static_cast<int>(rule);
        };
        row("0.6 mm too deep", Rule::TooDeep,
            [](const Assignment& a, std::size_t k, auto, float z) { return isCut(a, k) ? z - 0.6F : z; });
        row("0.6 mm too shallow", Rule::TooShallow,
            [](const Assignment& a, std::size_t k, auto, float z) { return isCut(a, k) ? z + 0.6F : z; });
        row("nothing cut", Rule::TooLittleDone,
            [](const Assignment& a, std::size_t k, auto, float) { return a.anatomy->top[k]; });
        row("half of it left", Rule::NotAllCut, [](const Assignment& a, std::size_t k, glm::dvec2 at, float z) {
            return at.x > 0.0 ? a.anatomy->top[k] : z;
        });
        row("a step in the floor", Rule::FloorUneven, [](const Assignment& a, std::size_t k, glm::dvec2 at, float z) {
            return isCut(a, k) && std::fmod(std::abs(at.x), 1.0) < 0.5 ? z + 0.5F : z;
        });
        row("through the ridges", Rule::RidgeThin, [](const Assignment& a, std::size_t k, glm::dvec2 at, float z) {
            return std::abs(at.y) < 0.6 && std::abs(at.x) < 4.6 ? std::min(z, a.anatomy->top[k] - 1.0F) : z;
        });
        row("through the bottom", Rule::Perforated, [](const Assignment& a, std::size_t k, glm::dvec2 at, float z) {
            return glm::length(at) < 0.5 ? core::terrain::kEmptyTop + 0.0F * a.anatomy->top[k] : z;
        });
    }
    void aFormThatIsOff()
    {
        QFETCH(const Change, change);
        QFETCH(const int, rule);
        const Assignment assignment = classOne();
        const auto advice = adviceFor(assignment, changed(assignment, change));
        const Advice* found = find(advice, static_cast<Rule>(rule));
        QVERIFY(found != nullptr);
        QVERIFY(!found->moment);
    }

    void thePitThatIsOffIsNamed()
    {
        const Assignment assignment = shippedAssignment("first-01-plunges");
        // The third pit, 1.5 mm deep, is to the right of the middle.
        const auto off = [&](float byMm) {
            return adviceFor(assignment, changed(assignment, [=](const Assignment& a, std::size_t k, auto, float z) {
                                 return isCut(a, k) && z < -1.1F && z > -1.6F ? z + byMm : z;
                             }));
        };
        const auto deep = off(-0.4F);
        const Advice* tooDeep = find(deep, Rule::PitTooDeep);
        QVERIFY(tooDeep != nullptr && find(deep, Rule::PitTooShallow) == nullptr);
        QVERIFY(std::abs(tooDeep->askedMm - 1.5) < 0.01 && std::abs(tooDeep->amount - 0.4) < 0.01);
        const auto shallow = off(0.5F);
        const Advice* tooShallow = find(shallow, Rule::PitTooShallow);
        QVERIFY(tooShallow != nullptr && std::abs(tooShallow->askedMm - 1.5) < 0.01);
    }

    void whereEnamelAloneWasToBeCutDentinIsNamed()
    {
        const Assignment assignment = shippedAssignment("first-02-enamel-only");
        const auto off = [&](float byMm) {
            return adviceFor(assignment, changed(assignment, [=](const Assignment& a, std::size_t k, auto, float z) {
                                 return isCut(a, k) ? z + byMm : z;
                             }));
        };
        const auto deep = off(-0.4F);
        const Advice* dentin = find(deep, Rule::DentinCut);
        QVERIFY(dentin != nullptr && dentin->amount > 5.0);
        QVERIFY(find(deep, Rule::TooDeep) == nullptr);
        QVERIFY(find(off(0.4F), Rule::EnamelLeft) != nullptr);
    }

    /// A box that is too deep or too shallow, and an oblique ridge that is cut, have advice of their own.
    void aBoxOrAnObliqueRidgeThatIsOff()
    {
        using Preparation = core::grading::Preparation;
        const Assignment slot = shippedAssignment("first-11-slot-35");
        const Preparation::Box box = *slot.ideal->box;
        const auto inside = [&](glm::dvec2 at, double fromMm) {
            return glm::dot(at - box.atMm, -box.outwards) >= fromMm;
        };
        const auto shallow =
            adviceFor(slot, changed(slot, [&](const Assignment& a, std::size_t k, glm::dvec2 at, float z) {
                          return inside(at, 1.0) ? a.anatomy->top[k] : z;
                      }));
        QVERIFY(find(shallow, Rule::AxialWallShallow) != nullptr);
        QVERIFY(std::abs(find(shallow, Rule::AxialWallShallow)->amount - 0.45) < 0.1);
        const auto deep = adviceFor(slot, changed(slot, [&](auto&, std::size_t, glm::dvec2 at, float z) {
                                        return inside(at, 0.0) && !inside(at, 2.2) && std::abs(at.y - box.atMm.y) < 1.2
                                                   ? std::min(z, static_cast<float>(box.floorMm))
                                                   : z;
                                    }));
        QVERIFY(find(deep, Rule::AxialWallDeep) != nullptr);
        const auto low = adviceFor(slot, changed(slot, [&](const Assignment& a, std::size_t k, auto, float z) {
                                       return isCut(a, k) ? z - 0.6F : z;
                                   }));
        QVERIFY(find(low, Rule::GingivalFloorOff) != nullptr);
        const Assignment upper = shippedAssignment("first-07-class1-26");
        const glm::dvec2 middle = upper.ideal->obliqueCrest[upper.ideal->obliqueCrest.size() / 2];
        const auto through =
            adviceFor(upper, changed(upper, [&](const Assignment& a, std::size_t k, glm::dvec2 at, float z) {
                          return glm::distance(at, middle) < 0.4 ? std::min(z, a.anatomy->top[k] - 0.5F) : z;
                      }));
        QVERIFY(find(through, Rule::ObliqueRidgeThin) != nullptr);
    }

    void whereMostIsLeftThatComesFirst()
    {
        const Assignment assignment = classOne();
        const auto advice =
            adviceFor(assignment, changed(assignment, [](const Assignment& a, std::size_t k, glm::dvec2 at, float z) {
                          return glm::length(at) < 0.8 ? z : a.anatomy->top[k];
                      }));
        QVERIFY(!advice.empty());
        QCOMPARE(advice.front().rule, Rule::NotAllCut);
        QVERIFY(advice.front().amount > 50.0);
        QVERIFY(find(advice, Rule::TooShallow) == nullptr);
    }

    void anOutlineTooWide()
    {
        const Assignment assignment = classOne();
        const auto advice = adviceFor(assignment, widened(assignment, 8));
        const Advice* outline = find(advice, Rule::OutlineBeyond);
        const Advice* isthmus = find(advice, Rule::IsthmusWide);
        QVERIFY(outline != nullptr && isthmus != nullptr);
        const double wideMm = 8 * assignment.anatomy->grid.cellMm;
        QVERIFY(std::abs(outline->amount - wideMm) < 0.3);
        QVERIFY(std::abs(isthmus->amount - 2.0 * wideMm) < 0.3);
    }

    void anOutlineTooNarrow()
    {
        const Assignment assignment = classOne();
        const auto advice =
            adviceFor(assignment, changed(assignment, [](const Assignment& a, std::size_t k, glm::dvec2 at, float z) {
                          return std::abs(at.x) > 2.0 ? a.anatomy->top[k] : z;
                      }));
        QVERIFY(find(advice, Rule::OutlineShort) != nullptr);
        QVERIFY(find(advice, Rule::OutlineBeyond) == nullptr);
    }

    void aPlungeIntoThePulpWasTooFast()
    {
        PlungeAttempt attempt;
        attempt.plunge(-6.0, 2.0);
        const auto advice = attempt.advice();
        QVERIFY(!advice.empty());
        QCOMPARE(advice.front().rule, Rule::PulpOpenedFast);
        QVERIFY(advice.front().amount >= kFastFeedMmPerS);
        QCOMPARE(advice.front().amount, advice.front().moment->feedMmPerS);
        QVERIFY(advice.front().moment && advice.front().moment->stroke == 1);
    }

    void aSlowOneWasTooDeep()
    {
        PlungeAttempt attempt;
        attempt.plunge(-6.0, 0.3);
        const auto advice = attempt.advice();
        QVERIFY(!advice.empty());
        QCOMPARE(advice.front().rule, Rule::PulpOpened);
        QVERIFY(advice.front().moment && advice.front().moment->feedMmPerS < 0.5);
    }

    void decayThatIsLeft()
    {
        PlungeAttempt attempt;
        attempt.plunge(-1.2, 0.3);
        const auto advice = attempt.advice();
        QVERIFY(!advice.empty());
        QCOMPARE(advice.front().rule, Rule::DecayLeft);
        QVERIFY(advice.front().amount > 80.0);
        QVERIFY(find(advice, Rule::TooLittleDone) != nullptr);
    }

    void soundTissueBesideCleanDecay()
    {
        const Assignment assignment = decayed();
        const auto advice = adviceFor(assignment, support::lowered(assignment.anatomy, [](glm::dvec2 at) {
                                          return glm::length(at) < 2.2 ? -3.6 : 1.0;
                                      }));
        const Advice* const told = find(advice, Rule::SoundTissue);
        QVERIFY(told != nullptr && told->amount > 10.0);
        QVERIFY(find(advice, Rule::BelowDecay) != nullptr);
        QVERIFY(find(advice, Rule::DecayLeft) == nullptr && find(advice, Rule::TooLittleDone) == nullptr);
        // Each advice is given once, with the criterion that states the requirement.
        std::set<Rule> rules;
        for (const Advice& one : advice)
            QVERIFY(rules.insert(one.rule).second);
        QVERIFY(assignment.rubric.criteria[told->criterion].weightTenths > 0);
    }

    /// Decay with a soft, a leathery and a firm zone: there is no advice to remove decay that may stay.
    void selectiveRemoval()
    {
        const Assignment assignment = shippedAssignment("first-14-selective-36");
        const auto ideal = assignment.shownIdeal();
        const auto adviceAt = [&](float besideIdealMm) {
            std::vector<float> top = *ideal;
            for (std::size_t k = 0; k < top.size(); ++k)
                if (top[k] < assignment.anatomy->top[k])
                    top[k] = std::min(assignment.anatomy->top[k], top[k] + besideIdealMm);
            return adviceFor(assignment, core::terrain::restored(assignment.anatomy, top));
        };
        QVERIFY(adviceAt(0.0F).empty());
        const auto tooDeep = adviceAt(-0.8F);
        QVERIFY(find(tooDeep, Rule::BelowFirmDecay) != nullptr && find(tooDeep, Rule::BelowDecay) == nullptr);
        const auto tooShallow = adviceAt(0.3F);
        QVERIFY(find(tooShallow, Rule::SoftDecayLeft) != nullptr && find(tooShallow, Rule::DecayLeft) == nullptr);
        QVERIFY(find(tooShallow, Rule::LeatheryLeft) != nullptr);
        QVERIFY(find(tooShallow, Rule::LeftAtJunction) != nullptr);
    }
};

CUSP_TEST(TestAdvice)
#include "tst_advice.moc"
