// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <span>

#include <QBuffer>
#include <QCommandLineParser>
#include <QImage>
#include <QPainter>

#include "app/Display.h"
#include "app/cli/Arguments.h"
#include "app/cli/Commands.h"
#include "core/base/WholeFile.h"
#include "core/drilling/Bur.h"
#include "core/imaging/Bitewing.h"
#include "core/imaging/Radiograph.h"
#include "core/recording/Recording.h"
#include "core/recording/Replay.h"
#include "core/teeth/Arch.h"
#include "ui/inside/RadiographPicture.h"
#include "ui/inside/SectionPainter.h"
#include "ui/render/ArchRenderer.h"
#include "ui/render/Canvas.h"
#include "ui/render/Presenter.h"
#include "ui/render/ToothRenderer.h"
#include "ui/tooth/MouthScene.h"
#include "ui/tooth/Viewpoint.h"

namespace app::cli {
namespace {

constexpr QRgb kRoomGrey = 0xFF1C1E20;
constexpr QRgb kFilmGround = 0xFF0B0C0D;
constexpr double kFilmMarginMm = 2.0;
constexpr std::uint64_t kGrain = 1;  ///< of the film: every picture has the same
constexpr int kAnyTooth = 36;        ///< where a recording brings its own

/// What is to be drawn: a tooth whole or as an attempt left it, and where the bur was then.
struct Subject
{
    core::terrain::Tooth tooth;
    std::optional<core::session::ServoState> bur;
};

void addOptions(QCommandLineParser& parser)
{
    const auto option = [&](const char* name, const char* help, const char* value) {
        parser.addOption({QLatin1String(name), QLatin1String(help), QLatin1String(value)});
    };
    option("tooth", "A mesh file or an FDI number.", "FILE|FDI");
    option("recording", "Draws what this attempt left of its tooth, and its bur.", "FILE");
    parser.addOption({QStringLiteral("view"),
                      QStringLiteral("From where: %1, or AZ,EL,DIST in degrees, degrees and mm. Azimuth 0 looks along "
                                     "+y; it grows as the eye moves towards +x.")
                          .arg(ui::tooth::viewpointNames().join(QStringLiteral(", "))),
                      QStringLiteral("NAME|AZ,EL,DIST"), QStringLiteral("start")});
    parser.addOption({QStringLiteral("size"), QStringLiteral("Of the picture in pixels; 1280x800 if not given."),
                      QStringLiteral("WxH"), QStringLiteral("1280x800")});
    option("section",
           "Draws, instead, the upright cut through the bur or the middle of the tooth, so many degrees from +x to +y.",
           "ANGLE");
    parser.addOption({QStringLiteral("xray"), QStringLiteral("Draws, instead, an X-ray picture from the side.")});
    parser.addOption({QStringLiteral("bitewing"),
                      QStringLiteral("Draws, instead, an X-ray picture of the crown between its two neighbours.")});
    parser.addOption({QStringLiteral("arch"),
                      QStringLiteral("Draws, instead, the whole mouth; a --tooth of it by its FDI number is marked.")});
    option("stereo", "For two eyes: red-cyan, grey (for the same glasses), side-by-side or top-bottom.", "MODE");
    option("flip", "Turns the picture over: left-right, up-down or both.", "WHICH");
    option(
        "show",
        "What is drawn besides, several with commas: mirror, distinct (colours and patterns that nobody "
        "confuses), wet, light (of the handpiece), depth (the cut coloured by its depth), neighbours (the teeth beside "
        "it).",
        "WHAT");
    option("out", "The picture.", "FILE.png");
    addToothOptions(parser);
}

/// What the picture is of.
enum class Kind : std::uint8_t { Tooth, Section, Xray, Bitewing, Arch };

/// What the options ask of the picture, of the look and of the way to the screen.
struct Wishes
{
    Kind kind = Kind::Tooth;
    double sectionDeg = 0.0;
    ui::render::Look look;
    ui::render::Presentation presentation;
    bool mirror = false;
    bool neighbours = false;
};

/// The one picture that is asked for, and whether the other options go with it.
core::Result<Kind> kindOf(const QCommandLineParser& parser)
{
    QStringList asked;
    Kind kind = Kind::Tooth;
    const QStringList flat{QStringLiteral("section"), QStringLiteral("xray"), QStringLiteral("bitewing"),
                           QStringLiteral("arch")};
    for (int k = 0; k < flat.size(); ++k) {
        if (!parser.isSet(flat[k]))
            continue;
        asked << QStringLiteral("--") + flat[k];
        kind = static_cast<Kind>(k + 1);
    }
    if (asked.size() > 1)
        return core::unexpected(core::ErrorCode::UnknownName,
                                asked.join(u" and ").toStdString() + " are pictures of their own; ask for one");
    if (kind == Kind::Tooth)
        return kind;
    for (const char* option : {"view", "stereo", "flip"})
        if (parser.isSet(QLatin1String(option)))
            return core::unexpected(core::ErrorCode::UnknownName, std::string("--") + option +
                                                                      " is about the tooth in space and means nothing "
                                                                      "with " +
                                                                      asked.front().toStdString());
    const QString show = parser.value(QStringLiteral("show"));
    if (!show.isEmpty() && !(kind == Kind::Section && show == u"distinct"))
        return core::unexpected(core::ErrorCode::UnknownName,
                                kind == Kind::Section ? "with --section, --show knows only distinct"
                                                      : "--show means nothing with " + asked.front().toStdString());
    return kind;
}

core::Result<Wishes> wishesOf(const QCommandLineParser& parser)
{
    using ui::render::Stereo;
    Wishes wishes;
    const auto kind = kindOf(parser);
    if (!kind)
        return tl::unexpected(kind.error());
    wishes.kind = *kind;
    if (*kind == Kind::Section) {
        bool isNumber = false;
        wishes.sectionDeg = parser.value(QStringLiteral("section")).toDouble(&isNumber);
        if (!isNumber || !(std::abs(wishes.sectionDeg) <= 360.0))
            return core::unexpected(core::ErrorCode::OutOfRange, "--section wants degrees from -360 to 360");
    }
    const QString stereo = parser.value(QStringLiteral("stereo"));
    const QStringList modes{QString(), QStringLiteral("red-cyan"), QStringLiteral("grey"),
                            QStringLiteral("side-by-side"), QStringLiteral("top-bottom")};
    if (!modes.contains(stereo) || (stereo.isEmpty() && parser.isSet(QStringLiteral("stereo"))))
        return core::unexpected(core::ErrorCode::UnknownName,
                                "--stereo wants one of" + modes.join(u", ").mid(1).toStdString());
    wishes.presentation.stereo = static_cast<Stereo>(modes.indexOf(stereo));
    if (const QString flip = parser.value(QStringLiteral("flip")); parser.isSet(QStringLiteral("flip"))) {
        wishes.presentation.flipLeftRight = flip == u"left-right" || flip == u"both";
        wishes.presentation.flipUpDown = flip == u"up-down" || flip == u"both";
        if (!wishes.presentation.flipLeftRight && !wishes.presentation.flipUpDown)
            return core::unexpected(core::ErrorCode::UnknownName, "--flip wants left-right, up-down or both");
    }
    for (const QString& what : parser.value(QStringLiteral("show")).split(u',', Qt::SkipEmptyParts)) {
        if (what == u"mirror")
            wishes.mirror = true;
        else if (what == u"distinct")
            wishes.look.palette = ui::render::Palette::Distinct;
        else if (what == u"wet")
            wishes.look.isWet = true;
        else if (what == u"light")
            wishes.look.burLight = true;
        else if (what == u"depth")
            wishes.look.depthColours = ui::render::DepthColours::BelowOriginal;
        else if (what == u"ideal")
            wishes.look.depthColours = ui::render::DepthColours::AgainstIdeal;
        else if (what == u"neighbours")
            wishes.neighbours = true;
        else
            return core::unexpected(core::ErrorCode::UnknownName,
                                    "--show knows mirror, distinct, wet, light, depth, ideal and neighbours, "
                                    "but not \"" +
                                        what.toStdString() + "\"");
    }
    return wishes;
}

/// The upright cut through the bur, or through the middle of the tooth, on the room's dark grey.
QImage sectionPicture(const Subject& subject, double degrees, QSize size, ui::render::Palette palette)
{
    QImage picture(size, QImage::Format_RGB32);
    picture.fill(kRoomGrey);
    ui::inside::SectionScene scene;
    scene.tooth = &subject.tooth;
    scene.plane.angleRad = degrees * std::numbers::pi / 180.0;
    scene.plane.throughMm = subject.tooth.grid().middleMm();
    scene.palette = palette;
    scene.ideal = core::grading::idealCavity(*subject.tooth.anatomy);
    if (subject.bur) {
        scene.bur = &core::drilling::burs()[subject.bur->burIndex];
        scene.tipMm = subject.bur->anchorMm;
        scene.plane.throughMm = glm::dvec2(scene.tipMm);
    }
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    ui::inside::paintSection(painter, QRectF(picture.rect()), scene);
    return picture;
}

/// The whole shadow of the tooth on a film that fills the picture.
QImage xrayPicture(const core::terrain::Tooth& tooth, QSize size)
{
    const core::imaging::XrayedTooth one{&tooth};
    const core::imaging::Beam beam;
    core::imaging::FilmArea area = core::imaging::shadowArea(std::span(&one, 1), beam, kFilmMarginMm);
    const glm::dvec2 wide = area.highMm - area.lowMm;
    const double pixelMm = std::max(wide.x / size.width(), wide.y / size.height());
    const glm::dvec2 more = 0.5 * (glm::dvec2(size.width(), size.height()) * pixelMm - wide);
    area = {area.lowMm - more, area.highMm + more};
    return ui::inside::radiographPicture(std::span(&one, 1), beam, area, pixelMm, {1.0, kGrain})
        .scaled(size)
        .convertToFormat(QImage::Format_RGB32);
}

/// The crown between its neighbours, as wide as there is room for; no higher, or roots would show that a bitewing has
/// not.
core::Result<QImage> bitewingPicture(const core::terrain::Tooth& tooth, QSize size)
{
    const auto neighbours = core::imaging::neighboursOf(*tooth.anatomy);
    if (!neighbours)
        return tl::unexpected(neighbours.error());
    std::vector<core::imaging::XrayedTooth> teeth{{&tooth}};
    for (const core::imaging::Neighbour& neighbour : *neighbours)
        teeth.push_back(neighbour.xrayed());
    const core::imaging::Beam beam;
    core::imaging::FilmArea area = core::imaging::bitewingArea(teeth, beam);
    const glm::dvec2 film = area.highMm - area.lowMm;
    const double wider = 0.5 * std::max(0.0, film.y * size.width() / size.height() - film.x);
    area.lowMm.x -= wider;
    area.highMm.x += wider;
    const double pixelMm = (area.highMm.x - area.lowMm.x) / size.width();
    const QImage developed = ui::inside::radiographPicture(teeth, beam, area, pixelMm, {1.0, kGrain});
    QImage picture(size, QImage::Format_RGB32);
    picture.fill(kFilmGround);
    QPainter(&picture).drawImage((size.width() - developed.width()) / 2, (size.height() - developed.height()) / 2,
                                 developed);
    return picture;
}

/// The whole mouth as the page shows it on which a tooth is chosen.
/// @param chosenFdi  is tinted; 0: none
core::Result<QImage> archPicture(int chosenFdi, QSize size)
{
    const auto canvas = ui::render::Canvas::make(size);
    if (!canvas)
        return tl::unexpected(canvas.error());
    ui::render::ArchRenderer renderer;
    if (QString reason; !renderer.initialize(reason))
        return core::unexpected(core::ErrorCode::FileUnreadable,
                                "this display cannot draw the mouth: " + reason.toStdString());
    const std::vector<core::teeth::ArchPiece> mouth = core::teeth::Arch().mouth(ui::tooth::kMouthOpenRad);
    ui::tooth::Camera camera;
    camera.setViewport({size.width(), size.height()});
    ui::tooth::showPieces(camera, mouth);
    camera.set(ui::tooth::kMouthAzimuthDeg, ui::tooth::kMouthElevationDeg, camera.fittingMm());
    ui::render::ArchScene scene = ui::tooth::mouthThrough(camera);
    scene.chosenFdi = chosenFdi;
    return (*canvas)->picture([&] {
        renderer.setPieces(mouth);
        renderer.drawRoom(glm::vec2(size.width(), size.height()), {0.0F, 0.0F});
        renderer.draw(scene);
    });
}

/// The tooth in space.
core::Result<QImage> toothPicture(const Subject& subject, const Wishes& wishes, const QString& view, QSize size)
{
    const auto& anatomy = subject.tooth.anatomy;
    if (wishes.neighbours && !core::teeth::isGenerated(*anatomy))
        return core::unexpected(core::ErrorCode::UnknownName,
                                "nothing is known of what stands beside '" + anatomy->name +
                                    "'; only a tooth chosen by its FDI number has neighbours");
    ui::render::ToothSurface surface(anatomy, ui::tooth::operatingLight(false));
    surface.write(subject.tooth.top);
    surface.setIdeal(core::grading::idealCavity(*anatomy));
    surface.refresh();

    const auto canvas = ui::render::Canvas::make(size);
    if (!canvas)
        return tl::unexpected(canvas.error());
    ui::render::ToothRenderer renderer;
    ui::render::Presenter presenter;
    if (QString reason; !renderer.initialize(reason) || !presenter.initialize(reason))
        return core::unexpected(core::ErrorCode::FileUnreadable,
                                "this display cannot draw a tooth: " + reason.toStdString());
    ui::tooth::Camera camera;
    camera.setViewport({size.width(), size.height()});
    ui::tooth::showWhole(camera, surface);
    if (const core::Status there = ui::tooth::goTo(camera, view, core::teeth::isGenerated(*anatomy) ? anatomy->fdi : 0);
        !there)
        return tl::unexpected(there.error());
    ui::render::Scene scene = ui::tooth::sceneThrough(camera, glm::vec2(size.width(), size.height()), false);
    if (subject.bur) {
        scene.instrumentShown = true;
        scene.burIndex = subject.bur->burIndex;
        scene.tipMm = subject.bur->anchorMm;
        scene.surfaceBelowTipMm = surface.topMm(glm::dvec2(scene.tipMm));
        scene.liftMm = ui::tooth::liftMm(surface, scene.burIndex, scene.tipMm);
    }
    scene.look = wishes.look;
    if (wishes.mirror)
        scene.mirror = ui::tooth::mirrorBeside(camera, surface, false, wishes.neighbours);
    return (*canvas)->picture([&] {
        renderer.setSurface(surface);
        if (wishes.neighbours)
            renderer.setNeighbours(core::teeth::Arch().neighbours(anatomy->fdi));
        presenter.draw(renderer, scene, wishes.presentation, camera.distanceMm(), ui::render::Canvas::kSamples);
    });
}

core::Result<QImage> draw(const Subject& subject, const Wishes& wishes, const QString& view, QSize size)
{
    switch (wishes.kind) {
    case Kind::Section:
        return sectionPicture(subject, wishes.sectionDeg, size, wishes.look.palette);
    case Kind::Xray:
        return xrayPicture(subject.tooth, size);
    case Kind::Bitewing:
        return bitewingPicture(subject.tooth, size);
    default:
        return toothPicture(subject, wishes, view, size);
    }
}

core::Result<Subject> subjectOf(const QString& recordingFile, const core::teeth::ToothSource& source,
                                const core::teeth::BuildOptions& build)
{
    if (!recordingFile.isEmpty()) {
        const auto recording = core::recording::readRecording(recordingFile.toStdString());
        if (!recording)
            return tl::unexpected(recording.error());
        auto outcome = core::recording::replay(*recording);
        if (!outcome)
            return tl::unexpected(outcome.error());
        return Subject{std::move(outcome->tooth), outcome->state};
    }
    const auto tooth = core::teeth::buildTooth(source, build);
    if (!tooth)
        return tl::unexpected(tooth.error());
    warn(tooth->report.warnings);
    return Subject{core::terrain::Tooth(tooth->anatomy), std::nullopt};
}

core::Status save(const QImage& picture, const QString& file)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    if (!picture.save(&buffer, "PNG"))
        return core::unexpected(core::ErrorCode::FileUnwritable, "the picture could not be made a PNG");
    return core::writeWhole(file.toStdString(), {bytes.constData(), static_cast<std::size_t>(bytes.size())},
                            "The picture");
}

}  // namespace

int renderCommand(const QStringList& arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(
        QStringLiteral("Draws a tooth into a PNG, as the window shows it. Without a display it makes one of its own by "
                       "xvfb-run."));
    addOptions(parser);
    const QString usage = QStringLiteral("cusp render --tooth FILE|FDI --out FILE.png [OPTIONS]");
    if (const auto code = parse(parser, arguments, usage))
        return *code;
    if (!parser.positionalArguments().isEmpty())
        return wrongUsage(
            QStringLiteral("\"%1\" belongs to no option; usage: ").arg(parser.positionalArguments().front()) + usage);
    const auto wishes = wishesOf(parser);
    if (!wishes)
        return wrongUsage(QString::fromStdString(wishes.error().detail));
    const bool isArch = wishes->kind == Kind::Arch;
    const QString named = parser.value(QStringLiteral("tooth"));
    const QString recording = parser.value(QStringLiteral("recording"));
    if (isArch && !recording.isEmpty())
        return wrongUsage(QStringLiteral("--arch shows sound teeth and nothing of a --recording"));
    if (!isArch && named.isEmpty() == recording.isEmpty())
        return wrongUsage(QStringLiteral("one of --tooth and --recording is wanted; usage: ") + usage);
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
    if (!hasDisplay()) {
        const int exitCode = runOnDisplay(QStringList{QStringLiteral("render")} + arguments, false);
        return exitCode >= 0 ? exitCode
                             : failed({core::ErrorCode::FileUnreadable,
                                       "A picture needs a display with OpenGL 3.3, or xvfb-run (Debian package xvfb)"});
    }

    core::Result<QImage> picture;
    if (isArch) {
        picture = archPicture(named.isEmpty() ? 0 : *fdi, *size);
    } else {
        const auto subject = subjectOf(recording, source, *build);
        if (!subject)
            return failed(subject.error());
        picture = draw(*subject, *wishes, view, *size);
    }
    if (!picture)
        return failed(picture.error());
    const core::Status saved = save(*picture, out);
    return saved ? kDone : failed(saved.error());
}

}  // namespace app::cli
