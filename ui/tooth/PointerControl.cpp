// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tooth/PointerControl.h"

#include <algorithm>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace ui::tooth {
namespace {

constexpr double kRoamMm = 5.0;     ///< distance that the bur may move beside the tooth
constexpr double kMarchMm = 0.04;   ///< step of the search for a hovering height
constexpr double kRecoverMm = 1.5;  ///< pointer travel after which the bur is under the pointer again
constexpr double kUncutMm = 0.05;   ///< a place cut less deep counts as uncut
constexpr double kThereMm = 0.05;   ///< a bur within this distance counts as under the pointer
constexpr double kJumpMm = 0.5;     ///< longest move for which the bur is not lifted over the tooth

}  // namespace

void PointerControl::setSurface(const render::ToothSurface* surface)
{
    m_surface = surface;
    m_hasRay = false;
    m_pushing = false;
    m_surfaceMm.reset();
    m_hoverMm = core::terrain::kEmptyTop;
    setTarget(m_targetMm);
}

/// Moves the target along the ray, from the tooth towards the eye, to the first place where kClearanceMm are free below
/// the bur.
void PointerControl::hoverOn(const render::Ray& ray)
{
    glm::dvec3 place;
    if (m_surface == nullptr || !m_surface->meet(ray, place))
        return;
    const glm::dvec3 up = ray.direction * (kMarchMm / std::min(ray.direction.z, -0.02));
    const double highest = m_surface->highestMm().z + kClearanceMm;
    const auto lacksMm = [&] {
        return m_surface->highestWithinMm(glm::dvec2(place), m_burRadiusMm) + kClearanceMm - place.z;
    };
    for (double lacks = lacksMm(); lacks > 0.0 && place.z < highest; lacks = lacksMm())
        place += up * std::max(1.0, 0.25 * lacks / kMarchMm);
    setTarget(glm::dvec2(place));
    m_hoverMm = place.z;
}

void PointerControl::moveTo(const render::Ray& ray, glm::dvec3 anchorMm)
{
    glm::dvec3 now;
    glm::dvec3 before;
    if (!m_pushing) {
        hoverOn(ray);
    } else if (!m_hasTouched) {
        if (m_surface != nullptr && m_surface->meet(ray, now))
            setTarget(glm::dvec2(now));
    } else if (m_hasRay && render::ToothSurface::meetPlane(ray, anchorMm.z, now) &&
               render::ToothSurface::meetPlane(m_lastRay, anchorMm.z, before)) {
        const glm::dvec2 by(now - before);
        setTarget(glm::mix(m_targetMm + by, glm::dvec2(now), std::min(1.0, glm::length(by) / kRecoverMm)));
    }
    m_lastRay = ray;
    m_hasRay = true;
}

void PointerControl::follow(const core::servo::ServoState& servo)
{
    if (!m_pushing || !servo.touching || m_hasTouched)
        return;
    m_hasTouched = true;
    if (m_surfaceMm && servo.hasDepth && servo.depthMm >= kUncutMm)
        return;
    // The tip of a bur that touches a wall may still be above the surface.
    m_surfaceMm = servo.anchorMm.z;
    if (servo.hasDepth && m_surface != nullptr)
        *m_surfaceMm += m_surface->belowUncutMm(servo.anchorMm);
}

std::optional<double> PointerControl::depthMm(double tipMm) const
{
    // Until contact it is unknown whether this press continues in the plane of the previous one.
    if (!m_surfaceMm || !m_hasTouched)
        return std::nullopt;
    return std::max(0.0, *m_surfaceMm - tipMm);
}

std::optional<double> PointerControl::stopMm() const
{
    if (!m_stopIsOn || !m_surfaceMm || (m_pushing && !m_hasTouched))
        return std::nullopt;
    return *m_surfaceMm - m_stopDepthMm;
}

void PointerControl::moveBy(glm::dvec2 stepMm)
{
    setTarget(m_targetMm + stepMm);
    m_hoverMm = core::terrain::kEmptyTop;
    m_hasRay = false;
}

void PointerControl::push(bool pushing)
{
    if (pushing != m_pushing)
        m_hasTouched = false;
    m_pushing = pushing;
    m_pressure = 1.0;
}

void PointerControl::setForce(double newtons)
{
    m_forceN = std::clamp(newtons, kWeakestN, kStrongestN);
}

void PointerControl::setFeed(double mmPerS)
{
    m_feedMmPerS = std::clamp(mmPerS, kSlowestMmPerS, kFastestMmPerS);
}

void PointerControl::setStopDepth(double depthMm)
{
    m_stopDepthMm = std::clamp(depthMm, kShallowestMm, kDeepestMm);
}

core::servo::PointerInput PointerControl::input(std::optional<glm::dvec3> anchorMm) const
{
    core::servo::PointerInput wish;
    wish.targetMm = m_targetMm;
    // The bur is lowered only after it has arrived under the pointer.
    const bool isThere = m_hasTouched || !anchorMm || glm::distance(glm::dvec2(*anchorMm), m_targetMm) < kThereMm;
    wish.pushing = m_pushing && !m_lifted && isThere;
    wish.pushForceN = m_forceN * m_pressure;
    wish.feedMmPerS = m_feedMmPerS;
    wish.buttonIsPedal = true;
    if (const std::optional<double> stop = stopMm())
        wish.stopMm = *stop;
    if (m_surface == nullptr)
        return wish;
    if (m_lifted) {
        wish.hoverMm = m_surface->highestMm().z + kLiftMm;
        return wish;
    }
    glm::dvec2 from = anchorMm ? glm::dvec2(*anchorMm) : m_targetMm;
    if (glm::distance(from, m_targetMm) < kJumpMm)
        from = m_targetMm;
    const double highest = m_surface->highestBetweenMm(from, m_targetMm, m_burRadiusMm);
    wish.hoverMm = std::max(highest + kClearanceMm, m_hoverMm);
    // A bur inside a cavity moves up first. On a straight path to the target it would cut through the wall.
    if (!wish.pushing && anchorMm && anchorMm->z < highest)
        wish.targetMm = glm::dvec2(*anchorMm);
    return wish;
}

bool PointerControl::meetsTooth(const render::Ray& ray) const
{
    return m_surface != nullptr && m_surface->meetTooth(ray).has_value();
}

void PointerControl::setTarget(glm::dvec2 targetMm)
{
    m_targetMm = targetMm;
    if (m_surface != nullptr)
        m_targetMm = glm::clamp(targetMm, glm::dvec2(m_surface->lowestMm()) - kRoamMm,
                                glm::dvec2(m_surface->highestMm()) + kRoamMm);
}

}  // namespace ui::tooth
