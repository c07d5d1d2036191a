// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of `cusp lesson` that write files: new, capture, pack and unpack.
#include <algorithm>

#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QScopeGuard>

#include "cli/Commands.h"
#include "cli/parts/Arguments.h"
#include "cli/parts/LessonParts.h"
#include "core/base/WholeFile.h"
#include "lessons/Assignment.h"
#include "lessons/IdealFromRecordings.h"
#include "lessons/LessonCatalog.h"
#include "lessons/LessonPack.h"
#include "lessons/NewLesson.h"

namespace cli {
namespace {

constexpr qint64 kLargestSeed = qint64{1} << 53;
const QStringList kMeshes{QStringLiteral("obj"), QStringLiteral("stl"), QStringLiteral("ply")};
const QStringList kTasks{QStringLiteral("remove_decay"), QStringLiteral("cut_ideal"), QStringLiteral("trace_shape")};

std::filesystem::path toPath(const QString& file)
{
    return {file.toStdU16String()};
}

core::Error taken(const QString& file)
{
    return {core::ErrorCode::FileUnwritable,
            QStringLiteral("%1 is there already and is not overwritten; name another with --out")
                .arg(printable(QDir::toNativeSeparators(file)))
                .toStdString()};
}

core::Result<std::optional<double>> numberOf(const QCommandLineParser& parser, const QString& option)
{
    if (!parser.isSet(option))
        return std::optional<double>();
    bool isNumber = false;
    const double number = parser.value(option).toDouble(&isNumber);
    if (!isNumber)
        return core::unexpected(core::ErrorCode::BadNumber,
                                QStringLiteral("--%1 wants a number").arg(option).toStdString());
    return std::optional(number);
}

core::Status addTooth(const QCommandLineParser& parser, lessons::NewLesson& wishes)
{
    const QString tooth = parser.value(QStringLiteral("tooth"));
    if (tooth.startsWith(QStringLiteral("block:"))) {
        wishes.block = tooth.mid(6);
    } else if (kMeshes.contains(QFileInfo(tooth).suffix().toLower())) {
        wishes.scan = QFileInfo(tooth).fileName();
    } else if (!tooth.isEmpty()) {
        bool isNumber = false;
        wishes.fdi = tooth.toInt(&isNumber);
        if (!isNumber)
            return core::unexpected(
                core::ErrorCode::UnknownName,
                "--tooth wants an FDI number, a practice block such as block:cross, or the scan of a "
                "tooth (.obj, .stl, .ply)");
    }
    for (const char* const option : {"unit", "up", "fdi"})
        if (parser.isSet(QLatin1String(option)) && wishes.scan.isEmpty())
            return core::unexpected(core::ErrorCode::OutOfRange,
                                    "--" + std::string(option) + " is about a scan, named with --tooth");
    wishes.unit = parser.value(QStringLiteral("unit"));
    wishes.up = parser.value(QStringLiteral("up"));
    if (parser.isSet(QStringLiteral("fdi"))) {
        const auto fdi = wholeNumber(parser, QStringLiteral("fdi"), 11, 48);
        if (!fdi)
            return tl::unexpected(fdi.error());
        wishes.fdi = static_cast<int>(*fdi);
    }
    if (parser.isSet(QStringLiteral("seed"))) {
        const auto seed = wholeNumber(parser, QStringLiteral("seed"), 0, kLargestSeed);
        if (!seed)
            return tl::unexpected(seed.error());
        wishes.seed = *seed;
    }
    return {};
}

/// Copies a scan to the folder of the new lesson.
core::Status bringScan(const QString& file, const QString& folder)
{
    const QString there = QDir(folder).filePath(QFileInfo(file).fileName());
    if (core::isSameFile(toPath(file), toPath(there)))
        return {};
    if (QFileInfo::exists(there))
        return tl::unexpected(core::Error{core::ErrorCode::FileUnwritable,
                                          QStringLiteral("%1 is there already and is not overwritten; name that one "
                                                         "with --tooth, or call the scan something else")
                                              .arg(printable(QDir::toNativeSeparators(there)))
                                              .toStdString()});
    if (!QFileInfo(file).isFile() || !QFile::copy(file, there))
        return core::unexpected(core::ErrorCode::FileUnreadable,
                                QStringLiteral("%1 cannot be copied beside the lesson; check its name and rights")
                                    .arg(printable(QDir::toNativeSeparators(file)))
                                    .toStdString());
    return {};
}

/// Copies a captured ideal to the folder of the new lesson, because a lesson refers only to files in its own folder.
core::Status bringCaptured(const QString& file, const QString& folder)
{
    const QFileInfo there(QDir(folder).filePath(QFileInfo(file).fileName()));
    if (QFileInfo(file).absoluteFilePath() == there.absoluteFilePath())
        return {};
    const auto ideal = core::preparation::readCaptured(toPath(file));
    if (!ideal)
        return tl::unexpected(ideal.error());
    if (there.exists()) {
        const auto known = core::preparation::readCaptured(toPath(there.filePath()));
        if (known && core::preparation::toBytes(*known) == core::preparation::toBytes(*ideal))
            return {};
        return tl::unexpected(taken(there.filePath()));
    }
    return core::preparation::writeCaptured(toPath(there.filePath()), *ideal);
}

void addNewLessonOptions(QCommandLineParser& parser)
{
    const auto option = [&](const char* name, const char* help, const char* value) {
        parser.addOption({QLatin1String(name), QLatin1String(help), QLatin1String(value)});
    };
    option("id", "Its id: small letters, digits, - and _.", "ID");
    option("from", "The lesson it is based on: an id, or a file in the same folder.", "BASE");
    option("tooth", "FDI number (36), a practice block (block:cross) or a scan (.obj, .stl, .ply).", "FDI|BLOCK|FILE");
    option("unit", "Of the scan: mm, cm, m, in, or the millimetres of one unit; guessed if not given.", "U");
    option("up", "Direction of the crown in the scan: +x -x +y -y +z -z; guessed if not given.", "A");
    option("fdi", "Of the scan.", "NN");
    option("seed", "Which tooth of that number.", "N");
    option("task", "remove_decay, cut_ideal or trace_shape.", "TASK");
    option("title", "What students read; made up if not given.", "WORDS");
    option("captured", "The captured ideal to cut (.cuspideal). Its tolerances go into the rubric.", "FILE");
    option("out", "The lesson; in the teacher's folder under its id if not given.", "FILE.lesson.json");
}

/// Writes a lesson to a file if it has no faults.
core::Status writeLesson(const QJsonObject& object, const QString& out)
{
    const lessons::ReadLesson read = lessons::readDraft(object, out);
    for (const lessons::ValidationIssue& fault : read.faults)
        if (fault.grave)
            return core::unexpected(core::ErrorCode::BadStructure, fault.sentence().toStdString());
    if (const auto assigned = lessons::assign(*read.lesson); !assigned)
        return tl::unexpected(assigned.error());
    const QByteArray json = QJsonDocument(object).toJson();
    return core::writeWhole(toPath(out), {json.constData(), static_cast<std::size_t>(json.size())}, "The lesson");
}

}  // namespace

int newLessonPart(const QStringList& arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral(
        "Writes a lesson that can be given as it is, for a teacher to go on from. What it is based on is read when the "
        "lesson is; only what differs stands in the file. Overwrites nothing."));
    addNewLessonOptions(parser);
    const QString usage = QStringLiteral("cusp lesson new --id ID [--from BASE] [--tooth FDI|BLOCK|FILE] [--task TASK] "
                                         "[--captured FILE] [--out FILE.lesson.json]");
    if (const auto code = parse(parser, arguments, usage))
        return *code;
    if (!parser.positionalArguments().isEmpty())
        return wrongUsage(
            QStringLiteral("\"%1\" belongs to no option; usage: ").arg(parser.positionalArguments().front()) + usage);
    lessons::NewLesson wishes;
    wishes.id = parser.value(QStringLiteral("id"));
    wishes.from = parser.value(QStringLiteral("from"));
    wishes.title = parser.value(QStringLiteral("title"));
    if (wishes.id.isEmpty())
        return wrongUsage(QStringLiteral("a lesson needs an --id; usage: ") + usage);
    if (const QString task = parser.value(QStringLiteral("task")); !task.isEmpty()) {
        if (!kTasks.contains(task))
            return wrongUsage(QStringLiteral("--task wants one of ") + kTasks.join(QStringLiteral(", ")));
        wishes.task = static_cast<lessons::Task>(kTasks.indexOf(task));
    }
    if (const core::Status sound = addTooth(parser, wishes); !sound)
        return wrongUsage(QString::fromStdString(sound.error().detail));
    const QString out = parser.isSet(QStringLiteral("out"))
                            ? parser.value(QStringLiteral("out"))
                            : QDir(lessons::teachersFolder()).filePath(wishes.id + QStringLiteral(".lesson.json"));
    if (!out.endsWith(QStringLiteral(".lesson.json")))
        return wrongUsage(QStringLiteral("--out wants a name that ends in .lesson.json"));
    if (QFileInfo::exists(out) || QFileInfo(out).isSymLink())
        return failed(taken(out));
    const QString folder = QFileInfo(out).absolutePath();
    if (!parser.isSet(QStringLiteral("out")))
        QDir().mkpath(folder);
    const QString scan = QDir(folder).filePath(wishes.scan);
    const bool isScanNew = !wishes.scan.isEmpty() && !QFileInfo::exists(scan);
    if (!wishes.scan.isEmpty())
        if (const core::Status brought = bringScan(parser.value(QStringLiteral("tooth")), folder); !brought)
            return failed(brought.error());
    auto leaveNothing = qScopeGuard([&] {
        if (isScanNew)
            QFile::remove(scan);
    });
    if (const QString captured = parser.value(QStringLiteral("captured")); !captured.isEmpty()) {
        if (const core::Status brought = bringCaptured(captured, folder); !brought)
            return failed(brought.error());
        wishes.captured = QFileInfo(captured).fileName();
    }
    const auto object = lessons::newLesson(wishes, folder);
    if (!object)
        return failed(object.error());
    if (const core::Status written = writeLesson(*object, out); !written)
        return failed(written.error());
    leaveNothing.dismiss();
    printText(QStringLiteral("%1\n").arg(printable(QDir::toNativeSeparators(out))));
    return kDone;
}

int captureLessonPart(const QStringList& arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral(
        "Makes an ideal preparation of one attempt, or of the mean of several at the same tooth, for lessons to name: "
        "what most of them cut, as deep as they did on the average. Overwrites nothing."));
    parser.addPositionalArgument(QStringLiteral("RECORDING"), QStringLiteral("Recordings of attempts (.cusprec)."));
    const auto option = [&](const char* name, const char* help, const char* value) {
        parser.addOption({QLatin1String(name), QLatin1String(help), QLatin1String(value)});
    };
    option("out", "The captured ideal.", "FILE.cuspideal");
    option("outline", "Tolerance of the outline, mm (0.3).", "MM");
    option("depth", "Tolerance of the floor's depth, mm (0.25).", "MM");
    option("wall", "Tolerance of the walls' angle, degrees (5).", "DEG");
    option("floor", "Tolerance of the floor's evenness, mm (0.1).", "MM");
    addJson(parser);
    const QString usage = QStringLiteral("cusp lesson capture --out FILE.cuspideal RECORDING ... [OPTIONS]");
    if (const auto code = parse(parser, arguments, usage))
        return *code;
    const QString out = parser.value(QStringLiteral("out"));
    if (!out.endsWith(QStringLiteral(".cuspideal")) || parser.positionalArguments().isEmpty())
        return wrongUsage(QStringLiteral("name recordings, and --out with a name that ends in .cuspideal; usage: ") +
                          usage);
    if (QFileInfo::exists(out) || QFileInfo(out).isSymLink())
        return failed(taken(out));
    core::preparation::Tolerances tolerances;
    for (const auto& [name, tolerance] :
         {std::pair("outline", &tolerances.outlineMm), std::pair("depth", &tolerances.depthMm),
          std::pair("wall", &tolerances.wallDeg), std::pair("floor", &tolerances.floorMm)}) {
        const auto number = numberOf(parser, QLatin1String(name));
        if (!number)
            return wrongUsage(QString::fromStdString(number.error().detail));
        *tolerance = number->value_or(*tolerance);
    }
    std::vector<std::filesystem::path> recordings;
    for (const QString& file : parser.positionalArguments())
        recordings.push_back(toPath(file));
    const auto ideal = lessons::captureFrom(recordings, tolerances);
    if (!ideal)
        return failed(ideal.error());
    if (const core::Status written = core::preparation::writeCaptured(toPath(out), *ideal); !written)
        return failed(written.error());
    const auto cut = static_cast<qint64>(ideal->heightsMm.size());
    const double areaMm2 = static_cast<double>(cut) * ideal->grid.cellMm * ideal->grid.cellMm;
    QJsonArray sources;
    for (const std::string& source : ideal->sources)
        sources.append(QString::fromStdString(source));
    if (parser.isSet(QStringLiteral("json")))
        printJson({{"file", out},
                   {"tooth", QString::fromStdString(ideal->tooth)},
                   {"seed", static_cast<qint64>(ideal->seed)},
                   {"grid", ideal->grid.side},
                   {"columns", cut},
                   {"area_mm2", areaMm2},
                   {"outline_mm", ideal->tolerances.outlineMm},
                   {"depth_mm", ideal->tolerances.depthMm},
                   {"wall_deg", ideal->tolerances.wallDeg},
                   {"floor_mm", ideal->tolerances.floorMm},
                   {"sources", sources}});
    else
        printText(QStringLiteral("%1: the ideal of %2 recording(s) on tooth %3, %4 mm2 seen from above\n")
                      .arg(printable(QDir::toNativeSeparators(out)))
                      .arg(sources.size())
                      .arg(printable(QString::fromStdString(ideal->tooth)))
                      .arg(areaMm2, 0, 'f', 2));
    return kDone;
}

int packLessonsPart(const QStringList& arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral(
        "Puts lessons into one file with all that they need: what they are based on, rubrics, scans and captured "
        "ideals, each with its hash. Put it into a teacher's folder, or unpack it. Overwrites nothing."));
    parser.addPositionalArgument(QStringLiteral("FILE"), QStringLiteral("Lessons (.lesson.json)."));
    parser.addOption({QStringLiteral("out"), QStringLiteral("The pack."), QStringLiteral("NAME.cusplessons")});
    const QString usage = QStringLiteral("cusp lesson pack FILE ... --out NAME.cusplessons");
    if (const auto code = parse(parser, arguments, usage))
        return *code;
    const QString out = parser.value(QStringLiteral("out"));
    if (parser.positionalArguments().isEmpty() || !out.endsWith(QStringLiteral(".cusplessons")))
        return wrongUsage(QStringLiteral("name lessons, and --out with a name that ends in .cusplessons; usage: ") +
                          usage);
    if (QFileInfo::exists(out) || QFileInfo(out).isSymLink())
        return failed(taken(out));
    const auto bytes = lessons::packLessons(parser.positionalArguments());
    if (!bytes)
        return failed(bytes.error());
    const core::Status written =
        core::writeWhole(toPath(out), {bytes->constData(), static_cast<std::size_t>(bytes->size())}, "The pack");
    if (!written)
        return failed(written.error());
    // Reads the pack back as another Cusp would read it.
    const auto files = lessons::readPack(out);
    if (!files)
        return failed(files.error());
    QString text = QStringLiteral("%1: %2 file(s)\n").arg(printable(out)).arg(files->size());
    for (const lessons::PackedFile& file : *files)
        text += QStringLiteral("  %1 %2 bytes\n").arg(printable(file.name), -40).arg(file.content.size());
    printText(text);
    return kDone;
}

int unpackLessonsPart(const QStringList& arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral(
        "Checks a pack of lessons and puts its files into a folder, the teacher's own if none is named. Overwrites "
        "nothing, and writes nothing at all if something is wrong."));
    parser.addPositionalArgument(QStringLiteral("FILE"), QStringLiteral("The pack (.cusplessons)."));
    parser.addOption({QStringLiteral("folder"), QStringLiteral("Where to."), QStringLiteral("FOLDER")});
    const QString usage = QStringLiteral("cusp lesson unpack FILE [--folder FOLDER]");
    if (const auto code = parse(parser, arguments, usage))
        return *code;
    if (parser.positionalArguments().size() != 1)
        return wrongUsage(QStringLiteral("name one pack; usage: ") + usage);
    const QString folder =
        parser.isSet(QStringLiteral("folder")) ? parser.value(QStringLiteral("folder")) : lessons::teachersFolder();
    const auto files = lessons::readPack(parser.positionalArguments().front());
    if (!files)
        return failed(files.error());
    if (const core::Status put = lessons::putInto(folder, *files); !put)
        return failed(put.error());
    QString text;
    for (const lessons::PackedFile& file : *files)
        text += printable(QDir::toNativeSeparators(QDir(folder).filePath(file.name))) + u'\n';
    printText(text);
    return kDone;
}

}  // namespace cli
