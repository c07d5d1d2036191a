// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <filesystem>

#include "core/teeth/ToothBuilder.h"
#include "lab/Block.h"
#include "lab/Smoothness.h"
#include "tests/support/Suite.h"
#include "tests/support/ToothMaps.h"

namespace {

std::shared_ptr<const core::terrain::ToothAnatomy> soundTooth(const core::teeth::ToothSource& source)
{
    core::teeth::BuildOptions sound;
    sound.caries.reset();
    return core::teeth::buildTooth(source, sound).value().anatomy;
}

struct Changes
{
    double feltN = 0.0;
    double springN = 0.0;
};

/// Returns the changes of which 99 of 100 ticks of all lines stay below.
Changes changesOf(const std::shared_ptr<const core::terrain::ToothAnatomy>& anatomy)
{
    std::vector<double> felt;
    std::vector<double> spring;
    for (const double y : lab::kSmoothnessLinesMm) {
        const auto changes = lab::forceChanges(anatomy, y, {}).value();
        for (const lab::ForceChange& change : changes) {
            felt.push_back(change.feltN);
            spring.push_back(change.springN);
        }
    }
    return {lab::percentile99(felt), lab::percentile99(spring)};
}

}  // namespace

class TestSmoothness : public QObject
{
    Q_OBJECT
private slots:
    /// The damper used to mistake the rotation of the spring in a groove for an impact: 0.26 N.
    void aCrownIsFeltWithoutClicks()
    {
        const Changes changes = changesOf(soundTooth({36}));
        QVERIFY2(changes.springN > 0.03 && changes.feltN < 0.08,
                 qPrintable(QString("felt %1, spring %2 N").arg(changes.feltN).arg(changes.springN)));
    }

    void soIsAScan()
    {
        const std::string scan = support::sharedData("teeth/dundee_36.obj");
        if (scan.empty())
            QSKIP("the scan is not there");
        const Changes changes = changesOf(soundTooth({std::filesystem::path(scan)}));
        QVERIFY2(changes.springN > 0.03 && changes.feltN < 0.08,
                 qPrintable(QString("felt %1, spring %2 N").arg(changes.feltN).arg(changes.springN)));
    }

    void evenGroundChangesNothing()
    {
        const auto changes = lab::forceChanges(lab::enamelBlock([](glm::dvec2) { return 0.0; }), 0.0, {}).value();
        QCOMPARE(changes.size(), std::size_t{120});
        // During the first ticks the friction builds up.
        for (auto change = changes.begin() + 20; change != changes.end(); ++change)
            QVERIFY2(change->feltN < 1.0e-3 && change->springN < 1.0e-3,
                     qPrintable(QString("%1 mm: %2, %3 N").arg(change->xMm).arg(change->feltN).arg(change->springN)));
    }

    void badSettingsAreRefused()
    {
        core::servo::ServoSettings settings;
        settings.method = "magic";
        const auto flat = lab::enamelBlock([](glm::dvec2) { return 0.0; });
        QCOMPARE(lab::forceChanges(flat, 0.0, settings).error().code, core::ErrorCode::UnknownName);
    }

    void percentileOfNoneIsNothing()
    {
        QCOMPARE(lab::percentile99({}), 0.0);
        std::vector<double> values;
        for (int n = 100; n >= 0; --n)
            values.push_back(n);
        QCOMPARE(lab::percentile99(values), 99.0);
    }
};

CUSP_TEST(TestSmoothness)
#include "tst_smoothness.moc"
