// SPDX-License-Identifier: GPL-3.0-or-later
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include <cmath>
#include <limits>

#include "core/base/Rng.h"
#include "lessons/DecayRemovalRubric.h"
#include "lessons/ScoreSheetJson.h"

using namespace lessons;
using core::grading::Measures;

namespace {

Measures attempt(double cariesPercent, double overcutMm3, double exposedMm2)
{
    Measures measures;
    measures.cariesLeftPercent = cariesPercent;
    measures.overcutMm3 = overcutMm3;
    measures.pulpExposedMm2 = exposedMm2;
    return measures;
}

/// The arithmetic of a sheet written a second time, another way: count whole points up, in units of half a point.
int slowPoints(const Criterion& c)
{
    if (c.measured <= c.free)
        return 0;
    if (c.rule == PointRule::Once)
        return c.maxPoints;
    const double exact = (c.measured - c.free) * c.pointsPerUnit;
    int points = 0;
    while (points < c.maxPoints && 2.0 * exact >= 2.0 * points + 1.0)
        ++points;
    return points;
}

DecayRemovalRubric randomRubric(core::Rng& rng)
{
    DecayRemovalRubric rubric;
    for (const RubricField& field : decayRemovalFields()) {
        const double value = rng.uniform(field.minimum, field.maximum);
        rubric.*field.value = field.whole ? std::floor(value) : value;
    }
    return rubric;
}

}  // namespace

class TestScoreSheet : public QObject
{
    Q_OBJECT

private slots:
    void gradesAsTheWorkedLineSays_data();
    void gradesAsTheWorkedLineSays();
    void aLargerLesionAllowsALargerCavity();
    void exposedPulpFailsWhateverTheTotal();
    void pointsBelowZeroAreShown();
    void aPerforationFailsToo();
    void whatWasNotMeasuredEarnsNothing();
    void agreesWithASecondImplementation();
    void moreDamageNeverEarnsPoints();
    void defaultsLieInsideTheirRanges();
    void refusesARubricOutOfRange_data();
    void refusesARubricOutOfRange();
    void jsonHoldsEveryNumberBitForBit();
};

void TestScoreSheet::gradesAsTheWorkedLineSays_data()
{
    QTest::addColumn<double>("caries");
    QTest::addColumn<double>("overcut");
    QTest::addColumn<int>("cariesLost");
    QTest::addColumn<int>("soundLost");
    QTest::newRow("clean") << 0.0 << 0.0 << 0 << 0;
    QTest::newRow("within what is free") << 1.0 << 6.0 << 0 << 0;
    QTest::newRow("4.2 % left, free 1.0 %, 2 points per %") << 4.2 << 0.0 << 6 << 0;
    QTest::newRow("half a point rounds away from zero") << 1.25 << 7.0 << 1 << 2;
    QTest::newRow("just under half a point") << 1.2499 << 6.9999 << 0 << 1;
    QTest::newRow("nothing done") << 100.0 << 0.0 << 60 << 0;
    QTest::newRow("crown cut away") << 0.0 << 300.0 << 0 << 40;
}

void TestScoreSheet::gradesAsTheWorkedLineSays()
{
    QFETCH(double, caries);
    QFETCH(double, overcut);
    QFETCH(int, cariesLost);
    QFETCH(int, soundLost);
    const ScoreSheet sheet = grade(attempt(caries, overcut, 0.0));
    QCOMPARE(sheet.criteria.at(0).pointsLost, cariesLost);
    QCOMPARE(sheet.criteria.at(1).pointsLost, soundLost);
    QCOMPARE(sheet.criteria.at(2).pointsLost, 0);
    QCOMPARE(sheet.total, 100 - cariesLost - soundLost);
    QCOMPARE(sheet.pointsBelowZero(), 0);
}

void TestScoreSheet::aLargerLesionAllowsALargerCavity()
{
    Measures measures = attempt(0.0, 20.0, 0.0);
    QCOMPARE(grade(measures).criteria.at(1).pointsLost, 21);  // 1.5 * (20 - 6)
    measures.lesionMm3 = 5.0;
    measures.accessMm3 = 4.0;
    QCOMPARE(grade(measures).criteria.at(1).free, 15.0);
    QCOMPARE(grade(measures).criteria.at(1).pointsLost, 8);  // 1.5 * (20 - 15), half a point up
}

void TestScoreSheet::exposedPulpFailsWhateverTheTotal()
{
    DecayRemovalRubric lenient;
    lenient.pulpMaxPoints = 5.0;
    const ScoreSheet sheet = grade(attempt(0.0, 0.0, 0.01), lenient);
    QCOMPARE(sheet.total, 95);
    QVERIFY(sheet.total >= sheet.passMark);
    QVERIFY(sheet.failedCritically());
    QVERIFY(!sheet.passed());
    QVERIFY(grade(attempt(0.0, 0.0, 0.0), lenient).passed());
}

void TestScoreSheet::pointsBelowZeroAreShown()
{
    const ScoreSheet sheet = grade(attempt(100.0, 300.0, 1.0));
    QCOMPARE(sheet.pointsLost(), 200);
    QCOMPARE(sheet.total, 0);
    QCOMPARE(sheet.pointsBelowZero(), 100);
}

void TestScoreSheet::aPerforationFailsToo()
{
    Measures measures = attempt(0.0, 0.0, 0.0);
    measures.perforatedMm2 = 0.02;
    QCOMPARE(grade(measures).criteria.at(3).pointsLost, 100);
    QCOMPARE(grade(measures).total, 0);
    DecayRemovalRubric lenient;
    lenient.perforationMaxPoints = 5.0;
    QCOMPARE(grade(measures, lenient).total, 95);
    QVERIFY(!grade(measures, lenient).passed());
    lenient.perforationFreeMm2 = 0.02;
    QVERIFY(grade(measures, lenient).passed());
}

void TestScoreSheet::whatWasNotMeasuredEarnsNothing()
{
    const ScoreSheet sheet = grade(attempt(std::nan(""), std::numeric_limits<double>::infinity(), 0.0));
    QCOMPARE(sheet.criteria.at(0).pointsLost, 60);
    QCOMPARE(sheet.criteria.at(1).pointsLost, 40);
}

void TestScoreSheet::agreesWithASecondImplementation()
{
    core::Rng rng(20261120);
    for (int round = 0; round < 10'000; ++round) {
        const DecayRemovalRubric rubric = round % 2 == 0 ? DecayRemovalRubric{} : randomRubric(rng);
        // Small values often: that is where points are decided. Quarters land exactly on half points.
        const double scale = rng.uniform() < 0.5 ? 10.0 : 100.0;
        double caries = rng.uniform(0.0, scale);
        double overcut = rng.uniform(0.0, scale);
        if (round % 5 == 0) {
            caries = std::floor(4.0 * caries) / 4.0;
            overcut = std::floor(4.0 * overcut) / 4.0;
        }
        const double exposed = rng.uniform() < 0.7 ? 0.0 : rng.uniform(0.0, 3.0);
        Measures measures = attempt(caries, overcut, exposed);
        measures.perforatedMm2 = rng.uniform() < 0.7 ? 0.0 : rng.uniform(0.0, 3.0);
        const ScoreSheet sheet = grade(measures, rubric);

        int left = 100;
        for (const Criterion& criterion : sheet.criteria) {
            QVERIFY2(criterion.pointsLost == slowPoints(criterion), qPrintable(QStringLiteral("round %1").arg(round)));
            left -= slowPoints(criterion);
        }
        QCOMPARE(sheet.total, left > 0 ? left : 0);
        QCOMPARE(100 - sheet.pointsLost() + sheet.pointsBelowZero(), sheet.total);
        const bool harmless = sheet.criteria.at(2).pointsLost == 0 && sheet.criteria.at(3).pointsLost == 0;
        QCOMPARE(sheet.passed(), sheet.total >= sheet.passMark && harmless);
    }
}

void TestScoreSheet::moreDamageNeverEarnsPoints()
{
    core::Rng rng(7);
    for (int round = 0; round < 2'000; ++round) {
        const DecayRemovalRubric rubric = randomRubric(rng);
        const double caries = rng.uniform(0.0, 100.0);
        const double overcut = rng.uniform(0.0, 100.0);
        const ScoreSheet better = grade(attempt(caries, overcut, 0.0), rubric);
        const ScoreSheet worse = grade(attempt(caries + rng.uniform(), overcut + rng.uniform(), rng.uniform()), rubric);
        QVERIFY(worse.total <= better.total);
    }
}

void TestScoreSheet::defaultsLieInsideTheirRanges()
{
    QVERIFY(validate(DecayRemovalRubric{}).has_value());
    for (const RubricField& field : decayRemovalFields())
        QVERIFY(field.minimum < field.maximum);
}

void TestScoreSheet::refusesARubricOutOfRange_data()
{
    QTest::addColumn<int>("field");
    for (std::size_t k = 0; k < decayRemovalFields().size(); ++k)
        QTest::newRow(decayRemovalFields()[k].id) << static_cast<int>(k);
}

void TestScoreSheet::refusesARubricOutOfRange()
{
    QFETCH(int, field);
    const RubricField& tried = decayRemovalFields()[static_cast<std::size_t>(field)];
    std::vector<double> wrong{tried.minimum - 1.0, tried.maximum + 1.0, std::nan("")};
    if (tried.whole)
        wrong.push_back(tried.minimum + 0.5);
    for (const double value : wrong) {
        DecayRemovalRubric rubric;
        rubric.*tried.value = value;
        const auto refused = validate(rubric);
        QVERIFY(!refused.has_value());
        QVERIFY(refused.error().detail.find(tried.id) != std::string::npos);
    }
}

void TestScoreSheet::jsonHoldsEveryNumberBitForBit()
{
    core::Rng rng(3);
    for (int round = 0; round < 500; ++round) {
        const ScoreSheet sheet =
            grade(attempt(rng.uniform(0.0, 100.0), rng.uniform(0.0, 100.0), rng.uniform()), randomRubric(rng));
        const QJsonObject json = QJsonDocument::fromJson(toJson(sheet)).object();
        QCOMPARE(json["rubric"].toString().toStdString(), sheet.rubricId);
        QCOMPARE(json["rubric_version"].toInt(), sheet.rubricVersion);
        QCOMPARE(json["total"].toInt(), sheet.total);
        QCOMPARE(json["pass_mark"].toInt(), sheet.passMark);
        const QJsonArray criteria = json["criteria"].toArray();
        QCOMPARE(static_cast<std::size_t>(criteria.size()), sheet.criteria.size());
        for (qsizetype k = 0; k < criteria.size(); ++k) {
            const QJsonObject object = criteria[k].toObject();
            Criterion back;
            back.id = object["id"].toString().toStdString();
            back.measured = object["measured"].toDouble();
            back.unit = object["unit"].toString().toStdString();
            back.free = object["free"].toDouble();
            back.rule = object["rule"].toString() == u"once" ? PointRule::Once : PointRule::PerUnit;
            back.pointsPerUnit = object["points_per_unit"].toDouble();
            back.maxPoints = object["max_points"].toInt();
            back.critical = object["critical"].toBool();
            back.pointsLost = object["points_lost"].toInt();
            QVERIFY(back == sheet.criteria[static_cast<std::size_t>(k)]);
        }
    }
}

QTEST_GUILESS_MAIN(TestScoreSheet)
#include "tst_score_sheet.moc"
