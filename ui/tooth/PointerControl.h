// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/session/Links.h"
#include "core/terrain/Tooth.h"
#include "ui/render/ToothSurface.h"

namespace ui::tooth {

/// Turns rays of sight, a button and steps of keys into what the pointer device asks for. No widgets, no OpenGL.
///
/// With the button up, the tip of the bur hovers on the ray, kClearanceMm over the tooth. With the button down it comes
/// down along the ray. Once it has touched, a ray that rests moves nothing, so that a bur is driven in straight; a ray
/// that moves takes the bur along and brings it back under itself.
///
/// The depth stop is a plane: so far below the original surface where the bur has touched it. A press within what has
/// been cut keeps the plane, so that a cavity that is cut in several presses gets one floor.
class PointerControl
{
public:
    static constexpr double kClearanceMm = 0.6;  ///< between the bur and the tooth while not pushing
    static constexpr double kLiftMm = 3.0;       ///< above the highest cusp while lifted
    static constexpr double kWeakestN = 0.2;
    static constexpr double kFirstN =
        0.6;  ///< to begin with: a mouse has no feel, so a little under the 1 N of dentists
    static constexpr double kStrongestN = 3.0;
    static constexpr double kStepN = 0.1;  ///< of wheel, keys and slider

    static constexpr double kSlowestMmPerS = 0.1;  ///< of the feed
    static constexpr double kFirstMmPerS = 0.5;    ///< what a person who reacts after 0.3 s stops within 0.25 mm
    static constexpr double kFastestMmPerS = 2.0;
    static constexpr double kStepMmPerS = 0.1;

    static constexpr double kShallowestMm = 0.1;  ///< of the depth stop
    static constexpr double kFirstMm = 1.5;
    static constexpr double kDeepestMm = 9.0;
    static constexpr double kStepMm = 0.1;

    /// @param surface  null: there is no tooth; else must outlive the next call of setSurface()
    void setSurface(const render::ToothSurface* surface);
    void setBurRadius(double radiusMm) { m_burRadiusMm = radiusMm; }

    /// The pointer is on this ray. Call it when the pointer or the view has moved, and once a frame while `anchorMm`,
    /// where the bur is, may have.
    void moveTo(const render::Ray& ray, glm::dvec3 anchorMm);
    /// The view has turned under a pressed button: the next ray does not move the bur.
    void forgetRay() { m_hasRay = false; }
    /// The newest state of the bur, once a frame: a press takes the depth stop from the first touch.
    void follow(const core::session::ServoState& servo);
    /// Keys: the target moves by a vector of the tooth's x, y plane.
    void moveBy(glm::dvec2 stepMm);
    void push(bool pushing);
    void lift(bool lifted) { m_lifted = lifted; }
    /// How hard to push, kept within kWeakestN .. kStrongestN.
    void setForce(double newtons);
    /// Of the set force, what a pen presses: 0 .. 1.
    void setPressure(double share) { m_pressure = share; }
    [[nodiscard]] double forceN() const { return m_forceN; }
    /// How fast the bur goes down at most, kept within kSlowestMmPerS .. kFastestMmPerS.
    void setFeed(double mmPerS);
    [[nodiscard]] double feedMmPerS() const { return m_feedMmPerS; }
    /// Below the original surface; kept within kShallowestMm .. kDeepestMm.
    void setStopDepth(double depthMm);
    [[nodiscard]] double stopDepthMm() const { return m_stopDepthMm; }
    void setStopOn(bool on) { m_stopIsOn = on; }
    [[nodiscard]] bool isStopOn() const { return m_stopIsOn; }
    /// Height of the stop, tooth frame z. Empty while it is off or no press has touched the tooth yet.
    [[nodiscard]] std::optional<double> stopMm() const;
    /// Of a tip at this height below the original surface where the press has touched it; empty before.
    [[nodiscard]] std::optional<double> depthMm(double tipMm) const;
    [[nodiscard]] bool isPushing() const { return m_pushing; }

    /// The wish as it stands, with the height over the tooth as it now is. Not pushing, the bur is lifted over what
    /// lies between it (`anchorMm`, if there is one) and its target before it goes there.
    [[nodiscard]] core::session::PointerInput input(std::optional<glm::dvec3> anchorMm = {}) const;
    /// True when the ray meets the chewing surface and not the space beside it.
    [[nodiscard]] bool meetsTooth(const render::Ray& ray) const;

private:
    void hoverOn(const render::Ray& ray);
    void setTarget(glm::dvec2 targetMm);

    const render::ToothSurface* m_surface = nullptr;
    double m_burRadiusMm = 0.5;
    glm::dvec2 m_targetMm{0.0};
    double m_hoverMm = core::terrain::kEmptyTop;  ///< on the ray, over the target
    render::Ray m_lastRay;
    bool m_hasRay = false;
    bool m_pushing = false;
    bool m_hasTouched = false;  ///< since the button went down
    bool m_lifted = false;
    double m_forceN = kFirstN;
    double m_pressure = 1.0;
    double m_feedMmPerS = kFirstMmPerS;
    double m_stopDepthMm = kFirstMm;
    bool m_stopIsOn = false;
    std::optional<double> m_surfaceMm;  ///< original surface from which the depth stop counts, tooth frame z
};

}  // namespace ui::tooth
