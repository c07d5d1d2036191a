// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <QOpenGLBuffer>
#include <QOpenGLFramebufferObject>
#include <QOpenGLFunctions_3_3_Core>
#include <QOpenGLShaderProgram>
#include <QOpenGLVertexArrayObject>
#include <QString>

#include "ui/render/ArchRenderer.h"
#include "ui/render/BurLight.h"
#include "ui/render/Look.h"
#include "ui/render/SolidMesh.h"
#include "ui/render/StillPicture.h"
#include "ui/render/ToothMaps.h"
#include "ui/render/ToothSurface.h"

namespace ui::render {

/// A height below every tooth, mm. With this height nothing fades.
inline constexpr float kNoFadeMm = -1.0e6F;

/// The contents of one picture besides the tooth itself.
struct Scene
{
    glm::dmat4 eyeFromTooth{1.0};
    glm::dmat4 clipFromEye{1.0};
    glm::dvec3 eyeMm{0.0, 0.0, 40.0};
    glm::vec3 towardsLight{0.0F, 0.0F, 1.0F};
    glm::vec2 sizePx{1.0F, 1.0F};  ///< size of the picture, device pixels

    bool instrumentShown = false;
    std::size_t burIndex = 0;
    glm::dvec3 tipMm{0.0};                    ///< tip of the bur
    std::optional<double> surfaceBelowTipMm;  ///< height of the tooth under the tip, if there is any; the cue line ends
                                              ///< there
    double handAzimuthRad = 0.0;              ///< direction of the handle, about +z from +x
    double leanRad = 0.0;                     ///< of shank and handpiece from upright, so that they do not hide the
                                              ///< tooth
    double leanAzimuthRad = 0.0;              ///< direction of the lean, about +z from +x
    double turnRad = 0.0;                     ///< rotation of the bur about its axis
    bool drillOn = false;
    glm::vec4 burTint{0.0F};  ///< colour of the bur's head, and its opacity
    double liftMm = 0.0;      ///< lift of shank and handpiece along the bur, so that they clear the tooth

    std::optional<glm::dvec3> ghostMm;  ///< position where the hand holds the bur, drawn transparent
    std::optional<DentalMirror> mirror;
    bool mirrorHandleLeft = true;  ///< the hand opposite the handpiece holds the mirror
    Look look;

    int eye = 0;  ///< 0: the left or only eye, 1: the right eye
    /// Stores the picture of everything that does not move. Useful for a software driver, which draws slowly and copies
    /// fast.
    bool keepsStill = false;
};

/// Draws a ToothSurface, the bur and the handpiece with OpenGL 3.3 core. The context of initialize() must be current in
/// every call, including the destructor.
class ToothRenderer : private QOpenGLFunctions_3_3_Core
{
public:
    ToothRenderer();
    ~ToothRenderer() override;

    /// Compiles the shaders. Returns false if the context has no OpenGL 3.3 or rejects a shader, and writes the cause
    /// to `reason`.
    [[nodiscard]] bool initialize(QString& reason);

    /// Uploads a whole surface, which replaces the previous one.
    void setSurface(const ToothSurface& surface);
    /// Uploads only the parts that a refresh() of that surface has changed.
    void update(const ToothSurface& surface, const ToothSurface::Changes& changes);
    /// Sets the pieces beside the tooth, in the tooth's frame. Empty: none.
    void setNeighbours(std::vector<core::teeth::ArchPiece> pieces);
    /// Draws into the whole viewport of the bound framebuffer. Without a surface it draws the empty room.
    void draw(const Scene& scene);

    /// Returns the number of bytes that setSurface() and update() have uploaded so far. For tests: a picture does not
    /// show whether update() skipped unchanged parts.
    [[nodiscard]] std::uint64_t uploadedBytes() const { return m_maps.uploadedBytes(); }

private:
    struct Part
    {
        QOpenGLVertexArrayObject layout;
        QOpenGLBuffer vertices{QOpenGLBuffer::VertexBuffer};
        QOpenGLBuffer indices{QOpenGLBuffer::IndexBuffer};
        int count = 0;
    };
    void upload(Part& part, const SolidMesh& mesh);
    void drawStill(const Scene& scene, const glm::dvec4& clipPlane);
    void drawRoom(const Scene& scene, const QRect& part);
    void copyPixels(GLuint from, GLuint to, QSize size, GLbitfield what);
    void spoilStills(const ToothSurface::Changes& changes);
    void useTooth(QOpenGLShaderProgram& program, const Scene& scene);
    void showNearestFronts();
    void drawLightOfBur(const Scene& scene);
    void drawReflection(const Scene& scene);
    void drawMirror(const Scene& scene);
    void drawGhost(const Scene& scene);
    void useMetal(const Scene& scene, const glm::dmat4& toothFromPart);
    void drawPart(Part& part);
    [[nodiscard]] static glm::dmat4 toothFromBur(const Scene& scene, const glm::dvec3& tipMm);
    [[nodiscard]] static glm::dmat4 toothFromHand(const Scene& scene);
    void fadeOverTheCut(const Scene& scene, const glm::dmat4& toothFromHand);
    void drawBackdrop(const Scene& scene);
    void drawTooth(const Scene& scene, const QRect& part);
    void drawInstrument(const Scene& scene);
    void drawCue(const Scene& scene);

    QOpenGLShaderProgram m_toothProgram;
    QOpenGLShaderProgram m_brightenProgram;
    QOpenGLShaderProgram m_backdropProgram;
    QOpenGLShaderProgram m_metalProgram;
    QOpenGLShaderProgram m_lineProgram;
    QOpenGLShaderProgram m_glassProgram;
    QOpenGLVertexArrayObject m_nothing;  ///< for drawing without vertices
    ToothMaps m_maps;
    std::vector<std::unique_ptr<Part>> m_burs;
    std::vector<std::unique_ptr<Part>> m_shanks;
    ArchRenderer m_neighbours;
    glm::vec2 m_fadeMm{kNoFadeMm, kNoFadeMm - 1.0F};  ///< heights between which the root fades, like the gum beside it
    Part m_handpiece;
    Part m_mirror;
    std::unique_ptr<QOpenGLFramebufferObject> m_reflected;   ///< the picture in the dental mirror, from the eye
    std::unique_ptr<QOpenGLFramebufferObject> m_reflection;  ///< m_reflected resolved for reading, if it has several
                                                             ///< samples
    bool m_isMirrored = false;                               ///< the picture is a mirror image: front faces have the
                                                             ///< opposite orientation
    glm::vec4 m_clipPlane{0.0F};                             ///< tooth frame; nothing behind it is drawn

    /// For each eye, direct and in the mirror.
    std::array<StillPicture, 4> m_stills;
    BurLight m_burLight;
    std::uint64_t m_surfaces = 0;  ///< number of teeth and sets of neighbours so far
    glm::vec3 m_crownMm{0.0F};
};

}  // namespace ui::render
