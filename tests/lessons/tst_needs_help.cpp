// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include <vector>

#include "lessons/NeedsHelp.h"
#include "tests/support/Suite.h"
#include "tests/support/Tables.h"

using lessons::AttemptOutcome;
using lessons::needsHelp;

namespace {

std::vector<AttemptOutcome> failed(const QList<int>& newestFirst)
{
    std::vector<AttemptOutcome> made;
    for (const int tenths : newestFirst)
        made.push_back({tenths, false});
    return made;
}

}  // namespace

class TestStuck : public QObject
{
    Q_OBJECT
private slots:
    void lastAttempts_data()
    {
        support::columns<QList<int>, bool>("newestFirst", "stuck");
        QTest::newRow("none") << QList<int>{} << false;
        QTest::newRow("two are too few") << QList<int>{400, 400} << false;
        QTest::newRow("three alike") << QList<int>{400, 400, 400} << true;
        QTest::newRow("worse and worse") << QList<int>{300, 400, 500} << true;
        QTest::newRow("the newest is better by 4.9") << QList<int>{449, 400, 400} << true;
        QTest::newRow("the newest is better by 5") << QList<int>{450, 400, 400} << false;
        QTest::newRow("the middle one was better by 5") << QList<int>{400, 450, 400} << false;
        QTest::newRow("better than the last, not than the one before") << QList<int>{460, 400, 440} << true;
        QTest::newRow("in small steps") << QList<int>{480, 440, 400} << true;
    }

    void lastAttempts()
    {
        QFETCH(QList<int>, newestFirst);
        QFETCH(bool, stuck);
        QCOMPARE(needsHelp(failed(newestFirst)), stuck);
    }

    void onePassedAttemptFrees()
    {
        for (std::size_t k = 0; k < 3; ++k) {
            std::vector<AttemptOutcome> tries = failed({400, 400, 400});
            tries[k].passed = true;
            QVERIFY(!needsHelp(tries));
        }
    }

    void onlyTheLastThreeCount()
    {
        std::vector<AttemptOutcome> tries = failed({400, 400, 400, 900, 100});
        tries[3].passed = true;
        QVERIFY(needsHelp(tries));
    }
};

CUSP_TEST(TestStuck)
#include "tst_needs_help.moc"
