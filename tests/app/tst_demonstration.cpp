// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "app/attempt/Demonstration.h"
#include "cli/parts/Attempt.h"
#include "core/recording/Recording.h"
#include "lessons/LessonCatalog.h"

/// The attempts that a simulated hand makes at lessons.
class TestDemonstration : public QObject
{
    Q_OBJECT

private slots:
    void cutsTheIdeal_data()
    {
        QTest::addColumn<QString>("lesson");
        QTest::newRow("Class I") << "class1-24";
        QTest::newRow("Class II, beside a neighbour") << "class2-36-distal";
        QTest::newRow("Class II on a lower molar, mesial") << "class2-36-mesial";
        QTest::newRow("Class II on a lower premolar") << "class2-35-distal";
        QTest::newRow("Class II on an upper molar") << "class2-26-mesial";
        QTest::newRow("Class I with the oblique ridge") << "first-07-class1-26";
        QTest::newRow("Class I with a buccal extension") << "first-08-buccal-36";
        QTest::newRow("MO on a lower molar") << "first-09-mo-36";
        QTest::newRow("DO on an upper premolar") << "first-10-do-25";
        QTest::newRow("a block") << "block-line";
        QTest::newRow("pits of four depths") << "first-01-plunges";
        QTest::newRow("enamel down to the junction") << "first-02-enamel-only";
        QTest::newRow("occlusal reduction") << "first-15-reduction-36";
        QTest::newRow("decay") << "decay-36-small";
        QTest::newRow("exam, decay on a lower molar") << "exam-36-decay";
        QTest::newRow("exam, decay on an upper molar") << "exam-26-decay";
        QTest::newRow("exam, Class I") << "exam-36-class1";
        QTest::newRow("exam, Class II") << "exam-36-class2";
    }

    /// The result earns nearly full marks, and two runs give the same attempt.
    void cutsTheIdeal()
    {
        QFETCH(QString, lesson);
        const lessons::Assignment assignment = assignmentOf(lesson);
        const auto first = app::demonstrate(assignment, false);
        QVERIFY(first.has_value());
        QCOMPARE(first->recording->lesson(), assignment.lesson->json);
        const auto marked = lessons::markAgain(*first->recording);
        QVERIFY(marked.has_value());
        QVERIFY(marked->outcome.agreesWithWitness);
        QVERIFY2(marked->mark.sheet.totalTenths >= 980, qPrintable(QString::number(marked->mark.sheet.totalTenths)));
        QVERIFY(marked->conduct.infractions.empty());
        // Without the tooth, a tick takes less room than the three floats of its position.
        const core::recording::Recording begun(first->recording->settings(), assignment.anatomy,
                                               assignment.lesson->json);
        const std::size_t work = first->recording->toBytes().size() - begun.toBytes().size();
        QVERIFY2(work < 8 * first->recording->ticks(), qPrintable(QString::number(work)));
        const auto again = app::demonstrate(assignment, false);
        QCOMPARE(core::terrain::stateHash(again->tooth), core::terrain::stateHash(first->tooth));
        QCOMPARE(again->recording->toBytes(), first->recording->toBytes());
    }

    void nothingIsShownOfAnExercise()
    {
        const auto refused = app::demonstrate(assignmentOf("orientation-2-hold"), false);
        QVERIFY(!refused && refused.error().code == core::ErrorCode::WrongKind);
        QVERIFY(!lessons::lessonNamed("none").has_value());
    }

    void everyBreachHasAName()
    {
        using core::grading::RuleViolation;
        QSet<QString> names;
        constexpr int kBreaches = static_cast<int>(RuleViolation::NeighbourHit) + 1;
        for (int k = 0; k < kBreaches; ++k) {
            core::grading::Infraction infraction;
            infraction.breach = static_cast<RuleViolation>(k);
            names << cli::toJson(std::vector{infraction})[0].toObject()["what"].toString();
        }
        QCOMPARE(names.size(), kBreaches);
        QVERIFY(names.contains("neighbour_hit") && !names.contains(QString()));
    }

private:
    static lessons::Assignment assignmentOf(const QString& id)
    {
        const auto lesson = lessons::lessonNamed(id);
        return lessons::assign(lesson.value()).value().assignment;
    }
};

QTEST_GUILESS_MAIN(TestDemonstration)
#include "tst_demonstration.moc"
