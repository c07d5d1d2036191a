// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/render/ToothRenderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <QOpenGLContext>
#include <QOpenGLPixelTransferOptions>
#include <QVector4D>

#include "ui/render/GritColour.h"
#include "ui/render/Shaders.h"

namespace ui::render {
namespace {

constexpr double kWorkMm = 6.0;       ///< length of the bur, from its tip, that the handpiece must not hide
constexpr double kWorkAsideMm = 2.2;  ///< and the width to either side of the bur
constexpr float kWholeMesh = 1.0e6F;  ///< mm, higher than any part of the instrument: nothing fades
constexpr double kNeighboursDimmed = 0.35;
constexpr float kCueWide = 0.0034F;  ///< half-width of the line under the bur, as a share of half the picture's height
constexpr int kFreeUnit = 8;         ///< first texture unit that ToothMaps does not use
constexpr int kGlassCorners = 64;    ///< corners of the mirror's glass; must equal the number in glass.vert

void setMatrix(QOpenGLFunctions_3_3_Core& gl, QOpenGLShaderProgram& program, const char* name, const glm::mat4& matrix)
{
    gl.glUniformMatrix4fv(program.uniformLocation(name), 1, GL_FALSE, glm::value_ptr(matrix));
}

/// Returns the heights between which the gum around a tooth fades, x above y, if the tooth is not among the pieces.
glm::vec2 fadeOf(const std::vector<core::teeth::ArchPiece>& pieces)
{
    glm::vec2 fade(kNoFadeMm, kNoFadeMm - 1.0F);
    for (const core::teeth::ArchPiece& gum : pieces) {
        const bool isBeside = std::any_of(pieces.begin(), pieces.end(), [&](const core::teeth::ArchPiece& piece) {
            return piece.tooth && piece.fdi == gum.fdi;
        });
        if (gum.tooth || isBeside)
            continue;
        fade = {kNoFadeMm, 0.0F};
        for (const core::teeth::LookVertex& v : gum.mesh->vertices) {
            if (v.shown <= 0.0F || v.shown >= 1.0F)
                continue;
            const auto z = static_cast<float>((gum.place * glm::dvec4(v.positionMm, 1.0)).z);
            fade = {std::max(fade.x, z), std::min(fade.y, z)};
        }
    }
    return fade.x > fade.y ? fade : glm::vec2(kNoFadeMm, kNoFadeMm - 1.0F);
}

/// Returns the size of a diamond's grains in mm; those of ISO 6360 are about 25 to 180 um. Returns that of a medium bur
/// for an unknown grit number.
double grainOf(int grit)
{
    switch (grit) {
    case 504:
        return 0.03;
    case 514:
        return 0.05;
    case 534:
        return 0.15;
    case 544:
        return 0.18;
    default:
        return 0.11;
    }
}

}  // namespace

ToothRenderer::ToothRenderer() = default;
ToothRenderer::~ToothRenderer() = default;

bool ToothRenderer::initialize(QString& reason)
{
    if (!initializeOpenGLFunctions()) {
        reason = QStringLiteral("no OpenGL 3.3 core profile");
        return false;
    }
    if (!buildProgram(m_toothProgram, "tooth", "tooth", reason) ||
        !buildProgram(m_backdropProgram, "backdrop", "backdrop", reason) ||
        !buildProgram(m_metalProgram, "metal", "metal", reason) ||
        !buildProgram(m_lineProgram, "line", "line", reason) ||
        !buildProgram(m_glassProgram, "glass", "glass", reason) ||
        !buildProgram(m_brightenProgram, "brighten", "brighten", reason) || !m_neighbours.initialize(reason) ||
        !m_burLight.initialize(reason) || !m_maps.initialize())
        return false;
    m_nothing.create();
    for (const core::bur::Bur& bur : core::bur::burs()) {
        m_burs.push_back(std::make_unique<Part>());
        upload(*m_burs.back(), burMesh(bur));
        m_shanks.push_back(std::make_unique<Part>());
        upload(*m_shanks.back(), shankMesh(bur));
    }
    upload(m_handpiece, handpieceMesh());
    upload(m_mirror, mirrorMesh());
    return true;
}

void ToothRenderer::upload(Part& part, const SolidMesh& mesh)
{
    part.layout.create();
    const QOpenGLVertexArrayObject::Binder bound(&part.layout);
    part.vertices.create();
    part.vertices.bind();
    part.vertices.allocate(mesh.vertices.data(), static_cast<int>(mesh.vertices.size() * sizeof(MetalVertex)));
    part.indices.create();
    part.indices.bind();
    part.indices.allocate(mesh.indices.data(), static_cast<int>(mesh.indices.size() * sizeof(std::uint32_t)));
    part.count = static_cast<int>(mesh.indices.size());
    const auto attribute = [&](GLuint slot, GLint size, std::size_t offset) {
        glEnableVertexAttribArray(slot);
        glVertexAttribPointer(slot, size, GL_FLOAT, GL_FALSE, sizeof(MetalVertex),
                              // NOLINTNEXTLINE(performance-no-int-to-ptr): an offset into OpenGL's own buffer
                              reinterpret_cast<const void*>(offset));
    };
    attribute(0, 3, offsetof(MetalVertex, position));
    attribute(1, 3, offsetof(MetalVertex, normal));
    attribute(2, 2, offsetof(MetalVertex, finish));
}

void ToothRenderer::setSurface(const ToothSurface& surface)
{
    m_maps.setSurface(surface);
    m_crownMm = glm::vec3(surface.crownMiddleMm());
    ++m_surfaces;
}

void ToothRenderer::update(const ToothSurface& surface, const ToothSurface::Changes& changes)
{
    if (m_maps.isEmpty())
        return;
    // Invalidates the stored pictures where the surface was and where it is now.
    spoilStills(changes);
    m_maps.update(surface, changes);
    spoilStills(changes);
}

void ToothRenderer::spoilStills(const ToothSurface::Changes& changes)
{
    for (StillPicture& still : m_stills) {
        if (!still.view())
            continue;
        const glm::dmat4 clipFromTooth = still.view()->clipFromEye * still.view()->eyeFromTooth;
        for (const core::terrain::NodeRect& rect : {changes.heights, changes.normals, changes.light, changes.blood})
            if (!rect.isEmpty())
                still.spoil(pixelsOf(m_maps.boxOf(rect), clipFromTooth, still.size()));
    }
}

void ToothRenderer::setNeighbours(std::vector<core::teeth::ArchPiece> pieces)
{
    m_fadeMm = fadeOf(pieces);
    m_neighbours.setPieces(std::move(pieces));
    ++m_surfaces;
}

void ToothRenderer::draw(const Scene& scene)
{
    glEnable(GL_MULTISAMPLE);
    glDisable(GL_BLEND);
    glDisable(GL_STENCIL_TEST);
    glDisable(GL_SCISSOR_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
    if (scene.mirror)
        drawReflection(scene);
    drawStill(scene, glm::dvec4(0.0));
    drawLightOfBur(scene);
    showNearestFronts();
    if (scene.mirror)
        drawMirror(scene);
    if (scene.instrumentShown && scene.burIndex < m_burs.size())
        drawInstrument(scene);
    if (scene.ghostMm && scene.burIndex < m_burs.size())
        drawGhost(scene);
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
}

/// Draws the tooth and the room. Unless the plane is zero, only the part of the tooth in front of it is drawn.
void ToothRenderer::drawStill(const Scene& scene, const glm::dvec4& clipPlane)
{
    m_clipPlane = glm::vec4(clipPlane);
    GLint bound = 0;
    GLint samples = 0;
    glGetIntegerv(GL_FRAMEBUFFER_BINDING, &bound);
    glGetIntegerv(GL_SAMPLES, &samples);
    const auto target = static_cast<GLuint>(bound);
    const QSize size(static_cast<int>(scene.sizePx.x), static_cast<int>(scene.sizePx.y));
    const QRect all(QPoint(), size);
    if (!scene.keepsStill) {
        drawRoom(scene, all);
        return;
    }
    StillView view{scene.eyeFromTooth, scene.clipFromEye, clipPlane, scene.towardsLight, scene.look, m_surfaces};
    view.look.burLight = false;
    StillPicture& still = m_stills[static_cast<std::size_t>((scene.eye != 0 ? 2 : 0) + (m_isMirrored ? 1 : 0))];
    if (samples > 0) {
        // Saves the smooth colours of a multisampled picture in the stored picture. Depths are drawn again: a copy
        // would take one of several samples, which lies beside the middle of the pixel.
        drawRoom(scene, all);
        still.take(size, view);
        copyPixels(target, still.framebuffer(), size, GL_COLOR_BUFFER_BIT);
        glBindFramebuffer(GL_FRAMEBUFFER, still.framebuffer());
        glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        drawRoom(scene, all);
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    } else {
        QRect part = still.takeSpoilt();
        if (!still.holds(size, view)) {
            still.take(size, view);
            part = all;
        }
        if (!part.isEmpty()) {
            glBindFramebuffer(GL_FRAMEBUFFER, still.framebuffer());
            drawRoom(scene, part);
        }
        // Copies the stencil too, because depth and stencil share one buffer and drivers draw a copy of a part of it
        // instead.
        copyPixels(still.framebuffer(), target, size,
                   GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, target);
}

void ToothRenderer::copyPixels(GLuint from, GLuint to, QSize size, GLbitfield what)
{
    glBindFramebuffer(GL_READ_FRAMEBUFFER, from);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to);
    glBlitFramebuffer(0, 0, size.width(), size.height(), 0, 0, size.width(), size.height(), what, GL_NEAREST);
}

/// Draws the whole room, clipped to a rectangle of pixels.
void ToothRenderer::drawRoom(const Scene& scene, const QRect& part)
{
    glEnable(GL_SCISSOR_TEST);
    glScissor(part.x(), part.y(), part.width(), part.height());
    glClear(GL_DEPTH_BUFFER_BIT);
    drawBackdrop(scene);
    if (!m_neighbours.pieces().empty()) {
        ArchScene beside;
        beside.eyeFromScene = scene.eyeFromTooth;
        beside.clipFromEye = scene.clipFromEye;
        beside.eyeMm = scene.eyeMm;
        beside.towardsLight = scene.towardsLight;
        beside.clipPlane = glm::dvec4(m_clipPlane);
        beside.dimmed = kNeighboursDimmed;
        m_neighbours.draw(beside);
    }
    if (!m_maps.isEmpty())
        drawTooth(scene, part);
    glDisable(GL_SCISSOR_TEST);
}

/// Draws the reflection in the mirror: the mirrored scene, seen by the same eye. Uses half the resolution of the
/// picture unless the picture is multisampled.
void ToothRenderer::drawReflection(const Scene& scene)
{
    GLint target = 0;
    GLint samples = 0;
    std::array<GLint, 4> viewport{};
    glGetIntegerv(GL_FRAMEBUFFER_BINDING, &target);
    glGetIntegerv(GL_SAMPLES, &samples);
    glGetIntegerv(GL_VIEWPORT, viewport.data());
    const int coarse = samples > 0 ? 1 : 2;
    const QSize size(std::max(1, viewport[2] / coarse), std::max(1, viewport[3] / coarse));
    if (!m_reflected || m_reflected->size() != size || m_reflected->format().samples() != samples) {
        QOpenGLFramebufferObjectFormat format;
        format.setSamples(samples);
        format.setAttachment(QOpenGLFramebufferObject::CombinedDepthStencil);
        m_reflected = std::make_unique<QOpenGLFramebufferObject>(size, format);
        m_reflection = samples > 0 ? std::make_unique<QOpenGLFramebufferObject>(size) : nullptr;
    }
    m_reflected->bind();
    glViewport(0, 0, size.width(), size.height());
    Scene seen = scene;
    seen.eyeFromTooth = scene.eyeFromTooth * scene.mirror->imageMatrix();
    seen.eyeMm = scene.mirror->image(scene.eyeMm);
    seen.sizePx = glm::vec2(size.width(), size.height());
    seen.ghostMm.reset();
    seen.mirror.reset();
    m_isMirrored = true;
    glEnable(GL_CLIP_DISTANCE0);
    const glm::dvec3& normal = scene.mirror->normal;
    drawStill(seen, glm::dvec4(normal, -glm::dot(normal, scene.mirror->centreMm)));
    drawLightOfBur(seen);
    showNearestFronts();
    if (seen.instrumentShown && seen.burIndex < m_burs.size())
        drawInstrument(seen);
    glDisable(GL_CLIP_DISTANCE0);
    m_isMirrored = false;
    m_clipPlane = glm::vec4(0.0F);
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
    if (m_reflection)
        QOpenGLFramebufferObject::blitFramebuffer(m_reflection.get(), m_reflected.get());
    glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(target));
    glViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
}

/// Draws the mirror. In its frame the origin is in the middle, +z points out of the glass, and the handle points
/// towards +x, which is turned upwards as far as possible.
void ToothRenderer::drawMirror(const Scene& scene)
{
    const glm::dvec3& z = scene.mirror->normal;
    const glm::dvec3 up = glm::dvec3(glm::inverse(scene.eyeFromTooth)[1]);
    const glm::dvec3 away = glm::dvec3(glm::inverse(scene.eyeFromTooth)[0]) * (scene.mirrorHandleLeft ? -1.0 : 1.0);
    const glm::dvec3 wanted = up * 0.35 + away;
    const glm::dvec3 x = glm::normalize(wanted - z * glm::dot(wanted, z));
    const glm::dvec3 y = glm::cross(z, x);
    const glm::dmat4 toothFromMirror(glm::dvec4(x, 0.0), glm::dvec4(y, 0.0), glm::dvec4(z, 0.0),
                                     glm::dvec4(scene.mirror->centreMm, 1.0));
    useMetal(scene, toothFromMirror);
    drawPart(m_mirror);
    const QOpenGLVertexArrayObject::Binder bound(&m_nothing);
    m_glassProgram.bind();
    setMatrix(*this, m_glassProgram, "clipFromMirror",
              glm::mat4(scene.clipFromEye * scene.eyeFromTooth * toothFromMirror));
    m_glassProgram.setUniformValue("radiusMm", static_cast<float>(DentalMirror::kRadiusMm - 0.6));
    m_glassProgram.setUniformValue("sizePx", scene.sizePx.x, scene.sizePx.y);
    m_glassProgram.setUniformValue("reflection", 0);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, (m_reflection ? m_reflection : m_reflected)->texture());
    glDrawArrays(GL_TRIANGLE_FAN, 0, kGlassCorners);
}

/// Draws a transparent bur at the position of the hand.
void ToothRenderer::drawGhost(const Scene& scene)
{
    useMetal(scene, toothFromBur(scene, *scene.ghostMm));
    m_metalProgram.setUniformValue("fade", 0.28F);
    m_metalProgram.setUniformValue("blur", 0.0F);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    // Visible through the tooth, because it shows where the hand is.
    glDisable(GL_DEPTH_TEST);
    drawPart(*m_burs[scene.burIndex]);
    glEnable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
}

glm::dmat4 ToothRenderer::toothFromBur(const Scene& scene, const glm::dvec3& tipMm)
{
    return glm::rotate(glm::translate(glm::dmat4(1.0), tipMm), scene.handAzimuthRad, glm::dvec3(0.0, 0.0, 1.0));
}

/// Returns the frame of shank and handpiece. Without lift and lean it is the frame of the bur. Once the top of the
/// bur's neck has left the tooth, they lean about that point.
glm::dmat4 ToothRenderer::toothFromHand(const Scene& scene)
{
    const double headMm = core::bur::burs()[scene.burIndex].headLengthMm;
    const glm::dvec3 axis(-std::sin(scene.leanAzimuthRad), std::cos(scene.leanAzimuthRad), 0.0);
    const glm::dmat4 atNeck =
        glm::translate(glm::dmat4(1.0), scene.tipMm + glm::dvec3(0.0, 0.0, headMm + scene.liftMm));
    const glm::dmat4 turned =
        glm::rotate(glm::rotate(atNeck, scene.leanRad, axis), scene.handAzimuthRad, glm::dvec3(0.0, 0.0, 1.0));
    return glm::translate(turned, glm::dvec3(0.0, 0.0, -headMm));
}

void ToothRenderer::useMetal(const Scene& scene, const glm::dmat4& toothFromPart)
{
    m_metalProgram.bind();
    setMatrix(*this, m_metalProgram, "clipFromTooth", glm::mat4(scene.clipFromEye * scene.eyeFromTooth));
    setMatrix(*this, m_metalProgram, "toothFromPart", glm::mat4(toothFromPart));
    setVector(m_metalProgram, "eyeMm", glm::vec3(scene.eyeMm));
    const glm::mat3 eyeRotation(scene.eyeFromTooth);
    glUniformMatrix3fv(m_metalProgram.uniformLocation("eyeRotation"), 1, GL_FALSE, glm::value_ptr(eyeRotation));
    setVector(m_metalProgram, "towardsLight", scene.towardsLight);
    m_metalProgram.setUniformValue("turnRad", static_cast<float>(std::remainder(scene.turnRad, 6.283185307179586)));
    m_metalProgram.setUniformValue("blur", scene.drillOn ? 0.8F : 0.0F);
    m_metalProgram.setUniformValue("fade", 1.0F);
    m_metalProgram.setUniformValue("tint", QVector4D());
    m_metalProgram.setUniformValue("workRadius", 0.0F);
    m_metalProgram.setUniformValue("topMm", kWholeMesh);
    const core::bur::Bur& bur = core::bur::burs()[scene.burIndex];
    const double grainMm = grainOf(bur.grit);
    m_metalProgram.setUniformValue("grains",
                                   static_cast<float>(std::ceil(2.0 * std::numbers::pi * bur.headRadiusMm / grainMm)),
                                   static_cast<float>(1.0 / grainMm));
    const QColor ring = gritColour(bur.grit).value_or(QColor(Qt::lightGray));
    m_metalProgram.setUniformValue("ring", ring.redF(), ring.greenF(), ring.blueF());
    glUniform4fv(m_metalProgram.uniformLocation("clipPlane"), 1, glm::value_ptr(m_clipPlane));
    glFrontFace(m_isMirrored ? GL_CW : GL_CCW);
}

void ToothRenderer::drawPart(Part& part)
{
    const QOpenGLVertexArrayObject::Binder bound(&part.layout);
    glDrawElements(GL_TRIANGLES, part.count, GL_UNSIGNED_INT, nullptr);
}

void ToothRenderer::drawBackdrop(const Scene& scene)
{
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    const QOpenGLVertexArrayObject::Binder bound(&m_nothing);
    const glm::dvec4 crown = scene.clipFromEye * scene.eyeFromTooth * glm::dvec4(m_crownMm, 1.0);
    m_backdropProgram.bind();
    m_backdropProgram.setUniformValue("crown", static_cast<float>(crown.x / crown.w),
                                      static_cast<float>(crown.y / crown.w));
    m_backdropProgram.setUniformValue("aspect", scene.sizePx.x / scene.sizePx.y);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

/// Sets the uniforms common to all programs that draw nodes of the lattice.
void ToothRenderer::useTooth(QOpenGLShaderProgram& program, const Scene& scene)
{
    program.bind();
    setMatrix(*this, program, "clipFromTooth", glm::mat4(scene.clipFromEye * scene.eyeFromTooth));
    setVector(program, "eyeMm", glm::vec3(scene.eyeMm));
    setVector(program, "towardsLight", scene.towardsLight);
    glUniform4fv(program.uniformLocation("clipPlane"), 1, glm::value_ptr(m_clipPlane));
    showNearestFronts();
}

void ToothRenderer::showNearestFronts()
{
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glEnable(GL_CULL_FACE);
    glCullFace(GL_BACK);
}

void ToothRenderer::drawTooth(const Scene& scene, const QRect& part)
{
    useTooth(m_toothProgram, scene);
    m_toothProgram.setUniformValue("decayZones", m_maps.hasDecayZones());
    m_toothProgram.setUniformValue("distinct", scene.look.palette == Palette::Distinct);
    m_toothProgram.setUniformValue("wet", scene.look.isWet ? 1.0F : 0.0F);
    m_toothProgram.setUniformValue("fadeMm", m_fadeMm.x, m_fadeMm.y);
    const DepthColours colours = scene.look.depthColours;
    m_toothProgram.setUniformValue("depthColours", static_cast<int>(colours));
    m_toothProgram.setUniformValue("idealOutline", scene.look.idealOutline);
    m_toothProgram.setUniformValue(
        "scaleMm", static_cast<float>(colours == DepthColours::AgainstIdeal ? kIdealScaleMm : kDepthScaleMm));
    const glm::dmat4 clipFromTooth = scene.clipFromEye * scene.eyeFromTooth;
    const QSize size(static_cast<int>(scene.sizePx.x), static_cast<int>(scene.sizePx.y));
    const auto isSeen = [&](const TileBounds& tile) {
        return tile.mayFace(scene.eyeMm) && pixelsOf(tile.box, clipFromTooth, size).intersects(part);
    };
    if (m_fadeMm.x > kNoFadeMm) {
        glEnable(GL_BLEND);
        // The picture's alpha stays 1, because it is composited over a window.
        glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    }
    glFrontFace(m_isMirrored ? GL_CW : GL_CCW);
    m_toothProgram.setUniformValue("facing", 1.0F);
    m_maps.bind(m_toothProgram, ToothMaps::Side::Upper);
    m_maps.draw(m_maps.select(ToothMaps::Side::Upper, isSeen));
    glFrontFace(m_isMirrored ? GL_CCW : GL_CW);
    m_toothProgram.setUniformValue("facing", -1.0F);
    m_maps.bind(m_toothProgram, ToothMaps::Side::Lower);
    m_maps.draw(m_maps.select(ToothMaps::Side::Lower, isSeen));
    glDisable(GL_BLEND);
    glFrontFace(GL_CCW);
}

/// Multiplies the drawn picture by the light changes from bur and handpiece. Only these two move; the rest of the light
/// is constant.
void ToothRenderer::drawLightOfBur(const Scene& scene)
{
    if (m_maps.isEmpty() || !scene.instrumentShown || scene.burIndex >= m_burs.size())
        return;
    m_burLight.find(m_maps, {toothFromBur(scene, scene.tipMm), toothFromHand(scene), scene.burIndex, scene.liftMm,
                             scene.look.burLight, scene.towardsLight});
    if (m_burLight.reached().nodes.isEmpty())
        return;
    useTooth(m_brightenProgram, scene);
    m_maps.bind(m_brightenProgram, ToothMaps::Side::Upper);
    m_brightenProgram.setUniformValue("burLight", kFreeUnit);
    glActiveTexture(GL_TEXTURE0 + kFreeUnit);
    glBindTexture(GL_TEXTURE_2D, m_burLight.texture());
    glActiveTexture(GL_TEXTURE0);
    glFrontFace(m_isMirrored ? GL_CW : GL_CCW);
    glDepthMask(GL_FALSE);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_DST_COLOR, GL_SRC_COLOR, GL_ZERO, GL_ONE);
    m_maps.draw(m_burLight.reached());
    glDisable(GL_BLEND);
    glDepthMask(GL_TRUE);
    glFrontFace(GL_CCW);
}

void ToothRenderer::drawInstrument(const Scene& scene)
{
    drawCue(scene);
    useMetal(scene, toothFromBur(scene, scene.tipMm));
    const glm::vec4& tint = scene.burTint;
    m_metalProgram.setUniformValue("tint", QVector4D(tint.r, tint.g, tint.b, tint.a));
    m_metalProgram.setUniformValue("topMm",
                                   static_cast<float>(core::bur::burs()[scene.burIndex].headLengthMm + scene.liftMm));
    drawPart(*m_burs[scene.burIndex]);
    m_metalProgram.setUniformValue("tint", QVector4D());
    m_metalProgram.setUniformValue("topMm", kWholeMesh);
    const glm::dmat4 toothFromPart = toothFromHand(scene);
    setMatrix(*this, m_metalProgram, "toothFromPart", glm::mat4(toothFromPart));
    drawPart(*m_shanks[scene.burIndex]);

    // The handpiece is opaque except where it would hide the work.
    fadeOverTheCut(scene, toothFromPart);
    glEnable(GL_BLEND);
    // The picture's alpha stays 1, because it is composited over a window.
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    drawPart(m_handpiece);
    glDisable(GL_BLEND);
}

/// Sets where the metal is transparent: around the last millimetres of the bur on the screen.
void ToothRenderer::fadeOverTheCut(const Scene& scene, const glm::dmat4& toothFromHand)
{
    const glm::dmat4 clipFromTooth = scene.clipFromEye * scene.eyeFromTooth;
    const glm::dvec2 half = 0.5 * glm::dvec2(scene.sizePx);
    const double upright = core::bur::burs()[scene.burIndex].headLengthMm + scene.liftMm;
    const glm::dvec4 top = upright < kWorkMm ? toothFromHand * glm::dvec4(0.0, 0.0, kWorkMm - scene.liftMm, 1.0)
                                             : glm::dvec4(scene.tipMm + glm::dvec3(0.0, 0.0, kWorkMm), 1.0);
    const glm::dvec4 from = clipFromTooth * glm::dvec4(scene.tipMm, 1.0);
    const glm::dvec4 to = clipFromTooth * top;
    if (from.w < 1.0 || to.w < 1.0)  // beside the eye or behind it
        return;
    const auto pixel = [&](const char* name, const glm::dvec4& clip) {
        const glm::vec2 at(half + half * glm::dvec2(clip) / clip.w);
        m_metalProgram.setUniformValue(name, at.x, at.y);
    };
    pixel("workFrom", from);
    pixel("workTo", to);
    m_metalProgram.setUniformValue("workRadius",
                                   static_cast<float>(kWorkAsideMm * scene.clipFromEye[1][1] / from.w * half.y));
    m_metalProgram.setUniformValue("tipAwayMm", static_cast<float>(glm::distance(scene.eyeMm, scene.tipMm)));
}

/// Draws a thin vertical line from the bur's tip to the point of the tooth where the bur would land.
void ToothRenderer::drawCue(const Scene& scene)
{
    if (!scene.surfaceBelowTipMm || scene.tipMm.z - *scene.surfaceBelowTipMm < 0.25)
        return;
    const QOpenGLVertexArrayObject::Binder bound(&m_nothing);
    m_lineProgram.bind();
    setMatrix(*this, m_lineProgram, "clipFromTooth", glm::mat4(scene.clipFromEye * scene.eyeFromTooth));
    setVector(m_lineProgram, "fromMm", glm::vec3(scene.tipMm));
    setVector(m_lineProgram, "toMm", glm::vec3(glm::dvec2(scene.tipMm), *scene.surfaceBelowTipMm + 0.02));
    m_lineProgram.setUniformValue("halfWidth", kCueWide * scene.sizePx.y / scene.sizePx.x, 0.0F);
    glUniform4fv(m_lineProgram.uniformLocation("clipPlane"), 1, glm::value_ptr(m_clipPlane));
    m_lineProgram.setUniformValue("tint", 0.06F, 0.55F, 0.56F, 0.8F);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    glDisable(GL_CULL_FACE);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    glEnable(GL_CULL_FACE);
    glDisable(GL_BLEND);
}

}  // namespace ui::render
