// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/render/Canvas.h"

#include <algorithm>
#include <cstddef>

#include <QOpenGLFunctions>

#include "ui/render/Driver.h"

namespace ui::render {
namespace {

constexpr int kStripLines = 64;

}  // namespace

core::Result<std::unique_ptr<Canvas>> Canvas::make(QSize sizePx)
{
    const auto none = core::unexpected(core::ErrorCode::FileUnreadable,
                                       "this display offers no OpenGL 3.3; install or update the graphics driver (on "
                                       "Debian: libgl1-mesa-dri)");
    std::unique_ptr<Canvas> canvas(new Canvas(sizePx));
    QSurfaceFormat format = wantedFormat();
    format.setSamples(0);
    canvas->m_context.setFormat(format);
    if (!canvas->m_context.create())
        return none;
    canvas->m_surface.setFormat(canvas->m_context.format());
    canvas->m_surface.create();
    if (!canvas->m_context.makeCurrent(&canvas->m_surface) || canvas->m_context.format().version() < qMakePair(3, 3) ||
        canvas->m_context.isOpenGLES())
        return none;
    if (!canvas->pixels(kSamples).isValid())
        return core::unexpected(core::ErrorCode::OutOfRange,
                                "the graphics driver refuses a picture of this size; ask for a smaller one");
    return canvas;
}

Canvas::~Canvas()
{
    makeCurrent();
    resize({});
    m_context.doneCurrent();
}

void Canvas::resize(QSize sizePx)
{
    if (sizePx == m_size)
        return;
    makeCurrent();
    m_smooth.reset();
    m_resolved.reset();
    m_hard.reset();
    m_size = sizePx;
}

/// Returns the frame buffer. Creates it at the first call.
QOpenGLFramebufferObject& Canvas::pixels(int samples)
{
    auto& pixels = samples > 0 ? m_smooth : m_hard;
    if (!pixels) {
        QOpenGLFramebufferObjectFormat format;
        format.setSamples(samples);
        format.setAttachment(QOpenGLFramebufferObject::CombinedDepthStencil);
        pixels = std::make_unique<QOpenGLFramebufferObject>(m_size, format);
    }
    if (samples > 0 && !m_resolved)
        m_resolved = std::make_unique<QOpenGLFramebufferObject>(m_size);
    return *pixels;
}

const QImage& Canvas::picture(const std::function<void()>& draw, int samples)
{
    makeCurrent();
    QOpenGLFramebufferObject& drawn = pixels(samples);
    drawn.bind();
    m_context.functions()->glViewport(0, 0, m_size.width(), m_size.height());
    draw();
    if (samples > 0)
        QOpenGLFramebufferObject::blitFramebuffer(m_resolved.get(), &drawn);
    readBack(samples > 0 ? *m_resolved : drawn);
    return m_image;
}

/// Reads the pixels back. OpenGL counts lines from the bottom, so strips are flipped while they are in the cache.
void Canvas::readBack(QOpenGLFramebufferObject& from)
{
    const int width = m_size.width();
    const int height = m_size.height();
    m_strip.resize(static_cast<std::size_t>(width) * kStripLines);
    from.bind();
    if (m_image.size() != m_size)
        m_image = QImage(m_size, QImage::Format_RGB32);
    for (int lowest = 0; lowest < height; lowest += kStripLines) {
        const int lines = std::min(kStripLines, height - lowest);
        m_context.functions()->glReadPixels(0, lowest, width, lines, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV,
                                            m_strip.data());
        for (int line = 0; line < lines; ++line)
            std::copy_n(m_strip.data() + static_cast<std::ptrdiff_t>(line) * width, width,
                        reinterpret_cast<std::uint32_t*>(m_image.scanLine(height - 1 - lowest - line)));
    }
}

}  // namespace ui::render
