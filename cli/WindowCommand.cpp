// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/WindowCommand.h"

#include <algorithm>
#include <optional>
#include <span>
#include <string_view>

#include <QApplication>
#include <QCommandLineParser>
#include <QLocale>
#include <QSurfaceFormat>

#include "app/Application.h"
#include "app/devices/StationDevices.h"
#include "app/devices/StopForces.h"
#include "app/threads/Display.h"
#include "cli/Commands.h"
#include "cli/parts/Arguments.h"
#include "ui/devices/DeviceKind.h"
#include "ui/kit/LanguageMenu.h"
#include "ui/kit/Theme.h"
#include "ui/text/Language.h"

namespace cli {
namespace {

constexpr int kSamples = 4;
constexpr int kFirstTooth = 36;

/// Returns whether the arguments name a platform of Qt, which Qt then opens whatever the environment says.
bool namePlatform(std::span<char*> arguments)
{
    return std::any_of(arguments.begin(), arguments.end(),
                       [](const char* argument) { return std::string_view(argument).ends_with("-platform"); });
}

void addOptions(QCommandLineParser& parser)
{
    parser.setApplicationDescription(QStringLiteral("Opens the window."));
    const auto option = [&](const char* name, const char* help, const char* value) {
        parser.addOption({QLatin1String(name), QLatin1String(help), QLatin1String(value)});
    };
    option("tooth", "The tooth to begin with: a mesh file, an FDI number or a practice block such as block:line.",
           "FILE|FDI");
    option("recording", "Plays a recording.", "FILE");
    option("picture", "Draws the tooth, or the end of the recording, into a PNG and quits.", "FILE.png");
    option("db", "The school's data: a file, or postgresql://user@host/name.", "FILE|URL");
    option("theme", "light or dark; the desktop's own if not given.", "THEME");
    option("language", "one of those that it speaks; if not given, the one chosen before, or the system's own.",
           "CODE");
    addDeviceOption(parser, app::handIds());
    addToothOptions(parser);
}

/// Reads the options of the window. If one is wrong, prints an explanation and returns the exit code.
std::optional<int> takeOptions(QCommandLineParser& parser, const QStringList& arguments, app::WindowOptions& options)
{
    addOptions(parser);
    if (const auto code = parse(parser, arguments, QStringLiteral("cusp [OPTIONS]")))
        return code;
    if (!parser.positionalArguments().isEmpty())
        return wrongUsage(QStringLiteral("\"%1\" belongs to no option; a scan is opened with --tooth FILE")
                              .arg(parser.positionalArguments().front()));
    if (parser.isSet(QStringLiteral("recording")) && parser.isSet(QStringLiteral("tooth")))
        return wrongUsage(QStringLiteral("a recording brings its own tooth; leave out --tooth or --recording"));
    const auto device = chosenDevice(parser, app::handIds());
    if (!device)
        return wrongUsage(QString::fromStdString(device.error().detail));
    options.device = *device;
    options.source = parser.isSet(QStringLiteral("tooth"))
                         ? core::teeth::parseSource(parser.value(QStringLiteral("tooth")).toStdString())
                         : core::teeth::ToothSource{kFirstTooth};
    const auto build = toothOptions(parser, options.source);
    if (!build)
        return wrongUsage(QString::fromStdString(build.error().detail));
    const QString theme = parser.value(QStringLiteral("theme"));
    if (parser.isSet(QStringLiteral("theme")) && theme != u"light" && theme != u"dark")
        return wrongUsage(QStringLiteral("--theme wants light or dark"));
    if (parser.isSet(QStringLiteral("language")) &&
        !ui::text::Language::isAvailable(parser.value(QStringLiteral("language"))))
        return wrongUsage(QStringLiteral("--language wants ") +
                          ui::text::Language::available().join(QStringLiteral(", ")));
    options.build = *build;
    options.recording = parser.value(QStringLiteral("recording"));
    options.picture = parser.value(QStringLiteral("picture"));
    options.database = parser.value(QStringLiteral("db"));
    // With a named recording, picture or tooth, the window opens it at once. With a simulated hand, no user works.
    // Neither needs a login.
    options.asksWho = options.recording.isEmpty() && options.picture.isEmpty() &&
                      options.device != QLatin1String(ui::devices::kSimulated) &&
                      !parser.isSet(QStringLiteral("tooth"));
    options.showsRound = options.asksWho;
    return std::nullopt;
}

/// Prints, without a display, that the usage is wrong or why no window can be opened.
int sayThereIsNoDisplay(int& argc, char** argv, const QString& why)
{
    const QCoreApplication application(argc, argv);
    QCommandLineParser parser;
    app::WindowOptions options;
    if (const auto code = takeOptions(parser, QCoreApplication::arguments().mid(1), options))
        return *code;
    return failed({core::ErrorCode::FileUnreadable,
                   "no window can be opened: " + why.toStdString() +
                       "; \"cusp render\" draws pictures without a display, \"cusp help\" lists what else works"});
}

/// Returns the requested language, otherwise the one of the last run, otherwise that of the system.
QString languageOf(const QCommandLineParser& parser)
{
    if (parser.isSet(QStringLiteral("language")))
        return parser.value(QStringLiteral("language"));
    const QString chosen = ui::kit::LanguageMenu::remembered();
    return chosen.isEmpty() ? QLocale::system().name() : chosen;
}

}  // namespace

QString windowOptionsHelp()
{
    QCommandLineParser parser;
    addOptions(parser);
    // The text of Qt begins with a usage line and the description, which are removed.
    return parser.helpText().section(QStringLiteral("Options:\n"), 1);
}

int runWindow(int& argc, char** argv)
{
    if (!namePlatform({argv, static_cast<std::size_t>(argc)}))
        if (const QString why = app::whyNoDisplay(qEnvironmentVariable("QT_QPA_PLATFORM")); !why.isEmpty())
            return sayThereIsNoDisplay(argc, argv, why);
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setSamples(kSamples);
    format.setDepthBufferSize(24);
    QSurfaceFormat::setDefaultFormat(format);

    const QtMessageHandler handler = qInstallMessageHandler(hearQtStart);
    QApplication application(argc, argv);
    qInstallMessageHandler(handler);
    QApplication::setApplicationName(QStringLiteral("cusp"));
    QApplication::setApplicationDisplayName(QStringLiteral("Cusp"));
    QApplication::setApplicationVersion(QStringLiteral(CUSP_VERSION));
    QApplication::setDesktopFileName(QStringLiteral("org.cusp.Cusp"));

    QCommandLineParser parser;
    app::WindowOptions options;
    if (const auto code = takeOptions(parser, QApplication::arguments().mid(1), options))
        return *code;
    const QString theme = parser.value(QStringLiteral("theme"));

    ui::text::Language::choose(languageOf(parser));
    using ui::kit::ThemeChoice;
    ui::kit::applyTheme(application, theme == u"light"  ? ThemeChoice::Light
                                     : theme == u"dark" ? ThemeChoice::Dark
                                                        : ui::kit::rememberedTheme());
    app::stopForcesOnSignals();
    const auto program = app::Application::make(options);
    if (!program)
        return failed(program.error());
    (*program)->show();
    const int code = QApplication::exec();
    return (*program)->endedBy() ? failed(*(*program)->endedBy()) : code;
}

}  // namespace cli
