// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdio>

#include <QDir>
#include <QFileInfo>

#include "bench/Progress.h"
#include "bench/SuiteFiles.h"
#include "bench/Suites.h"
#include "cli/Commands.h"
#include "cli/parts/Arguments.h"

namespace cli {
namespace {

using bench::Figure;
using bench::Figures;

struct Suite
{
    const char* name;
    const char* summary;
    core::Result<Figures> (*run)(const bench::Context&);
    double seconds;  ///< expected time, for the estimate of the remaining time; measured on two cores of 2.4 GHz
};

constexpr Suite kSuites[] = {
    {"volume", "volume of solids at grid 150 against closed form", bench::volumeSuite, 1.0},
    {"load", "time from a number or a mesh to a tooth that can be drilled", bench::loadSuite, 1.0},
    {"tick", "thread CPU time of a servo tick, by method and grid", bench::tickSuite, 40.0},
    {"contact", "error of each contact method against exact positions", bench::contactSuite, 30.0},
    {"rate", "error and lag of each contact method against the rate of the servo", bench::rateSuite, 20.0},
    {"stiffness", "largest stable stiffness, by method, hand and delay", bench::stiffnessSuite, 20.0},
    {"stability", "scenes where methods fail, by method, stiffness, delay and hand", bench::stabilitySuite, 155.0},
    {"smoothness", "change of the force from tick to tick over a crown", bench::smoothnessSuite, 1.0},
    {"servo", "1, 2 and 4 kHz: largest stable stiffness, ticks, missed periods", bench::servoSuite, 40.0},
    {"cutting", "swept volumes, pace over grids, rates and headings, ripple", bench::cuttingSuite, 16.0},
    {"model", "height stack and dense voxels: size, time, volume", bench::modelSuite, 10.0},
    {"history", "undo: memory of a thousand moments, jumps, servo meanwhile", bench::historySuite, 40.0},
    {"live", "the servo's ticks with and without live measures in other threads", bench::liveSuite, 62.0},
    {"pointer", "a simulated person at a mouse: plunge, slot, lesion, aim", bench::pointerSuite, 200.0},
    {"falcon", "a Falcon's packets and kinematics", bench::falconSuite, 2.0},
    {"tracking", "head tracking: a tag in rendered pictures, errors and times", bench::trackingSuite, 95.0},
    {"sound", "sound of the handpiece: time, latency, pitch and materials", bench::soundSuite, 5.0},
    {"marks", "points against the letters of a strict instructor, for spoiled attempts", bench::marksSuite, 200.0},
    {"replay", "an attempt replayed, and looked at here and there", bench::replaySuite, 25.0},
    {"drilling", "minutes of continuous drilling: ticks and memory", bench::drillingSuite, 6.0},
};

/// Returns whether the option --minutes applies to the suite.
bool takesMinutes(const Suite& suite)
{
    return suite.run == bench::drillingSuite || suite.run == bench::servoSuite;
}

double secondsOf(const Suite& suite, const bench::Context& context)
{
    return takesMinutes(suite) ? 0.1 * context.minutes * suite.seconds : suite.seconds;
}

void print(const QString& suite, const Figures& figures)
{
    for (const Figure& figure : figures)
        printText(QStringLiteral("%1 %2 %3 %4  %5\n")
                      .arg(suite, -9)
                      .arg(figure.what, -46)
                      .arg(figure.value, 10, 'f', 3)
                      .arg(figure.unit, -4)
                      .arg(figure.reach));
}

void addOptions(QCommandLineParser& parser)
{
    QString help = QStringLiteral("Measures this program on this machine. Times are thread CPU time, but those of "
                                  "loading.\n\nSuites:\n");
    for (const Suite& suite : kSuites)
        help += QStringLiteral("  %1 %2\n").arg(QLatin1String(suite.name), -10).arg(QLatin1String(suite.summary));
    parser.setApplicationDescription(help);
    parser.addPositionalArgument(QStringLiteral("SUITE"), QStringLiteral("One of them; all if not given."));
    parser.addOption({QStringLiteral("mesh"),
                      QStringLiteral("Loads this mesh too in the suite load; may be given several times."),
                      QStringLiteral("FILE")});
    parser.addOption({QStringLiteral("out"),
                      QStringLiteral("Writes bench-SUITE.csv, bench-SUITE.json and charts into this folder, as each "
                                     "suite ends."),
                      QStringLiteral("DIR")});
    parser.addOption({QStringLiteral("minutes"),
                      QStringLiteral("Simulated time of the suites drilling and servo (default 10)."),
                      QStringLiteral("N"), QStringLiteral("10")});
    addJson(parser);
}

}  // namespace

int benchCommand(const QStringList& arguments)
{
    QCommandLineParser parser;
    addOptions(parser);
    const QString usage = QStringLiteral("cusp bench [SUITE] [--mesh FILE] [--out DIR] [OPTIONS]");
    if (const auto code = parse(parser, arguments, usage, QStringLiteral("mesh")))
        return *code;
    if (parser.positionalArguments().size() > 1)
        return wrongUsage(QStringLiteral("one suite at a time; usage: ") + usage);
    const QString wanted = parser.positionalArguments().value(0);
    if (!parser.positionalArguments().isEmpty() && wanted.isEmpty())
        return wrongUsage(QStringLiteral("an empty name is no suite; leave it out for all of them"));
    const auto isWanted = [&](const Suite& suite) { return wanted.isEmpty() || wanted == QLatin1String(suite.name); };
    if (std::none_of(std::begin(kSuites), std::end(kSuites), isWanted))
        return wrongUsage(QStringLiteral("there is no suite \"%1\"; \"cusp bench --help\" lists them").arg(wanted));
    bool isNumber = false;
    bench::Context context;
    context.minutes = parser.value(QStringLiteral("minutes")).toDouble(&isNumber);
    if (!isNumber || !(context.minutes >= 0.01 && context.minutes <= 240.0))
        return wrongUsage(QStringLiteral("--minutes wants a number from 0.01 to 240"));
    context.meshes = parser.values(QStringLiteral("mesh"));
    if (!context.meshes.isEmpty() && !wanted.isEmpty() && wanted != QLatin1String("load"))
        return wrongUsage(QStringLiteral("--mesh belongs to the suite \"load\""));
    for (const QString& mesh : context.meshes)
        if (!QFileInfo(mesh).isFile())
            return failed({core::ErrorCode::FileMissing,
                           mesh.toStdString() + (QFileInfo::exists(mesh) ? " is not a file; name the mesh itself"
                                                                         : " does not exist; check the name")});
    if (parser.isSet(QStringLiteral("minutes")) &&
        std::none_of(std::begin(kSuites), std::end(kSuites),
                     [&](const Suite& suite) { return isWanted(suite) && takesMinutes(suite); }))
        return wrongUsage(QStringLiteral("--minutes belongs to the suites \"drilling\" and \"servo\""));
    const QString out = parser.value(QStringLiteral("out"));
    if (parser.isSet(QStringLiteral("out")) && out.isEmpty())
        return wrongUsage(QStringLiteral("--out wants a folder"));
    const QDir folder(out);
    if (!out.isEmpty() && !(folder.mkpath(QStringLiteral(".")) && QFileInfo(folder.path()).isWritable()))
        return failed({core::ErrorCode::FileUnwritable,
                       "Nothing can be written into the folder " + out.toStdString() + "; name another with --out."});

    QList<const Suite*> suites;
    double seconds = 0.0;
    for (const Suite& suite : kSuites)
        if (isWanted(suite)) {
            suites << &suite;
            seconds += secondsOf(suite, context);
        }
    bench::Progress progress(seconds);
    context.progress = [&](const QString& what, int done, int of) { progress.step(what, done, of); };
    QJsonObject all;
    QStringList files;
    for (const Suite* suite : suites) {
        const QLatin1String name(suite->name);
        QList<bench::NamedChart> charts;
        context.show = [&](const bench::NamedChart& chart) { charts << chart; };
        progress.begin(name, secondsOf(*suite, context));
        const auto figures = suite->run(context);
        if (!figures)
            return failed(figures.error());
        progress.end();
        for (const Figure& figure : *figures)
            all[figure.key] = figure.value;
        if (!parser.isSet(QStringLiteral("json")))
            print(name, *figures);
        if (out.isEmpty())
            continue;
        const auto written = bench::writeFiles(folder, name, *figures, charts);
        if (!written)
            return failed(written.error());
        files << *written;
    }
    if (parser.isSet(QStringLiteral("json")))
        printJson(all);
    if (!files.isEmpty())
        printText(QStringLiteral("In %1:\n  %2\n").arg(folder.absolutePath(), files.join(QStringLiteral("\n  "))),
                  stderr);
    return kDone;
}

}  // namespace cli
