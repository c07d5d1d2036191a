// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/render/Driver.h"

#include <QByteArray>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>

namespace ui::render {

QSurfaceFormat wantedFormat()
{
    QSurfaceFormat format;
    format.setRenderableType(QSurfaceFormat::OpenGL);
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    format.setSamples(4);
    return format;
}

const Driver& driver()
{
    static const Driver found = [] {
        Driver asked;
        QOpenGLContext context;
        context.setFormat(wantedFormat());
        if (!context.create())
            return asked;
        QOffscreenSurface surface;
        surface.setFormat(context.format());
        surface.create();
        if (!context.makeCurrent(&surface))
            return asked;
        asked.hasOpenGl33 = !context.isOpenGLES() && context.format().version() >= qMakePair(3, 3);
        const QByteArray name(reinterpret_cast<const char*>(context.functions()->glGetString(GL_RENDERER)));
        asked.name = QString::fromLatin1(name);
        for (const char* software : {"llvmpipe", "softpipe", "swrast", "Software"})
            asked.isSoftware = asked.isSoftware || name.contains(software);
        context.doneCurrent();
        return asked;
    }();
    return found;
}

}  // namespace ui::render
