// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "core/base/Rng.h"
#include "core/grading/IdealCavity.h"
#include "core/grading/MeasureTable.h"
#include "tests/support/Files.h"
#include "tests/support/Scenes.h"
#include "tests/support/Suite.h"
#include "tests/support/SyntheticTooth.h"

using namespace core;
using grading::Measured;
using grading::MeasureInfo;
using grading::Part;
using grading::Preparation;

namespace {

std::optional<double> valueOf(const char* id, const Measured& measured)
{
    const auto measure = grading::findMeasure(id);
    return measure ? measure->value(measured) : std::nullopt;
}

std::optional<std::size_t> nodeOf(const char* id, const Measured& measured)
{
    return grading::findMeasure(id).value().nodeIn(measured);
}

/// A tooth with a box cut into it, and the ideal: a level box.
struct Attempt
{
    terrain::Tooth tooth;
    Preparation ideal;

    [[nodiscard]] Measured measured() const
    {
        return {grading::measure(tooth),
                grading::measureLesionCut(tooth),
                grading::measureDeviation(tooth, ideal, grading::Leeway{}).value(),
                grading::Process{},
                0,
                0,
                0,
                {}};
    }
};

Attempt boxed(const std::shared_ptr<const terrain::ToothAnatomy>& anatomy, glm::dvec2 halfMm, float floorMm = -4.0F)
{
    Attempt attempt{terrain::Tooth(anatomy), {}};
    std::vector<float> top = anatomy->top;
    attempt.ideal.parts.assign(top.size(), Part::Keep);
    support::eachNode(anatomy->grid, [&](std::size_t k, const glm::dvec2& p) {
        if (!(anatomy->top[k] > floorMm))
            return;
        if (std::abs(p.x) < 1.5 && std::abs(p.y) < 0.8) {
            top[k] = floorMm;
            attempt.ideal.parts[k] = Part::Floor;
        }
        if (std::abs(p.x) < halfMm.x && std::abs(p.y) < halfMm.y)
            attempt.tooth.top[k] = floorMm - 0.1F;
    });
    attempt.ideal.top = std::make_shared<const std::vector<float>>(std::move(top));
    return attempt;
}

}  // namespace

class TestMeasureTable : public QObject
{
    Q_OBJECT

private slots:
    void everyRowIsWhole()
    {
        const std::set<std::string_view> units{"mm3", "mm2", "mm", "deg", "percent", "s", "N", "mm/s3", ""};
        std::set<std::string_view> ids;
        for (const MeasureInfo& row : grading::measureTable()) {
            const std::string id(row.id);
            QVERIFY2(ids.insert(row.id).second, id.c_str());
            QVERIFY2(!id.empty() && id.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string::npos,
                     id.c_str());
            QVERIFY2(units.contains(row.unit),
                     (id + ": name its unit in unitName() of ui/text/Texts.cpp and in this test").c_str());
            QVERIFY2(row.definition.ends_with('.') && row.definition.size() > 20, id.c_str());
            QVERIFY2(!row.source.empty(), id.c_str());
            QVERIFY2(row.value != nullptr, id.c_str());
            QCOMPARE(grading::findMeasure(row.id)->definition, row.definition);
        }
    }

    /// A rubric in a teacher's folder names measures by their ids: never rename or remove one.
    void theSchemaListsTheMeasures()
    {
        std::vector<std::string> ids;
        for (const MeasureInfo& row : grading::measureTable())
            ids.emplace_back(row.id);
        QVERIFY(support::isSchemaUpToDate("measure", ids));
    }

    void anUnknownIdIsNone()
    {
        for (const char* id : {"", "overcut", "OVERCUT_MM3", "overcut_mm3 ", "no_such_thing"})
            QVERIFY(!grading::findMeasure(id).has_value());
    }

    void whatIsNotThereIsNotMeasured()
    {
        // A sound block without ideal and recording: only the measures of the removed tissue are known.
        Measured measured;
        measured.measures = grading::measure(terrain::Tooth(support::makeBlock({})));
        const std::set<std::string_view> known{"lesion_mm3",         "sound_overcut_mm3", "enamel_removed_mm3",
                                               "dentin_removed_mm3", "pulp_removed_mm3",  "deepest_cut_mm",
                                               "pulp_exposed_mm2",   "perforated_mm2",    "removed_mm3"};
        for (const MeasureInfo& row : grading::measureTable()) {
            const std::string id(row.id);
            if (known.contains(row.id))
                QVERIFY2(row.value(measured).has_value(), (id + ": it is not measured on a sound block").c_str());
            else
                QVERIFY2(!row.value(measured).has_value(),
                         (id + " is measured on a sound block without ideal and recording: if its value means "
                               "something there, add it to `known` in this test; else return no value")
                             .c_str());
            QVERIFY2(!row.nodeIn(measured).has_value(), std::string(row.id).c_str());
        }
    }

    void valuesAreThoseOfTheStructs()
    {
        Measured measured = boxed(support::builtTooth(36), {1.6, 0.8}).measured();
        const grading::Measures& m = measured.measures;
        const grading::Deviation& d = *measured.deviation;
        measured.process->totalS = 12.0;
        measured.process->force = grading::Process::Force{1.0, 0.2, 1.4, 2.5};
        const std::pair<const char*, std::optional<double>> rows[]{
            {"overcut_mm3", d.overcutBesideMm3 + d.overcutBelowMm3},
            {"overcut_percent", 100.0 * (d.overcutMm3() / d.idealMm3)},
            {"dice", d.dice},
            {"depth_error_signed_mm", d.depth->signedMm},
            {"outline_max_mm", std::max(d.outline->overMm.value, d.outline->underMm.value)},
            {"ridge_least_mm", std::min(d.form.ridgeMesialMm->value, d.form.ridgeDistalMm->value)},
            {"caries_left_percent", m.cariesLeftPercent},
            {"caries_removed_percent", 100.0 - m.cariesLeftPercent},
            {"remaining_over_pulp_mm", m.remainingOverPulpMm},
            {"enamel_removed_mm3", m.removedMm3[1]},
            {"target_removed_percent", 100.0},
            {"time_total_s", 12.0},
            {"force_p95_n", 1.4},
            {"time_to_first_cut_s", std::nullopt},
            {"isthmus_width_mm", std::nullopt}};
        for (const auto& [id, value] : rows)
            QVERIFY2(valueOf(id, measured) == value, id);
        QVERIFY(std::abs(*valueOf("depth_error_signed_mm", measured) + 0.1) < 1.0e-5);
        QVERIFY(std::abs(*valueOf("removed_mm3", measured) - d.removedMm3) < 1.0e-4);
    }

    void wallsAndFloorOfAHoleAreNotThoseOfTheIdeal()
    {
        const Measured hole = boxed(support::builtTooth(36), {0.5, 0.8}).measured();
        const Measured most = boxed(support::builtTooth(36), {1.0, 0.8}).measured();
        QVERIFY(*valueOf("target_removed_percent", hole) > 20.0 && *valueOf("target_removed_percent", hole) < 45.0);
        QVERIFY(*valueOf("target_removed_percent", most) > 55.0 && *valueOf("target_removed_percent", most) < 80.0);
        QVERIFY(hole.deviation->floor.has_value());
        for (const char* id : {"wall_angle_error_deg", "floor_flatness_mm", "floor_slope_deg", "floor_step_mm"}) {
            QVERIFY2(!valueOf(id, hole), id);
            QVERIFY2(!nodeOf(id, hole), id);
            QVERIFY2(valueOf(id, most), id);
        }
    }

    void nodesAreWhereThingsAreWorst()
    {
        const auto anatomy = support::builtTooth(36);
        Attempt attempt = boxed(anatomy, {1.5, 0.8});
        const terrain::Tooth& tooth = attempt.tooth;
        const std::size_t deep = anatomy->grid.index(75, 75);
        attempt.tooth.top[deep] -= 0.5F;
        const Measured measured = attempt.measured();
        for (const char* id : {"depth_too_deep_mm", "depth_error_p95_mm", "overcut_mm3"})
            QCOMPARE(nodeOf(id, measured), std::optional(deep));
        // The expected nodes: the column with the most decay left, and the one that was lowered most.
        const auto first = [&](const std::function<double(std::size_t)>& value) {
            std::size_t best = 0;
            for (std::size_t k = 1; k < anatomy->top.size(); ++k)
                best = value(k) > value(best) ? k : best;
            return std::optional(best);
        };
        QCOMPARE(nodeOf("caries_left_percent", measured), first([&](std::size_t k) {
                     return tooth.isSolid(k)
                                ? terrain::lengthsBetween(anatomy->layers[k], tooth.bottom[k], tooth.top[k])[0] *
                                      static_cast<double>(anatomy->areaMm2[k])
                                : 0.0;
                 }));
        QCOMPARE(nodeOf("deepest_cut_mm", measured),
                 first([&](std::size_t k) { return static_cast<double>(anatomy->top[k] - tooth.top[k]); }));
        // The distance from that column to the pulp is the measured one.
        const std::size_t nearest = nodeOf("remaining_over_pulp_mm", measured).value();
        QVERIFY(tooth.top[nearest] < anatomy->top[nearest]);
        double least = 5.0;
        for (std::size_t k = 0; k < anatomy->top.size(); ++k)
            if (terrain::hasPulp(*anatomy, k)) {
                const glm::dvec2 way = anatomy->grid.nodeMm(k) - anatomy->grid.nodeMm(nearest);
                const double over = static_cast<double>(tooth.top[nearest] - anatomy->layers[k].pulpRoof);
                least = std::min(least, std::hypot(way.x, way.y, std::max(0.0, over)));
            }
        QVERIFY(std::abs(least - measured.measures.remainingOverPulpMm) < 1.0e-5);
    }

    /// The same leaning cavity in a lower tooth, an upper tooth and a block: buccal is -y, +y and undefined.
    void wallsAreNamedWhereTheSidesAreKnown()
    {
        for (const int fdi : {36, 26, 0}) {
            // The surface is flat, so that only the names differ.
            auto flat =
                std::make_shared<terrain::ToothAnatomy>(fdi == 0 ? *support::makeBlock({}) : *support::builtTooth(fdi));
            for (std::size_t k = 0; k < flat->top.size(); ++k)
                if (flat->top[k] > flat->bottom[k]) {
                    flat->top[k] = 0.0F;
                    flat->bottom[k] = -6.0F;
                }
            Attempt attempt{terrain::Tooth(flat), {{}, std::vector<Part>(flat->top.size(), Part::Keep), {}}};
            attempt.ideal.top = std::make_shared<const std::vector<float>>(flat->top);
            support::eachNode(flat->grid, [&](std::size_t k, const glm::dvec2& p) {
                const double in =
                    std::max({-1.5, -(p.x + 1.5) * 3.0, -(1.5 - p.x) * 4.0, -(p.y + 1.5) * 5.0, -(1.5 - p.y) * 6.0});
                if (flat->top[k] > flat->bottom[k] && in < 0.0)
                    attempt.tooth.top[k] = static_cast<float>(in);
            });
            const Measured measured = attempt.measured();
            const bool isUpper = fdi == 26;
            for (const auto& [id, rise, needsSides] : {std::tuple("wall_angle_mesial_deg", 3.0, true),
                                                       {"wall_angle_distal_deg", 4.0, true},
                                                       {"wall_angle_buccal_deg", isUpper ? 6.0 : 5.0, true},
                                                       {"wall_angle_lingual_deg", isUpper ? 5.0 : 6.0, true},
                                                       {"wall_angle_most_deg", 3.0, false},
                                                       {"wall_angle_least_deg", 6.0, false}}) {
                const auto degrees = valueOf(id, measured);
                if (fdi == 0 && needsSides)
                    QVERIFY2(!degrees, id);
                else
                    QVERIFY2(degrees && std::abs(*degrees - std::atan(1.0 / rise) * 180.0 / std::numbers::pi) < 1.0,
                             id);
            }
            for (const char* id : {"ridge_mesial_mm", "ridge_least_mm"})
                QVERIFY2(fdi != 0 || !valueOf(id, measured), id);
        }
    }

    /// After any cuts, every measure is a finite number or unknown, and measuring again gives the same.
    void randomCutsGiveFiniteNumbers()
    {
        for (std::uint64_t seed = 1; seed <= 12; ++seed) {
            Rng rng(seed);
            const auto anatomy =
                support::builtTooth(seed % 2 == 0 ? 36 : 24, 64 + 40 * static_cast<int>(seed % 3), seed);
            Attempt attempt = boxed(anatomy, {rng.uniform(0.0, 3.0), rng.uniform(0.0, 3.0)}, -3.5F);
            for (int hole = 0; hole < 40; ++hole) {
                const int i = rng.below(anatomy->grid.side);
                const int j = rng.below(anatomy->grid.side);
                const int reach = rng.below(8);
                const auto to = static_cast<float>(rng.uniform(-25.0, 0.0));
                support::eachOf(anatomy->grid, support::around(anatomy->grid, i, j, reach), [&](std::size_t k) {
                    attempt.tooth.top[k] = std::min(attempt.tooth.top[k], to);
                    if (attempt.tooth.top[k] <= anatomy->bottom[k])
                        support::cutThrough(attempt.tooth, k);
                });
            }
            attempt.ideal.isthmus = Preparation::Isthmus{};
            const Measured measured = attempt.measured();
            const Measured again = attempt.measured();
            for (const MeasureInfo& row : grading::measureTable()) {
                const auto value = row.value(measured);
                QVERIFY2(!value || std::isfinite(*value), std::string(row.id).c_str());
                QCOMPARE(row.value(again), value);
                const auto node = row.nodeIn(measured);
                QVERIFY2(!node || *node < anatomy->grid.count(), std::string(row.id).c_str());
            }
        }
    }
};

CUSP_TEST(TestMeasureTable)
#include "tst_measure_table.moc"
