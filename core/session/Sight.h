// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include <glm/vec3.hpp>

namespace core::session {

/// A student's viewpoint. Recorded as a note (AddNote), so that a replay can show what they saw.
struct Sight
{
    double azimuthDeg = 0.0;    ///< -180 .. 180, as in ui::tooth::Camera
    double elevationDeg = 0.0;  ///< -90 .. 90
    double distanceMm = 0.0;    ///< from the eye to lookAtMm, 0 .. 204
    glm::dvec3 lookAtMm{0.0};   ///< tooth frame; x and y within 12.7 mm, z within -25 .. 6
    bool operator==(const Sight&) const = default;
};

/// Packs a sight into a note: angles to 0.1 degrees, lengths to 0.25 mm. Values outside the ranges are clamped.
[[nodiscard]] std::uint64_t sightNote(const Sight& sight);

/// Returns the sight in a note. Empty if the note is about something else.
[[nodiscard]] std::optional<Sight> sightOf(std::uint64_t note);

}  // namespace core::session
