// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include <QImage>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>

#include "core/base/Result.h"

namespace ui::render {

/// Draws pictures with OpenGL 3.3 without a window and reads them back as images. Needs a QGuiApplication on a display
/// with OpenGL. Used only by the thread that created it.
class Canvas
{
public:
    static constexpr int kSamples = 4;  ///< per pixel, for anti-aliasing

    /// Creates a canvas. Returns FileUnreadable, with a one-sentence detail, if there is no OpenGL 3.3 core profile,
    /// and OutOfRange for a size that the driver rejects.
    [[nodiscard]] static core::Result<std::unique_ptr<Canvas>> make(QSize sizePx);
    ~Canvas();

    /// Calls `draw` with the canvas as the bound framebuffer, and reads the picture back.
    /// @param samples  kSamples, or 0 for no anti-aliasing in less than half the time
    /// @return opaque, Format_RGB32, size(); valid until the next picture
    [[nodiscard]] const QImage& picture(const std::function<void()>& draw, int samples = kSamples);
    /// Sets the size of later pictures.
    void resize(QSize sizePx);
    void makeCurrent() { m_context.makeCurrent(&m_surface); }
    [[nodiscard]] QSize size() const { return m_size; }

private:
    explicit Canvas(QSize sizePx) : m_size(sizePx) {}
    [[nodiscard]] QOpenGLFramebufferObject& pixels(int samples);
    void readBack(QOpenGLFramebufferObject& from);

    QOpenGLContext m_context;
    QOffscreenSurface m_surface;
    QSize m_size;
    std::unique_ptr<QOpenGLFramebufferObject> m_smooth;    ///< with several samples per pixel
    std::unique_ptr<QOpenGLFramebufferObject> m_resolved;  ///< the same, resolved for reading
    std::unique_ptr<QOpenGLFramebufferObject> m_hard;
    std::vector<std::uint32_t> m_strip;  ///< a strip of the picture in OpenGL's order, from the bottom
    QImage m_image;
};

}  // namespace ui::render
