// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tooth/Camera.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

namespace ui::tooth {
namespace {

constexpr double kLeastDepthMm = 0.01;  ///< least depth of a point that is projected to the screen
constexpr double kPerNotch = 0.88;      ///< factor of the distance after one notch of the wheel
constexpr double kFollowS = 0.07;       ///< time constant of the zoom
constexpr double kClosest = 0.22;       ///< smallest distance, as a share of the fitting distance
constexpr double kFurthest = 2.5;
constexpr double kDownDeg = 75.0;   ///< elevation of an eye that looks down at a place
constexpr double kDownShare = 0.6;  ///< and its distance, as a share of the fitting distance

}  // namespace

void Camera::setSubject(glm::dvec3 centreMm, double radiusMm)
{
    m_centreMm = centreMm;
    m_radiusMm = radiusMm;
    reset();
}

void Camera::setViewport(glm::dvec2 sizePx)
{
    m_sizePx = glm::max(sizePx, glm::dvec2(1.0));
    if (m_fitted)
        fit();
}

void Camera::setStart(double azimuthDeg, double elevationDeg)
{
    if (azimuthDeg == m_startDeg && elevationDeg == m_startHeightDeg)
        return;
    m_startDeg = azimuthDeg;
    m_startHeightDeg = elevationDeg;
    reset();
}

void Camera::reset()
{
    m_azimuthDeg = m_startDeg;
    m_elevationDeg = m_startHeightDeg;
    fit();
}

/// Fits the whole subject into the view and centres it.
void Camera::fit()
{
    m_fitted = true;
    m_lookAtMm = m_centreMm;
    m_distanceMm = m_wantedMm = fittingMm();
}

void Camera::lookAs(const Camera& other)
{
    m_lookAtMm = other.m_lookAtMm;
    m_towardsMm = other.m_towardsMm;
    m_azimuthDeg = other.m_azimuthDeg;
    m_elevationDeg = other.m_elevationDeg;
    m_lean = other.m_lean;
    m_distanceMm = other.m_distanceMm;
    m_wantedMm = other.m_wantedMm;
    m_fitted = false;
}

void Camera::lookFrom(const core::session::Sight& sight)
{
    set(sight.azimuthDeg, sight.elevationDeg, sight.distanceMm);
    m_lookAtMm = m_towardsMm = sight.lookAtMm;
}

core::session::Sight Camera::sight() const
{
    return {azimuthDeg(), elevationDeg(), distanceMm(), m_lookAtMm};
}

double Camera::azimuthDeg() const
{
    const glm::dvec3 back = axes().back;
    return glm::degrees(std::atan2(back.x, -back.y));
}

double Camera::elevationDeg() const
{
    return glm::degrees(std::asin(std::clamp(axes().back.z, -1.0, 1.0)));
}

void Camera::lookDownAt(glm::dvec3 placeMm)
{
    lookFrom({m_startDeg, kDownDeg, kDownShare * fittingMm(), placeMm});
}

void Camera::set(double azimuthDeg, double elevationDeg, double distanceMm)
{
    m_azimuthDeg = azimuthDeg;
    m_elevationDeg = elevationDeg;
    m_wantedMm = distanceMm;
    m_fitted = false;
    keepInBounds();
    m_lookAtMm = m_centreMm;
    m_distanceMm = m_wantedMm;
}

void Camera::turn(double azimuthDeg, double elevationDeg)
{
    m_azimuthDeg += azimuthDeg;
    m_elevationDeg += elevationDeg;
    keepInBounds();
}

void Camera::zoom(double steps, const std::optional<glm::dvec3>& towardsMm)
{
    zoomBy(1.0 / std::pow(kPerNotch, steps), towardsMm);
}

void Camera::zoomBy(double ratio, const std::optional<glm::dvec3>& towardsMm)
{
    m_towardsMm = towardsMm.value_or(m_lookAtMm);
    m_wantedMm /= ratio;
    m_fitted = false;
    keepInBounds();
}

bool Camera::advance(double seconds)
{
    if (m_distanceMm == m_wantedMm)
        return false;
    moveTo(m_distanceMm + (m_wantedMm - m_distanceMm) * (1.0 - std::exp(-seconds / kFollowS)));
    if (std::abs(m_distanceMm - m_wantedMm) < 0.002 * m_wantedMm)
        moveTo(m_wantedMm);
    return true;
}

void Camera::moveTo(double distanceMm)
{
    if (distanceMm < m_distanceMm) {
        m_lookAtMm = glm::mix(m_towardsMm, m_lookAtMm, distanceMm / m_distanceMm);
    } else {
        // Moves back towards the centre, and reaches it at the latest where the whole subject fits.
        const double before = fittingMm() - m_distanceMm;
        const double after = fittingMm() - distanceMm;
        m_lookAtMm = after > 0.0 ? glm::mix(m_centreMm, m_lookAtMm, after / before) : m_centreMm;
    }
    m_distanceMm = distanceMm;
}

void Camera::keepInBounds()
{
    m_azimuthDeg = std::remainder(m_azimuthDeg, 360.0);
    m_elevationDeg = std::clamp(m_elevationDeg, kLowestDeg, kHighestDeg);
    m_wantedMm = std::clamp(m_wantedMm, kClosest * fittingMm(), kFurthest * fittingMm());
}

double Camera::fittingMm() const
{
    const double vertical = std::tan(glm::radians(kFieldOfViewDeg) / 2.0);
    const double narrower = vertical * std::min(1.0, m_sizePx.x / m_sizePx.y);
    return m_radiusMm / std::sin(std::atan(narrower));
}

/// Returns the camera's axes, rotated by the lean as if the user's head moved around a fixed tooth.
Camera::Axes Camera::axes() const
{
    const double azimuth = glm::radians(m_azimuthDeg);
    const double elevation = glm::radians(m_elevationDeg);
    const glm::dvec3 right(std::cos(azimuth), std::sin(azimuth), 0.0);
    const glm::dvec3 back(std::sin(azimuth) * std::cos(elevation), -std::cos(azimuth) * std::cos(elevation),
                          std::sin(elevation));
    const double yaw = glm::radians(m_lean.yawDeg);
    const double pitch = glm::radians(m_lean.pitchDeg);
    const glm::dvec3 up = glm::cross(back, right);
    const glm::dvec3 aside = std::cos(yaw) * back + std::sin(yaw) * right;
    return {std::cos(yaw) * right - std::sin(yaw) * back, std::cos(pitch) * up - std::sin(pitch) * aside,
            std::cos(pitch) * aside + std::sin(pitch) * up};
}

glm::dvec3 Camera::eyeMm() const
{
    const Axes screen = axes();
    return m_lookAtMm + distanceMm() * (screen.back + m_lean.rightShare * screen.right + m_lean.upShare * screen.up);
}

glm::dmat4 Camera::view() const
{
    const Axes screen = axes();
    const glm::dvec3 eye = eyeMm();
    return glm::lookAt(eye, eye - screen.back, screen.up);
}

glm::dmat4 Camera::projection() const
{
    const double nearMm = 0.1 * distanceMm();
    const double high = std::tan(glm::radians(kFieldOfViewDeg) / 2.0);
    const double wide = high * m_sizePx.x / m_sizePx.y;
    return glm::frustum(nearMm * (-wide - m_lean.rightShare), nearMm * (wide - m_lean.rightShare),
                        nearMm * (-high - m_lean.upShare), nearMm * (high - m_lean.upShare), nearMm,
                        distanceMm() + 200.0);
}

render::Ray Camera::rayThrough(glm::dvec2 pixel) const
{
    const double high = std::tan(glm::radians(kFieldOfViewDeg) / 2.0);
    const double right = (2.0 * pixel.x / m_sizePx.x - 1.0) * high * m_sizePx.x / m_sizePx.y;
    const double up = (1.0 - 2.0 * pixel.y / m_sizePx.y) * high;
    const Axes screen = axes();
    const glm::dvec3 eye = eyeMm();
    // The middle of the screen shows the point that the camera looks at.
    const glm::dvec3 onScreen = m_lookAtMm + distanceMm() * (right * screen.right + up * screen.up);
    return {eye, glm::normalize(onScreen - eye)};
}

glm::dvec2 Camera::pixelOf(glm::dvec3 pointMm) const
{
    const glm::dvec4 clip = projection() * view() * glm::dvec4(pointMm, 1.0);
    const double depth = std::max(clip.w, kLeastDepthMm);
    return {0.5 * (1.0 + clip.x / depth) * m_sizePx.x, 0.5 * (1.0 - clip.y / depth) * m_sizePx.y};
}

glm::dvec2 Camera::rightOnTooth() const
{
    return glm::normalize(glm::dvec2(axes().right));
}

glm::dvec2 Camera::awayOnTooth() const
{
    const glm::dvec2 right = rightOnTooth();
    return {-right.y, right.x};
}

}  // namespace ui::tooth
