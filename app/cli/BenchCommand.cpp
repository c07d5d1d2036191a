// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdio>

#include <QDateTime>
#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QSysInfo>

#include "app/cli/Arguments.h"
#include "app/cli/Commands.h"
#include "app/cli/bench/Suites.h"
#include "core/base/WholeFile.h"
#include "core/contact/Kernels.h"

namespace app::cli {
namespace {

using bench::Figure;
using bench::Figures;

struct Suite
{
    const char* name;
    const char* summary;
    core::Result<Figures> (*run)(const bench::Context&);
};

constexpr Suite kSuites[] = {
    {"volume", "volume of solids at grid 150 against closed form", bench::volumeSuite},
    {"load", "time from a number or a mesh to a tooth that can be drilled", bench::loadSuite},
    {"tick", "thread CPU time of a servo tick, by method and grid", bench::tickSuite},
    {"contact", "error of each contact method against exact positions", bench::contactSuite},
    {"stiffness", "largest stable stiffness, by method, hand and delay", bench::stiffnessSuite},
    {"stability", "scenes where methods fail, by method, stiffness, delay and hand", bench::stabilitySuite},
    {"cutting", "swept volumes, pace over grids, rates and headings, ripple", bench::cuttingSuite},
    {"drilling", "minutes of continuous drilling: ticks and memory", bench::drillingSuite},
};

/// bench-SUITE.csv and bench-SUITE.json.
core::Status writeFiles(const QDir& folder, const QString& suite, const Figures& figures)
{
    QByteArray csv("key,what,value,unit,reach\n");
    QJsonArray rows;
    for (const Figure& figure : figures) {
        csv += figure.key.toUtf8() + ",\"" + QString(figure.what).replace(u'"', u'\'').toUtf8() + "\"," +
               QByteArray::number(figure.value, 'g', 9) + "," + figure.unit.toUtf8() + ",\"" + figure.reach.toUtf8() +
               "\"\n";
        rows.append(QJsonObject{{QStringLiteral("key"), figure.key},
                                {QStringLiteral("what"), figure.what},
                                {QStringLiteral("value"), figure.value},
                                {QStringLiteral("unit"), figure.unit},
                                {QStringLiteral("reach"), figure.reach}});
    }
    const QJsonObject all{{QStringLiteral("suite"), suite},
                          {QStringLiteral("date"), QDateTime::currentDateTimeUtc().toString(Qt::ISODate)},
                          {QStringLiteral("system"), QSysInfo::prettyProductName()},
                          {QStringLiteral("processor"), QSysInfo::currentCpuArchitecture()},
                          {QStringLiteral("kernels"), QLatin1String(core::contact::kernels().name)},
                          {QStringLiteral("version"), QStringLiteral(CUSP_VERSION)},
                          {QStringLiteral("figures"), rows}};
    for (const auto& [ending, bytes] : {std::pair("csv", csv), std::pair("json", QJsonDocument(all).toJson())}) {
        const QString name = QStringLiteral("bench-%1.%2").arg(suite, QLatin1String(ending));
        if (core::Status written =
                core::writeWhole(folder.filePath(name).toStdString(), bytes.toStdString(), "The figures");
            !written)
            return written;
    }
    return {};
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
                      QStringLiteral("Writes bench-SUITE.csv and bench-SUITE.json into this folder."),
                      QStringLiteral("DIR")});
    parser.addOption({QStringLiteral("minutes"), QStringLiteral("Length of the drilling suite (default 10)."),
                      QStringLiteral("N"), QStringLiteral("10")});
    parser.addOption({QStringLiteral("json"), QStringLiteral("Answers in JSON.")});
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
    const auto isWanted = [&](const Suite& suite) { return wanted.isEmpty() || wanted == QLatin1String(suite.name); };
    if (std::none_of(std::begin(kSuites), std::end(kSuites), isWanted))
        return wrongUsage(QStringLiteral("there is no suite \"%1\"; \"cusp bench --help\" lists them").arg(wanted));
    bool isNumber = false;
    bench::Context context;
    context.minutes = parser.value(QStringLiteral("minutes")).toDouble(&isNumber);
    if (!isNumber || !(context.minutes > 0.0 && context.minutes <= 240.0))
        return wrongUsage(QStringLiteral("--minutes wants a number up to 240"));
    context.meshes = parser.values(QStringLiteral("mesh"));
    const QString out = parser.value(QStringLiteral("out"));
    const QDir folder(out);
    if (!out.isEmpty() && !folder.mkpath(QStringLiteral(".")))
        return failed({core::ErrorCode::FileUnwritable,
                       "The folder " + out.toStdString() + " cannot be made; name another with --out."});

    QJsonObject all;
    for (const Suite& suite : kSuites) {
        if (!isWanted(suite))
            continue;
        context.progress = [&](const QString& what) {
            std::fprintf(stderr, "%s: %s\n", suite.name, what.toLocal8Bit().constData());
        };
        const auto figures = suite.run(context);
        if (!figures)
            return failed(figures.error());
        for (const Figure& figure : *figures)
            all[figure.key] = figure.value;
        if (!parser.isSet(QStringLiteral("json")))
            print(QLatin1String(suite.name), *figures);
        if (!out.isEmpty())
            if (const core::Status written = writeFiles(folder, QLatin1String(suite.name), *figures); !written)
                return failed(written.error());
    }
    if (parser.isSet(QStringLiteral("json")))
        printJson(all);
    return kDone;
}

}  // namespace app::cli
