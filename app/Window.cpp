// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/Window.h"

#include <algorithm>
#include <optional>
#include <span>
#include <string_view>

#include <QApplication>
#include <QCommandLineParser>
#include <QLibraryInfo>
#include <QLocale>
#include <QSurfaceFormat>
#include <QTranslator>

#include "app/Application.h"
#include "app/cli/Arguments.h"
#include "app/cli/Commands.h"
#include "ui/shell/Theme.h"

namespace app {
namespace {

constexpr int kSamples = 4;
constexpr int kFirstTooth = 36;

/// Without a display Qt would abort with a message of its own.
bool hasDisplay(std::span<char*> arguments)
{
    return !qEnvironmentVariableIsEmpty("DISPLAY") || !qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY") ||
           qEnvironmentVariableIsSet("QT_QPA_PLATFORM") ||
           std::any_of(arguments.begin(), arguments.end(),
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
    option("language", "en, de or es; the system's own if not given.", "CODE");
    cli::addDeviceOption(parser);
    cli::addToothOptions(parser);
}

/// The languages of translations/; one for a country, such as de_AT, is understood too.
bool isSpoken(const QLocale& locale)
{
    return locale.language() == QLocale::English || locale.language() == QLocale::German ||
           locale.language() == QLocale::Spanish;
}

/// Understands what the window was asked for, or explains what is wrong with it and gives the exit code.
std::optional<int> takeOptions(QCommandLineParser& parser, const QStringList& arguments, WindowOptions& options)
{
    addOptions(parser);
    if (const auto code = cli::parse(parser, arguments, QStringLiteral("cusp [OPTIONS]")))
        return code;
    if (!parser.positionalArguments().isEmpty())
        return cli::wrongUsage(QStringLiteral("\"%1\" belongs to no option; a scan is opened with --tooth FILE")
                                   .arg(parser.positionalArguments().front()));
    if (parser.isSet(QStringLiteral("recording")) && parser.isSet(QStringLiteral("tooth")))
        return cli::wrongUsage(QStringLiteral("a recording brings its own tooth; leave out --tooth or --recording"));
    const auto simulatedDevice = cli::wantsSimulatedDevice(parser);
    if (!simulatedDevice)
        return cli::wrongUsage(QString::fromStdString(simulatedDevice.error().detail));
    options.simulatedDevice = *simulatedDevice;
    options.source = parser.isSet(QStringLiteral("tooth"))
                         ? core::teeth::parseSource(parser.value(QStringLiteral("tooth")).toStdString())
                         : core::teeth::ToothSource{kFirstTooth};
    const auto build = cli::toothOptions(parser, options.source);
    if (!build)
        return cli::wrongUsage(QString::fromStdString(build.error().detail));
    const QString theme = parser.value(QStringLiteral("theme"));
    if (parser.isSet(QStringLiteral("theme")) && theme != u"light" && theme != u"dark")
        return cli::wrongUsage(QStringLiteral("--theme wants light or dark"));
    if (parser.isSet(QStringLiteral("language")) && !isSpoken(QLocale(parser.value(QStringLiteral("language")))))
        return cli::wrongUsage(QStringLiteral("--language wants en, de or es"));
    options.build = *build;
    options.recording = parser.value(QStringLiteral("recording"));
    options.picture = parser.value(QStringLiteral("picture"));
    options.database = parser.value(QStringLiteral("db"));
    // Who names what is to be seen wants to see it; a simulated hand's work is nobody's.
    options.asksWho = options.recording.isEmpty() && options.picture.isEmpty() && !options.simulatedDevice &&
                      !parser.isSet(QStringLiteral("tooth"));
    return std::nullopt;
}

/// What can be said without a display: that the usage is wrong, or that there is none.
int sayThereIsNoDisplay(int& argc, char** argv)
{
    const QCoreApplication application(argc, argv);
    QCommandLineParser parser;
    WindowOptions options;
    if (const auto code = takeOptions(parser, QCoreApplication::arguments().mid(1), options))
        return *code;
    return cli::failed({core::ErrorCode::FileUnreadable,
                        "there is no display to open a window on; \"cusp help\" lists what works without one"});
}

void installLanguage(QApplication& application, const QString& language)
{
    const QLocale locale = language.isEmpty() ? QLocale() : QLocale(language);
    QLocale::setDefault(locale);  // numbers and dates in the language of the words
    for (const auto& [name, folder] :
         {std::pair(QStringLiteral("cusp"), QStringLiteral(":/i18n")),
          std::pair(QStringLiteral("qtbase"), QLibraryInfo::path(QLibraryInfo::TranslationsPath))}) {
        auto* const translator = new QTranslator(&application);
        // Who speaks none of the languages reads English, plurals and all.
        if (translator->load(locale, name, QStringLiteral("_"), folder) ||
            (name == u"cusp" && translator->load(QStringLiteral(":/i18n/cusp_en.qm"))))
            QApplication::installTranslator(translator);
    }
}

}  // namespace

QString windowOptionsHelp()
{
    QCommandLineParser parser;
    addOptions(parser);
    // Before them Qt writes a usage line and the description.
    return parser.helpText().section(QStringLiteral("Options:\n"), 1);
}

int runWindow(int& argc, char** argv)
{
    if (!hasDisplay({argv, static_cast<std::size_t>(argc)}))
        return sayThereIsNoDisplay(argc, argv);
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setSamples(kSamples);
    format.setDepthBufferSize(24);
    QSurfaceFormat::setDefaultFormat(format);

    QApplication application(argc, argv);
    QApplication::setApplicationName(QStringLiteral("cusp"));
    QApplication::setApplicationDisplayName(QStringLiteral("Cusp"));
    QApplication::setApplicationVersion(QStringLiteral(CUSP_VERSION));
    QApplication::setDesktopFileName(QStringLiteral("org.cusp.Cusp"));

    QCommandLineParser parser;
    WindowOptions options;
    if (const auto code = takeOptions(parser, QApplication::arguments().mid(1), options))
        return *code;
    const QString theme = parser.value(QStringLiteral("theme"));

    installLanguage(application, parser.value(QStringLiteral("language")));
    using ui::shell::ThemeChoice;
    ui::shell::applyTheme(application, theme == u"light"  ? ThemeChoice::Light
                                       : theme == u"dark" ? ThemeChoice::Dark
                                                          : ThemeChoice::System);
    const auto program = Application::make(options);
    if (!program)
        return cli::failed(program.error());
    (*program)->show();
    return QApplication::exec();
}

}  // namespace app
