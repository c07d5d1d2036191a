// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "core/tracking/TagTracker.h"
#include "tests/support/Suite.h"
#include "tests/support/Tables.h"
#include "tests/support/Trials.h"
#include "tests/tracking/TagSpread.h"

using namespace core::tracking;

namespace {

constexpr int kParts = 50;
constexpr int kInPart = 200;  ///< 10,000 in all

}  // namespace

class TestTagClutter : public QObject
{
    Q_OBJECT
private slots:
    /// Split into parts, because Qt Test aborts a function after five minutes.
    void clutterHasNoTag_data()
    {
        QTest::addColumn<int>("part");
        for (int part = 0; part < kParts; ++part)
            QTest::addRow("%d", part) << part;
    }

    /// Neither the tag of the head nor any other tag is found.
    void clutterHasNoTag()
    {
        QFETCH(int, part);
        TagTracker tracker({});
        TagDetector any({});
        lab::TagScene scene;
        scene.camera = support::usualCamera();
        for (int n = kInPart * part; n < kInPart * part + support::trials(6, kInPart); ++n) {
            scene.clutter = static_cast<std::uint64_t>(1000 + n);
            scene.grain = static_cast<std::uint64_t>(n);
            const Picture picture = lab::render(scene);
            QVERIFY2(tracker.look(picture.view()).value().tags.empty(), qPrintable(QString("clutter %1").arg(n)));
            const auto seen = any.find(picture.view(), {2 + n % 2, true});
            QVERIFY2(seen.empty(), qPrintable(QString("clutter %1").arg(n)));
        }
    }
};

CUSP_TEST(TestTagClutter)
#include "tst_tag_clutter.moc"
