// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tooth/Viewpoint.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "core/bur/Bur.h"

namespace ui::tooth {
namespace {

constexpr double kSideElevationDeg = 12.0;
constexpr double kLaidStartDeg = 55.0;  ///< initial elevation for a tooth that lies on its side
// The handpiece leans to the side when the eye looks from above.
constexpr double kUprightBelowDeg = 25.0;  ///< elevation of the eye up to which the handpiece is upright
constexpr double kLeansMostDeg = 75.0;     ///< elevation from which it leans by kMostLeanDeg
constexpr double kMostLeanDeg = 58.0;
constexpr double kHandleComesDeg = 40.0;  ///< angle by which the handle has then turned towards the viewer
constexpr double kShankClearMm = 0.9;     ///< distance around the bur's axis that the shank keeps free
// Initial position of the dental mirror.
constexpr double kMirrorBehind = 0.9;  ///< distance behind the middle of the crown, in radii of the crown
constexpr double kMirrorSeen = 0.55;   ///< share of the mirror's radius between its middle and the edge of the view
constexpr double kBehindTheRowMm = 6.0;
constexpr double kOverTheMiddleMm = 1.0;
constexpr double kMirrorAbove = 0.22;  ///< height above the middle of the view, as a share of half its height
constexpr double kHandClearMm = 5.5;   ///< distance between the mirror and the handpiece's head and neck

struct Named
{
    const char* name;
    double azimuthDeg;
    double elevationDeg;
    bool isOfMouth;  ///< the direction is known only if the position of the tooth in the mouth is
};

/// Directions of a lower tooth, whose +y is lingual; +y of an upper tooth is buccal. In the order of
/// render::GizmoLetters: -x, +x, -y, +y, -z, +z.
constexpr std::array<Named, 6> kNamed{{{"mesial", -90.0, kSideElevationDeg, true},
                                       {"distal", 90.0, kSideElevationDeg, true},
                                       {"buccal", 0.0, kSideElevationDeg, true},
                                       {"lingual", 180.0, kSideElevationDeg, true},
                                       {"below", 0.0, Camera::kLowestDeg, false},
                                       {"occlusal", 0.0, Camera::kHighestDeg, false}}};

/// Looks at the whole tooth from a direction given in the tooth's own frame.
void lookFromSide(Camera& camera, double azimuthDeg, double elevationDeg, const core::terrain::Lying& lying)
{
    camera.reset();
    if (!lying.isUpright()) {
        // Looks along the given axis; from the side a little from above, as at an upright tooth.
        const bool isAside = elevationDeg == kSideElevationDeg;
        const double azimuth = glm::radians(azimuthDeg);
        const glm::dvec3 own = isAside ? glm::dvec3(std::sin(azimuth), -std::cos(azimuth), 0.0)
                                       : glm::dvec3(0.0, 0.0, elevationDeg > 0.0 ? 1.0 : -1.0);
        const glm::dvec3 towardsEye = lying.cutFromOwn() * own;
        const double height = glm::degrees(std::asin(std::clamp(towardsEye.z, -1.0, 1.0)));
        const bool isUpOrDown = std::abs(height) > Camera::kHighestDeg;
        azimuthDeg = isUpOrDown ? Camera::kStartAzimuthDeg : glm::degrees(std::atan2(towardsEye.x, -towardsEye.y));
        elevationDeg =
            std::clamp(isUpOrDown ? height : height + kSideElevationDeg, Camera::kLowestDeg, Camera::kHighestDeg);
    }
    camera.set(azimuthDeg, elevationDeg, camera.fittingMm());
}

bool isUpper(int fdi)
{
    return fdi < 30;
}

/// Returns the number of columns of an open lesion that the camera sees.
int lesionColumnsSeen(const render::ToothSurface& surface, const Camera& camera)
{
    constexpr double kSameMm = 0.2;
    const core::terrain::ToothAnatomy& anatomy = surface.anatomy();
    const core::terrain::Grid& grid = anatomy.grid;
    int seen = 0;
    for (int j = 0; j < grid.side; ++j) {
        for (int i = 0; i < grid.side; ++i) {
            const std::size_t k = grid.index(i, j);
            const core::terrain::ColumnLayers& layers = anatomy.layers[k];
            if (layers.cariesFloor >= layers.cariesRoof || layers.cariesRoof < anatomy.top[k])
                continue;
            const glm::dvec3 point(grid.nodeMm(i, j), anatomy.top[k]);
            const auto met = surface.meetTooth(camera.rayThrough(camera.pixelOf(point)));
            if (met && glm::length(*met - point) < kSameMm)
                ++seen;
        }
    }
    return seen;
}

double startAzimuthDeg(const render::ToothSurface& surface, Camera camera)
{
    constexpr double kFront = Camera::kStartAzimuthDeg;
    constexpr double kBehind = kFront + 180.0;
    camera.setStart(kFront);
    camera.reset();
    const int front = lesionColumnsSeen(surface, camera);
    camera.setStart(kBehind);
    return lesionColumnsSeen(surface, camera) > 3 * front ? kBehind : kFront;
}

}  // namespace

glm::vec3 operatingLight(bool leftHanded)
{
    const glm::vec3 light = glm::normalize(glm::vec3(-0.45F, 0.22F, 0.87F));
    return leftHanded ? glm::vec3(-light.x, light.y, light.z) : light;
}

render::Scene sceneThrough(const Camera& camera, glm::vec2 sizePx, bool leftHanded)
{
    render::Scene scene;
    scene.eyeFromTooth = camera.view();
    scene.clipFromEye = camera.projection();
    scene.eyeMm = camera.eyeMm();
    scene.towardsLight = operatingLight(leftHanded);
    scene.sizePx = sizePx;
    // The handpiece turns with the view, so that its handle stays at the same side of the picture. The more the eye
    // looks down along the bur, the more the handpiece leans to the side like a pen, and the handle turns towards the
    // viewer.
    const double fromAbove = glm::smoothstep(kUprightBelowDeg, kLeansMostDeg, camera.elevationDeg());
    const double side = leftHanded ? -1.0 : 1.0;
    const double handleDeg = (leftHanded ? 180.0 : 0.0) - side * (20.0 + kHandleComesDeg * fromAbove);
    const glm::dvec2 right = camera.rightOnTooth();
    const double rightRad = std::atan2(right.y, right.x);
    scene.handAzimuthRad = rightRad + glm::radians(handleDeg);
    scene.leanAzimuthRad = rightRad + glm::radians(handleDeg + side * 90.0);
    scene.leanRad = glm::radians(kMostLeanDeg * fromAbove);
    return scene;
}

void showWhole(Camera& camera, const render::ToothSurface& surface)
{
    // Slightly tighter than the bounding ball, because a crown does not fill the ball's corners.
    camera.setSubject(surface.crownMiddleMm(), 0.93 * surface.crownRadiusMm());
    // The cutting site of a tooth that lies on its side is viewed along the bur.
    if (surface.anatomy().lying.isUpright())
        camera.setStart(startAzimuthDeg(surface, camera));
    else
        camera.setStart(Camera::kStartAzimuthDeg, kLaidStartDeg);
}

double liftMm(const render::ToothSurface& surface, std::size_t burIndex, const glm::dvec3& tipMm)
{
    if (burIndex >= core::bur::burs().size())
        return 0.0;
    const glm::dvec2 at(tipMm);
    const double shank = tipMm.z + core::bur::burs()[burIndex].headLengthMm + render::kNeckMm;
    const double chuck = tipMm.z + core::bur::kChuckMm;
    const double lift =
        std::max(surface.highestWithinMm(at, kShankClearMm) - shank, surface.highestWithinMm(at, kHandClearMm) - chuck);
    return std::clamp(lift, 0.0, render::kMostLiftMm);
}

render::DentalMirror mirrorBeside(const Camera& camera, const render::ToothSurface& surface, bool leftHanded,
                                  bool amongNeighbours)
{
    render::DentalMirror mirror;
    const glm::dvec3 middle = surface.crownMiddleMm();
    const double radius = surface.crownRadiusMm();
    // Behind the crown and to the side, so far that a part of the mirror is outside the view and the rest is beside the
    // tooth.
    const glm::dmat4 eyeFromTooth = camera.view();
    const glm::dmat4 projection = camera.projection();
    const double depth = -(eyeFromTooth * glm::dvec4(middle, 1.0)).z + kMirrorBehind * radius;
    const double wide = depth / projection[0][0];
    const double high = depth / projection[1][1];
    const double aside = std::max(wide - kMirrorSeen * render::DentalMirror::kRadiusMm, 0.6 * wide);
    const glm::dvec4 inEye(leftHanded ? aside : -aside, kMirrorAbove * high, -depth, 1.0);
    mirror.centreMm = glm::dvec3(glm::inverse(eyeFromTooth) * inEye);
    // The normal bisects the directions to the eye and to the crown, so the mirror shows the crown from behind.
    const auto aim = [&] {
        const glm::dvec3 towardsEye = glm::normalize(camera.eyeMm() - mirror.centreMm);
        const glm::dvec3 towardsCrown = glm::normalize(middle + glm::dvec3(0.0, 0.0, 0.2 * radius) - mirror.centreMm);
        mirror.normal = glm::normalize(towardsEye + towardsCrown);
    };
    aim();
    if (amongNeighbours) {
        // Another tooth is beside this one, so the mirror is behind the row, towards the side away from the eye.
        const double farSide = camera.eyeMm().y < middle.y ? 1.0 : -1.0;
        const double halfDepth = 0.5 * (surface.highestMm().y - surface.lowestMm().y);
        mirror.centreMm = middle + glm::dvec3(0.0, farSide * (halfDepth + kBehindTheRowMm), kOverTheMiddleMm);
        aim();
    }
    return mirror;
}

QStringList viewpointNames()
{
    QStringList names{QStringLiteral("start"), QStringLiteral("above")};
    for (const Named& named : kNamed)
        names << QLatin1String(named.name);
    return names;
}

core::Status goTo(Camera& camera, const QString& viewpoint, int fdi, const core::terrain::Lying& lying)
{
    if (viewpoint == u"start") {
        camera.reset();
        return {};
    }
    if (viewpoint == u"above") {
        lookFromSide(camera, 0.0, Camera::kHighestDeg, {});
        return {};
    }
    for (const Named& named : kNamed) {
        if (viewpoint != QLatin1String(named.name))
            continue;
        if (named.isOfMouth && fdi == 0)
            return core::unexpected(core::ErrorCode::UnknownName,
                                    "nothing says which side of this tooth is " + viewpoint.toStdString() +
                                        "; give --view as start, above, occlusal, below or AZ,EL,DIST");
        const bool turned = named.isOfMouth && isUpper(fdi) && std::abs(named.azimuthDeg) != 90.0;
        lookFromSide(camera, named.azimuthDeg + (turned ? 180.0 : 0.0), named.elevationDeg, lying);
        return {};
    }
    const QStringList parts = viewpoint.split(u',');
    std::array<double, 3> values{};
    bool good = parts.size() == 3;
    for (int k = 0; good && k < 3; ++k)
        values[static_cast<std::size_t>(k)] = parts[k].toDouble(&good);
    if (!good || !(std::abs(values[0]) <= 360.0 && std::abs(values[1]) <= 90.0 && values[2] > 0.0 && values[2] < 1.0e4))
        return core::unexpected(core::ErrorCode::UnknownName, "a viewpoint is one of " +
                                                                  viewpointNames().join(u", ").toStdString() +
                                                                  " or AZ,EL,DIST in degrees, degrees and mm");
    camera.set(values[0], values[1], values[2]);
    return {};
}

void lookFromEnd(Camera& camera, std::size_t end, const core::terrain::Lying& lying)
{
    lookFromSide(camera, kNamed.at(end).azimuthDeg, kNamed.at(end).elevationDeg, lying);
}

}  // namespace ui::tooth
