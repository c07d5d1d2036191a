// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include <cmath>

#include <glm/geometric.hpp>

#include "core/grading/Exercise.h"
#include "core/servo/ServoState.h"
#include "core/session/Sight.h"
#include "tests/support/Suite.h"

using core::session::Sight;
using core::session::sightNote;
using core::session::sightOf;

class TestSight : public QObject
{
    Q_OBJECT
private slots:
    void whatIsNotedIsReadAgain()
    {
        const Sight sight{-123.4, 47.6, 38.3, {-2.3, 4.1, -1.6}};
        const auto read = sightOf(sightNote(sight));
        QVERIFY(read);
        QVERIFY(std::abs(read->azimuthDeg - sight.azimuthDeg) < 0.06);
        QVERIFY(std::abs(read->elevationDeg - sight.elevationDeg) < 0.06);
        QVERIFY(std::abs(read->distanceMm - sight.distanceMm) < 0.11);
        QVERIFY(glm::distance(read->lookAtMm, sight.lookAtMm) < 0.2);
        QCOMPARE(sightNote(*read), sightNote(sight));
    }

    void whatIsTooFarIsClamped()
    {
        const auto read = sightOf(sightNote({540.0, 95.0, 1.0e6, {-99.0, 99.0, 99.0}}));
        QVERIFY(read);
        QVERIFY(read->distanceMm > 200.0 && read->distanceMm < 205.0);
        QVERIFY(read->lookAtMm.x >= -12.8 && read->lookAtMm.y <= 12.9);
    }

    void otherNotesAreNone()
    {
        for (const std::uint64_t note :
             {core::servo::kGradedNote, core::servo::kRestNote, core::servo::kWorkNote,
              core::grading::answerNote(1, core::terrain::Material::Dentin), std::uint64_t(0)})
            QVERIFY(!sightOf(note));
    }
};

CUSP_TEST(TestSight)
#include "tst_sight.moc"
