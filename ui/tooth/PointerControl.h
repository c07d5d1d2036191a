// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/session/Links.h"
#include "ui/render/ToothSurface.h"

namespace ui::tooth {

/// Turns rays of sight, a button and steps of keys into what the pointer device asks for. No widgets, no OpenGL.
///
/// With the button up the target is where the ray meets the tooth. With the button down it moves by what the ray
/// moves in the plane at the height of the bur: it neither leaps when the button goes down, nor when the ray passes
/// over the wall of a cavity.
class PointerControl
{
public:
    static constexpr double kClearanceMm = 0.6;  ///< between the bur and the tooth while not pushing
    static constexpr double kLiftMm = 3.0;       ///< above the highest cusp while lifted
    static constexpr double kLeashMm = 2.5;      ///< how far ahead of a pushed bur the target may go
    static constexpr double kWeakestN = 0.2;
    static constexpr double kFirstN =
        0.6;  ///< to begin with: a mouse has no feel, so a little under the 1 N of dentists
    static constexpr double kStrongestN = 3.0;
    static constexpr double kStepN = 0.1;  ///< of wheel, keys and slider

    /// @param surface  null: there is no tooth; else must outlive the next call of setSurface()
    void setSurface(const render::ToothSurface* surface);
    void setBurRadius(double radiusMm) { m_burRadiusMm = radiusMm; }

    /// The pointer moved. While pushing, `anchorMm` is where the bur is.
    void moveTo(const render::Ray& ray, glm::dvec3 anchorMm);
    /// Keys: the target moves by a vector of the tooth's x, y plane.
    void moveBy(glm::dvec2 stepMm);
    void push(bool pushing);
    void lift(bool lifted) { m_lifted = lifted; }
    /// How hard to push, kept within kWeakestN .. kStrongestN.
    void setForce(double newtons);
    /// Of the set force, what a pen presses: 0 .. 1.
    void setPressure(double share) { m_pressure = share; }
    [[nodiscard]] double forceN() const { return m_forceN; }

    /// The wish as it stands, with the height over the tooth as it now is. Not pushing, the bur is lifted over what
    /// lies between it (`anchorMm`, if there is one) and its target before it goes there.
    [[nodiscard]] core::session::PointerInput input(std::optional<glm::dvec3> anchorMm = {}) const;
    /// True when the ray meets the chewing surface and not the space beside it.
    [[nodiscard]] bool meetsTooth(const render::Ray& ray) const;

private:
    void setTarget(glm::dvec2 targetMm);

    const render::ToothSurface* m_surface = nullptr;
    double m_burRadiusMm = 0.5;
    glm::dvec2 m_targetMm{0.0};
    render::Ray m_lastRay;
    bool m_hasRay = false;
    bool m_pushing = false;
    bool m_lifted = false;
    double m_forceN = kFirstN;
    double m_pressure = 1.0;
};

}  // namespace ui::tooth
