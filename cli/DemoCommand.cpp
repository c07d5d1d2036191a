// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QJsonDocument>

#include "app/attempt/Demonstration.h"
#include "app/threads/Display.h"
#include "cli/Commands.h"
#include "cli/parts/Arguments.h"
#include "cli/parts/Attempt.h"
#include "core/base/WholeFile.h"
#include "core/recording/Recording.h"
#include "lessons/Assignment.h"
#include "lessons/LessonCatalog.h"
#include "ui/devices/DeviceKind.h"

namespace cli {
namespace {

/// Returns the assignment: that of a lesson, or the removal of a tooth's decay.
core::Result<lessons::Assignment> workFor(const QCommandLineParser& parser, const core::teeth::ToothSource& source,
                                          const core::teeth::BuildOptions& build)
{
    const QString wanted = parser.value(QStringLiteral("lesson"));
    if (wanted.isEmpty()) {
        const auto tooth = core::teeth::buildTooth(source, build);
        if (!tooth)
            return tl::unexpected(tooth.error());
        warn(tooth->report.warnings);
        return lessons::practiceOn(tooth->anatomy);
    }
    const auto lesson = lessons::lessonNamed(wanted);
    if (!lesson)
        return tl::unexpected(lesson.error());
    auto assigned = lessons::assign(*lesson);
    if (!assigned)
        return tl::unexpected(assigned.error());
    warn(assigned->report.warnings);
    return std::move(assigned->assignment);
}

/// Returns the ids of the hands that can do the work.
QStringList hands()
{
    return {QLatin1String(ui::devices::kPointer), QLatin1String(ui::devices::kSimulated)};
}

void addOptions(QCommandLineParser& parser)
{
    parser.setApplicationDescription(QStringLiteral(
        "A simulated hand takes the decay out of a tooth, or does what a lesson asks for. Leaves the recording, its "
        "score and a picture in a folder."));
    parser.addOption({QStringLiteral("out"), QStringLiteral("The folder; cusp-demo if not given."),
                      QStringLiteral("FOLDER"), QStringLiteral("cusp-demo")});
    parser.addOption({QStringLiteral("tooth"), QStringLiteral("A mesh file or an FDI number; 36 if not given."),
                      QStringLiteral("FILE|FDI"), QStringLiteral("36")});
    parser.addOption({QStringLiteral("lesson"),
                      QStringLiteral("A lesson's file or id; its tooth is taken, and none of the options about teeth."),
                      QStringLiteral("FILE|ID")});
    addDeviceOption(parser, hands());
    addToothOptions(parser);
}

}  // namespace

int demoCommand(const QStringList& arguments)
{
    QCommandLineParser parser;
    addOptions(parser);
    if (const auto code = parse(parser, arguments, QStringLiteral("cusp demo [--out FOLDER] [OPTIONS]")))
        return *code;
    if (const auto code = refuseWords(parser))
        return *code;
    const auto source = core::teeth::parseSource(parser.value(QStringLiteral("tooth")).toStdString());
    const auto build = toothOptions(parser, source);
    if (!build)
        return wrongUsage(QString::fromStdString(build.error().detail));
    const auto device = chosenDevice(parser, hands());
    if (!device)
        return wrongUsage(QString::fromStdString(device.error().detail));
    const QDir folder(parser.value(QStringLiteral("out")));
    if (!folder.mkpath(QStringLiteral(".")))
        return failed({core::ErrorCode::FileUnwritable,
                       "The folder " + folder.path().toStdString() + " cannot be made; name another with --out."});
    const auto work = workFor(parser, source, *build);
    if (!work)
        return failed(work.error());
    printText((work->lesson ? QStringLiteral("Doing the lesson %1 with a simulated hand ...\n")
                                  .arg(QString::fromStdString(work->lesson->id))
                            : QStringLiteral("Taking the decay out of tooth %1 with a simulated hand ...\n")
                                  .arg(QString::fromStdString(work->anatomy->name))));
    const auto outcome = app::demonstrate(*work, *device == hands().back());
    if (!outcome)
        return failed(outcome.error());

    const QString recording = folder.absoluteFilePath(QStringLiteral("attempt.cusprec"));
    if (const core::Status written = core::recording::writeRecording(recording.toStdString(), *outcome->recording);
        !written)
        return failed(written.error());
    const auto remarked = lessons::markAgain(*outcome->recording);
    if (!remarked)
        return failed(remarked.error());
    const lessons::Mark* const marked = &remarked->mark;
    const QJsonObject score{{QStringLiteral("score"), toJsonObject(marked->sheet)},
                            {QStringLiteral("measures"), toJson(marked->measured)},
                            {QStringLiteral("state_hash"), hashText(core::terrain::stateHash(outcome->tooth))}};
    if (const core::Status written =
            core::writeWhole(folder.absoluteFilePath(QStringLiteral("score.json")).toStdString(),
                             QJsonDocument(score).toJson().toStdString(), "The score");
        !written)
        return failed(written.error());
    const QString scoreText = toText(marked->sheet);
    if (const core::Status written = core::writeWhole(
            folder.absoluteFilePath(QStringLiteral("score.txt")).toStdString(), scoreText.toStdString(), "The score");
        !written)
        return failed(written.error());

    const double lastsS = std::chrono::duration<double>(outcome->recording->duration()).count();
    printText(QStringLiteral("%1 s of drilling, %2 ticks.\n").arg(lastsS, 0, 'f', 1).arg(outcome->recording->ticks()) +
              scoreText);
    const QString picture = folder.absoluteFilePath(QStringLiteral("picture.png"));
    QFile::remove(picture);
    // Hides the messages of Qt and the display on stderr, because the command reports the error in one sentence.
    const bool drawn = app::runOnDisplay({QStringLiteral("render"), QStringLiteral("--recording"), recording,
                                          QStringLiteral("--out"), picture},
                                         true) == kDone;
    printText(QStringLiteral("In %1:\n  attempt.cusprec  replay it with: cusp replay, or in the window\n"
                             "  score.txt, score.json\n")
                  .arg(folder.absolutePath()) +
              (drawn ? QStringLiteral("  picture.png\n") : QString()));
    if (!drawn)
        return failed({core::ErrorCode::FileUnwritable,
                       "The picture could not be drawn: it needs a display with OpenGL 3.3 or xvfb-run (Debian "
                       "package xvfb); the recording and the score are complete."});
    return kDone;
}

}  // namespace cli
