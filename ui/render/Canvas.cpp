// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/render/Canvas.h"

#include <QOpenGLFunctions>

namespace ui::render {
core::Result<std::unique_ptr<Canvas>> Canvas::make(QSize sizePx)
{
    const auto none = core::unexpected(core::ErrorCode::FileUnreadable,
                                       "this display offers no OpenGL 3.3; install or update the graphics driver (on "
                                       "Debian: libgl1-mesa-dri)");
    std::unique_ptr<Canvas> canvas(new Canvas);
    QSurfaceFormat format;
    format.setRenderableType(QSurfaceFormat::OpenGL);
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    canvas->m_context.setFormat(format);
    if (!canvas->m_context.create())
        return none;
    canvas->m_surface.setFormat(canvas->m_context.format());
    canvas->m_surface.create();
    if (!canvas->m_context.makeCurrent(&canvas->m_surface) || canvas->m_context.format().version() < qMakePair(3, 3) ||
        canvas->m_context.isOpenGLES())
        return none;
    QOpenGLFramebufferObjectFormat pixels;
    pixels.setSamples(kSamples);
    pixels.setAttachment(QOpenGLFramebufferObject::CombinedDepthStencil);
    canvas->m_pixels = std::make_unique<QOpenGLFramebufferObject>(sizePx, pixels);
    if (!canvas->m_pixels->isValid())
        return core::unexpected(core::ErrorCode::OutOfRange,
                                "the graphics driver refuses a picture of this size; ask for a smaller one");
    return canvas;
}

Canvas::~Canvas()
{
    makeCurrent();
    m_pixels.reset();
    m_context.doneCurrent();
}

QImage Canvas::picture(const std::function<void()>& draw)
{
    makeCurrent();
    m_pixels->bind();
    m_context.functions()->glViewport(0, 0, size().width(), size().height());
    draw();
    return m_pixels->toImage().convertToFormat(QImage::Format_RGB32);
}

}  // namespace ui::render
