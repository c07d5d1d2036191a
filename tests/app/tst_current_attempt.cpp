// SPDX-License-Identifier: GPL-3.0-or-later
// The life cycle of an attempt, without a window: every transition, an exam, a resumed attempt, an undone mistake.
#include <QTest>

#include "app/attempt/CurrentAttempt.h"
#include "app/attempt/GradeDestination.h"
#include "app/school/OfflineUnlock.h"
#include "tests/support/SyntheticTooth.h"

using namespace std::chrono_literals;
using app::CurrentAttempt;
using app::GradeCircumstances;
using app::OfflineUnlock;
using core::grading::Infraction;
using core::grading::RuleViolation;
using core::session::AttemptSnapshot;
using Exam = CurrentAttempt::Exam;
using Keeping = ui::scoring::ScorePage::Keeping;
using State = CurrentAttempt::State;

namespace {

std::shared_ptr<const core::terrain::ToothAnatomy> block()
{
    static const auto made = [] {
        support::Block small;
        small.side = 16;
        return support::makeBlock(small);
    }();
    return made;
}

lessons::Assignment practice()
{
    return lessons::practiceOn(block()).value();
}

lessons::Assignment exam()
{
    lessons::Assignment made = practice();
    made.lesson.emplace();
    made.lesson->id = "exam";
    made.lesson->exam = true;
    return made;
}

/// Returns a snapshot of the attempt of a generation after a number of ticks.
std::optional<AttemptSnapshot> work(std::uint64_t generation, std::uint64_t ticks = 0)
{
    core::session::Findings findings;
    findings.generation = generation;
    findings.ticks = ticks;
    return AttemptSnapshot{{{}, block()}, core::terrain::Tooth(block()), findings};
}

void conclude(CurrentAttempt& attempt, std::uint64_t ticks = 0, bool isExamOver = false)
{
    QVERIFY(attempt.settle());
    attempt.conclude([&] { return work(attempt.generation(), ticks); }, isExamOver);
    QCOMPARE(attempt.state(), State::Predicting);
}

Infraction violation(RuleViolation rule, std::uint64_t tick)
{
    Infraction made;
    made.breach = rule;
    made.tick = tick;
    return made;
}

}  // namespace

class TestCurrentAttempt : public QObject
{
    Q_OBJECT
private slots:
    void init() { m_attempt = {}; }

    void isEmptyWithoutTooth()
    {
        QCOMPARE(m_attempt.state(), State::Empty);
        QVERIFY(!m_attempt.hasTooth());
        QVERIFY(!m_attempt.settle());
        QVERIFY(!m_attempt.grade());
        QVERIFY(!m_attempt.startExam());
        QCOMPARE(m_attempt.state(), State::Empty);
    }

    void goesFromReadyToGraded()
    {
        m_attempt.begin(3, practice(), {});
        QCOMPARE(m_attempt.state(), State::Ready);
        QCOMPARE(m_attempt.generation(), 3U);
        QVERIFY(m_attempt.hasTooth() && !m_attempt.isExam() && !m_attempt.isGraded());
        QVERIFY(m_attempt.settle());
        QCOMPARE(m_attempt.state(), State::Settling);
        QVERIFY(!m_attempt.settle());  // a second click on "Grade" does not start a second grading
        m_attempt.conclude([] { return work(3, 40); }, false);
        QCOMPARE(m_attempt.state(), State::Predicting);
        const auto toGrade = m_attempt.grade();
        QVERIFY(toGrade);
        QCOMPARE(toGrade->findings.ticks, 40U);
        QCOMPARE(m_attempt.state(), State::Graded);
        QVERIFY(m_attempt.isGraded());
        QVERIFY(!m_attempt.grade());  // graded once
        QCOMPARE(m_attempt.state(), State::Graded);
    }

    void goesBackWhereNothingIsToBeGraded()
    {
        m_attempt.begin(1, practice(), {});
        QVERIFY(m_attempt.settle());
        m_attempt.stopSettling();
        QCOMPARE(m_attempt.state(), State::Ready);
        conclude(m_attempt);
        QVERIFY(m_attempt.grade());
        QVERIFY(m_attempt.settle());
        m_attempt.stopSettling();
        QCOMPARE(m_attempt.state(), State::Graded);
        m_attempt.stopSettling();
        QCOMPARE(m_attempt.state(), State::Graded);
    }

    /// If the student leaves the prediction page and cuts on, the work is graded as it is at the next request.
    void canBeAskedAgainBeforeThePrediction()
    {
        m_attempt.begin(1, practice(), {});
        conclude(m_attempt, 10);
        conclude(m_attempt, 20);
        QCOMPARE(m_attempt.grade()->findings.ticks, 20U);
    }

    /// After a grade the student can cut on and get another grade for the same tooth.
    void canBeGradedTwice()
    {
        m_attempt.begin(1, practice(), {});
        conclude(m_attempt, 10);
        QVERIFY(m_attempt.grade());
        conclude(m_attempt, 20);
        QVERIFY(m_attempt.isGraded());
        QCOMPARE(m_attempt.grade()->findings.ticks, 20U);
    }

    void anotherToothEndsEveryState_data()
    {
        QTest::addColumn<int>("steps");
        for (int steps = 0; steps < 4; ++steps)
            QTest::addRow("%d", steps) << steps;
    }
    void anotherToothEndsEveryState()
    {
        QFETCH(const int, steps);
        m_attempt.begin(1, exam(), {});
        m_attempt.resume(5, app::GradedMarker{"uid", 9, 800});
        if (steps > 0)
            QVERIFY(m_attempt.settle());
        if (steps > 1)
            m_attempt.conclude([] { return work(1); }, true);
        if (steps > 2)
            QVERIFY(m_attempt.grade());
        m_attempt.begin(2, practice(), {});
        QCOMPARE(m_attempt.state(), State::Ready);
        QVERIFY(!m_attempt.isExam() && !m_attempt.isResumed() && !m_attempt.isGraded() && !m_attempt.seenBefore());
        QVERIFY(!m_attempt.grade());
        m_attempt.stopSettling();
        QCOMPARE(m_attempt.state(), State::Ready);
    }

    /// The assessment lags slightly behind, so its answer may still be about the previous tooth.
    void workAtAnotherToothIsNotGraded()
    {
        m_attempt.begin(7, practice(), {});
        QVERIFY(m_attempt.settle());
        m_attempt.conclude([] { return work(6); }, false);
        QVERIFY(!m_attempt.grade());
        QCOMPARE(m_attempt.state(), State::Ready);
        QVERIFY(m_attempt.settle());
        m_attempt.conclude([]() -> std::optional<AttemptSnapshot> { return {}; }, false);
        QVERIFY(!m_attempt.grade());
        QVERIFY(!m_attempt.isGraded());
    }

    void anExamIsCountedOnce()
    {
        m_attempt.begin(1, exam(), {});
        QCOMPARE(m_attempt.exam(), Exam::NotBegun);
        QVERIFY(m_attempt.startExam());
        QCOMPARE(m_attempt.exam(), Exam::Checking);
        QVERIFY(!m_attempt.startExam());
        QVERIFY(!m_attempt.answerExam(1, true));
        QCOMPARE(m_attempt.exam(), Exam::Counted);
        QVERIFY(!m_attempt.answerExam(1, false));  // a second answer that arrives late
        QCOMPARE(m_attempt.exam(), Exam::Counted);
    }

    void anExamWithoutAnAttemptLeftIsRefused()
    {
        m_attempt.begin(1, exam(), {});
        QVERIFY(m_attempt.startExam());
        QVERIFY(m_attempt.answerExam(1, false));
        QCOMPARE(m_attempt.exam(), Exam::Refused);
    }

    void theAnswerAboutAnotherExamChangesNothing()
    {
        m_attempt.begin(1, exam(), {});
        QVERIFY(m_attempt.startExam());
        m_attempt.begin(2, exam(), {});
        QVERIFY(!m_attempt.answerExam(1, false));
        QCOMPARE(m_attempt.exam(), Exam::NotBegun);
        QVERIFY(m_attempt.startExam());
        QVERIFY(!m_attempt.answerExam(1, false));
        QCOMPARE(m_attempt.exam(), Exam::Checking);
    }

    /// After a kill: the exam was counted when it began.
    void aResumedExamIsCountedAlready()
    {
        m_attempt.begin(1, exam(), {});
        m_attempt.resume(1000, {});
        QVERIFY(m_attempt.isResumed());
        QVERIFY(m_attempt.startExam());  // the database is told again, because it may not know of the exam yet
        QCOMPARE(m_attempt.exam(), Exam::Counted);
        QVERIFY(!m_attempt.seenBefore());
    }

    void aGradedExamIsNotBegunAgain()
    {
        m_attempt.begin(1, exam(), {});
        conclude(m_attempt);
        QVERIFY(m_attempt.grade());
        QVERIFY(!m_attempt.startExam());
    }

    /// When the time of an exam is over, the work of that moment is graded, however often the student requests it.
    void theEndOfAnExamIsFixed()
    {
        m_attempt.begin(1, exam(), {});
        conclude(m_attempt, 100, true);
        QVERIFY(m_attempt.settle());
        m_attempt.conclude([]() -> std::optional<AttemptSnapshot> { throw std::logic_error("asked again"); }, true);
        QCOMPARE(m_attempt.grade()->findings.ticks, 100U);
    }

    void theGravestViolationIsExplainedOnce()
    {
        m_attempt.begin(1, practice(), {});
        std::vector<Infraction> found;
        QVERIFY(!m_attempt.nextViolation(found));
        const RuleViolation grave = RuleViolation::PulpExposed;
        const auto slight = static_cast<RuleViolation>(static_cast<int>(grave) + 1);
        found = {violation(slight, 10), violation(grave, 11)};
        const auto first = m_attempt.nextViolation(found);
        QVERIFY(first);
        QCOMPARE(first->tick, 11U);
        QVERIFY(!m_attempt.nextViolation(found));
        // A violation that was undone and is repeated counts as a new one.
        found.push_back(violation(slight, 30));
        QCOMPARE(m_attempt.nextViolation(found)->tick, 30U);
        QVERIFY(!m_attempt.nextViolation(found));
    }

    void violationsBeforeTheInterruptionAreNotExplainedAgain()
    {
        m_attempt.begin(1, practice(), {});
        m_attempt.resume(20, {});
        std::vector<Infraction> found{violation(RuleViolation::PulpExposed, 20)};
        QVERIFY(!m_attempt.nextViolation(found));
        found.push_back(violation(RuleViolation::PulpExposed, 21));
        QCOMPARE(m_attempt.nextViolation(found)->tick, 21U);
    }

    void anExamExplainsNoViolation()
    {
        m_attempt.begin(1, exam(), {});
        QVERIFY(!m_attempt.nextViolation({violation(RuleViolation::PulpExposed, 4)}));
    }

    void gradesGoWhereTheyBelong_data()
    {
        QTest::addColumn<GradeCircumstances>("of");
        QTest::addColumn<Keeping>("goes");
        const auto row = [](const char* name, const GradeCircumstances& of, Keeping goes) {
            QTest::newRow(name) << of << goes;
        };
        row("a student's", {.hasDatabase = true}, Keeping::Pending);
        row("a student's exam", {.hasDatabase = true, .isExam = true}, Keeping::Pending);
        row("a student's resumed exam", {.hasDatabase = true, .isExam = true, .isResumed = true}, Keeping::Pending);
        row("no database", {}, Keeping::Nowhere);
        row("a guest's", {.hasDatabase = true, .isGuest = true}, Keeping::Guest);
        row("a guest's exam", {.hasDatabase = true, .isGuest = true, .isExam = true}, Keeping::Nowhere);
        row("resumed by a guest", {.hasDatabase = true, .isGuest = true, .isResumed = true}, Keeping::Nowhere);
        row("a simulated hand's", {.hasDatabase = true, .isSimulated = true}, Keeping::Nowhere);
        row("a trial of a preset", {.hasDatabase = true, .isTrial = true}, Keeping::Nowhere);
        row("over the limit", {.hasDatabase = true, .isOverLimit = true}, Keeping::Nowhere);
    }
    void gradesGoWhereTheyBelong()
    {
        QFETCH(const GradeCircumstances, of);
        QFETCH(const Keeping, goes);
        QCOMPARE(app::destinationOf(of), goes);
    }

    void wrongPasswordsWaitLongerEachTime()
    {
        OfflineUnlock::TimePoint now{};
        OfflineUnlock unlock([&now] { return now; });
        QVERIFY(!unlock.isPossible());
        unlock.setHash("hash");
        QVERIFY(unlock.isPossible());
        for (int k = 0; k < OfflineUnlock::kFreeTries; ++k) {
            unlock.reject();
            QCOMPARE(unlock.wait(), 0s);
        }
        unlock.reject();
        QCOMPARE(unlock.wait(), 2s);
        now += 1500ms;
        QCOMPARE(unlock.wait(), 1s);
        now += 600ms;
        QCOMPARE(unlock.wait(), 0s);
        unlock.reject();
        QCOMPARE(unlock.wait(), 4s);
        for (int k = 0; k < 40; ++k)
            unlock.reject();
        QCOMPARE(unlock.wait(), 1024s);
        unlock.resetTries();
        QCOMPARE(unlock.wait(), 0s);
        unlock.setHash({});
        QVERIFY(!unlock.isPossible());
    }

private:
    CurrentAttempt m_attempt;
};

QTEST_GUILESS_MAIN(TestCurrentAttempt)
#include "tst_current_attempt.moc"
