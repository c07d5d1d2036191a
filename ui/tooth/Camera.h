// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/session/Sight.h"
#include "core/tracking/Lean.h"
#include "ui/render/ToothSurface.h"

namespace ui::tooth {

inline constexpr double kAtOnceS = 10.0;  ///< Time after which every animation has ended.

/// An upright camera on a sphere around the point it looks at: from afar the middle of the crown, from nearby the point
/// that was zoomed to. Plain arithmetic, no OpenGL.
///
/// Azimuth 0 looks along +y with +x to the right; it grows as the eye moves towards +x. Elevation is the height of
/// the eye above the horizon.
class Camera
{
public:
    static constexpr double kFieldOfViewDeg = 27.0;  ///< vertical field of view
    static constexpr double kStartAzimuthDeg = 18.0;
    static constexpr double kStartElevationDeg = 48.0;
    static constexpr double kAboveDeg = 80.0;    ///< elevation from which the floor of a cavity is visible
    static constexpr double kLowestDeg = -85.0;  ///< a view from below, which shows a perforation
    static constexpr double kHighestDeg = 88.0;

    /// Sets the sphere that must fit the picture.
    void setSubject(glm::dvec3 centreMm, double radiusMm);
    void setViewport(glm::dvec2 sizePx);

    /// Sets the direction for reset(). Resets the camera if the direction has changed.
    void setStart(double azimuthDeg, double elevationDeg = kStartElevationDeg);
    [[nodiscard]] double startAzimuthDeg() const { return m_startDeg; }
    /// Returns to the start: the whole crown, three quarters from above.
    void reset();
    /// Copies the viewpoint of another camera.
    void lookAs(const Camera& other);
    /// Looks from the student's viewpoint.
    void lookFrom(const core::session::Sight& sight);
    /// Returns the viewpoint, for lookFrom().
    [[nodiscard]] core::session::Sight sight() const;
    /// Looks steeply down at a place from close by, so that no cusp hides it.
    void lookDownAt(glm::dvec3 placeMm);
    void set(double azimuthDeg, double elevationDeg, double distanceMm);
    void turn(double azimuthDeg, double elevationDeg);
    /// Zooms in by `steps` notches of a wheel, or out if negative. advance() animates the zoom. When zooming in,
    /// `towardsMm` stays in place in the picture (empty: the middle of the picture does); when zooming out, the crown
    /// moves back to the middle.
    void zoom(double steps, const std::optional<glm::dvec3>& towardsMm = {});
    /// Zooms by the ratio of the sizes in the picture after and before.
    void zoomBy(double ratio, const std::optional<glm::dvec3>& towardsMm = {});
    /// Sets how far the user's head turns the eye about the axes of the screen, and moves it. The other functions
    /// change the view without the lean.
    void lean(const core::tracking::Lean& lean) { m_lean = lean; }
    [[nodiscard]] const core::tracking::Lean& lean() const { return m_lean; }
    /// Advances the animation of the zoom. Returns true while it still moves.
    bool advance(double seconds);

    // Angles of the eye, including the lean.
    [[nodiscard]] double azimuthDeg() const;
    [[nodiscard]] double elevationDeg() const;
    [[nodiscard]] double distanceMm() const { return m_distanceMm * m_lean.farther; }
    /// Returns the distance at which the subject just fits the viewport, mm.
    [[nodiscard]] double fittingMm() const;

    [[nodiscard]] glm::dvec3 eyeMm() const;
    [[nodiscard]] glm::dmat4 view() const;        ///< eye from tooth
    [[nodiscard]] glm::dmat4 projection() const;  ///< clip from eye
    /// Returns the ray through a point of the viewport, in pixels from its upper left corner.
    [[nodiscard]] render::Ray rayThrough(glm::dvec2 pixel) const;
    /// Returns the pixel at which a point is seen. A point behind the eye is far outside the viewport, on its side.
    [[nodiscard]] glm::dvec2 pixelOf(glm::dvec3 pointMm) const;
    /// Return unit vectors of the tooth's x, y plane that point right and up (away) on the screen.
    [[nodiscard]] glm::dvec2 rightOnTooth() const;
    [[nodiscard]] glm::dvec2 awayOnTooth() const;

private:
    /// Unit vectors that point right and up on the screen, and from the screen to the eye; tooth frame.
    struct Axes
    {
        glm::dvec3 right;
        glm::dvec3 up;
        glm::dvec3 back;
    };
    [[nodiscard]] Axes axes() const;
    void keepInBounds();
    void moveTo(double distanceMm);
    void fit();

    glm::dvec3 m_centreMm{0.0, 0.0, -3.0};
    glm::dvec3 m_lookAtMm = m_centreMm;
    glm::dvec3 m_towardsMm = m_centreMm;  ///< stays in place while the camera zooms in
    double m_radiusMm = 7.0;
    glm::dvec2 m_sizePx{1280.0, 800.0};
    double m_startDeg = kStartAzimuthDeg;
    double m_startHeightDeg = kStartElevationDeg;
    double m_azimuthDeg = kStartAzimuthDeg;
    double m_elevationDeg = kStartElevationDeg;
    double m_distanceMm = 40.0;
    double m_wantedMm = 40.0;
    core::tracking::Lean m_lean;
    bool m_fitted = true;  ///< the distance follows the size of the viewport until the user zooms
};

}  // namespace ui::tooth
