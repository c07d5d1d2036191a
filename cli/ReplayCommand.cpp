// SPDX-License-Identifier: GPL-3.0-or-later
#include <chrono>
#include <memory>
#include <optional>
#include <utility>

#include <QElapsedTimer>

#include "cli/Commands.h"
#include "cli/parts/Arguments.h"
#include "cli/parts/Attempt.h"
#include "core/recording/Replay.h"
#include "haptics/simulated/Simulation.h"
#include "lessons/GridSensitivity.h"
#include "lessons/PointLossTimeline.h"

namespace cli {
namespace {

/// The causes of a score, and the time it took to find them.
struct Explained
{
    lessons::GridSensitivity noise;
    double noiseS = 0.0;
    lessons::PointLossTimeline moments;
    double momentsS = 0.0;
};

core::Result<Explained> explain(const core::recording::Recording& recording, const lessons::Remarked& remarked)
{
    const auto assignment = lessons::assignmentOf(recording.anatomy(), recording.lesson());
    if (!assignment)
        return tl::unexpected(assignment.error());
    QElapsedTimer timer;
    timer.start();
    Explained explained;
    auto noise = lessons::gridNoise(*assignment, remarked.outcome.tooth, remarked.conduct);
    if (!noise)
        return tl::unexpected(noise.error());
    explained.noise = *noise;
    explained.noiseS = 1.0e-9 * static_cast<double>(timer.nsecsElapsed());
    timer.start();
    auto moments = lessons::momentsOf(*assignment, recording);
    if (!moments)
        return tl::unexpected(moments.error());
    explained.moments = std::move(**moments);
    explained.momentsS = 1.0e-9 * static_cast<double>(timer.nsecsElapsed());
    return explained;
}

QString gridsText(const lessons::GridSensitivity& noise)
{
    return QStringLiteral("other grids    half %1%2%3\n")
        .arg(0.1 * noise.half.totalTenths, 0, 'f', 1)
        .arg(noise.twice ? QStringLiteral(", double %1").arg(0.1 * noise.twice->totalTenths, 0, 'f', 1) : QString(),
             noise.isUncertain() ? QStringLiteral("; the pass mark lies between") : QString());
}

/// A recording, the result of its replay, and the duration of the replay.
struct Replay
{
    core::recording::Recording recording;
    lessons::Remarked remarked;
    std::unique_ptr<haptics::TickTimes> tickTimes;
    double tookS = 0.0;
    std::optional<Explained> explained;  ///< if it was asked for

    [[nodiscard]] double lastsS() const { return std::chrono::duration<double>(recording.duration()).count(); }
};

QJsonObject figuresOf(const Replay& replay)
{
    const core::terrain::PerMaterial& removedMm3 = replay.remarked.mark.measured.measures.removedMm3;
    QJsonObject answer{{QStringLiteral("tooth"), QString::fromStdString(replay.recording.anatomy()->name)},
                       {QStringLiteral("ticks"), static_cast<qint64>(replay.recording.ticks())},
                       {QStringLiteral("duration_s"), replay.lastsS()},
                       {QStringLiteral("replay_s"), replay.tookS},
                       {QStringLiteral("tick_us"), toJson(*replay.tickTimes)},
                       {QStringLiteral("state_hash"), hashText(replay.remarked.outcome.stateHash)},
                       {QStringLiteral("preset"), presetText(replay.recording)},
                       {QStringLiteral("verified"), replay.recording.witness().has_value()},
                       {QStringLiteral("removed_mm3"), toJson(removedMm3)},
                       {QStringLiteral("measures"), toJson(replay.remarked.mark.measured)},
                       {QStringLiteral("score"), toJsonObject(replay.remarked.mark.sheet)},
                       {QStringLiteral("infractions"), toJson(replay.remarked.conduct.infractions)}};
    if (replay.explained) {
        answer.insert(QStringLiteral("moments"), toJson(replay.explained->moments));
        answer.insert(QStringLiteral("moments_s"), replay.explained->momentsS);
        answer.insert(QStringLiteral("half_grid_tenths"), replay.explained->noise.half.totalTenths);
        answer.insert(QStringLiteral("double_grid_tenths"), replay.explained->noise.twice
                                                                ? QJsonValue(replay.explained->noise.twice->totalTenths)
                                                                : QJsonValue());
        answer.insert(QStringLiteral("grids_s"), replay.explained->noiseS);
    }
    return answer;
}

QString textOf(const Replay& replay)
{
    const core::terrain::PerMaterial& removedMm3 = replay.remarked.mark.measured.measures.removedMm3;
    return QStringLiteral("tooth          %1\n"
                          "attempt        %2 s in %3 ticks, replayed in %4 s\n"
                          "removed        caries %5, enamel %6, dentin %7, pulp %8 mm3\n"
                          "state          %9%10\n"
                          "preset         %11\n")
               .arg(printable(QString::fromStdString(replay.recording.anatomy()->name)))
               .arg(replay.lastsS(), 0, 'f', 2)
               .arg(replay.recording.ticks())
               .arg(replay.tookS, 0, 'f', 2)
               .arg(removedMm3[0], 0, 'f', 4)
               .arg(removedMm3[1], 0, 'f', 4)
               .arg(removedMm3[2], 0, 'f', 4)
               .arg(removedMm3[3], 0, 'f', 4)
               .arg(hashText(replay.remarked.outcome.stateHash),
                    replay.recording.witness() ? QStringLiteral(" (as recorded)") : QString(),
                    printable(presetText(replay.recording))) +
           toText(replay.remarked.mark.sheet) +
           (replay.explained ? toText(replay.explained->moments) + gridsText(replay.explained->noise) : QString()) +
           toText(replay.remarked.conduct.infractions);
}

}  // namespace

int replayCommand(const QStringList& arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(
        QStringLiteral("Replays a recording tick by tick, measures and scores the tooth it leaves."));
    parser.addPositionalArgument(QStringLiteral("RECORDING"), QStringLiteral("A file that Cusp has saved."));
    parser.addOption({QStringLiteral("moments"),
                      QStringLiteral("Says when each point was lost, and the score at half and at double the grid.")});
    addJson(parser);
    const QString usage = QStringLiteral("cusp replay RECORDING [--moments] [--json]");
    if (const auto code = parse(parser, arguments, usage))
        return *code;
    if (parser.positionalArguments().size() != 1)
        return wrongUsage(QStringLiteral("one recording is wanted; usage: ") + usage);
    auto recording = core::recording::readRecording(parser.positionalArguments().front().toStdString());
    if (!recording)
        return failed(recording.error());
    QElapsedTimer timer;
    timer.start();
    auto tickTimes = std::make_unique<haptics::TickTimes>();
    double before = haptics::threadCpuUs();
    auto remarked =
        lessons::markAgain(*recording, [&](const core::servo::ServoEvent& event, const core::recording::Replayer&) {
            if (!core::recording::isStep(event))
                return;
            const double now = haptics::threadCpuUs();
            tickTimes->add(now - before);
            before = now;
        });
    if (!remarked)
        return failed(remarked.error());
    const core::recording::ReplayOutcome& outcome = remarked->outcome;
    const double tookS = static_cast<double>(timer.nsecsElapsed()) * 1.0e-9;
    if (!outcome.agreesWithWitness)
        return failed(
            {core::ErrorCode::BadStructure,
             "The replay came to another tooth than the one recorded: the recording was altered, or this Cusp "
             "computes differently from the one that made it. Do not trust its score."});
    std::optional<Explained> explained;
    if (parser.isSet(QStringLiteral("moments"))) {
        auto found = explain(*recording, *remarked);
        if (!found)
            return failed(found.error());
        explained = std::move(*found);
    }
    const Replay replay{std::move(*recording), std::move(*remarked), std::move(tickTimes), tookS, std::move(explained)};
    if (parser.isSet(QStringLiteral("json")))
        printJson(figuresOf(replay));
    else
        printText(textOf(replay));
    return kDone;
}

}  // namespace cli
