// SPDX-License-Identifier: GPL-3.0-or-later
// The check that decides which answers of a Falcon are accepted.
#include <cmath>

#include <QTest>

#include "core/base/Rng.h"
#include "haptics/falcon/AnswerCheck.h"
#include "tests/support/Suite.h"

using namespace std::chrono_literals;
using haptics::falcon::Answer;
using haptics::falcon::AnswerCheck;

namespace {

Answer homedAt(int top, int right, int left)
{
    return {{static_cast<std::int16_t>(top), static_cast<std::int16_t>(right), static_cast<std::int16_t>(left)},
            0,
            {true, true, true}};
}

/// Returns a check that accepts answers at these counts.
AnswerCheck settledAt(int count)
{
    AnswerCheck check;
    for (int n = 1; n <= 3; ++n)
        static_cast<void>(check.take(homedAt(count, count, count), n * 1ms));
    return check;
}

}  // namespace

class TestFalconAnswers : public QObject
{
    Q_OBJECT
private slots:
    void believesTheThirdAnswerThatAgrees();
    void followsAHandThatSwingsFast();
    void refusesAJump();
    void refusesAnArmThatIsNotHomed();
    void refusesWhatNoArmReaches();
    void findsTheHandAgainAfterAPause();
    void afterMissingAnswersTwoHaveToAgree();
    void believesNoCountThatIsFarOff();
};

void TestFalconAnswers::believesTheThirdAnswerThatAgrees()
{
    AnswerCheck check;
    QVERIFY(!check.take(homedAt(100, 100, 100), 1ms));
    QVERIFY(!check.take(homedAt(101, 100, 100), 2ms));
    QVERIFY(check.take(homedAt(102, 100, 100), 3ms));
    check.restart();
    QVERIFY(!check.take(homedAt(103, 100, 100), 4ms));
    QVERIFY(!check.take(homedAt(400, 100, 100), 5ms));  // damaged: it counts as a new first answer
    QVERIFY(!check.take(homedAt(105, 100, 100), 6ms));
    QVERIFY(!check.take(homedAt(106, 100, 100), 7ms));
    QVERIFY(check.take(homedAt(107, 100, 100), 8ms));
}

void TestFalconAnswers::followsAHandThatSwingsFast()
{
    // Moving 20 mm to each side at 3 Hz is 0.38 m/s and 7 m/s^2. An arm turns some 25 counts per millimetre.
    AnswerCheck check;
    int refused = 0;
    for (int ms = 0; ms < 2000; ++ms) {
        const double at = 500.0 * std::sin(2.0 * 3.14159265358979 * 3.0 * 0.001 * ms);
        const int count = static_cast<int>(std::lround(at));
        refused += check.take(homedAt(count, -count, count / 2), ms * 1ms) ? 0 : 1;
    }
    QCOMPARE(refused, 2);  // the two before the first accepted answer
}

void TestFalconAnswers::refusesAJump()
{
    AnswerCheck check = settledAt(100);
    QVERIFY(!check.take(homedAt(100 + 16, 100, 100), 4ms));  // one flipped bit
    const auto after = check.take(homedAt(100, 100, 100), 5ms);
    QVERIFY(after);
    QCOMPARE(after->x, 100.0);
}

void TestFalconAnswers::refusesAnArmThatIsNotHomed()
{
    AnswerCheck check = settledAt(0);
    Answer answer = homedAt(0, 0, 0);
    answer.homed[1] = false;
    QVERIFY(!check.take(answer, 4ms));
    QVERIFY(check.take(homedAt(0, 0, 0), 5ms));
}

void TestFalconAnswers::refusesWhatNoArmReaches()
{
    AnswerCheck check;
    for (int n = 0; n < 10; ++n)
        QVERIFY(!check.take(homedAt(AnswerCheck::kMostCount + 1, 0, 0), n * 1ms));
}

void TestFalconAnswers::findsTheHandAgainAfterAPause()
{
    AnswerCheck check = settledAt(100);
    QVERIFY(!check.take(homedAt(700, 700, 700), 103ms));
    QVERIFY(!check.take(homedAt(700, 700, 700), 104ms));
    QVERIFY(check.take(homedAt(700, 700, 700), 105ms));
}

void TestFalconAnswers::afterMissingAnswersTwoHaveToAgree()
{
    AnswerCheck check = settledAt(100);
    QVERIFY(!check.take(homedAt(102, 100, 100), 11ms));
    QVERIFY(check.take(homedAt(102, 100, 100), 12ms));
    // A change that a hand can make in this time, but the answer is damaged.
    check = settledAt(100);
    QVERIFY(!check.take(homedAt(100 + 32, 100, 100), 11ms));
    QVERIFY(!check.take(homedAt(100, 100, 100), 12ms));
    QVERIFY(!check.take(homedAt(100, 100, 100), 13ms));
    QVERIFY(check.take(homedAt(100, 100, 100), 14ms));
}

void TestFalconAnswers::believesNoCountThatIsFarOff()
{
    AnswerCheck check;
    core::Rng rng(5);
    int believed = 0;
    int spoiltBelieved = 0;
    int worst = 0;
    for (int ms = 0; ms < 200'000; ++ms) {
        const int real = static_cast<int>(std::lround(400.0 * std::sin(0.01 * ms)));
        Answer answer = homedAt(real, real, real);
        const bool isSpoilt = rng.uniform() < 0.05;
        const auto leg = static_cast<std::size_t>(rng.uniform() * 3.0);
        if (isSpoilt)
            answer.counts.at(leg) =
                static_cast<std::int16_t>(answer.counts.at(leg) ^ (1 << static_cast<int>(rng.uniform() * 16.0)));
        const auto counts = check.take(answer, ms * 1ms);
        if (!counts)
            continue;
        ++believed;
        const int off = static_cast<int>(
            std::max({std::abs(counts->x - real), std::abs(counts->y - real), std::abs(counts->z - real)}));
        spoiltBelieved += off > 0 ? 1 : 0;
        worst = std::max(worst, off);
    }
    qInfo("believed %d of 200000, %d of them spoilt, by at most %d counts", believed, spoiltBelieved, worst);
    QVERIFY(worst <= 8);  // sometimes two answers in a row are damaged, or the one before was refused
    QVERIFY(believed > 185'000);
}

CUSP_TEST(TestFalconAnswers)
#include "tst_falcon_answers.moc"
