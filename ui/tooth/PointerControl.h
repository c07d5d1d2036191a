// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/servo/ServoState.h"
#include "core/terrain/Tooth.h"
#include "ui/render/ToothSurface.h"

namespace ui::tooth {

/// Turns rays of sight, a button and steps of keys into the input of the pointer device. No widgets, no OpenGL.
///
/// While the button is up, the tip of the bur hovers on the ray, kClearanceMm above the tooth. When the button is
/// pressed, the bur comes down where the ray meets the tooth. After it has touched the tooth, a resting pointer does
/// not move the bur, so the bur goes straight down. A moving pointer moves the bur and reduces the distance between
/// them.
///
/// The depth stop is a horizontal plane at a set depth below the original surface at the first contact. A press inside
/// the cavity keeps the plane, so a cavity that is cut in several presses has one floor.
class PointerControl
{
public:
    static constexpr double kClearanceMm = 0.6;  ///< height of a hovering bur above the tooth
    static constexpr double kLiftMm = 3.0;       ///< height of a lifted bur above the highest cusp

    // Range, default and step of the force. Dentists use 1 N; a mouse gives no feedback, so the default is lower.
    static constexpr double kWeakestN = 0.2;
    static constexpr double kFirstN = 0.6;
    static constexpr double kStrongestN = 3.0;
    static constexpr double kStepN = 0.1;

    // The same for the feed rate. With the default, a user who reacts late cuts at most 0.25 mm too deep.
    static constexpr double kSlowestMmPerS = 0.1;
    static constexpr double kFirstMmPerS = 0.5;
    static constexpr double kFastestMmPerS = 2.0;
    static constexpr double kStepMmPerS = 0.1;

    // The same for the depth of the depth stop.
    static constexpr double kShallowestMm = 0.1;
    static constexpr double kFirstMm = 1.5;
    static constexpr double kDeepestMm = 9.0;
    static constexpr double kStepMm = 0.1;

    /// @param surface  null if there is no tooth; must live until the next call of setSurface()
    void setSurface(const render::ToothSurface* surface);
    void setBurRadius(double radiusMm) { m_burRadiusMm = radiusMm; }
    [[nodiscard]] double burRadiusMm() const { return m_burRadiusMm; }

    /// Sets the ray under the pointer. Call this when the pointer or the view has moved, and once a frame.
    /// @param anchorMm  position of the bur
    void moveTo(const render::Ray& ray, glm::dvec3 anchorMm);
    /// Call this when the view has moved: the next ray then does not move a pressed bur.
    void forgetRay() { m_hasRay = false; }
    /// Applies the newest state of the bur, once per frame. The first contact of a press places the depth stop.
    void follow(const core::servo::ServoState& servo);
    /// Moves the target by a step in the x, y plane of the tooth, for keys.
    void moveBy(glm::dvec2 stepMm);
    void push(bool pushing);
    void lift(bool lifted) { m_lifted = lifted; }
    /// Sets the push force, clamped to kWeakestN .. kStrongestN.
    void setForce(double newtons);
    /// Sets the share of the force that is used, 0 .. 1: the pressure of a pen.
    void setPressure(double share) { m_pressure = share; }
    [[nodiscard]] double forceN() const { return m_forceN; }
    /// Sets the largest speed at which the bur is lowered, clamped to kSlowestMmPerS .. kFastestMmPerS.
    void setFeed(double mmPerS);
    [[nodiscard]] double feedMmPerS() const { return m_feedMmPerS; }
    /// Sets the depth below the original surface, clamped to kShallowestMm .. kDeepestMm.
    void setStopDepth(double depthMm);
    [[nodiscard]] double stopDepthMm() const { return m_stopDepthMm; }
    void setStopOn(bool on) { m_stopIsOn = on; }
    [[nodiscard]] bool isStopOn() const { return m_stopIsOn; }
    /// Returns the height of the stop, tooth frame z. Empty if the stop is off, or if there has been no contact yet.
    [[nodiscard]] std::optional<double> stopMm() const;
    /// Returns the depth of a tip at this height, below the original surface at the contact. Empty before the contact.
    [[nodiscard]] std::optional<double> depthMm(double tipMm) const;
    [[nodiscard]] bool isPushing() const { return m_pushing; }

    /// Returns the input of the pointer device, with heights above the tooth as it is cut now. A bur that does not push
    /// is lifted over the parts of the tooth between it and its target before it moves there.
    /// @param anchorMm  position of the bur; empty: unknown
    [[nodiscard]] core::servo::PointerInput input(std::optional<glm::dvec3> anchorMm = {}) const;
    /// Returns whether a ray meets the occlusal surface, and not the space beside it.
    [[nodiscard]] bool meetsTooth(const render::Ray& ray) const;

private:
    void hoverOn(const render::Ray& ray);
    void setTarget(glm::dvec2 targetMm);

    const render::ToothSurface* m_surface = nullptr;
    double m_burRadiusMm = 0.5;
    glm::dvec2 m_targetMm{0.0};
    double m_hoverMm = core::terrain::kEmptyTop;  ///< height at which the ray passes over the target
    render::Ray m_lastRay;
    bool m_hasRay = false;
    bool m_pushing = false;
    bool m_hasTouched = false;  ///< there has been contact since the button was pressed
    bool m_lifted = false;
    double m_forceN = kFirstN;
    double m_pressure = 1.0;
    double m_feedMmPerS = kFirstMmPerS;
    double m_stopDepthMm = kFirstMm;
    bool m_stopIsOn = false;
    std::optional<double> m_surfaceMm;  ///< height from which the depth is counted, tooth frame z
};

}  // namespace ui::tooth
