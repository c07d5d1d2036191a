// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

#include "bench/Contestants.h"
#include "bench/Suites.h"
#include "cli/parts/Arguments.h"
#include "core/teeth/ToothBuilder.h"
#include "lab/Smoothness.h"

namespace bench {
namespace {

constexpr double kAskedN = 0.08;
constexpr double kLeastShownN = 0.1;

/// Returns the scan beside the checkout that contains this program, as the tests find it; empty if there is none.
QString scanFile()
{
    const QString folder = qEnvironmentVariable("CUSP_SHARED_DATA", QCoreApplication::applicationDirPath() +
                                                                        QStringLiteral("/../../../../shared/data"));
    const QFileInfo file(QDir(folder).filePath(QStringLiteral("teeth/dundee_36.obj")));
    return file.isFile() ? file.canonicalFilePath() : QString();
}

struct Teeth
{
    QString key;  ///< end of the keys of its figures
    QString name;
    core::teeth::ToothSource source;
};

}  // namespace

core::Result<Figures> smoothnessSuite(const Context& context)
{
    QList<Teeth> teeth{{QString(), QStringLiteral("generated 36"), {36}}};
    if (const QString scan = scanFile(); !scan.isEmpty())
        teeth << Teeth{
            QStringLiteral("_scan"), QStringLiteral("scan of a 36"), {std::filesystem::path(scan.toStdString())}};
    else
        cli::printText(QStringLiteral("smoothness: the scan dundee_36 is not there, so there are no figures of it\n"),
                       stderr);

    const core::servo::ServoSettings settings;
    const auto lines = static_cast<int>(lab::kSmoothnessLinesMm.size());
    Figures figures;
    ui::charts::Curve chart;
    chart.x = {QStringLiteral("line over the crown, y (mm)"), -1.2, 1.2};
    chart.y = {QStringLiteral("change of the force in a tick, 99 of 100 are below (N, of 1 N/mm)"), 0.0, kLeastShownN};
    chart.limits = {{kAskedN, false, QStringLiteral("asked of all five lines together")}};
    LookIndex look = 0;
    int done = 0;
    for (const Teeth& tooth : teeth) {
        core::teeth::BuildOptions sound;
        sound.caries.reset();
        const auto built = core::teeth::buildTooth(tooth.source, sound);
        if (!built)
            return tl::unexpected(built.error());
        std::vector<double> allFelt;
        std::vector<double> allSpring;
        ui::charts::Line felt = lineOf(tooth.name + QStringLiteral(", the device"), look++);
        ui::charts::Line spring = lineOf(tooth.name + QStringLiteral(", the spring alone"), look++);
        for (const double y : lab::kSmoothnessLinesMm) {
            context.progress(QStringLiteral("%1, y = %2 mm").arg(tooth.name).arg(y), done++,
                             lines * static_cast<int>(teeth.size()));
            const auto changes = lab::forceChanges(built->anatomy, y, settings);
            if (!changes)
                return tl::unexpected(changes.error());
            std::vector<double> feltN;
            std::vector<double> springN;
            for (const lab::ForceChange& change : *changes) {
                feltN.push_back(change.feltN);
                springN.push_back(change.springN);
            }
            const auto dot = [&](const std::vector<double>& values) {
                const double p99 = lab::percentile99(values);
                chart.y.high = std::max(chart.y.high, ui::charts::roundEnd(p99));
                return pointAt(y, p99, QString::number(p99, 'f', 3));
            };
            felt.dots << dot(feltN);
            spring.dots << dot(springN);
            allFelt.insert(allFelt.end(), feltN.begin(), feltN.end());
            allSpring.insert(allSpring.end(), springN.begin(), springN.end());
        }
        chart.lines << felt << spring;
        const auto add = [&](const char* key, const char* what, const std::vector<double>& values,
                             const QString& reach) {
            figures << Figure{QStringLiteral("smoothness_%1_p99_n").arg(QLatin1String(key)) + tooth.key,
                              QStringLiteral("%1: %2").arg(tooth.name, QLatin1String(what)), lab::percentile99(values),
                              QStringLiteral("N"), reach};
        };
        add("felt", "change of the force, 99 of 100", allFelt, QStringLiteral("%1").arg(kAskedN));
        add("spring", "change of the spring alone", allSpring, {});
    }
    context.show({QStringLiteral("smoothness"),
                  {QStringLiteral("Change of the force from tick to tick over a crown"),
                   QStringLiteral("A hand led along x from %1 to %2 mm with %3 mm/s, %4 mm below where the bur No. 330 "
                                  "slides over the tooth; grid 150, 1 kHz,\nwithout cutting, the device reads exactly. "
                                  "Spring, damper, friction and brake as shipped, divided by the stiffness.")
                       .arg(-lab::kSmoothnessReachMm)
                       .arg(lab::kSmoothnessReachMm)
                       .arg(lab::kSmoothnessMmPerS)
                       .arg(lab::kSmoothnessDepthMm),
                   {},
                   chart}});
    return figures;
}

}  // namespace bench
