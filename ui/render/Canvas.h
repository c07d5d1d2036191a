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

/// A place to draw pictures with OpenGL 3.3 where there is no window, read back as images. Needs a QGuiApplication on a
/// display that has OpenGL. The thread that made it.
class Canvas
{
public:
    static constexpr int kSamples = 4;  ///< of each pixel, for smooth edges

    /// FileUnreadable, with one sentence, where there is no OpenGL 3.3 core profile; OutOfRange for a size that the
    /// driver refuses.
    [[nodiscard]] static core::Result<std::unique_ptr<Canvas>> make(QSize sizePx);
    ~Canvas();

    /// The canvas is what OpenGL draws into while `draw` runs.
    /// @param samples  kSamples, or 0: hard edges, for less than half the time
    /// @return opaque, Format_RGB32, size(); holds until the next picture
    [[nodiscard]] const QImage& picture(const std::function<void()>& draw, int samples = kSamples);
    /// For the pictures to come.
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
    std::unique_ptr<QOpenGLFramebufferObject> m_smooth;    ///< of several samples a pixel
    std::unique_ptr<QOpenGLFramebufferObject> m_resolved;  ///< the same, to be read
    std::unique_ptr<QOpenGLFramebufferObject> m_hard;
    std::vector<std::uint32_t> m_strip;  ///< of the picture as OpenGL gives it, from below
    QImage m_image;
};

}  // namespace ui::render
