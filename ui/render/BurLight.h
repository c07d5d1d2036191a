// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <QOpenGLFramebufferObject>
#include <QOpenGLFunctions_3_3_Core>
#include <QOpenGLShaderProgram>
#include <QOpenGLVertexArrayObject>
#include <QString>

#include "ui/render/ToothMaps.h"

namespace ui::render {

/// Computes how bur and handpiece change the light on the upper surface of a tooth: their shadows, and the light of the
/// handpiece's lamp. Computed once per node for all eyes. The context of initialize() must be current in every call,
/// including the destructor.
class BurLight : private QOpenGLFunctions_3_3_Core
{
public:
    /// Everything but the tooth that the light depends on.
    struct Pose
    {
        glm::dmat4 toothFromBur{1.0};   ///< tip at the origin, axis +z, handle towards +x
        glm::dmat4 toothFromHand{1.0};  ///< shank and handpiece as drawn: lifted, and leaning out of the view
        std::size_t burIndex = 0;
        double liftMm = 0.0;  ///< lift of shank and handpiece along the bur
        bool lamp = false;    ///< the handpiece's own lamp is on
        glm::vec3 towardsLight{0.0F, 0.0F, 1.0F};
        bool operator==(const Pose&) const = default;
    };

    /// Compiles the shader. Returns false if the context has no OpenGL 3.3 or rejects the shader, and writes the cause
    /// to `reason`.
    [[nodiscard]] bool initialize(QString& reason);

    /// Updates reached() and texture(). Restores framebuffer and viewport, but may switch depth test and culling off.
    void find(ToothMaps& maps, const Pose& pose);
    /// Returns the tiles of the upper surface on which the light changes. texture() is undefined elsewhere.
    [[nodiscard]] const ToothMaps::Selection& reached() const { return m_reached; }
    /// Returns a texture with one pixel per node: half the factor by which brightness changes. Valid if reached() is
    /// not empty.
    [[nodiscard]] GLuint texture() const { return m_map->texture(); }

private:
    QOpenGLShaderProgram m_program;
    QOpenGLVertexArrayObject m_nothing;  ///< for drawing without vertices
    std::unique_ptr<QOpenGLFramebufferObject> m_map;
    ToothMaps::Selection m_reached;
    std::optional<Pose> m_pose;         ///< pose at the last update
    std::uint64_t m_uploadedBytes = 0;  ///< the tooth's upload count at the last update
};

}  // namespace ui::render
