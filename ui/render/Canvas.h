// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

#include <QImage>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>

#include "core/base/Result.h"

namespace ui::render {

/// A place to draw pictures with OpenGL 3.3 where there is no window: with smooth edges, read back as an image. Needs a
/// QGuiApplication on a display that has OpenGL. The thread that made it.
class Canvas
{
public:
    static constexpr int kSamples = 4;  ///< of each pixel

    /// FileUnreadable, with one sentence, where there is no OpenGL 3.3 core profile.
    [[nodiscard]] static core::Result<std::unique_ptr<Canvas>> make(QSize sizePx);
    ~Canvas();

    /// The canvas is what OpenGL draws into while `draw` runs.
    [[nodiscard]] QImage picture(const std::function<void()>& draw);
    void makeCurrent() { m_context.makeCurrent(&m_surface); }
    [[nodiscard]] QSize size() const { return m_pixels->size(); }

private:
    Canvas() = default;

    QOpenGLContext m_context;
    QOffscreenSurface m_surface;
    std::unique_ptr<QOpenGLFramebufferObject> m_pixels;
};

}  // namespace ui::render
