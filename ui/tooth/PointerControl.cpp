// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tooth/PointerControl.h"

#include <algorithm>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace ui::tooth {
namespace {

constexpr double kRoamMm = 5.0;  ///< how far beside the tooth the bur may go

}  // namespace

void PointerControl::setSurface(const render::ToothSurface* surface)
{
    m_surface = surface;
    m_hasRay = false;
    m_pushing = false;
    setTarget(m_targetMm);
}

void PointerControl::moveTo(const render::Ray& ray, glm::dvec3 anchorMm)
{
    glm::dvec3 now;
    if (m_pushing) {
        glm::dvec3 before;
        if (m_hasRay && render::ToothSurface::meetPlane(m_lastRay, anchorMm.z, before) &&
            render::ToothSurface::meetPlane(ray, anchorMm.z, now)) {
            // On a leash: what a wall holds up must answer at once when the hand turns back.
            const glm::dvec2 ahead = m_targetMm + glm::dvec2(now - before) - glm::dvec2(anchorMm);
            const double length = glm::length(ahead);
            setTarget(glm::dvec2(anchorMm) + (length > kLeashMm ? ahead * (kLeashMm / length) : ahead));
        }
    } else if (m_surface != nullptr && m_surface->meet(ray, now)) {
        setTarget(glm::dvec2(now));
    }
    m_lastRay = ray;
    m_hasRay = true;
}

void PointerControl::moveBy(glm::dvec2 stepMm)
{
    setTarget(m_targetMm + stepMm);
}

void PointerControl::push(bool pushing)
{
    m_pushing = pushing;
    m_pressure = 1.0;
}

void PointerControl::setForce(double newtons)
{
    m_forceN = std::clamp(newtons, kWeakestN, kStrongestN);
}

core::session::PointerInput PointerControl::input(std::optional<glm::dvec3> anchorMm) const
{
    core::session::PointerInput wish;
    wish.targetMm = m_targetMm;
    wish.pushing = m_pushing && !m_lifted;
    wish.pushForceN = m_forceN * m_pressure;
    if (m_surface == nullptr)
        return wish;
    if (m_lifted) {
        wish.hoverMm = m_surface->highestMm().z + kLiftMm;
        return wish;
    }
    const glm::dvec2 from = anchorMm ? glm::dvec2(*anchorMm) : m_targetMm;
    const double highest = m_surface->highestBetweenMm(from, m_targetMm, m_burRadiusMm);
    wish.hoverMm = highest + kClearanceMm;
    // Straight out of a cavity the bur would cut through its wall.
    if (!wish.pushing && anchorMm && anchorMm->z < highest)
        wish.targetMm = from;
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
