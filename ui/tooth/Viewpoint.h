// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/terrain/Lying.h"
#include "ui/render/ToothRenderer.h"
#include "ui/tooth/Camera.h"

#include <QString>
#include <QStringList>

namespace ui::tooth {

/// Returns the base scene of every picture of a tooth: seen through this camera under the operating light, without
/// instrument.
/// @param sizePx  size of the picture, device pixels
[[nodiscard]] render::Scene sceneThrough(const Camera& camera, glm::vec2 sizePx, bool leftHanded);

/// Returns the unit vector to the operating light, tooth frame: from behind, over the shoulder opposite the handpiece,
/// so that the shadows of fissures point towards the eye.
[[nodiscard]] glm::vec3 operatingLight(bool leftHanded);

/// Fits the camera to a tooth from its first viewpoint: from behind if the lesion is visible only there, as on lower
/// incisors.
void showWhole(Camera& camera, const render::ToothSurface& surface);

/// Returns how far shank and handpiece must be raised to clear the tooth, mm.
[[nodiscard]] double liftMm(const render::ToothSurface& surface, std::size_t burIndex, const glm::dvec3& tipMm);

/// Returns the initial place of the dental mirror: beside the tooth on the far side, on the side of the other hand, so
/// that it shows what the eye cannot see. With adjacent teeth the mirror is behind the row.
[[nodiscard]] render::DentalMirror mirrorBeside(const Camera& camera, const render::ToothSurface& surface,
                                                bool leftHanded, bool amongNeighbours);

/// Returns the names of the viewpoints: start, above (the view along the bur), mesial, distal, buccal, lingual, and the
/// two views along the axis of the tooth, occlusal and below.
[[nodiscard]] QStringList viewpointNames();

/// Moves the camera to a viewpoint by name, or to "AZ,EL,DIST" (degrees, degrees, mm). Returns UnknownName with a
/// one-sentence detail for any other text, and for a direction such as mesial if the tooth is unknown.
/// @param fdi  FDI number of the tooth; 0: unknown
/// @param lying  the directions of the tooth's own frame
[[nodiscard]] core::Status goTo(Camera& camera, const QString& viewpoint, int fdi,
                                const core::terrain::Lying& lying = {});

/// Looks at the whole tooth along one of its own axes.
/// @param end  the end of an axis from which the camera looks: -x, +x, -y, +y, -z, +z, as in render::GizmoLetters
void lookFromEnd(Camera& camera, std::size_t end, const core::terrain::Lying& lying);

}  // namespace ui::tooth
