// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/parts/Arguments.h"

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <limits>

#include <QJsonDocument>
#include <QStringDecoder>

#include "cli/parts/ExitCode.h"
#include "core/bur/Bur.h"
#include "core/teeth/Laid.h"
#include "core/teeth/LesionSite.h"
#include "core/teeth/ToothTable.h"
#include "haptics/simulated/Simulation.h"

namespace cli {
namespace {

void printTo(std::FILE* stream, const QString& text)
{
    const QByteArray bytes = text.toLocal8Bit();
    std::fwrite(bytes.constData(), 1, static_cast<std::size_t>(bytes.size()), stream);
    std::fflush(stream);
}

void explain(const QString& sentence)
{
    QString text = printable(sentence.simplified());
    if (!text.endsWith(u'.'))
        text += u'.';
    printTo(stderr, QStringLiteral("cusp: ") + text + u'\n');
}

core::Status readNumbers(const QCommandLineParser& parser, core::teeth::BuildOptions& options)
{
    if (parser.isSet(QStringLiteral("grid"))) {
        const auto grid =
            wholeNumber(parser, QStringLiteral("grid"), core::terrain::kMinGridSide, core::terrain::kMaxGridSide);
        if (!grid)
            return tl::unexpected(grid.error());
        options.gridSide = static_cast<int>(*grid);
    }
    if (parser.isSet(QStringLiteral("fdi"))) {
        const auto fdi = wholeNumber(parser, QStringLiteral("fdi"), 11, 48);
        if (!fdi || *fdi % 10 == 0 || *fdi % 10 == 9)
            return core::unexpected(core::ErrorCode::OutOfRange,
                                    "--fdi wants the number of a permanent tooth, 11-18, 21-28, 31-38 or 41-48");
        options.fdi = static_cast<int>(*fdi);
    }
    if (parser.isSet(QStringLiteral("seed"))) {
        const auto seed = wholeNumber(parser, QStringLiteral("seed"), 0, std::numeric_limits<qint64>::max());
        if (!seed)
            return tl::unexpected(seed.error());
        options.seed = static_cast<std::uint64_t>(*seed);
    }
    bool isNumber = false;
    options.cariesExtent = parser.value(QStringLiteral("extent")).toDouble(&isNumber);
    if (!isNumber || !(options.cariesExtent >= 0.0 && options.cariesExtent <= 1.0))
        return core::unexpected(core::ErrorCode::OutOfRange, "--extent wants a number from 0 to 1");
    return {};
}

core::Status readPlacement(const QCommandLineParser& parser, core::mesh::PlacementOptions& placement)
{
    if (parser.isSet(QStringLiteral("unit"))) {
        auto unit = core::mesh::parseUnit(parser.value(QStringLiteral("unit")).toStdString());
        if (!unit)
            return tl::unexpected(std::move(unit).error());
        placement.unit = *unit;
    }
    if (parser.isSet(QStringLiteral("up"))) {
        auto up = core::mesh::parseUp(parser.value(QStringLiteral("up")).toStdString());
        if (!up)
            return tl::unexpected(std::move(up).error());
        placement.up = *up;
    }
    if (const QString frame = parser.value(QStringLiteral("frame")); frame == u"file")
        placement.keepFrame = true;
    else if (frame != u"tooth")
        return core::unexpected(core::ErrorCode::UnknownName, "--frame wants \"file\" or \"tooth\"");
    if (placement.keepFrame && (placement.unit || placement.up))
        return core::unexpected(core::ErrorCode::OutOfRange,
                                "--frame file means millimetres with +z up, so --unit and --up cannot go with it");
    return {};
}

core::Status readLying(const QCommandLineParser& parser, const core::teeth::ToothSource& source,
                       core::teeth::BuildOptions& options)
{
    if (!parser.isSet(QStringLiteral("lies"))) {
        if (parser.isSet(QStringLiteral("tilt")))
            return core::unexpected(core::ErrorCode::OutOfRange,
                                    "--tilt says how far a tooth lies on a side; say which "
                                    "by --lies");
    } else {
        if (std::holds_alternative<core::teeth::BlockDesign>(source.what))
            return core::unexpected(core::ErrorCode::OutOfRange,
                                    "--lies is about a tooth, and a practice block lies on no side; leave it out");
        bool isNumber = false;
        const double tiltDeg = parser.value(QStringLiteral("tilt")).toDouble(&isNumber);
        if (!isNumber)
            return core::unexpected(core::ErrorCode::OutOfRange, "--tilt wants a number of degrees from 5 to 90");
        const int* const fdi = std::get_if<int>(&source.what);
        const auto lying = core::teeth::findLying(parser.value(QStringLiteral("lies")).toStdString(), tiltDeg,
                                                  fdi != nullptr ? *fdi : 0);
        if (!lying)
            return tl::unexpected(lying.error());
        options.lying = *lying;
    }
    if (!parser.isSet(QStringLiteral("site")))
        return {};
    const QString site = parser.value(QStringLiteral("site"));
    const auto known = std::find(std::begin(core::teeth::kLesionSites), std::end(core::teeth::kLesionSites), site);
    if (known == std::end(core::teeth::kLesionSites))
        return core::unexpected(core::ErrorCode::UnknownName,
                                "--site wants \"fissure\", \"cervical\", \"pit\" or \"contact\"");
    options.site = static_cast<core::teeth::LesionSite>(known - std::begin(core::teeth::kLesionSites));
    return core::teeth::checkSite(*options.site, options.lying);
}

/// Checks that the source exists, and that the options apply to it.
core::Status checkSource(const QCommandLineParser& parser, const core::teeth::ToothSource& source)
{
    if (std::holds_alternative<std::filesystem::path>(source.what))
        return {};
    const int* const fdi = std::get_if<int>(&source.what);
    if (fdi != nullptr)
        if (const auto known = core::teeth::findToothSizes(*fdi); !known)
            return tl::unexpected(known.error());
    const QString what = fdi != nullptr ? QStringLiteral("tooth %1").arg(*fdi) : QStringLiteral("a practice block");
    for (const char* option : {"unit", "up", "fdi", "frame"})
        if (parser.isSet(QLatin1String(option)))
            return core::unexpected(core::ErrorCode::OutOfRange,
                                    QStringLiteral("--%1 is about a mesh file, and %2 comes from no file; leave it out")
                                        .arg(QLatin1String(option), what)
                                        .toStdString());
    return {};
}

core::Status readTissues(const QCommandLineParser& parser, core::teeth::BuildOptions& options)
{
    using core::teeth::CariesRule;
    using core::teeth::LayerRule;
    const QString layers = parser.value(QStringLiteral("layers"));
    if (layers != u"anatomical" && layers != u"2011")
        return core::unexpected(core::ErrorCode::UnknownName, "--layers wants \"anatomical\" or \"2011\"");
    options.layers = layers == u"2011" ? LayerRule::ConstantDepth2011 : LayerRule::Anatomical;
    const QString caries = parser.value(QStringLiteral("caries"));
    if (caries != u"walk" && caries != u"2011" && caries != u"none")
        return core::unexpected(core::ErrorCode::UnknownName, "--caries wants \"walk\", \"2011\" or \"none\"");
    if (caries == u"none")
        options.caries.reset();
    else
        options.caries = caries == u"2011" ? CariesRule::LowPointFill2011 : CariesRule::FissureWalk;
    return {};
}

}  // namespace

std::optional<int> parse(QCommandLineParser& parser, const QStringList& arguments, const QString& usage,
                         const QString& repeatable)
{
    const QCommandLineOption help({QStringLiteral("h"), QStringLiteral("help")}, QStringLiteral("Prints this help."));
    parser.addOption(help);
    const bool understood = parser.parse(QStringList{QStringLiteral("cusp")} + arguments);
    if (understood && parser.isSet(help)) {
        // Qt's first line names only the program. The rest of its help is printed.
        printText(QStringLiteral("Usage: ") + usage + parser.helpText().section(u'\n', 1).prepend(u'\n'));
        return kDone;
    }
    if (understood) {
        for (const QString& name : parser.optionNames())
            if (name != repeatable && parser.values(name).size() > 1)
                return wrongUsage(QStringLiteral("--%1 is given more than once; say which you mean").arg(name));
        return std::nullopt;
    }
    QString fault = parser.errorText();
    fault.chop(fault.endsWith(u'.') ? 1 : 0);
    return wrongUsage(fault + QStringLiteral("; usage: ") + usage);
}

std::optional<int> refuseWords(const QCommandLineParser& parser)
{
    if (parser.positionalArguments().isEmpty())
        return std::nullopt;
    return wrongUsage(QStringLiteral("\"%1\" belongs to no option").arg(parser.positionalArguments().front()));
}

void addJson(QCommandLineParser& parser)
{
    parser.addOption({QStringLiteral("json"), QStringLiteral("Answers in JSON.")});
}

int runPart(const QString& command, std::span<const CommandPart> parts, const QStringList& arguments)
{
    QStringList names;
    for (const CommandPart& part : parts)
        names << QLatin1String(part.name);
    if (arguments.isEmpty())
        return wrongUsage(
            QStringLiteral("say what about %1s: %2; \"cusp %1 --help\" explains")
                .arg(command, names.mid(0, names.size() - 1).join(u", ") + QStringLiteral(" or ") + names.last()));
    const QString& first = arguments.front();
    if (first == u"--help" || first == u"-h" || first == u"help") {
        QString text = QStringLiteral("Usage: cusp %1 PART [OPTIONS]\n\n").arg(command);
        for (const CommandPart& part : parts)
            text += QStringLiteral("  cusp %1 %2 %3\n")
                        .arg(command)
                        .arg(QLatin1String(part.name), -9)
                        .arg(QLatin1String(part.summary));
        printText(text + QStringLiteral("\n\"cusp %1 PART --help\" explains one.\n").arg(command));
        return kDone;
    }
    const qsizetype at = names.indexOf(first);
    if (at < 0)
        return wrongUsage(
            QStringLiteral("cusp %1 has no part \"%2\"; \"cusp %1 --help\" lists them").arg(command, printable(first)));
    return parts[static_cast<std::size_t>(at)].run(arguments.mid(1));
}

void addToothOptions(QCommandLineParser& parser)
{
    const auto add = [&](const char* name, const char* help, const char* value, const char* standard = "") {
        parser.addOption({QLatin1String(name), QLatin1String(help), QLatin1String(value), QLatin1String(standard)});
    };
    add("grid", "Nodes a side of the height maps, 64 to 1024 (150).", "N");
    add("unit", "Unit of the file: mm, cm, m, in, or millimetres in one unit; guessed when absent.", "U");
    add("up",
        "Direction of the crown in the file: +x -x +y -y +z -z, or three "
        "numbers such as 1,0,1; guessed when absent.",
        "A");
    add("fdi", "FDI number of the tooth in the file.", "NN");
    add("frame", "\"file\" keeps the file's own coordinates, taken as mm with +z up.", "FRAME", "tooth");
    add("seed", "Seed of shape, layers and decay (0).", "N");
    add("layers", "Rule of enamel and pulp: anatomical or 2011.", "RULE", "anatomical");
    add("caries", "Rule of the decay: walk, 2011 or none.", "RULE", "walk");
    add("lies", "Side turned to the bur: occlusal, mesial, distal, buccal, lingual; of a file -x, +x, -y, +y.", "SIDE");
    add("tilt", "How far it lies on that side, 5 to 90 degrees.", "DEG", "90");
    add("site", "Where the decay is: fissure, cervical, pit or contact; what is usual for the side if not given.",
        "SITE");
    add("extent", "How far the decay has gone, 0 to 1.", "X", "0.5");
}

core::Result<core::teeth::BuildOptions> toothOptions(const QCommandLineParser& parser,
                                                     const core::teeth::ToothSource& source)
{
    core::teeth::BuildOptions options;
    for (core::Status status :
         {readNumbers(parser, options), readPlacement(parser, options.placement), readTissues(parser, options),
          checkSource(parser, source), readLying(parser, source, options)})
        if (!status)
            return tl::unexpected(std::move(status).error());
    return options;
}

void addBurOption(QCommandLineParser& parser, const QString& value, const QString& more)
{
    const std::string& usual = core::bur::burs()[haptics::SimulationOptions().burIndex].id;
    const QString burs = QString::fromStdString(core::bur::burIds());
    parser.addOption(
        {QStringLiteral("bur"),
         QStringLiteral("The bur (default %1): one of %2%3.")
             .arg(QString::fromStdString(usual), burs, more.isEmpty() ? more : QStringLiteral("; ") + more),
         value});
}

void addDeviceOption(QCommandLineParser& parser, const QStringList& ids)
{
    parser.addOption(
        {QStringLiteral("device"),
         QStringLiteral("The hand that moves the bur: %1. With \"simulated\", a simulated Falcon in a simulated hand "
                        "does the work.")
             .arg(ids.join(QStringLiteral(", "))),
         QStringLiteral("DEVICE")});
}

core::Result<QString> chosenDevice(const QCommandLineParser& parser, const QStringList& ids)
{
    const QString device = parser.value(QStringLiteral("device"));
    if (parser.isSet(QStringLiteral("device")) && !ids.contains(device))
        return core::unexpected(core::ErrorCode::UnknownName,
                                "--device wants one of " + ids.join(QStringLiteral(", ")).toStdString());
    return device;
}

core::Result<qint64> wholeNumber(const QCommandLineParser& parser, const QString& option, qint64 low, qint64 high)
{
    bool isNumber = false;
    const qint64 number = parser.value(option).toLongLong(&isNumber);
    if (!isNumber || number < low || number > high)
        return core::unexpected(
            core::ErrorCode::OutOfRange,
            QStringLiteral("--%1 wants a whole number from %2 to %3").arg(option).arg(low).arg(high).toStdString());
    return number;
}

std::optional<int> refuseOddNames(std::span<char* const> arguments)
{
    for (const char* const argument : arguments) {
        QStringDecoder decode(QStringDecoder::Utf8, QStringDecoder::Flag::Stateless);
        const QString name = decode(QByteArrayView(argument));
        if (decode.hasError())
            return failed({core::ErrorCode::FileUnreadable,
                           "Cusp cannot open what is called \"" + name.toStdString() +
                               "\", because the name is not written in UTF-8; rename the file and try again"});
    }
    return std::nullopt;
}

QString printable(QString text)
{
    for (QChar& letter : text)
        if (letter.category() == QChar::Other_Control)
            letter = u'?';
    return text;
}

int wrongUsage(const QString& sentence)
{
    explain(sentence);
    return kWrongUsage;
}

int failed(const core::Error& error)
{
    explain(QString::fromStdString(error.detail));
    return kFailed;
}

void warn(const std::vector<std::string>& warnings)
{
    for (const std::string& warning : warnings)
        explain(QStringLiteral("warning: ") + QString::fromStdString(warning));
}

void printText(const QString& text, std::FILE* stream)
{
    printTo(stream, text);
}

void printJson(const QJsonObject& object, std::FILE* stream)
{
    printTo(stream, QString::fromUtf8(QJsonDocument(object).toJson()));
}

QJsonArray toJsonArray(const std::vector<std::string>& sentences)
{
    QJsonArray array;
    for (const std::string& sentence : sentences)
        array.append(QString::fromStdString(sentence));
    return array;
}

std::optional<QSize> pictureSize(const QString& text)
{
    constexpr int kLeastPx = 16;
    constexpr int kMostPx = 8192;
    const QStringList parts = text.toLower().split(u'x');
    if (parts.size() != 2)
        return std::nullopt;
    const QSize size(parts[0].toInt(), parts[1].toInt());
    const bool good =
        size.width() >= kLeastPx && size.height() >= kLeastPx && size.width() <= kMostPx && size.height() <= kMostPx;
    return good ? std::optional(size) : std::nullopt;
}

}  // namespace cli
