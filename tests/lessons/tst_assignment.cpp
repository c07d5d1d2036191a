// SPDX-License-Identifier: GPL-3.0-or-later
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include <array>
#include <chrono>
#include <filesystem>
#include <set>

#include <glm/geometric.hpp>

#include "core/bur/Reach.h"
#include "core/grading/IdealCavity.h"
#include "core/grading/MeasureTable.h"
#include "core/grading/RuleChecker.h"
#include "core/guidance/Landmarks.h"
#include "core/preparation/ToothDesign.h"
#include "core/servo/ServoState.h"
#include "core/teeth/Block.h"
#include "lessons/Assignment.h"
#include "lessons/LessonCatalog.h"
#include "tests/support/Checks.h"
#include "tests/support/Files.h"
#include "tests/support/Suite.h"
#include "tests/support/Tables.h"
#include "tests/support/Trials.h"

using namespace lessons;

namespace {

std::vector<Lesson> withIdeal()
{
    std::vector<Lesson> found;
    for (const CatalogEntry& entry : readCatalog({}))
        if (entry.read.lesson &&
            (entry.read.lesson->task == Task::CutIdeal || entry.read.lesson->task == Task::TraceShape))
            found.push_back(*entry.read.lesson);
    return found;
}

Lesson shipped(const std::string& id)
{
    for (const CatalogEntry& entry : readCatalog({}))
        if (entry.read.lesson && entry.read.lesson->id == id)
            return *entry.read.lesson;
    qFatal("no such lesson: %s", id.c_str());
}

Assignment assigned(const std::string& id)
{
    return assign(shipped(id)).value().assignment;
}

/// Lists the criteria that lose points, each with its loss and its measured value.
QString losses(const Mark& marked)
{
    QString all;
    for (const Criterion& line : marked.sheet.criteria)
        if (line.lostTenths != 0)
            all += QStringLiteral("%1 loses %2 with %3; ")
                       .arg(QString::fromStdString(line.id))
                       .arg(0.1 * line.lostTenths)
                       .arg(line.measured ? QString::number(*line.measured) : QStringLiteral("nothing"));
    return all;
}

core::terrain::Tooth cutTo(const Assignment& assignment, const std::vector<float>& top)
{
    return core::terrain::restored(assignment.anatomy, top);
}

/// Returns the tooth cut down to these heights, but no lower than a bur reaches and without raising any column.
core::terrain::Tooth cutAsFarAsCanBe(const Assignment& assignment, std::vector<float> top)
{
    const core::terrain::ToothAnatomy& anatomy = *assignment.anatomy;
    const auto lowest = static_cast<float>(core::bur::lowestTipMm(anatomy));
    for (std::size_t k = 0; k < top.size(); ++k) {
        top[k] = std::min(anatomy.top[k], std::max(top[k], lowest));
        if (!(top[k] > anatomy.bottom[k]))
            top[k] = core::terrain::kEmptyTop;
    }
    return cutTo(assignment, top);
}

/// Mistakes that students make in a preparation that is otherwise ideal.
enum class Slip { TooShallow, FloorTooDeep, GougeBeside, QuarterGroundOff, FlatToTheFloor };

std::vector<float> spoiled(const Assignment& assignment, Slip slip)
{
    const core::terrain::ToothAnatomy& anatomy = *assignment.anatomy;
    const core::terrain::Grid& grid = anatomy.grid;
    const std::vector<float>& ideal = *assignment.ideal->top;
    std::vector<float> top = ideal;
    float lowest = 0.0F;
    for (std::size_t k = 0; k < top.size(); ++k)
        if (assignment.ideal->parts[k] == core::grading::Part::Floor)
            lowest = std::min(lowest, ideal[k]);
    for (int j = 0; j < grid.side; ++j)
        for (int i = 0; i < grid.side; ++i) {
            const std::size_t k = grid.index(i, j);
            const glm::dvec2 at = grid.nodeMm(i, j);
            if (slip == Slip::TooShallow && ideal[k] < anatomy.top[k])
                top[k] = anatomy.top[k] - 0.78F * (anatomy.top[k] - ideal[k]);
            if (slip == Slip::FloorTooDeep && assignment.ideal->parts[k] == core::grading::Part::Floor)
                top[k] -= 1.2F;
            if (slip == Slip::GougeBeside && at.y > 2.8 && at.y < 3.8 && std::abs(at.x) < 1.5)
                top[k] = std::min(top[k], anatomy.top[k] - 1.5F);
            if (slip == Slip::QuarterGroundOff && at.x > 0.0 && at.y > 0.0)
                top[k] = std::min(top[k], anatomy.top[k] - 1.5F);
            if (slip == Slip::FlatToTheFloor)
                top[k] = std::min(top[k], lowest);
        }
    return top;
}

QJsonObject lessonSchema()
{
    const std::string text = support::bytesOf(CUSP_SOURCE_DIR "/lessons/schema/lesson.schema.json");
    return QJsonDocument::fromJson(QByteArray::fromStdString(text)).object();
}

/// Collects every key of an object and of the objects in it. The names of texts and sizes are left out.
void keysOf(const QJsonObject& object, const QString& before, QSet<QString>& keys)
{
    static const QSet<QString> kOpen{"title", "goal", "course", "not_modelled", "text", "hint", "sizes"};
    for (const QString& key : object.keys()) {
        keys << before + key;
        if (kOpen.contains(key))
            continue;
        if (object[key].isObject())
            keysOf(object[key].toObject(), before + key + '.', keys);
        for (const QJsonValue item : object[key].toArray())
            if (item.isObject())
                keysOf(item.toObject(), before + key + '.', keys);
    }
}

void schemaKeysOf(const QJsonObject& schema, const QJsonObject& definitions, const QString& before, QSet<QString>& keys)
{
    const QString name = schema["$ref"].toString().section('/', -1);
    if (name == "text" || name == "id")
        return;
    if (!name.isEmpty())
        schemaKeysOf(definitions[name].toObject(), definitions, before, keys);
    for (const QJsonValue choice : schema["oneOf"].toArray())
        schemaKeysOf(choice.toObject(), definitions, before, keys);
    if (schema["items"].isObject())
        schemaKeysOf(schema["items"].toObject(), definitions, before, keys);
    const QJsonObject properties = schema["properties"].toObject();
    for (const QString& key : properties.keys()) {
        keys << before + key;
        schemaKeysOf(properties[key].toObject(), definitions, before + key + '.', keys);
    }
}

}  // namespace

class TestAssignment : public QObject
{
    Q_OBJECT

private slots:
    void theOutlineBeginsOnlyWhereItGivesNothingAway()
    {
        QVERIFY(beginsWithOutline(assigned("class1-36")));
        QVERIFY(!beginsWithOutline(assigned("exam-36-class1")));
        QVERIFY(!beginsWithOutline(assigned("decay-36-moderate")));
        Assignment free = assigned("class1-36");
        free.lesson.reset();
        QVERIFY(!beginsWithOutline(free));
    }

    void theRuleAboutThePulpHasTheLimitOfTheRubric()
    {
        const auto limitOf = [](const Assignment& assignment) { return examinationOf(assignment).rules.pulpLimitMm2; };
        for (const char* id : {"class1-36", "decay-36-moderate", "exam-36-class1"})
            QCOMPARE(limitOf(assigned(id)), std::optional(0.05));
        QVERIFY(!limitOf(assigned("access-36")));  // the pulp has to be opened
        Assignment own = assigned("class1-36");
        for (CriterionRule& rule : own.lesson->rubric.criteria)
            if (rule.measure == "pulp_exposed_mm2")
                rule.tolerance = 0.0;
        QCOMPARE(limitOf(own), std::optional(0.0));
        own.lesson->rubric.criteria.clear();
        QCOMPARE(limitOf(own), std::optional(core::grading::kPulpLimitMm2));
    }

    void theDepthStopBeginsAtTheFloorThatIsCutFirst_data()
    {
        QTest::addColumn<double>("least");
        QTest::addColumn<double>("most");
        QTest::newRow("class1-36") << 1.5 << 1.5;
        QTest::newRow("class2-36-mesial") << 1.5 << 1.5;
        QTest::newRow("class2-35-distal") << 1.5 << 1.5;
        QTest::newRow("access-36") << 5.0 << 7.5;
        QTest::newRow("block-square") << 1.49 << 1.51;
        QTest::newRow("decay-36-moderate") << 1.4 << 3.5;
    }
    void theDepthStopBeginsAtTheFloorThatIsCutFirst()
    {
        QFETCH(const double, least);
        QFETCH(const double, most);
        const double depth = depthToCutMm(assigned(QTest::currentDataTag()));
        QVERIFY2(depth >= least && depth <= most, qPrintable(QString::number(depth)));
    }

    void everyPlaceThatAStepNamesIsThere()
    {
        for (const Lesson& lesson : withIdeal()) {
            std::optional<Assignment> assignment;
            for (const Step& step : lesson.steps) {
                if (!step.mark)
                    continue;
                if (!assignment)
                    assignment = assigned(lesson.id);
                const auto places =
                    core::guidance::findLandmark(*step.mark, *assignment->anatomy, *assignment->shownIdeal());
                QVERIFY2(!places.empty(), inLanguage(step.text, "en").c_str());
            }
        }
    }

    void everyIdealEarnsFullPoints_data()
    {
        QTest::addColumn<QString>("id");
        for (int n = 0; const Lesson& lesson : withIdeal())
            if (support::isTried(n++))
                QTest::newRow(lesson.id.c_str()) << QString::fromStdString(lesson.id);
    }

    /// A preparation cut to the ideal, as far as a bur reaches, loses no points. An untouched tooth earns none.
    void everyIdealEarnsFullPoints()
    {
        QFETCH(QString, id);
        const Assignment assignment = assigned(id.toStdString());
        QVERIFY(assignment.ideal.has_value());
        const Conduct blameless;
        const Mark perfect = mark(assignment, cutAsFarAsCanBe(assignment, *assignment.ideal->top), blameless).value();
        QCOMPARE(losses(perfect), QString());
        QVERIFY(perfect.sheet.passed());
        QCOMPARE(mark(assignment, core::terrain::Tooth(assignment.anatomy))->sheet.totalTenths, 0);
    }

    void everyLesionCanBeCleared_data()
    {
        QTest::addColumn<QString>("id");
        int n = 0;
        for (const CatalogEntry& entry : readCatalog({}))
            if (entry.read.lesson && entry.read.lesson->lesion && entry.read.lesson->lesion->extent > 0.7 &&
                support::isTried(n++))
                QTest::newRow(entry.read.lesson->id.c_str()) << QString::fromStdString(entry.read.lesson->id);
    }

    /// In every deep lesion, all decay that must be removed can be removed with the tissue above it, without opening
    /// the pulp or perforating the tooth.
    void everyLesionCanBeCleared()
    {
        QFETCH(QString, id);
        const Assignment assignment = assigned(id.toStdString());
        const auto cleared = core::grading::idealCavity(*assignment.anatomy);
        QCOMPARE(losses(mark(assignment, cutAsFarAsCanBe(assignment, *cleared)).value()), QString());
    }

    /// The decay of front teeth is on a side, and a bur that comes from that side can remove it.
    void decayOfFrontTeethIsOnASide()
    {
        int laid = 0;
        for (const CatalogEntry& entry : readCatalog({})) {
            const Lesson& lesson = *entry.read.lesson;
            const auto* made = std::get_if<MadeTooth>(&lesson.tooth);
            if (lesson.task != Task::RemoveDecay || made == nullptr || made->fdi % 10 > 3)
                continue;
            QVERIFY2(!made->lying.isUpright() && lesson.lesion->site, lesson.id.c_str());
            ++laid;
        }
        QVERIFY(laid > 0);
    }

    /// A recording of an attempt on a tooth that lies on a side gets the same marks again wherever it is read.
    void anAttemptAtALaidToothIsMarkedAgain()
    {
        const Assignment assignment = assigned("decay-33-moderate");
        QVERIFY(!assignment.anatomy->lying.isUpright());
        const core::recording::Recording recording({}, assignment.anatomy, assignment.lesson->json);
        const auto read = core::recording::Recording::fromBytes(recording.toBytes());
        QVERIFY(support::succeeds(read));
        QCOMPARE(read->anatomy()->lying, assignment.anatomy->lying);
        const auto again = assignmentOf(read->anatomy(), read->lesson());
        QVERIFY(support::succeeds(again));
        QCOMPARE(again->lesson->hash, assignment.lesson->hash);
        QCOMPARE(markAgain(*read)->mark.sheet.totalTenths, 0);
    }

    void decayLeftAloneEarnsNothing()
    {
        const Assignment assignment = assigned("decay-36-moderate");
        const Mark nothing = mark(assignment, core::terrain::Tooth(assignment.anatomy)).value();
        QCOMPARE(nothing.sheet.totalTenths, 0);
        QVERIFY(nothing.sheet.criteria.at(1).isTooEarly);
    }

    void everyClassOneIsThereAndNothingDonePassesNone()
    {
        QSet<int> teeth;
        for (const Lesson& lesson : withIdeal())
            if (lesson.ideal && lesson.ideal->kind == "class1")
                teeth << std::get<MadeTooth>(lesson.tooth).fdi;
        QCOMPARE(teeth, (QSet<int>{24, 25, 26, 27, 34, 35, 36, 37}));
    }

    void whatNoInstructorPassesFails_data()
    {
        support::columns<QString, int>("id", "slip");
        const auto row = [](const char* id, const char* what, Slip slip) {
            QTest::addRow("%s, %s", id, what) << QString::fromLatin1(id) << static_cast<int>(slip);
        };
        for (const char* id : {"class1-36", "class1-24", "class1-26", "class2-36-distal", "class2-36-mesial",
                               "class2-35-distal", "class2-26-mesial", "access-36", "access-21", "first-07-class1-26",
                               "first-08-buccal-36", "first-09-mo-36", "first-10-do-25", "first-11-slot-35"}) {
            row(id, "floor too deep", Slip::FloorTooDeep);
            row(id, "gouge beside", Slip::GougeBeside);
            row(id, "quarter ground off", Slip::QuarterGroundOff);
        }
        row("access-21", "chamber not opened", Slip::TooShallow);
        row("first-15-reduction-36", "surface too low", Slip::FloorTooDeep);
        row("first-15-reduction-36", "quarter ground off", Slip::QuarterGroundOff);
        row("first-15-reduction-36", "flat to the floor", Slip::FlatToTheFloor);
        for (const char* id :
             {"block-circle", "block-cross", "block-staircase", "first-01-plunges", "first-02-enamel-only"}) {
            row(id, "floor too deep", Slip::FloorTooDeep);
            row(id, "quarter ground off", Slip::QuarterGroundOff);
            row(id, "flat to the floor", Slip::FlatToTheFloor);
        }
    }

    /// More than 1.0 mm too deep or too wide fails (docs/facts/teaching.md, section 4), and so does cutting through the
    /// side or the bottom of a block (section 5), however good the rest is.
    void whatNoInstructorPassesFails()
    {
        QFETCH(QString, id);
        QFETCH(int, slip);
        const Assignment assignment = assigned(id.toStdString());
        const Mark marked = mark(assignment, cutTo(assignment, spoiled(assignment, static_cast<Slip>(slip)))).value();
        QVERIFY2(!marked.sheet.passed(), qPrintable(QString::number(0.1 * marked.sheet.totalTenths)));
    }

    /// The box is cut through where the tooth bulges over it, and the shell before the neighbouring tooth is removed
    /// last (docs/teeth.md).
    void aShellLeftBeforeTheNeighbourIsNoHole()
    {
        const Assignment assignment = assigned("class2-36-distal");
        const core::terrain::ToothAnatomy& anatomy = *assignment.anatomy;
        const int shell = static_cast<int>(0.3 / anatomy.grid.cellMm);
        std::vector<float> top = *assignment.ideal->top;
        for (int j = 0; j < anatomy.grid.side; ++j) {
            int rim = anatomy.grid.side - 1;
            while (rim >= 0 && !(anatomy.top[anatomy.grid.index(rim, j)] > anatomy.bottom[anatomy.grid.index(rim, j)]))
                --rim;
            for (int i = std::max(0, rim - shell); i <= rim; ++i)
                top[anatomy.grid.index(i, j)] = anatomy.top[anatomy.grid.index(i, j)];
        }
        const core::terrain::Tooth tooth = cutTo(assignment, top);
        QVERIFY(!core::terrain::perforations(tooth).empty());
        const Mark marked = mark(assignment, tooth).value();
        QCOMPARE(marked.measured.measures.perforatedMm2, 0.0);
        QVERIFY(!marked.sheet.failedCritically());
    }

    void everyBoxHasItsNeighbour_data()
    {
        QTest::addColumn<QString>("id");
        for (const Lesson& lesson : withIdeal())
            if (lesson.ideal && (lesson.ideal->kind.starts_with("class2") || lesson.ideal->kind.starts_with("slot")))
                QTest::newRow(lesson.id.c_str()) << QString::fromStdString(lesson.id);
    }

    /// The box is open towards the neighbouring tooth: a bur that moves on outwards touches that tooth, and a bur
    /// inside the box does not.
    void everyBoxHasItsNeighbour()
    {
        QFETCH(QString, id);
        const Assignment assignment = assigned(id.toStdString());
        QVERIFY(assignment.neighbours != nullptr);
        const double outwards = assignment.lesson->ideal->kind.ends_with("mesial") ? -1.0 : 1.0;
        const core::terrain::Grid& grid = assignment.anatomy->grid;
        glm::dvec2 edge(-outwards * 100.0, 0.0);
        for (int j = 0; j < grid.side; ++j)
            for (int i = 0; i < grid.side; ++i)
                if (const glm::dvec2 node = grid.nodeMm(i, j);
                    assignment.ideal->parts[grid.index(i, j)] != core::grading::Part::Keep &&
                    outwards * (node.x - edge.x) > 0.0)
                    edge = node;
        core::grading::Rules rules;
        rules.neighbours = assignment.neighbours;
        const core::terrain::Tooth tooth(assignment.anatomy);
        core::grading::RuleChecker referee(rules, assignment.anatomy, nullptr);
        core::servo::ServoState state;
        state.drillOn = true;
        state.burIndex = static_cast<std::uint8_t>(core::bur::findBur("330").value());
        const auto hitsAt = [&](double beyondMm) {
            state.anchorMm = {edge.x + outwards * beyondMm, edge.y, -3.0};
            const auto found = referee.look(state, {}, tooth, std::chrono::milliseconds(1));
            return found.size() == 1 && found.front().breach == core::grading::RuleViolation::NeighbourHit;
        };
        QVERIFY(!hitsAt(-0.6));
        QVERIFY(hitsAt(0.9));
    }

    void aBoxHasTheFiguresOfItsLesson_data()
    {
        support::columns<QString, double, double>("id", "least", "most");
        QTest::newRow("MO of 36") << "first-09-mo-36" << 1.2 << 1.5;
        QTest::newRow("DO of 25") << "first-10-do-25" << 1.2 << 1.3;
        QTest::newRow("slot of 35") << "first-11-slot-35" << 1.2 << 1.5;
        QTest::newRow("step of 36") << "first-08-buccal-36" << 1.0 << 1.5;
    }

    void aBoxHasTheFiguresOfItsLesson()
    {
        QFETCH(const QString, id);
        QFETCH(const double, least);
        QFETCH(const double, most);
        const Assignment assignment = assigned(id.toStdString());
        const Mark marked = mark(assignment, cutTo(assignment, *assignment.ideal->top), Conduct{}).value();
        const double axialMm = marked.measured.deviation->form.axialDepthMm->value;
        QVERIFY2(axialMm >= least && axialMm <= most, qPrintable(QString::number(axialMm)));
    }

    /// One touch of the neighbour fails the attempt, however good the box is.
    void aTouchOfTheNeighbourFailsTheFirstBoxes()
    {
        for (const char* id : {"first-09-mo-36", "first-10-do-25", "first-11-slot-35"}) {
            const Assignment assignment = assigned(id);
            const core::terrain::Tooth whole = cutAsFarAsCanBe(assignment, *assignment.ideal->top);
            QVERIFY2(mark(assignment, whole, Conduct{})->sheet.passed(), id);
            Conduct touching;
            touching.infractions.emplace_back().breach = core::grading::RuleViolation::NeighbourHit;
            const Mark marked = mark(assignment, whole, touching).value();
            QVERIFY2(!marked.sheet.passed() && marked.sheet.totalTenths > 0, id);
        }
    }

    /// A ridge that the box leaves is measured, and the ridge that the box cuts through is not.
    void aRidgeThatABoxLeavesCounts()
    {
        const Assignment assignment = assigned("first-09-mo-36");
        const core::terrain::Grid& grid = assignment.anatomy->grid;
        double distalMm = -100.0;  // of the ideal
        for (std::size_t k = 0; k < grid.count(); ++k)
            if (assignment.ideal->parts[k] != core::grading::Part::Keep)
                distalMm = std::max(distalMm, grid.nodeMm(k).x);
        const auto cutOnBy = [&](double mm) {
            std::vector<float> top = *assignment.ideal->top;
            for (std::size_t k = 0; k < top.size(); ++k) {
                const glm::dvec2 at = grid.nodeMm(k);
                if (at.x > distalMm - 1.0 && at.x < distalMm + mm && std::abs(at.y) < 0.6)
                    top[k] = std::min(top[k], assignment.anatomy->top[k] - 1.5F);
            }
            return mark(assignment, cutAsFarAsCanBe(assignment, top), Conduct{}).value();
        };
        const auto lost = [](const Mark& marked) {
            return core::grading::findMeasure("ridge_lost_mm")->value(marked.measured).value();
        };
        const Mark whole = mark(assignment, cutAsFarAsCanBe(assignment, *assignment.ideal->top), Conduct{}).value();
        QVERIFY(lost(whole) < 0.05);
        const Mark thinner = cutOnBy(0.9);
        QVERIFY2(std::abs(lost(thinner) - 0.9) < 0.2, qPrintable(QString::number(lost(thinner))));
        QVERIFY(thinner.sheet.totalTenths <= 650 && thinner.sheet.totalTenths > 0);
        QVERIFY(cutOnBy(3.0).sheet.totalTenths <= 300);
    }

    /// Near its rim a tooth is so narrow that a deep box goes through it. This does not count as a perforation.
    void aBoxThatIsTooDeepIsNoPerforation()
    {
        const Assignment assignment = assigned("first-10-do-25");
        const core::terrain::ToothAnatomy& anatomy = *assignment.anatomy;
        for (const float deeper : {0.2F, 0.46F, 0.57F, 0.8F}) {
            std::vector<float> top = *assignment.ideal->top;
            for (std::size_t k = 0; k < top.size(); ++k)
                if (assignment.ideal->parts[k] != core::grading::Part::Keep)
                    top[k] = top[k] - deeper > anatomy.bottom[k] ? top[k] - deeper : core::terrain::kEmptyTop;
            const Mark marked = mark(assignment, cutTo(assignment, top), Conduct{}).value();
            QVERIFY2(core::grading::findMeasure("perforated_mm2")->value(marked.measured).value() <= 0.0,
                     qPrintable(QString::number(deeper)));
        }
    }

    void anObliqueRidgeCutThroughLimitsTheScore()
    {
        const Assignment assignment = assigned("first-07-class1-26");
        std::vector<float> top = *assignment.ideal->top;
        const auto& crest = assignment.ideal->obliqueCrest;
        QVERIFY(!crest.empty());
        for (std::size_t k = 0; k < top.size(); ++k)
            if (glm::distance(assignment.anatomy->grid.nodeMm(k), crest[crest.size() / 2]) < 0.3)
                top[k] = std::min(top[k], assignment.anatomy->top[k] - 0.5F);
        const Mark marked = mark(assignment, cutTo(assignment, top), Conduct{}).value();
        QVERIFY(marked.sheet.totalTenths <= 500 && marked.sheet.totalTenths > 0);
    }

    void tooDeepCostsDepthAlone()
    {
        const Assignment assignment = assigned("class1-36");
        std::vector<float> top = *assignment.ideal->top;
        for (std::size_t k = 0; k < top.size(); ++k)
            if (assignment.ideal->parts[k] == core::grading::Part::Floor)
                top[k] -= 0.5F;
        const Mark marked = mark(assignment, cutTo(assignment, top)).value();
        for (const Criterion& line : marked.sheet.criteria) {
            if (line.id == "depth") {
                QVERIFY(std::abs(line.measured.value() - 0.5) < 0.01);
                QCOMPARE(line.lostTenths, 72);  // 12 points * (0.5 - 0.2) / 0.5
            } else if (line.id == "outline" || line.id == "isthmus" || line.id == "ridge" || line.id == "floor") {
                QCOMPARE(line.lostTenths, 0);
            }
        }
    }

    void aRecordingIsMarkedForItsLesson()
    {
        const Lesson lesson = shipped("block-line");
        const auto anatomy = assign(lesson)->assignment.anatomy;
        const auto remarked = markAgain(core::recording::Recording({}, anatomy, lesson.json));
        QVERIFY(support::succeeds(remarked));
        QCOMPARE(remarked->mark.sheet.rubricHash, lesson.rubric.hash);
        QVERIFY(remarked->mark.measured.deviation->zones.has_value());
        QVERIFY(!markAgain(core::recording::Recording({}, anatomy, "{\"format\": 99}")).has_value());
        QCOMPARE(markAgain(core::recording::Recording({}, anatomy))->mark.sheet.rubricId, std::string("decay_removal"));
    }

    void everyExerciseDoneEarnsFullPointsAndNothingDonePassesNone()
    {
        using namespace core::grading;
        QStringList found;
        for (const CatalogEntry& entry : readCatalog({})) {
            const Lesson& lesson = *entry.read.lesson;
            if (!isExercise(lesson.task))
                continue;
            found << QString::fromStdString(lesson.id);
            const Assignment assignment = assign(lesson).value().assignment;
            QVERIFY(assignment.exercise.has_value());
            QVERIFY(assignment.shownIdeal() == nullptr);
            Practised nothing = Named{};
            Practised all = Named{};
            if (const auto* touch = std::get_if<PointsToTouch>(&*assignment.exercise)) {
                nothing = Touched{std::vector<std::optional<double>>(touch->pointsMm.size())};
                all = Touched{std::vector<std::optional<double>>(touch->pointsMm.size(), 30.0)};
            } else if (std::holds_alternative<ForceToHold>(*assignment.exercise)) {
                nothing = Held{};
                all = Held{10.0, 10.0, 12.0, 15.0, 0.15, true};
            } else {
                const auto& pads = std::get<PadsToName>(*assignment.exercise);
                all = Named{{pads.madeOf[0], pads.madeOf[1], pads.madeOf[2]}, 3};
            }
            const core::terrain::Tooth tooth(assignment.anatomy);
            QCOMPARE(mark(assignment, tooth, Conduct{{}, {}, 0, all})->sheet.totalTenths, kFullTenths);
            QVERIFY2(!mark(assignment, tooth, Conduct{{}, {}, 0, nothing})->sheet.passed(), lesson.id.c_str());
            // The exercise of the recording is the same, so that it is assessed alike live and in every replay.
            const Assignment again = assignmentOf(assignment.anatomy, lesson.json).value();
            QVERIFY(again.exercise == assignment.exercise);
            QVERIFY(examinationOf(again).exercise == assignment.exercise);
        }
        // The orientation lessons come before all others.
        QCOMPARE(found, (QStringList{"orientation-1-touch", "orientation-2-hold", "orientation-3-layers"}));
        QCOMPARE(readCatalog({}).front().read.lesson->id, std::string("orientation-1-touch"));
    }

    void layersComeInAnotherOrderAndEveryReplayKnowsIt()
    {
        using namespace core::grading;
        Lesson lesson = shipped("orientation-3-layers");
        QVERIFY(!std::get<Block>(lesson.tooth).seed);
        std::set<std::array<core::terrain::Material, kPads>> orders;
        for (std::uint64_t drawn = 0; drawn < 30; ++drawn) {
            const Assignment asked = assign(lesson, drawn).value().assignment;
            const auto& pads = std::get<PadsToName>(*asked.exercise);
            orders.insert(pads.madeOf);
            // The recording holds all that is needed to set the same exercise and to mark it.
            core::recording::Recording recording({}, asked.anatomy, lesson.json);
            for (std::size_t pad = 0; pad < kPads; ++pad)
                recording.append({core::servo::ServoEvent::Kind::Note, 0, glm::vec3(0.0F),
                                  answerNote(pad, pads.madeOf[pad == 2 ? 0 : pad])});
            recording.append({core::servo::ServoEvent::Kind::NoDevice, 1000, glm::vec3(0.0F), 0});
            const auto read = core::recording::Recording::fromBytes(recording.toBytes());
            QVERIFY(read.has_value());
            QVERIFY(assignmentOf(read->anatomy(), read->lesson()).value().exercise == asked.exercise);
            const auto marked = markAgain(*read);
            QVERIFY(support::succeeds(marked));
            QCOMPARE(std::get<Named>(*marked->conduct.practised).right, 2);
        }
        QCOMPARE(orders.size(), std::size_t{6});
        // If the teacher sets a seed, the order is that of the seed.
        std::get<Block>(lesson.tooth).seed = 5;
        for (const std::uint64_t drawn : {0U, 1U, 2U})
            QVERIFY(std::get<PadsToName>(*assign(lesson, drawn).value().assignment.exercise).madeOf ==
                    core::teeth::padMaterials(5));
    }

    void anExpertsAttemptMustBeOfTheLessonsTooth()
    {
        QTemporaryDir folder;
        const auto write = [&](const Assignment& at, const char* name) {
            const std::filesystem::path path = folder.filePath(name).toStdString();
            QVERIFY(core::recording::writeRecording(path, core::recording::Recording({}, at.anatomy, at.lesson->json)));
        };
        const Lesson lesson = shipped("decay-36-moderate");
        Assignment own = assign(lesson).value().assignment;
        own.lesson->expert = Expert{folder.filePath("expert.cusprec").toStdString(), {}};
        const auto complaint = [&] {
            const auto expert = readExpert(own);
            return expert ? QString() : QString::fromStdString(expert.error().detail);
        };
        QVERIFY2(complaint().contains("There is no recording at") && complaint().contains("expert.cusprec"),
                 qPrintable(complaint()));
        write(own, "expert.cusprec");
        QCOMPARE(complaint(), QString());
        // A recording is refused if it is of another tooth, variation, decay or grid.
        Lesson varied = lesson;
        std::get<MadeTooth>(varied.tooth).seed += 1;
        Lesson coarse = lesson;
        coarse.gridSide = 100;
        for (const Lesson& other : {shipped("decay-37-moderate"), varied, shipped("decay-36-deep"), coarse}) {
            write(assign(other).value().assignment, "expert.cusprec");
            QVERIFY2(complaint().startsWith("expert.cusprec: the attempt is at the tooth '"), qPrintable(complaint()));
            QCOMPARE(readExpert(own).error().code, core::ErrorCode::OtherTooth);
        }
        // The order of the layers may differ, because each order teaches the same.
        Assignment layers = assign(shipped("orientation-3-layers"), 1).value().assignment;
        write(assign(shipped("orientation-3-layers"), 2).value().assignment, "expert.cusprec");
        layers.lesson->expert = own.lesson->expert;
        QVERIFY(readExpert(layers).has_value());
        // A lesson resumed from a journal has only the file name of the recording.
        own.lesson->expert->file = "expert.cusprec";
        QVERIFY2(complaint().contains("open the lesson anew"), qPrintable(complaint()));
        own.lesson->expert.reset();
        QVERIFY(!readExpert(own));
    }

    void aPointBesideTheToothIsNamed()
    {
        Lesson lesson = shipped("orientation-1-touch");
        lesson.touch->pointsMm[1] = {9.5, 0.0};
        QVERIFY(support::isRefused(assign(lesson), "touch.points[1]: there is no tooth at x = 9.5, y = 0 mm"));
    }

    /// The schema contains each key of every shipped file, and the reader knows each key of the schema.
    void theSchemaKnowsTheKeysThatAreRead()
    {
        const QJsonObject schema = lessonSchema();
        QVERIFY(!schema.isEmpty());
        QSet<QString> inSchema;
        schemaKeysOf(schema, schema["$defs"].toObject(), {}, inSchema);
        QSet<QString> used;
        for (const CatalogEntry& entry : readCatalog({}))
            keysOf(QJsonDocument::fromJson(QByteArray::fromStdString(entry.read.lesson->json)).object(), {}, used);
        QVERIFY2((used - inSchema).isEmpty(), qPrintable(QStringList((used - inSchema).values()).join(' ')));

        // The reader knows each key of the schema: it may complain about the value 1, but it warns of no key.
        const auto warns = [](const QJsonObject& lesson) {
            const ReadLesson read = readLessonText(QJsonDocument(lesson).toJson(), QStringLiteral("probe"));
            return std::any_of(read.faults.begin(), read.faults.end(),
                               [](const ValidationIssue& fault) { return !fault.grave; });
        };
        for (const QString& path : std::as_const(inSchema)) {
            const QStringList keys = path.split('.');
            const bool isBase =
                keys[0] == "based_on" || path == "rubric.based_on";      // looked up before the keys are read
            const bool isSize = keys.size() == 3 && keys[1] == "sizes";  // see theSchemaOffersWhatThereIs()
            if (isBase || isSize)
                continue;
            QJsonValue value = 1;
            for (qsizetype k = keys.size() - 1; k > 0; --k) {
                QJsonObject object{{keys[k], value}};
                if (keys[0] == "tooth" && keys.size() == 2)  // some keys belong to one kind of tooth
                    object[path == "tooth.seed" || path == "tooth.sizes" ? "block" : "scan"] = "line";
                value = object;
                if (keys[k - 1] == "steps" || keys[k - 1] == "criteria")
                    value = QJsonArray{value};
            }
            QVERIFY2(!warns({{"format", 1}, {keys[0], value}}), qPrintable(path));
        }
    }

    /// The schema offers exactly the numbers and names that the reader accepts.
    void theSchemaOffersWhatThereIs()
    {
        const QJsonObject schema = lessonSchema();
        const QJsonObject keys = schema["properties"].toObject();
        const auto part = [](const QJsonObject& of, const char* key) {
            return of["properties"].toObject()[key].toObject();
        };
        // tst_bur and tst_measure_table compare the two lists with their tables.
        QCOMPARE(keys["burs"].toObject()["items"].toObject()["$ref"].toString(), QString("#/$defs/bur"));
        const QJsonObject criterion =
            part(schema["$defs"].toObject()["rubric"].toObject(), "criteria")["items"].toObject();
        for (const QJsonObject& named : {criterion, part(criterion, "allowance"), part(criterion, "once")})
            QCOMPARE(part(named, "measure")["$ref"].toString(), QString("#/$defs/measure"));

        const auto isOffered = [](const QJsonObject& sizes, const auto& field) {
            const QJsonObject size = sizes["properties"].toObject()[field.id].toObject();
            return size["minimum"].toDouble(-1.0) == field.minimum && size["maximum"].toDouble(-1.0) == field.maximum &&
                   size["type"].toArray()[0].toString() == (field.whole ? "integer" : "number");
        };
        for (const auto& field : core::teeth::blockFields())
            QVERIFY2(isOffered(part(keys["tooth"].toObject(), "sizes"), field), field.id);
        for (const auto kind : {core::preparation::Kind::ClassTwoMesial, core::preparation::Kind::Access,
                                core::preparation::Kind::OcclusalReduction})
            for (const auto& field : core::preparation::fieldsOf(kind))
                QVERIFY2(isOffered(part(keys["ideal"].toObject(), "sizes"), field), field.id);
    }
};

CUSP_TEST(TestAssignment)
#include "tst_assignment.moc"
