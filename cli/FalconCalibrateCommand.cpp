// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstdio>
#include <numbers>

#include <QFile>
#include <QTextStream>

#include "app/devices/FalconCalibration.h"
#include "cli/Commands.h"
#include "cli/parts/Arguments.h"
#include "cli/parts/FalconParts.h"
#include "cli/parts/FalconSession.h"
#include "cli/parts/StopSignal.h"
#include "haptics/falcon/CalibrationSteps.h"
#include "haptics/falcon/Placement.h"

namespace cli {
namespace {

using namespace std::chrono_literals;
using core::session::DeviceStage;
using haptics::DeviceSample;
using haptics::falcon::Calibration;

constexpr double kGravity = 9.80665;
constexpr double kMmPerM = 1000.0;
// Spring and damper that hold the grip at its height.
constexpr double kHoldNPerMm = 0.3;
constexpr double kHoldNSPerMm = 0.004;
constexpr double kHoldNPerMmS = 0.6;
constexpr double kHoldMostN = 6.0;
constexpr auto kSettles = 3000ms;
constexpr auto kMeasures = 4000ms;
// The grip moves up and down during the measurement, so that dry friction averages out.
constexpr double kSwingMm = 2.0;
constexpr double kSwingHz = 0.5;

/// Waits for Enter. Returns false at the end of the input or after Ctrl+C.
bool confirmed(QTextStream& input, const QString& words)
{
    warn({(words + QStringLiteral(" Then press Enter.")).toStdString()});
    return !input.readLine().isNull() && !StopSignal::hasCome();
}

/// Returns the position of the grip in the device frame, averaged over half a second.
core::Result<glm::dvec3> gripMm(FalconSession& session)
{
    glm::dvec3 sum(0.0);
    int count = 0;
    session.play(500ms, [&](const DeviceSample& sample, double) -> std::optional<glm::dvec3> {
        if (sample.present) {
            sum += glm::dvec3(sample.tipInToothMm);
            ++count;
        }
        return glm::dvec3(0.0);
    });
    if (count == 0)
        return core::unexpected(core::ErrorCode::ConnectionLost, "the Falcon gave no position");
    return haptics::falcon::Placement().gripFromToothMm(sum / static_cast<double>(count));
}

/// Holds the grip at its present height and returns the upward force that this needs.
core::Result<double> holdingN(FalconSession& session)
{
    std::optional<double> heldMm;
    double lastMm = 0.0;
    double sumN = 0.0;   // of the integral part
    double total = 0.0;  // of the forces measured
    int count = 0;
    double time = 0.0;
    session.play(kSettles + kMeasures, [&](const DeviceSample& sample, double seconds) -> std::optional<glm::dvec3> {
        if (!sample.present)
            return glm::dvec3(0.0);
        const double z = static_cast<double>(sample.tipInToothMm.z);
        if (!heldMm)
            heldMm = lastMm = z;
        const double wantedMm = *heldMm + kSwingMm * std::sin(2.0 * std::numbers::pi * kSwingHz * time);
        const double missingMm = wantedMm - z;
        const double mmPerS = seconds > 0.0 ? (z - std::exchange(lastMm, z)) / seconds : 0.0;
        sumN = std::clamp(sumN + kHoldNPerMmS * missingMm * seconds, -kHoldMostN, kHoldMostN);
        const double force =
            std::clamp(kHoldNPerMm * missingMm - kHoldNSPerMm * mmPerS + sumN, -kHoldMostN, kHoldMostN);
        time += seconds;
        if (time > std::chrono::duration<double>(kSettles).count()) {
            total += force;
            ++count;
        }
        return glm::dvec3(0.0, 0.0, force);
    });
    if (count == 0)
        return core::unexpected(core::ErrorCode::ConnectionLost, "the Falcon gave no position");
    return total / count + session.calibration().gripWeightN;
}

core::Result<Calibration> measured(FalconSession& session, double travelMm, double weightN)
{
    QTextStream input(stdin);
    const auto stopped = core::unexpected(core::ErrorCode::Busy, "stopped: the calibration is as it was");
    if (!confirmed(input,
                   QStringLiteral("Stand the Falcon upright, as sold. Lay a ruler beside the grip, along the line "
                                  "towards you. Push the grip straight in as far as it goes, and hold it there.")))
        return stopped;
    const auto inside = gripMm(session);
    if (!inside)
        return tl::unexpected(inside.error());
    if (!confirmed(input, QStringLiteral("Pull the grip straight towards you by %1 mm.").arg(travelMm)))
        return stopped;
    const auto outside = gripMm(session);
    if (!outside)
        return tl::unexpected(outside.error());
    auto found = haptics::falcon::withDistance(session.calibration(), *inside, *outside, travelMm);
    if (!found)
        return found;
    if (!confirmed(input,
                   QStringLiteral("Hold the grip in the middle of its reach. The motors take it over: let go of it "
                                  "slowly after you press Enter, and wait seven seconds.")))
        return stopped;
    const auto emptyN = holdingN(session);
    if (!emptyN)
        return tl::unexpected(emptyN.error());
    if (!confirmed(input, QStringLiteral("Hang the weight of %1 g on the grip and hold the grip in the middle of its "
                                         "reach. Let go of it slowly after you press Enter, and wait seven seconds.")
                              .arg(weightN / kGravity * kMmPerM)))
        return stopped;
    const auto loadedN = holdingN(session);
    if (!loadedN)
        return tl::unexpected(loadedN.error());
    return haptics::falcon::withWeight(*found, *emptyN, *loadedN, weightN);
}

}  // namespace

int falconCalibratePart(const QStringList& arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral(
        "Measures with a ruler and a known weight what differs from one Falcon to another, and writes it "
        "into a file: the angle of the arms at their index marks, the scale of the motor commands and "
        "the weight of the grip. Asks for each step."));
    parser.addOption({QStringLiteral("travel"), QStringLiteral("Distance on the ruler, mm: 40 to 70; 60 if not given."),
                      QStringLiteral("MM"), QStringLiteral("60")});
    parser.addOption({QStringLiteral("weight"), QStringLiteral("The weight, g: 50 to 400; 200 if not given."),
                      QStringLiteral("G"), QStringLiteral("200")});
    parser.addOption({QStringLiteral("out"), QStringLiteral("The file to write; that of this computer if not given."),
                      QStringLiteral("FILE")});
    addFalconOptions(parser);
    if (const auto code = parseFalcon(parser, arguments, QStringLiteral("cusp falcon calibrate [OPTIONS]")))
        return *code;
    const auto travelMm = wholeNumber(parser, QStringLiteral("travel"), 40, 70);
    if (!travelMm)
        return wrongUsage(QString::fromStdString(travelMm.error().detail));
    const auto grams = wholeNumber(parser, QStringLiteral("weight"), 50, 400);
    if (!grams)
        return wrongUsage(QString::fromStdString(grams.error().detail));
    const StopSignal stop;
    const auto session = FalconSession::open(parser);
    if (!session)
        return failed(session.error());
    if (const auto ready = (*session)->waitFor(DeviceStage::Ready); !ready)
        return failed(ready.error());
    const auto found =
        measured(**session, static_cast<double>(*travelMm), static_cast<double>(*grams) / kMmPerM * kGravity);
    if (!found)
        return failed(found.error());
    const QString file =
        parser.isSet(QStringLiteral("out")) ? parser.value(QStringLiteral("out")) : app::falconCalibrationFile();
    if (const auto written = app::writeFalconCalibration(file, *found); !written)
        return failed(written.error());
    constexpr double kDegree = std::numbers::pi / 180.0;
    printText(QStringLiteral("Angle at the index marks %1 degrees, %2 commands per Nm, grip %3 N. Written to %4.\n")
                  .arg(found->homeRad.x / kDegree, 0, 'f', 1)
                  .arg(found->commandPerNm, 0, 'f', 0)
                  .arg(found->gripWeightN, 0, 'f', 2)
                  .arg(printable(file)));
    return kDone;
}

}  // namespace cli
