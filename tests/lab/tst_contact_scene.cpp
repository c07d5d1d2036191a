// SPDX-License-Identifier: GPL-3.0-or-later
// Accuracy of contact on surfaces whose offset is known. The values are those of docs/facts/haptics.md, section 8.4.
#include <QTest>

#include <algorithm>
#include <map>

#include "core/bur/Bur.h"
#include "lab/ContactScene.h"
#include "tests/support/Suite.h"
#include "tests/support/Tables.h"

namespace {

constexpr double kStiffnessNPerMm = 2.0;

const lab::ContactFamily& familyOf(const char* bur, const QString& name)
{
    static std::map<std::string, std::vector<lab::ContactFamily>> known;
    auto& families = known[bur];
    if (families.empty())
        families = lab::contactFamilies(150, core::bur::findBur(bur).value());
    return *std::find_if(families.begin(), families.end(),
                         [&](const lab::ContactFamily& family) { return family.name == name.toStdString(); });
}

}  // namespace

class TestContactScene : public QObject
{
    Q_OBJECT
private slots:
    /// The height map knows the position of a wall in a cell only to half a cell. At an edge the error is larger: if
    /// the flank of the bur rests on an edge 0.2 or 0.5 mm high, a cell sideways moves the bur by more than a cell.
    void continuousStandsWhereGeometrySays_data()
    {
        support::columns<QString, QString, bool>("bur", "name", "isEdge");
        for (const QString& bur : {QString("2"), QString("330")})
            for (const QString& name :
                 QString("plane 0,plane 10,plane 20,plane 27,plane 45,plane 60,plane 75,fossa,cusp,groove 30,"
                         "groove 30 anywhere,groove 45,groove 45 anywhere,wall,pit corner,step 0.07,step 0.20,"
                         "step 0.50")
                     .split(','))
                QTest::addRow("%s on %s", qPrintable(bur), qPrintable(name))
                    << bur << name << (name == "step 0.20" || name == "step 0.50");
    }

    void continuousStandsWhereGeometrySays()
    {
        QFETCH(QString, bur);
        QFETCH(QString, name);
        QFETCH(bool, isEdge);
        const lab::ContactFamily& family = familyOf(qPrintable(bur), name);
        const lab::ContactErrors errors = lab::measureContact(family, "continuous", kStiffnessNPerMm);
        QVERIFY2(errors.rmsUm < family.reachRmsUm, qPrintable(QString("rms %1 um").arg(errors.rmsUm)));
        QVERIFY2(isEdge || errors.mostUm < family.reachMostUm, qPrintable(QString("most %1 um").arg(errors.mostUm)));
        QVERIFY2(errors.jumpN < family.reachJumpN, qPrintable(QString("jump %1 N").arg(errors.jumpN)));
    }

    void latticeFailsWhereTheorySaysSo()
    {
        // docs/facts/haptics.md, section 3.3: one step per tick is 70 mm/s, and on a slope the candidates that are
        // nearer are not free.
        for (const char* name : {"plane 0", "plane 27", "groove 30"}) {
            const lab::ContactErrors errors = lab::measureContact(familyOf("2", name), "lattice", kStiffnessNPerMm);
            QVERIFY2(errors.rmsUm > 100.0, qPrintable(QString("%1: rms %2 um").arg(name).arg(errors.rmsUm)));
            QVERIFY2(errors.jumpN > 0.1, qPrintable(QString("%1: jump %2 N").arg(name).arg(errors.jumpN)));
        }
    }

    void penaltyFailsWhereTheorySaysSo()
    {
        // Beside a wall the method pushes up instead of out, and between two walls it knows only one.
        for (const char* name : {"wall", "groove 30", "groove 45"}) {
            const lab::ContactErrors errors = lab::measureContact(familyOf("2", name), "penalty", kStiffnessNPerMm);
            QVERIFY2(errors.rmsUm > 100.0, qPrintable(QString("%1: rms %2 um").arg(name).arg(errors.rmsUm)));
        }
    }

    void ridgesAreNotCrossed_data() { support::rows<int>("cells", {1, 2}); }

    void ridgesAreNotCrossed()
    {
        QFETCH(int, cells);
        for (const std::size_t bur : {std::size_t{0}, std::size_t{1}}) {
            const double held = lab::ridgeHoldsN("continuous", cells, bur, kStiffnessNPerMm);
            QVERIFY2(held >= 4.0, qPrintable(QString("%1 N").arg(held)));
        }
        QVERIFY2(lab::ridgeHoldsN("penalty", cells, 0, kStiffnessNPerMm) < 4.0, "penalty holds a ridge");
    }
};

CUSP_TEST(TestContactScene)
#include "tst_contact_scene.moc"
