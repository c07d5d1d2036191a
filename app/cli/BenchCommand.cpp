// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <numbers>

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QSysInfo>

#include <glm/common.hpp>

#include "app/cli/Arguments.h"
#include "app/cli/Attempt.h"
#include "app/cli/Commands.h"
#include "core/terrain/Rasteriser.h"
#include "haptics/pointer/PointerDevice.h"
#include "haptics/simulated/Simulation.h"

namespace app::cli {
namespace {

using core::mesh::TriangleMesh;

/// One measured figure.
struct Figure
{
    QString suite;
    QString what;
    double value = 0.0;
    QString unit;
    QString reach;  ///< what was to be reached, empty if nothing was set
};
using Figures = QList<Figure>;

/// What a suite needs from the command line, and where it tells how far it is.
struct Context
{
    double minutes = 10.0;
    std::function<void(const QString&)> progress;
};

// --- volume: generated solids against closed form -----------------------------------------------------------------

void addQuad(TriangleMesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d)
{
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
}

/// A prism of four corners at the bottom and four at the top, both counter-clockwise seen from above.
TriangleMesh prism(const std::array<glm::vec3, 8>& corners)
{
    TriangleMesh mesh;
    mesh.vertices.assign(corners.begin(), corners.end());
    addQuad(mesh, 3, 2, 1, 0);
    addQuad(mesh, 4, 5, 6, 7);
    for (std::uint32_t k = 0; k < 4; ++k)
        addQuad(mesh, k, (k + 1) % 4, (k + 1) % 4 + 4, k + 4);
    return mesh;
}

/// A body of revolution about z, closed below by a disc at its first point's height and above at the axis.
TriangleMesh lathe(const std::vector<glm::dvec2>& outline)
{
    constexpr std::uint32_t kTurns = 360;
    TriangleMesh mesh;
    for (const glm::dvec2& p : outline)
        for (std::uint32_t k = 0; k < kTurns; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / kTurns;
            mesh.vertices.emplace_back(p.x * std::cos(angle), p.x * std::sin(angle), p.y);
        }
    for (std::uint32_t ring = 0; ring + 1 < outline.size(); ++ring)
        for (std::uint32_t k = 0; k < kTurns; ++k)
            addQuad(mesh, ring * kTurns + k, ring * kTurns + (k + 1) % kTurns, (ring + 1) * kTurns + (k + 1) % kTurns,
                    (ring + 1) * kTurns + k);
    const auto centre = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.emplace_back(0.0, 0.0, outline.front().y);
    for (std::uint32_t k = 0; k < kTurns; ++k)
        mesh.triangles.push_back({centre, (k + 1) % kTurns, k});
    return mesh;
}

double volumeErrorPercent(const TriangleMesh& mesh, double exactMm3)
{
    glm::dvec2 low(1.0e9);
    glm::dvec2 high(-1.0e9);
    for (const glm::vec3& v : mesh.vertices) {
        low = glm::min(low, glm::dvec2(v));
        high = glm::max(high, glm::dvec2(v));
    }
    const auto maps =
        core::terrain::rasterise(mesh, core::terrain::fitGrid(low, high, core::terrain::kDefaultGridSide));
    return 100.0 * (core::terrain::volumeOf(maps) / exactMm3 - 1.0);
}

Figures volumeSuite(const Context& context)
{
    context.progress(QStringLiteral("solids"));
    const auto turned = [](double x, double y, double z, double degrees) {
        const double a = degrees * std::numbers::pi / 180.0;
        return glm::vec3(x * std::cos(a) - y * std::sin(a), x * std::sin(a) + y * std::cos(a), z);
    };
    const auto box = [&](double degrees) {
        return prism({turned(-4, -3, 0, degrees), turned(4, -3, 0, degrees), turned(4, 3, 0, degrees),
                      turned(-4, 3, 0, degrees), turned(-4, -3, 5, degrees), turned(4, -3, 5, degrees),
                      turned(4, 3, 5, degrees), turned(-4, 3, 5, degrees)});
    };
    const TriangleMesh wedge =
        prism({glm::vec3(-4, -3, 0), glm::vec3(4, -3, 0), glm::vec3(4, 3, 0), glm::vec3(-4, 3, 0), glm::vec3(-4, -3, 1),
               glm::vec3(4, -3, 5), glm::vec3(4, 3, 5), glm::vec3(-4, 3, 1)});
    std::vector<glm::dvec2> cap;
    for (int k = 0; k <= 90; ++k) {
        const double angle = 0.5 * k * std::numbers::pi / 90.0 + 0.25 * std::numbers::pi * (1.0 - k / 90.0);
        cap.emplace_back(5.0 * std::cos(angle), 5.0 * std::sin(angle));
    }
    cap.back().x = 0.0;
    const double capHeight = 5.0 - cap.front().y;
    const double capVolume = std::numbers::pi * capHeight * capHeight * (15.0 - capHeight) / 3.0;
    const QString reach = QStringLiteral("within 0.5");
    Figures figures;
    const auto add = [&](const char* what, const TriangleMesh& mesh, double exact) {
        figures << Figure{QStringLiteral("volume"), QLatin1String(what), volumeErrorPercent(mesh, exact),
                          QStringLiteral("%"), reach};
    };
    add("box", box(0.0), 240.0);
    add("box turned by 17 degrees", box(17.0), 240.0);
    add("wedge", wedge, 144.0);
    add("cone", lathe({{4.0, 0.0}, {0.0, 6.0}}), std::numbers::pi * 16.0 * 6.0 / 3.0);
    add("sphere cap", lathe(cap), capVolume);
    return figures;
}

// --- load: a tooth from number or file ------------------------------------------------------------------------------

Figures loadSuite(const Context& context)
{
    Figures figures;
    for (const int fdi : {21, 24, 36}) {
        context.progress(QStringLiteral("tooth %1").arg(fdi));
        double best = 1.0e9;
        for (int run = 0; run < 5; ++run)
            if (const auto tooth = core::teeth::buildTooth({fdi}, {}); tooth)
                best = std::min(best, tooth->report.loadMs);
        figures << Figure{QStringLiteral("load"),
                          QStringLiteral("generate tooth %1, maps, layers, caries").arg(fdi),
                          best,
                          QStringLiteral("ms"),
                          {}};
    }
    return figures;
}

// --- tick and drilling
// ------------------------------------------------------------------------------------------------

/// Resident memory of this process, MiB; 0 where the system does not say.
double residentMiB()
{
    QFile status(QStringLiteral("/proc/self/status"));
    if (!status.open(QIODevice::ReadOnly))
        return 0.0;
    for (const QByteArray& line : status.readAll().split('\n'))
        if (line.startsWith("VmRSS:"))
            return line.mid(6).trimmed().split(' ').front().toDouble() / 1024.0;
    return 0.0;
}

/// Strokes that wander over the whole crown: slow figure of eight in a slowly turning direction.
core::session::PointerInput wander(double seconds, double radiusMm)
{
    core::session::PointerInput want;
    const double stroke = radiusMm * std::sin(2.0 * std::numbers::pi * 0.8 * seconds);
    const double drift = 0.5 * radiusMm * std::sin(2.0 * std::numbers::pi * 0.031 * seconds);
    const double turn = 2.0 * std::numbers::pi * 0.013 * seconds;
    want.targetMm = {stroke * std::cos(turn) - drift * std::sin(turn),
                     stroke * std::sin(turn) + drift * std::cos(turn)};
    want.pushing = true;
    want.pushForceN = 1.0;
    return want;
}

struct DrillingRun
{
    std::vector<float> tickUs;
    double cuttingShare = 0.0;
    double firstMiB = 0.0;  ///< after a tenth of the time
    double lastMiB = 0.0;
    double recordedMiB = 0.0;
};

core::Result<DrillingRun> drillFor(double seconds, int gridSide, const char* method, bool drill, const Context& context)
{
    core::teeth::BuildOptions build;
    build.gridSide = gridSide;
    const auto tooth = core::teeth::buildTooth({36}, build);
    if (!tooth)
        return tl::unexpected(tooth.error());
    haptics::SimulationOptions options;
    options.settings.method = method;
    core::rt::TripleBuffer<core::session::PointerInput> pointer;
    haptics::PointerDevice device(pointer, options.settings.force.stiffnessNPerMm, 1.0 / options.rateHz);
    const auto ticks = static_cast<std::uint64_t>(seconds * options.rateHz);
    DrillingRun run;
    std::uint64_t cutting = 0;
    const auto outcome = haptics::simulate(
        tooth->anatomy, device, ticks, options,
        [&](std::uint64_t tick, const core::session::ServoState&, const core::terrain::Tooth&) -> std::optional<bool> {
            if (tick % 16 == 0)
                pointer.publish(wander(static_cast<double>(tick) / options.rateHz, 4.0));
            if (tick % 60000 == 0 && ticks > 60000)
                context.progress(QStringLiteral("minute %1 of %2").arg(tick / 60000 + 1).arg((ticks + 59999) / 60000));
            if (tick == ticks / 10)
                run.firstMiB = residentMiB();
            return drill;
        },
        [&](std::uint64_t, const core::session::ServoState& state) { cutting += state.cutting ? 1 : 0; });
    if (!outcome)
        return tl::unexpected(outcome.error());
    run.lastMiB = residentMiB();
    run.tickUs = outcome->tickUs;
    run.cuttingShare = static_cast<double>(cutting) / static_cast<double>(ticks);
    run.recordedMiB = static_cast<double>(outcome->recording.packedBytes()) / 1048576.0;
    return run;
}

void addPercentiles(Figures& figures, const QString& suite, const QString& what, const std::vector<float>& tickUs,
                    const QString& reach)
{
    const QJsonObject at = percentiles(tickUs);
    for (const char* name : {"p50", "p99", "p999"})
        figures << Figure{suite, what + QStringLiteral(", ") + QLatin1String(name), at[QLatin1String(name)].toDouble(),
                          QStringLiteral("us"), QLatin1String(name) == QLatin1String("p99") ? reach : QString()};
}

Figures tickSuite(const Context& context)
{
    constexpr double kSeconds = 30.0;
    const QString suite = QStringLiteral("tick");
    Figures figures;
    for (const char* method : {"continuous", "lattice", "penalty"}) {
        context.progress(QStringLiteral("contact, %1").arg(QLatin1String(method)));
        if (const auto run = drillFor(kSeconds, 150, method, false, context); run)
            addPercentiles(figures, suite, QStringLiteral("contact, %1, grid 150").arg(QLatin1String(method)),
                           run->tickUs, {});
    }
    for (const int side : {150, 300, 600}) {
        context.progress(QStringLiteral("cutting, grid %1").arg(side));
        if (const auto run = drillFor(kSeconds, side, "continuous", true, context); run)
            addPercentiles(figures, suite, QStringLiteral("contact and cutting, bur 330, grid %1").arg(side),
                           run->tickUs, side == 150 ? QStringLiteral("under 20") : QString());
    }
    return figures;
}

Figures drillingSuite(const Context& context)
{
    const QString suite = QStringLiteral("drilling");
    const auto run = drillFor(60.0 * context.minutes, 150, "continuous", true, context);
    if (!run)
        return {};
    Figures figures;
    addPercentiles(figures, suite, QStringLiteral("tick"), run->tickUs, QStringLiteral("under 20"));
    figures << Figure{suite, QStringLiteral("tick, longest"),
                      percentiles(run->tickUs)[QStringLiteral("max")].toDouble(), QStringLiteral("us"),
                      QStringLiteral("under 1000")};
    figures << Figure{suite, QStringLiteral("ticks that cut"), 100.0 * run->cuttingShare, QStringLiteral("%"), {}};
    figures << Figure{suite, QStringLiteral("memory after a tenth"), run->firstMiB, QStringLiteral("MiB"), {}};
    figures << Figure{suite, QStringLiteral("memory at the end"), run->lastMiB, QStringLiteral("MiB"),
                      QStringLiteral("flat but for the recording")};
    figures << Figure{suite, QStringLiteral("of it, the recording"), run->recordedMiB, QStringLiteral("MiB"), {}};
    return figures;
}

struct Suite
{
    const char* name;
    const char* summary;
    Figures (*run)(const Context&);
};

constexpr Suite kSuites[] = {
    {"volume", "volume of solids at grid 150 against closed form", volumeSuite},
    {"load", "time from a number to a tooth that can be drilled", loadSuite},
    {"tick", "thread CPU time of a servo tick, by method and grid", tickSuite},
    {"drilling", "minutes of continuous drilling: ticks and memory", drillingSuite},
};

core::Status writeFiles(const QDir& folder, const Figures& figures)
{
    QByteArray csv("suite,what,value,unit,reach\n");
    QJsonArray rows;
    for (const Figure& figure : figures) {
        csv += figure.suite.toUtf8() + ",\"" + figure.what.toUtf8() + "\"," + QByteArray::number(figure.value, 'g', 9) +
               "," + figure.unit.toUtf8() + ",\"" + figure.reach.toUtf8() + "\"\n";
        rows.append(QJsonObject{{QStringLiteral("suite"), figure.suite},
                                {QStringLiteral("what"), figure.what},
                                {QStringLiteral("value"), figure.value},
                                {QStringLiteral("unit"), figure.unit},
                                {QStringLiteral("reach"), figure.reach}});
    }
    const QJsonObject all{{QStringLiteral("date"), QDateTime::currentDateTimeUtc().toString(Qt::ISODate)},
                          {QStringLiteral("system"), QSysInfo::prettyProductName()},
                          {QStringLiteral("processor"), QSysInfo::currentCpuArchitecture()},
                          {QStringLiteral("kernels"), QLatin1String(core::contact::kernels().name)},
                          {QStringLiteral("version"), QStringLiteral(CUSP_VERSION)},
                          {QStringLiteral("figures"), rows}};
    for (const auto& [name, bytes] : {std::pair(QStringLiteral("bench.csv"), csv),
                                      std::pair(QStringLiteral("bench.json"), QJsonDocument(all).toJson())}) {
        QFile file(folder.filePath(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
            return core::unexpected(core::ErrorCode::FileUnwritable,
                                    file.fileName().toStdString() + " could not be written; check the folder.");
    }
    return {};
}

}  // namespace

int benchCommand(const QStringList& arguments)
{
    QCommandLineParser parser;
    QString help = QStringLiteral("Measures this program on this machine. Times are thread CPU time.\n\nSuites:\n");
    for (const Suite& suite : kSuites)
        help += QStringLiteral("  %1 %2\n").arg(QLatin1String(suite.name), -10).arg(QLatin1String(suite.summary));
    parser.setApplicationDescription(help);
    parser.addPositionalArgument(QStringLiteral("SUITE"), QStringLiteral("One of them; all if not given."));
    parser.addOption({QStringLiteral("out"), QStringLiteral("Writes bench.csv and bench.json into this folder."),
                      QStringLiteral("DIR")});
    parser.addOption({QStringLiteral("minutes"), QStringLiteral("Length of the drilling suite (default 10)."),
                      QStringLiteral("N"), QStringLiteral("10")});
    parser.addOption({QStringLiteral("json"), QStringLiteral("Answers in JSON.")});
    const QString usage = QStringLiteral("cusp bench [SUITE] [--out DIR]");
    if (const auto code = parse(parser, arguments, usage))
        return *code;
    if (parser.positionalArguments().size() > 1)
        return wrongUsage(QStringLiteral("one suite at a time; usage: ") + usage);
    const QString wanted = parser.positionalArguments().value(0);
    bool isNumber = false;
    Context context;
    context.minutes = parser.value(QStringLiteral("minutes")).toDouble(&isNumber);
    if (!isNumber || !(context.minutes > 0.0 && context.minutes <= 240.0))
        return wrongUsage(QStringLiteral("--minutes wants a number up to 240"));

    Figures figures;
    bool known = wanted.isEmpty();
    for (const Suite& suite : kSuites) {
        if (!wanted.isEmpty() && wanted != QLatin1String(suite.name))
            continue;
        known = true;
        context.progress = [&](const QString& what) {
            std::fprintf(stderr, "%s: %s\n", suite.name, what.toLocal8Bit().constData());
        };
        figures += suite.run(context);
    }
    if (!known)
        return wrongUsage(QStringLiteral("there is no suite \"%1\"; \"cusp bench --help\" lists them").arg(wanted));

    if (parser.isSet(QStringLiteral("json"))) {
        QJsonObject object;
        for (const Figure& figure : figures)
            object[figure.suite + QStringLiteral(": ") + figure.what + QStringLiteral(" [") + figure.unit +
                   QStringLiteral("]")] = figure.value;
        printJson(object);
    } else {
        for (const Figure& figure : figures)
            printText(QStringLiteral("%1 %2 %3 %4  %5\n")
                          .arg(figure.suite, -9)
                          .arg(figure.what, -46)
                          .arg(figure.value, 10, 'f', 3)
                          .arg(figure.unit, -4)
                          .arg(figure.reach));
    }
    if (const QString out = parser.value(QStringLiteral("out")); !out.isEmpty()) {
        const QDir folder(out);
        if (!folder.mkpath(QStringLiteral(".")))
            return failed({core::ErrorCode::FileUnwritable, "The folder " + out.toStdString() + " cannot be made."});
        if (const core::Status written = writeFiles(folder, figures); !written)
            return failed(written.error());
    }
    return kDone;
}

}  // namespace app::cli
