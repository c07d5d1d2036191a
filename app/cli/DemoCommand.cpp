// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QJsonDocument>

#include "app/Display.h"
#include "app/cli/Arguments.h"
#include "app/cli/Attempt.h"
#include "app/cli/Commands.h"
#include "core/base/WholeFile.h"
#include "core/recording/Recording.h"
#include "haptics/falcon/FalconFeel.h"
#include "haptics/pointer/PointerDevice.h"
#include "haptics/simulated/DemoHand.h"
#include "haptics/simulated/GuidedFalcon.h"
#include "haptics/simulated/Simulation.h"
#include "lessons/Assignment.h"

namespace app::cli {
namespace {

constexpr std::uint64_t kMostTicks = 600'000;  ///< ten minutes
constexpr std::uint64_t kTicksPerDecision = 16;
constexpr std::uint64_t kTicksAfterwards = 500;

core::Result<haptics::SimulationOutcome> drillOutTheDecay(const core::teeth::BuiltTooth& tooth, bool simulatedDevice)
{
    haptics::SimulationOptions options;
    options.record = true;
    if (simulatedDevice)
        haptics::falcon::addFalconFeel(options.settings.force);
    core::rt::TripleBuffer<core::session::PointerInput> pointer;
    const double stiffness = options.settings.force.stiffnessNPerMm;
    haptics::PointerDevice plain(pointer, stiffness, 1.0 / options.rateHz);
    haptics::GuidedFalcon guided(pointer, stiffness, 1.0 / options.rateHz);
    haptics::HapticDevice& device = simulatedDevice ? static_cast<haptics::HapticDevice&>(guided) : plain;
    haptics::DemoHand hand;
    std::uint64_t doneAt = kMostTicks;
    return haptics::simulate(tooth.anatomy, device, kMostTicks, options,
                             [&](std::uint64_t tick, const core::session::ServoState& state,
                                 const core::terrain::Tooth& now) -> std::optional<bool> {
                                 if (tick % kTicksPerDecision == 0)
                                     pointer.publish(hand.decide(state, now));
                                 if (hand.isDone())
                                     doneAt = std::min(doneAt, tick);
                                 if (tick >= doneAt + kTicksAfterwards)
                                     return std::nullopt;
                                 return !hand.isDone();
                             },
                             {});
}

}  // namespace

int demoCommand(const QStringList& arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral(
        "A simulated hand takes the decay out of a tooth. Leaves the recording, its score and a picture in a folder."));
    parser.addOption({QStringLiteral("out"), QStringLiteral("The folder; cusp-demo if not given."),
                      QStringLiteral("FOLDER"), QStringLiteral("cusp-demo")});
    parser.addOption({QStringLiteral("tooth"), QStringLiteral("A mesh file or an FDI number; 36 if not given."),
                      QStringLiteral("FILE|FDI"), QStringLiteral("36")});
    addDeviceOption(parser);
    addToothOptions(parser);
    if (const auto code = parse(parser, arguments, QStringLiteral("cusp demo [--out FOLDER] [OPTIONS]")))
        return *code;
    const auto source = core::teeth::parseSource(parser.value(QStringLiteral("tooth")).toStdString());
    const auto build = toothOptions(parser, source);
    if (!build)
        return wrongUsage(QString::fromStdString(build.error().detail));
    const auto simulatedDevice = wantsSimulatedDevice(parser);
    if (!simulatedDevice)
        return wrongUsage(QString::fromStdString(simulatedDevice.error().detail));
    const QDir folder(parser.value(QStringLiteral("out")));
    if (!folder.mkpath(QStringLiteral(".")))
        return failed({core::ErrorCode::FileUnwritable,
                       "The folder " + folder.path().toStdString() + " cannot be made; name another with --out."});
    const auto tooth = core::teeth::buildTooth(source, *build);
    if (!tooth)
        return failed(tooth.error());
    warn(tooth->report.warnings);
    printText(QStringLiteral("Taking the decay out of tooth %1 with a simulated hand ...\n")
                  .arg(QString::fromStdString(tooth->anatomy->name)));
    const auto outcome = drillOutTheDecay(*tooth, *simulatedDevice);
    if (!outcome)
        return failed(outcome.error());

    const QString recording = folder.absoluteFilePath(QStringLiteral("attempt.cusprec"));
    if (const core::Status written = core::recording::writeRecording(recording.toStdString(), *outcome->recording);
        !written)
        return failed(written.error());
    const auto remarked = lessons::markAgain(*outcome->recording);
    if (!remarked)
        return failed(remarked.error());
    const lessons::Mark* const marked = &remarked->mark;
    const QJsonObject score{{QStringLiteral("score"), toJsonObject(marked->sheet)},
                            {QStringLiteral("measures"), toJson(marked->measured)},
                            {QStringLiteral("state_hash"), hashText(core::terrain::stateHash(outcome->tooth))}};
    if (const core::Status written =
            core::writeWhole(folder.absoluteFilePath(QStringLiteral("score.json")).toStdString(),
                             QJsonDocument(score).toJson().toStdString(), "The score");
        !written)
        return failed(written.error());
    const QString scoreText = toText(marked->sheet);
    if (const core::Status written = core::writeWhole(
            folder.absoluteFilePath(QStringLiteral("score.txt")).toStdString(), scoreText.toStdString(), "The score");
        !written)
        return failed(written.error());

    const double lastsS = std::chrono::duration<double>(outcome->recording->duration()).count();
    printText(QStringLiteral("%1 s of drilling, %2 ticks.\n").arg(lastsS, 0, 'f', 1).arg(outcome->recording->ticks()) +
              scoreText);
    const QString picture = folder.absoluteFilePath(QStringLiteral("picture.png"));
    QFile::remove(picture);
    // What Qt and the display say on stderr is kept from the user: we say one sentence.
    const bool drawn = runOnDisplay({QStringLiteral("render"), QStringLiteral("--recording"), recording,
                                     QStringLiteral("--out"), picture},
                                    true) == kDone;
    printText(QStringLiteral("In %1:\n  attempt.cusprec  replay it with: cusp replay, or in the window\n"
                             "  score.txt, score.json\n")
                  .arg(folder.absolutePath()) +
              (drawn ? QStringLiteral("  picture.png\n") : QString()));
    if (!drawn)
        return failed({core::ErrorCode::FileUnwritable,
                       "The picture could not be drawn: it needs a display with OpenGL 3.3 or xvfb-run (Debian "
                       "package xvfb); the recording and the score are complete."});
    return kDone;
}

}  // namespace app::cli
