// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/terrain/Lying.h"
#include "ui/render/ToothRenderer.h"
#include "ui/tooth/Camera.h"

#include <QString>
#include <QStringList>

namespace ui::tooth {

/// What every picture of a tooth begins with: seen through this camera under the operating light, no instrument.
/// @param sizePx  of the picture, device pixels
[[nodiscard]] render::Scene sceneThrough(const Camera& camera, glm::vec2 sizePx, bool leftHanded);

/// Unit vector to the operating light, tooth frame: from behind, over the other shoulder than the handpiece, so that
/// fissures throw their shadows towards the eye.
[[nodiscard]] glm::vec3 operatingLight(bool leftHanded);

/// Makes a tooth the camera's subject, from where it is looked at first: from behind if only there its lesion is seen,
/// as on lower incisors.
void showWhole(Camera& camera, const render::ToothSurface& surface);

/// How much higher than on a bur held in the air shank and handpiece must be drawn to clear the tooth, mm.
[[nodiscard]] double liftMm(const render::ToothSurface& surface, std::size_t burIndex, const glm::dvec3& tipMm);

/// Where the dental mirror is held first: beside the tooth on the far side, over the other hand, so that it shows what
/// the eye does not see; among neighbours behind the row.
[[nodiscard]] render::DentalMirror mirrorBeside(const Camera& camera, const render::ToothSurface& surface,
                                                bool leftHanded, bool amongNeighbours);

/// Returns the names of the viewpoints: start, above (the view along the bur), mesial, distal, buccal, lingual, and the
/// two views along the axis of the tooth, occlusal and below.
[[nodiscard]] QStringList viewpointNames();

/// Takes the camera to a viewpoint by name, or to "AZ,EL,DIST" (degrees, degrees, mm). UnknownName with one sentence,
/// also for a direction of the mouth where nothing says which it is.
/// @param fdi  of the tooth, 0 where it is unknown
/// @param lying  which way the directions of the tooth's own frame point
[[nodiscard]] core::Status goTo(Camera& camera, const QString& viewpoint, int fdi,
                                const core::terrain::Lying& lying = {});

/// Looks at the whole tooth along one of its own axes.
/// @param end  the end of an axis from which the camera looks: -x, +x, -y, +y, -z, +z, as in render::GizmoLetters
void lookFromEnd(Camera& camera, std::size_t end, const core::terrain::Lying& lying);

}  // namespace ui::tooth
