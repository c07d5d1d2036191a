// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/render/Pictures.h"

#include <algorithm>
#include <cstdint>
#include <numbers>
#include <span>

#include <QBuffer>
#include <QPainter>

#include "core/base/WholeFile.h"
#include "core/bur/Bur.h"
#include "core/imaging/Bitewing.h"
#include "core/imaging/Radiograph.h"
#include "core/teeth/Arch.h"
#include "core/teeth/ToothBuilder.h"
#include "ui/inside/RadiographPicture.h"
#include "ui/inside/SectionPainter.h"
#include "ui/render/ArchRenderer.h"
#include "ui/render/Canvas.h"
#include "ui/render/ToothRenderer.h"
#include "ui/tooth/MouthScene.h"
#include "ui/tooth/ViewMarks.h"
#include "ui/tooth/Viewpoint.h"

namespace cli {
namespace {

constexpr QRgb kRoomGrey = 0xFF1C1E20;
constexpr QRgb kFilmGround = 0xFF0B0C0D;
constexpr double kFilmMarginMm = 2.0;
constexpr int kFilmGapPx = 12;
constexpr std::uint64_t kGrain = 1;  ///< seed of the film's grain: the same in every picture

core::imaging::Beam beamOf(const core::terrain::ToothAnatomy& anatomy, const RenderWishes& wishes)
{
    core::imaging::Beam beam;
    beam.angleRad += wishes.beamDeg * std::numbers::pi / 180.0;
    return core::imaging::laidBeam(anatomy.lying, beam);
}

/// Returns the vertical section through the bur, or through the middle of the tooth, on the dark grey background.
QImage sectionPicture(const RenderSubject& subject, double degrees, QSize size, ui::render::Palette palette)
{
    QImage picture(size, QImage::Format_RGB32);
    picture.fill(kRoomGrey);
    ui::inside::SectionScene scene;
    scene.tooth = &subject.tooth;
    scene.plane.angleRad = degrees * std::numbers::pi / 180.0;
    scene.plane.throughMm = subject.tooth.grid().middleMm();
    scene.palette = palette;
    scene.ideal = subject.ideal;
    if (subject.bur) {
        scene.bur = &core::bur::burs()[subject.bur->burIndex];
        scene.tipMm = subject.bur->anchorMm;
        scene.plane.throughMm = glm::dvec2(scene.tipMm);
    }
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    ui::inside::paintSection(painter, QRectF(picture.rect()), scene);
    return picture;
}

/// Returns a radiograph of the whole tooth. Its film fills the picture, or half of it beside a film of the uncut tooth.
QImage xrayPicture(const core::terrain::Tooth& tooth, const RenderWishes& wishes, QSize size)
{
    const core::imaging::Beam beam = beamOf(*tooth.anatomy, wishes);
    const core::terrain::Tooth whole(tooth.anatomy);
    const core::imaging::XrayedTooth before{&whole};
    // Both films show the same part of space.
    core::imaging::FilmArea area = core::imaging::shadowArea(std::span(&before, 1), beam, kFilmMarginMm);
    const QSize film(wishes.before ? std::max(1, (size.width() - kFilmGapPx) / 2) : size.width(), size.height());
    const glm::dvec2 wide = area.highMm - area.lowMm;
    const double pixelMm = std::max(wide.x / film.width(), wide.y / film.height());
    const glm::dvec2 more = 0.5 * (glm::dvec2(film.width(), film.height()) * pixelMm - wide);
    area = {area.lowMm - more, area.highMm + more};
    const auto developed = [&](const core::terrain::Tooth& shown) {
        const core::imaging::XrayedTooth one{&shown};
        return ui::inside::radiographPicture(std::span(&one, 1), beam, area, pixelMm, {wishes.exposure, kGrain})
            .scaled(film)
            .convertToFormat(QImage::Format_RGB32);
    };
    if (!wishes.before)
        return developed(tooth);
    QImage both(size, QImage::Format_RGB32);
    both.fill(kFilmGround);
    QPainter painter(&both);
    painter.drawImage(0, 0, developed(whole));
    painter.drawImage(size.width() - film.width(), 0, developed(tooth));
    return both;
}

/// Returns a bitewing of the crown between its neighbours, as wide as fits. Its height is limited, because a bitewing
/// does not show the roots.
core::Result<QImage> bitewingPicture(const core::terrain::Tooth& tooth, const RenderWishes& wishes, QSize size)
{
    const auto neighbours = core::imaging::neighboursOf(*tooth.anatomy);
    if (!neighbours)
        return tl::unexpected(neighbours.error());
    std::vector<core::imaging::XrayedTooth> teeth{{&tooth}};
    for (const core::imaging::Neighbour& neighbour : *neighbours)
        teeth.push_back(neighbour.xrayed());
    const core::imaging::Beam beam = beamOf(*tooth.anatomy, wishes);
    core::imaging::FilmArea area = core::imaging::bitewingArea(teeth, beam);
    const glm::dvec2 film = area.highMm - area.lowMm;
    const double wider = 0.5 * std::max(0.0, film.y * size.width() / size.height() - film.x);
    area.lowMm.x -= wider;
    area.highMm.x += wider;
    const double pixelMm = (area.highMm.x - area.lowMm.x) / size.width();
    const QImage developed = ui::inside::radiographPicture(teeth, beam, area, pixelMm, {wishes.exposure, kGrain});
    QImage picture(size, QImage::Format_RGB32);
    picture.fill(kFilmGround);
    QPainter(&picture).drawImage((size.width() - developed.width()) / 2, (size.height() - developed.height()) / 2,
                                 developed);
    return picture;
}

/// Paints the marks that the window paints over its picture.
void paintMarks(QImage& picture, const RenderSubject& subject, const RenderWishes& wishes,
                const ui::tooth::Camera& camera)
{
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    const core::terrain::ToothAnatomy& anatomy = *subject.tooth.anatomy;
    if (wishes.gizmo && core::teeth::isGenerated(anatomy)) {
        constexpr double kMiddle = ui::tooth::kGizmoInPx + ui::tooth::kGizmoPx;
        ui::render::paintGizmo(painter, QPointF(kMiddle, kMiddle), ui::tooth::kGizmoPx,
                               glm::dmat3(camera.view()) * anatomy.lying.cutFromOwn(),
                               ui::tooth::gizmoLetters(anatomy.fdi));
    }
    if (wishes.hand && subject.bur) {
        const glm::dvec2 hand = camera.pixelOf(subject.bur->deviceMm);
        const glm::dvec2 bur = camera.pixelOf(subject.bur->anchorMm);
        ui::tooth::paintArrowOut(painter, picture.size(), {bur.x, bur.y}, {hand.x, hand.y});
    }
    if (wishes.look.depthColours != ui::render::DepthColours::Off)
        ui::tooth::paintDepthScale(painter, picture.size(), wishes.look, wishes.presentation);
}

/// Returns the three-dimensional picture of the tooth.
core::Result<QImage> toothPicture(const RenderSubject& subject, const RenderWishes& wishes, const QString& view,
                                  QSize size)
{
    const auto& anatomy = subject.tooth.anatomy;
    if (wishes.neighbours && !core::teeth::standsInTheArch(*anatomy))
        return core::unexpected(core::ErrorCode::UnknownName,
                                "nothing is known of what stands beside '" + anatomy->name +
                                    "'; only a tooth chosen by its FDI number that stands upright has neighbours");
    ui::render::ToothSurface surface(anatomy, ui::tooth::operatingLight(wishes.leftHand));
    surface.write(subject.tooth.top);
    surface.setIdeal(subject.ideal);
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
    if (const core::Status there =
            ui::tooth::goTo(camera, view, core::teeth::isGenerated(*anatomy) ? anatomy->fdi : 0, anatomy->lying);
        !there)
        return tl::unexpected(there.error());
    ui::render::Scene scene = ui::tooth::sceneThrough(camera, glm::vec2(size.width(), size.height()), wishes.leftHand);
    if (subject.bur) {
        scene.instrumentShown = true;
        scene.burIndex = subject.bur->burIndex;
        scene.tipMm = subject.bur->anchorMm;
        scene.surfaceBelowTipMm = surface.topMm(glm::dvec2(scene.tipMm));
        scene.liftMm = ui::tooth::liftMm(surface, scene.burIndex, scene.tipMm);
    }
    scene.look = wishes.look;
    if (wishes.mirror)
        scene.mirror = ui::tooth::mirrorBeside(camera, surface, wishes.leftHand, wishes.neighbours);
    scene.mirrorHandleLeft = !wishes.leftHand;
    if (wishes.hand && subject.bur)
        scene.ghostMm = subject.bur->deviceMm;
    QImage picture = (*canvas)->picture([&] {
        renderer.setSurface(surface);
        if (wishes.neighbours)
            renderer.setNeighbours(core::teeth::Arch().neighbours(anatomy->fdi));
        presenter.draw(renderer, scene, wishes.presentation, camera.distanceMm(), ui::render::Canvas::kSamples);
    });
    if (wishes.presentation.isPlain())
        paintMarks(picture, subject, wishes, camera);
    return picture;
}

}  // namespace

core::Result<QImage> renderedArch(int chosenFdi, QSize size)
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

core::Status savePng(const QImage& picture, const QString& file)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    if (!picture.save(&buffer, "PNG"))
        return core::unexpected(core::ErrorCode::FileUnwritable, "the picture could not be made a PNG");
    return core::writeWhole(file.toStdString(), {bytes.constData(), static_cast<std::size_t>(bytes.size())},
                            "The picture");
}

core::Result<QImage> rendered(const RenderSubject& subject, const RenderWishes& wishes, const QString& view, QSize size)
{
    switch (wishes.kind) {
    case Picture::Section:
        return sectionPicture(subject, wishes.sectionDeg, size, wishes.look.palette);
    case Picture::Xray:
        return xrayPicture(subject.tooth, wishes, size);
    case Picture::Bitewing:
        return bitewingPicture(subject.tooth, wishes, size);
    default:
        return toothPicture(subject, wishes, view, size);
    }
}

}  // namespace cli
