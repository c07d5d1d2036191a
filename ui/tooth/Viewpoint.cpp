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
constexpr double kLaidStartDeg = 55.0;  ///< elevation from which a tooth that lies on a side is looked at first
// The handpiece leans aside when the eye looks from above.
constexpr double kUprightBelowDeg = 25.0;  ///< elevation of the eye up to which it is upright
constexpr double kLeansMostDeg = 75.0;     ///< elevation from which it leans by kMostLeanDeg
constexpr double kMostLeanDeg = 58.0;
constexpr double kHandleComesDeg = 40.0;  ///< angle by which the handle then has turned towards the viewer
constexpr double kShankClearMm = 0.9;     ///< around the bur's axis, what the shank must clear
// Where the dental mirror is taken in hand.
constexpr double kMirrorBehind = 0.9;  ///< the middle of the crown, of its radius
constexpr double kMirrorSeen = 0.55;   ///< of its radius, on the outer side
constexpr double kBehindTheRowMm = 6.0;
constexpr double kOverTheMiddleMm = 1.0;
constexpr double kMirrorAbove = 0.22;  ///< the middle of the view, of half its height
constexpr double kHandClearMm = 5.5;   ///< and the head of the handpiece with its neck

struct Named
{
    const char* name;
    double azimuthDeg;
    double elevationDeg;
    bool isOfMouth;  ///< known only where the tooth is
};

/// For a lower tooth: its +y is lingual, that of an upper one buccal. In the order of render::GizmoLetters: -x, +x, -y,
/// +y, -z, +z.
constexpr std::array<Named, 6> kNamed{{{"mesial", -90.0, kSideElevationDeg, true},
                                       {"distal", 90.0, kSideElevationDeg, true},
                                       {"buccal", 0.0, kSideElevationDeg, true},
                                       {"lingual", 180.0, kSideElevationDeg, true},
                                       {"below", 0.0, Camera::kLowestDeg, false},
                                       {"occlusal", 0.0, Camera::kHighestDeg, false}}};

/// Looks at the whole tooth from a direction that is named in the tooth's own frame.
void lookFromSide(Camera& camera, double azimuthDeg, double elevationDeg, const core::terrain::Lying& lying)
{
    camera.reset();
    if (!lying.isUpright()) {
        // The axis that was named, and from the side a little from above, as of an upright tooth.
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

/// Returns how many columns of an open lesion the camera sees.
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
    // The handpiece turns with the view, so that the handle stays at the same side of the picture. The more the eye
    // looks down along the bur, the more the handpiece leans aside, as a pen does, and the handle comes towards the
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
    // Slightly tighter than the ball: the tooth is the hero, and a crown does not fill its corners.
    camera.setSubject(surface.crownMiddleMm(), 0.93 * surface.crownRadiusMm());
    // What is to be cut of a tooth that lies on a side is seen along the bur.
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
    // Behind the crown and to the side, so far that a little of its disc is outside the view and the rest beside the
    // tooth.
    const glm::dmat4 eyeFromTooth = camera.view();
    const glm::dmat4 projection = camera.projection();
    const double depth = -(eyeFromTooth * glm::dvec4(middle, 1.0)).z + kMirrorBehind * radius;
    const double wide = depth / projection[0][0];
    const double high = depth / projection[1][1];
    const double aside = std::max(wide - kMirrorSeen * render::DentalMirror::kRadiusMm, 0.6 * wide);
    const glm::dvec4 inEye(leftHanded ? aside : -aside, kMirrorAbove * high, -depth, 1.0);
    mirror.centreMm = glm::dvec3(glm::inverse(eyeFromTooth) * inEye);
    // Half way between where the eye is and what it wants to see: the crown from behind.
    const auto aim = [&] {
        const glm::dvec3 towardsEye = glm::normalize(camera.eyeMm() - mirror.centreMm);
        const glm::dvec3 towardsCrown = glm::normalize(middle + glm::dvec3(0.0, 0.0, 0.2 * radius) - mirror.centreMm);
        mirror.normal = glm::normalize(towardsEye + towardsCrown);
    };
    aim();
    if (amongNeighbours) {
        // Beside the tooth stands another: behind the row, towards its far side.
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
