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

/// What bur and handpiece change of the light on the upper surface of a tooth: the shadows they throw, and the
/// handpiece's own lamp. Found once for each node, however many eyes look. The context given to initialize() must be
/// current in every call, the destructor included.
class BurLight : private QOpenGLFunctions_3_3_Core
{
public:
    /// Everything that decides it besides the tooth.
    struct Pose
    {
        glm::dmat4 toothFromBur{1.0};   ///< tip at the origin, axis +z, handle towards +x
        glm::dmat4 toothFromHand{1.0};  ///< shank and handpiece as they are drawn: lifted, and leaning out of the view
        std::size_t burIndex = 0;
        double liftMm = 0.0;  ///< of shank and handpiece along the bur
        bool lamp = false;    ///< the handpiece's own is on
        glm::vec3 towardsLight{0.0F, 0.0F, 1.0F};
        bool operator==(const Pose&) const = default;
    };

    /// False when the context has no OpenGL 3.3 or refuses a shader; `reason` then says which.
    [[nodiscard]] bool initialize(QString& reason);

    /// Brings reached() and texture() up to date. Leaves framebuffer and viewport as they were; depth test and culling
    /// may be off.
    void find(ToothMaps& maps, const Pose& pose);
    /// Tiles of the upper surface where something changes; elsewhere texture() holds nothing.
    [[nodiscard]] const ToothMaps::Selection& reached() const { return m_reached; }
    /// A pixel a node: half of how many times as bright it looks. There once reached() is not empty.
    [[nodiscard]] GLuint texture() const { return m_map->texture(); }

private:
    QOpenGLShaderProgram m_program;
    QOpenGLVertexArrayObject m_nothing;  ///< for pictures without vertices
    std::unique_ptr<QOpenGLFramebufferObject> m_map;
    ToothMaps::Selection m_reached;
    std::optional<Pose> m_pose;         ///< that was found last,
    std::uint64_t m_uploadedBytes = 0;  ///< for the tooth as it was then
};

}  // namespace ui::render
