// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numeric>
#include <optional>

#include <QFile>
#include <QFileInfo>
#include <QSaveFile>

#include "cli/Commands.h"
#include "cli/parts/Arguments.h"
#include "cli/parts/Attempt.h"
#include "core/base/WholeFile.h"
#include "core/bur/Bur.h"
#include "core/bur/BurFile.h"
#include "core/servo/ServoState.h"
#include "haptics/simulated/PathDevice.h"
#include "haptics/simulated/Simulation.h"

namespace cli {
namespace {

constexpr double kLeastRateHz = 20.0;
constexpr double kMostRateHz = 20000.0;
constexpr std::uint64_t kMostTicks = 100'000'000;

/// Returns whether the trace goes to standard output.
bool isStandardOutput(const QString& path)
{
    return path == u"-" || path == u"/dev/stdout";
}

/// Returns whether a path is a terminal, a null device or a pipe. Those are written directly and not replaced.
bool isStream(const QString& path)
{
    std::error_code failure;
    const std::filesystem::file_status status = std::filesystem::status(path.toStdString(), failure);
    return std::filesystem::is_character_file(status) || std::filesystem::is_fifo(status);
}

/// Writes the trace row by row. A file is written under a temporary name and renamed when it is complete, so that a
/// failure does not damage an older trace. A stream gets the rows at once.
class TraceWriter
{
public:
    explicit TraceWriter(QString path) : m_path(std::move(path)), m_file(m_path), m_stream(m_path) {}

    [[nodiscard]] core::Status open()
    {
        bool opened = false;
        if (isStandardOutput(m_path)) {
            opened = m_stream.open(stdout, QIODevice::WriteOnly);
            m_out = &m_stream;
        } else if (isStream(m_path)) {
            opened = m_stream.open(QIODevice::WriteOnly | QIODevice::Unbuffered);
            m_out = &m_stream;
        } else if (!QFileInfo::exists(m_path) || QFileInfo(m_path).isFile()) {
            opened = m_file.open(QIODevice::WriteOnly);
        }
        if (!opened)
            return unwritable();
        m_line =
            "t_s,x_mm,y_mm,z_mm,ax_mm,ay_mm,az_mm,fx_n,fy_n,fz_n,contact,caries_mm3,enamel_mm3,dentin_mm3,pulp_mm3\n";
        return {};
    }

    void row(double timeS, const core::servo::ServoState& state)
    {
        number(timeS);
        for (const glm::dvec3& v : {state.deviceMm, state.anchorMm, state.forceN})
            for (int axis = 0; axis < 3; ++axis)
                number(v[axis]);
        m_line += state.touching ? "1," : "0,";
        for (const double removed : state.removedMm3)
            number(removed);
        m_line.back() = '\n';
        if (m_line.size() > 65536)
            flush();
    }

    [[nodiscard]] core::Status finish()
    {
        flush();
        if (!m_written || !(m_out == &m_file ? m_file.flush() && m_file.commit() : m_stream.flush()))
            return unwritable();
        return {};
    }

private:
    /// Writes the shortest digits that read back to the same double, whatever the locale.
    void number(double value)
    {
        char digits[32];
        const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
        m_line.append(digits, static_cast<std::size_t>(end - digits));
        m_line += ',';
    }
    void flush()
    {
        m_written = m_written && m_out->write(m_line.data(), static_cast<qint64>(m_line.size())) ==
                                     static_cast<qint64>(m_line.size());
        m_line.clear();
    }
    [[nodiscard]] tl::unexpected<core::Error> unwritable() const
    {
        return core::unexpected(core::ErrorCode::FileUnwritable,
                                "The trace could not be written to " + m_path.toStdString() +
                                    "; check the folder, its rights and the space left.");
    }

    QString m_path;
    QSaveFile m_file;
    QFile m_stream;
    QIODevice* m_out = &m_file;
    std::string m_line;
    bool m_written = true;
};

void addOptions(QCommandLineParser& parser)
{
    const auto option = [&](const char* name, const char* help, const char* value) {
        parser.addOption({QLatin1String(name), QLatin1String(help), QLatin1String(value)});
    };
    option("tooth", "The tooth to work on: a mesh file, an FDI number or a practice block such as block:line.",
           "FILE|FDI");
    option("path", "Device path: CSV with t_s,x_mm,y_mm,z_mm,drill.", "P.csv");
    option("out",
           "Where the trace goes, one row a tick: a file, a pipe, or - for standard output; the figures then go to "
           "standard error.",
           "T.csv");
    parser.addOption({QStringLiteral("drill"), QStringLiteral("Drill on all the time, whatever the path says.")});
    addBurOption(parser, QStringLiteral("NAME|FILE"),
                 QStringLiteral("or a file with a bur of your own, which goes into no recording"));
    option("method", "continuous (default), lattice, lattice16 (16 steps a tick) or penalty.", "M");
    option("rate", "Ticks a second, 20 to 20000 (default 1000).", "HZ");
    option("preset",
           "Hardness: natural (default), typodont, one of \"cusp preset list\", or a file such as {\"name\": \"soft\", "
           "\"enamel\": {\"rate_mm3_per_ns\": 0.7, \"threshold_n\": 0.15}, \"axial_share\": 0.65, \"flat_end_share\": "
           "0.615, \"full_load_n\": 1.5, \"force\": {\"stiffness_n_per_mm\": 2}}; caries, dentin and pulp as enamel; "
           "what is left out is natural, but every bur and any load cut alike if "
           "flat_end_share and full_load_n are left out.",
           "NAME|FILE");
    option(
        "handpiece",
        "What turns the bur: turbine (default), electric or low-speed. A load brakes it; at its stall torque it stops "
        "and cuts nothing.",
        "NAME");
    parser.addOption(
        {QStringLiteral("break-off"),
         QStringLiteral("Columns and fins that a cut leaves standing, more than six times as high as wide, "
                        "break off.")});
    option("record", "Saves a recording for cusp replay.", "FILE");
    addJson(parser);
}

/// Returns a bur by its name, or otherwise the user's own bur from the file of that name.
core::Result<std::size_t> burOf(const std::string& name)
{
    auto known = core::bur::findBur(name);
    std::error_code failure;
    if (known || !std::filesystem::exists(name, failure))
        return known;
    auto own = core::bur::readBur(name);
    if (!own)
        return tl::unexpected(std::move(own).error());
    return core::bur::addOwnBur(std::move(*own));
}

core::Result<haptics::SimulationOptions> simulationOptions(const QCommandLineParser& parser)
{
    haptics::SimulationOptions options;
    if (parser.isSet(QStringLiteral("bur"))) {
        const auto bur = burOf(parser.value(QStringLiteral("bur")).toStdString());
        if (!bur)
            return tl::unexpected(bur.error());
        if (core::bur::isOwnBur(*bur) && !parser.value(QStringLiteral("record")).isEmpty())
            return core::unexpected(core::ErrorCode::NotAllowed,
                                    "a bur of your own goes into no recording, for nobody else could replay it; leave "
                                    "out --record or --bur FILE");
        options.burIndex = *bur;
    }
    if (parser.isSet(QStringLiteral("method")))
        options.settings.method = parser.value(QStringLiteral("method")).toStdString();
    if (const auto method = core::contact::makeContactMethod(options.settings.method); !method)
        return tl::unexpected(method.error());
    if (parser.isSet(QStringLiteral("handpiece"))) {
        const auto handpiece = core::settings::findHandpiece(parser.value(QStringLiteral("handpiece")).toStdString());
        if (!handpiece)
            return tl::unexpected(handpiece.error());
        options.settings.handpieces = {*handpiece};
    }
    options.settings.breakOff.on = parser.isSet(QStringLiteral("break-off"));
    if (parser.isSet(QStringLiteral("rate"))) {
        bool isNumber = false;
        options.rateHz = parser.value(QStringLiteral("rate")).toDouble(&isNumber);
        if (!isNumber || !(options.rateHz >= kLeastRateHz && options.rateHz <= kMostRateHz))
            return core::unexpected(core::ErrorCode::OutOfRange, "--rate wants a number from 20 to 20000");
    }
    options.record = !parser.value(QStringLiteral("record")).isEmpty();
    return options;
}

/// Returns a warning if the path begins deeper than any handpiece reaches.
std::optional<std::string> tooDeep(const core::recording::DevicePath& path, double highestMm)
{
    const double firstMm = path.points.front().tipMm.z;
    if (firstMm >= highestMm - core::bur::kChuckMm)
        return std::nullopt;
    return QStringLiteral("the path begins at z %1 mm, but a handpiece stops on the crown before its bur is more than "
                          "%2 mm below the highest cusp; begin the path above the tooth")
        .arg(firstMm, 0, 'f', 2)
        .arg(core::bur::kChuckMm)
        .toStdString();
}

/// Returns an error about the first output file that would overwrite another file of the command line; empty if there
/// is none.
QString clashingFiles(const QCommandLineParser& parser)
{
    const auto file = [&](const char* option) {
        return std::filesystem::path(parser.value(QLatin1String(option)).toStdString());
    };
    for (const auto& [written, other] : {std::pair("out", "path"),
                                         {"out", "tooth"},
                                         {"out", "preset"},
                                         {"out", "bur"},
                                         {"out", "record"},
                                         {"record", "path"},
                                         {"record", "tooth"},
                                         {"record", "preset"}}) {
        const bool isName = other == std::string_view("bur") && core::bur::findBur(file(other).string());
        if (!isName && !file(written).empty() && !file(other).empty() && core::isSameFile(file(written), file(other)))
            return QStringLiteral("--%1 would overwrite the file given with --%2; name another")
                .arg(QLatin1String(written), QLatin1String(other));
    }
    return {};
}

/// The inputs of a simulation.
struct Work
{
    haptics::SimulationOptions options;
    core::recording::DevicePath path;
    bool drillAlways = false;
    std::shared_ptr<const core::terrain::ToothAnatomy> anatomy;

    [[nodiscard]] std::uint64_t ticks() const { return path.ticks(options.rateHz); }
};

/// What the servo did not follow.
struct Ignored
{
    std::uint64_t readings = 0;  ///< number of readings that were ignored because no hand can be there
    bool isInside = false;       ///< the bur began inside the tooth
};

/// Runs the simulation over the path and writes the trace.
core::Result<haptics::SimulationOutcome> run(const Work& work, const QString& out, Ignored& ignored)
{
    TraceWriter trace(out);
    if (const core::Status opened = trace.open(); !opened)
        return tl::unexpected(opened.error());
    const double rateHz = work.options.rateHz;
    const double startS = work.path.points.front().timeS;
    haptics::PathDevice device(work.path, rateHz);
    core::recording::PathCursor drillCursor(work.path);
    core::recording::PathCursor handCursor(work.path);
    auto outcome = haptics::simulate(
        work.anatomy, device, work.ticks(), work.options,
        [&](std::uint64_t tick, const core::servo::ServoState&, const core::terrain::Tooth&) {
            return drillCursor.at(static_cast<double>(tick) / rateHz).drill || work.drillAlways;
        },
        [&](std::uint64_t tick, const core::servo::ServoState& state) {
            const double timeS = static_cast<double>(tick) / rateHz;
            if (glm::vec3(handCursor.at(timeS).tipMm) != glm::vec3(state.deviceMm))
                ++ignored.readings;
            ignored.isInside = ignored.isInside || (tick <= 1 && (state.health & core::servo::kBegunInside) != 0);
            trace.row(startS + timeS, state);
        });
    if (!outcome)
        return tl::unexpected(outcome.error());
    if (const core::Status written = trace.finish(); !written)
        return tl::unexpected(written.error());
    return outcome;
}

/// Prints the figures of a run as JSON or as readable text.
void printFigures(const Work& work, const haptics::SimulationOutcome& outcome, const std::vector<std::string>& warnings,
                  bool asJson, std::FILE* figures)
{
    const QString hash = hashText(core::terrain::stateHash(outcome.tooth));
    const QJsonObject tickUs = toJson(*outcome.tickTimes);
    if (asJson) {
        printJson({{QStringLiteral("ticks"), static_cast<qint64>(work.ticks())},
                   {QStringLiteral("tick_us"), tickUs},
                   {QStringLiteral("removed_mm3"), toJson(outcome.last.removedMm3)},
                   {QStringLiteral("broken_mm3"), toJson(outcome.last.brokenMm3)},
                   {QStringLiteral("state_hash"), hash},
                   {QStringLiteral("warnings"), toJsonArray(warnings)},
                   {QStringLiteral("kernels"), QLatin1String(core::contact::kernels().name)}},
                  figures);
        return;
    }
    warn(warnings);
    const auto& removed = outcome.last.removedMm3;
    const auto& broken = outcome.last.brokenMm3;
    printText(QStringLiteral("ticks          %1 at %2 Hz\n"
                             "tick           p50 %3, p99 %4, p99.9 %5, max %6 us (thread CPU time)\n"
                             "removed        caries %7, enamel %8, dentin %9, pulp %10 mm3\n"
                             "broke off      %11 mm3 of it\n"
                             "state          %12\n")
                  .arg(work.ticks())
                  .arg(work.options.rateHz)
                  .arg(tickUs[QStringLiteral("p50")].toDouble(), 0, 'f', 1)
                  .arg(tickUs[QStringLiteral("p99")].toDouble(), 0, 'f', 1)
                  .arg(tickUs[QStringLiteral("p999")].toDouble(), 0, 'f', 1)
                  .arg(tickUs[QStringLiteral("max")].toDouble(), 0, 'f', 1)
                  .arg(removed[0], 0, 'f', 4)
                  .arg(removed[1], 0, 'f', 4)
                  .arg(removed[2], 0, 'f', 4)
                  .arg(removed[3], 0, 'f', 4)
                  .arg(std::accumulate(broken.begin(), broken.end(), 0.0), 0, 'f', 4)
                  .arg(hash),
              figures);
}

/// Parses the command line. Returns an exit code if the command has nothing more to do.
std::optional<int> parseCommand(QCommandLineParser& parser, const QStringList& arguments)
{
    parser.setApplicationDescription(QStringLiteral("Drives the servo tick over a device path and writes what "
                                                    "happened, one row a tick. Coordinates are in the tooth "
                                                    "frame, mm; with --frame file they are the mesh file's own."));
    addOptions(parser);
    addToothOptions(parser);
    const QString usage = QStringLiteral("cusp simulate --tooth FILE|FDI --path P.csv --out T.csv [OPTIONS]");
    if (const auto code = parse(parser, arguments, usage))
        return code;
    for (const char* needed : {"tooth", "path", "out"})
        if (parser.value(QLatin1String(needed)).isEmpty())
            return wrongUsage(QStringLiteral("--%1 is missing; usage: ").arg(QLatin1String(needed)) + usage);
    if (!parser.positionalArguments().isEmpty())
        return wrongUsage(
            QStringLiteral("\"%1\" belongs to no option; usage: ").arg(parser.positionalArguments().front()) + usage);
    return std::nullopt;
}

/// Reads the path and checks that it is not too long.
core::Status readPath(const QString& file, Work& work)
{
    auto path = core::recording::readDevicePath(file.toStdString(), !work.drillAlways);
    if (!path)
        return tl::unexpected(path.error());
    work.path = std::move(*path);
    if (work.ticks() > kMostTicks)
        return core::unexpected(core::ErrorCode::OutOfRange,
                                "The device path is too long for this rate: " + std::to_string(work.ticks()) +
                                    " ticks, at most 100 million are run.");
    if (work.options.record && work.ticks() > core::recording::kEventsOfLongestAttempt)
        return core::unexpected(core::ErrorCode::OutOfRange,
                                "A recording of " + std::to_string(work.ticks()) +
                                    " ticks would be longer than six hours at 1000 a second, the longest that Cusp "
                                    "reads; leave out --record, or use a shorter path or a lower rate.");
    return {};
}

}  // namespace

int simulateCommand(const QStringList& arguments)
{
    QCommandLineParser parser;
    if (const auto code = parseCommand(parser, arguments))
        return *code;
    const auto source = core::teeth::parseSource(parser.value(QStringLiteral("tooth")).toStdString());
    const auto build = toothOptions(parser, source);
    if (!build)
        return wrongUsage(QString::fromStdString(build.error().detail));
    auto options = simulationOptions(parser);
    if (!options)
        return wrongUsage(QString::fromStdString(options.error().detail));
    if (const QString clash = clashingFiles(parser); !clash.isEmpty())
        return wrongUsage(clash);
    if (parser.isSet(QStringLiteral("preset"))) {
        const core::Status taken = takePreset(parser.value(QStringLiteral("preset")), options->settings);
        if (!taken)
            return taken.error().code == core::ErrorCode::UnknownName
                       ? wrongUsage(QString::fromStdString(taken.error().detail))
                       : failed(taken.error());
    }

    Work work{std::move(*options), {}, parser.isSet(QStringLiteral("drill")), nullptr};
    if (const core::Status read = readPath(parser.value(QStringLiteral("path")), work); !read)
        return failed(read.error());
    auto tooth = core::teeth::buildTooth(source, *build);
    if (!tooth)
        return failed(tooth.error());
    tooth->mesh = {};  // the simulation uses only the maps
    work.anatomy = tooth->anatomy;
    std::vector<std::string> warnings = tooth->report.warnings;
    const auto deep = tooDeep(work.path, tooth->report.highMm.z);
    if (deep)
        warnings.push_back(*deep);

    const QString record = parser.value(QStringLiteral("record"));
    if (!record.isEmpty() && !QFileInfo(QFileInfo(record).absolutePath()).isWritable())
        return failed({core::ErrorCode::FileUnwritable, record.toStdString() + " cannot be written: its folder is not "
                                                                               "there or not writable"});
    Ignored ignored;
    const auto outcome = run(work, parser.value(QStringLiteral("out")), ignored);
    if (!outcome)
        return failed(outcome.error());
    if (ignored.isInside && !deep)
        warnings.emplace_back(
            "the bur begins inside the tooth: it feels and cuts nothing until it has been outside; begin "
            "the path above it");
    if (ignored.readings > 0)
        warnings.push_back("The path leaps: " + std::to_string(ignored.readings) +
                           " ticks of it, to places where no hand can have come in their time, were passed over as bad "
                           "readings");
    if (!record.isEmpty())
        if (const core::Status written = core::recording::writeRecording(record.toStdString(), *outcome->recording);
            !written)
            return failed(written.error());

    printFigures(work, *outcome, warnings, parser.isSet(QStringLiteral("json")),
                 isStandardOutput(parser.value(QStringLiteral("out"))) ? stderr : stdout);
    return kDone;
}

}  // namespace cli
