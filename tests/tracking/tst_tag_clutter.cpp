// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "core/tracking/TagTracker.h"
#include "tests/support/Suite.h"
#include "tests/support/Tables.h"
#include "tests/support/Trials.h"
#include "tests/tracking/TagSpread.h"

using namespace core::tracking;

class TestTagClutter : public QObject
{
    Q_OBJECT
private slots:
    void clutterHasNoTag_data() { support::rows<int>("part", {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}); }

    /// Neither the tag of the head nor any other.
    void clutterHasNoTag()
    {
        QFETCH(int, part);
        TagTracker tracker({});
        TagDetector any({});
        lab::TagScene scene;
        scene.camera = support::usualCamera();
        for (int n = 1000 * part; n < 1000 * part + support::trials(30, 1000); ++n) {
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
