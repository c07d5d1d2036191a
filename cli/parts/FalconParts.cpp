// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/parts/FalconParts.h"

#include <algorithm>

#include "cli/parts/Arguments.h"
#include "cli/parts/ExitCode.h"
#include "cli/parts/FalconSession.h"
#include "cli/parts/StopSignal.h"
#include "haptics/falcon/Usb.h"

namespace cli {
namespace {

using namespace std::chrono_literals;
using core::session::DeviceStage;
using haptics::DeviceSample;

constexpr double kMostTestN = 1.0;

QJsonObject rowOf(const haptics::falcon::FoundFalcon& falcon)
{
    QJsonObject row{{QStringLiteral("serial"), QString::fromStdString(falcon.serial)},
                    {QStringLiteral("usable"), falcon.access.has_value()}};
    if (!falcon.access)
        row[QStringLiteral("why")] = QString::fromStdString(falcon.access.error().detail);
    return row;
}

/// Does the common part of probe, home and test: parses the options, opens the device and waits for a stage.
core::Result<std::unique_ptr<FalconSession>> openedAt(DeviceStage stage, const QCommandLineParser& parser)
{
    auto session = FalconSession::open(parser);
    if (!session)
        return session;
    if (const auto reached = (*session)->waitFor(stage); !reached)
        return tl::unexpected(reached.error());
    return session;
}

std::optional<glm::dvec3> noForce(const DeviceSample& /*sample*/, double /*seconds*/)
{
    return glm::dvec3(0.0);
}

void printReport(const FalconSession& session, bool asJson)
{
    const auto report = session.report();
    if (asJson) {
        QJsonObject object = toJson(report.exchange);
        object[QStringLiteral("serial")] = QString::fromStdString(report.serial);
        object[QStringLiteral("stage")] = stageName(report.stage);
        object[QStringLiteral("homed")] = QJsonArray{report.homed[0], report.homed[1], report.homed[2]};
        object[QStringLiteral("tip_mm")] =
            QJsonArray{static_cast<double>(report.tipMm.x), static_cast<double>(report.tipMm.y),
                       static_cast<double>(report.tipMm.z)};
        printJson(object);
        return;
    }
    printText(
        QStringLiteral("Falcon %1: %2\n%3\n")
            .arg(printable(QString::fromStdString(report.serial)), stageName(report.stage), toText(report.exchange)));
}

}  // namespace

int falconListPart(const QStringList& arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral("Lists the Falcons that are plugged in."));
    addJson(parser);
    if (const auto code = parse(parser, arguments, QStringLiteral("cusp falcon list [--json]")))
        return *code;
    if (!parser.positionalArguments().isEmpty())
        return wrongUsage(QStringLiteral("cusp falcon list takes no names"));
    const auto usb = haptics::falcon::Usb::open();
    if (!usb)
        return failed(usb.error());
    const auto falcons = (*usb)->falcons();
    if (parser.isSet(QStringLiteral("json"))) {
        QJsonArray rows;
        for (const auto& falcon : falcons)
            rows.append(rowOf(falcon));
        printJson({{QStringLiteral("falcons"), rows}});
        return kDone;
    }
    if (falcons.empty())
        printText(QStringLiteral("No Falcon is plugged in.\n"));
    for (const auto& falcon : falcons)
        printText(falcon.access ? printable(QString::fromStdString(falcon.serial)) + QStringLiteral(": can be opened\n")
                                : QString::fromStdString(falcon.access.error().detail) + u'\n');
    return kDone;
}

int falconProbePart(const QStringList& arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral("Opens a Falcon, loads its firmware if it has none, and measures "
                                                    "the exchange of packets for two seconds. Gives "
                                                    "no force."));
    addFalconOptions(parser);
    addJson(parser);
    if (const auto code =
            parseFalcon(parser, arguments, QStringLiteral("cusp falcon probe [--firmware FILE] [OPTIONS]")))
        return *code;
    const StopSignal stop;
    const auto session = openedAt(DeviceStage::Homing, parser);
    if (!session)
        return failed(session.error());
    (*session)->play(2200ms, noForce);
    if (const auto there = (*session)->stillAt(DeviceStage::Homing); !there)
        return failed(there.error());
    printReport(**session, parser.isSet(QStringLiteral("json")));
    return kDone;
}

int falconHomePart(const QStringList& arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(
        QStringLiteral("Waits until the three arms of a Falcon have passed their index marks. Gives no force."));
    addFalconOptions(parser);
    addJson(parser);
    if (const auto code = parseFalcon(parser, arguments, QStringLiteral("cusp falcon home [OPTIONS]")))
        return *code;
    const StopSignal stop;
    const auto session = openedAt(DeviceStage::Ready, parser);
    if (!session)
        return failed(session.error());
    printReport(**session, parser.isSet(QStringLiteral("json")));
    return kDone;
}

int falconTestPart(const QStringList& arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(
        QStringLiteral("Pushes the grip right, left, away, towards you, up and down, for one second each, with at most "
                       "1 N, and reports the exchange of packets. Hold the grip loosely."));
    parser.addOption({QStringLiteral("force"), QStringLiteral("How hard, in mN: 0 to 1000; 500 if not given."),
                      QStringLiteral("MN"), QStringLiteral("500")});
    addFalconOptions(parser);
    addJson(parser);
    if (const auto code = parseFalcon(parser, arguments, QStringLiteral("cusp falcon test [--force MN] [OPTIONS]")))
        return *code;
    const auto milliN = wholeNumber(parser, QStringLiteral("force"), 0, 1000);
    if (!milliN)
        return wrongUsage(QString::fromStdString(milliN.error().detail));
    const StopSignal stop;
    const auto session = openedAt(DeviceStage::Ready, parser);
    if (!session)
        return failed(session.error());
    struct Push
    {
        const char* name;
        glm::dvec3 towards;
    };
    constexpr Push kPushes[] = {
        {"right", {1.0, 0.0, 0.0}},        {"left", {-1.0, 0.0, 0.0}}, {"away from you", {0.0, 1.0, 0.0}},
        {"towards you", {0.0, -1.0, 0.0}}, {"up", {0.0, 0.0, 1.0}},    {"down", {0.0, 0.0, -1.0}}};
    const double newtons = std::min(kMostTestN, 0.001 * static_cast<double>(*milliN));
    for (const Push& push : kPushes) {
        if (StopSignal::hasCome())
            break;
        warn({std::string("Pushing ") + push.name + " …"});
        (*session)->play(1000ms, [&](const DeviceSample& sample, double) -> std::optional<glm::dvec3> {
            return sample.present ? push.towards * newtons : glm::dvec3(0.0);
        });
        if (const auto there = (*session)->stillAt(DeviceStage::Ready); !there)
            return failed(there.error());
    }
    printReport(**session, parser.isSet(QStringLiteral("json")));
    return kDone;
}

int falconRulesPart(const QStringList& arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(
        QStringLiteral("Prints the udev rule that lets users of this computer open a Falcon. To install it: "
                       "cusp falcon rules | sudo tee %1, then unplug the Falcon and plug it in again.")
            .arg(QLatin1String(haptics::falcon::kUdevFile)));
    if (const auto code = parse(parser, arguments, QStringLiteral("cusp falcon rules")))
        return *code;
    if (!parser.positionalArguments().isEmpty())
        return wrongUsage(QStringLiteral("cusp falcon rules takes no names"));
    printText(QStringLiteral("# Novint Falcon for Cusp: belongs into %1\n%2\n")
                  .arg(QLatin1String(haptics::falcon::kUdevFile), QLatin1String(haptics::falcon::kUdevRule)));
    return kDone;
}

}  // namespace cli
