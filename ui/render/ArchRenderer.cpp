// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/render/ArchRenderer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "ui/render/Shaders.h"

namespace ui::render {

using core::teeth::ArchPiece;
using core::teeth::LookMesh;
using core::teeth::LookVertex;

ArchRenderer::ArchRenderer() = default;
ArchRenderer::~ArchRenderer() = default;

bool ArchRenderer::initialize(QString& reason)
{
    if (!initializeOpenGLFunctions()) {
        reason = QStringLiteral("no OpenGL 3.3 core profile");
        return false;
    }
    if (!buildProgram(m_program, "arch", "arch", reason) ||
        !buildProgram(m_roomProgram, "backdrop", "backdrop", reason))
        return false;
    m_nothing.create();
    m_layout.create();
    m_vertices.create();
    m_indices.create();
    return true;
}

void ArchRenderer::setPieces(std::vector<ArchPiece> pieces)
{
    m_pieces = std::move(pieces);
    m_fades = std::any_of(m_pieces.begin(), m_pieces.end(), [](const ArchPiece& piece) {
        return std::any_of(piece.mesh->vertices.begin(), piece.mesh->vertices.end(),
                           [](const LookVertex& v) { return v.shown < 1.0F; });
    });
    bool known = true;
    for (const ArchPiece& piece : m_pieces)
        known = known && m_spans.contains(piece.mesh.get());
    if (known)
        return;
    m_spans.clear();
    std::vector<LookVertex> vertices;
    std::vector<std::uint32_t> indices;
    for (const ArchPiece& piece : m_pieces) {
        if (m_spans.contains(piece.mesh.get()))
            continue;
        const LookMesh& mesh = *piece.mesh;
        m_spans[&mesh] = {static_cast<int>(vertices.size()), indices.size(), static_cast<int>(mesh.indices.size())};
        vertices.insert(vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
        indices.insert(indices.end(), mesh.indices.begin(), mesh.indices.end());
    }
    const QOpenGLVertexArrayObject::Binder bound(&m_layout);
    m_vertices.bind();
    m_vertices.allocate(vertices.data(), static_cast<int>(vertices.size() * sizeof(LookVertex)));
    m_indices.bind();
    m_indices.allocate(indices.data(), static_cast<int>(indices.size() * sizeof(std::uint32_t)));
    m_uploadedBytes += vertices.size() * sizeof(LookVertex) + indices.size() * sizeof(std::uint32_t);
    const auto attribute = [&](GLuint slot, GLint size, std::size_t offset) {
        glEnableVertexAttribArray(slot);
        glVertexAttribPointer(slot, size, GL_FLOAT, GL_FALSE, sizeof(LookVertex),
                              // NOLINTNEXTLINE(performance-no-int-to-ptr): an offset into OpenGL's own buffer
                              reinterpret_cast<const void*>(offset));
    };
    attribute(0, 3, offsetof(LookVertex, positionMm));
    attribute(1, 3, offsetof(LookVertex, normal));
    attribute(2, 1, offsetof(LookVertex, open));
    attribute(3, 1, offsetof(LookVertex, tissue));
    attribute(4, 1, offsetof(LookVertex, shown));
}

void ArchRenderer::drawRoom(glm::vec2 sizePx, glm::vec2 lamp)
{
    glDisable(GL_BLEND);
    glDisable(GL_STENCIL_TEST);
    glDisable(GL_SCISSOR_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
    glClear(GL_DEPTH_BUFFER_BIT);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    const QOpenGLVertexArrayObject::Binder bound(&m_nothing);
    m_roomProgram.bind();
    m_roomProgram.setUniformValue("crown", lamp.x, lamp.y);
    m_roomProgram.setUniformValue("aspect", sizePx.x / sizePx.y);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void ArchRenderer::draw(const ArchScene& scene)
{
    glEnable(GL_MULTISAMPLE);
    // Blends only pieces that fade. The picture's alpha stays 1, because it is composited over a window.
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    if (m_fades)
        glEnable(GL_BLEND);
    else
        glDisable(GL_BLEND);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glDepthMask(GL_TRUE);
    glCullFace(GL_BACK);
    const QOpenGLVertexArrayObject::Binder bound(&m_layout);
    m_program.bind();
    const auto vector = [&](const char* name, glm::vec3 v) { m_program.setUniformValue(name, v.x, v.y, v.z); };
    vector("eyeMm", glm::vec3(scene.eyeMm));
    vector("towardsLight", scene.towardsLight);
    vector("towardsSky", scene.towardsSky);
    const glm::vec4 clipPlane(scene.clipPlane);
    glUniform4fv(m_program.uniformLocation("clipPlane"), 1, glm::value_ptr(clipPlane));
    m_program.setUniformValue("dimmed", static_cast<float>(scene.dimmed));
    const int clipFromPiece = m_program.uniformLocation("clipFromPiece");
    const int sceneFromPiece = m_program.uniformLocation("sceneFromPiece");
    const int highlight = m_program.uniformLocation("highlight");
    const glm::dmat4 clipFromScene = scene.clipFromEye * scene.eyeFromScene;
    // A mirror, or a picture flipped for a half-silvered mirror, reverses the winding of every triangle.
    const double handed =
        glm::determinant(glm::dmat3(scene.eyeFromScene)) * scene.clipFromEye[0][0] * scene.clipFromEye[1][1];
    for (const ArchPiece& piece : m_pieces) {
        const Span& span = m_spans.at(piece.mesh.get());
        const glm::mat4 clip(clipFromScene * piece.place);
        const glm::mat4 place(piece.place);
        glUniformMatrix4fv(clipFromPiece, 1, GL_FALSE, glm::value_ptr(clip));
        glUniformMatrix4fv(sceneFromPiece, 1, GL_FALSE, glm::value_ptr(place));
        const bool chosen = piece.tooth && piece.fdi == scene.chosenFdi;
        const bool hovered = piece.tooth && piece.fdi == scene.hoveredFdi;
        m_program.setUniformValue(highlight, chosen ? 1.0F : 0.0F, hovered ? 1.0F : 0.0F);
        // A tooth is a closed mesh. The gum is an open sheet, whose back is visible from below.
        if (piece.tooth)
            glEnable(GL_CULL_FACE);
        else
            glDisable(GL_CULL_FACE);
        glFrontFace(handed * glm::determinant(glm::dmat3(piece.place)) < 0.0 ? GL_CW : GL_CCW);
        glDrawElementsBaseVertex(GL_TRIANGLES, span.indices, GL_UNSIGNED_INT,
                                 // NOLINTNEXTLINE(performance-no-int-to-ptr): an offset into OpenGL's own buffer
                                 reinterpret_cast<const void*>(span.firstIndex * sizeof(std::uint32_t)),
                                 span.firstVertex);
    }
    glFrontFace(GL_CCW);
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);
}

namespace {

/// Returns the distance along the ray to the nearest triangle (Moeller and Trumbore), infinite if it hits none.
double distanceTo(const LookMesh& mesh, const Ray& ray)
{
    double nearest = std::numeric_limits<double>::infinity();
    const glm::dvec3 toMiddle = glm::dvec3(mesh.middleMm) - ray.originMm;
    const double along = glm::dot(toMiddle, ray.direction);
    const double radius = static_cast<double>(mesh.radiusMm);
    if (glm::dot(toMiddle, toMiddle) - along * along > radius * radius)
        return nearest;
    for (std::size_t k = 0; k < mesh.indices.size(); k += 3) {
        const glm::dvec3 a(mesh.vertices[mesh.indices[k]].positionMm);
        const glm::dvec3 ab = glm::dvec3(mesh.vertices[mesh.indices[k + 1]].positionMm) - a;
        const glm::dvec3 ac = glm::dvec3(mesh.vertices[mesh.indices[k + 2]].positionMm) - a;
        const glm::dvec3 p = glm::cross(ray.direction, ac);
        const double determinant = glm::dot(ab, p);
        if (std::abs(determinant) < 1.0e-12)
            continue;
        const glm::dvec3 from = ray.originMm - a;
        const double u = glm::dot(from, p) / determinant;
        const glm::dvec3 q = glm::cross(from, ab);
        const double v = glm::dot(ray.direction, q) / determinant;
        const double t = glm::dot(ac, q) / determinant;
        if (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0 && t < nearest)
            nearest = t;
    }
    return nearest;
}

}  // namespace

int toothMet(std::span<const ArchPiece> pieces, const Ray& ray)
{
    double nearest = std::numeric_limits<double>::infinity();
    int fdi = 0;
    for (const ArchPiece& piece : pieces) {
        // Placements rotate and mirror but do not scale, so distances are the same in the piece's frame.
        const glm::dmat4 back = glm::inverse(piece.place);
        const Ray inPiece{glm::dvec3(back * glm::dvec4(ray.originMm, 1.0)),
                          glm::dvec3(back * glm::dvec4(ray.direction, 0.0))};
        if (const double distance = distanceTo(*piece.mesh, inPiece); distance < nearest) {
            nearest = distance;
            fdi = piece.tooth ? piece.fdi : 0;
        }
    }
    return fdi;
}

}  // namespace ui::render
