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

/// Below every tooth: a height from which nothing fades, mm.
inline constexpr float kNoFadeMm = -1.0e6F;

/// Everything one picture shows besides the tooth itself.
struct Scene
{
    glm::dmat4 eyeFromTooth{1.0};
    glm::dmat4 clipFromEye{1.0};
    glm::dvec3 eyeMm{0.0, 0.0, 40.0};
    glm::vec3 towardsLight{0.0F, 0.0F, 1.0F};
    glm::vec2 sizePx{1.0F, 1.0F};  ///< of the picture, device pixels

    bool instrumentShown = false;
    std::size_t burIndex = 0;
    glm::dvec3 tipMm{0.0};                    ///< of the bur
    std::optional<double> surfaceBelowTipMm;  ///< height of the tooth under the tip, if any; the cue line ends there
    double handAzimuthRad = 0.0;              ///< from +x to where the handle points, about +z
    double leanRad = 0.0;                     ///< of shank and handpiece from upright, out of the way of the view
    double leanAzimuthRad = 0.0;              ///< from +x to where they lean, about +z
    double turnRad = 0.0;                     ///< of the bur about its axis
    bool drillOn = false;
    glm::vec4 burTint{0.0F};  ///< colour of the bur's head, and how much of it
    double liftMm = 0.0;      ///< of shank and handpiece along the bur, so that they clear the tooth

    std::optional<glm::dvec3> ghostMm;  ///< where the hand holds the bur, shown faintly
    std::optional<DentalMirror> mirror;
    bool mirrorHandleLeft = true;  ///< the mirror is held by the other hand than the handpiece
    Look look;

    int eye = 0;  ///< of two: 0 the left one or the only one, 1 the right one
    /// Keep what does not move from picture to picture: right for a software driver, which draws slowly and copies
    /// quickly.
    bool keepsStill = false;
};

/// Draws a ToothSurface, the bur and the handpiece with OpenGL 3.3 core. The context given to initialize() must be
/// current in every call, the destructor included.
class ToothRenderer : private QOpenGLFunctions_3_3_Core
{
public:
    ToothRenderer();
    ~ToothRenderer() override;

    /// Compiles the shaders. False when the context has no OpenGL 3.3 or refuses a shader; `reason` then says which.
    [[nodiscard]] bool initialize(QString& reason);

    /// Uploads a whole surface in place of the one before.
    void setSurface(const ToothSurface& surface);
    /// Uploads what a refresh() of that surface changed, and nothing else.
    void update(const ToothSurface& surface, const ToothSurface::Changes& changes);
    /// What stands beside the tooth, in its frame; empty: nothing.
    void setNeighbours(std::vector<core::teeth::ArchPiece> pieces);
    /// Draws into the bound framebuffer, whole viewport. Without a surface: the empty room.
    void draw(const Scene& scene);

    /// Bytes of textures and buffers written by setSurface() and update() so far. For the test: no picture shows
    /// whether update() left out what had not changed.
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
    QOpenGLVertexArrayObject m_nothing;  ///< for pictures without vertices
    ToothMaps m_maps;
    std::vector<std::unique_ptr<Part>> m_burs;
    std::vector<std::unique_ptr<Part>> m_shanks;
    ArchRenderer m_neighbours;
    glm::vec2 m_fadeMm{kNoFadeMm,
                       kNoFadeMm - 1.0F};  ///< heights between which the root fades, as the gum beside it does
    Part m_handpiece;
    Part m_mirror;
    std::unique_ptr<QOpenGLFramebufferObject> m_reflected;   ///< what the dental mirror shows, as the eye sees it
    std::unique_ptr<QOpenGLFramebufferObject> m_reflection;  ///< the same to be read, where that has several samples
    bool m_isMirrored = false;                               ///< what is drawn is a mirror image: its front faces turn
    glm::vec4 m_clipPlane{0.0F};                             ///< tooth frame; what is behind it is not drawn

    /// Of each eye, straight and in the mirror.
    std::array<StillPicture, 4> m_stills;
    BurLight m_burLight;
    std::uint64_t m_surfaces = 0;  ///< teeth and neighbours that came so far
    glm::vec3 m_crownMm{0.0F};
};

}  // namespace ui::render
