// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/render/ToothRenderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <QOpenGLContext>
#include <QOpenGLPixelTransferOptions>

#include "ui/render/Shaders.h"

namespace ui::render {
namespace {

/// Sine of the elevation from which the eye looks down along the shank: 55 degrees.
constexpr double kShankHidesTheWork = 0.82;
constexpr double kNeighboursDimmed = 0.35;
constexpr double kLampAsideMm = 3.0;  ///< of the handpiece's light, from the bur's axis
constexpr int kGlassCorners = 64;     ///< of the mirror's glass; glass.vert has the same

enum Unit : int { kPlaces, kHeights, kNormals, kLight, kUpperLayers, kLowerLayers };

void setMatrix(QOpenGLFunctions_3_3_Core& gl, QOpenGLShaderProgram& program, const char* name, const glm::mat4& matrix)
{
    gl.glUniformMatrix4fv(program.uniformLocation(name), 1, GL_FALSE, glm::value_ptr(matrix));
}

void setVector(QOpenGLShaderProgram& program, const char* name, glm::vec3 v)
{
    program.setUniformValue(name, v.x, v.y, v.z);
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
        !buildProgram(m_glassProgram, "glass", "glass", reason) || !m_neighbours.initialize(reason))
        return false;
    m_nothing.create();
    m_toothLayout.create();
    m_triangles.create();
    for (const core::drilling::Bur& bur : core::drilling::burs()) {
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
    attribute(2, 1, offsetof(MetalVertex, finish));
}

void ToothRenderer::setSurface(const ToothSurface& surface)
{
    const core::terrain::Grid& lattice = surface.lattice();
    if (!m_lattice || m_lattice->side != lattice.side) {
        const auto make = [&](Map& map, QOpenGLTexture::TextureFormat format, int bytesPerNode) {
            map.texture = std::make_unique<QOpenGLTexture>(QOpenGLTexture::Target2D);
            map.texture->setFormat(format);
            map.texture->setSize(lattice.side, lattice.side);
            map.texture->setMipLevels(1);
            map.texture->allocateStorage();
            map.texture->setMinMagFilters(QOpenGLTexture::Linear, QOpenGLTexture::Linear);
            map.texture->setWrapMode(QOpenGLTexture::ClampToEdge);
            map.bytesPerNode = bytesPerNode;
        };
        make(m_places, QOpenGLTexture::RG32F, 8);
        make(m_tops, QOpenGLTexture::R32F, 4);
        make(m_bottoms, QOpenGLTexture::R32F, 4);
        make(m_topNormals, QOpenGLTexture::RG16_SNorm, 4);
        make(m_bottomNormals, QOpenGLTexture::RG16_SNorm, 4);
        make(m_light, QOpenGLTexture::RGBA8_UNorm, 4);
        make(m_upperLayers, QOpenGLTexture::RGBA32F, 16);
        make(m_lowerLayers, QOpenGLTexture::RGBA32F, 16);
    }
    m_lattice = lattice;
    m_crownMm = glm::vec3(surface.crownMiddleMm());
    m_crownRadiusMm = static_cast<float>(surface.crownRadiusMm());

    const core::terrain::NodeRect all = wholeOf(lattice);
    write(m_upperLayers, surface.upperLayers().data(), QOpenGLTexture::RGBA, QOpenGLTexture::Float32, all);
    write(m_lowerLayers, surface.lowerLayers().data(), QOpenGLTexture::RGBA, QOpenGLTexture::Float32, all);
    const QOpenGLVertexArrayObject::Binder bound(&m_toothLayout);
    m_triangles.bind();
    m_triangles.allocate(surface.indices().data(), static_cast<int>(surface.indices().size() * sizeof(std::uint32_t)));
    m_uploadedBytes += surface.indices().size() * sizeof(std::uint32_t);
    writeHeights(surface, all);
    writeNormals(surface, all);
    writeLight(surface, all);
    writeTriangles(surface, {});
}

void ToothRenderer::update(const ToothSurface& surface, const ToothSurface::Changes& changes)
{
    if (!m_lattice)
        return;
    if (!changes.heights.isEmpty()) {
        writeHeights(surface, changes.heights);
        const QOpenGLVertexArrayObject::Binder bound(&m_toothLayout);
        writeTriangles(surface, changes.heights);
    }
    if (!changes.normals.isEmpty())
        writeNormals(surface, changes.normals);
    if (!changes.light.isEmpty())
        writeLight(surface, changes.light);
}

void ToothRenderer::write(Map& map, const void* nodes, QOpenGLTexture::PixelFormat format,
                          QOpenGLTexture::PixelType type, const core::terrain::NodeRect& rect)
{
    QOpenGLPixelTransferOptions rows;
    rows.setAlignment(4);
    rows.setRowLength(m_lattice->side);
    const auto first = static_cast<std::ptrdiff_t>(m_lattice->index(rect.beginI, rect.beginJ)) * map.bytesPerNode;
    map.texture->setData(rect.beginI, rect.beginJ, 0, rect.endI - rect.beginI, rect.endJ - rect.beginJ, 1, format, type,
                         static_cast<const std::byte*>(nodes) + first, &rows);
    m_uploadedBytes += static_cast<std::uint64_t>(rect.endI - rect.beginI) *
                       static_cast<std::uint64_t>(rect.endJ - rect.beginJ) *
                       static_cast<std::uint64_t>(map.bytesPerNode);
}

void ToothRenderer::writeHeights(const ToothSurface& surface, const core::terrain::NodeRect& rect)
{
    write(m_places, surface.places().data(), QOpenGLTexture::RG, QOpenGLTexture::Float32, rect);
    write(m_tops, surface.tops().data(), QOpenGLTexture::Red, QOpenGLTexture::Float32, rect);
    write(m_bottoms, surface.bottoms().data(), QOpenGLTexture::Red, QOpenGLTexture::Float32, rect);
}

void ToothRenderer::writeNormals(const ToothSurface& surface, const core::terrain::NodeRect& rect)
{
    write(m_topNormals, surface.topNormals().data(), QOpenGLTexture::RG, QOpenGLTexture::Int16, rect);
    write(m_bottomNormals, surface.bottomNormals().data(), QOpenGLTexture::RG, QOpenGLTexture::Int16, rect);
}

void ToothRenderer::writeLight(const ToothSurface& surface, const core::terrain::NodeRect& rect)
{
    write(m_light, surface.light().data(), QOpenGLTexture::RGBA, QOpenGLTexture::UInt8, rect);
}

/// Rewrites the tiles of the index buffer that a rectangle touches, and lists again which tiles hold triangles.
void ToothRenderer::writeTriangles(const ToothSurface& surface, const core::terrain::NodeRect& rect)
{
    const int side = surface.tilesPerSide();
    constexpr int kBytes = ToothSurface::kTileIndices * static_cast<int>(sizeof(std::uint32_t));
    m_triangles.bind();
    if (!rect.isEmpty()) {
        const int lastX = std::min((rect.endI - 1) / ToothSurface::kTileCells, side - 1);
        const int lastY = std::min((rect.endJ - 1) / ToothSurface::kTileCells, side - 1);
        for (int y = std::max(0, rect.beginJ - 1) / ToothSurface::kTileCells; y <= lastY; ++y) {
            for (int x = std::max(0, rect.beginI - 1) / ToothSurface::kTileCells; x <= lastX; ++x) {
                const int tile = y * side + x;
                m_triangles.write(
                    tile * kBytes,
                    surface.indices().data() + static_cast<std::ptrdiff_t>(tile) * ToothSurface::kTileIndices, kBytes);
                m_uploadedBytes += kBytes;
            }
        }
    }
    m_drawCounts.clear();
    m_drawOffsets.clear();
    for (std::size_t tile = 0; tile < surface.indexCounts().size(); ++tile) {
        if (surface.indexCounts()[tile] == 0)
            continue;
        m_drawCounts.push_back(surface.indexCounts()[tile]);
        // OpenGL takes an offset into its own buffer as a pointer.
        // NOLINTNEXTLINE(performance-no-int-to-ptr)
        m_drawOffsets.push_back(reinterpret_cast<const void*>(tile * static_cast<std::size_t>(kBytes)));
    }
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
    glClear(GL_DEPTH_BUFFER_BIT);
    drawBackdrop(scene);
    drawSolids(scene, glm::dvec4(0.0));
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

/// What hides and is hidden like any solid. Of it only what lies before a plane, unless that is zero.
void ToothRenderer::drawSolids(const Scene& scene, const glm::dvec4& clipPlane)
{
    m_clipPlane = glm::vec4(clipPlane);
    if (!m_neighbours.pieces().empty()) {
        ArchScene beside;
        beside.eyeFromScene = scene.eyeFromTooth;
        beside.clipFromEye = scene.clipFromEye;
        beside.eyeMm = scene.eyeMm;
        beside.towardsLight = scene.towardsLight;
        beside.clipPlane = clipPlane;
        beside.dimmed = kNeighboursDimmed;
        m_neighbours.draw(beside);
    }
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glEnable(GL_CULL_FACE);
    glCullFace(GL_BACK);
    if (m_lattice)
        drawTooth(scene);
}

/// The scene as it stands behind the glass: its mirror image, seen by the same eye. Half as fine as the picture.
void ToothRenderer::drawReflection(const Scene& scene)
{
    GLint target = 0;
    std::array<GLint, 4> viewport{};
    glGetIntegerv(GL_FRAMEBUFFER_BINDING, &target);
    glGetIntegerv(GL_VIEWPORT, viewport.data());
    const QSize size(std::max(1, viewport[2] / 2), std::max(1, viewport[3] / 2));
    if (!m_reflection || m_reflection->size() != size)
        m_reflection = std::make_unique<QOpenGLFramebufferObject>(size, QOpenGLFramebufferObject::CombinedDepthStencil);
    m_reflection->bind();
    glViewport(0, 0, size.width(), size.height());
    Scene seen = scene;
    seen.eyeFromTooth = scene.eyeFromTooth * scene.mirror->imageMatrix();
    seen.eyeMm = scene.mirror->image(scene.eyeMm);
    seen.sizePx = glm::vec2(size.width(), size.height());
    seen.ghostMm.reset();
    seen.mirror.reset();
    glClear(GL_DEPTH_BUFFER_BIT);
    drawBackdrop(seen);
    m_isMirrored = true;
    glEnable(GL_CLIP_DISTANCE0);
    const glm::dvec3& normal = scene.mirror->normal;
    drawSolids(seen, glm::dvec4(normal, -glm::dot(normal, scene.mirror->centreMm)));
    if (seen.instrumentShown && seen.burIndex < m_burs.size())
        drawInstrument(seen);
    glDisable(GL_CLIP_DISTANCE0);
    m_isMirrored = false;
    m_clipPlane = glm::vec4(0.0F);
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
    glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(target));
    glViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
}

/// Frame of the mirror: its middle, +z out of the glass, its handle towards +x, which points up as far as it can.
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
    glBindTexture(GL_TEXTURE_2D, m_reflection->texture());
    glDrawArrays(GL_TRIANGLE_FAN, 0, kGlassCorners);
}

/// The bur where the hand holds it.
void ToothRenderer::drawGhost(const Scene& scene)
{
    useMetal(scene, toothFromBur(scene, *scene.ghostMm));
    m_metalProgram.setUniformValue("fade", 0.28F);
    m_metalProgram.setUniformValue("blur", 0.0F);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    // Through the tooth as well: where it is is what it tells.
    glDisable(GL_DEPTH_TEST);
    drawPart(*m_burs[scene.burIndex]);
    glEnable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
}

glm::dmat4 ToothRenderer::toothFromBur(const Scene& scene, const glm::dvec3& tipMm)
{
    return glm::rotate(glm::translate(glm::dmat4(1.0), tipMm), scene.handAzimuthRad, glm::dvec3(0.0, 0.0, 1.0));
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
    m_metalProgram.setUniformValue("glassRadius", 0.0F);
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

void ToothRenderer::drawTooth(const Scene& scene)
{
    const QOpenGLVertexArrayObject::Binder bound(&m_toothLayout);
    m_toothProgram.bind();
    setMatrix(*this, m_toothProgram, "clipFromTooth", glm::mat4(scene.clipFromEye * scene.eyeFromTooth));
    setVector(m_toothProgram, "eyeMm", glm::vec3(scene.eyeMm));
    setVector(m_toothProgram, "towardsLight", scene.towardsLight);
    setVector(m_toothProgram, "tipMm", glm::vec3(scene.tipMm));
    const bool shadow = scene.instrumentShown && scene.burIndex < m_burs.size();
    const double radius = shadow ? core::drilling::burs()[scene.burIndex].headRadiusMm : 0.0;
    m_toothProgram.setUniformValue("burShadowMm", static_cast<float>(1.3 * radius));
    glUniform4fv(m_toothProgram.uniformLocation("clipPlane"), 1, glm::value_ptr(m_clipPlane));
    m_toothProgram.setUniformValue("distinct", scene.look.palette == Palette::Distinct);
    m_toothProgram.setUniformValue("wet", scene.look.isWet ? 1.0F : 0.0F);
    m_toothProgram.setUniformValue("depthColoursMm", static_cast<float>(scene.look.depthColoursMm));
    const glm::dvec3 towardsHandle(std::cos(scene.handAzimuthRad), std::sin(scene.handAzimuthRad), 0.0);
    const glm::dvec3 lampMm =
        scene.tipMm + towardsHandle * kLampAsideMm + glm::dvec3(0.0, 0.0, core::drilling::kChuckMm + scene.liftMm);
    setVector(m_toothProgram, "burLampMm", glm::vec3(lampMm));
    m_toothProgram.setUniformValue("burLamp", scene.look.burLight && shadow ? 1.0F : 0.0F);
    m_toothProgram.setUniformValue("places", int{kPlaces});
    m_toothProgram.setUniformValue("heights", int{kHeights});
    m_toothProgram.setUniformValue("normals", int{kNormals});
    m_toothProgram.setUniformValue("light", int{kLight});
    m_toothProgram.setUniformValue("upperLayers", int{kUpperLayers});
    m_toothProgram.setUniformValue("lowerLayers", int{kLowerLayers});
    setVector(m_toothProgram, "lattice",
              glm::vec3(glm::vec2(m_lattice->originMm), static_cast<float>(1.0 / m_lattice->cellMm)));
    m_places.texture->bind(kPlaces);
    m_light.texture->bind(kLight);
    m_upperLayers.texture->bind(kUpperLayers);
    m_lowerLayers.texture->bind(kLowerLayers);

    const auto surface = [&](Map& heights, Map& normals, float facing, GLenum front) {
        heights.texture->bind(kHeights);
        normals.texture->bind(kNormals);
        m_toothProgram.setUniformValue("facing", facing);
        glFrontFace(m_isMirrored == (front == GL_CCW) ? GL_CW : GL_CCW);
        glMultiDrawElements(GL_TRIANGLES, m_drawCounts.data(), GL_UNSIGNED_INT, m_drawOffsets.data(),
                            static_cast<GLsizei>(m_drawCounts.size()));
    };
    surface(m_tops, m_topNormals, 1.0F, GL_CCW);
    surface(m_bottoms, m_bottomNormals, -1.0F, GL_CW);
    glFrontFace(GL_CCW);
}

void ToothRenderer::drawInstrument(const Scene& scene)
{
    drawCue(scene);
    const glm::dmat4 clipFromTooth = scene.clipFromEye * scene.eyeFromTooth;
    const glm::dmat4 toothFromPart = toothFromBur(scene, scene.tipMm);
    useMetal(scene, toothFromPart);
    drawPart(*m_burs[scene.burIndex]);
    setMatrix(*this, m_metalProgram, "toothFromPart",
              glm::mat4(glm::translate(toothFromPart, glm::dvec3(0.0, 0.0, scene.liftMm))));
    // From the side the shank is what tells how the bur stands; from above it would hide all that it does.
    const glm::dvec3 towardsEye = glm::normalize(scene.eyeMm - scene.tipMm);
    const bool shankIsGlass = towardsEye.z > kShankHidesTheWork;
    if (!shankIsGlass)
        drawPart(*m_shanks[scene.burIndex]);

    // The handpiece turns to glass over the crown: the hand feels it, the eye wants the tooth. First its depth alone,
    // so that only its nearest side is blended.
    const glm::dvec4 crown = clipFromTooth * glm::dvec4(m_crownMm, 1.0);
    const double scale = scene.clipFromEye[1][1] / crown.w * 0.5 * static_cast<double>(scene.sizePx.y);
    m_metalProgram.setUniformValue(
        "glassCentre", static_cast<float>((0.5 + 0.5 * crown.x / crown.w) * static_cast<double>(scene.sizePx.x)),
        static_cast<float>((0.5 + 0.5 * crown.y / crown.w) * static_cast<double>(scene.sizePx.y)));
    m_metalProgram.setUniformValue("glassRadius", static_cast<float>(m_crownRadiusMm * scale));
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    const auto glass = [&] {
        if (shankIsGlass)
            drawPart(*m_shanks[scene.burIndex]);
        drawPart(m_handpiece);
    };
    glass();
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glEnable(GL_BLEND);
    // Alpha of the picture stays one: it is laid over a window.
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    glass();
    glDisable(GL_BLEND);
}

/// A thin line from the tip to the tooth below it: where the bur will land.
void ToothRenderer::drawCue(const Scene& scene)
{
    if (scene.tipMm.z - scene.surfaceBelowTipMm < 0.25)
        return;
    const QOpenGLVertexArrayObject::Binder bound(&m_nothing);
    m_lineProgram.bind();
    setMatrix(*this, m_lineProgram, "clipFromTooth", glm::mat4(scene.clipFromEye * scene.eyeFromTooth));
    setVector(m_lineProgram, "fromMm", glm::vec3(scene.tipMm));
    setVector(m_lineProgram, "toMm", glm::vec3(glm::dvec2(scene.tipMm), scene.surfaceBelowTipMm + 0.02));
    m_lineProgram.setUniformValue("halfWidth", 1.2F / scene.sizePx.x, 0.0F);
    m_lineProgram.setUniformValue("tint", 0.06F, 0.55F, 0.56F, 0.8F);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    glDisable(GL_CULL_FACE);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    glEnable(GL_CULL_FACE);
    glDisable(GL_BLEND);
}

}  // namespace ui::render
