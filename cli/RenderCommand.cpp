// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCommandLineParser>
#include <QFileInfo>
#include <QImage>

#include "app/threads/Display.h"
#include "cli/Commands.h"
#include "cli/parts/Arguments.h"
#include "cli/render/Pictures.h"
#include "cli/render/Wishes.h"
#include "core/preparation/BlockPreparation.h"
#include "core/preparation/ToothPreparation.h"
#include "core/recording/Recording.h"
#include "core/recording/Replay.h"
#include "core/teeth/ToothBuilder.h"
#include "ui/tooth/Viewpoint.h"

namespace cli {
namespace {

constexpr int kAnyTooth = 36;  ///< not shown: a recording contains its own tooth

/// @param named  the requested tooth; empty: the one of the recording
core::Result<RenderSubject> subjectOf(const QString& recordingFile, const QString& named,
                                      const core::teeth::ToothSource& source, const core::teeth::BuildOptions& build)
{
    if (!recordingFile.isEmpty()) {
        const auto recording = core::recording::readRecording(recordingFile.toStdString());
        if (!recording)
            return tl::unexpected(recording.error());
        auto outcome = core::recording::replay(*recording);
        if (!outcome)
            return tl::unexpected(outcome.error());
        const std::string& own = outcome->tooth.anatomy->name;
        if (!named.isEmpty() && QFileInfo(named).fileName().toStdString() != own)
            return core::unexpected(core::ErrorCode::UnknownName,
                                    "that recording was made on '" + own + "'; leave --tooth out, or name this one");
        return RenderSubject{std::move(outcome->tooth), outcome->state, nullptr};
    }
    const auto tooth = core::teeth::buildTooth(source, build);
    if (!tooth)
        return tl::unexpected(tooth.error());
    warn(tooth->report.warnings);
    return RenderSubject{core::terrain::Tooth(tooth->anatomy), std::nullopt, nullptr};
}

/// Sets the ideal of the picture: the requested one, otherwise the shape of a practice block, otherwise the decay.
core::Status findIdeal(RenderSubject& subject, const RenderWishes& wishes)
{
    const auto& anatomy = subject.tooth.anatomy;
    if (!wishes.ideal.empty()) {
        const auto kind = core::preparation::findKind(wishes.ideal);
        if (!kind)
            return tl::unexpected(kind.error());
        const auto design = core::preparation::fittedDesign(*kind, *anatomy);
        if (!design)
            return tl::unexpected(design.error());
        const auto made = core::preparation::makePreparation(*kind, *design, *anatomy);
        if (!made)
            return tl::unexpected(made.error());
        subject.ideal = made->top;
    } else if (const auto block = core::teeth::findBlock(anatomy->name); block && *block) {
        const auto shape = core::preparation::blockPreparation(**block, *anatomy);
        if (!shape)
            return tl::unexpected(shape.error());
        subject.ideal = shape->top;
    } else {
        subject.ideal = core::grading::idealCavity(*anatomy);
    }
    if (wishes.prepared && subject.ideal)
        subject.tooth = core::terrain::restored(anatomy, *subject.ideal);
    return {};
}

}  // namespace

int renderCommand(const QStringList& arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(
        QStringLiteral("Draws a tooth into a PNG, as the window shows it. Without a display it makes one of its own by "
                       "xvfb-run."));
    addRenderOptions(parser);
    const QString usage = QStringLiteral("cusp render --tooth FILE|FDI [--recording FILE] --out FILE.png [OPTIONS]");
    if (const auto code = parse(parser, arguments, usage))
        return *code;
    if (!parser.positionalArguments().isEmpty())
        return wrongUsage(
            QStringLiteral("\"%1\" belongs to no option; usage: ").arg(parser.positionalArguments().front()) + usage);
    const auto wishes = renderWishes(parser);
    if (!wishes)
        return wrongUsage(QString::fromStdString(wishes.error().detail));
    const bool isArch = wishes->kind == Picture::Arch;
    const QString named = parser.value(QStringLiteral("tooth"));
    const QString recording = parser.value(QStringLiteral("recording"));
    if (isArch && !recording.isEmpty())
        return wrongUsage(QStringLiteral("--arch shows sound teeth and nothing of a --recording"));
    if (!isArch && named.isEmpty() && recording.isEmpty())
        return wrongUsage(QStringLiteral("a --tooth or a --recording is wanted; usage: ") + usage);
    const QString out = parser.value(QStringLiteral("out"));
    if (!out.endsWith(QStringLiteral(".png"), Qt::CaseInsensitive))
        return wrongUsage(QStringLiteral("--out wants the name of a picture that ends in .png"));
    const auto size = pictureSize(parser.value(QStringLiteral("size")));
    if (!size)
        return wrongUsage(QStringLiteral("--size wants width x height in pixels, such as 1280x800, each 16 to 8192"));
    const auto source =
        named.isEmpty() ? core::teeth::ToothSource{kAnyTooth} : core::teeth::parseSource(named.toStdString());
    const auto build = toothOptions(parser, source);
    if (!build)
        return wrongUsage(QString::fromStdString(build.error().detail));
    const int* fdi = std::get_if<int>(&source.what);
    if (isArch && fdi == nullptr)
        return wrongUsage(QStringLiteral("--arch wants the FDI number of a tooth to mark, or none"));
    ui::tooth::Camera camera;
    const QString view = parser.value(QStringLiteral("view"));
    if (const core::Status known = ui::tooth::goTo(camera, view, kAnyTooth); !known)
        return wrongUsage(QString::fromStdString(known.error().detail));
    if (!app::hasDisplay()) {
        const int exitCode = app::runOnDisplay(QStringList{QStringLiteral("render")} + arguments, false);
        return exitCode >= 0 ? exitCode
                             : failed({core::ErrorCode::FileUnreadable,
                                       "A picture needs a display with OpenGL 3.3, or xvfb-run (Debian package xvfb)"});
    }

    core::Result<QImage> picture;
    if (isArch) {
        picture = renderedArch(named.isEmpty() ? 0 : *fdi, *size);
    } else {
        auto subject = subjectOf(recording, named, source, *build);
        if (!subject)
            return failed(subject.error());
        if (const core::Status found = findIdeal(*subject, *wishes); !found)
            return failed(found.error());
        picture = rendered(*subject, *wishes, view, *size);
    }
    if (!picture)
        return failed(picture.error());
    const core::Status saved = savePng(*picture, out);
    return saved ? kDone : failed(saved.error());
}

}  // namespace cli
