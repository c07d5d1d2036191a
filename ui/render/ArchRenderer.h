// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <QOpenGLBuffer>
#include <QOpenGLFunctions_3_3_Core>
#include <QOpenGLShaderProgram>
#include <QOpenGLVertexArrayObject>
#include <QString>

#include "core/teeth/Arch.h"
#include "ui/render/ToothSurface.h"

namespace ui::render {

/// The view of pieces of a mouth. The scene frame is that of the pieces: the mouth's, or that of the tooth being worked
/// on.
struct ArchScene
{
    glm::dmat4 eyeFromScene{1.0};
    glm::dmat4 clipFromEye{1.0};
    glm::dvec3 eyeMm{0.0, 0.0, 40.0};
    glm::vec3 towardsLight{0.0F, 0.0F, 1.0F};
    glm::vec3 towardsSky{0.0F, 0.0F, 1.0F};  ///< direction of the brightest part of the room
    int hoveredFdi = 0;                      ///< drawn a little lighter
    int chosenFdi = 0;                       ///< tinted
    glm::dvec4 clipPlane{0.0};               ///< scene frame; nothing behind it is drawn; zero: no plane
    double dimmed = 0.0;                     ///< 0 to 1: how much the pieces are dimmed, behind other content
};

/// Draws teeth and gums of core::teeth::Arch with OpenGL 3.3 core, lit as ToothRenderer lights the single tooth. The
/// context of initialize() must be current in every call, including the destructor.
class ArchRenderer : private QOpenGLFunctions_3_3_Core
{
public:
    ArchRenderer();
    ~ArchRenderer() override;

    /// Compiles the shaders. Returns false if the context has no OpenGL 3.3 or rejects a shader, and writes the cause
    /// to `reason`.
    [[nodiscard]] bool initialize(QString& reason);

    /// Sets the pieces for draw(). Uploads each mesh once, however often it is used.
    void setPieces(std::vector<core::teeth::ArchPiece> pieces);
    [[nodiscard]] const std::vector<core::teeth::ArchPiece>& pieces() const { return m_pieces; }

    /// Draws the empty practice room over the whole viewport and clears the depth.
    /// @param lamp  the brightest place of the room, clip coordinates
    void drawRoom(glm::vec2 sizePx, glm::vec2 lamp);
    /// Draws the pieces over the contents of the bound framebuffer, which must have a depth buffer. Either matrix of
    /// the scene may mirror. Disables depth test and culling afterwards.
    void draw(const ArchScene& scene);

    [[nodiscard]] std::uint64_t uploadedBytes() const { return m_uploadedBytes; }

private:
    struct Span
    {
        int firstVertex = 0;
        std::size_t firstIndex = 0;
        int indices = 0;
    };

    QOpenGLShaderProgram m_program;
    QOpenGLShaderProgram m_roomProgram;
    QOpenGLVertexArrayObject m_nothing;
    QOpenGLVertexArrayObject m_layout;
    QOpenGLBuffer m_vertices{QOpenGLBuffer::VertexBuffer};
    QOpenGLBuffer m_indices{QOpenGLBuffer::IndexBuffer};
    bool m_fades = false;  ///< some of the pieces fade
    std::vector<core::teeth::ArchPiece> m_pieces;
    std::map<const core::teeth::LookMesh*, Span> m_spans;
    std::uint64_t m_uploadedBytes = 0;
};

/// Returns the FDI number of the first tooth that a ray meets; 0 if it meets none, or gum first.
[[nodiscard]] int toothMet(std::span<const core::teeth::ArchPiece> pieces, const Ray& ray);

}  // namespace ui::render
