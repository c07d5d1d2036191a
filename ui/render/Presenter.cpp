// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/render/Presenter.h"

#include <algorithm>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "ui/render/Shaders.h"

namespace ui::render {

const char* idOf(Stereo stereo)
{
    switch (stereo) {
    case Stereo::Off:
        break;
    case Stereo::RedCyan:
        return "red-cyan";
    case Stereo::RedCyanGrey:
        return "red-cyan-grey";
    case Stereo::SideBySide:
        return "side-by-side";
    case Stereo::TopBottom:
        return "top-bottom";
    }
    return "flat";
}

QColor seenAs(const QColor& colour, Stereo stereo)
{
    if (stereo != Stereo::RedCyan && stereo != Stereo::RedCyanGrey)
        return colour;
    // The sum of both eyes' matrices in present.frag.
    constexpr glm::dmat3 kBoth(0.4126, 0.3384, -0.0874, 0.4126, 0.6958, -0.1336, 0.1748, -0.0343, 1.2209);
    const glm::dvec3 own(colour.redF(), colour.greenF(), colour.blueF());
    const glm::dvec3 seen = stereo == Stereo::RedCyan ? glm::clamp(kBoth * own, 0.0, 1.0)
                                                      : glm::dvec3(glm::dot(own, glm::dvec3(0.299, 0.587, 0.114)));
    return QColor::fromRgbF(static_cast<float>(seen.x), static_cast<float>(seen.y), static_cast<float>(seen.z));
}

bool Presenter::initialize(QString& reason)
{
    if (!initializeOpenGLFunctions()) {
        reason = QStringLiteral("no OpenGL 3.3 core profile");
        return false;
    }
    m_nothing.create();
    return buildProgram(m_program, "backdrop", "present", reason);
}

/// Returns the scene for one eye. Both eyes look straight ahead, side by side, through one window in the plane of
/// convergence. There is no toe-in, which would tilt objects at the side.
Scene Presenter::seenBy(int eye, const Scene& scene, const Presentation& how, double focusMm)
{
    Scene seen = scene;
    seen.eye = eye > 0 ? 1 : 0;
    const double aside = 0.5 * eye * how.apart * focusMm;
    seen.eyeFromTooth = glm::translate(glm::dmat4(1.0), glm::dvec3(-aside, 0.0, 0.0)) * scene.eyeFromTooth;
    seen.clipFromEye[2][0] -= scene.clipFromEye[0][0] * aside / (how.convergence * focusMm);
    seen.eyeMm = glm::dvec3(glm::inverse(seen.eyeFromTooth)[3]);
    return seen;
}

void Presenter::draw(ToothRenderer& renderer, const Scene& scene, const Presentation& how, double focusMm, int samples)
{
    if (how.isPlain()) {
        renderer.draw(scene);
        return;
    }
    GLint target = 0;
    std::array<GLint, 4> viewport{};
    glGetIntegerv(GL_FRAMEBUFFER_BINDING, &target);
    glGetIntegerv(GL_VIEWPORT, viewport.data());
    const int pictures = how.stereo == Stereo::Off ? 1 : 2;
    QSize size(viewport[2], viewport[3]);
    if (how.stereo == Stereo::SideBySide)
        size.setWidth(std::max(1, size.width() / 2));
    if (how.stereo == Stereo::TopBottom)
        size.setHeight(std::max(1, size.height() / 2));
    for (int k = 0; k < pictures; ++k) {
        Pictures& eye = m_eyes[static_cast<std::size_t>(k)];
        if (!eye.drawn || eye.drawn->size() != size || m_samples != samples) {
            QOpenGLFramebufferObjectFormat format;
            format.setSamples(samples);
            format.setAttachment(QOpenGLFramebufferObject::CombinedDepthStencil);
            eye.drawn = std::make_unique<QOpenGLFramebufferObject>(size, format);
            eye.resolved = samples > 0 ? std::make_unique<QOpenGLFramebufferObject>(size) : nullptr;
        }
        eye.drawn->bind();
        glViewport(0, 0, size.width(), size.height());
        Scene seen = pictures == 2 ? seenBy(2 * k - 1, scene, how, focusMm) : scene;
        seen.sizePx = glm::vec2(size.width(), size.height());
        renderer.draw(seen);
        if (eye.resolved)
            QOpenGLFramebufferObject::blitFramebuffer(eye.resolved.get(), eye.drawn.get());
    }
    m_samples = samples;
    glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(target));
    glViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
    m_program.bind();
    m_program.setUniformValue("leftEye", 0);
    m_program.setUniformValue("rightEye", 1);
    m_program.setUniformValue("stereo", static_cast<int>(how.stereo));
    m_program.setUniformValue("flip", how.flipLeftRight ? 1.0F : 0.0F, how.flipUpDown ? 1.0F : 0.0F);
    for (int k = 0; k < pictures; ++k) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(k));
        const Pictures& eye = m_eyes[static_cast<std::size_t>(k)];
        glBindTexture(GL_TEXTURE_2D, (eye.resolved ? eye.resolved : eye.drawn)->texture());
    }
    glActiveTexture(GL_TEXTURE0);
    glDisable(GL_DEPTH_TEST);
    const QOpenGLVertexArrayObject::Binder bound(&m_nothing);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace ui::render
