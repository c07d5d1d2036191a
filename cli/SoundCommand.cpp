// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <QFileInfo>

#include "cli/Commands.h"
#include "cli/parts/Arguments.h"
#include "core/audio/ServoSound.h"
#include "core/audio/Synthesizer.h"
#include "core/audio/WaveFile.h"
#include "core/base/WholeFile.h"
#include "core/bur/Bur.h"
#include "core/recording/DevicePath.h"
#include "core/servo/ServoState.h"
#include "haptics/simulated/PathDevice.h"
#include "haptics/simulated/Simulation.h"

namespace cli {
namespace {

constexpr int kSoundRateHz = 48'000;
constexpr int kServoRateHz = 1'000;
constexpr std::size_t kSamplesATick = kSoundRateHz / kServoRateHz;
constexpr double kTickS = 1.0 / kServoRateHz;
constexpr std::uint64_t kMostSoundTicks = 600 * kServoRateHz;
constexpr std::size_t kRunDownS = 1;

struct SoundWish
{
    QString out;
    QString path;
    core::teeth::ToothSource source;
    core::teeth::BuildOptions build;
    haptics::SimulationOptions simulation;
    bool drillAlways = false;
    bool isJson = false;
};

/// Result of `cusp sound`.
struct RenderedSound
{
    std::vector<float> samples;
    bool hasTurned = false;  ///< the bur has turned at some time
    bool hasTouched = false;
};

void addSoundOptions(QCommandLineParser& parser)
{
    const auto option = [&](const char* name, const char* help, const char* value) {
        parser.addOption({QLatin1String(name), QLatin1String(help), QLatin1String(value)});
    };
    option("render", "Where the sound goes: a WAV file, one channel of 16 bits at 48 kHz.", "OUT.wav");
    option("tooth", "The tooth to work on: a mesh file, an FDI number or a practice block such as block:line.",
           "FILE|FDI");
    option("path", "Device path: CSV with t_s,x_mm,y_mm,z_mm,drill; at most ten minutes.", "P.csv");
    parser.addOption({QStringLiteral("drill"), QStringLiteral("Drill on all the time, whatever the path says.")});
    addBurOption(parser, QStringLiteral("NAME"));
    option("handpiece", "What turns the bur: turbine (default), electric or low-speed.", "NAME");
    addJson(parser);
}

/// Returns the values of the options, or a sentence for wrongUsage().
core::Result<SoundWish> soundWish(const QCommandLineParser& parser)
{
    SoundWish wish;
    wish.out = parser.value(QStringLiteral("render"));
    wish.path = parser.value(QStringLiteral("path"));
    wish.drillAlways = parser.isSet(QStringLiteral("drill"));
    wish.isJson = parser.isSet(QStringLiteral("json"));
    wish.source = core::teeth::parseSource(parser.value(QStringLiteral("tooth")).toStdString());
    const auto build = toothOptions(parser, wish.source);
    if (!build)
        return tl::unexpected(build.error());
    wish.build = *build;
    if (parser.isSet(QStringLiteral("bur"))) {
        const auto bur = core::bur::findBur(parser.value(QStringLiteral("bur")).toStdString());
        if (!bur)
            return tl::unexpected(bur.error());
        wish.simulation.burIndex = *bur;
    }
    if (parser.isSet(QStringLiteral("handpiece"))) {
        const auto handpiece = core::settings::findHandpiece(parser.value(QStringLiteral("handpiece")).toStdString());
        if (!handpiece)
            return tl::unexpected(handpiece.error());
        wish.simulation.settings.handpieces = {*handpiece};
    }
    wish.simulation.rateHz = kServoRateHz;
    for (const QString& other : {wish.path, parser.value(QStringLiteral("tooth"))})
        if (core::isSameFile(wish.out.toStdString(), other.toStdString()))
            return core::unexpected(core::ErrorCode::OutOfRange,
                                    "--render would overwrite " + other.toStdString() + "; name another file");
    return wish;
}

core::Result<RenderedSound> render(const SoundWish& wish)
{
    const auto path = core::recording::readDevicePath(wish.path.toStdString(), !wish.drillAlways);
    if (!path)
        return tl::unexpected(path.error());
    const std::uint64_t ticks = path->ticks(kServoRateHz);
    if (ticks > kMostSoundTicks)
        return core::unexpected(core::ErrorCode::OutOfRange,
                                "The device path is longer than ten minutes; a sound is at most that long.");
    auto tooth = core::teeth::buildTooth(wish.source, wish.build);
    if (!tooth)
        return tl::unexpected(tooth.error());
    warn(tooth->report.warnings);

    RenderedSound sound;
    sound.samples.reserve((ticks + kRunDownS * kServoRateHz) * kSamplesATick);
    core::audio::Synthesizer synthesizer(kSoundRateHz);
    core::audio::Volumes volumes;
    volumes.master = 1.0F;
    synthesizer.setVolumes(volumes);
    const auto append = [&](const core::audio::SoundState& state) {
        sound.samples.resize(sound.samples.size() + kSamplesATick);
        synthesizer.render(state, std::span(sound.samples).last(kSamplesATick));
        sound.hasTurned = sound.hasTurned || state.turns;
        sound.hasTouched = sound.hasTouched || state.isTouching;
    };
    core::audio::ServoSound heard;
    haptics::PathDevice device(*path, kServoRateHz);
    core::recording::PathCursor cursor(*path);
    const auto outcome = haptics::simulate(
        tooth->anatomy, device, ticks, wish.simulation,
        [&](std::uint64_t tick, const core::servo::ServoState&, const core::terrain::Tooth&) {
            return wish.drillAlways || cursor.at(static_cast<double>(tick) * kTickS).drill;
        },
        [&](std::uint64_t, const core::servo::ServoState& state) {
            append(heard.update(state, wish.simulation.settings.handpieces.front(), kTickS));
        });
    if (!outcome)
        return tl::unexpected(outcome.error());
    for (std::size_t tick = 0; tick < kRunDownS * kServoRateHz; ++tick)
        append({});
    return sound;
}

}  // namespace

int soundCommand(const QStringList& arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(
        QStringLiteral("Writes what a simulation would sound like into a WAV file. Coordinates of the path are in the "
                       "tooth frame, mm; with --frame file they are the mesh file's own."));
    addSoundOptions(parser);
    addToothOptions(parser);
    const QString usage = QStringLiteral("cusp sound --render OUT.wav --tooth FILE|FDI --path P.csv [OPTIONS]");
    if (const auto code = parse(parser, arguments, usage))
        return *code;
    for (const char* needed : {"render", "tooth", "path"})
        if (parser.value(QLatin1String(needed)).isEmpty())
            return wrongUsage(QStringLiteral("--%1 is missing; usage: ").arg(QLatin1String(needed)) + usage);
    if (!parser.positionalArguments().isEmpty())
        return wrongUsage(
            QStringLiteral("\"%1\" belongs to no option; usage: ").arg(parser.positionalArguments().front()) + usage);
    const auto wish = soundWish(parser);
    if (!wish)
        return wrongUsage(QString::fromStdString(wish.error().detail));
    const auto sound = render(*wish);
    if (!sound)
        return failed(sound.error());
    if (const core::Status written =
            core::writeWhole(wish->out.toStdString(), core::audio::waveFile(sound->samples, kSoundRateHz), "The sound");
        !written)
        return failed(written.error());
    if (!sound->hasTurned)
        warn({"The bur does not turn anywhere on this path, so the file is silent; --drill turns it all the time"});
    else if (!sound->hasTouched)
        warn({"The bur does not touch the tooth anywhere on this path"});

    const auto [low, high] = std::minmax_element(sound->samples.begin(), sound->samples.end());
    const double loudest = sound->samples.empty() ? 0.0 : static_cast<double>(std::max(-*low, *high));
    const double seconds = static_cast<double>(sound->samples.size()) / kSoundRateHz;
    if (wish->isJson)
        printJson({{QStringLiteral("seconds"), seconds},
                   {QStringLiteral("rate_hz"), kSoundRateHz},
                   {QStringLiteral("loudest"), loudest}});
    else
        printText(QStringLiteral("%1 s of sound at %2 Hz, loudest sample %3 of full scale\n")
                      .arg(seconds, 0, 'f', 2)
                      .arg(kSoundRateHz)
                      .arg(loudest, 0, 'f', 2));
    return kDone;
}

}  // namespace cli
