// SPDX-License-Identifier: GPL-3.0-or-later
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include <cmath>
#include <limits>

#include "core/base/Rng.h"
#include "lessons/ClassStanding.h"
#include "lessons/Rubric.h"
#include "lessons/RubricReader.h"
#include "lessons/ScoreSheetJson.h"
#include "tests/support/Checks.h"
#include "tests/support/Suite.h"
#include "tests/support/Tables.h"

using namespace lessons;

namespace {

CriterionRule rule(const std::string& id, double target, double tolerance, double span, int weightTenths,
                   Side side = Side::Over)
{
    CriterionRule made;
    made.id = id;
    made.measure = id;
    made.side = side;
    made.target = target;
    made.tolerance = tolerance;
    made.span = span;
    made.weightTenths = weightTenths;
    return made;
}

Rubric twoHalves()
{
    Rubric rubric;
    rubric.id = std::string("halves");
    rubric.title = {{"en", "Halves"}};
    rubric.criteria = {rule("a", 0.0, 1.0, 2.0, 500), rule("b", 1.5, 0.25, 0.5, 500, Side::Both)};
    return rubric;
}

Rubric decayRemoval()
{
    return shippedRubric(QStringLiteral("decay_removal")).value_or(Rubric{});
}

}  // namespace

class TestRubric : public QObject
{
    Q_OBJECT

private slots:
    void theExampleOfTheDocumentIsRight()
    {
        const Rubric rubric = decayRemoval();
        Values values{{"caries_left_percent", 2.8}, {"caries_removed_percent", 97.2}, {"sound_overcut_mm3", 7.4},
                      {"smallest_cavity_mm3", 6.0}, {"below_lesion_mm", 0.26},        {"remaining_over_pulp_mm", 1.4},
                      {"pulp_exposed_mm2", 0.0},    {"perforated_mm2", 0.0},          {"beyond_lesion_mm", 0.4},
                      {"ridge_lost_mm", 0.3},       {"caries_at_junction_mm2", 0.1},  {"removed_mm3", 8.0}};
        ScoreSheet sheet = grade(rubric, values);
        QCOMPARE(sheet.criteria[0].lostTenths, 160);
        QCOMPARE(sheet.criteria[1].tolerance, 2.5 + 0.35 * 6.0);
        QCOMPARE(sheet.criteria[1].lostTenths, 50);
        QCOMPARE(sheet.criteria[2].lostTenths, 40);
        QCOMPARE(sheet.criteria[3].lostTenths, 0);
        QCOMPARE(sheet.totalTenths, 750);
        QVERIFY(sheet.passed());
        values["caries_at_junction_mm2"] = 0.8;
        sheet = grade(rubric, values);
        QCOMPARE(sheet.totalTenths, 500);
        QVERIFY(!sheet.passed() && sheet.limitTenths() == 500);
    }

    void eachSideCountsItsOwnErrors_data()
    {
        support::columns<int, double, double>("side", "value", "error");
        QTest::newRow("over, above") << 0 << 2.0 << 0.25;
        QTest::newRow("over, below") << 0 << 0.5 << 0.0;
        QTest::newRow("under, above") << 1 << 2.0 << 0.0;
        QTest::newRow("under, below") << 1 << 1.0 << 0.25;
        QTest::newRow("both, above") << 2 << 2.0 << 0.25;
        QTest::newRow("both, below") << 2 << 1.0 << 0.25;
        QTest::newRow("both, at the edge of the tolerance") << 2 << 1.75 << 0.0;
    }

    void eachSideCountsItsOwnErrors()
    {
        QFETCH(int, side);
        QFETCH(double, value);
        QFETCH(double, error);
        Rubric rubric;
        rubric.criteria = {rule("a", 1.5, 0.25, 1.0, 1000, static_cast<Side>(side))};
        const ScoreSheet sheet = grade(rubric, {{"a", value}});
        QCOMPARE(sheet.criteria[0].error, error);
        QCOMPARE(sheet.criteria[0].lostTenths, static_cast<int>(1000 * error));
    }

    /// Limits that are not exact in binary: a value exactly on the limit passes, and a slightly larger one does not.
    void whatComesFromRoundingIsNoError()
    {
        Rubric rubric = decayRemoval();
        CriterionRule& rule = *std::find_if(rubric.criteria.begin(), rubric.criteria.end(),
                                            [](const CriterionRule& one) { return one.id == "pulp_exposure"; });
        QVERIFY(rule.critical);
        const auto failedAt = [&rubric](double value) {
            return grade(rubric, {{"caries_left_percent", 0.0},
                                  {"sound_overcut_mm3", 0.0},
                                  {"pulp_exposed_mm2", value},
                                  {"perforated_mm2", 0.0}})
                .failedCritically();
        };
        for (const Side side : {Side::Over, Side::Under, Side::Both})
            for (int target = -30; target <= 30; ++target)
                for (int tolerance = 0; tolerance <= 30; ++tolerance) {
                    rule.side = side;
                    rule.target = 0.1 * target;
                    rule.tolerance = 0.1 * tolerance;
                    const int sign = side == Side::Under ? -1 : 1;
                    const double limit = 0.1 * (target + sign * tolerance);
                    QVERIFY(!failedAt(limit));
                    QVERIFY(!failedAt(limit + sign * 1.0e-10));
                    QVERIFY(failedAt(limit + sign * 1.0e-8));
                }
        // Larger numbers have larger rounding errors.
        rule.side = Side::Over;
        rule.target = 600000.7;
        rule.tolerance = 200000.1;
        QVERIFY(!failedAt(0.1 * 8000008));
    }

    void halfATenthGoesUp()
    {
        Rubric rubric = twoHalves();
        rubric.criteria = {rule("a", 0.0, 0.0, 8.0, 4), rule("b", 0.0, 0.0, 0.0, 996)};
        QCOMPARE(grade(rubric, {{"a", 1.0}, {"b", 0.0}}).criteria[0].lostTenths, 1);  // 4 / 8 = 0.5
        QCOMPARE(grade(rubric, {{"a", 0.99}, {"b", 0.0}}).criteria[0].lostTenths, 0);
    }

    void whatWasNotMeasuredEarnsNothing()
    {
        const ScoreSheet sheet =
            grade(twoHalves(), {{"a", std::nan("")}, {"b", std::numeric_limits<double>::infinity()}});
        QVERIFY(!sheet.criteria[0].measured && !sheet.criteria[1].measured);
        QCOMPARE(sheet.totalTenths, 0);
        QCOMPARE(grade(twoHalves(), {{"a", 0.0}}).totalTenths, 500);
    }

    void anAllowanceGrowsWithItsMeasure()
    {
        Rubric rubric;
        rubric.criteria = {rule("a", 0.0, 6.0, 10.0, 1000)};
        rubric.criteria[0].allowance = Allowance{"cavity", 0.5};
        QCOMPARE(grade(rubric, {{"a", 9.0}}).criteria[0].tolerance, 6.0);
        QCOMPARE(grade(rubric, {{"a", 9.0}, {"cavity", 4.0}}).criteria[0].tolerance, 8.0);
        QCOMPARE(grade(rubric, {{"a", 9.0}, {"cavity", -4.0}}).criteria[0].tolerance, 6.0);
    }

    void nothingIsEarnedBeforeItsTime()
    {
        Rubric rubric = twoHalves();
        rubric.criteria[1].once = Once{"done", "percent", 50.1};
        const auto graded = [&](const Values& values) { return grade(rubric, values); };
        const ScoreSheet untouched = graded({{"a", 0.0}, {"b", 1.5}, {"done", 0.0}});
        QVERIFY(untouched.criteria[1].isTooEarly);
        QCOMPARE(untouched.criteria[1].error, 0.0);
        QCOMPARE(untouched.totalTenths, 500);
        QVERIFY(graded({{"a", 0.0}, {"b", 1.5}}).criteria[1].isTooEarly);
        QCOMPARE(graded({{"a", 0.0}, {"b", 1.5}, {"done", 50.1}}).totalTenths, 1000);
        QCOMPARE(graded({{"a", 0.0}, {"b", 1.5}, {"done", 167 * 0.3}}).totalTenths, 1000);
        QCOMPARE(graded({{"a", 0.0}, {"b", 1.5}, {"done", 50.099}}).totalTenths, 500);
        // Errors made before the condition is met are still measured.
        const ScoreSheet wrong = graded({{"a", 0.0}, {"b", 2.125}, {"done", 12.0}});
        QVERIFY(wrong.criteria[1].error > 0.0);
        QCOMPARE(wrong.criteria[1].lostTenths, 500);
        QCOMPARE(lostByError(wrong.criteria[1], Verdict::SumOfErrors), 375);
        // A critical criterion does not fail an attempt before its condition is met.
        rubric.criteria[1].critical = true;
        rubric.criteria[1].weightTenths = 0;
        rubric.criteria[0].weightTenths = 1000;
        QCOMPARE(graded({{"a", 0.0}, {"b", 9.0}, {"done", 12.0}}).totalTenths, 1000);
        QVERIFY(graded({{"a", 0.0}, {"b", 9.0}, {"done", 60.0}}).failedCritically());
    }

    void theWorstErrorDecides()
    {
        Rubric rubric = twoHalves();
        rubric.verdict = Verdict::WorstError;
        const ScoreSheet sheet = grade(rubric, {{"a", 1.5}, {"b", 2.125}});  // shares 0.25 and 0.75
        QCOMPARE(sheet.criteria[0].lostTenths, 0);
        QCOMPARE(sheet.criteria[1].lostTenths, 750);
        QCOMPARE(sheet.totalTenths, 250);
        QCOMPARE(grade(rubric, {{"a", 1.0}, {"b", 1.5}}).totalTenths, 1000);
        // Of equal errors, the first one counts.
        QCOMPARE(grade(rubric, {{"a", 3.0}, {"b", 9.0}}).criteria[0].lostTenths, 1000);
    }

    void aCriticalErrorTakesWhatIsLeft()
    {
        Rubric rubric = twoHalves();
        rubric.criteria.push_back(rule("harm", 0.0, 0.1, 0.0, 0));
        rubric.criteria.push_back(rule("worse", 0.0, 0.0, 0.0, 0));
        rubric.criteria[2].critical = rubric.criteria[3].critical = true;
        const ScoreSheet sheet = grade(rubric, {{"a", 2.0}, {"b", 1.5}, {"harm", 0.2}, {"worse", 1.0}});
        QCOMPARE(sheet.criteria[0].lostTenths, 250);
        QCOMPARE(sheet.criteria[2].lostTenths, 750);
        QCOMPARE(sheet.criteria[3].lostTenths, 0);
        QCOMPARE(sheet.totalTenths, 0);
        QVERIFY(sheet.failedCritically() && !sheet.passed());
        QVERIFY(grade(rubric, {{"a", 2.0}, {"b", 1.5}, {"harm", 0.1}, {"worse", 0.0}}).passed());
        // Failing does not depend on points: an attempt fails even if there are none left to lose.
        Rubric lenient = rubric;
        lenient.passMarkTenths = 0;
        QVERIFY(!grade(lenient, {{"a", 9.0}, {"b", 9.0}, {"harm", 1.0}, {"worse", 0.0}}).passed());
    }

    void theLowestLimitCounts()
    {
        Rubric rubric = twoHalves();
        rubric.criteria.push_back(rule("thin", 0.0, 0.1, 0.0, 0));
        rubric.criteria.push_back(rule("thinner", 0.0, 0.5, 0.0, 0));
        rubric.criteria[2].critical = rubric.criteria[3].critical = true;
        rubric.criteria[2].capTenths = 650;
        rubric.criteria[3].capTenths = 500;
        QVERIFY(support::succeeds(check(rubric)));
        const auto graded = [&](double a, double thin, double thinner) {
            return grade(rubric, {{"a", a}, {"b", 1.5}, {"thin", thin}, {"thinner", thinner}});
        };
        QVERIFY(graded(2.0, 0.1, 0.5).passed());
        ScoreSheet sheet = graded(2.0, 0.2, 0.2);
        QCOMPARE(sheet.totalTenths, 650);
        QCOMPARE(sheet.criteria[0].lostTenths, 250);  // the loss of the other criteria is unchanged
        QCOMPARE(sheet.criteria[2].lostTenths, 100);
        QVERIFY(!sheet.passed() && !sheet.failedCritically() && sheet.limitTenths() == 650);
        sheet = graded(2.0, 0.6, 0.6);
        QCOMPARE(sheet.totalTenths, 500);
        QCOMPARE(sheet.criteria[2].lostTenths, 0);
        QCOMPARE(sheet.criteria[3].lostTenths, 250);
        // If the other losses already exceed the cap, it costs nothing.
        sheet = graded(9.0, 0.6, 0.6);
        QCOMPARE(sheet.totalTenths, 500);
        QCOMPARE(sheet.criteria[3].lostTenths, 0);
        QVERIFY(sheetIn(toJson(sheet).toStdString()) == sheet);
        // A criterion that is not yet due does not limit the total.
        rubric.criteria[2].once = Once{"a", "mm", 5.0};
        QCOMPARE(graded(2.0, 0.2, 0.2).totalTenths, 750);
        QCOMPARE(graded(6.0, 0.2, 0.2).totalTenths, 500);
        rubric.criteria[0].capTenths = 100;
        QVERIFY(support::isRefused(check(rubric), "caps_at"));
    }

    void theSumIsAlwaysExact()
    {
        core::Rng rng(5);
        for (int round = 0; round < 2000; ++round) {
            Rubric rubric;
            rubric.verdict = round % 3 == 0 ? Verdict::WorstError : Verdict::SumOfErrors;
            int left = kFullTenths;
            for (int k = 0; left > 0; ++k) {
                const int weight = k == 9 ? left : std::min(left, 1 + static_cast<int>(rng.uniform(0.0, 300.0)));
                left -= weight;
                rubric.criteria.push_back(rule(std::to_string(k), rng.uniform(-1.0, 1.0), rng.uniform(0.0, 1.0),
                                               rng.uniform(0.0, 2.0), weight, static_cast<Side>(k % 3)));
            }
            if (round % 4 == 0) {
                rubric.criteria.push_back(rule("critical", 0.0, 2.0, 0.0, 0));
                rubric.criteria.back().critical = true;
            }
            QVERIFY(support::succeeds(check(rubric)));
            Values values;
            for (const CriterionRule& criterion : rubric.criteria)
                if (rng.uniform() > 0.1)
                    values[criterion.measure] = rng.uniform(-3.0, 3.0);
            const ScoreSheet sheet = grade(rubric, values);
            int sum = sheet.totalTenths;
            for (const Criterion& line : sheet.criteria) {
                QVERIFY(line.lostTenths >= 0);
                sum += line.lostTenths;
            }
            QCOMPARE(sum, kFullTenths);
            QVERIFY(sheet.totalTenths >= 0);
        }
    }

    void moreErrorNeverEarnsPoints()
    {
        core::Rng rng(6);
        for (int round = 0; round < 2000; ++round) {
            Rubric rubric = twoHalves();
            rubric.criteria[0].span = rng.uniform(0.0, 3.0);
            rubric.criteria[0].tolerance = rng.uniform(0.0, 1.0);
            const double value = rng.uniform(0.0, 4.0);
            const int better = grade(rubric, {{"a", value}, {"b", 1.5}}).totalTenths;
            const int worse = grade(rubric, {{"a", value + rng.uniform()}, {"b", 1.5}}).totalTenths;
            QVERIFY(worse <= better);
        }
    }

    void aClassIsComparedFromFivePeopleOn()
    {
        QCOMPARE(classStanding(800, {}), (ClassStanding{0, {}}));
        QCOMPARE(classStanding(800, std::vector<int>{100, 200, 300, 900}), (ClassStanding{4, {}}));
        QCOMPARE(classStanding(800, std::vector<int>{100, 200, 300, 900, 950}), (ClassStanding{5, 60.0}));
        QCOMPARE(classStanding(800, std::vector<int>{100, 200, 800, 800, 950}), (ClassStanding{5, 40.0}));
        // For the lowest score of all, nobody is below.
        QCOMPARE(classStanding(100, std::vector<int>{100, 200, 800, 800, 950}), (ClassStanding{5, 0.0}));
        QCOMPARE(classStanding(0, std::vector<int>{1, 2, 3, 4, 5}), (ClassStanding{5, 0.0}));
        QCOMPARE(classStanding(1000, std::vector<int>{1, 2, 3, 4, 5}), (ClassStanding{5, 100.0}));
    }

    void refusesWhatCannotMark()
    {
        QVERIFY(check(twoHalves()).has_value());
        using Spoil = void (*)(Rubric&);
        for (const auto& [says, spoil] :
             {std::pair<const char*, Spoil>("make 110.0 points", [](Rubric& r) { r.criteria[0].weightTenths = 600; }),
              {"make 90.0 points", [](Rubric& r) { r.criteria[0].weightTenths = 400; }},
              {"twice", [](Rubric& r) { r.criteria[0].id = std::string("b"); }},
              {"criteria", [](Rubric& r) { r.criteria.clear(); }},
              {"critical", [](Rubric& r) { r.criteria[0].critical = true; }},
              {"tolerance", [](Rubric& r) { r.criteria[0].tolerance = -0.1; }},
              {"target", [](Rubric& r) { r.criteria[0].target = std::nan(""); }},
              {"pass_mark", [](Rubric& r) { r.passMarkTenths = 1001; }}}) {
            Rubric rubric = twoHalves();
            spoil(rubric);
            QVERIFY(support::isRefused(check(rubric), says));
        }
    }

    void jsonHoldsEveryNumberBitForBit()
    {
        Rubric rubric = twoHalves();
        rubric.hash = std::string("abc");
        const ScoreSheet sheet = grade(rubric, {{"a", 1.0 + 1.0 / 3.0}});
        const QJsonObject object = QJsonDocument::fromJson(toJson(sheet)).object();
        // The measured values are read back bit for bit.
        const Values again = measuredIn(toJson(sheet).toStdString());
        for (const Criterion& line : sheet.criteria) {
            QCOMPARE(again.contains(line.measure), line.measured.has_value());
            if (line.measured)
                QCOMPARE(again.at(line.measure), *line.measured);
        }
        // The whole sheet is read back unchanged.
        const auto readAgain = [](const ScoreSheet& one) { return sheetIn(toJson(one).toStdString()); };
        QVERIFY(readAgain(sheet) == sheet);
        Rubric worst = rubric;
        worst.verdict = Verdict::WorstError;
        worst.title = {{"en", "Halves"}, {"ja", "半分"}};
        worst.criteria[1].side = Side::Both;
        worst.criteria[1].once = Once{"caries_removed_percent", "percent", 50.1};
        for (const Values& values : {Values{{"a", 0.1}}, Values{{"a", 0.1}, {"caries_removed_percent", 1.0 / 3.0}}}) {
            const ScoreSheet other = grade(worst, values);
            QVERIFY(readAgain(other) == other);
        }
        const QByteArray whole = toJson(sheet);
        for (const char* key : {"\"format\":", "\"measured\":", "\"side\":", "\"lost_tenths\":", "\"total_tenths\":"})
            QVERIFY2(!sheetIn(QByteArray(whole).replace(key, "\"other\":").toStdString()), key);
        QVERIFY(!sheetIn("") && !sheetIn("hello") && !sheetIn("{\"format\":2,\"sample\":true}"));
        QVERIFY(measuredIn("").empty() && measuredIn("{\"criteria\": 3}").empty() && measuredIn("hello").empty());
        QCOMPARE(object["format"].toInt(), 2);
        QCOMPARE(object["total_tenths"].toInt(), sheet.totalTenths);
        QCOMPARE(object["rubric_hash"].toString(), QString("abc"));
        const QJsonObject first = object["criteria"].toArray().at(0).toObject();
        QCOMPARE(first["measured"].toDouble(), 1.0 + 1.0 / 3.0);
        QCOMPARE(first["share"].toDouble(), sheet.criteria[0].share);
        QCOMPARE(first["lost_tenths"].toInt(), sheet.criteria[0].lostTenths);
        QVERIFY(object["criteria"].toArray().at(1).toObject()["measured"].isNull());
    }
};

CUSP_TEST(TestRubric)
#include "tst_rubric.moc"
